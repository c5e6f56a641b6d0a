"""Series of points against Fourier integrals, known waves and the mesh cycle."""

from __future__ import annotations

from math import cos, pi, sin, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gearlash.gears.mesh_cycle import MeshCycle
from gearlash.gears.pair_shape import PairShape
from gearlash.gears.waveform import loaded_error, rectangle, unloaded_error_of, waveform
from gearlash.system import GearlashError, evaluate

points = st.integers(2, 12).flatmap(
    lambda n: st.tuples(
        st.lists(st.floats(0.0, 0.999), min_size=n, max_size=n).map(sorted),
        st.lists(st.floats(-1.0, 1.0), min_size=n, max_size=n),
    )
)


@settings(max_examples=25)
@given(points)
def test_series_against_a_fine_sum(given_points):
    phases, values = given_points
    found = waveform(phases, values, 4)
    fine = (np.arange(40000) + 0.5) / 40000
    psi, v = np.append(phases, phases[0] + 1.0), np.append(values, values[0])
    curve = np.interp(np.where(fine < phases[0], fine + 1.0, fine), psi, v)
    assert found.series[0] == pytest.approx(curve.mean(), abs=2e-4)
    for order in (1, 2, 3, 4):
        angle = 2 * pi * order * fine
        assert found.series[2 * order - 1] == pytest.approx(2 * np.mean(curve * np.cos(angle)), abs=4e-4)
        assert found.series[2 * order] == pytest.approx(2 * np.mean(curve * np.sin(angle)), abs=4e-4)
    rest = curve - evaluate(found.series, 2 * pi * fine)
    assert found.rms_error == pytest.approx(sqrt(np.mean(rest**2)), abs=1e-2)


def test_a_rectangle_of_contact_ratio_1_6():
    found = rectangle(1.0, 2.0, 1.6, 8)
    assert found.series[0] == pytest.approx(1.6)
    for n in range(1, 9):
        # ∫ over the high part: 2/(2πn) (sin 2πn 0.6, 1 − cos 2πn 0.6).
        assert found.series[2 * n - 1] == pytest.approx(sin(2 * pi * n * 0.6) / (pi * n), abs=1e-15)
        assert found.series[2 * n] == pytest.approx((1 - cos(2 * pi * n * 0.6)) / (pi * n), abs=1e-15)
    rms = [rectangle(1.0, 2.0, 1.6, n).rms_error for n in (0, 8, 32, 128)]
    assert rms[0] == pytest.approx(sqrt(0.24))
    assert rms[1] / rms[3] == pytest.approx(4.0, rel=0.1)  # as 1/√count


def test_a_rectangle_is_the_cycle_of_equal_pairs():
    cycle = MeshCycle(1.6, 0.0, PairShape.CONSTANT)
    found = rectangle(1.0, 2.0, 1.6, 3)
    assert found.amplitudes / found.series[0] == pytest.approx(np.abs(cycle.harmonics(3)), rel=1e-12)


def test_points_of_a_cosine_give_a_cosine():
    psi = np.arange(256) / 256
    found = waveform(psi, 3.0 + 0.5 * np.cos(2 * pi * 2 * psi + 0.7), 4)
    assert found.amplitudes == pytest.approx([0.0, 0.5, 0.0, 0.0], abs=3e-4)
    assert found.angles[1] == pytest.approx(0.7, abs=1e-12)
    assert found.reconstructed() == pytest.approx(found.values, abs=4e-4)


def test_a_cycle_may_start_anywhere_and_end_at_one():
    shifted = waveform([0.25, 0.75], [1.0, -1.0], 1)
    assert shifted.series == pytest.approx([0.0, 0.0, 8 / pi**2], abs=1e-15)
    closed = waveform([0.0, 0.5, 1.0], [1.0, -1.0, 1.0], 1)
    assert closed.series == pytest.approx([0.0, 8 / pi**2, 0.0], abs=1e-15)


def test_a_loaded_error_has_the_stiffness_in_it():
    psi = np.linspace(0, 1, 50, endpoint=False)
    stiffness = 3e8 * (1 + 0.2 * np.cos(2 * pi * psi))
    unloaded = 1e-6 * np.sin(2 * pi * psi)
    loaded = loaded_error(unloaded, stiffness, 5e3)
    assert unloaded_error_of(loaded, stiffness, 5e3) == pytest.approx(unloaded, abs=1e-18)
    assert np.ptp(loaded) > np.ptp(5e3 / stiffness) * 0.9
    assert loaded_error(0.0, stiffness, 0.0) == pytest.approx(0.0)


@pytest.mark.parametrize(
    ("phases", "values", "says"),
    [
        ([0.5], [1.0], "two points"),
        ([0.0, 0.5], [1.0], "two points"),
        ([0.5, 0.2], [1.0, 2.0], "never back"),
        ([-0.1, 0.2], [1.0, 2.0], "never back"),
        ([0.1, 1.2], [1.0, 2.0], "never back"),
        ([0.1, 0.2], [1.0, float("nan")], "finite"),
    ],
)
def test_points_that_are_no_cycle_are_refused(phases, values, says):
    with pytest.raises(GearlashError, match=says):
        waveform(phases, values, 2)


def test_a_rectangle_needs_a_pair_in_contact():
    with pytest.raises(GearlashError, match="ε_α"):
        rectangle(1.0, 2.0, 0.9, 2)
