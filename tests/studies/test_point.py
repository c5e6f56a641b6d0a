"""What a point keeps of an attractor, against closed forms and against the attractor itself."""

from __future__ import annotations

import math

import numpy as np
import pytest

from gearlash import case, flow, orbits, studies
from gearlash.system import Family, GearlashError, Parameter, Status

ARTICLE = case.load("article-first-harmonic").family()[0]
CLASSICAL = case.load("kahraman-singh").family()[0]


def response(omega: float) -> tuple[float, float, float]:
    """Of x'' + 0.1 x' + x = 0.1 + 0.05 ω² cos(ωτ − π/2), the bundled pair in contact: mean of x, its
    amplitude, and the amplitude of x + 0.1 x'.
    """
    amplitude = 0.05 * omega**2 / math.hypot(1.0 - omega**2, 0.1 * omega)
    return 0.1, amplitude, amplitude * math.hypot(1.0, 0.1 * omega)


def test_impact_free_point_is_the_linear_response():
    found = studies.point(CLASSICAL, {"omega": 0.6}, name="omega")
    mean, amplitude, force = response(0.6)
    assert (found.value, found.status, found.label) == (0.6, "ok", "1-0-0")
    assert found.impact_free
    assert found.drive_side_only
    assert found.maximum == pytest.approx(1.0 + mean + amplitude, abs=1e-11)  # the gap coordinate: D + x
    assert found.minimum == pytest.approx(1.0 + mean - amplitude, abs=1e-11)
    assert found.force_max == pytest.approx(mean + force, abs=1e-8 * force)
    assert found.force_min == pytest.approx(mean - force, abs=1e-8 * force)
    assert found.force_rms == pytest.approx(math.sqrt(mean**2 + force**2 / 2.0), rel=1e-11)
    assert found.share_without_contact == 0.0
    assert abs(found.leading) == pytest.approx(math.exp(-0.05 * 2.0 * math.pi / 0.6), rel=1e-9)
    assert found.largest_exponent == pytest.approx(-0.05, rel=1e-9)


@pytest.mark.parametrize(("omega", "gap"), [(0.83, 1.0), (0.78, 0.385), (0.78, 0.4)])
def test_point_agrees_with_its_attractor(omega, gap):
    values = {"omega": omega, "D": gap}
    found = studies.point(ARTICLE, values, name="D")
    attractor = orbits.attractor(ARTICLE.system(values), ARTICLE.start(values))
    sections, whole = orbits.sections(attractor), orbits.motion_statistics(attractor)
    assert found.label == attractor.label
    assert found.value == gap
    np.testing.assert_array_equal(found.strobes, sections.time.displacement)
    np.testing.assert_array_equal(found.drive_force, sections.drive.entering.force)
    np.testing.assert_array_equal(found.back_force, sections.back.entering.force)
    np.testing.assert_array_equal(found.back_release_force, sections.back.leaving.force)
    np.testing.assert_array_equal(found.back_phase, sections.back.entering.phase)
    assert (len(found.strobes), len(found.drive_force), len(found.back_force)) == (
        found.period,
        found.drive,
        found.back,
    )
    assert (found.drive_force > 0).all()  # Φ = ζ X', and X rises through +D
    assert (found.back_force < 0).all()
    assert found.force_rms == pytest.approx(whole.force.rms, rel=1e-12)
    assert found.force_max == pytest.approx(whole.force.maximum, rel=1e-7)
    assert found.share_without_contact == pytest.approx(whole.share_without_contact, abs=1e-14)
    assert (found.minimum, found.maximum) == pytest.approx((whole.minimum, whole.maximum), abs=1e-13)


def test_largest_force_of_a_dense_sample():
    values = {"omega": 0.78, "D": 0.385}
    found = studies.point(ARTICLE, values)
    trace = flow.trace(flow.propagators(ARTICLE.system(values)), found.state, float(found.period))
    dense = trace.samples(60_001).force
    span = dense.max() - dense.min()
    assert found.force_max == pytest.approx(dense.max(), abs=1e-7 * span)
    assert found.force_min == pytest.approx(dense.min(), abs=1e-7 * span)


def test_aperiodic_point_keeps_a_stretch_and_no_period():
    found = studies.point(ARTICLE, {"omega": 1.17}, name="omega")
    assert found.label == "aperiodic"
    assert (found.period, found.drive, found.back) == (0, 0, 0)
    assert found.largest_exponent > found.exponent_error > 0
    assert len(found.strobes) == orbits.results.SAMPLE
    assert len(found.drive_force) > 100
    assert not found.periodic
    assert not found.impact_free
    assert not found.drive_side_only
    assert math.isnan(found.leading.real)


def test_a_value_out_of_range_is_flagged_with_its_reason():
    found = studies.point(CLASSICAL, {"D": -1.0}, name="D")
    assert (found.status, found.label, found.value) == (Status.FAILED, None, -1.0)
    assert "D" in found.message
    assert not found.computed


def test_a_motion_that_runs_away_has_a_status_and_no_sections():
    def build(values):
        system = CLASSICAL.build({**CLASSICAL.defaults, **values})
        matrix = system.matrix.copy()
        matrix[1, 1] = 2.0  # damping of the wrong sign
        return type(system)(system.omega, matrix, system.forcing, system.clearances)

    family = Family((Parameter("omega", 0.6),), ("X", "X'"), build, lambda values: np.array([1.1, 0.0]))
    found = studies.point(family, {"omega": 0.6}, name="omega")
    assert found.status == "diverged"
    assert len(found.strobes) == 0
    assert math.isnan(found.force_max)
    assert not found.periodic


@pytest.mark.parametrize("error", [ZeroDivisionError("no teeth"), KeyError("teeth"), RuntimeError()])
def test_what_a_family_raises_fails_the_point_with_its_reason(error: Exception):
    def build(values):
        raise error

    family = Family((Parameter("omega", 0.6),), ("X",), build, lambda values: np.zeros(1))
    found = studies.point(family)
    assert found.status == Status.FAILED
    assert found.message == f"build failed at omega = 0.6: {type(error).__name__}: {error}".removesuffix(": ")
    with pytest.raises(GearlashError) as raised:
        family.system()
    assert raised.value.__cause__ is error


def test_ctrl_c_while_a_family_builds_goes_through():
    def build(values):
        raise KeyboardInterrupt

    family = Family((Parameter("omega", 0.6),), ("X",), build, lambda values: np.zeros(1))
    with pytest.raises(KeyboardInterrupt):
        studies.point(family)


def test_a_refusal_to_build_is_flagged():
    def build(values):
        raise GearlashError("no teeth")

    family = Family((Parameter("omega", 0.6),), ("X",), build, lambda values: np.zeros(1))
    assert studies.point(family).message == "no teeth"
