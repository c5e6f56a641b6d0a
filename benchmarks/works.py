"""The pieces of work: pairs at chosen points, on their attractors."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gearlash import flow
from gearlash.case import load
from gearlash.flow import Propagators
from gearlash.orbits import attractor
from gearlash.system import Family, System

from .peers.plain import Array, Pair

SEED = 20_261_125
SETTLING = 4_000  # base periods
KEPT = 200  # strobes of the attractor
COUNTED = 1_000  # periods whose crossings are averaged
TOGETHER = 32  # motions marched side by side
SPREAD = 0.1  # of each of their states about the attractor, either way
MANY_PERIODS = 100  # that they are marched: on a stable orbit they come together, and then are one motion


@dataclass(frozen=True, eq=False)
class Work:
    """One point of one case: its system for both sides, and states (KEPT, n) of its attractor at phase
    zero; ``crossings`` a period, releases and engagements; starts (TOGETHER, n) ``scattered`` about it, no
    two of which move alike."""

    name: str
    system: System
    pair: Pair
    props: Propagators
    states: Array
    crossings: float
    scattered: Array


POINTS = (
    ("article", 1.05, 1.0),  # no impact
    ("article", 0.95, 1.0),  # 1-1
    ("article", 0.78, 0.38),  # both sides
    ("article", 0.78, 0.45),
    ("article", 0.78, 0.60),
    ("article", 0.78, 0.25),  # aperiodic
    ("kahraman-singh", 0.90, 1.0),  # one degree of freedom
)
FEW = (0, 1, 6)  # of a quick run


def family(case: str) -> Family:
    """Of a bundled case."""
    return load(case).family()[0]


def works(quick: bool) -> list[Work]:
    """All pieces of work, settled."""
    return [_work(*POINTS[i]) for i in (FEW if quick else range(len(POINTS)))]


def _work(case: str, omega: float, D: float) -> Work:
    pairs, values = family(case), {"omega": omega, "D": D}
    system = pairs.system(values)
    props = flow.propagators(system)
    run = flow.march(props, pairs.start(values), SETTLING)
    name = f"{case} ω = {omega:g}, D = {D:g} ({attractor(props, run.states[-1]).label})"
    crossings = float(run.contacts[-COUNTED:].sum()) / COUNTED
    states = run.states[-KEPT:].copy()
    return Work(name, system, Pair.of(system), props, states, crossings, _scattered(props, states, crossings))


def _scattered(props: Propagators, states: Array, crossings: float) -> Array:
    """Where the attractor has no impacts, so near to it that they have none either."""
    offsets = np.random.default_rng(SEED).uniform(-SPREAD, SPREAD, (TOGETHER, states.shape[1]))
    while True:
        starts = states[-TOGETHER:] + offsets
        if crossings or not flow.march_many(props, starts, 1, MANY_PERIODS).contacts.any():
            return starts
        offsets /= 2.0
