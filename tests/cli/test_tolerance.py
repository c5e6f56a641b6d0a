"""gearlash tolerance: limits as typed, bands and probabilities, files, refusals."""

import json
from pathlib import Path
from types import SimpleNamespace
from typing import cast

import pytest

from cli.conftest import Gearlash
from gearlash.cli.answers.tolerance import always_text
from gearlash.results.tolerance import Tolerance

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
        (["torque=100 to 200Nm:300Nm"], "NAME=FROM:TO"),
        (["torque=200:100Nm"], "the smaller one first"),
        (["torque=150Nm ± 20 mm"], "another unit"),
        (["torque=100:200Nm", "torque=100:210Nm"], "each name once"),
        (["torqe=100:200Nm"], "did you mean"),
        ([], "nothing in this case is estimated with a range"),
    ],
)
def test_limits_that_do_not_fit(gearlash: Gearlash, limits: list[str], message: str):
    ran = gearlash(*ASKED, *(part for one in limits for part in ("--limits", one)))
    assert ran.code == 2
    assert message in " ".join(ran.err.split())


@pytest.mark.parametrize(
    ("bands", "said"),
    [
        ([], "no value of the range holds"),
        ([(900.0, 1000.0)], "combinations tried from 900 to 1000 rpm"),
        ([(941.9, 942.4)], "only in a band less wide than 1 % of the range and of its values, from 941.9 to"),
        ([(850.0, 850.2), (941.9, 942.4)], "only in 2 bands less wide than 1 % of the range and of its "
                                           "values, the widest from 941.9 to 942.4 rpm"),
        ([(850.0, 850.2), (900.0, 990.0)], "tried from 900 to 990 rpm, and in a band less wide than 1 %"),
        ([(800.0, 800.5)], "tried from 800 to 800.5 rpm"),  # goes on below the range for all that is known
        ([(810.0, 820.0), (900.0, 990.0), (1000.0, 1090.0), (1100.0, 1190.0)],
         "tried from 900 to 990 and 1000 to 1090 and 1100 to 1190 rpm and 1 less wide"),
    ],
)  # fmt: skip
def test_bands_that_nobody_can_run_in_are_no_headline(bands: list[tuple[float, float]], said: str):
    axis = SimpleNamespace(name="pinion_speed", unit="rpm", values=[800.0, 1800.0])
    found = SimpleNamespace(axis=axis, always=tuple(bands))
    assert said in always_text(cast(Tolerance, found))
