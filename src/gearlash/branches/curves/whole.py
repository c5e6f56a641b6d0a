"""A whole curve through a special orbit: both ways from it, put together."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

import numpy as np

from gearlash.branches.continuation.points import SpecialKind
from gearlash.branches.continuation.settings import ContinuationSettings
from gearlash.orbits.floquet import ordered
from gearlash.system import GearlashError, Status

from .begin import Beginning
from .conditions import At
from .follow import Follower
from .locate import Met
from .motion import is_clear
from .newton import left_over
from .node import Node, state_at
from .plane import UNBUILT, Array
from .points import CodimTwoPoint, Curve, CurveEndKind, CurvePoint, EndOfCurve
from .problem import Evaluated
from .touch import Leg, carried

KINDS = {At.ONE: SpecialKind.FOLD, At.MINUS_ONE: SpecialKind.DOUBLING, At.CIRCLE: SpecialKind.TORUS}
AGAIN = 1e-8  # of the values: so near the start is met again
REAL = 1e-9  # of the size of the motion: how well the orbit closes without anything held


@dataclass(frozen=True)
class Listener:
    """``tell`` hears the parameters of every orbit; ``cancelled`` says whether to stop."""

    tell: Callable[[tuple[float, float]], object]
    cancelled: Callable[[], bool]


def kind_of(node: Node) -> SpecialKind:
    if node.problem.touches:
        return SpecialKind.GRAZING
    return KINDS[node.problem.conditions[0].at]


def curve_through(begun: Beginning, settings: ContinuationSettings, listen: Listener) -> Curve:
    """The curve both ways from its beginning."""
    ahead, behind, met = begun.ahead, begun.behind, begun.met
    way = _Way.taken(ahead, settings, listen, begun.known)
    between: tuple[CodimTwoPoint, ...] = ()
    if begun.ended is not None:
        back = _Way(EndOfCurve(begun.ended, _pair(ahead.place if met is None else met.place)), ahead)
    elif behind is None or way.end.kind is CurveEndKind.CLOSED:
        back = _Way(EndOfCurve(CurveEndKind.CLOSED, _pair(ahead.place)), ahead)
    else:
        goal = way.last.turned if way.end.kind is CurveEndKind.POINTS else None
        back = _Way.taken(behind, settings, listen, goal=goal).turned
        if goal is not None and back.end.kind is CurveEndKind.CLOSED:
            way.end = back.end
    start = [_point(ahead, 0.0)]
    if met is not None:
        between = (special_of(met, -_away(met, ahead), behind or ahead, ahead),)
    if met is not None and behind is not None:
        back = back.moved(-_away(met, ahead))
        start.insert(0, _point(behind, -_away(met, ahead)))
    if begun.start is not None:
        between = (_at_start(begun.start, back, way),)
    special = (*_others(between, back.special), *between, *_others(between, way.special))
    plane = ahead.problem.plane
    return Curve(
        kind=kind_of(ahead),
        names=(plane.names[0], plane.names[1]),
        values=dict(plane.at(ahead.place)),
        lower=_pair(np.array(plane.lower)),
        upper=_pair(np.array(plane.upper)),
        points=(*back.points, *start, *way.points),
        special=special,
        ends=(back.end, way.end),
        scale=np.concatenate([ahead.problem.size, plane.unit]),
    )


def _at_start(start: CodimTwoPoint, back: _Way, way: _Way) -> CodimTwoPoint:
    """The point at which a curve was begun, as one of it."""
    before = back.points[-1].signature if back.points else start.point.signature
    after = way.points[0].signature if way.points else start.point.signature
    point = replace(start.point, arclength=0.0)
    return replace(start, point=point, label_before=before, label_after=after)


def _others(between: tuple[CodimTwoPoint, ...], found: list[CodimTwoPoint]) -> list[CodimTwoPoint]:
    """Without what is the start, met again."""
    return [
        each
        for each in found
        if not any(
            each.kind is one.kind and np.allclose(each.values, one.values, rtol=AGAIN, atol=0.0)
            for one in between
        )
    ]


@dataclass(eq=False)
class _Way:
    """One way from the first orbit, in order of arclength."""

    end: EndOfCurve
    last: Node
    points: list[CurvePoint] = field(default_factory=list)
    special: list[CodimTwoPoint] = field(default_factory=list)

    @staticmethod
    def taken(
        start: Node,
        settings: ContinuationSettings,
        listen: Listener,
        known: tuple[Node, ...] = (),
        goal: Node | None = None,
    ) -> _Way:
        last, arclength = start, 0.0
        way = _Way(EndOfCurve(CurveEndKind.CANCELLED, _pair(start.place)), start)
        waiting: list[Met] = []
        for item in Follower(start, settings, settings.first, known, goal).run():
            if isinstance(item, Met):
                waiting.append(item)
                continue
            after = last if isinstance(item, EndOfCurve) else item
            step = 0.0 if isinstance(item, EndOfCurve) else _length(last, item)
            way.special += [
                special_of(m, arclength + _on_step(m, last, after, step), last, after) for m in waiting
            ]
            waiting.clear()
            if isinstance(item, EndOfCurve):
                way.end = item
                break
            arclength += step
            way.points.append(_point(item, arclength))
            last = way.last = item
            listen.tell(_pair(item.place))
            if listen.cancelled():
                way.end = EndOfCurve(CurveEndKind.CANCELLED, _pair(item.place))
                break
        return way

    @property
    def turned(self) -> _Way:
        """The same in the other order, its arclength negative."""
        points = [replace(each, arclength=-each.arclength) for each in reversed(self.points)]
        special = [
            replace(
                each,
                point=replace(each.point, arclength=-each.arclength),
                label_before=each.label_after,
                label_after=each.label_before,
            )
            for each in reversed(self.special)
        ]
        return _Way(self.end, self.last, points, special)

    def moved(self, by: float) -> _Way:
        """The same with another beginning of arclength."""
        points = [replace(each, arclength=each.arclength + by) for each in self.points]
        special = [
            replace(each, point=replace(each.point, arclength=each.point.arclength + by))
            for each in self.special
        ]
        return _Way(self.end, self.last, points, special)


def _length(left: Node, right: Node) -> float:
    """From one orbit to the next, in the plane and in states where both are begun at one phase."""
    if left.problem.origin == right.problem.origin and len(left.u) == len(right.u):
        return float(np.linalg.norm(right.u - left.u))
    return float(np.linalg.norm((right.place - left.place) / left.problem.plane.unit))


def _away(met: Met, node: Node) -> float:
    return float(np.linalg.norm((met.place - node.place) / node.problem.plane.unit))


def _on_step(met: Met, left: Node, right: Node, length: float) -> float:
    """How far along a step of a given length a point lies; behind the last orbit by the way in the plane."""
    before, after = _away(met, left), _away(met, right)
    return before if length == 0.0 else length * before / max(before + after, 1e-300)


def _pair(place: Array) -> tuple[float, float]:
    return float(place[0]), float(place[1])


def _point(node: Node, arclength: float) -> CurvePoint:
    here = node.here
    touched = tuple(e for e in node.extrema.all if e.number in node.touching and here.problem.touches)
    return CurvePoint(
        values=_pair(node.place),
        arclength=arclength,
        state=state_at(here, 0.0),
        period=int(here.cycles),
        signature=node.motion.signature,
        multipliers=node.spectrum.multipliers,
        touches=touched,
        extrema=node.extrema.all,
        residual=left_over(here, node.jacobian),
        admissible=_admissible(node),
        status=Status.OK,
    )


def _admissible(node: Node) -> bool:
    """Whether nothing that is held would cross, and the orbit closes with nothing held."""
    kept = [(node.motion.beside(phase, window), window) for phase, window in node.problem.kept]
    if any(e is not None and not is_clear(e) and e.number not in node.touching for e, _ in kept):
        return False
    return closes(node.here)


def closes(here: Evaluated) -> bool:
    """Whether the orbit closes with nothing held."""
    state, origin = here.problem.state(here.u), here.problem.origin
    try:
        end = carried(here.props, state, Leg(origin, origin + here.cycles, None))[0]
    except GearlashError:
        return False
    return float(np.abs((end - state) / here.problem.size).max()) <= REAL


def special_of(met: Met, arclength: float, before: Node, after: Node) -> CodimTwoPoint:
    """As it is told."""
    here, labels = met.here, (before.motion.signature, after.motion.signature)
    if met.touched and not before.problem.touches and labels[0] == labels[1]:
        held, other = met.motion.signature, met.motion.more(met.touched[0])
        labels = (held, other) if before.motion.signature == held else (other, held)
    try:
        real = closes(here)
    except UNBUILT:
        real = False
    values, errors = met.place, met.errors
    point = CurvePoint(
        values=_pair(values),
        arclength=arclength,
        state=state_at(here, 0.0),
        period=int(here.cycles),
        signature=met.motion.signature,
        multipliers=ordered(np.linalg.eigvals(here.monodromy)),
        touches=met.touched,
        extrema=met.motion.extrema.all,
        residual=left_over(here, met.jacobian),
        admissible=real,
        status=Status.OK,
    )
    return CodimTwoPoint(
        kind=met.kind,
        values=_pair(values),
        errors=_pair(errors),
        point=point,
        label_before=labels[0],
        label_after=labels[1],
        solved=met.solved,
        note="; ".join(filter(None, (str(met.kind), met.note))),
        status=Status.OK,
    )
