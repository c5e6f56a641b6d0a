"""What the report says of the pair with real teeth follows from the data that are kept."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import gearlash as gl
from gearlash.article.report import conclusion, teeth
from gearlash.article.report import verified as section_of
from gearlash.article.verified import Verified, VerifiedBreathing, VerifiedLines, kept, verified
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


def test_the_first_sentence_says_where_the_numbers_come_from():
    shown = section(gl.load_case("article"))
    assert shown is not None
    first = words(shown.blocks[0])  # pyright: ignore[reportArgumentType]
    made = kept().computed
    assert first.startswith("The numbers of this section are kept and were not computed in this run: ")
    for part in (
        kept().gearlash,
        made["commit"],
        made["day"],
        "make verified",
        "gearlash reproduce --verify",
    ):
        assert part in first
    done: Any = SimpleNamespace(case=gl.load_case("article"))
    for found, checked, begins in (
        (replace(kept(), in_run=True), "", "All numbers of this section were computed in this run"),
        (None, "A check said so.", "The numbers of this section are kept"),
    ):
        made_now = section_of.section(done, found, checked)
        assert made_now is not None
        text = words(made_now[0].blocks[0])  # pyright: ignore[reportArgumentType]
        assert text.startswith(begins)
        assert checked in text


def text_of(found: Verified) -> str:
    note = next(block for block in conclusion.blocks(found) if isinstance(block, Note))
    return words(note.text)


def test_the_conclusion_names_the_inputs_with_the_reported_motion():
    """First what the article's dimensionless numbers give, then where teeth do as is reported."""
    said = text_of(kept())
    assert said.startswith("With the article’s dimensionless numbers held")
    assert "“stiffness”" in said.partition("as reported")[0]
    agree = [way.name for way in conclusion.agreeing(kept())]
    for way in kept().ways:
        as_reported = f"as reported with the inputs “{way.name}”" in said
        assert as_reported == (way.name in agree)
    none = tuple(
        replace(way, points=tuple(replace(p, label="2-1-0") for p in way.points)) for way in kept().ways
    )
    assert "With none of the inputs" in text_of(replace(kept(), ways=none))


def test_contact_that_does_not_repeat_is_the_reported_contact_and_another_label_is_not():
    way = next(way for way in kept().ways if way.name == "absolute")
    lower, higher = way.points
    kept_on = replace(way, points=(replace(lower, label="1-1-0"), replace(higher, label="kept", apart=0.0)))
    other = replace(way, points=(replace(lower, label="2-1-0"), higher))
    assert conclusion.agreeing(replace(kept(), ways=(kept_on, other))) == [kept_on]


def test_the_conclusion_says_with_which_settings_an_agreement_is_lost():
    way = next(way for way in kept().ways if way.name == "absolute")
    low, high = (point.speed for point in way.points)
    points = (
        replace(way.points[0], label="1-1-0", apart=0.1),
        replace(way.points[1], label="1-0-0", apart=0.0),
    )
    rows = (
        ("one", low, "1-1-0", 0.2),
        ("two", low, "1-0-0", 0.0),
        ("one", high, "kept", 0.0),
        ("two", high, "none", 0.3),
    )
    said = text_of(replace(kept(), ways=(replace(way, points=points, beside=rows),)))
    assert f"the label 1-1-0 at {low:.0f} rpm is lost with 1 of 2 settings beside: two (1-0-0)" in said
    assert f"the contact at {high:.0f} rpm is lost with 1 of 2 settings beside: two (not periodic)" in said


def test_agreement_of_both_models_is_counted_for_parting_and_for_labels():
    point = kept().ways[0].points[0]
    points = [
        replace(point, label="1-1-0", apart=0.1, lumped={"always": "2-1-0"}, lumped_apart={"always": 0.3}),
        replace(point, label="kept", apart=0.0, lumped={"always": "1-0-0"}, lumped_apart={"always": 0.0}),
        replace(point, label="none", apart=0.2, lumped={"always": "1-0-0"}, lumped_apart={"always": 0.0}),
        replace(
            point, label="none", apart=0.2, lumped={"always": "aperiodic"}, lumped_apart={"always": None}
        ),
    ]
    assert conclusion.same(points, "always") == 3


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
