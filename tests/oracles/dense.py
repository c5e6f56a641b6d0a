"""Random systems of the class that are no gears: everything is coupled to everything.

Dense matrix, forcing in every state (so that the gap's velocity is forced as well), dense h and g with
h·g = 0, an offset, unequal sides with their own stiffness series, a base period of one to three mesh cycles.
"""

from __future__ import annotations

import numpy as np

from gearlash.system import Clearance, System

from .heyoka_oracle import gap


def random_dense(rng: np.random.Generator, size: int, harmonics: int = 3) -> tuple[System, np.ndarray]:
    """A random system of ``size`` states and a start with X of the order of the gap."""
    matrix = rng.normal(0.0, 0.7, (size, size)) / np.sqrt(size) - 0.5 * np.eye(size)
    h, g = rng.normal(size=size), rng.normal(size=size)
    g -= h * (h @ g) / (h @ h)
    g -= h * (h @ g) / (h @ h)  # once more, for the rounding of the first
    g *= -np.sign((h @ matrix) @ g) * 1.5 / max(1e-3, np.linalg.norm(g))  # so that the contact pushes back
    clearance = Clearance(
        h=h,
        g=g,
        gap_plus=float(rng.uniform(0.05, 1.0)),
        gap_minus=float(rng.uniform(-0.04, 1.0)),
        stiffness_plus=_series(rng, 1.0, 0.2, harmonics),
        stiffness_minus=_series(rng, 3.0, 0.2, harmonics),
        damping=float(rng.uniform(0.0, 0.2)),
        offset=_series(rng, 0.1, 0.1, harmonics),
    )
    forcing = np.array([_series(rng, 0.1, 0.2, harmonics) for _ in range(size)])
    cycles = int(rng.integers(1, 4))
    system = System(float(rng.uniform(0.4, 2.0)), matrix, forcing, (clearance,), cycles)
    state = rng.normal(0.0, 0.5, size)
    state += h * (float(rng.uniform(-1.5, 1.5)) - float(gap(system, state, 0.0))) / (h @ h)
    return system, state


def _series(rng: np.random.Generator, mean: float, size: float, harmonics: int) -> np.ndarray:
    return np.concatenate([[mean], rng.normal(0.0, size, 2 * harmonics)])
