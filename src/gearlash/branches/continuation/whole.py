"""A whole branch through an orbit: both ways from it, put together."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from gearlash.orbits import Certificate, Orbit, Verdict, orbit_at
from gearlash.system import Family, GearlashError, Status, given

from .beside import Passed, Unexplained
from .branch import Branch
from .derivative import DerivativeKind
from .equations import UNBUILT, Equations, Line
from .follow import Follower
from .isolated import isolated
from .locate import MEETING
from .node import Node, node_near
from .notes import note_of
from .points import BranchPoint, EndKind, EndOfBranch, SpecialKind, SpecialPoint
from .reciprocal import Reciprocal
from .settings import ContinuationSettings
from .testfunctions import neutral

FEW_NEUTRAL = 3  # orbits with a multiplier on the unit circle: so many may lie at special points by chance
LONGEST_PERIOD = 64  # base periods
ASIDE = 1e-5  # of scaled unknowns: from a special point to the orbit that a branch begins with
AT_FOLD = 1e-3
"""Part of the value in a branch's direction: at a fold rounding would decide which way it rises, so there
it goes towards the end of the greater value."""
ON_CIRCLE = 1e-9  # distance of a multiplier from the unit circle at a special point, as it is solved for
NOT_ASKED = Certificate(Verdict.UNCERTAIN, ("it was not asked for",))


def continue_orbit(
    family: Family,
    values: Mapping[str, float],
    name: str,
    orbit: Orbit,
    lower: float,
    upper: float,
    settings: ContinuationSettings | None = None,
    tell: Callable[[float], object] | None = None,
    cancelled: Callable[[], bool] | None = None,
) -> Branch:
    """The branch through ``orbit``, found at ``values``, between two limits of the parameter ``name``."""
    settings = ContinuationSettings() if settings is None else settings
    line = Line(family, family.complete(values), name, lower, upper)
    start = clear_of_special(first_node(line, orbit, float(line.values[name])), settings)
    listen = Listener(tell or (lambda _: None), cancelled or (lambda: False))
    ahead = _Way.taken(Follower(start, settings), listen)
    if ahead.end.kind is EndKind.CLOSED:
        behind = _Way(EndOfBranch(EndKind.CLOSED, start.value))
    else:
        behind = _Way.taken(Follower(start.turned, settings), listen)
    if abs(start.direction[-1]) < AT_FOLD and ahead.end.value < behind.end.value:
        start, ahead, behind = start.turned, behind, ahead
    behind = behind.turned
    points = (*behind.points, point_of(start, 0.0, settings), *ahead.points)
    return Branch(
        name=name,
        values=dict(line.values),
        lower=lower,
        upper=upper,
        scale=start.equations.scale,
        points=_with_births(points),
        special=_met((*behind.special, *ahead.special), line.unit),
        ends=(behind.end, ahead.end),
        unexplained=(*behind.unexplained, *ahead.unexplained, *_neutral(points)),
        derivative=line.along.kind,
        derivative_error=0.0 if line.along.kind is DerivativeKind.EXACT else line.along.error,
    )


def _neutral(points: tuple[BranchPoint, ...]) -> tuple[str, ...]:
    """What is said of a branch whose multipliers stay on the unit circle, as without damping."""
    found = [point for point in points if neutral(point.multipliers)]
    if len(found) <= FEW_NEUTRAL:
        return ()
    values = [point.value for point in found]
    told = (
        f"multipliers lie on the unit circle within rounding in {len(found)} of {len(points)} orbits, from "
        f"{min(values):.12g} to {max(values):.12g}: "
    )
    if all(Reciprocal.of(point.multipliers) for point in found):
        return (
            f"{told}without damping they come as μ and 1/μ, and where pairs leave the circle is solved for; "
            "whether orbits with all multipliers on it are stable is not decided",
        )
    return (f"{told}whether these are stable, or pairs leave the circle there, is not decided",)


def first_node(line: Line, orbit: Orbit, value: float) -> Node:
    """The orbit as a point of its branch, in the direction of rising values. Raises `GearlashError` where it
    is none, or too long."""
    value = line.within(value)
    if not line.lower <= value <= line.upper:
        raise GearlashError(
            f"{line.name} = {value:.10g} of the orbit lies outside the interval from {line.lower:g} to "
            f"{line.upper:g} in which it is to be followed"
        )
    try:
        props = line.system_at(value)
        found = orbit_at(props, orbit.state, orbit.shot.period, least=True)
    except UNBUILT as error:
        raise GearlashError(f"the orbit is not one of this family: {error}") from error
    if found is None:
        raise GearlashError(f"there is no periodic orbit of this family near the start, at {value:.10g}")
    given.whole("period of the orbit, in base periods", found.shot.period, 1, LONGEST_PERIOD)
    equations = Equations.of(line, found)
    if not isolated(found, equations.size):
        raise GearlashError(
            f"the orbit at {line.name} = {value:.10g} is not isolated: a multiplier is 1, "
            "and other periodic orbits lie beside it at the same value, so that it is on no single branch"
        )
    u = equations.unknowns(found, value)
    row = np.zeros(len(u))
    row[-1] = 1.0
    node = node_near(equations, u, row, u[-1], None)
    if node.node is None:
        raise GearlashError(f"the orbit cannot be followed from its start: {node.failure}")
    return node.node


def clear_of_special(start: Node, settings: ContinuationSettings) -> Node:
    """The orbit to begin with; where a multiplier is on the unit circle, as at a special point of another
    branch, one a little farther on. Beside it the point is met on the way, where within rounding of it
    neither way would know on which side it begins."""
    if not _on_circle(start):
        return start
    length = max(ASIDE, settings.shortest)
    for node in (start, start.turned):
        step = Follower(node, settings).step(None, node, length)
        if not isinstance(step, EndOfBranch) and not _on_circle(step[0]):
            return step[0] if node is start else step[0].turned
    return start


def _on_circle(node: Node) -> bool:
    return bool((np.abs(np.abs(node.spectrum.multipliers) - 1.0) <= ON_CIRCLE).any())


@dataclass(frozen=True)
class Listener:
    """``tell`` hears the value of every orbit; ``cancelled`` says whether to stop."""

    tell: Callable[[float], object]
    cancelled: Callable[[], bool]


@dataclass(eq=False)
class _Way:
    """One way from the first orbit, in order of arclength."""

    end: EndOfBranch
    points: list[BranchPoint] = field(default_factory=list)
    special: list[SpecialPoint] = field(default_factory=list)
    unexplained: list[str] = field(default_factory=list)

    @staticmethod
    def taken(follower: Follower, listen: Listener) -> _Way:
        last, arclength = follower.start, 0.0
        way = _Way(EndOfBranch(EndKind.CANCELLED, last.value))
        for item in follower.run():
            if isinstance(item, EndOfBranch):
                way.end = item
            elif isinstance(item, Passed):
                way.special.append(special_of(item, last, arclength, follower.settings))
            elif isinstance(item, Unexplained):
                way.unexplained.append(f"{item.left.value:.12g} to {item.right.value:.12g}: {item.note}")
            else:
                arclength += item.apart(last)
                way.points.append(point_of(item, arclength, follower.settings))
                last = item
                listen.tell(item.value)
                way.end = EndOfBranch(EndKind.CANCELLED, last.value)
                if listen.cancelled():
                    break
        return way

    @property
    def turned(self) -> _Way:
        """The same in the other order, its arclength negative."""
        points = [_turned_point(each) for each in reversed(self.points)]
        special = [_turned(each) for each in reversed(self.special)]
        return _Way(self.end, points, special, self.unexplained[::-1])


def point_of(node: Node, arclength: float, settings: ContinuationSettings) -> BranchPoint:
    """What is told of an orbit that was stepped to."""
    orbit = node.orbit
    return BranchPoint(
        value=node.value,
        arclength=arclength,
        state=orbit.state,
        strobes=orbit.strobes,
        turn=float(node.direction[-1]),
        signature=orbit.signature,
        multipliers=node.spectrum.multipliers,
        extrema=node.extrema.all,
        born=(),
        died=(),
        residual=orbit.residual,
        error=orbit.shot.error,
        certificate=orbit.certificate if settings.certify else NOT_ASKED,
        status=orbit.status,
    )


def special_of(passed: Passed, last: Node, arclength: float, settings: ContinuationSettings) -> SpecialPoint:
    """What is told of something that was passed, behind the orbit ``last`` at ``arclength``."""
    located, left, right = passed.located, passed.left, passed.right
    assert located.kind is not None
    node, change = located.node, located.change
    here = arclength + node.apart(last)
    point = point_of(node, here, replace(settings, certify=False))
    extremum = node.extrema.by_number[change.number] if located.kind is SpecialKind.GRAZING else None
    linear = not any(map(any, point.signature.counts))
    before, after = passed.sides
    away = [side.apart(node) for side in (left, right)]
    interval = left.value, right.value
    if located.kind is SpecialKind.EXISTENCE and located.value is not None:
        interval = node.value, located.value
    return SpecialPoint(
        kind=located.kind,
        value=node.value if located.value is None else located.value,
        error=located.error,
        interval=interval,
        arclengths=(here - away[0], here + away[1]),
        point=point,
        label_before=before.label,
        label_after=after.label,
        unstable_before=before.unstable,
        unstable_after=after.unstable,
        extremum=extremum,
        linear=linear,
        note=note_of(passed),
        status=Status.OK,
        name=node.equations.line.name,
        values={**node.equations.line.values, node.equations.line.name: node.value},
    )


def _turned_point(point: BranchPoint) -> BranchPoint:
    return replace(point, arclength=-point.arclength, turn=-point.turn)


def _turned(each: SpecialPoint) -> SpecialPoint:
    point = _turned_point(each.point)
    return replace(
        each,
        point=point,
        interval=each.interval[::-1],
        arclengths=(-each.arclengths[1], -each.arclengths[0]),
        label_before=each.label_after,
        label_after=each.label_before,
        unstable_before=each.unstable_after,
        unstable_after=each.unstable_before,
    )


def _met(special: tuple[SpecialPoint, ...], unit: float) -> tuple[SpecialPoint, ...]:
    """A fold and a branch point that cannot be told apart are one thing: an orbit that was born at the
    symmetry breaking of another one comes back to it. There a multiplier only touches 1, and rounding makes
    it cross."""
    found: list[SpecialPoint] = []
    for each in special:
        last = found[-1] if found else None
        kinds = {each.kind, last.kind} if last is not None else set()
        together = kinds == {SpecialKind.FOLD, SpecialKind.BRANCH_POINT}
        if last is not None and together and abs(each.value - last.value) <= MEETING * unit:
            fold = each if each.kind is SpecialKind.FOLD else last
            found[-1] = replace(
                fold,
                kind=SpecialKind.SYMMETRIC,
                error=max(fold.error, MEETING * unit),
                note=str(SpecialKind.SYMMETRIC),
                interval=(last.interval[0], each.interval[1]),
                arclengths=(last.arclengths[0], each.arclengths[1]),
                label_before=last.label_before,
                label_after=each.label_after,
                unstable_before=last.unstable_before,
                unstable_after=each.unstable_after,
            )
        else:
            found.append(each)
    return tuple(found)


def _with_births(points: tuple[BranchPoint, ...]) -> tuple[BranchPoint, ...]:
    """With the numbers of the extrema that are not in the point before, or no longer."""
    found, before = [], None
    for point in points:
        here = {extremum.number for extremum in point.extrema}
        if before is not None and here != before:
            point = replace(point, born=tuple(sorted(here - before)), died=tuple(sorted(before - here)))
        found.append(point)
        before = here
    return tuple(found)
