"""Motions that nothing attracts are an answer of their own."""

from __future__ import annotations

import numpy as np
import pytest

import gearlash as gl
from gearlash.system import MotionKind, Status
from oracles.oscillators import oscillator

FAR = (1e6, 1e6)  # a gap that is never crossed


def _family(case: str, **values: float) -> tuple[gl.System, np.ndarray]:
    family, _ = gl.load_case(case).family()
    return family.system(values), family.start(values)


NEUTRAL = {
    "between two frequencies": (
        oscillator(omega=0.7, gap=FAR, ground=(1.0, 0.0), force=(0.0, 1.0, 0.0)), [0.0, 0.0],
    ),
    "no ratio of frequencies": (
        oscillator(omega=np.sqrt(2.0), gap=FAR, ground=(1.0, 0.0), force=(0.0, 1.0, 0.0)), [0.3, 0.0],
    ),
    "on the forced response": (
        oscillator(omega=2.0, gap=FAR, ground=(1.0, 0.0), force=(0.0, 1.0, 0.0)), [-1.0 / 3.0, 0.0],
    ),
    "at rest in the gap": (oscillator(damping=0.1), [0.3, 0.0]),
    "shaken in the gap": (oscillator(damping=0.1, force=(0.0, 0.1, 0.0)), [0.3, 0.0]),
    "to and fro in the gap": (oscillator(gap=(1.0, 1.0)), [0.3, 0.5]),
    "regular impacts": (
        oscillator(omega=1.3, ground=(1.0, 0.0), stiffness=(3.0, 3.0), force=(0.0, 0.1, 0.0)), [0.6, 0.0],
    ),
    "a pair without load": _family("article", load=0.0),
    "a spur pair without load": _family("kahraman-singh", load=0.0),
}  # fmt: skip


@pytest.mark.parametrize("name", NEUTRAL)
def test_neutral_is_an_answer_of_its_own(name):
    system, start = NEUTRAL[name]
    found = gl.attractor(system, start)
    assert isinstance(found, gl.Neutral)
    assert (found.label, found.status) == ("neutral", Status.NEUTRAL)
    assert "periods (--periods)" not in found.message
    assert "continuum" in found.message
    assert "damping" in found.status.advice
    assert not found.certificate.certified
    assert abs(found.largest_exponent) <= 2.0 * found.exponent_error + 1e-3
    assert found.exponent_error > 1e-16


@pytest.mark.parametrize(
    ("system", "start", "step"),
    [
        # x = (τ/2) sin τ: x' grows by π in a period
        (oscillator(omega=1.0, gap=FAR, ground=(1.0, 0.0), force=(0.0, 1.0, 0.0)), [0.0, 0.0], np.pi),
        (oscillator(omega=1.0, gap=FAR), [0.3, 0.01], 0.02 * np.pi),
    ],
    ids=["resonance", "drift"],
)
def test_what_moves_on_for_ever_says_by_how_much(system, start, step):
    found = gl.attractor(system, start)
    assert isinstance(found, gl.Neutral)
    assert f"moved on by the same step, {step:.1e}, in one base period" in found.message


def test_a_drift_that_will_be_stopped_is_waited_for():
    """The gap's far side is 0.7 away: the answer comes after it was met."""
    system = oscillator(gap=(1.0, 1.0), damping=0.1, rule=gl.ContactRule.IN_CONTACT)
    found = gl.attractor(system, [0.3, 0.01])
    assert isinstance(found, gl.Neutral)
    assert found.periods_used > 100 / (2.0 * np.pi)  # 0.7 at 0.01 per unit of time
    assert "will" not in found.message


@pytest.mark.parametrize("damping", [1e-3, 1e-2, 0.1])
def test_a_little_damping_is_no_neutral_motion(damping):
    found = gl.attractor(
        oscillator(omega=0.7, gap=FAR, ground=(1.0, damping), force=(0.0, 1.0, 0.0)), [0.0, 0.0]
    )
    assert isinstance(found, gl.Orbit)
    assert found.largest_exponent == pytest.approx(-damping / 2.0, rel=1e-9)


def test_chaos_without_damping_stays_aperiodic():
    system, start = _family("article", mesh_damping=0.0, bearing_damping=0.0)
    found = gl.attractor(system, start)
    assert found.label == "aperiodic"
    assert found.largest_exponent > found.exponent_error > 0.0


def test_sweeps_and_maps_carry_neutral_points():
    family, _ = gl.load_case("kahraman-singh").family()
    axis = gl.Axis.even("load", 0.0, 0.1, 2)
    sweep = gl.sweep(family, axis)
    assert sweep.points[0].label == "neutral"
    assert sweep.points[0].status == "neutral"
    plane = gl.map_plane(family, axis, gl.Axis.even("omega", 0.9, 1.0, 2))
    assert plane.shares[MotionKind.NEUTRAL] == 2
    assert plane.statuses[Status.NEUTRAL] == 2
