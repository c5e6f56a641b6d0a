"""The extrema of an orbit, each beside the boundary that it may touch, followed from orbit to orbit.

The least distance of an orbit from a boundary has kinks along a branch, where one extremum takes the lead of
another. Each extremum by itself has none. So every one keeps a number of its own as long as it exists;
extrema are born and die in pairs of a minimum and a maximum."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import count
from typing import NamedTuple

import numpy as np

from gearlash.orbits import GrazingCheck, Orbit, grazing_checks
from gearlash.orbits.extrema import gap_extrema
from gearlash.system import ContactRule

from .seam import lost_at_seam, near_seam, twice_at_seam

LARGEST_MOVE = 0.5  # of the way to the next extremum of its kind: how far one may move in a step, in phase
TIED = 1e-6  # of the orbit's period: extrema of one kind so near in phase cannot be told apart

Group = tuple[int, str, int, int]
"""Clearance, surface, boundary, sign of the curvature: extrema of one kind."""


class Extremum(NamedTuple):
    """One extremum of an orbit beside a boundary that it may touch.

    Attributes
    ----------
    number : int
        Its own along the branch.
    clearance : int
        Index of the gap.
    surface : {"gap", "force"}
        Of what it is an extremum: X, or with the rule `no-tension` the contact force Φ.
    boundary : {1, -1}
        Drive or back side.
    phase : float
        In mesh cycles.
    distance : float
        From the boundary, signed: X ∓ D, or Φ.
    a0 : float
        X'' there, or Φ''.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("article").family()
    >>> branch = gl.continue_branch(family, "omega", lower=1.0, upper=1.12)
    >>> touch = branch.special[0].extremum
    >>> touch.boundary, touch.a0 > 0.0
    (1, True)
    """

    number: int
    clearance: int
    surface: str
    boundary: int
    phase: float
    distance: float
    a0: float

    @property
    def group(self) -> Group:
        """Clearance, surface, boundary and sign of the curvature: extrema of one kind."""
        return self.clearance, self.surface, self.boundary, 1 if self.a0 > 0.0 else -1


@dataclass(frozen=True, eq=False)
class Extrema:
    """Of one orbit; ``born`` and ``died``: numbers that appeared, or are no longer there, against the orbit
    before it; ``doubt``: what could not be told about them."""

    all: tuple[Extremum, ...]
    cycles: float
    numbers: count[int]
    born: tuple[int, ...] = ()
    died: tuple[int, ...] = ()
    doubt: str = ""

    @staticmethod
    def of(orbit: Orbit) -> Extrema:
        """Numbered from zero on."""
        found = [*map(_plain, grazing_checks(orbit)), *_at_edges(orbit), *_at_seam(orbit)]
        found = _once(found, float(orbit.period))
        found.sort(key=lambda extremum: (extremum.phase, extremum.boundary))
        named = tuple(extremum._replace(number=i) for i, extremum in enumerate(found))
        return Extrema(named, float(orbit.period), count(len(named)))

    @property
    def by_number(self) -> dict[int, Extremum]:
        return {extremum.number: extremum for extremum in self.all}

    @property
    def groups(self) -> dict[Group, list[Extremum]]:
        found: dict[Group, list[Extremum]] = defaultdict(list)
        for extremum in self.all:
            found[extremum.group].append(extremum)
        return dict(found)

    def after(self, before: Extrema) -> Extrema:
        """The same, with the numbers of those of a neighbouring orbit that they continue."""
        named: list[Extremum] = []
        died: list[int] = []
        doubt = ""
        mine, its = before.groups, self.groups
        for group in sorted({*mine, *its}):
            here, there = mine.get(group, []), its.get(group, [])
            pairs, sure = _matched(here, there, self.cycles)
            doubt = doubt or ("" if sure else _doubt(group, here, there))
            continued = {new.phase: old.number for old, new in pairs}
            named += [e._replace(number=continued.get(e.phase, -1)) for e in there]
            died += [old.number for old in here if old.number not in continued.values()]
        born, final = [], []
        for extremum in sorted(named, key=lambda e: (e.phase, e.boundary)):
            number = next(before.numbers) if extremum.number < 0 else extremum.number
            if extremum.number < 0:
                born.append(number)
            final.append(extremum._replace(number=number))
        return Extrema(tuple(final), self.cycles, before.numbers, tuple(born), tuple(died), doubt)


def _doubt(group: Group, here: list[Extremum], there: list[Extremum]) -> str:
    phases = ["{" + ", ".join(f"{e.phase:.4g}" for e in side) + "}" for side in (here, there)]
    side = "+D" if group[2] > 0 else "-D"
    return (
        f"extrema of clearance {group[0]} beside {side} cannot be told apart: phases {' and '.join(phases)}"
    )


def _plain(check: GrazingCheck) -> Extremum:
    return Extremum(-1, check.clearance, check.surface, check.boundary, check.phase, check.distance, check.a0)


def _at_edges(orbit: Orbit) -> Iterator[Extremum]:
    """With `no-tension` contact is not lost at the boundary of the gap. But where the sides are apart already
    and X comes back just to the boundary, it makes a difference whether it stays beyond, where the force
    rises from zero, or passes it and comes from the gap, where the damping sets in at once."""
    for j, c in enumerate(orbit.propagators.system.clearances):
        if c.contact is not ContactRule.NO_TENSION:
            continue
        found = gap_extrema(orbit.trace, j)
        for boundary, gap, damping in ((1, c.gap_plus, c.dampings[0]), (-1, -c.gap_minus, c.dampings[1])):
            if not c.stops(boundary) or damping == 0.0:
                continue
            for phase, x, a0 in zip(found.phase, found.displacement, found.curvature, strict=True):
                if boundary * a0 > 0.0:
                    yield Extremum(-1, j, "gap", boundary, float(phase), float(x - gap), float(a0))


def _at_seam(orbit: Orbit) -> Iterator[Extremum]:
    """Extrema of the gap at phase zero that the trace of the orbit does not have."""
    for j, c in enumerate(orbit.propagators.system.clearances):
        lost = lost_at_seam(orbit, j, gap_extrema(orbit.trace, j).phase.tolist())
        if lost is None:
            continue
        x, a0 = lost
        for boundary, gap in ((1, c.gap_plus), (-1, -c.gap_minus)):
            inside = c.contact is not ContactRule.NO_TENSION or boundary * a0 < 0.0
            if c.stops(boundary) and (inside or any(c.dampings)):
                yield Extremum(-1, j, "gap", boundary, 0.0, x - gap, a0)


def _once(found: list[Extremum], length: float) -> list[Extremum]:
    """Without those at the end of the orbit that are at its beginning, too."""
    kept: list[Extremum] = []
    at_seam: list[Extremum] = []  # of those that are kept
    for each in found:
        if near_seam(each.phase, length):
            same = (other for other in at_seam if other.group == each.group)
            if any(twice_at_seam(each.phase, other.phase, length) for other in same):
                continue
            at_seam.append(each)
        kept.append(each)
    return kept


def _matched(
    here: list[Extremum], there: list[Extremum], cycles: float
) -> tuple[list[tuple[Extremum, Extremum]], bool]:
    """Pairs of extrema of one kind that continue each other: each the nearest of the other in phase. Whether
    that is beyond doubt: each moved by less than half of the way to the next."""
    if not here or not there:
        return [], True
    one, two = (np.array([e.phase for e in side]) for side in (here, there))
    away = (two[None, :] - one[:, None]) % cycles
    away = np.minimum(away, cycles - away)
    nearest, back = away.argmin(axis=1), away.argmin(axis=0)
    pairs = [(here[i], there[j]) for i, j in enumerate(nearest.tolist()) if back[j] == i]
    equal = len(here) == len(there)
    if equal and len(pairs) < len(here):
        return pairs, False
    if not equal and len(pairs) < min(len(here), len(there)):
        return pairs, False
    spacing = _spacing(one, cycles)
    sure = all(
        away[i, j] <= LARGEST_MOVE * spacing[i] or spacing[i] <= TIED * cycles
        for i, j in enumerate(nearest.tolist())
        if back[j] == i
    )
    return pairs, sure


def _spacing(phases: np.ndarray, cycles: float) -> np.ndarray:
    """Distance of every phase from the next one."""
    if len(phases) == 1:
        return np.array([0.5 * cycles])
    away = np.abs(phases[:, None] - phases[None, :])
    away = np.minimum(away, cycles - away)
    np.fill_diagonal(away, np.inf)
    return away.min(axis=1)
