"""The report's part on branches: every sentence is made from the records of the run."""

from __future__ import annotations

from dataclasses import replace

import pytest

from article.study import small
from gearlash.article import Reproduction
from gearlash.article.report import branches, document
from gearlash.article.report.coexistence import chains, counted, sentences
from gearlash.article.reproduction import Scan
from gearlash.report.blocks import Page
from gearlash.report.page import html
from report.reading import Reading

DRAWING = b'<svg width="510pt" height="9pt" viewBox="0 0 510 9" xmlns="http://www.w3.org/2000/svg"></svg>'


def backlash() -> Scan:
    return next(scan for scan in small().scans if scan.parameter == "D")


def read(done: Reproduction) -> Reading:
    section, pictures = branches.section(done)
    return Reading(html(Page("", "", (section,)), {picture.stem: DRAWING for picture in pictures}))


@pytest.fixture(scope="module")
def page() -> Reading:
    return read(small())


def test_the_page_is_sound(page: Reading):
    assert page.problems == []


@pytest.mark.parametrize("parameter", ["omega", "D"])
def test_every_change_of_the_sweeps_stands_there_as_a_special_point(page: Reading, parameter: str):
    (scan,) = [scan for scan in small().scans if scan.parameter == parameter]
    assert scan.events
    for event in scan.events:
        assert event.special is not None
        assert f"{event.value:.10g} {event.kind}" in page.text
    assert f"{scan.on_branches} of {scan.attractors} periodic attractors" in page.text
    assert f"{len(scan.events)} of {len(scan.events)} located changes" in page.text


def test_coexistence_is_told_by_what_bounds_it(page: Reading):
    assert "3-3-1 is stable from D = 0.4521586 (its period doubling) to 0.4854106 (its fold)." in page.text
    joins = "to 0.4521586 (joins the orbit of period 3 at its doubling)."
    assert f"6-6-2 is stable from D = 0.44 (end of the sweep) {joins}" in page.text
    assert "6-6-2 and 3-3 up to 0.4521586; 3-3 and 3-3-1 up to 0.4854106." in page.text
    assert "Followed upwards, 3-3-1 is left at the fold at D = 0.4854106, for 3-3." in page.text


def test_the_sentences_follow_the_numbers():
    scan = backlash()
    moved = tuple(replace(each, upper=0.4712345) if each.upper < 0.49 else each for each in scan.stretches)
    said = str(sentences(replace(scan, stretches=moved)))
    assert "to 0.4712345 (its fold)" in said
    assert "0.4854106 (its fold)" not in said


def test_nothing_is_said_to_coexist_where_nothing_does():
    (only,) = sentences(replace(backlash(), together=()))
    assert "no two stable motions lie side by side" in str(only)


def test_neighbouring_intervals_are_one_if_a_motion_goes_through():
    (chain,) = chains(backlash())
    assert len(chain.intervals) == 2
    apart = replace(chain.intervals[1], lower=0.46)
    assert len(chains(replace(backlash(), together=(chain.intervals[0], apart)))) == 2


def test_what_is_not_matched_or_not_followed_is_said():
    scan = backlash()
    lost = replace(scan.events[0], special=None, branch=-1)
    changed = replace(scan, events=(lost, *scan.events[1:]), left=("9-9-9 from D = 0.5: lost",))
    assert f"{len(scan.events) - 1} of {len(scan.events)} located changes" in counted(changed)
    seen = read(replace(small(), scans=(changed,)))
    assert "none of these branches has it" in seen.text
    assert "Not followed: 9-9-9 from D = 0.5: lost." in seen.text


def test_a_study_without_scans_has_no_such_part():
    page, _ = document(replace(small(), scans=()))
    assert "branches" not in [section.id for section in page.sections]


def test_ends_of_zones_name_the_special_point_that_they_are():
    whole, pictures = document(small())
    seen = Reading(html(whole, {picture.stem: DRAWING for picture in pictures}))
    assert seen.problems == []
    assert "fold of 3-3-1 (branch" in seen.text
    assert "grazing of 1-1, 1-0 (branch" in seen.text


def test_events_tell_the_law_of_their_touch():
    found = [event for event in small().events if event.found]
    assert found
    assert all(event.law is not None for event in found)


def test_a_value_between_special_points_is_none_of_them():
    special = backlash().events[0].special
    assert special is not None
    found = backlash().special_at(special.value * (1.0 + 1e-12))
    assert found is not None
    assert found[1].value == pytest.approx(special.value, rel=1e-9)
    assert backlash().special_at(special.value * (1.0 + 1e-6)) is None
