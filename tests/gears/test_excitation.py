"""Curves of stiffness and error over mesh cycles and turns of shafts, and run-out, in a pair's equations."""

import numpy as np
import pytest
from scipy.linalg import expm

import gearlash as gl
from gearlash.gears import HelicalPair, helical, spur
from gearlash.gears.excitation import Curve, Excitation, spread, summed
from gearlash.gears.waveform import rectangle, waveform
from gearlash.system import evaluate

PLAIN = {"omega": 0.7, "D": 1.0, "load": 0.5, "mesh_damping": 0.05}


def orbit_of(system: gl.System, start: np.ndarray) -> gl.Orbit:
    found = gl.attractor(system, start)
    assert isinstance(found, gl.Orbit)
    return found


def test_a_series_spread_over_more_cycles_is_the_same_curve():
    series = np.array([0.3, 1.0, -0.5, 0.2, 0.7])
    angle = np.linspace(0.0, 2.0 * np.pi, 37)
    assert evaluate(spread(series, 5), angle) == pytest.approx(evaluate(series, 5.0 * angle), abs=1e-13)
    other = np.array([1.0, 2.0, 0.0])
    total = evaluate(series, angle) + evaluate(other, angle)
    assert evaluate(summed(series, other), angle) == pytest.approx(total, abs=1e-14)


def test_a_curve_means_the_same_as_its_harmonics_by_name():
    named = spur.family(
        PLAIN | {"ripple": 0.2, "ripple_phase": 0.4, "error": 0.1, "error_2": 0.05, "error_phase_2": 1.0}
    )
    curved = spur.family(
        PLAIN,
        excitation=Excitation(
            Curve(gl.cosines(1.0, [0.2], [0.4])), Curve(gl.cosines(0.3, [0.1, 0.05], [0.0, 1.0]))
        ),
    )
    one, other = named.system(), curved.system()
    assert other.forcing == pytest.approx(one.forcing, abs=1e-15)
    assert other.clearances[0].stiffness_plus == pytest.approx(one.clearances[0].stiffness_plus, abs=1e-15)
    twice = curved.system({"ripple_scale": 2.0, "error_scale": 0.5})
    assert twice.clearances[0].stiffness_plus[1:] == pytest.approx(2.0 * one.clearances[0].stiffness_plus[1:])
    assert twice.forcing[1][1:] == pytest.approx(0.5 * one.forcing[1][1:])


@pytest.mark.parametrize("ratio", [1.6, 2.4])
def test_a_rectangle_converges_to_the_switched_system(ratio):
    """Multipliers of the closed mesh, from matrix exponentials between the two values of stiffness."""
    low, high, omega = 0.9, 1.15, 1.3
    part = ratio % 1.0
    mean = part * high + (1.0 - part) * low

    def closed(stiffness):
        return np.array([[0.0, 1.0], [-stiffness / mean, -2.0 * 0.05]])

    period = 2.0 * np.pi / omega
    exact = expm((1.0 - part) * period * closed(low)) @ expm(part * period * closed(high))
    wanted = np.sort_complex(np.linalg.eigvals(exact))
    errors = []
    for count in (12, 48):
        curve = rectangle(low / mean, high / mean, ratio, count)
        family = spur.family(PLAIN | {"omega": omega}, excitation=Excitation(Curve(curve.series)))
        found = orbit_of(family.system(), family.start())
        assert str(found.label) == "1-0-0"
        errors.append(np.abs(np.sort_complex(found.multipliers) - wanted).max())
    assert errors[1] < errors[0] / 2.0
    assert errors[1] < 2e-3


@pytest.mark.parametrize("teeth", [{"pinion": 5}, {"gear": 7}, {"pinion": 4, "gear": 6}])
def test_run_out_of_a_closed_mesh_moves_it_once_a_turn(teeth):
    """A linear oscillator under -E'' with E = F_r/2 cos(θ/z): its answer in closed form."""
    excitation = Excitation(runout=teeth)
    values = {f"{shaft}_runout": 0.2 for shaft in teeth}
    family = spur.family(PLAIN | values, excitation=excitation)
    found = orbit_of(family.system(), family.start())
    assert found.period == pytest.approx(np.lcm.reduce(list(teeth.values())))
    phases = np.linspace(0.0, found.period, 41)
    expected = np.full(len(phases), 1.5)
    for count in teeth.values():
        rate = PLAIN["omega"] / count
        answer = 0.1 * rate**2 / (1.0 - rate**2 + 2j * 0.05 * rate)
        expected += (answer * np.exp(2j * np.pi * phases / count)).real
    trace = gl.trace(family.system(), found.state, found.period)
    assert trace.at(phases).displacement == pytest.approx(expected, abs=1e-10)


def test_turns_of_both_shafts_close_after_their_common_multiple():
    assert Excitation(runout={"pinion": 28, "gear": 70}).cycles == 140
    curve = Curve(waveform([0.0, 0.5], [1.0, -1.0], 3).series, 28)
    assert Excitation(curve, None, {"gear": 70}).cycles == 140


def test_a_helical_pair_takes_them_too():
    pair = HelicalPair(0.8, 0.89, 0.29, (0.3, 0.05), (0.7, 0.6, 0.4, 0.3))
    excitation = Excitation(runout={"pinion": 3})
    values = PLAIN | {"bearing_damping": 0.05, "pinion_runout": 0.3}
    family = helical.family(pair, values, excitation)
    found = orbit_of(family.system(), family.start())
    assert found.period == 3
    still = family.system({"pinion_runout": 0.0})
    start = orbit_of(still, family.start({"pinion_runout": 0.0}))
    assert np.sort(np.abs(found.multipliers)) == pytest.approx(np.sort(np.abs(start.multipliers)), abs=1e-8)
