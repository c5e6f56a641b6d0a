"""A motion followed along a parameter: what it meets first, against closed forms and against itself."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

import numpy as np
import pytest

from branches.shaken import DEFAULTS, linear, response, shaken, touches
from branches.test_out_of_range import unbuildable
from gearlash.branches import BifurcationPoint, GrazingPoint, Outcome, Passage, PathEnd, follow
from gearlash.orbits import Orbit, attractor, shoot
from gearlash.system import ContactRule, Family, GearlashError, Label
from oracles import closed_forms
from orbits.contacts import one_dof_under, two_gaps
from orbits.members import built, one_dof, orbit

SHAKEN = [
    {},  # chaos lies behind its touch
    {"beta": 1000.0, "zeta": 0.002},
    {"a": 0.2, "omega": 0.9, "zeta": 0.05, "beta": 3.0},
    {"a": 1.4, "omega": 0.5, "zeta": 0.3, "gap": 0.4},
]


def events(family: Family, values: Mapping[str, float], name: str, found: Orbit, to: float):
    """What is met, and the end."""
    *met, end = follow(family, name, found, to, values=values)
    assert all(isinstance(one, Passage) for one in met)
    assert isinstance(end, PathEnd)
    return [one for one in met if isinstance(one, Passage)], end


def first_touch(family: Family, values: Mapping[str, float], name: str, found: Orbit, to: float):
    """The first grazing on the way, or None."""
    for step in follow(family, name, found, to, values=values):
        if isinstance(step, Passage) and isinstance(step.point, GrazingPoint):
            return step.point
    return None


@pytest.mark.parametrize(("side", "away"), [(1, 0.1), (1, 1e-3), (-1, 1e-6), (1, 1e-9)])
@pytest.mark.parametrize("name", ["omega", "a", "gap", "zeta"])
@pytest.mark.parametrize("changed", SHAKEN, ids=range(len(SHAKEN)))
def test_the_next_touch_of_a_linear_motion(side, name, changed, away):
    """From as near and as far as one likes, whatever the motion is behind the touch; the other way, the next
    one or none."""
    family, values = shaken(side), {**DEFAULTS, **changed}
    for exact in touches(values, name, 0.3 * values[name], 3.0 * values[name]):
        for sign in (-1.0, 1.0):
            start = {**values, name: exact * (1.0 + sign * away)}
            if abs(response(start)) > start["gap"]:
                continue
            found = linear(family, start)
            point = first_touch(family, start, name, found, exact * (1.0 - sign * 0.1))
            assert point is not None
            assert point.value == pytest.approx(exact, rel=1e-11)
            assert point.boundary == side
            labels = (point.label_below, point.label_above)[:: int(sign)]
            assert labels == (("1-1-0", "1-0-0") if side > 0 else ("1-0-1", "1-0-0"))
            to = start[name] * (1.0 + 0.5 * sign)
            further = touches(values, name, *sorted((start[name], to)))
            other = first_touch(family, start, name, found, to)
            assert (other is None) == (not further)
            if other is not None:
                assert other.value == pytest.approx(min(further, key=lambda v: abs(v - exact)), rel=1e-11)


def test_from_the_touch_itself():
    """The orbit that touches: the touch lies on the side on which its contact begins, not on the other."""
    values = dict(DEFAULTS)
    (exact, _) = touches(values, "omega", 0.5, 3.0)
    values["omega"] = exact
    found = linear(shaken(), values)
    up = first_touch(shaken(), values, "omega", found, 0.85)
    assert up is not None
    assert up.value == pytest.approx(exact, rel=1e-12)
    assert first_touch(shaken(), values, "omega", found, 0.6) is None


@pytest.mark.parametrize("load", [0.1, -0.1])
@pytest.mark.parametrize("rule", list(ContactRule))
def test_a_mesh_under_either_sign_of_the_load(load, rule):
    """Up from low speed the first root of a quadratic in ω², of either side; where the force is what ends
    contact, the touch of the force comes before."""
    family = one_dof_under(rule)
    values = family.complete({"omega": 0.5, "load": load, "error": 0.05 * np.sign(load)})
    point = first_touch(family, values, "omega", orbit(family, **values), 0.95)
    assert point is not None
    exact = closed_forms.spur_grazing_omegas(0.1, 0.05, 0.1)[0]
    if rule is ContactRule.NO_TENSION:
        assert point.surface == "force"
        assert point.value < exact
    else:
        assert point.value == pytest.approx(exact, rel=1e-11)
    assert point.boundary == np.sign(load)


@pytest.mark.parametrize("omega", [0.9, 1.3])
def test_between_impact_counts_both_ways_are_one(omega):
    """Two gaps: the touches met upwards are those met downwards from where that ended."""
    family = two_gaps()
    values = family.complete({"omega": omega})
    up, end = events(family, values, "omega", orbit(family, **values), omega + 0.15)
    assert end.outcome is Outcome.ARRIVED
    back, _ = events(family, family.complete({"omega": end.last.value}), "omega", end.last.orbit, omega)
    assert [m.value for m in up] == pytest.approx([m.value for m in back][::-1], rel=1e-10)
    for one in up:
        assert isinstance(one.point, GrazingPoint)
        assert (one.point.label_below, one.point.label_above) == (one.before.label, _label(one))


def _label(met: Passage) -> Label:
    assert met.after is not None
    return met.after.label


@pytest.fixture(scope="module")
def falling() -> tuple[Family, dict[str, float], list[Passage], PathEnd]:
    """The pair that falls off a fold, upwards from 0.8, with all that it meets."""
    family = one_dof(load=0.1, error=0.05)
    values = family.complete({"omega": 0.8})
    return family, values, *events(family, values, "omega", orbit(family, **values), 0.9)


def test_a_fold_is_the_end(falling):
    family, values, met, end = falling
    assert end.outcome is Outcome.FOLD
    fold = met[-1].point
    assert isinstance(fold, BifurcationPoint)
    assert fold.multiplier == 1
    assert met[-1].after is None
    assert fold.value == pytest.approx(0.82846398, abs=1e-8)
    props = built(family, **{**values, "omega": fold.value * (1 + 1e-6)})
    gone = shoot(props, fold.state, 1)
    assert gone.residual > 1e-11 or np.abs(gone.state - fold.state).max() > 0.1
    beyond = attractor(props, fold.state)
    assert np.abs(beyond.final_state - fold.state).max() > 0.1


def test_in_the_order_in_which_they_are_met(falling):
    _, _, met, _ = falling
    assert all(a.value < b.value for a, b in pairwise(met))
    assert [type(one.point) for one in met] == [GrazingPoint, BifurcationPoint]


def test_a_doubling_is_passed_on_the_doubled_orbit_and_found_from_it():
    family = shaken()
    values = dict(DEFAULTS)
    met, _ = events(family, values, "omega", linear(family, values), 0.80206)
    assert [one.before.label for one in met] == ["1-0-0", "1-1-0"]
    doubling = met[-1].point
    assert isinstance(doubling, BifurcationPoint)
    assert np.abs(doubling.multipliers + 1.0).min() < 1e-6
    after = met[-1].after
    assert after is not None
    assert (after.label, after.orbit.stable) == ("2-2-0", True)
    back, end = events(family, {**values, "omega": after.value}, "omega", after.orbit, 0.79)
    assert back[0].value == pytest.approx(doubling.value, rel=1e-9)
    assert back[1].value == pytest.approx(met[0].value, rel=1e-11)
    assert (end.outcome, end.last.label) == (Outcome.ARRIVED, "1-0-0")


def test_where_no_system_can_be_built():
    family = unbuildable(one_dof(load=0.1, error=0.05), "omega", 0.65, GearlashError("too fast"))
    values = family.complete({"omega": 0.6})
    met, end = events(family, values, "omega", orbit(family, **values), 0.9)
    assert met == []
    assert end.outcome is Outcome.UNBUILT
    assert "too fast" in end.reason
    assert end.last.value <= 0.65 < end.beyond <= 0.65 + 1e-6


@pytest.mark.parametrize("rule", list(ContactRule))
def test_through_rest(rule):
    """Where ripple and error cancel, the teeth in contact come to rest; the motion goes on beyond."""
    family = one_dof_under(rule, back_stiffness=1.0)
    values = {"omega": 0.62807, "load": 0.25747, "ripple": 0.27312, "error": 0.13495, "mesh_damping": 0.08561}
    start = orbit(family, **values)
    met, end = events(family, family.complete(values), "omega", start, 0.9)
    assert (met, end.outcome, end.last.label) == ([], Outcome.ARRIVED, "1-0-0")
    swings = [
        float(np.ptp(orbit(family, **{**values, "omega": omega}).trace.samples(50).displacement))
        for omega in (0.7, 0.72186, 0.74)
    ]
    assert swings[1] < 1e-3 * min(swings[0], swings[2])


def test_the_way_is_told():
    values, told = dict(DEFAULTS), []
    found = linear(shaken(), values)
    list(follow(shaken(), "omega", found, 0.7, values=values, tell=told.append))
    assert told == sorted(told, reverse=True)
    assert told[-1] == 0.7
