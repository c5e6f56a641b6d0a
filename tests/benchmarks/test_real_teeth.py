"""Pairs of many kinds with real teeth: each can be verified, and the page has a row of each."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from benchmarks.real_teeth import COARSE, COLUMNS, KEPT, PAIRS, Both, both, drawn, main, row, table
from gearlash.article.report import seen
from gearlash.article.report.seen import has_label, parts

PAGE = (Path(__file__).parents[2] / "docs" / "verification.md").read_text(encoding="utf-8")


FOUND = json.loads(KEPT.read_text(encoding="utf-8"))
ROWS = [dict(zip(COLUMNS, cells, strict=True)) for cells in FOUND["rows"]]
WORDS = " ".join(PAGE.split())


def test_the_table_of_the_page_is_that_of_the_command():
    """Every cell as it is kept, of the drawings that the command has now, and the commit."""
    assert table(FOUND["rows"]) in PAGE
    assert {row["pair"]: row["options of `gearlash new`"].strip("`") for row in ROWS} == PAIRS
    assert f"Commit {FOUND['commit']} computed the rows" in PAGE


def greatest(cell: str) -> list[float]:
    return [float(each.split(" to ")[1]) for each in cell.split(" / ")]


def part(label: str) -> bool:
    """Whether teeth part: of a motion without a label, unless it is one that keeps contact."""
    return parts(label, None) if has_label(label) else label != seen.KEPT


def test_what_the_page_says_below_the_table_is_what_the_rows_say():
    """How many pairs part alike and have one label under each rule, and how far greatest forces are apart."""
    both = [(row["real teeth"], row["lumped"].split(" / ")) for row in ROWS]
    parting = sum(part(real) == part(each) for real, lumped in both for each in lumped[:1])
    assert all(len({part(each) for each in lumped}) == 1 for _, lumped in both)
    same = [row for row, (real, lumped) in zip(ROWS, both, strict=True) if lumped == [real]]
    neither = [lumped for real, lumped in both if not has_label(real) and lumped == ["aperiodic"]]
    assert len(neither) == 1
    assert f"same in both models for {parting} of the {len(ROWS)} pairs, under each rule; the label" in WORDS
    assert f"the label is the same for {len(same)}, and one more has none in either model" in WORDS
    shares = {
        row["pair"]: [
            greatest(row["forces of real teeth over their mean"])[0] / lumped
            for lumped in greatest(row["of the lumped model"])
        ]
        for row in same
    }
    everywhere = [each for found in shares.values() for each in found]
    assert f"between {min(everywhere):.2f} and {max(everywhere):.2f} of those of the lumped model" in WORDS
    del shares["helix of 33°"]
    others = [each for found in shares.values() for each in found]
    assert f"(1.13 and 1.52 of the mean) between {min(others):.2f} and {max(others):.2f}." in WORDS


def test_all_pairs_are_kept_or_none(capsys: pytest.CaptureFixture[str]):
    with pytest.raises(SystemExit):
        main(["--keep", "steel"])
    assert "--keep is of all pairs" in capsys.readouterr().err


@pytest.fixture(scope="module")
def light() -> Both:
    return both(drawn(PAIRS["module 1"]), COARSE)


@pytest.mark.slow
def test_a_row_says_what_was_found(light: Both):
    shown = dict(zip(COLUMNS, row("module 1", light), strict=True))
    assert float(shown["k of real teeth"].partition("·")[0]) * 1e8 == pytest.approx(
        light.mesh.stiffness, rel=1e-2
    )
    least, estimate, greatest = light.estimate
    assert least < estimate < greatest
    assert estimate == pytest.approx(light.inputs.mean_stiffness)
    low, high = map(float, shown["forces of real teeth over their mean"].split(" to "))
    assert low == pytest.approx(light.real.reading.least / light.real.reading.mean, abs=6e-3)
    assert low < 1.0 < high


@pytest.mark.slow
def test_both_models_run_at_the_speed_of_the_drawing(light: Both):
    """And so at one ω, that of the stiffness of the teeth."""
    assert light.real.rpm == pytest.approx(20000.0, rel=1e-6)
    assert {point.omega for point in light.lumped} == {light.real.omega}
    assert light.mesh.static.torque == pytest.approx(4.0)


def test_a_pair_that_is_not_there_is_answered_with_those_that_are(capsys: pytest.CaptureFixture[str]):
    with pytest.raises(SystemExit):
        main(["module 13"])
    said = capsys.readouterr().err
    assert "no such pair: module 13" in said
    assert "module 12" in said
