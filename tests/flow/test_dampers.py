"""A side acts if its own stiffness, or the damping stated for it, is not zero."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import gearlash as gl
from gearlash.system import ContactRule
from oracles.oscillators import oscillator

EITHER = (ContactRule.IN_CONTACT, ContactRule.NO_TENSION)


def _system(stiffness, damping, damping_minus=None, rule=ContactRule.IN_CONTACT, gap=(0.5, 0.7)):
    return oscillator(
        omega=0.9,
        gap=gap,
        stiffness=stiffness,
        damping=damping,
        damping_minus=damping_minus,
        rule=rule,
        force=(0.1, 1.0, 0.0),
        ground=(1.0, 0.1),
    )


@pytest.mark.parametrize(
    ("stiffness", "damping", "damping_minus", "acts"),
    [
        ((2.0, 3.0), 0.0, None, (True, True)),
        ((2.0, 0.0), 0.0, None, (True, False)),
        ((2.0, 0.0), 0.5, None, (True, False)),  # the common damping is not inherited
        ((0.0, 2.0), 0.5, None, (False, True)),
        ((2.0, 0.0), 0.5, 0.3, (True, True)),  # this one is stated for side -
        ((2.0, 0.0), 0.5, 0.0, (True, False)),
        ((0.0, 2.0), 0.5, 0.0, (True, True)),
        ((0.0, 0.0), 0.5, None, (True, True)),  # nobody to inherit from: it is that of both sides
        ((0.0, 0.0), 0.5, 0.0, (True, False)),
        ((0.0, 0.0), 0.0, 0.5, (False, True)),
        ((0.0, 0.0), 0.0, None, (False, False)),
    ],
)
@pytest.mark.parametrize("rule", EITHER)
def test_which_sides_act(stiffness, damping, damping_minus, acts, rule):
    clearance = _system(stiffness, damping, damping_minus, rule).clearances[0]
    assert (clearance.stops(1), clearance.stops(-1)) == acts


def test_where_damping_acts_everywhere_only_stiffness_makes_a_side():
    clearance = _system((0.0, 2.0), 0.5, rule=ContactRule.ALWAYS).clearances[0]
    assert (clearance.stops(1), clearance.stops(-1)) == (False, True)


@pytest.mark.parametrize("rule", EITHER)
@pytest.mark.parametrize(
    ("stiffness", "soft", "damping", "minus"),
    [
        ((0.0, 0.0), (1e-12, 0.0), 0.5, 0.0),
        ((0.0, 0.0), (1e-12, 1e-12), 0.5, None),
        ((0.0, 0.0), (0.0, 1e-12), 0.0, 0.5),
        ((3.0, 0.0), (3.0, 1e-12), 0.2, 0.4),
    ],
)
def test_a_damper_is_the_limit_of_a_soft_stop(rule, stiffness, soft, damping, minus):
    damper = gl.attractor(_system(stiffness, damping, minus, rule), [0.0, 0.0])
    limit = gl.attractor(_system(soft, damping, minus, rule), [0.0, 0.0])
    assert damper.label == limit.label
    assert isinstance(damper, gl.Orbit)
    assert damper.signature.impacts > 0
    assert np.abs(damper.final_state - limit.final_state).max() < 1e-10


@pytest.mark.parametrize("rule", EITHER)
def test_dampers_against_an_independent_integrator(rule):
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    from oracles import region_oracle
    from oracles.matches import match

    rng, met = np.random.default_rng(11), 0
    for _ in range(12):
        stiffness = [(0.0, 0.0), (2.0, 0.0), (0.0, 5.0)][rng.integers(3)]
        system = _system(
            stiffness, rng.uniform(0.1, 1.0), rng.uniform(0.1, 1.0), rule, rng.uniform(0.1, 0.6, 2)
        )
        start = rng.normal(size=2)
        found = match(
            system, gl.trace(gl.propagators(system), start, 3.0), region_oracle.run(system, start, 3.0)
        )
        met += found.told.count("True")
        assert found.holds(), found.told
    assert met > 12


@pytest.mark.parametrize(
    ("name", "settings", "words"),
    [
        (
            "shaw-holmes",
            {"clearance.stop.contact": "in-contact"},
            "no damping stated for it: it does not act",
        ),
    ],
)
def test_check_says_how_a_side_without_stiffness_is_read(name, settings, words):
    (note,) = gl.load_case(name, settings).notes()
    assert words in note.text
    assert note.path.endswith("stiffness_minus")


def test_the_pair_with_equal_sides_is_read_as_before():
    clearance = gl.load_case("article").family()[0].system().clearances[0]
    assert clearance.stops(1)
    assert clearance.stops(-1)
    assert not replace(clearance, stiffness_minus=[0.0], contact="in-contact").stops(-1)
