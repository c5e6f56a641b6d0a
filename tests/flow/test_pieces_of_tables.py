"""Tables are built in calls that are short enough to be interrupted, and are the same bytes in any."""

from __future__ import annotations

import dataclasses
import sys

import numpy as np
import pytest

from gearlash import flow
from gearlash.flow import tables
from oracles.members import random_member

building = sys.modules["gearlash.flow.propagators"]
responding = sys.modules["gearlash.flow.responses"]


@pytest.mark.parametrize("states", [2, 5, 12])
def test_any_pieces_give_the_same_bytes(states: int, monkeypatch: pytest.MonkeyPatch):
    calls = []
    for room, name in ((responding, "respond"), (building, "assemble")):
        kernel = getattr(room, name)
        monkeypatch.setattr(room, name, lambda *a, of=kernel: calls.append(1) or of(*a))
    system, _ = random_member(np.random.default_rng(states), states, 2)
    heavier = dataclasses.replace(system, forcing=1.5 * system.forcing)
    found, counts = [], []
    for numbers in (10**9, 1):  # all cells at once, and each alone
        monkeypatch.setattr(tables, "NUMBERS_PER_CALL", numbers)
        props = flow.propagators(system)
        props.build(int(np.flatnonzero(props.tables.slot_of < 0)[0]))
        others = flow.propagators(heavier, reuse=props)
        responses = [(*(part.tobytes() for part in r[:2]), *r[2:]) for r in props.responses.values()]
        found.append((props.tables.memory.tobytes(), others.tables.memory.tobytes(), responses))
        counts.append(len(calls))
        calls.clear()
    assert found[0] == found[1]
    assert counts[1] > 5 * counts[0]


def test_a_linear_motion_is_the_same_bytes_in_any_pieces(monkeypatch: pytest.MonkeyPatch):
    system, _ = random_member(np.random.default_rng(7), 6, 1)
    found = []
    for numbers in (10**9, 1):
        monkeypatch.setattr(tables, "NUMBERS_PER_CALL", numbers)
        motion = flow.linear_motion(system, flow.PLUS)
        assert motion is not None
        found.append((motion.map.tobytes(), motion.beyond.tobytes(), motion.stiffness.tobytes()))
    assert found[0] == found[1]


def test_no_call_writes_more_than_it_may(monkeypatch: pytest.MonkeyPatch):
    """Of a slow system, which has many cells a period."""
    widths = []
    kernel = responding.respond
    monkeypatch.setattr(responding, "respond", lambda *a: widths.append(a[12] - a[11]) or kernel(*a))
    monkeypatch.setattr(tables, "NUMBERS_PER_CALL", 100_000)
    system, _ = random_member(np.random.default_rng(3), 4, 1)
    props = flow.propagators(dataclasses.replace(system, omega=1e-2))
    assert len(widths) > 4
    assert max(widths) * props.shape.slot / props.cells <= 100_000
