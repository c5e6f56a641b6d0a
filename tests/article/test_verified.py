"""What the report says of the pair with real teeth follows from the data that are kept."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import gearlash as gl
from gearlash.article.report import teeth
from gearlash.article.report import verified as section_of
from gearlash.article.verified import REPORTED, Verified, VerifiedBreathing, VerifiedLines, kept, verified
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


def conclusion(found: Verified) -> str:
    note = next(block for block in section_of._conclusion(found) if isinstance(block, Note))
    return words(note.text)


def test_the_conclusion_says_where_a_moving_centre_distance_makes_the_agreement():
    assert "with it held, the motion is another one at 3600 rpm (not periodic)." in conclusion(kept())
    ways = tuple(
        replace(
            way,
            breathing=tuple(
                replace(moved, label_held=point.label)
                for moved, point in zip(way.breathing, way.points, strict=True)
            ),
        )
        for way in kept().ways
    )
    assert "held" not in conclusion(replace(kept(), ways=ways))


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


def with_pictures() -> Verified:
    """The kept data with a small set of what pictures of teeth need."""
    rolls = np.linspace(0.012, 0.03, 4 * 2 * 3)
    lines = VerifiedLines(
        97.0, (-0.02, 0.0, 0.02), (0.0, 0.25, 0.5, 0.75), (4, 2, 3), tuple(rolls), (9.0,) * 24
    )
    breath = VerifiedBreathing((-2.0, 7.0), (1.602, 1.604), (98.0, 104.0), "1-0-0", 0.05)
    ways = []
    for way in kept().ways:
        frames = tuple((k / 2, 0.1 * k, -0.04 * k, 1000.0 * k, 0.0) for k in range(2))
        more = {"orders": (0.0, 0.9), "lumped_orders": (1.0,), "lumped_amplitudes": (0.8,), "frames": frames}
        points = tuple(replace(point, **more) for point in way.points)
        ways.append(replace(way, points=points, breathing=(breath,) * len(points)))
    return replace(kept(), ways=tuple(ways), pictured="absolute", lines=lines)


def test_pictures_of_teeth_are_those_that_the_data_have():
    case, full = gl.load_case("article"), with_pictures()
    blocks, pictures = teeth.drawn(case, full)
    assert [each.stem for each in pictures] == [teeth.ORDERS, teeth.FRAMES, teeth.LINES]
    figures = [each.draw(*each.arguments) for each in pictures]
    assert len(figures[0].axes) == sum(len(way.points) for way in full.ways)
    assert [axes.get_title("left") for axes in figures[1].axes] == ["phase 0.00", "phase 0.50"]
    table = next(block for block in blocks if isinstance(block, Table))
    assert table.rows[0][2:6] == ("−2.0 to 7.0 µm", "1.6020 to 1.6040", "98.0 to 104.0 µm", "+5.0 %")
    bare = replace(full, lines=None, ways=tuple(replace(way, breathing=()) for way in full.ways))
    blocks, pictures = teeth.drawn(case, bare)
    assert [each.stem for each in pictures] == [teeth.ORDERS]
    assert not any(isinstance(block, Table) for block in blocks)


def test_the_kept_data_have_what_pictures_need():
    found = kept()
    assert found.lines is not None
    assert len(found.lines.loads) == np.prod(found.lines.shape)
    assert found.pictured in [way.name for way in found.ways]
    for way in found.ways:
        assert len(way.breathing) == len(way.points)
