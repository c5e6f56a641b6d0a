"""--periods and --max-period count mesh cycles, also where the base period is several of them."""

from __future__ import annotations

import pytest

OVER = {
    "run": (),
    "branch": ("--over", "omega=0.4:0.7"),
    "graze": (),
    "sweep": ("--over", "omega=0.5:0.6:2", "--cold", "--workers", "1"),
    "map": ("--over", "omega=0.5:0.6:2", "--over", "load=0.1:0.2:2", "--workers", "1"),
    "atlas": ("--over", "omega=0.5:0.6", "--over", "load=0.1:0.2", "--workers", "1"),
    "zones": ("--over", "omega=0.5:0.6:2", "--workers", "1"),
}


@pytest.mark.parametrize("periods", [3, 5, 30, 500])
def test_periods_are_mesh_cycles(gearlash, periods):
    ran = gearlash("run", "two-stage", "--set", "error_1=0.9", "--periods", str(periods), "--json")
    told = ran.answer
    assert 0 < 3 * told["periods_used"] <= periods
    if periods < 30:
        assert ran.code == 3
        assert told["motion"] == "unresolved"


@pytest.mark.parametrize("command", OVER)
@pytest.mark.parametrize("option", ["--periods", "--max-period"])
def test_less_than_a_base_period_is_refused(gearlash, command, option):
    ran = gearlash(command, "two-stage", *OVER[command], option, "2")
    assert ran.code == 2
    assert f"{option} = 2: expected 3 or more" in ran.complaint


def test_the_longest_period_is_in_mesh_cycles(gearlash):
    """A motion of six mesh cycles, two base periods, is not found where five are the longest looked for."""
    case = ("run", "two-stage", "--set", "error_1=0.3", "--json")
    assert gearlash(*case, "--max-period", "6").answer["label"] == "6-5-0/6-0"
    shorter = gearlash(*case, "--max-period", "5")
    assert shorter.code == 3
    assert shorter.answer["motion"] == "unresolved"
