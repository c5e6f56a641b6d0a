"""A stable motion followed along a parameter: what it meets, against closed forms and against itself."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise

import numpy as np
import pytest

from branches.followed import PLAIN
from branches.shaken import DEFAULTS, linear, response, shaken, touches
from branches.test_out_of_range import unbuildable
from gearlash.branches.continuation import (
    EndKind,
    EndOfBranch,
    Node,
    SpecialKind,
    SpecialPoint,
    continue_orbit,
    walk,
)
from gearlash.orbits import Orbit, attractor, orbit_at, shoot
from gearlash.system import ContactRule, Family, GearlashError
from oracles import closed_forms
from orbits.contacts import one_dof_under, two_gaps
from orbits.members import built, one_dof, orbit

SHAKEN = [
    {},  # chaos lies behind its touch
    {"beta": 1000.0, "zeta": 0.002},
    {"a": 0.2, "omega": 0.9, "zeta": 0.05, "beta": 3.0},
    {"a": 1.4, "omega": 0.5, "zeta": 0.3, "gap": 0.4},
]


class Met:
    """All that a walk meets: orbits, special points, and the end."""

    def __init__(self, family: Family, values: Mapping[str, float], name: str, found: Orbit, to: float):
        self.items = list(walk(family, values, name, found, to))
        self.nodes = [item for item in self.items if isinstance(item, Node)]
        self.special = [item for item in self.items if isinstance(item, SpecialPoint)]
        (self.end,) = (item for item in self.items if isinstance(item, EndOfBranch))
        assert self.items[-1] is self.end

    @property
    def last(self) -> Node:
        return self.nodes[-1]

    def after(self, special: SpecialPoint) -> Node | None:
        later = self.items[self.items.index(special) + 1 :]
        return next((item for item in later if isinstance(item, Node)), None)


def first_touch(
    family: Family, values: Mapping[str, float], name: str, found: Orbit, to: float
) -> SpecialPoint | None:
    """The first grazing on the way."""
    way: Iterator[object] = walk(family, values, name, found, to)
    return next((s for s in way if isinstance(s, SpecialPoint) and s.kind is SpecialKind.GRAZING), None)


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
            assert point.extremum is not None
            assert point.extremum.boundary == side
            labels = (point.label_before, point.label_after)
            assert labels == (("1-0-0", "1-1-0") if side > 0 else ("1-0-0", "1-0-1"))
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
    assert point.extremum is not None
    exact = closed_forms.spur_grazing_omegas(0.1, 0.05, 0.1)[0]
    if rule is ContactRule.NO_TENSION:
        assert point.extremum.surface == "force"
        assert point.value < exact
    else:
        assert point.value == pytest.approx(exact, rel=1e-11)
    assert point.extremum.boundary == np.sign(load)


@pytest.mark.parametrize("omega", [0.9, 1.3])
def test_between_impact_counts_both_ways_are_one(omega):
    """Two gaps: the touches met upwards are those met downwards from where that ended."""
    family = two_gaps()
    values = family.complete({"omega": omega})
    up = Met(family, values, "omega", orbit(family, **values), omega + 0.15)
    assert up.end.kind is EndKind.ARRIVED
    back = Met(family, {**values, "omega": up.last.value}, "omega", up.last.orbit, omega)
    assert [m.value for m in up.special] == pytest.approx([m.value for m in back.special][::-1], rel=1e-10)
    assert all(one.kind is SpecialKind.GRAZING for one in up.special)
    labels = [label for one in up.special for label in (one.label_before, one.label_after)]
    assert labels == [label for one in back.special[::-1] for label in (one.label_after, one.label_before)]
    assert all(one.label_after == after.label_before for one, after in pairwise(up.special))


@pytest.fixture(scope="module")
def falling() -> tuple[Family, dict[str, float], Met]:
    """The pair that falls off a fold, upwards from 0.8, with all that it meets."""
    family = one_dof(load=0.1, error=0.05)
    values = family.complete({"omega": 0.8})
    return family, values, Met(family, values, "omega", orbit(family, **values), 0.9)


def test_a_fold_is_the_end(falling):
    family, values, met = falling
    fold = met.special[-1]
    assert (met.end.kind, met.end.value) == (EndKind.FOLD, fold.value)
    assert fold.kind is SpecialKind.FOLD
    assert met.after(fold) is None
    assert fold.value == pytest.approx(0.82846398, abs=1e-8)
    props = built(family, **{**values, "omega": fold.value * (1 + 1e-6)})
    gone = shoot(props, fold.point.state, 1)
    assert gone.residual > 1e-11 or np.abs(gone.state - fold.point.state).max() > 0.1
    beyond = attractor(props, fold.point.state)
    assert np.abs(beyond.final_state - fold.point.state).max() > 0.1


def test_in_the_order_in_which_they_are_met(falling):
    _, _, met = falling
    values = [item.value for item in met.items]
    assert values == sorted(values)
    assert [one.kind for one in met.special] == [SpecialKind.GRAZING, SpecialKind.FOLD]


def test_a_doubling_is_passed_on_the_doubled_orbit_and_found_from_it():
    family = shaken()
    values = dict(DEFAULTS)
    met = Met(family, values, "omega", linear(family, values), 0.80206)
    assert [one.label_before for one in met.special[:2]] == ["1-0-0", "1-1-0"]
    doubling = met.special[1]
    assert doubling.kind is SpecialKind.DOUBLING
    assert np.abs(doubling.point.multipliers + 1.0).min() < 1e-6
    after = met.after(doubling)
    assert after is not None
    assert (after.label, after.orbit.stable) == ("2-2-0", True)
    back = Met(family, {**values, "omega": after.value}, "omega", after.orbit, 0.79)
    joined, touch = back.special
    assert joined.value == pytest.approx(doubling.value, rel=1e-9)
    assert touch.value == pytest.approx(met.special[0].value, rel=1e-11)
    assert (back.end.kind, back.last.label) == (EndKind.ARRIVED, "1-0-0")


def test_no_longer_period_is_followed_than_was_asked_for():
    values = dict(DEFAULTS)
    *_, doubling, end = walk(shaken(), values, "omega", linear(shaken(), values), 0.80206, longest=1)
    assert isinstance(doubling, SpecialPoint)
    assert isinstance(end, EndOfBranch)
    assert (end.kind, end.value) == (EndKind.PERIOD, doubling.value)


def test_where_no_system_can_be_built():
    family = unbuildable(one_dof(load=0.1, error=0.05), "omega", 0.65, GearlashError("too fast"))
    values = family.complete({"omega": 0.6})
    met = Met(family, values, "omega", orbit(family, **values), 0.9)
    assert met.special == []
    assert met.end.kind is EndKind.UNBUILT
    assert "too fast" in met.end.note
    assert met.last.value <= 0.65 <= met.last.value + 1e-6


@pytest.mark.parametrize("rule", list(ContactRule))
def test_through_rest(rule):
    """Where ripple and error cancel, the teeth in contact come to rest; the motion goes on beyond."""
    family = one_dof_under(rule, back_stiffness=1.0)
    values = {"omega": 0.62807, "load": 0.25747, "ripple": 0.27312, "error": 0.13495, "mesh_damping": 0.08561}
    met = Met(family, family.complete(values), "omega", orbit(family, **values), 0.9)
    assert (met.special, met.end.kind, met.last.label) == ([], EndKind.ARRIVED, "1-0-0")
    swings = [
        float(np.ptp(orbit(family, **{**values, "omega": omega}).trace.samples(50).displacement))
        for omega in (0.7, 0.72186, 0.74)
    ]
    assert swings[1] < 1e-3 * min(swings[0], swings[2])


def test_every_orbit_on_the_way_is_told():
    values = dict(DEFAULTS)
    met = Met(shaken(), values, "omega", linear(shaken(), values), 0.7)
    told = [node.value for node in met.nodes]
    assert told == sorted(told, reverse=True)
    assert (told[0], told[-1]) == pytest.approx((values["omega"], 0.7), rel=1e-15)


def test_no_way_at_all():
    values = dict(DEFAULTS)
    start, end = walk(shaken(), values, "omega", linear(shaken(), values), values["omega"])
    assert isinstance(start, Node)
    assert isinstance(end, EndOfBranch)
    assert end.kind is EndKind.ARRIVED


@pytest.mark.parametrize("state", [(0.0, 0.0), (0.1, 0.0), (-1.5, 0.0)])
def test_what_is_not_isolated_is_refused(state):
    """Without load and excitation a pair rests anywhere in its gap."""
    family = one_dof(load=0.0, error=0.0, ripple=0.0, D=2.0)
    rest = orbit_at(built(family, omega=1.0), state, 1)
    assert rest is not None
    for go in (
        lambda: list(walk(family, {"omega": 1.0}, "omega", rest, 1.2)),
        lambda: continue_orbit(family, {"omega": 1.0}, "omega", rest, 0.8, 1.2, PLAIN),
    ):
        with pytest.raises(GearlashError, match="is not isolated"):
            go()
