"""What changes between the points of a sweep, located."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import pytest

from gearlash.case import Case
from gearlash.case import load as load_case
from gearlash.orbits import Orbit, attractor, shoot
from gearlash.results import Axis, Sweep
from gearlash.studies import sweep
from gearlash.studies.transition import (
    APERIODIC,
    DOUBLING,
    FOLD,
    GRAZING,
    JUMP,
    UNPROVED,
    Transition,
)
from gearlash.studies.transitions import transitions
from gearlash.system import Label, MotionKind, Signature, Status
from orbits.members import article, built, cold


@pytest.fixture(scope="module")
def case() -> Case:
    return load_case("article-first-harmonic")


def found_along(done: Sweep, rising: bool = True) -> tuple[Transition, ...]:
    return transitions(article(), done.axis.name, done.points, values=done.fixed, rising=rising)


def check_one(transition: Transition) -> None:
    """What every located change must hold."""
    point = transition.point
    assert transition.lower < transition.upper
    assert transition.label_below != transition.label_above
    if point is None:
        assert transition.kind in (JUMP, APERIODIC, UNPROVED)
        assert transition.value == 0.5 * (transition.lower + transition.upper)
        return
    assert transition.value == point.value
    assert point.status is Status.OK
    assert point.residual <= 1e-10
    assert point.is_grazing == (transition.kind == GRAZING)
    if point.is_grazing:
        assert (point.label_below, point.label_above) == (transition.label_below, transition.label_above)
        assert transition.lower <= point.value <= transition.upper
    else:
        target = -1.0 if transition.kind == DOUBLING else 1.0
        assert np.abs(point.multipliers - target).min() < 1e-5


def test_window_over_frequency(case):
    """Seven points: the grazing at ω ≈ 0.97248, and nothing else."""
    done = sweep(case, Axis.even("omega", 0.955, 0.985, 7))
    found = found_along(done)
    assert [t.kind for t in found] == [GRAZING]
    (graze,) = found
    check_one(graze)
    assert graze.value == pytest.approx(0.97248, abs=5e-6)
    assert (graze.label_below, graze.label_above) == ("1-1-0", "1-0-0")


def test_doubling_over_frequency(case):
    done = sweep(case, Axis.even("omega", 1.28, 1.31, 4))
    found = found_along(done)
    assert [t.kind for t in found] == [DOUBLING]
    check_one(found[0])
    assert found[0].value == pytest.approx(1.294084, abs=1e-6)
    assert (found[0].label_below, found[0].label_above) == ("2-2-0", "1-1-0")


@pytest.fixture(scope="module")
def over_the_gap(case) -> tuple[Sweep, tuple[Transition, ...]]:
    done = sweep(case, Axis.even("D", 0.38, 0.401, 8), values={"omega": 0.78}, direction="up")
    return done, found_along(done)


def test_several_changes_over_the_gap(over_the_gap):
    """From 12-12-3 to 12-12-4 through others: every change, in order, of its kind."""
    _, found = over_the_gap
    assert [(t.kind, t.label_below, t.label_above) for t in found] == [
        (GRAZING, "12-12-3", "12-12-2"),
        (DOUBLING, "12-12-2", "6-6-1"),
        (GRAZING, "6-6-1", "6-6-2"),
        (DOUBLING, "6-6-2", "12-12-4"),
        (GRAZING, "12-12-4", "12-12-3"),
        (GRAZING, "12-12-3", "12-12-4"),
    ]
    for transition in found:
        check_one(transition)
    values = [t.value for t in found]
    assert values == sorted(values)
    for one, two in pairwise(found):
        assert one.label_above == two.label_below


def test_labels_between_the_changes_are_those_they_say(over_the_gap):
    """Attractors at values that no sweep has seen: the label is the one between its neighbouring changes."""
    done, found = over_the_gap
    edges = [0.38, *(t.value for t in found), 0.401]
    labels = [found[0].label_below, *(t.label_above for t in found)]
    start = done.points[0].state
    for (low, high), label in zip(pairwise(edges), labels, strict=True):
        for part in (0.02, 0.5, 0.98):
            value = low + part * (high - low)
            props = built(article(), omega=0.78, D=value)
            assert attractor(props, start).label == label, f"at D = {value}"


def test_direction_matters_where_attractors_coexist(case):
    """2-1-0 ends in a fold at ω ≈ 1.0922 when followed down; followed up, 1-0-0 goes on."""
    axis = Axis.even("omega", 1.085, 1.105, 3)
    down = sweep(case, axis, direction="down")
    assert [p.label for p in down.points] == ["1-0-0", "2-1-0", "2-1-0"]
    found = found_along(down, rising=False)
    assert [t.kind for t in found] == [FOLD]
    check_one(found[0])
    assert found[0].value == pytest.approx(1.0921896, abs=1e-6)
    up = sweep(case, axis, direction="up")
    assert found_along(up) == ()


def test_onset_of_aperiodic_motion_has_an_interval_only(case):
    done = sweep(case, Axis.even("omega", 0.59, 0.60, 2))
    assert done.points[1].label == "aperiodic"
    assert done.points[0].period > 0
    (change,) = found_along(done)
    assert change.kind == APERIODIC
    assert change.point is None
    check_one(change)


@dataclass(frozen=True)
class Bare:
    """The least that a sampled point must have."""

    value: float
    label: Label | None
    period: int
    state: np.ndarray


def test_no_change_no_transition():
    found = cold(article(), omega=1.04)
    assert isinstance(found, Orbit)
    points = [Bare(value, Signature(1, 0), 1, found.state) for value in (1.03, 1.04, 1.05)]
    assert transitions(article(), "omega", points) == ()
    assert transitions(article(), "omega", points[:1]) == ()
    assert transitions(article(), "omega", []) == ()


def test_unresolved_neighbours_give_no_point():
    found = cold(article(), omega=1.04)
    points = [
        Bare(1.03, MotionKind.UNRESOLVED, 0, found.final_state),
        Bare(1.04, MotionKind.APERIODIC, 0, found.final_state),
    ]
    (change,) = transitions(article(), "omega", points)
    assert (change.kind, change.point) == (UNPROVED, None)


def test_a_label_that_is_not_true_is_not_explained():
    """Points that claim a grazing where there is none: no point is made up for it."""
    states = {}
    for value in (1.02, 1.04):
        shot = shoot(built(article(), omega=value), cold(article(), omega=1.04).final_state, 1)
        states[value] = shot.state
    points = [Bare(1.02, Signature(1, 1), 1, states[1.02]), Bare(1.04, Signature(1, 0), 1, states[1.04])]
    for change in transitions(article(), "omega", points):
        assert change.kind != GRAZING
        assert change.point is None


def test_sparse_and_dense_sweeps_agree(case):
    """The same values from other points: what is located does not depend on where it was looked from."""
    one = found_along(sweep(case, Axis.even("omega", 0.96, 0.98, 3)))
    other = found_along(sweep(case, Axis.even("omega", 0.971, 0.974, 4)))
    assert len(one) == len(other) == 1
    assert one[0].value == pytest.approx(other[0].value, rel=1e-12)
    assert replace(one[0], lower=0, upper=0, point=None).kind == other[0].kind
