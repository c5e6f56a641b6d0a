"""Chaos over 1e5 periods: what has to hold exactly does not drift."""

from __future__ import annotations

import numpy as np
import pytest

from gearlash.orbits import lyapunov
from orbits.members import article, built
from orbits.test_aperiodic import divergence


@pytest.mark.slow
@pytest.mark.parametrize(("omega", "D"), [(0.78, 0.3), (0.6, 1.0)])
def test_trace_identity_over_1e5_periods(omega, D):
    """The sum of the ten exponents is the divergence of the field, over 100,000 periods as over one."""
    family = article()
    props = built(family, omega=omega, D=D)
    spectrum = lyapunov(props, family.start({"omega": omega, "D": D}), 100_000)
    expected = divergence(props.system)
    assert spectrum.periods == 100_000
    assert spectrum.values[0] > spectrum.errors[0] > 0.0
    assert abs(spectrum.values.sum() - expected) <= 1e-10 * abs(expected)
    assert np.isfinite(spectrum.final_state).all()
