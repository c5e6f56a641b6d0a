"""Near-touches of every surface of the class: none missed, none invented.

400 here. `GEARLASH_GRAZES=100000 pytest -n 0 tests/flow/test_touches.py` takes a fifth of that number besides
the 100,000 of `test_grazes.py`: in-contact and no-tension, one to three clearances, touches of what presses.
"""

from __future__ import annotations

import os
from functools import lru_cache

import numpy as np
import pytest

from gearlash import flow
from gearlash.system import ContactRule, Status
from oracles.matches import match

pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
from oracles.touches import touches

TOUCHES = int(os.environ.get("GEARLASH_GRAZES", "2000")) // 5

DRAWS = {
    "always": (1, (1, 2, 3), (ContactRule.ALWAYS,), 1),
    "in-contact": (2, (1, 2, 3), (ContactRule.IN_CONTACT,), 3),
    "no-tension": (3, (1, 2, 3), (ContactRule.NO_TENSION,), 4),
    "mixed": (4, (2, 3), tuple(ContactRule), 2),
}


@pytest.mark.slow
@pytest.mark.parametrize("draw", DRAWS)
def test_touches_built_backwards_from_the_extremum(draw):
    """Depths from 1e-3 to 1e-10 short of and beyond zero, of δ and of P, with another clearance at its own
    boundary at the same time in many."""
    seed, clearances, rules, tenths = DRAWS[draw]
    propagators = lru_cache(maxsize=1)(flow.propagators)
    seen = {"deep": 0.0, "early": 0, "companion": 0, "known": 0}
    for touch in touches(seed, TOUCHES * tenths // 10, clearances, rules):
        props = propagators(touch.system)
        trace = flow.trace(props, touch.start, touch.span, touch.phase)
        assert trace.status is Status.OK, touch.told
        far = match(touch.system, trace, touch.truth)
        assert far.holds(state=1e-12), f"{touch.told}: {far.told}"
        if touch.events is not None:
            assert touch.near(trace.events) == touch.events, touch.told
        carried = flow.carry(props, touch.start, touch.span, touch.phase)
        count = len(touch.system.clearances)
        assert carried.status is Status.OK, touch.told
        assert carried.contacts.reshape(-1, 4).tolist() == touch.truth.contacts(count), touch.told
        assert np.abs(carried.state - trace.end).max() < 1e-12 * max(1.0, np.abs(trace.end).max()), touch.told
        seen["deep"] = max(seen["deep"], -np.log10(abs(touch.depth)))
        seen["early"] += touch.early
        seen["companion"] += touch.companion is not None
        seen["known"] += touch.events is not None
    assert seen["deep"] > 9.5
    assert seen["known"] > TOUCHES * tenths // 40
    assert seen["early"] > 0 or ContactRule.NO_TENSION not in rules
    assert seen["companion"] > 0


def test_depths_near_rounding_are_decided_rightly_or_not_at_all():
    """Between 1e-15 and 1e-13 some cannot be decided: their status says so, and no sure answer is wrong. What
    judges them gives up on some draws too; this seed has none of those.
    """
    uncertain = 0
    for touch in touches(8, 80, depths=(1e-15, 1e-13)):
        props = flow.propagators(touch.system)
        trace = flow.trace(props, touch.start, touch.span, touch.phase)
        carried = flow.carry(props, touch.start, touch.span, touch.phase)
        far = match(touch.system, trace, touch.truth)
        assert {trace.status, carried.status} <= {Status.OK, Status.UNCERTAIN}
        assert trace.status is Status.UNCERTAIN or far.same_events, touch.told
        counts = touch.truth.contacts(len(touch.system.clearances))
        assert carried.status is Status.UNCERTAIN or carried.contacts.reshape(-1, 4).tolist() == counts
        assert far.state < 1e-12, touch.told
        uncertain += trace.status is Status.UNCERTAIN
    assert 0 < uncertain < 70
