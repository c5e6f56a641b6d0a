"""Which way the speed went when it was measured, and what of it is a jump."""

from __future__ import annotations

import numpy as np

import gearlash as gl
from gearlash.studies.measured_jumps import directions_of, jumps_of

UP = np.linspace(0.70, 0.90, 11)
BOTH = np.concatenate([UP, UP[-2::-1]])


def test_rows_know_which_way_the_speed_went():
    assert directions_of(BOTH) == ("up",) * 11 + ("down",) * 10
    assert directions_of(UP[::-1]) == ("down",) * 11
    assert set(directions_of(UP[[0, 4, 2, 8, 1, 9, 3]])) == {""}


def test_residuals_are_to_the_motion_of_the_same_way():
    """A measurement whose hysteresis lies the wrong way round fits the nearer motion everywhere."""
    case = gl.load_case("kahraman-singh")
    made = gl.compare(case, gl.measurement(case, UP, np.ones(11), "mesh_force"), "rms")
    width = float(np.max(np.abs(made.up - made.down)))
    assert width > 0.01
    right = np.concatenate([made.up, made.down[-2::-1]])
    swapped = np.concatenate([made.down, made.up[-2::-1]])
    for values, largest in ((right, 0.0), (swapped, width)):
        found = gl.compare(case, gl.measurement(case, BOTH, values, "mesh_force"), "rms")
        assert np.isclose(np.abs(found.residuals).max(), largest, atol=1e-12)
        assert np.abs(found.nearer_residuals).max() < 1e-12


def test_a_flank_that_climbs_in_several_steps_is_no_jump():
    case = gl.load_case("kahraman-singh")
    flank = np.array([1.0, 1.0, 1.01, 1.02, 1.4, 1.8, 2.2, 2.22, 2.23, 2.23, 2.24])
    jump = np.array([1.0, 1.0, 1.01, 1.02, 1.05, 1.9, 2.0, 2.02, 2.03, 2.03, 2.04])
    for values, count in ((flank, 0), (jump, 1)):
        assert len(jumps_of(gl.measurement(case, UP, values, "mesh_force"), [])) == count


def test_a_peak_of_a_resonance_is_no_jump_nor_is_a_row_that_stands_out():
    """On a resonance that few rows lie on both flanks are steep; a jump stays up, or falls more slowly."""
    case = gl.load_case("kahraman-singh")
    resonance = np.array([1.0, 1.0, 1.01, 1.1, 1.4, 2.2, 1.4, 1.1, 1.01, 1.0, 1.0])
    outlier = np.array([1.0, 1.0, 1.01, 1.02, 1.05, 1.9, 1.06, 1.02, 1.03, 1.03, 1.04])
    jump = np.array([1.0, 1.0, 1.01, 1.02, 1.05, 1.9, 1.7, 1.6, 1.5, 1.45, 1.4])
    for values, count in ((resonance, 0), (outlier, 0), (jump, 1)):
        assert len(jumps_of(gl.measurement(case, UP, values, "mesh_force"), [])) == count


def test_a_curve_that_climbs_over_missing_rows_is_no_jump():
    """The same flank, with seven rows left out of it; a jump there is one all the same."""
    case, omega = gl.load_case("kahraman-singh"), np.linspace(0.70, 0.90, 41)
    rows = np.r_[0:17, 24:41]
    flank = 1.0 + (omega - 0.70)
    for values, count in ((flank, 0), (flank + (omega > 0.80), 1)):
        jumps = jumps_of(gl.measurement(case, omega[rows], values[rows], "mesh_force"), [])
        assert len(jumps) == count
        assert all(jump.lower < 0.80 < jump.upper for jump in jumps)
