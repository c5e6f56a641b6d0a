"""With what a curve of the atlas begins: a special point of a branch, or a point where two things happen."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.branches.continuation import Extremum, SpecialKind, SpecialPoint
from gearlash.branches.curves import CodimTwoKind, CodimTwoPoint, Curve, CurvePoint
from gearlash.system import Family, Signature

Array = NDArray[np.float64]
DRAWN = (SpecialKind.GRAZING, SpecialKind.FOLD, SpecialKind.DOUBLING, SpecialKind.TORUS)
"""Kinds of curves, in the order in which they are begun."""
BY_TWO = {
    CodimTwoKind.GRAZING_DOUBLING: (SpecialKind.GRAZING, SpecialKind.DOUBLING),
    CodimTwoKind.GRAZING_FOLD: (SpecialKind.GRAZING, SpecialKind.FOLD),
    CodimTwoKind.GRAZING_TORUS: (SpecialKind.GRAZING, SpecialKind.TORUS),
    CodimTwoKind.CUSP: (SpecialKind.FOLD,),
    CodimTwoKind.GENERALISED_DOUBLING: (SpecialKind.DOUBLING,),
    CodimTwoKind.FOLD_FLIP: (SpecialKind.FOLD, SpecialKind.DOUBLING),
    CodimTwoKind.ONE_ONE: (SpecialKind.FOLD, SpecialKind.TORUS),
    CodimTwoKind.ONE_TWO: (SpecialKind.DOUBLING, SpecialKind.TORUS),
    CodimTwoKind.ONE_THREE: (SpecialKind.TORUS,),
    CodimTwoKind.ONE_FOUR: (SpecialKind.TORUS,),
    CodimTwoKind.DEGENERATE: (SpecialKind.GRAZING,),
    CodimTwoKind.FLAT: (SpecialKind.GRAZING,),
    CodimTwoKind.NO_ROOT: (SpecialKind.GRAZING,),
}
"""The curves that pass through a point where two things happen."""
CROSSING = 2  # curves of grazings that cross where two extrema touch, or at a corner


@dataclass(frozen=True, eq=False)
class Seed:
    """``kind`` and ``period`` (in mesh cycles) are those of the curve, ``strobes`` (m, n) the states of its
    orbit at phase zero, ``touch`` the extremum that touches on a curve of grazings. ``number`` and
    ``doubled`` are what `continue_curve` is told of a point where two things happen. ``values`` are all
    parameters, ``way`` says how it was found."""

    start: SpecialPoint | CodimTwoPoint
    kind: SpecialKind
    period: int
    label: Signature
    strobes: Array
    touch: Extremum | None
    values: Mapping[str, float]
    way: str
    number: int = 0
    doubled: bool = False

    @property
    def elsewhere(self) -> bool:
        """Whether its orbit is another one than that of its start: at a corner there is one of every size."""
        corner = isinstance(self.start, CodimTwoPoint) and self.start.kind is CodimTwoKind.CORNER
        return corner and self.number > 0

    def place(self, names: tuple[str, str]) -> tuple[float, float]:
        return self.values[names[0]], self.values[names[1]]


def seed_of_special(special: SpecialPoint, way: str) -> Seed | None:
    """Of a special point of a branch; None where no curve of its kind is followed. Where an orbit joins that
    of half its period, it is the doubling of the latter."""
    kind, period, label = special.kind, special.point.period, special.label_before
    if kind is SpecialKind.JOINS:
        kind, period = SpecialKind.DOUBLING, period // 2
        half = [(drive // 2, back // 2) for drive, back in label.counts]
        label = Signature(period, *half[0], others=tuple(half[1:]))
    if kind not in DRAWN:
        return None
    touch = special.extremum if kind is SpecialKind.GRAZING else None
    return Seed(special, kind, period, label, special.point.strobes, touch, special.values, way)


def seeds_of_two(
    family: Family, special: CodimTwoPoint, values: Mapping[str, float], known: Sequence[Curve]
) -> Iterator[Seed]:
    """The curves that pass through a point where two things happen, but for those that are ``known``."""
    point, way = special.point, f"through a point: {special.kind}"
    about = point.period, point.signature, strobes_of(family, values, point)
    kinds = [curve.kind for curve in known if curve.points[0].period == point.period]
    crossing = special.kind in (CodimTwoKind.TWO_GRAZINGS, CodimTwoKind.CORNER)
    if crossing and kinds.count(SpecialKind.GRAZING) < CROSSING:
        for i in range(CROSSING):
            touch = point.touches[min(i, len(point.touches) - 1)]
            yield Seed(special, SpecialKind.GRAZING, *about, touch, values, way, i)
    for kind in BY_TWO.get(special.kind, ()):
        touch = point.touches[0] if kind is SpecialKind.GRAZING and point.touches else None
        if kind not in kinds and (kind is not SpecialKind.GRAZING or touch is not None):
            yield Seed(special, kind, *about, touch, values, way)


def doubled_seed(family: Family, special: CodimTwoPoint, values: Mapping[str, float]) -> Seed | None:
    """Where a grazing orbit doubles: the curve on which the orbit of twice its period grazes."""
    if special.kind is not CodimTwoKind.GRAZING_DOUBLING:
        return None
    point = special.point
    about = strobes_of(family, values, point), point.touches[0], values
    way = f"the doubled orbit, from a point: {special.kind}"
    return Seed(
        special, SpecialKind.GRAZING, 2 * point.period, point.signature.twice, *about, way, doubled=True
    )


def strobes_of(family: Family, values: Mapping[str, float], point: CurvePoint) -> Array:
    """States (m, n) of its orbit at phase zero of every base period."""
    props = flow.propagators(family.system(values))
    cycles, found = props.system.cycles, [point.state]
    for _ in range(point.period // cycles - 1):
        found.append(flow.carry(props, found[-1], float(cycles)).state)
    return np.array(found)
