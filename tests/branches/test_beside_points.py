"""What lies just beside special points that share a step, and branches that only pass by a doubling."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from branches.followed import PLAIN
from gearlash.branches.continuation import Branch, SpecialKind, continue_orbit, switched
from gearlash.orbits import Orbit, attractor, orbit_at
from gearlash.system import Clearance, ContactRule, Family, Parameter, System
from orbits.members import built


def rattle() -> Family:
    """An idle gear, held back by drag, driven through backlash by a pinion of uneven speed."""

    def build(p):
        matrix = np.array([[0.0, 1.0], [0.0, 0.0]])
        forcing = np.array([[0.0, 0.0, 0.0], [-0.2, 0.0, 0.0]])
        h, g = np.array([1.0, 0.0]), np.array([0.0, -1.0])
        stiffness = np.array([9.0, 1.8, 0.0])
        mesh = Clearance(h, g, 1.0, 1.0, stiffness, stiffness, 0.6, np.array([0.0, p["amplitude"], 0.0]))
        return System(p["omega"], matrix, forcing, (mesh,))

    parameters = Parameter("omega", 0.7), Parameter("amplitude", 0.6)
    cold = np.array([-1.0 - 0.2 / 9.0, 0.0])
    return Family(parameters, ("x", "v"), build, cold_start=lambda _: cold)


def stop() -> Family:
    """A driven oscillator with a soft stop on one side."""

    def build(p):
        matrix = np.array([[0.0, 1.0], [-1.0, -0.08]])
        forcing = np.array([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
        h, g = np.array([1.0, 0.0]), np.array([0.0, -1.0])
        one = Clearance(h, g, 1.3, 100.0, np.array([15.0]), np.array([0.0]), contact=ContactRule.IN_CONTACT)
        return System(p["omega"], matrix, forcing, (one,))

    return Family((Parameter("omega", 0.8),), ("x", "v"), build, cold_start=lambda _: np.zeros(2))


def pair(apart: float) -> Family:
    """Two equal oscillators side by side, each with a stop; these differ by ``apart``."""

    def build(p):
        one = np.array([[0.0, 1.0], [-1.0, -0.2]])
        matrix = np.block([[one, np.zeros((2, 2))], [np.zeros((2, 2)), one]])
        forcing = np.zeros((4, 3))
        forcing[[1, 3], 1] = p["force"]
        clearances = []
        for i in (0, 2):
            h, g = np.zeros(4), np.zeros(4)
            h[i], g[i + 1] = 1.0, -1.0
            stiffness, name = np.array([0.5]), f"stop {i}"
            gap = 1.0 if i == 0 else 1.0 + apart
            stops = Clearance(
                h, g, gap, 9.0, stiffness, 0.0 * stiffness, contact=ContactRule.IN_CONTACT, name=name
            )
            clearances.append(stops)
        return System(1.5, matrix, forcing, tuple(clearances))

    names = ("x", "v", "y", "w")
    return Family((Parameter("force", 1.0),), names, build, cold_start=lambda _: np.zeros(4))


def followed(family: Family, name: str, value: float, lower: float, upper: float) -> Branch:
    props = built(family, **{name: value})
    found = attractor(props, family.start())
    assert isinstance(found, Orbit)
    start = orbit_at(props, found.state, 1)
    assert start is not None
    return continue_orbit(family, {name: value}, name, start, lower, upper, PLAIN)


def chained(branch: Branch) -> None:
    """Behind a special point lies what is before the next one, where no orbit was computed in between."""
    for one, two in pairwise(branch.special):
        if not any(one.arclength < point.arclength < two.arclength for point in branch.points):
            assert one.label_after == two.label_before
            assert one.unstable_after == two.unstable_before


def test_a_touch_and_a_fold_in_one_step():
    branch = followed(rattle(), "amplitude", 0.3, 0.1, 1.5)
    (touch,) = [s for s in branch.special if s.value == pytest.approx(0.5634861558, abs=1e-9)]
    place = branch.special.index(touch)
    before, after = branch.special[place - 1], branch.special[place + 1]
    assert before.kind is after.kind is SpecialKind.FOLD
    assert (before.label_after, before.unstable_after) == ("1-0-1", 0)
    assert (touch.label_before, touch.label_after) == ("1-0-1", "1-0-2")
    assert (touch.unstable_before, touch.unstable_after) == (0, 0)
    assert (after.label_before, after.label_after) == ("1-0-2", "1-0-2")
    assert (after.unstable_before, after.unstable_after) == (0, 1)
    chained(branch)


def test_two_touches_at_one_place():
    """Two equal oscillators side by side touch their stops at one value: no orbit lies between."""

    branch = followed(pair(0.0), "force", 1.0, 0.9, 1.5)
    one, two = branch.special
    assert one.is_grazing
    assert two.is_grazing
    assert one.value == pytest.approx(np.hypot(1.25, 0.3), rel=1e-10)
    assert two.value == pytest.approx(one.value, rel=1e-13)
    for touch in (one, two):
        assert (touch.label_before, touch.label_after) == ("1-0-0/0-0", "1-1-0/1-0")


def test_two_touches_near_each_other():
    """Of two oscillators whose stops differ by 1e-7: between the touches only one of them is in contact."""
    one, two = followed(pair(1e-7), "force", 1.0, 0.9, 1.5).special
    assert two.value - one.value == pytest.approx(1e-7 * one.value, rel=1e-5)
    assert [one.label_before, one.label_after] == ["1-0-0/0-0", "1-1-0/0-0"]
    assert [two.label_before, two.label_after] == ["1-1-0/0-0", "1-1-0/1-0"]


def test_no_branch_that_only_passes_by_is_switched_to():
    """Near the doubling of 2-4-0 a loop of 4-6-0 lies 0.013 aside: what begins in the doubling is 4-8-0."""
    family = stop()
    branch = followed(family, "omega", 0.8, 0.3, 2.4)
    doubling = branch.of_kind(SpecialKind.DOUBLING)[0]
    (start,) = switched(family, branch, doubling)
    two = continue_orbit(family, {"omega": start.value}, "omega", start.orbit, 0.3, 2.4, PLAIN)
    first, second = two.of_kind(SpecialKind.DOUBLING)
    for special in (first, second):
        (other,) = switched(family, two, special)
        assert other.orbit.label == "4-8-0"
        nearest = np.abs(other.orbit.strobes - special.point.state).max(axis=1).min()
        assert nearest < 1e-3
        assert abs(other.value - special.value) < 1e-5
    (four,) = switched(family, two, first)
    whole = continue_orbit(family, {"omega": four.value}, "omega", four.orbit, 0.53, 0.56, PLAIN)
    joins = whole.of_kind(SpecialKind.JOINS)
    assert [join.value for join in joins] == pytest.approx([first.value, second.value], rel=1e-10)
