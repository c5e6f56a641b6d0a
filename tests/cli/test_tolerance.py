"""gearlash tolerance: limits as typed, bands and probabilities, files, refusals."""

import json
from pathlib import Path

import pytest

from cli.conftest import Gearlash

DRIVE = str(Path(__file__).parents[1] / "cases" / "drive.toml")
ASKED = ("tolerance", DRIVE, "--over", "pinion_speed=4150:4250rpm:3", "--samples", "2", "--replicates", "2")


def test_an_answer_in_the_units_asked_with_files(gearlash: Gearlash, tmp_path: Path):
    limits = ("--limits", "torque=100:250Nm", "--limits", "backlash=60:120um")
    ran = gearlash(*ASKED, *limits, "--workers", "1", "--out", str(tmp_path / "out"))
    assert ran.code == 0, ran.err
    assert ran.out.startswith("At 4200 rpm: teeth stay in contact as the case is")
    assert "--set 'operation.torque=100.0 N*m'" in ran.out
    assert "That no other combination is worse is not proved." in " ".join(ran.out.split())
    answer = json.loads((tmp_path / "out" / "tolerance.json").read_text())
    assert answer["unit"] == "rpm"
    assert answer["worst_margin"] < answer["nominal_margin"]
    assert (tmp_path / "out" / "tolerance.svg").exists()
    lines = (tmp_path / "out" / "tolerance.csv").read_text().splitlines()
    assert lines[0] == "pinion_speed [rpm],probability,standard_error"
    assert len(lines) == 4
    again = gearlash(*ASKED, *limits, "--workers", "2", "--json")
    assert json.loads(again.out) == answer


@pytest.mark.parametrize(
    ("limits", "message"),
    [
        (["torque=100"], "NAME=FROM:TO"),
        (["torque=100:200Nm", "torque=100:210Nm"], "each name once"),
        (["torqe=100:200Nm"], "did you mean"),
        ([], "nothing in this case is estimated with a range"),
    ],
)
def test_limits_that_do_not_fit(gearlash: Gearlash, limits: list[str], message: str):
    ran = gearlash(*ASKED, *(part for one in limits for part in ("--limits", one)))
    assert ran.code == 2
    assert message in " ".join(ran.err.split())
