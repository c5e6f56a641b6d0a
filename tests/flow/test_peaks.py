"""Peaks on an edge of a cell, where the Bernstein coefficient that decides is a value of X itself."""

from __future__ import annotations

from fractions import Fraction

import numpy as np

from gearlash import flow
from gearlash.system import ContactRule, Status
from oracles.oscillators import oscillator

DEPTHS = (0.0, 1e-16, -1e-16, 3e-16, -3e-16, 1e-13, -1e-13)


def test_a_peak_on_the_edge_of_a_cell_is_told_rightly_or_not_at_all():
    """X″ = −a: the peak is known exactly, and no Taylor term above the second hides rounding."""
    rng = np.random.default_rng(3)
    decided, undecided = 0, 0
    for acceleration in rng.uniform(0.2, 2.0, 60).tolist():
        system = oscillator(
            gap=(0.5, 9.0), stiffness=(2.0, 2.0), rule=ContactRule.IN_CONTACT, force=(-acceleration,)
        )
        props = flow.propagators(system)
        h = props.cell_duration
        for lift in DEPTHS:
            start = np.array([0.5 - acceleration * h * h / 2.0 + lift, acceleration * h])
            peak = Fraction(start[0]) + Fraction(start[1]) ** 2 / (2 * Fraction(acceleration))
            carried = flow.carry(props, start, 2.0 / props.cells)
            if carried.status is Status.UNCERTAIN:
                undecided += 1
                assert abs(float(peak - Fraction(0.5))) < 1e-14
                continue
            assert carried.status is Status.OK
            assert carried.contacts.sum() == (2 if peak > Fraction(0.5) else 0)
            decided += 1
    assert decided > 100
    assert undecided > 100
