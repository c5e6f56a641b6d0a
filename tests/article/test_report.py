"""The article's report, from a small reproduction that was computed."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from math import nan
from pathlib import Path

import pytest

from article.study import small
from gearlash.article import NOT_FOUND, Reproduction
from gearlash.article.report import document, render
from gearlash.case import Provenance
from gearlash.case.edges import at_most, shown_edge
from gearlash.plots.regimes import short
from gearlash.report.data import as_json
from gearlash.report.page import html
from report.reading import Reading

DRAWING = b'<svg width="510pt" height="9pt" viewBox="0 0 510 9" xmlns="http://www.w3.org/2000/svg"></svg>'


def read(done: Reproduction) -> tuple[str, Reading]:
    """The page with a stand-in for every figure: what is said, not what is drawn."""
    page, pictures = document(done)
    text = html(page, {picture.stem: DRAWING for picture in pictures})
    return text, Reading(text)


def folded(text: str) -> str:
    return " ".join(re.sub(r"([A-Za-zΑ-ω])_([A-Za-zα-ω0-9]{1,2})(?!\w)", r"\1\2", text).split())


@pytest.fixture(scope="module")
def page() -> Reading:
    return read(small())[1]


def test_it_is_sound_and_asks_no_host() -> None:
    text, seen = read(small())
    assert seen.problems == []
    assert not {"script", "link", "iframe", "img"} & set(seen.tags)
    links = [v for v in seen.values("href", "src", "xlink:href") if not v.startswith("#")]
    assert links
    assert all(re.fullmatch(r"figures/[\w.-]+\.(svg|pdf)", link) for link in links), links
    assert "@import" not in text
    assert "url(http" not in text
    ids = seen.values("id")
    assert len(ids) == len(set(ids))
    assert {v[1:] for v in seen.values("href") if v.startswith("#")} <= set(ids), (
        "every reference leads somewhere"
    )


EVIL = "</td><script>alert(1)</script><b onmouseover='x'>&amp; {{ 7 * 7 }} $\\frac{ \U0001f9b7"


def test_texts_of_a_case_are_escaped_wherever_they_stand() -> None:
    done = small()
    gap = done.case.entries["D"]
    entries = {**done.case.entries, "D": replace(gap, reason=EVIL, text=EVIL, provenance=Provenance.ASSUMED)}
    case = replace(done.case, name=EVIL, description=EVIL, source={"title": EVIL}, entries=entries)
    text, seen = read(replace(done, case=case))
    plain = read(done)[1]
    assert seen.problems == []
    assert [tag for tag in seen.tags if tag in ("script", "b")] == [t for t in plain.tags if t == "b"]
    assert "<script" not in text
    assert "onmouseover" not in {name for _, name, _ in seen.attributes}
    assert seen.text.count(" ".join(EVIL.split())) == 2  # the title of the source, and the reason
    assert json.loads(as_json(replace(done, case=case)))["case"]["name"] == EVIL


def test_every_claim_stands_beside_its_computed_counterpart(page: Reading) -> None:
    for claim in small().claims:
        for part in (
            claim.quantity,
            claim.sentence,
            claim.printed,
            claim.verdict,
            claim.computed,
            claim.branch,
        ):
            assert folded(part) in page.text, part
    verdicts = [claim.verdict for claim in small().claims]
    for verdict in set(verdicts):
        assert page.text.count(verdict) >= verdicts.count(verdict)


def test_every_event_is_shown_found_or_not(page: Reading) -> None:
    assert any(e.found for e in small().events)
    assert any(not e.found for e in small().events)
    for event in small().events:
        assert event.title in page.text
        assert event.digits in page.text
        if event.found:
            assert f"{event.value:.8g}" in page.text
            assert f"{short(event.label_below)} → {short(event.label_above)}" in page.text
        else:
            assert event.note.split(":")[0] in page.text
    missing = sum(not e.found for e in small().events)
    assert page.text.count("No such event was found") == missing


def test_zones_stand_in_rpm_and_micrometres(page: Reading) -> None:
    scales = small().case.scales
    for zone, reading in [(each, reading) for each in small().zones for reading in each.readings]:
        assert folded(reading.name) in page.text
        assert reading.found
        low, high = reading.lower.value, reading.upper.value
        if zone.parameter == "omega":
            rpm = [float(scales.pinion_rpm(v)) for v in (low, high)]
            assert f"{shown_edge(rpm[0], 1)} to {shown_edge(rpm[1], -1)} rpm" in page.text
        else:
            um = [float(scales.backlash_um(v)) for v in (low, high)]
            ends = f"{shown_edge(um[0], 1)} to {shown_edge(um[1], -1)}"
            assert re.search(rf"{re.escape(ends)} µm ?†", page.text)


def test_margins_of_the_operating_point_stand_in_both_units(page: Reading) -> None:
    zone = small().window_plane
    assert zone is not None
    assert zone.complete
    assert [margin.bounded for margin in zone.margins] == [True, True, False, False]
    for margin, edge in zip(zone.margins[:2], (0.9725, 1.112), strict=True):
        assert round(margin.value, 4) == edge
        rpm = float(small().case.scales.pinion_rpm(margin.distance))
        said = re.search(rf"{re.escape(at_most(margin.distance))} \(([\d.]+) rpm\)", page.text)
        assert said is not None
        assert 0.999 * rpm < float(said[1]) <= rpm
        assert folded(margin.event) in page.text
    data = json.loads(as_json(small()))["window_plane"]
    assert data["margins"][0]["value"] == zone.margins[0].value
    assert len(data["boundary"]) == len(zone.parts)


def test_contact_rules_are_compared_as_computed(page: Reading) -> None:
    assert [e.rule for e in small().rules] == ["always", "in-contact", "no-tension"]
    for effect in small().rules:
        for end in (effect.lower, effect.upper):
            assert end is not None
            assert f"{end.value:.9g}" in page.text
        for found in effect.backlash:
            assert short(found.label) in page.text
    assert "both ends are those of always" in page.text
    assert "so the window is narrower" in page.text
    _, without = read(replace(small(), rules=()))
    assert without.problems == []
    assert "What the contact rule changes" not in without.text


def test_certificates_are_counted(page: Reading) -> None:
    counts = small().run.certificates
    assert sum(counts.values()) == 3 * (10 + 4)
    for verdict, count in counts.items():
        assert f"{verdict} {count}" in page.text


def test_what_was_not_given_is_listed_with_its_reason(page: Reading) -> None:
    values = [v for v in small().case.values() if v.provenance in ("inferred", "assumed")]
    assert values
    for value in values:
        assert value.path in page.text
        assert folded(value.reason) in page.text
    assert f"{len(values)} values of this case are not stated" in page.text


def test_physical_numbers_on_assumed_values_are_marked_and_others_not() -> None:
    text, _ = read(small())
    assert re.search(r'class="marked">[\d.]+ to [\d.]+ µm', text)
    assert not re.search(r'class="marked">[^<]*rpm', text), "the speed scale rests on inferred values"


def test_the_summary_counts_what_the_table_says(page: Reading) -> None:
    claims = small().claims
    start = (
        page.text.index("Of 15 claims") if len(claims) == 15 else page.text.index(f"Of {len(claims)} claims")
    )
    sentence = page.text[start : start + 200]
    lost = sum(c.verdict == NOT_FOUND for c in claims)
    assert f"{lost} were ✗ not found" in sentence


def test_a_run_that_found_nothing_still_makes_a_report() -> None:
    done = small()
    first = done.zones[0]
    nowhere = replace(first.readings[0].lower, value=nan, how="none", next_label="")
    readings = tuple(
        replace(r, lower=nowhere, upper=nowhere, labels=(), margin=nan, coexisting=(), verdict=NOT_FOUND)
        for r in first.readings
    )
    zone = replace(first, readings=readings, nearest="", verdict=NOT_FOUND)
    empty = replace(done, events=(), zones=(zone,), window=(), table2=(), claims=())
    _, seen = read(empty)
    assert seen.problems == []
    assert "no interval without any impact was found" in seen.text
    _, seen = read(replace(empty, zones=()))
    assert seen.problems == []


def test_an_incomplete_run_says_so() -> None:
    done = small()
    _, seen = read(replace(done, run=replace(done.run, complete=False)))
    assert "stopped early" in seen.text


@pytest.mark.slow
def test_a_folder_holds_page_numbers_and_figures(tmp_path: Path) -> None:
    done = replace(small(), events=small().events[:1])
    path = render(done, tmp_path / "out")
    text = path.read_text(encoding="utf-8")
    seen = Reading(text)
    assert path == tmp_path / "out" / "report.html"
    assert seen.problems == []
    assert seen.tags.count("svg") == seen.tags.count("figure") > 4
    for link in {v for v in seen.values("href") if not v.startswith("#")}:
        file = path.parent / link
        head = file.read_bytes()[:100]
        assert head.startswith(b"%PDF") if link.endswith(".pdf") else b"<?xml" in head
    used = set(re.findall(r'(?:href="#|url\(#)([^")]+)', text))
    assert used <= set(seen.values("id")), "every part of a drawing that is used is there"
    names = re.sub(r'xmlns(:\w+)?="[^"]*"', "", text)
    assert "http://" not in names
    assert "https://" not in names

    data = json.loads((path.parent / "report.json").read_text(encoding="utf-8"))
    assert [c["computed_value"] for c in data["claims"]] == [
        c.computed_value if c.computed_value == c.computed_value else None for c in done.claims
    ]
    assert data["events"][0]["value"] == done.events[0].value
    assert len(data["frequency"]["dataset"]["variables"]["label"][0]) == len(done.frequency.dataset["omega"])
    assert data["case"]["hash"] == done.case.hash
