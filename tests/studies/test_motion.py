"""Motions as plain arrays agree with the orbits they are samples of."""

from __future__ import annotations

import numpy as np
import pytest

from plots.made import aperiodic, around_grazing, moving, orbit


@pytest.mark.parametrize(("omega", "gap"), [(1.05, 1.0), (0.95, 1.0), (0.78, 0.386)])
def test_a_motion_is_one_closed_period_with_every_contact(omega: float, gap: float) -> None:
    found, sampled = orbit(omega, gap), moving(omega, gap)
    assert sampled.cycles == found.period == sampled.period
    for values in (sampled.displacement, sampled.velocity, sampled.force):
        assert values[0] == pytest.approx(values[-1], abs=1e-9)
    engaging = sampled.hit_engaging
    assert (engaging & (sampled.hit_boundary > 0)).sum() == found.signature.drive
    assert (engaging & (sampled.hit_boundary < 0)).sum() == found.signature.back
    assert np.abs(np.abs(sampled.hit_displacement) - gap).max(initial=0.0) < 1e-13
    assert len(sampled.strobe_displacement) == found.period


def test_regions_agree_with_the_displacement() -> None:
    sampled = moving(0.78, 0.386)
    away = np.abs(np.abs(sampled.displacement) - 0.386) > 1e-9
    expected = np.where(sampled.displacement > 0.386, 0, np.where(sampled.displacement < -0.386, 2, 1))
    assert (sampled.region[away] == expected[away]).all()
    assert set(expected) == {0, 1, 2}


def test_extrema_are_among_the_samples() -> None:
    found, sampled = orbit(1.05, 1.0), moving(1.05, 1.0)
    assert sampled.displacement.min() == pytest.approx(found.extrema.displacement.min(), abs=1e-14)


def test_a_grazing_touches_and_does_not_cross() -> None:
    _, at, _ = around_grazing()
    assert at.touch is not None
    assert at.touch.displacement == pytest.approx(at.gap_plus, abs=1e-11)
    assert at.touch.velocity == pytest.approx(0.0, abs=1e-9)
    assert len(at.hit_phase) == 0
    assert at.displacement.min() == pytest.approx(at.gap_plus, abs=1e-11)


def test_a_motion_without_period_says_so() -> None:
    assert not aperiodic().periodic
    assert np.isnan(aperiodic().leading)
    assert aperiodic().largest_exponent > aperiodic().exponent_error > 0.0
