"""The article's study on coarse axes: every claim, with the way of scanning that shows it."""

from __future__ import annotations

from pathlib import Path

import pytest

from gearlash import EndOfBranch
from gearlash.article import REPRODUCED, SHIFTED, ClaimRow, Reproduction, Scope, reproduce
from gearlash.article.reproduction import Reading
from gearlash.case import load

pytestmark = pytest.mark.slow
ROOT = Path(__file__).parents[2]
SCOPE = Scope(omega=(0.82, 1.13, 63), backlash=(0.33, 1.0, 135), rules_backlash=(0.44, 0.5))
NEEDS_A_SCAN = {"window-upper", "exponent-window-upper", "frequency-zone", "backlash-zone"}
FITTED = {"window-upper", "window-lower", "period-3", "codimension-2", "back-side"}


@pytest.fixture(scope="module")
def done() -> Reproduction:
    return reproduce(load("article"), SCOPE, workers=0)


@pytest.fixture(scope="module")
def rows(done: Reproduction) -> dict[str, ClaimRow]:
    return {row.id: row for row in done.claims}


def reading(done: Reproduction, parameter: str, way: str) -> Reading:
    return next(zone for zone in done.zones if zone.parameter == parameter).reading(way)


def test_all_fifteen_claims_come_out(rows: dict[str, ClaimRow]):
    assert {row.verdict for row in rows.values()} == {REPRODUCED}
    assert len(rows) == 15


def test_a_claim_that_needs_a_scan_names_it(rows: dict[str, ClaimRow]):
    assert {name for name, row in rows.items() if row.needs} == NEEDS_A_SCAN
    assert "fixed start X = 1" in rows["backlash-zone"].needs
    assert "followed upwards" in rows["frequency-zone"].needs
    assert "up sweep" in rows["window-upper"].needs


def test_values_that_were_fitted_are_marked(rows: dict[str, ClaimRow]):
    assert {name for name, row in rows.items() if row.fitted} == FITTED


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("window-lower", 0.9725),
        ("window-upper", 1.112),
        ("period-3", 0.8300789),
        ("codimension-2", 0.3523191),
        ("back-side", 0.385502),
    ],
)
def test_critical_values(rows: dict[str, ClaimRow], name: str, value: float):
    assert rows[name].computed_value == pytest.approx(value, rel=1e-6)


def test_the_codimension_2_claim_says_two_things(rows: dict[str, ClaimRow]):
    value, coincidence = rows["codimension-2"].parts
    assert value.computed.endswith("12-12-3 → 6-6-1")
    assert (value.verdict, coincidence.verdict) == (REPRODUCED, REPRODUCED)
    assert coincidence.computed == "9.58e-06 apart"
    assert "square root" in coincidence.note
    assert "not claimed" in coincidence.note
    assert abs(rows["exponent-codimension-2"].computed_value) < 1e-12


@pytest.mark.parametrize(
    ("way", "lower", "verdict"),
    [
        ("cold", 0.45254, SHIFTED),
        ("up", 0.485411, SHIFTED),
        ("down", 0.415487, SHIFTED),
        ("every", 0.485411, SHIFTED),
        ("X = 1, all else zero", 0.459158, REPRODUCED),
        ("X = D + f_m, all else zero", 0.459919, REPRODUCED),
        ("all zero", 0.450529, SHIFTED),
    ],
)
def test_readings_of_the_zone_in_the_backlash(done: Reproduction, way: str, lower: float, verdict: str):
    found = reading(done, "D", way)
    assert found.lower.value == pytest.approx(lower, abs=2e-6)
    assert found.upper.value == 1.0
    assert found.verdict == verdict


def test_the_reading_nearest_to_the_article_is_named(done: Reproduction):
    assert {zone.parameter: zone.nearest for zone in done.zones} == {
        "omega": "up",
        "D": "X = 1, all else zero",
    }
    for zone in done.zones:
        compared = [r for r in zone.readings if r.way != "some"]
        assert min(compared, key=lambda r: abs(r.deviation)).way == zone.nearest


def test_a_bearing_swings_inside_the_window(done: Reproduction):
    (mode,) = done.bearings
    pinion = (8.0e8 / 5.98) ** 0.5 / load("article").scales.omega_n
    assert mode.frequency == pytest.approx(pinion, rel=1e-12)
    assert 0.9725 < mode.frequency < 1.112
    assert mode.force > 5 * mode.mesh_force


def test_every_change_along_the_sweeps_is_a_special_point_of_a_branch(done: Reproduction):
    for scan in done.scans:
        assert scan.on_branches == scan.attractors > 0
        assert [event.value for event in scan.events if event.special is None] == []


def test_every_event_of_the_article_has_the_law_of_its_touch(done: Reproduction):
    assert [event.law is not None and event.law.generic for event in done.events] == [True] * 5
    for event in done.events:
        touch = event.coincidence.grazing.value if event.coincidence is not None else event.value
        assert event.law is not None
        assert event.law.value == pytest.approx(touch, rel=1e-12)


def test_coexistence_stands_in_the_page_on_theory(done: Reproduction):
    theory = (ROOT / "docs" / "theory.md").read_text(encoding="utf-8")
    told = {
        "omega": [("2-1-0", "fold", "Neimark-Sacker"), ("1-1-0", "grazing", "doubling")],
        "D": [("3-3-1", "doubling", "fold"), ("3-3-1", "fold", "grazing"), ("3-3-0", "grazing", "upper")],
    }
    for scan in done.scans:
        for label, *kinds in told[scan.parameter]:
            stretches = [
                each
                for each in scan.stretches
                if each.label == label
                and str(each.lower_end.kind).startswith(kinds[0])
                and str(each.upper_end.kind).startswith(kinds[1])
                and each.upper > (1.1 if scan.parameter == "omega" else 0.41)
            ]
            assert stretches, (label, kinds)
            for end in (stretches[-1].lower_end, stretches[-1].upper_end):
                assert isinstance(end, EndOfBranch) or f"{end.value:.5f}" in theory, end


def test_table_2_has_the_pair_that_print_does_not_tell_apart(done: Reproduction):
    row = next(row for row in done.table2 if row.type.startswith("Co-dimension-2"))
    assert row.verdict == REPRODUCED
    assert row.patterns == ("12-12-3 → 6-6-1",)
    assert row.periods == ("12 → 6",)


def test_the_page_on_theory_and_the_readme_say_what_comes_out(done: Reproduction, rows: dict[str, ClaimRow]):
    theory = (ROOT / "docs" / "theory.md").read_text(encoding="utf-8")
    for name, digits in {"window-lower": 6, "window-upper": 6, "period-3": 6, "back-side": 6}.items():
        assert f"| {rows[name].computed_value:.{digits}f}" in theory
    (both,) = [each for each in done.coincidences if each.labels == ("12-12-3", "6-6-1")]
    assert f"doubling of 6-6-1 at {both.doubling.value:.7f}" in theory
    assert f"grazing at {both.grazing.value:.7f}, {both.apart:.1e}".replace("e-06", "e-6") in theory
    for value in (both.predicted, both.corrected):
        assert f"{value:.1e}".replace("e-06", "e-6") in theory
    law = f"h = {both.clearance:.4f}, c = {both.opens:.4f} and b = {both.approaches:.2f}"
    assert law in " ".join(theory.split())
    ways = ("X = 1, all else zero", "X = D + f_m, all else zero", "cold", "all zero", "up", "down")
    lower = [reading(done, "D", way).lower.value for way in ways]
    said = "from X = 1, all else zero: {:.4f}; from X = D + f_m: {:.4f}; cold {:.4f}; all zero {:.4f}; "
    assert (said + "followed up {:.4f}, down {:.4f}").format(*lower) in theory
    (mode,) = done.bearings
    assert f"moves by {mode.motion:.2f} D_c" in theory
    readme = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
    assert (
        f"All {len(rows)} claims come out, {len(NEEDS_A_SCAN)} of them only with a way of scanning" in readme
    )
