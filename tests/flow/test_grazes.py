"""Near-touches of a boundary: none missed, none invented.

2,000 here; `GEARLASH_GRAZES=100000 pytest -n 0 tests/flow/test_grazes.py` is the bar of the design.
"""

from __future__ import annotations

import os
from functools import lru_cache

import numpy as np
import pytest

from gearlash import flow
from gearlash.system import Status
from oracles.compare import distance

GRAZES = int(os.environ.get("GEARLASH_GRAZES", "2000"))


@pytest.mark.parametrize("pair", ["spur", "helical"])
def test_grazes_built_backwards_from_the_extremum(oracle, pair):
    """Depths from 1e-3 to 1e-10, short of and beyond either boundary, approached from both sides."""
    from oracles.grazes import grazes

    propagators = lru_cache(maxsize=1)(flow.propagators)  # many grazes in a row share a system
    worst_time, deepest = 0.0, 0.0
    for graze in grazes(20240501, GRAZES // 2, pair, oracle(pair)):
        trace = flow.trace(propagators(graze.system), graze.start, graze.span, graze.phase)
        far = distance(graze.system, trace, graze.truth)
        where = f"depth {graze.depth:.3e}, curvature {graze.curvature:.3e}, phase {graze.extremum_phase!r}"
        assert trace.status is Status.OK, where
        assert far.same_crossings, where
        assert far.same_extrema, where
        assert far.event_time < 1.0, where
        assert far.state < 1e-12, where
        # A trace expands every cell. What marches passes over cells that it has proved to be clear.
        carried = flow.carry(propagators(graze.system), graze.start, graze.span, graze.phase)
        assert carried.contacts.tolist() == graze.truth.contacts, where
        assert np.abs(carried.state - trace.end).max() < 1e-12 * max(1.0, np.abs(trace.end).max()), where
        assert abs(_depth(graze, trace.extrema) - graze.depth) < 2e-13, where
        worst_time, deepest = max(worst_time, far.event_time), max(deepest, -np.log10(abs(graze.depth)))
    assert deepest > 9.9
    assert worst_time > 0.0


def test_depths_near_rounding_are_decided_rightly_or_not_at_all(oracle):
    """Between 1e-15 and 1e-13 some cannot be decided: their status says so, and no sure answer is wrong."""
    from oracles.grazes import grazes

    uncertain = 0
    for graze in grazes(3, 300, "helical", oracle("helical"), depths=(1e-15, 1e-13)):
        props = flow.propagators(graze.system)
        trace = flow.trace(props, graze.start, graze.span, graze.phase)
        far = distance(graze.system, trace, graze.truth)
        carried = flow.carry(props, graze.start, graze.span, graze.phase)
        assert carried.status is Status.UNCERTAIN or carried.contacts.tolist() == graze.truth.contacts
        uncertain += trace.status is Status.UNCERTAIN
        assert trace.status is Status.UNCERTAIN or far.same_crossings
        assert far.state < 1e-12
    assert 0 < uncertain < 200


def _depth(graze, extrema) -> float:
    """Depth of the built extremum as the trace has it."""
    clearance = graze.system.clearances[0]
    level = clearance.gap_plus if graze.boundary > 0 else -clearance.gap_minus
    beyond = -graze.boundary if graze.from_contact else graze.boundary
    nearest = np.argmin(np.abs(extrema.phase - graze.extremum_phase))
    return beyond * (extrema.displacement[nearest] - level)
