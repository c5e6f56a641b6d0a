"""What is assured between neighbouring orbits: up to a touch, and not up to a fold."""

from __future__ import annotations

import numpy as np
import pytest

import gearlash as gl
from gearlash.studies.arcs import arcs_of
from gearlash.studies.assured import At, assured
from gearlash.studies.follow_tasks import Question
from gearlash.studies.followed import Followed
from gearlash.studies.model import Source

CASE = gl.load_case("kahraman-singh")


@pytest.fixture(scope="module")
def followed() -> Followed:
    question = Question(Source.of(CASE), (), "omega", 0.6, 1.6, gl.Settings())
    branch = gl.continue_branch(
        CASE, "omega", lower=0.6, upper=1.6, values={"omega": 1.5}, steps=gl.ContinuationSettings(longest=0.3)
    )
    found = Followed(question, gl.Execution())
    found.branches.append(branch)
    found.arcs.extend(arcs_of(branch))
    return found


def test_all_of_an_arc_between_limits_and_touches_is_assured(followed: Followed):
    free = [arc for arc in followed.stable if arc.label == "1-0-0"]
    found = assured(followed, [(arc, 0.6, 1.6) for arc in free])
    assert sorted(found.values()) == [(arc.lower.value, arc.upper.value) for arc in sorted(free, key=_lower)]


def test_a_fold_is_never_reached(followed: Followed):
    """There a multiplier is 1: what is assured ends before it, and as near as its step allows."""
    (arc,) = (arc for arc in followed.stable if arc.lower.kind == "fold")
    ((low, _),) = assured(followed, [(arc, 0.6, 0.8)]).values()
    assert arc.lower.value < low < arc.lower.value + 1e-3


def at(value: float, monodromy: np.ndarray) -> At:
    return At(value, np.zeros(2), monodromy)


def test_a_monodromy_that_strays_leaves_no_room():
    """Multipliers 0.9 at both ends, and 1.1 in the middle: nothing is assured; on the line, all is."""
    ends, high = at(0.0, 0.9 * np.eye(2)), at(0.5, 1.1 * np.eye(2))
    assert not ends.leaves_room(at(1.0, 0.9 * np.eye(2)), high)
    assert ends.leaves_room(at(1.0, -0.9 * np.eye(2)), at(0.5, 0.0 * np.eye(2)))


def _lower(arc: object) -> float:
    return arc.lower.value  # pyright: ignore[reportAttributeAccessIssue]
