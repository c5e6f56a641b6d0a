"""What the report says of the pair with real teeth follows from the data that are kept."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import gearlash as gl
from gearlash.article.report import verified as section_of
from gearlash.article.verified import REPORTED, kept, verified
from gearlash.report.blocks import Note, Section, Table, Text


def section(case: gl.Case) -> Section | None:
    done: Any = SimpleNamespace(case=case)
    found = section_of.section(done)
    return None if found is None else found[0]


def words(text: Text) -> str:
    return "".join(part if isinstance(part, str) else getattr(part, "text", "") for part in text.parts)


def test_the_data_belong_to_the_case_as_it_comes():
    assert verified(gl.load_case("article")) is kept()
    assert section(gl.load_case("article", {"backlash": "90 um"})) is None


def test_the_conclusion_names_the_inputs_with_the_reported_motion():
    shown = section(gl.load_case("article"))
    assert shown is not None
    notes = {b.title: words(b.text) for b in shown.blocks if isinstance(b, Note)}
    for way in kept().ways:
        as_reported = tuple(point.label for point in way.points) == REPORTED
        first, _, rest = notes["Conclusion"].partition(", and not with")
        assert f"“{way.name}”" in (first if as_reported else rest)
    assert "Friction is in neither model" in notes["What this rests on"]


def test_every_point_has_its_row():
    shown = section(gl.load_case("article"))
    assert shown is not None
    table = next(b for b in shown.blocks if isinstance(b, Table))
    assert len(table.rows) == sum(len(way.points) for way in kept().ways)


@pytest.mark.parametrize("way", kept().ways, ids=lambda way: way.name)
def test_forces_are_those_of_the_labels(way):
    """Where teeth part, the force of real teeth is zero for a time; its mean over whole cycles is one."""
    for point in way.points:
        if point.label.endswith("-0-0"):
            assert min(point.force) > 0.0
            assert point.apart == 0.0
        if point.label != "none":
            assert np.mean(point.force) == pytest.approx(1.0, abs=0.02)
