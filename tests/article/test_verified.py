"""What the report says of the pair with real teeth follows from the data that are kept."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import gearlash as gl
from gearlash.article import verifying
from gearlash.article.report import (
    conclusion,
    lumped_beside,
    seen,
    settings_beside,
    summary,
    teeth,
    when_fixed,
    window,
)
from gearlash.article.report import verified as section_of
from gearlash.article.verified import (
    Verified,
    VerifiedBreathing,
    VerifiedLines,
    VerifiedWay,
    kept,
    verified,
)
from gearlash.report.blocks import Bullets, Note, Section, Table, Text


def reproduced(case: gl.Case, *labels: str) -> Any:
    """As much of a reproduction as the section asks for: the lumped model of the case has these labels."""
    speeds = [
        SimpleNamespace(value=omega, label=label) for omega, label in zip((0.9, 1.0), labels, strict=False)
    ]
    return SimpleNamespace(case=case, rules=(SimpleNamespace(stated=True, speeds=speeds),) if labels else ())


def section(case: gl.Case) -> Section | None:
    found = section_of.section(reproduced(case))
    return None if found is None else found[0]


def words(text: Text) -> str:
    return "".join(part if isinstance(part, str) else getattr(part, "text", "") for part in text.parts)


def test_the_data_belong_to_the_case_as_it_comes():
    assert verified(gl.load_case("article")) is kept()
    assert section(gl.load_case("article", {"backlash": "90 um"})) is None


def test_this_code_computes_what_is_kept_with_bearings_as_far_apart_as_the_case_has_them():
    """So the command `verify article` computes with what the kept data have, and no other distance passes."""
    pytest.importorskip("exudyn")
    case, check = gl.load_case("article"), kept().check
    assert {v.text for v in case.values() if v.path.endswith(".bearing_span")} == {"150 mm"}
    assert "they are those of the code" in verifying.checked(case, check)
    nearer = {f"{gear}.bearing_span": "113 mm" for gear in ("pinion", "gear")}
    assert "they differ by up to" in verifying.checked(gl.load_case("article", nearer), check)


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
    done = reproduced(gl.load_case("article"))
    for found, checked, begins in (
        (replace(kept(), in_run=True), "", "All numbers of this section were computed in this run"),
        (None, "A check said so.", "The numbers of this section are kept"),
    ):
        made_now = section_of.section(done, found, checked)
        assert made_now is not None
        text = words(made_now[0].blocks[0])  # pyright: ignore[reportArgumentType]
        assert text.startswith(begins)
        assert checked in text


def text_of(found: Verified, *labels: str) -> str:
    """Conclusion, what it rests on, and how both models compare."""
    blocks = conclusion.blocks(found, reproduced(gl.load_case("article"), *labels))
    said = [words(block.text) for block in blocks if isinstance(block, Note)]
    said += [words(item) for block in blocks if isinstance(block, Bullets) for item in block.items]
    return " ".join([*said, *(words(block) for block in blocks if isinstance(block, Text))])


def named(name: str) -> VerifiedWay:
    return next(way for way in kept().ways if way.name == name)


def test_the_conclusion_names_the_inputs_with_the_reported_motion():
    """First what the case's dimensionless numbers give, then where teeth do as is reported."""
    said = text_of(kept())
    assert said.startswith("In short: real teeth part and stay in contact as the article reports with ")
    assert "With the dimensionless numbers of the case held" in said.partition("as reported")[0]
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
    way = named("absolute")
    lower, higher = way.points
    kept_on = replace(way, points=(replace(lower, label="1-1-0"), replace(higher, label="kept", apart=0.0)))
    other = replace(way, points=(replace(lower, label="2-1-0"), higher))
    assert conclusion.agreeing(replace(kept(), ways=(kept_on, other))) == [kept_on]


def test_the_conclusion_says_what_settings_do_whether_the_motion_is_the_reported_one_or_not():
    """Of each speed: how many part or stay as planned, how many have the label, and which do not."""
    way = named("absolute")
    low, high = (point.speed for point in way.points)
    points = (
        replace(way.points[0], label="1-1-0", apart=0.1),
        replace(way.points[1], label="1-0-0", apart=0.0),
    )
    rows = (
        ("one", low, "1-1-0", 0.2),
        ("two", low, "1-0-0", 0.0),
        ("three", low, "none", 0.4),
        ("one", high, "kept", 0.0),
        ("two", high, "none", 0.3),
    )
    agreeing = replace(way, points=points, beside=rows)
    said = text_of(replace(kept(), ways=(agreeing,)))
    assert f"at {low:.0f} rpm teeth part with 2 of 3, and the label is 1-1-0 with 1 (with one);" in said
    assert f"at {high:.0f} rpm contact is kept with 1 of 2 (not with two (not repeating, apart 30 %))" in said
    still = tuple(replace(point, label="1-0-0", apart=0.0) for point in points)
    other = replace(way, name="stiffness", points=still, beside=(("two", low, "1-1-0", 0.2),))
    said = text_of(replace(kept(), ways=(other, agreeing)))
    assert f"“stiffness”: at {low:.0f} rpm contact is kept with 0 of 1" in said


def test_settings_with_both_reported_motions_are_counted_of_every_way():
    """Parting once a cycle at the lower speed and contact at the higher one, by the same setting; a way with
    none is told, too."""
    way = named("stiffness")
    low, high = (point.speed for point in way.points)
    still = tuple(replace(point, label="1-0-0", apart=0.0) for point in way.points)
    rows = (
        ("both", low, "1-1-0", 0.1),
        ("both", high, "kept", 0.0),
        ("lower alone", low, "1-1-0", 0.1),
        ("lower alone", high, "none", 0.2),
        ("other label", low, "2-1-0", 0.1),
        ("other label", high, "1-0-0", 0.0),
    )
    first = replace(way, points=still, beside=rows)
    short = replace(first, name="modified", beside=rows[2:4])
    said = text_of(replace(kept(), ways=(first, replace(first, name="other", beside=rows[2:]), short)))
    assert (
        "Settings beside with both reported motions: 1 of 3 with “stiffness” (both), 0 of 2 with “other”, 0 "
        "of the 1 run with “modified”." in said
    )


def test_two_bodies_that_bend_are_told_with_what_they_turn_round():
    """One way has the reverse of what is reported, one loses its agreement, one keeps it."""
    name = next(each["name"] for each in kept().settings if each["flexible_pinion"] == "True")
    labels = {"stiffness": ("kept", "none"), "absolute": ("1-0-0", "1-0-0"), "other": ("1-1-0", "kept")}
    agreed = named("absolute")
    ways = []
    for which, (lower, higher) in labels.items():
        points = (
            replace(agreed.points[0], label="1-1-0", apart=0.1),
            replace(agreed.points[1], label="kept", apart=0.0),
        )
        rows = [
            (name, point.speed, label, 0.2 if label in ("none", "1-1-0") else 0.0)
            for point, label in zip(points, (lower, higher), strict=True)
        ]
        ways.append(replace(agreed, name=which, points=points, beside=tuple(rows)))
    said = text_of(replace(kept(), ways=tuple(ways)))
    low, high = (f"{point.speed:.0f} rpm" for point in agreed.points)
    assert f"1 of the 3 inputs tried has both motions: “stiffness” has the reverse, contact at {low}" in said
    assert f"parting at {high}; “absolute” loses its agreement, contact at both speeds;" in said
    assert f"“other” has parting at {low} and contact at {high}." in said
    faster = [replace(point, speed=1.5 * point.speed) for point in agreed.points]
    rows = [(name, point.speed, "1-0-0", 0.0) for point in faster]
    held = replace(agreed, name="dimensionless", points=tuple(faster), beside=tuple(rows))
    assert said.count("The shaft of that pinion is assumed. ") == 1
    assert (
        "The shaft of that pinion is assumed. Modes of bodies keep their Hz: beside them the mesh frequency "
        "is higher than in the case, with “dimensionless” 1.5 times as high."
    ) in text_of(replace(kept(), ways=(*ways, held)))


def test_the_rule_for_agreement_and_the_label_alone_are_both_counted():
    way = named("absolute")
    lower, higher = replace(way.points[0], label="1-1-0", apart=0.1), replace(way.points[1], apart=0.0)
    for label, count in (("kept", 0), ("1-0-0", 1)):
        one = replace(way, points=(lower, replace(higher, label=label)))
        found = replace(kept(), ways=(one,))
        assert len(conclusion.by_label(found)) == count
        said = text_of(found)
        assert (
            "with 1 of 1 ways to hold the inputs, begun with teeth pressed together (“absolute” at ω " in said
        )
        assert (
            f"By the label alone, the rule at first, {count} of 1 agree as mesh cycles are compared now"
            in said
        )


def test_what_was_fixed_after_something_was_seen_is_what_the_data_have():
    """The grid of the window and the steps named there are those of the kept data."""
    fixed = " ".join(what for _, what in when_fixed.FIXED)
    speeds, higher = kept().ways[0].window["speed"], kept().ways[0].points[-1].speed
    one = next(each for each in kept().settings if each["name"] == "window")
    planned = next(each for each in kept().settings if each["name"] == "as planned")
    ends = f"from {speeds[0] / higher:.2f} to {speeds[-1] / higher:.2f} in place"
    assert f"({len(speeds)} speeds {ends}" in fixed
    assert f"{one['steps']} steps for 160, {one['settle']} cycles to settle for 40" in fixed
    assert f"{planned['steps']} steps a mesh cycle for 256" in fixed
    assert f"{planned['read']} read for 24" in fixed
    assert f"{planned['settle']} mesh cycles in place of 60" in fixed
    assert f"up to {int(planned['steps']) * int(planned['finest'])} steps" in fixed


def test_impacts_and_the_balance_of_energy_are_told_where_they_are_kept():
    point = replace(named("absolute").points[0], label="none", apart=0.2)
    lines = section_of._seen(replace(point, impacts=1.3, back_impacts=0.25))
    assert "impacts a mesh cycle: 1.3, 0.25 on the back side" in lines
    still = replace(point, label="1-0-0", apart=0.0, impacts=0.0, back_impacts=0.0)
    assert not any("impacts" in str(line) for line in section_of._seen(still))
    way = replace(named("absolute"), points=(replace(point, energy_residual=-2e-3),))
    said = words(section_of._limits(replace(kept(), ways=(way,))).text)
    assert "of these 1 motions at most 2.0 × 10⁻³ of what dampers take" in said


def test_how_nearly_a_motion_without_a_label_repeats_is_told():
    point = replace(named("absolute").points[1], label="kept", apart=0.0, returns=0.011)
    assert section_of._seen(point)[0].endswith("not repeating within 1 % (misses itself by 1.1 %)")
    assert section_of._seen(replace(point, label="1-0-0"))[0] == "1-0-0"


def test_a_motion_whose_impacts_do_not_repeat_parts_and_has_no_label():
    assert seen.told("uneven") == "parts, impacts not repeating"
    assert seen.motion("uneven", 0.14) == "impacts not repeating, apart 14 %"
    assert seen.parts("uneven", 0.14)
    assert not seen.has_label("uneven")
    point = replace(named("absolute").points[0], label="uneven", apart=0.14, returns=0.004)
    assert section_of._seen(point)[0] == "parts, impacts not repeating (mean forces come back within 0.4 %)"


def test_a_share_of_time_apart_is_not_denied_by_a_label():
    assert seen.parts("1-0-0", 0.023)
    assert seen.motion("1-0-0", 0.023) == "1-0-0, apart 2.3 %"
    assert not seen.parts("1-0-0", 0.0)
    assert not seen.parts("1-0-0", None)


def test_contact_as_reported_without_its_period_is_said_to_lack_it():
    """And by how much, and where the reported label was found."""
    way = named("absolute")
    lower, higher = replace(way.points[0], label="1-1-0", apart=0.1), way.points[1]
    rows = (("one", higher.speed, "1-0-0", 0.0), ("two", higher.speed, "kept", 0.0))
    grid = {**way.window, "speed": (higher.speed, 1.1 * higher.speed)}
    grid |= {"up": ("1-0-0", "kept"), "down": ("kept", "1-0-0")}
    for label, lacks in (("kept", True), ("2-0-0", True), ("1-0-0", False)):
        points = (lower, replace(higher, label=label, apart=0.0, returns=0.011))
        one = replace(way, points=points, beside=rows, window=grid)
        said = text_of(replace(kept(), ways=(named("stiffness"), one)))
        lacking = f"as planned that at {higher.speed:.0f} rpm does not within 1 % (it misses itself by 1.1 %)"
        assert (lacking in said) == lacks
        found = "1-0-0 was found there from its neighbour on the grid (rising) and with 1 of 2 settings."
        assert (found in said) == lacks
        low, high = f"{lower.speed:.0f} rpm", f"{higher.speed:.0f} rpm"
        labels = f"labels at {low} and {high}"
        assert f"So the {f'label at {low} and the contact at {high}' if lacks else labels} agree" in said


def test_motions_that_coexist_are_both_told():
    """Pressed together teeth part; from the neighbour they stay in contact."""
    way = named("modified")
    low, high = (point.speed for point in way.points)
    points = tuple(replace(point, label="none", apart=0.3) for point in way.points)
    both = replace(way, points=points, up=f"{high - 100:.0f} to {high:.0f} rpm", down="nowhere on the grid")
    said = window.coexisting(kept(), both)
    assert f"rising, teeth stay in contact at {high:.0f} rpm (not repeating within 1 % after 30 " in said
    assert "mesh cycles): both motions were found there" in said
    assert f"at {low:.0f} rpm" not in said
    at = int(np.abs(np.array(way.window["speed"]) - high).argmin())
    labels = [*way.window["up"][:at], "2-0-0", *way.window["up"][at + 1 :]]
    repeating = replace(both, window={**way.window, "up": labels})
    assert f"at {high:.0f} rpm (2-0-0 after 30 mesh cycles)" in window.coexisting(kept(), repeating)
    assert window.coexisting(kept(), replace(both, up="nowhere on the grid")) == ""
    assert (
        window.coexisting(
            kept(), replace(both, points=tuple(replace(p, label="1-0-0", apart=0.0) for p in points))
        )
        == ""
    )


def test_the_ripple_is_blamed_only_where_the_lumped_model_changes_with_it():
    """The lumped model at held numbers stays in contact at both speeds; what the case itself does is
    varied."""
    held = tuple(named(name) for name in ("stiffness", "dimensionless"))
    quiet = dict.fromkeys(("always", "in-contact", "no-tension"), "1-0-0")
    still = tuple(
        replace(way, points=tuple(replace(p, label="1-0-0", apart=0.0, lumped=quiet) for p in way.points))
        for way in held
    )
    blamed = "these, put into the lumped model, are enough"
    found = replace(kept(), ways=still)
    assert f"So at ω 0.9 {blamed}" in text_of(found, "1-1-0", "1-0-0")
    assert blamed not in text_of(found, "1-0-0", "1-0-0")
    parting = replace(still[0].points[0], label="1-1-0", apart=0.1)
    unlike = replace(still[0], points=(parting, still[0].points[1]))
    said = text_of(replace(found, ways=(unlike, still[1])), "1-1-0", "1-0-0")
    assert blamed not in said
    assert "parts or stays as they do at 3 of 4 points" in said


def test_ends_of_windows_are_set_beside_the_reported_ones():
    """A step of the grid is 2 % of the higher speed; the reported end has to lie in the step beyond the last
    speed in contact."""
    way = named("stiffness")
    low, high = window.reported_ends(kept(), way) or (0.0, 0.0)
    assert low / high == pytest.approx(0.973 / 1.112)
    step = 0.02 * way.points[-1].speed
    rules = ("always", "in-contact", "no-tension")
    for begins, lower_met in ((low + 0.5 * step, 1), (low - 0.5 * step, 0), (low + 1.5 * step, 0)):
        told = f"{begins:.0f} to {high - 0.5 * step:.0f} rpm"
        lumped = dict.fromkeys(rules, "nowhere on the grid")
        one = replace(way, up=told, down=told, lumped_up=lumped, lumped_down=lumped)
        *_, said = window.blocks(replace(kept(), ways=(one,)))
        assert isinstance(said, Text)
        assert (
            f"the lower end with {2 * lower_met} of 2 windows of real teeth, and with 0, 0, 0 of 2"
            in words(said)
        )
        assert "the upper end with 2 of 2 windows of real teeth" in words(said)
    one = replace(one, down="nowhere on the grid")
    *_, said = window.blocks(replace(kept(), ways=(one,)))
    assert isinstance(said, Text)
    assert words(said).count("nowhere on the grid") == 1
    assert "of 2 windows of real teeth (with 1 of them teeth stay in contact nowhere on the grid)" in words(
        said
    )


def test_every_setting_of_the_plan_has_its_row():
    (table,) = settings_beside.blocks(kept())
    assert isinstance(table, Table)
    names = [row[0] for row in table.rows]
    assert len(set(names)) == len(names)
    planned = {each["name"] for each in kept().settings} - {"window"}
    assert planned | {row[0] for way in kept().ways for row in way.beside} == set(names)


def test_the_table_of_settings_says_how_long_motions_settle():
    """How many that did not come back went on, and for how long, of all that the table has."""
    planned = next(each for each in kept().settings if each["name"] == "as planned")
    planned, way = {**planned, "settle": "80", "read": "20", "longest": "12"}, named("absolute")
    for cycles, said in (
        (
            (80, 187, 80, 133),
            " (more, 187 at most, for 2 of the 4 motions of this table: of those "
            "that had not come back after one cycle, the ones in which the slowest vibration of bodies "
            "had not faded yet) and 20 that are read",
        ),
        ((80, 80), " (enough for all 2 motions of this table) and 20 that are read"),
    ):
        one = replace(way, settled=tuple(("as planned", 3600.0, each) for each in cycles))
        (table,) = settings_beside.blocks(replace(kept(), settings=(planned,), ways=(one,)))
        assert isinstance(table, Table)
        assert f"80 mesh cycles to settle{said}" in str(table.caption)


def test_every_motion_of_the_table_of_settings_has_the_cycles_that_it_settled():
    for way in kept().ways:
        of = [(row[0], row[1]) for row in way.settled]
        planned = [("as planned", point.speed) for point in way.points]
        assert sorted(of) == sorted([*planned, *((row[0], row[1]) for row in way.beside)])


def test_what_flanks_make_of_the_error_under_load_is_said_where_relief_is_spoken_of():
    made = (6.149, 2.217, 0.931)
    modified = replace(named("modified"), errors_under_load=made)
    found = replace(kept(), ways=(named("stiffness"), modified))
    assert "beside it the flanks make 6.15, 2.22 and 0.931 µm at these orders" in words(
        section_of._ways(found).items[1]
    )
    assert "an error of their own under load (6.15, 2.22 and 0.931 µm at the first three mesh" in text_of(
        found
    )


def test_relief_makes_more_error_under_load_than_flanks_without_it():
    plain, relieved = named("absolute").errors_under_load, named("modified").errors_under_load
    assert len(plain) == len(relieved) == 3
    assert max(relieved) > 2.0 * max(plain)


def test_the_summary_tells_with_how_many_inputs_both_reported_motions_were_found():
    agree, ways = conclusion.agreeing(kept()), kept().ways
    said = words(summary._real(kept()))
    assert f"with {len(agree)} of {len(ways)} ways to hold the inputs" in said


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
    assert lumped_beside.same(points, "always") == 3


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
