"""The map as a check: every change of label between neighbouring pixels, and why there is one."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from gearlash.branches.continuation import SpecialPoint
from gearlash.jobs import Chain, Execution, run
from gearlash.orbits import Settings
from gearlash.results.atlas import LabelChange, LabelChangeKind
from gearlash.results.plane import CERTIFICATES, STATUSES, PlaneMap
from gearlash.studies.model import Source
from gearlash.system import Signature, Status

from .between import Between, Walked, walk_between
from .drawn import Drawn
from .links import Link, connected, links_of_special, links_of_step
from .seeds import Seed, seed_of_special

Array = NDArray[np.float64]
Pixel = tuple[int, int]
CERTIFIED = CERTIFICATES.index("certified")
WAY = "of a change of label between neighbouring pixels"


@dataclass(eq=False)
class Check:
    """``walks``: what was met on the way from the first pixel of a pair to the second, and back."""

    plane: PlaneMap
    source: Source
    start: tuple[float, ...] | None
    settings: Settings
    execution: Execution
    drawn: Drawn
    longest: int
    walks: dict[tuple[Pixel, Pixel], Walked] = field(default_factory=dict)
    reason: str = ""

    def pairs(self) -> Iterator[tuple[Pixel, Pixel]]:
        """Neighbouring pixels with different labels, both computed."""
        codes = self.plane.label
        for row, column in np.ndindex(codes.shape):
            for other in ((row, column + 1), (row + 1, column)):
                inside = other[0] < codes.shape[0] and other[1] < codes.shape[1]
                seen = inside and self._computed((row, column)) and self._computed(other)
                if seen and codes[row, column] != codes[other]:
                    yield (row, column), other

    def _computed(self, pixel: Pixel) -> bool:
        return STATUSES[self.plane.status[pixel]] is not Status.NOT_COMPUTED

    def walk(self) -> list[Seed]:
        """Goes from either pixel to the other where no curve explains why they differ; what was met there is
        what curves begin with."""
        open_ = [
            change.pixels
            for change in self.changes()
            if change.kind in (LabelChangeKind.NONE, LabelChangeKind.POINT)
            and change.pixels not in self.walks
        ]
        asked = [way for one, other in open_ for way in ((one, other), (other, one))]
        if asked and not self.reason:
            chains = [Chain(way, (self._task(*way),), (1,)) for way in asked]
            outcome = run(walk_between, chains, self.execution)
            self.reason = outcome.reason
            self.walks.update({way: outcome.results[way][0] for way in asked if outcome.results.get(way)})
        met = [special for way in asked if way in self.walks for special in self.walks[way].specials]
        return [seed for special in met if (seed := seed_of_special(special, WAY)) is not None]

    def _task(self, here: Pixel, there: Pixel) -> Between:
        x, y = self.plane.x, self.plane.y
        along, to = (x, there[1]) if here[0] == there[0] else (y, there[0])
        values = {
            **self.plane.fixed, x.name: float(x.values[here[1]]), y.name: float(y.values[here[0]])
        }  # fmt: skip
        return Between(
            self.source, tuple(values.items()), along.name, float(along.values[to]), self.start,
            self.settings, self.longest,
        )  # fmt: skip

    def changes(self) -> tuple[LabelChange, ...]:
        """All changes of label, with what is known by now."""
        steps = Steps.of(self.drawn)
        return tuple(self._change(one, other, steps) for one, other in self.pairs())

    def _change(self, one: Pixel, other: Pixel, steps: Steps) -> LabelChange:
        labels = self.plane.label_at(*one), self.plane.label_at(*other)
        values = self._values(one), self._values(other)
        about = (one, other), values, labels
        a, b = labels
        if not isinstance(a, Signature) or not isinstance(b, Signature):
            return LabelChange(*about, LabelChangeKind.APERIODIC)
        crossed = steps.crossed(*((np.array(each) - self.drawn.lower) / self.drawn.width for each in values))
        known = dict[int, list[Link]]()
        for number, i in crossed:
            line = self.drawn.lines[number]
            known.setdefault(number, []).extend(links_of_step(line.curve, line.around(i)))
        met = list(self._met(one, other))
        for special, number, last in met:
            if number >= 0:
                known.setdefault(number, []).extend(links_of_special(special, last))
        by_curves = [link for found in known.values() for link in found]
        numbers = tuple(sorted(number for number, found in known.items() if found))
        if connected(a, b, by_curves):
            return LabelChange(*about, LabelChangeKind.CURVE, numbers)
        together = list(self._together(one, other, (a, b)))
        if connected(a, b, [*by_curves, *together]):
            return LabelChange(*about, LabelChangeKind.COEXIST, numbers)
        points = [link for special, _, last in met for link in links_of_special(special, last)]
        if connected(a, b, [*by_curves, *together, *points]):
            what = dict.fromkeys(
                f"{s.kind} at {s.name} = {s.value:.6g}" for s, number, _ in met if number < 0
            )
            return LabelChange(*about, LabelChangeKind.POINT, numbers, ", ".join(what))
        ways = ((one, other), (other, one))
        if self.reason and any(way not in self.walks for way in ways):
            return LabelChange(*about, LabelChangeKind.UNSEEN, numbers)
        why = [self.walks[way].why for way in ways if way in self.walks]
        return LabelChange(*about, LabelChangeKind.NONE, numbers, "; ".join(dict.fromkeys(filter(None, why))))

    def _values(self, pixel: Pixel) -> tuple[float, float]:
        return float(self.plane.x.values[pixel[1]]), float(self.plane.y.values[pixel[0]])

    def _met(self, one: Pixel, other: Pixel) -> Iterator[tuple[SpecialPoint, int, bool]]:
        """Special points between two pixels, the curve that each lies on, and whether a motion ends there."""
        for way in ((one, other), (other, one)):
            walked = self.walks.get(way, Walked())
            for i, special in enumerate(walked.specials):
                seed = seed_of_special(special, WAY)
                number = -1 if seed is None else self.drawn.knows(seed)
                ended = walked.arrived is None and i == len(walked.specials) - 1
                yield special, number, ended

    def _together(self, one: Pixel, other: Pixel, labels: tuple[Signature, Signature]) -> Iterator[Link]:
        """What attracts beside the motion of a pixel, both certified."""
        for way, there in (((one, other), labels[1]), ((other, one), labels[0])):
            walked = self.walks.get(way)
            if walked is None or walked.arrived is None or walked.arrived == there:
                continue
            if self.plane.certificate[way[1]] == CERTIFIED:
                yield Link(walked.arrived, there)


@dataclass(frozen=True, eq=False)
class Steps:
    """All steps of all curves, in units of the rectangle: from ``left`` to ``right`` (m, 2); ``numbers`` (m,)
    of their curves, ``at`` (m,) of the steps."""

    left: Array
    right: Array
    numbers: NDArray[np.int64]
    at: NDArray[np.int64]

    @staticmethod
    def of(drawn: Drawn) -> Steps:
        places = [line.places for line in drawn.lines]
        counts = [max(len(each) - 1, 0) for each in places]
        return Steps(
            np.concatenate([np.zeros((0, 2)), *(each[:-1] for each in places)]),
            np.concatenate([np.zeros((0, 2)), *(each[1:] for each in places)]),
            np.repeat(np.arange(len(places)), counts),
            np.concatenate([np.zeros(0, np.int64), *(np.arange(count) for count in counts)]),
        )

    def crossed(self, one: Array, other: Array) -> list[tuple[int, int]]:
        """Curve and step that cross the way from one place to another."""
        way, step = other - one, self.right - self.left
        sides = [_cross(way, end - one) for end in (self.left, self.right)]
        ends = [_cross(step, end - self.left) for end in (one, other)]
        found = np.flatnonzero((sides[0] * sides[1] <= 0.0) & (ends[0] * ends[1] <= 0.0))
        return [(int(self.numbers[i]), int(self.at[i])) for i in found]


def _cross(one: Array, other: Array) -> Array:
    """Of vectors (..., 2)."""
    return one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0]
