"""Random members of the whole class: several clearances, rules mixed, any number of states, no gears.

Masses on springs and dampers to ground and to each other, so that most are stable; first-order states that
positions drive and that push back; clearances between any combination of positions. A third of them is then
written in other coordinates, which couples everything to everything.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gearlash.system import Clearance, ContactRule, System

from .clearances import gap

RULES = (ContactRule.ALWAYS, ContactRule.IN_CONTACT, ContactRule.NO_TENSION)


def random_member(
    rng: np.random.Generator,
    size: int,
    clearances: int,
    rules: tuple[ContactRule, ...] = RULES,
    harmonics: int = 3,
    turned: bool | None = None,
) -> tuple[System, np.ndarray]:
    """A system of ``size`` states with that many clearances, and a start that has every X near its gap.

    With one state only, no force can act (h·g = 0): its clearances are watched and do nothing.
    """
    masses, matrix = _chain(rng, size)
    found = tuple(_clearance(rng, masses, size, f"c{j}", rules, harmonics) for j in range(clearances))
    forcing = np.array([series(rng, 0.05, 0.15, harmonics) for _ in range(size)])
    system = System(float(rng.uniform(0.4, 2.0)), matrix, forcing, found, int(rng.integers(1, 4)))
    if size > 1 and (rng.uniform() < 1 / 3 if turned is None else turned):
        system = in_other_coordinates(system, np.linalg.qr(rng.normal(size=(size, size)))[0])
    return system, random_start(rng, system)


def random_start(rng: np.random.Generator, system: System, phase: float = 0.0) -> np.ndarray:
    """Every X in any of its three regions, at ``phase``; as near to that as independent gaps allow."""
    state = rng.normal(0.0, 0.4, system.size)
    target = [rng.uniform(-c.gap_minus - 0.4, c.gap_plus + 0.4) for c in system.clearances]
    here = [float(gap(system, c, state, phase)) for c in system.clearances]
    read = np.array([c.h for c in system.clearances])
    return state + np.linalg.pinv(read) @ np.subtract(target, here)


def series(rng: np.random.Generator, mean: float, size: float, harmonics: int) -> np.ndarray:
    return np.concatenate([[mean], rng.normal(0.0, size, 2 * harmonics) / np.sqrt(2 * harmonics)])


def in_other_coordinates(system: System, turn: np.ndarray) -> System:
    """The same motion of ``turn`` z, an orthogonal change of coordinates."""
    moved = tuple(replace(c, h=turn @ c.h, g=turn @ c.g) for c in system.clearances)
    return replace(
        system, matrix=turn @ system.matrix @ turn.T, forcing=turn @ system.forcing, clearances=moved
    )


def _chain(rng: np.random.Generator, size: int) -> tuple[np.ndarray, np.ndarray]:
    """(masses, matrix). States: first-order ones, then position and velocity of every mass."""
    first = size % 2 if size < 5 else size % 2 + 2 * int(rng.integers(2))
    count = (size - first) // 2
    masses, matrix = rng.uniform(0.5, 2.0, count), np.zeros((size, size))
    places = first + 2 * np.arange(count)
    matrix[:first, :first] = -np.diag(rng.uniform(0.3, 1.0, first))
    for i, place in enumerate(places):
        matrix[place, place + 1] = 1.0
        for other in places[: i + 1]:
            k, c = rng.uniform(0.0, 0.6), rng.uniform(0.0, 0.1)
            pull = np.zeros(size)
            pull[place] = 1.0
            if other != place:
                pull[other] = -1.0
            for end in {place, other}:
                share = -pull[end] / masses[(end - first) // 2]
                matrix[end + 1] += share * k * pull
                matrix[end + 1] += share * c * np.roll(pull, 1)
    for row in range(first):
        if count:
            matrix[row, rng.choice(places)] = rng.normal(0.0, 0.3)
            matrix[rng.choice(places) + 1, row] = rng.normal(0.0, 0.3)
    return masses, matrix


def _clearance(rng, masses, size: int, name: str, rules, harmonics: int) -> Clearance:
    """Reads a combination of positions (and a little of first-order states); pushes on the masses."""
    first = size - 2 * len(masses)
    h, g = np.zeros(size), np.zeros(size)
    h[first::2] = rng.normal(0.0, 1.0, len(masses)) * (rng.uniform(size=len(masses)) < 0.7)
    h[:first] = rng.normal(0.0, 0.3 if len(masses) else 1.0, first)
    if len(masses) and not h[first::2].any():
        h[first] = 1.0
    g[first + 1 :: 2] = -h[first::2] / masses
    rule = rules[int(rng.integers(len(rules)))]
    plus, minus = series(rng, rng.uniform(0.5, 3.0), 0.3, harmonics), series(rng, 1.0, 0.2, harmonics)
    side = rng.uniform()
    if side < 0.1:
        minus = 0.0 * minus
    elif side < 0.2:
        plus = 0.0 * plus
    return Clearance(
        h=h,
        g=g,
        gap_plus=float(rng.uniform(0.05, 0.8)),
        gap_minus=float(rng.uniform(-0.04, 0.8)),
        stiffness_plus=plus,
        stiffness_minus=minus,
        damping=float(rng.choice([0.0, rng.uniform(0.02, 0.5)], p=[0.1, 0.9])),
        damping_minus=None if rule is ContactRule.ALWAYS else float(rng.uniform(0.02, 0.5)),
        offset=series(rng, 0.05, 0.1, harmonics),
        contact=rule,
        name=name,
    )
