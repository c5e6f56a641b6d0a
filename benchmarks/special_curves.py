"""Curves of special orbits of the article's pair in two parameters: what a point of them takes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from gearlash.branches.continuation import ContinuationSettings, SpecialKind, continue_orbit
from gearlash.branches.curves import Curve, Listener, Plane, beginning, curve_through
from gearlash.orbits import Orbit, attractor
from gearlash.system import GearlashError

from .results import OWN, Row
from .timing import Runner, in_turns
from .works import family

TASK = "a curve"
POINTS = 200
HOW = "every orbit with multipliers, extrema and admissibility, and co-dimension-2 points solved for"
Pair = tuple[float, float]
QUIET = Listener(lambda _: None, lambda: False)


@dataclass(frozen=True)
class Asked:
    """A curve: a special point of a branch, which leads from an orbit at ``values`` along ``name`` between
    ``ends``; and the plane in which it is followed."""

    work: str
    period: int
    values: dict[str, float]
    name: str
    ends: Pair
    kind: SpecialKind
    names: tuple[str, str]
    lower: Pair
    upper: Pair


ASKED = (
    Asked(
        "article, P = 1, grazing over ω and load", 1, {"omega": 1.05}, "omega", (1.0, 1.13),
        SpecialKind.GRAZING, ("omega", "load"), (0.9, 0.05), (1.2, 0.15),
    ),
    Asked(
        "article, P = 6, doubling over D and damping", 6, {"omega": 0.78, "D": 0.37}, "D", (0.34, 0.4),
        SpecialKind.DOUBLING, ("D", "bearing_damping"), (0.34, 0.036), (0.36, 0.05),
    ),
)  # fmt: skip


def curve_rows(repeats: int, quick: bool) -> list[Row]:
    """A row for each of the curves."""
    rows = []
    for asked in ASKED:
        run = _ready(asked, 0.1 if quick else 0.02)
        points = len(run().points)
        time = in_turns([Runner(OWN, run, points)], repeats)[OWN]
        rows.append(Row(TASK, asked.work, OWN, "point", time.median, time.best, how=HOW))
    return rows


def _ready(asked: Asked, longest: float) -> Callable[[], Curve]:
    """The following of a curve, its start found."""
    pairs = family("article")
    found = attractor(pairs.system(asked.values), pairs.start(asked.values))
    if not isinstance(found, Orbit) or found.period != asked.period:
        raise GearlashError(f"the benchmark expects an orbit of period {asked.period} at {asked.values}")
    branch = continue_orbit(pairs, asked.values, asked.name, found, *asked.ends)
    special = branch.of_kind(asked.kind)[0]
    values = pairs.complete({**asked.values, asked.name: special.value})
    settings = ContinuationSettings(longest=longest, certify=False)
    place = np.array([values[name] for name in asked.names])

    def run() -> Curve:
        plane = Plane(pairs, values, asked.names, asked.lower, asked.upper)
        return curve_through(beginning(plane, special, place, None), settings, QUIET)

    return run
