"""Jumps between orbits of one label, and smooth branches that are none."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import pytest

from branches.shaken import linear, shaken
from gearlash import flow
from gearlash.branches.continuation import SpecialKind
from gearlash.studies import Axis, point, sweep
from gearlash.studies.transition import (
    APERIODIC,
    FOLD,
    GRAZING,
    JUMP,
    UNDECIDED,
    UNPROVED,
    Transition,
    unlocated,
)
from gearlash.studies.transitions import transitions
from gearlash.studies.zone_end import BASIN
from gearlash.system import ContactRule, Family, GearlashError, Label, Signature, read_label
from orbits.contacts import two_gaps
from orbits.members import article, built, one_dof

FOLD_AT, TOUCH_AT, RETURN_AT = 0.82846398, 0.82063109, 0.70803160
"""Of the pair below: 1-1-0 ends upwards, is born in a touch of 1-0-0, and the other 1-1-0 ends downwards."""


def pair() -> Family:
    return one_dof(load=0.1, error=0.05)


def kinds(found: Sequence[Transition]) -> list[tuple[str, Label | None, Label | None]]:
    return [(t.kind, t.label_below, t.label_above) for t in found]


@dataclass(frozen=True)
class Bare:
    """The least that a sampled point must have."""

    value: float
    label: Label | None
    period: int
    state: np.ndarray


@pytest.mark.parametrize("count", [2, 3, 5, 41, 161])
def test_upwards_it_falls_off_a_fold_on_any_grid(count):
    """1-1-0 on both sides of the fold, and nothing else that changes from there on."""
    done = sweep(pair(), Axis.even("omega", 0.8, 0.84, count), direction="up")
    found = transitions(pair(), "omega", done.points)
    assert kinds(found) == [(GRAZING, "1-0-0", "1-1-0"), (FOLD, "1-1-0", "1-1-0")]
    assert [t.value for t in found] == pytest.approx([TOUCH_AT, FOLD_AT], abs=1e-7)
    assert found[1].point is not None
    assert found[1].point.kind is SpecialKind.FOLD
    assert all(t.lower < t.upper for t in found)


@pytest.mark.parametrize("count", [3, 41])
def test_downwards_it_stays_and_returns_elsewhere(count):
    axis = Axis.even("omega", 0.69, 0.84, count)
    done = sweep(pair(), axis, direction="down")
    found = transitions(pair(), "omega", done.points, rising=False)
    assert kinds(found) == [(FOLD, "1-0-0", "1-1-0")]
    assert found[0].value == pytest.approx(RETURN_AT, abs=1e-7)


def test_the_mirrored_pair_does_the_same():
    """X → -X with load and error negated: the same values on the back side."""
    fixed = {"load": -0.1, "error": -0.05}
    done = sweep(pair(), Axis.even("omega", 0.8, 0.84, 9), direction="up", values=fixed)
    found = transitions(pair(), "omega", done.points, values=fixed)
    assert kinds(found) == [(GRAZING, "1-0-0", "1-0-1"), (FOLD, "1-0-1", "1-0-1")]
    assert [t.value for t in found] == pytest.approx([TOUCH_AT, FOLD_AT], abs=1e-7)


@pytest.mark.slow
@pytest.mark.parametrize("count", [4, 41, 201])
@pytest.mark.parametrize("damping", [0.3, 0.002])
def test_a_resonance_is_no_jump(count, damping):
    """A linear motion has one branch, however sharp its peak is and however coarse the grid."""
    fixed = {"zeta": damping, "gap": 5e4}
    points = []
    for omega in np.linspace(0.5, 1.5, count):
        found = linear(shaken(), {**shaken().defaults, **fixed, "omega": float(omega)})
        points.append(Bare(float(omega), found.label, found.period, found.state))
    assert transitions(shaken(), "omega", points, values=fixed) == ()


def test_a_change_of_basin_between_orbits_of_one_label():
    """Between touch and fold two 1-1-0 coexist. A row of points that goes from one to the other where both
    exist: no orbit ends, and only the interval is known."""
    lower = sweep(pair(), Axis.even("omega", 0.8, 0.824, 7), direction="up").points[-1]
    upper = sweep(pair(), Axis.even("omega", 0.826, 0.9, 7), direction="down").points[0]
    assert lower.label == upper.label == "1-1-0"
    rows = [Bare(0.824, Signature(1, 1), 1, lower.state), Bare(0.826, Signature(1, 1), 1, upper.state)]
    for rising in (True, False):
        (change,) = transitions(pair(), "omega", rows, rising=rising)
        assert (change.kind, change.label_below, change.label_above) == (BASIN, "1-1-0", "1-1-0")
        assert (change.lower, change.upper, change.point) == (0.824, 0.826, None)


def test_orbits_begun_at_another_base_period_are_one():
    """A cold start may lead to any of the states of an orbit at phase zero."""
    one, two = (point(article(), {"omega": omega}, name="omega") for omega in (1.28, 1.281))
    assert one.label == two.label == "2-2-0"
    for state in (two.state, flow.march(built(article(), omega=1.281), two.state, 1).states[-1]):
        rows = [Bare(p.value, p.label, p.period, s) for p, s in ((one, one.state), (two, state))]
        assert transitions(article(), "omega", rows) == ()


def test_a_window_of_contact_between_two_points_is_seen():
    """Labels at both ends differ by one touch, but the motion between goes through three more changes."""
    family = two_gaps(ContactRule.IN_CONTACT)
    done = sweep(family, Axis.even("omega", 0.9, 1.0, 3), direction="up")
    found = transitions(family, "omega", done.points)
    assert [t.kind for t in found] == [GRAZING, GRAZING, FOLD, GRAZING]
    for one, two in pairwise(found):
        assert one.value < two.value
        assert one.label_above == two.label_below


def test_what_cannot_be_followed_is_not_decided():
    """Between two points of one branch no system can be built: nothing is said of a jump."""

    def build(values):
        if 0.61 < values["omega"] < 0.62:
            raise GearlashError("not in this range")
        return pair().build(values)

    family = replace(pair(), build=build)
    done = sweep(family, Axis.even("omega", 0.6, 0.63, 2), direction="up")
    (change,) = transitions(family, "omega", done.points)
    assert change.kind == UNDECIDED
    assert 0.6 <= change.lower <= 0.61
    assert 0.62 <= change.upper <= 0.63


def test_only_points_on_the_branch_are_taken_as_they_are():
    """One of them a tenth of a step beside it, or of another label, is solved for: it is on the branch."""
    points = sweep(pair(), Axis.even("omega", 0.9, 0.98, 9)).points
    rows = [Bare(p.value, p.label, p.period, p.state) for p in points]
    assert transitions(pair(), "omega", rows) == ()
    step = rows[4].state - rows[3].state
    moved = [*rows[:4], replace(rows[4], state=rows[4].state + 0.1 * step), *rows[5:]]
    assert transitions(pair(), "omega", moved) == ()  # it is near to its orbit, which is solved for
    named = [*rows[:4], replace(rows[4], label=Signature(1, 0)), *rows[5:]]
    assert transitions(pair(), "omega", named) == ()


@pytest.mark.parametrize(
    ("below", "above", "kind"),
    [
        ("1-0-0", "1-1-0", JUMP),
        ("1-0-0", "aperiodic", APERIODIC),
        ("unresolved", "1-0-0", UNPROVED),
        ("neutral", "1-0-0", UNPROVED),
        ("aperiodic", "unresolved", UNPROVED),
    ],
)
def test_what_was_not_proved_aperiodic_is_not_called_so(below: str, above: str, kind: str):
    one, two = (Bare(0.0, read_label(text), int(text[0] == "1"), np.zeros(2)) for text in (below, above))
    assert unlocated(one, two) == kind
    assert unlocated(two, one) == kind


@pytest.mark.parametrize("count", [3, 41])
@pytest.mark.parametrize("rising", [True, False])
def test_along_one_branch_the_motion_is_followed_once(rising, count, monkeypatch):
    """However many points lie on it."""
    begun: list[float] = []
    module = sys.modules["gearlash.studies.transitions"]
    original = module.walk

    def counted(family, values, name, orbit, to, *, longest, settings):
        begun.append(values[name])
        return original(family, values, name, orbit, to, longest=longest, settings=settings)

    monkeypatch.setattr(module, "walk", counted)
    points = sweep(pair(), Axis.even("omega", 0.9, 0.92, count)).points
    assert len({p.label for p in points}) == 1
    assert transitions(pair(), "omega", points, rising=rising) == ()
    assert begun == [points[0 if rising else -1].value]
