"""An atlas of a rectangle of two parameters: a map, branches on lines through it, curves, and their check."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from gearlash.branches.continuation import ContinuationSettings
from gearlash.jobs import Execution, run
from gearlash.jobs.stop import NEVER, Cancel
from gearlash.orbits import Settings
from gearlash.results import Axis
from gearlash.results.atlas import STAGES, Atlas
from gearlash.studies.arguments import checked_execution, checked_settings, checked_start, checked_values
from gearlash.studies.model import Model, Source
from gearlash.studies.named import plain_axis
from gearlash.studies.plane import map_plane
from gearlash.system import Family, GearlashError, given

from .changes import Check
from .drawing import Drawing
from .drawn import Drawn
from .lines import OnLine, follow_line, line_chains
from .made import curves_of, points_of, undone_of
from .seeds import Seed, doubled_seed, seed_of_special, seeds_of_two

CURVES, LINES, DEPTH, LONGEST = 60, 3, 2, 12
STEPS = ContinuationSettings(first=0.01, longest=0.1, most_points=300, certify=False)
FEWEST = 2  # values of an axis
OUTSIDE = 1e-6  # how far outside the unit circle a multiplier of a point where two things happen is
TIME = "the time that was given is over"


def atlas(
    model: Model,
    x: Axis,
    y: Axis,
    *,
    values: Mapping[str, float | str] | None = None,
    curves: int = CURVES,
    lines: int = LINES,
    depth: int = DEPTH,
    longest: int = LONGEST,
    seconds: float | None = None,
    start: ArrayLike | None = None,
    settings: Settings | None = None,
    execution: Execution | None = None,
) -> Atlas:
    """The curves of special orbits in a rectangle of two parameters, and where they meet.

    Motions are looked for by a coarse map and by sweeps in both directions along a few lines. Each periodic
    one is followed along its branch; at every special point at which one that attracts begins, ends or
    changes, the curve of that kind of point is followed through the rectangle. Then the map is a check:
    where neighbouring pixels show different motions and no curve of these lies between them, each motion is
    followed to the other pixel, and what it meets begins further curves; so do points at which two things
    happen at once. What is found is not all there is: motions that neither map nor sweep show are not there.

    Parameters
    ----------
    model : Case or Family
    x, y : Axis
        Two parameters and the values of the coarse map, at least two each; the rectangle goes from the first
        to the last. A case takes names and units as in its file.
    values : mapping of str to float or str, optional
        Other parameters, over those of the model.
    curves : int, default 60
        Budget: curves that are followed at the most, 0 or more, those that turn out to be known among them.
        It counts work and no time, so that the answer is the same on any machine.
    lines : int, default 3
        Lines along either axis, evenly spread, on which motions are swept and followed, 0 to 64.
    depth : int, default 2
        How many times curves are begun anew from what the check and the points of the curves show, 0 to 8.
    longest : int, default 12
        Period in mesh cycles of the longest motion that is followed, 1 to 64.
    seconds : float, optional
        Budget of time: what is not done by then is left. The answer then depends on the machine.
    start : array_like of shape (n,), optional
        State at phase zero from which pixels and sweeps start; the model's cold start without.
    settings : Settings, optional
        How attractors are looked for.
    execution : Execution, optional
        Who does the work, who is told and who may stop it: what is stopped has what is there by then.

    Returns
    -------
    Atlas

    Raises
    ------
    GearlashError
        For arguments that do not fit.

    References
    ----------
    M. di Bernardo, C. Budd, A. Champneys, P. Kowalczyk, Piecewise-smooth Dynamical Systems (2008), ch. 8,
    doi:10.1007/978-1-84628-708-4. Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory (2004), ch. 10,
    doi:10.1007/978-1-4757-3978-7.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> x, y = gl.Axis.even("omega", 0.81, 0.83, 2), gl.Axis.even("D", 0.9, 1.1, 2)
    >>> found = gl.atlas(case, x, y, lines=1)
    >>> for each in found.curves:
    ...     print(each.kind, each.straight[0])
    grazing StraightPiece(name='D', lower=0.9, upper=1.1, value=0.820631)
    fold StraightPiece(name='D', lower=0.9, upper=1.1, value=0.828464)
    """
    source = Source.of(model)
    family = source.family()
    x, y = plain_axis(model, family, x), plain_axis(model, family, y)
    _check_axes(x, y)
    fixed, begin = checked_values(model, family, values, [x, y]), checked_start(family, start)
    asked = _Asked(
        given.whole("curves", curves, 0),
        given.whole("lines", lines, 0, 64),
        given.whole("depth", depth, 0, 8),
        given.whole("longest", longest, 1, 64),
    )
    execution = _within(checked_execution(source, execution), seconds)
    maker = _Maker(
        model, source, family, (x, y), fixed, None if begin is None else tuple(map(float, begin)),
        checked_settings(settings), execution, asked,
    )  # fmt: skip
    return maker.made()


def _check_axes(x: Axis, y: Axis) -> None:
    if x.name == y.name:
        raise GearlashError(f"both axes of the atlas are {x.name}: expected two different parameters")
    for axis in (x, y):
        if len(axis) < FEWEST:
            raise GearlashError(f"axis {axis.name} of the atlas: expected at least two values")


@dataclass(frozen=True, eq=False)
class _Asked:
    curves: int
    lines: int
    depth: int
    longest: int


@dataclass(frozen=True, eq=False)
class _Clock:
    """A cancel that is set when the time is over, too."""

    cancel: Cancel
    until: float

    def is_set(self) -> bool:
        return self.cancel.is_set() or self.over

    @property
    def over(self) -> bool:
        return time.monotonic() > self.until


def _within(execution: Execution, seconds: float | None) -> Execution:
    if seconds is None:
        return execution
    allowed = given.number("seconds", seconds)
    if not allowed > 0.0:
        raise GearlashError(f"seconds = {allowed:g}: expected a positive time")
    return replace(execution, cancel=_Clock(execution.cancel or NEVER, time.monotonic() + allowed))


@dataclass(frozen=True, eq=False)
class _Maker:
    """All that is asked, and the steps one after the other."""

    model: Model
    source: Source
    family: Family
    axes: tuple[Axis, Axis]
    fixed: dict[str, float]
    start: tuple[float, ...] | None
    settings: Settings
    execution: Execution
    asked: _Asked

    def made(self) -> Atlas:
        x, y = self.axes
        plane = map_plane(
            self.model, x, y, values=self.fixed, start=self.start, settings=self.settings,
            execution=self.execution,
        )  # fmt: skip
        drawing = self._drawing()
        drawing.reason = plane.message
        went_on = [not drawing.reason]
        lines = self._lines(drawing)
        went_on.append(not drawing.reason)
        attracting, beside = _seeds_of_lines(lines)
        drawing.draw(attracting)
        went_on.append(not drawing.reason)
        check = Check(
            plane, self.source, self.start, self.settings, self.execution, drawing.drawn, self.asked.longest,
            reason=drawing.reason,
        )  # fmt: skip
        self._deeper(drawing, check)
        reason = drawing.reason or check.reason
        return Atlas(
            plane=plane,
            curves=curves_of(drawing.drawn),
            points=points_of(drawing.drawn),
            changes=check.changes(),
            undone=tuple(undone_of(drawing, lines, beside, plane)),
            tried=drawing.tried,
            complete=not reason,
            message=self._told(reason),
            values=self._values(),
            done=tuple(stage for stage, over in zip(STAGES, [*went_on, not reason], strict=True) if over),
        )

    def _drawing(self) -> Drawing:
        x, y = self.axes
        lower, upper = ((float(x.values[i]), float(y.values[i])) for i in (0, -1))
        width = np.array(upper) - np.array(lower)
        cycles = self.family.system(self.family.complete(self.fixed)).cycles
        drawn = Drawn(self.family, (x.name, y.name), np.array(lower), width, cycles)
        return Drawing(
            self.source, lower, upper, STEPS, self.execution, drawn, self.asked.curves, self.asked.longest
        )

    def _lines(self, drawing: Drawing) -> list[OnLine]:
        if drawing.reason:
            return []
        chains = line_chains(
            self.source, self.axes, self.fixed, self.start, self.settings, self.asked.lines,
            self.asked.longest,
        )  # fmt: skip
        outcome = run(follow_line, chains, self.execution)
        drawing.reason = outcome.reason
        return [found[0] for chain in chains if (found := outcome.results.get(chain.name))]

    def _deeper(self, drawing: Drawing, check: Check) -> None:
        """Curves from the check, and from points where two things happen."""
        looked: set[int] = set()
        for _ in range(self.asked.depth):
            if drawing.reason:
                return
            seeds = check.walk()
            drawing.reason = check.reason
            seeds += list(self._seeds_of_points(drawing, looked))
            before = drawing.tried
            drawing.draw(seeds)
            if drawing.tried == before:
                return

    def _seeds_of_points(self, drawing: Drawing, looked: set[int]) -> Iterator[Seed]:
        drawn = drawing.drawn
        for point in points_of(drawn):
            special = point.special
            if id(special) in looked or not _attracts(special.point.multipliers):
                continue
            looked.add(id(special))
            values = {**self._values(), **dict(zip(drawn.names, special.values, strict=True))}
            known = [drawn.lines[i].curve for i in point.curves]
            yield from seeds_of_two(self.family, special, values, known)
            doubled = doubled_seed(self.family, special, values)
            if doubled is not None:
                yield doubled

    def _values(self) -> dict[str, float]:
        return self.family.complete(self.fixed)

    def _told(self, reason: str) -> str:
        clock = self.execution.cancel
        return TIME if reason and isinstance(clock, _Clock) and clock.over else reason


def _seeds_of_lines(lines: Sequence[OnLine]) -> tuple[list[Seed], list[Seed]]:
    """Those at which a motion that attracts begins, ends or changes, and the others."""
    attracting, beside = [], []
    for line in lines:
        for branch in line.branches:
            for special in branch.special:
                seed = seed_of_special(special, line.way)
                if seed is not None:
                    stable = special.unstable_before == 0 or special.unstable_after == 0
                    (attracting if stable else beside).append(seed)
    return attracting, beside


def _attracts(multipliers: np.ndarray) -> bool:
    return bool((np.abs(multipliers) <= 1.0 + OUTSIDE).all())
