"""Small systems whose motions can be worked out by hand, and systems put side by side."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gearlash.system import Clearance, ContactRule, System


def oscillator(
    *,
    omega: float = 1.0,
    gap: tuple[float, float] = (0.5, 0.5),
    stiffness: tuple = (1.0, 1.0),
    damping: float = 0.0,
    damping_minus: float | None = None,
    rule: ContactRule = ContactRule.ALWAYS,
    force: tuple[float, ...] = (0.0,),
    ground: tuple[float, float] = (0.0, 0.0),
    cycles: int = 1,
) -> System:
    """X″ + c X′ + k X = force(θ) − Φ with ``ground`` = (k, c); stiffness: a constant or a series per side."""
    plus, minus = (np.atleast_1d(np.asarray(s, dtype=float)) for s in stiffness)
    clearance = Clearance(
        h=np.array([1.0, 0.0]),
        g=np.array([0.0, -1.0]),
        gap_plus=gap[0],
        gap_minus=gap[1],
        stiffness_plus=plus,
        stiffness_minus=minus,
        damping=damping,
        damping_minus=damping_minus,
        contact=rule,
    )
    forcing = np.zeros((2, len(force)))
    forcing[1] = force
    return System(omega, np.array([[0.0, 1.0], [-ground[0], -ground[1]]]), forcing, (clearance,), cycles)


def side_by_side(*systems: System) -> System:
    """One system that holds them all, uncoupled; they share frequency and base period."""
    sizes = [s.size for s in systems]
    starts = np.cumsum([0, *sizes[:-1]])
    matrix = np.zeros((sum(sizes), sum(sizes)))
    width = max(s.forcing.shape[1] for s in systems)
    forcing, clearances = np.zeros((sum(sizes), width)), []
    for k, (system, start) in enumerate(zip(systems, starts, strict=True)):
        if (system.omega, system.cycles) != (systems[0].omega, systems[0].cycles):
            raise ValueError("frequency or base period differs")
        own = slice(start, start + system.size)
        matrix[own, own] = system.matrix
        forcing[own, : system.forcing.shape[1]] = system.forcing
        for c in system.clearances:
            h, g = np.zeros(sum(sizes)), np.zeros(sum(sizes))
            h[own], g[own] = c.h, c.g
            clearances.append(replace(c, h=h, g=g, name=f"{c.name} {k}"))
    return System(systems[0].omega, matrix, forcing, tuple(clearances), systems[0].cycles)
