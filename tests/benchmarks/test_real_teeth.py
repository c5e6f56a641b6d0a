"""Pairs of many kinds with real teeth: each can be verified, and the page has a row of each."""

from __future__ import annotations

from pathlib import Path

import pytest

from benchmarks.real_teeth import COARSE, COLUMNS, PAIRS, Both, both, drawn, main, row

PAGE = (Path(__file__).parents[2] / "docs" / "verification.md").read_text(encoding="utf-8")


def cells(line: str) -> list[str]:
    return [cell.strip() for cell in line.strip("|").split("|")]


def test_the_table_of_the_page_is_that_of_the_command():
    """As many columns, and the drawing that was computed in each row."""
    begins = PAGE.index(f"| {' | '.join(COLUMNS)} |")
    rows = [cells(line) for line in PAGE[begins:].partition("\n\n")[0].splitlines()[2:]]
    assert {name: drawing.strip("`") for name, drawing, *_ in rows} == PAIRS
    assert {len(row) for row in rows} == {len(COLUMNS)}


@pytest.fixture(scope="module")
def light() -> Both:
    return both(drawn(PAIRS["module 1"]), COARSE)


@pytest.mark.slow
def test_a_row_says_what_was_found(light: Both):
    shown = dict(zip(COLUMNS, cells(row("module 1", light)), strict=True))
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
