"""A study of which much failed is not ok, and says how much and why."""

from __future__ import annotations

from pathlib import Path

import pytest

from cli.conftest import Gearlash
from gearlash.cli.answers.outcome import study_status, troubles

NARROW = str(Path(__file__).resolve().parents[1] / "cases" / "narrow.toml")  # gap from -0.5 on


@pytest.mark.parametrize(
    ("complete", "statuses", "status"),
    [
        (True, {"ok": 9}, "ok"),
        (True, {"ok": 5, "unresolved": 5}, "ok"),
        (True, {"ok": 4, "unresolved": 5}, "partly-failed"),
        (True, {"ok": 8, "failed": 1}, "partly-failed"),
        (True, {"failed": 9}, "failed"),
        (True, {"unresolved": 9}, "failed"),
        (False, {"ok": 5, "not-computed": 4}, "incomplete"),
    ],
)
def test_status_of_a_study(complete: bool, statuses: dict[str, int], status: str):
    assert study_status(complete, statuses) == status


def test_troubles_are_counted_and_the_first_reason_told():
    assert troubles({"ok": 9}, "") == ""
    assert troubles({"ok": 8, "failed": 1}, "x = 1, too small") == "1 of 9 points failed: x = 1, too small"
    said = troubles({"ok": 3, "failed": 2, "unresolved": 1}, "x = 1, too small", "pixel")
    assert said == (
        "2 of 6 pixels failed, the first: x = 1, too small; 1 of 6 pixels is flagged (1 unresolved)"
    )


def test_a_sweep_that_mostly_fails_is_not_ok(gearlash: Gearlash):
    ran = gearlash("sweep", NARROW, "--over", "gap=-3:1:9", "--json")
    assert ran.code == 3
    assert ran.answer["status"] == "partly-failed"
    assert "15 of 27 points failed, the first: gap = -3, not a valid system" in ran.answer["sentence"]


def test_a_map_that_partly_fails_is_not_ok(gearlash: Gearlash):
    ran = gearlash("map", NARROW, "--over", "gap=-3:1:5", "--over", "omega=0.4:0.5:3", "--json")
    assert ran.code == 3
    assert ran.answer["status"] == "partly-failed"
    assert "9 of 15 pixels failed, the first: gap = -3, omega = 0.4, " in ran.answer["sentence"]


def test_where_every_point_fails_the_study_failed(gearlash: Gearlash):
    ran = gearlash("sweep", NARROW, "--over", "gap=-3:-1:5", "--cold", "--json")
    assert ran.code == 3
    assert ran.answer["status"] == "failed"
    assert "5 of 5 points failed" in ran.answer["sentence"]
