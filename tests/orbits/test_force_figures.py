"""Extremes of the contact force, as sweeps tell them, against the force read everywhere."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.polynomial import polynomial

import gearlash as gl
from gearlash.flow import Trace
from gearlash.orbits.force_figures import force_figures
from gearlash.orbits.peaks import top
from gearlash.orbits.signals import signals
from gearlash.orbits.statistics import FREE
from gearlash.system import evaluate

READINGS = 2001  # of a piece, both ends among them: there the force jumps


def _everywhere(trace: Trace) -> np.ndarray:
    """Φ at many places of every piece, from its polynomial of X; damping acts in the gap, too."""
    (clearance,), props = trace.propagators.system.clearances, trace.propagators
    local, found = np.linspace(0.0, 1.0, READINGS), []
    for piece, series in enumerate(trace.gap):
        x = polynomial.polyval(local, series)
        velocity = polynomial.polyval(local, polynomial.polyder(series))
        velocity /= trace.lengths[piece] * props.cell_duration
        angle = 2.0 * np.pi / props.cells * (trace.positions[piece] + trace.lengths[piece] * local)
        beyond = np.where(x > 0.0, x - clearance.gap_plus, x + clearance.gap_minus)
        stiffness = evaluate(clearance.stiffness_plus, angle) * (trace.regions[piece] != FREE)
        found.append(stiffness * beyond + clearance.dampings[0] * velocity)
    return np.array(found)


@pytest.mark.parametrize("omega", [0.8, 0.82, 0.87, 0.89, 0.95, 1.05, 1.12])
def test_the_extremes_of_the_force_are_those_of_all_readings(omega: float) -> None:
    """At 0.8 to 0.95 the least force is where contact begins, and bends there; at 0.87 the motion is chaotic,
    and the highest of few readings lies beside another peak than the largest."""
    family, _ = gl.load_case("article").family()
    trace = gl.attractor(family.system({"omega": omega}), family.start({})).trace
    force, told, measured = _everywhere(trace), force_figures(trace), signals(trace).force
    span = np.ptp(force)
    for least, most in (told["force_min"], told["force_max"]), (measured.least, measured.most):
        assert least == pytest.approx(force.min(), abs=1e-7 * span)
        assert most == pytest.approx(force.max(), abs=1e-7 * span)


def test_a_force_that_does_not_alternate_alternates_by_rounding_only() -> None:
    family, _ = gl.load_case("article", {"ripple_2": 0.0, "error": 0.0}).family()
    force = gl.motion_statistics(gl.attractor(family.system(), family.start())).force
    assert force.mean > 0.1
    assert force.alternating_rms < 1e-13


@pytest.mark.parametrize("vertex", [0.0, 0.3, 1.0, 2.6, 5.4, 6.0])
def test_the_top_of_a_parabola_is_its_vertex_beside_an_end_too(vertex: float) -> None:
    assert top(3.0 - (np.arange(7.0) - vertex) ** 2) == pytest.approx(3.0, abs=1e-14)


def test_the_top_of_what_only_rises_is_its_last_value() -> None:
    assert top(3.0 - (np.arange(7.0) - 9.0) ** 2) == -6.0


@pytest.mark.parametrize("load", [0.1, -0.1])
def test_a_rule_without_tension_tells_none(load: float) -> None:
    """Contact ends where its force falls to zero: rounding there tells neither a pull nor a push."""
    values = {"contact": "no-tension", "omega": 0.9, "load": load}
    family, _ = gl.load_case("kahraman-singh", values).family()
    found = gl.attractor(family.system(), family.start())
    assert isinstance(found, gl.Orbit)
    assert (found.signature.drive, found.signature.back) == ((1, 0) if load > 0.0 else (0, 1))
    sign, told, force = np.sign(load), force_figures(found.trace), gl.motion_statistics(found).force
    for least, most in (
        (told["force_min"], told["force_max"]),
        (force.minimum, force.maximum),
        (signals(found.trace).force.least, signals(found.trace).force.most),
    ):
        assert (least if sign > 0.0 else most) == 0.0
        assert (most if sign > 0.0 else -least) > 0.15
