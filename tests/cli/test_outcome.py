"""A study of which much failed is not ok, and says how much and why."""

from __future__ import annotations

from pathlib import Path

import pytest

from cli.conftest import Gearlash
from gearlash.cli.answers.outcome import study_status, troubles
from gearlash.system import Status

NARROW = str(Path(__file__).resolve().parents[1] / "cases" / "narrow.toml")  # gap from -0.5 on


@pytest.mark.parametrize(
    ("complete", "statuses", "status"),
    [
        (True, {Status.OK: 9}, "ok"),
        (True, {Status.OK: 5, Status.UNRESOLVED: 5}, "ok"),
        (True, {Status.OK: 4, Status.UNRESOLVED: 5}, "partly-failed"),
        (True, {Status.OK: 8, Status.FAILED: 1}, "partly-failed"),
        (True, {Status.FAILED: 9}, "failed"),
        (True, {Status.UNRESOLVED: 9}, "failed"),
        (False, {Status.OK: 5, Status.NOT_COMPUTED: 4}, "incomplete"),
    ],
)
def test_status_of_a_study(complete: bool, statuses: dict[Status, int], status: str):
    assert study_status(complete, statuses) == status


def test_troubles_are_counted_and_the_first_reason_told():
    assert troubles({Status.OK: 9}, "") == ""
    assert (
        troubles({Status.OK: 8, Status.FAILED: 1}, "x = 1, too small")
        == "1 of 9 points failed: x = 1, too small"
    )
    said = troubles({Status.OK: 3, Status.FAILED: 2, Status.UNRESOLVED: 1}, "x = 1, too small", "pixel")
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
