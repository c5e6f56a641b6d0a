"""The search for a zone in a plane: lines, curves through their ends, and what takes over from these."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from gearlash.branches.continuation import ContinuationSettings, SpecialKind, SpecialPoint
from gearlash.branches.curves import (
    CodimTwoKind,
    CodimTwoPoint,
    Curve,
    Listener,
    Plane,
    beginning,
    curve_through,
)
from gearlash.system import GearlashError

from .following import Following
from .plane_zone import encloses
from .zone_end import Quiet
from .zone_lines import STOPPED, Line, Lines, Seen
from .zone_outline import Border, Tracer, apart, area
from .zone_parts import Part, parts_of

Array = NDArray[np.float64]
STEPS = ContinuationSettings(longest=0.06, certify=False)
KNOWN = 1e-4  # of the rectangle: an end so near to a known piece of its kind lies on it
ROUNDING = 1e-9  # of the rectangle
MOST_CURVES = 40
ROUNDS = 12  # of looking for what takes over
TAKES_OVER: Mapping[CodimTwoKind, tuple[tuple[SpecialKind, int], ...]] = {
    CodimTwoKind.GRAZING_DOUBLING: ((SpecialKind.GRAZING, 0), (SpecialKind.DOUBLING, 0)),
    CodimTwoKind.GRAZING_FOLD: ((SpecialKind.GRAZING, 0), (SpecialKind.FOLD, 0)),
    CodimTwoKind.GRAZING_TORUS: ((SpecialKind.GRAZING, 0), (SpecialKind.TORUS, 0)),
    CodimTwoKind.CORNER: ((SpecialKind.GRAZING, 0), (SpecialKind.GRAZING, 1)),
    CodimTwoKind.TWO_GRAZINGS: ((SpecialKind.GRAZING, 0), (SpecialKind.GRAZING, 1)),
    CodimTwoKind.FOLD_FLIP: ((SpecialKind.FOLD, 0), (SpecialKind.DOUBLING, 0)),
    CodimTwoKind.ONE_ONE: ((SpecialKind.FOLD, 0), (SpecialKind.TORUS, 0)),
    CodimTwoKind.ONE_TWO: ((SpecialKind.DOUBLING, 0), (SpecialKind.TORUS, 0)),
}
"""Curves that meet where two things happen at once, each with which touch it is."""


@dataclass(eq=False)
class Search:
    """All lines and pieces of curves; ``axes``: the four lines from the operating point."""

    plane: Plane
    quiet: Quiet
    start: Seen
    more: int
    following: Following
    lines: list[Line] = field(default_factory=list)
    axes: list[Line] = field(default_factory=list)
    parts: list[Part] = field(default_factory=list)
    ends: list[tuple[Array, Array, Line]] = field(default_factory=list)  # places, outward
    tried: list[tuple[CodimTwoKind, Array]] = field(default_factory=list)
    notes: dict[str, None] = field(default_factory=dict)  # what is missing
    remarks: dict[str, None] = field(default_factory=dict)  # what is to be known beside
    curves: int = 0

    @property
    def tracer(self) -> Tracer:
        return Tracer(self.parts, np.array(self.plane.lower), np.array(self.plane.upper))

    @property
    def follower(self) -> Lines:
        return Lines(self.plane, self.quiet, self.following.tell, self.following.stop)

    def run(self) -> None:
        for axis in (0, 1):
            self.axes += [line for up in (False, True) if (line := self.follow(self.start, axis, up))]
        if len(self.axes) < 4:
            raise GearlashError("the orbit at the operating point could not be followed from there")
        self.take_over()
        for axis in (0, 1):
            for seen in self.between(axis):
                for up in (False, True):
                    self.follow(seen, 1 - axis, up)
        self.edges()
        self.take_over()

    def between(self, axis: int) -> list[Seen]:
        """Orbits evenly along the lines of one axis through the operating point."""
        along = [*reversed(self.axes[2 * axis].seen), *self.axes[2 * axis + 1].seen[1:]]
        values = np.array([seen.place[axis] for seen in along])
        ends = self.axes[2 * axis].end.place[axis], self.axes[2 * axis + 1].end.place[axis]
        wanted = ends[0] + (ends[1] - ends[0]) * (np.arange(self.more) + 0.5) / max(self.more, 1)
        found = []
        for value in wanted.tolist():
            near = along[int(np.abs(values - value).argmin())]
            place = near.place.copy()
            place[axis] = value
            found.append(Seen(place, self.state_at(along, axis, value), near.period))
        return found

    def state_at(self, along: list[Seen], axis: int, value: float) -> Array:
        """Between those of two neighbours."""
        for one, two in pairwise(along):
            low, high = one.place[axis], two.place[axis]
            if low <= value <= high and high > low:
                return one.state + (value - low) / (high - low) * (two.state - one.state)
        return min(along, key=lambda seen: abs(seen.place[axis] - value)).state

    def edges(self) -> None:
        """Along the rectangle from where lines end at it, as far as that was not followed yet."""
        unit = self.plane.unit
        done: list[tuple[int, float, float, float]] = []  # axis, value across, from, to
        for line in list(self.lines):
            if not line.end.at_limit:
                continue
            place, axis = line.end.place, 1 - line.axis
            across, here = float(place[line.axis]), float(place[axis])
            if any(a == axis and c == across and low <= here <= high for a, c, low, high in done):
                continue
            seen = Seen(place, line.seen[-1].state, line.seen[-1].period)
            reached = [self.follow(seen, axis, up) for up in (False, True)]
            ends = [here if each is None else float(each.end.place[axis]) for each in reached]
            done.append((axis, across, ends[0] - ROUNDING * unit[axis], ends[1] + ROUNDING * unit[axis]))

    def follow(self, seen: Seen, axis: int, upward: bool) -> Line | None:
        """One line, and the curve through its end."""
        if len(self.axes) == 4 and self.following.stop():
            self.notes[STOPPED] = None
            return None
        try:
            line = self.follower.line(seen, axis, upward)
        except GearlashError as error:
            self.notes[f"from {self.where(seen.place)}: {error}"] = None
            return None
        if line is None:
            self.notes[f"at {self.where(seen.place)} the orbit was not found again"] = None
            return None
        self.lines.append(line)
        if line.end.special is not None:
            outward = np.zeros(2)
            outward[axis] = 1.0 if upward else -1.0
            self.ends.append((line.end.place, outward, line))
            if not self.known(line.end.place, line.end.special.kind):
                self.add(line.end.special, line.end.place, None, 0)
        elif not line.end.at_limit:
            self.notes[f"at {self.where(line.end.place)}: {line.end.reason}"] = None
        return line

    def known(self, place: Array, kind: SpecialKind) -> bool:
        wanted = SpecialKind.DOUBLING if kind is SpecialKind.JOINS else kind
        return any(far <= KNOWN and part.bound.kind is wanted for far, part in apart(self.tracer, place))

    def add(
        self, special: SpecialPoint | CodimTwoPoint, place: Array, kind: SpecialKind | None, touch: int
    ) -> None:
        """The pieces of the curve through a point that are not known yet."""
        if self.following.stop() or self.curves >= MOST_CURVES:
            self.notes["stopped, or too many curves: not all were followed"] = None
            return
        self.curves += 1
        listen = Listener(self.following.tell, self.following.stop)
        try:
            begun = beginning(self.plane, special, place, kind, touch)
            curve = curve_through(begun, STEPS, listen)
        except (GearlashError, np.linalg.LinAlgError) as error:
            if isinstance(special, SpecialPoint):
                self.notes[f"no curve through the {special.kind} at {self.where(place)}: {error}"] = None
            return
        at = special if isinstance(special, CodimTwoPoint) else None
        self.parts += [part for part in parts_of(curve, self.quiet, at) if not self.same(part, curve)]

    def same(self, part: Part, curve: Curve) -> bool:
        middle = part.bound.points[len(part.bound.points) // 2]
        return self.known(np.array(middle.values), curve.kind)

    def take_over(self) -> None:
        """Curves that begin where pieces end."""
        for _ in range(ROUNDS):
            open_ = [
                end
                for part in self.parts
                for end, how in zip(part.bound.ends, part.how, strict=True)
                if end is not None and not how and not self.was_tried(end)
            ]
            if not open_:
                return
            for end in open_:
                if self.was_tried(end):
                    continue
                self.tried.append((end.kind, np.array(end.values)))
                for kind, touch in TAKES_OVER.get(end.kind, ()):
                    self.add(end, np.array(end.values), kind, touch)

    def was_tried(self, end: CodimTwoPoint) -> bool:
        return any(
            kind is end.kind and np.abs((place - end.values) / self.plane.unit).max() < KNOWN
            for kind, place in self.tried
        )

    def where(self, place: Array) -> str:
        return ", ".join(
            f"{name} = {v:.6g}" for name, v in zip(self.plane.names, place.tolist(), strict=True)
        )

    def borders(self) -> tuple[Array, tuple[Array, ...], list[Part], tuple[str, ...]]:
        """The outer border, holes, the pieces on them, and what is missing."""
        folded = [part for part in self.parts if self.folds_over(part)]
        whole, tracer = self.tracer, replace(self.tracer, parts=[p for p in self.parts if p not in folded])
        borders, used = [], []
        for place, outward, line in self.ends:
            assert line.end.special is not None
            near = min(apart(whole, place), key=lambda pair: pair[0], default=(np.inf, None))
            part = near[1]
            if part in folded and near[0] <= KNOWN:
                continue
            if part is None or near[0] > KNOWN:
                self.notes[f"at {self.where(place)} the zone ends, on no curve that was followed"] = None
                continue
            if any(part is each for each in used):
                continue
            border = tracer.border((part, tracer.toward(part, place, outward)), place)
            borders.append(border)
            used += border.parts
        if not any(self.outer(border) for border in borders):
            limit = next((line for line in self.axes if line.end.at_limit), None)
            if limit is not None:
                borders.append(tracer.border(None, limit.end.place))
        outer, holes, parts, notes = self.sorted(borders)
        return outer, holes, [*parts, *folded], notes

    def folds_over(self, part: Part) -> bool:
        """Whether two folds leave a cusp on a piece: between them the zone lies over itself, and beyond the
        cusp it is one, so that they are no border of what it covers."""
        first, last = part.bound.points[0].arclength, part.bound.points[-1].arclength
        cusps = [s for s in part.bound.curve.of_kind(CodimTwoKind.CUSP) if first < s.arclength < last]
        for cusp in cusps:
            self.remarks[
                f"between the two folds that leave the cusp at {self.where(np.array(cusp.values))} two "
                "motions of the zone coexist: each is lost at one of them, on to the other"
            ] = None
        return bool(cusps)

    def outer(self, border: Border) -> bool:
        return len(border.polygon) > 2 and area(border.polygon) > 0.0

    def sorted(self, borders: list[Border]) -> tuple[Array, tuple[Array, ...], list[Part], tuple[str, ...]]:
        for border in borders:
            if border.reason and border.where is not None:
                self.notes[f"the border is open at {self.where(np.array(border.where))}: {border.reason}"] = (
                    None
                )
        outer = [b.polygon for b in borders if self.outer(b) and encloses(b.polygon, self.start.place)]
        holes = [b.polygon for b in borders if len(b.polygon) > 2 and area(b.polygon) < 0.0]
        if len(outer) != 1:
            self.notes[f"{len(outer)} borders around the operating point could be closed"] = None
        parts: list[Part] = []
        for border in borders:
            parts += [part for part in border.parts if not any(part is each for each in parts)]
        return (outer[0] if outer else np.empty((0, 2))), tuple(holes), parts, tuple(self.notes)
