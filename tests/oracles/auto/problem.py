"""A family as AUTO-07p takes it: the numbers of a system for `smoothed.f90`, and an orbit to start with."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np

from gearlash.orbits import Orbit
from gearlash.system import Clearance, ContactRule, Family, System
from oracles.region_oracle import run

SAMPLES = 500  # of the orbit, a base period


def write(folder: Path, family: Family, orbit: Orbit, values: Mapping[str, float], width: float) -> None:
    """``system.dat`` and ``start.dat`` for the parameter ω."""
    complete, system = family.complete(values), orbit.propagators.system
    assert system.cycles == 1
    assert not any(c.offset.any() for c in system.clearances)
    (folder / "system.dat").write_text("\n".join(_numbers(family, complete, system, width)) + "\n")
    np.savetxt(folder / "start.dat", _samples(system, orbit), fmt="%.17e")


def _numbers(family: Family, values: Mapping[str, float], system: System, width: float) -> list[str]:
    omega, orders = values["omega"], _orders(system)
    twice = family.system({**values, "omega": 2.0 * omega})
    squared = (twice.forcing - system.forcing) / (3.0 * omega**2)  # forcing = fixed + ω² squared
    fixed = system.forcing - omega**2 * squared
    half = family.system({**values, "omega": 0.5 * omega})
    assert np.allclose(half.forcing, fixed + 0.25 * omega**2 * squared, atol=1e-13)
    assert np.array_equal(half.matrix, system.matrix)
    lines = [f"{system.size} {orders} {len(system.clearances)}", _row([omega, 0.0, width])]
    for matrix in (system.matrix, _padded(fixed, orders), _padded(squared, orders)):
        lines += [_row(row) for row in matrix]
    for clearance in system.clearances:
        lines += _of_clearance(clearance, orders)
    return lines


def _of_clearance(c: Clearance, orders: int) -> list[str]:
    assert c.contact is not ContactRule.NO_TENSION
    assert c.damping_minus is None
    rows = [c.h, c.g, _padded(c.stiffness_plus, orders), _padded(c.stiffness_minus, orders)]
    edges, moved = [c.gap_plus, c.gap_minus], [0.0, 0.0]
    return [*map(_row, [*rows, edges, moved]), f"{c.damping!r} {int(c.contact is ContactRule.ALWAYS)}"]


def _orders(system: System) -> int:
    series = [c.stiffness_plus for c in system.clearances] + [c.stiffness_minus for c in system.clearances]
    return (max(system.forcing.shape[1], *(len(each) for each in series)) - 1) // 2


def _padded(series: np.ndarray, orders: int) -> np.ndarray:
    missing = 2 * orders + 1 - series.shape[-1]
    return np.concatenate([series, np.zeros((*series.shape[:-1], missing))], axis=-1)


def _row(numbers: Iterable[float]) -> str:
    return " ".join(repr(float(number)) for number in numbers)


@cache
def _samples(system: System, orbit: Orbit) -> np.ndarray:
    """Rows of time, state, cos θ and sin θ along the orbit, by the independent integrator."""
    phases = np.linspace(0.0, float(orbit.shot.period), SAMPLES * orbit.shot.period + 1)
    states, here = [np.asarray(orbit.state)], np.asarray(orbit.state, dtype=np.longdouble)
    for before, phase in pairwise(phases):
        here = run(system, here, phase - before, before).state
        states.append(here.astype(float))
    angle = 2.0 * np.pi * phases
    return np.column_stack([angle / system.omega, np.array(states), np.cos(angle), np.sin(angle)])
