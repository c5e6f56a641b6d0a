"""gearlash curve: its curves against the study, what is said of them, and what is kept."""

from __future__ import annotations

import json
import os
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import gearlash as gl
from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema

SCHEMA = answer_schema(answer_kind("curve"))
PAIR = ("--over", "omega=0.65:0.9", "--over", "D=0.13:1.1")
SPUR = ("curve", "kahraman-singh", "--near", "0.75", *PAIR)
MEETING = 0.708031618721831, 0.145906154662747  # fold of the impacting branch and grazing of the back side


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The file of a branch of the 1-DOF family, with its folds and grazings."""
    case = gl.load_case("kahraman-singh")
    branch = gl.continue_branch(case, "omega", lower=0.65, upper=0.9, values={"omega": 0.75})
    return str(gl.save_branch(branch, tmp_path_factory.mktemp("branch") / "branch.json", case))


def test_a_curve_from_the_motion_of_the_case(gearlash: Gearlash, tmp_path: Path):
    ran = gearlash(*SPUR, "--from", "fold=0.71", "--json", "--out", str(tmp_path))
    assert ran.code == 0
    assert problems(ran.answer, SCHEMA) == []
    (curve,) = ran.answer["curves"]
    (point,) = curve["special"]
    assert point["kind"] == "grazing with a multiplier 1"
    assert point["values"] == pytest.approx(MEETING, abs=1e-12)
    assert point["solved"]
    assert point["admissible"]
    assert [end["kind"] for end in curve["ends"]] == ["limit of a parameter"] * 2
    here = "omega from 0.65 to 0.9 and D from 0.13 to 1.1"
    assert ran.answer["sentence"].startswith(f"{here}: fold of 1-1-0; 1 grazing with a multiplier 1 found; ")
    names = {path.name for path in tmp_path.iterdir() if not path.name.startswith(".")}
    assert names == {
        "curve.json", "special.csv", "branch-1.json", "curve.svg", "curve.pdf",
        "curve-1.json", "curve-1.nc", "curve-1.csv",
    }  # fmt: skip
    assert json.loads((tmp_path / "curve.json").read_text(encoding="utf-8")) == ran.answer
    special = pd.read_csv(tmp_path / "special.csv")
    assert special[["omega", "D"]].to_numpy().tolist() == [point["values"]]
    again = gl.load_curve(tmp_path / "curve-1.json")
    dataset = gl.load_dataset(tmp_path / "curve-1.nc")
    np.testing.assert_array_equal(np.column_stack([dataset["omega"], dataset["D"]]), again.parameters)
    assert dataset["special_kind"].values.tolist() == [point["kind"]]
    assert len(pd.read_csv(tmp_path / "curve-1.csv")) == len(again.points) == len(curve["orbits"])
    branch = gl.load_branch(tmp_path / "branch-1.json")
    assert [str(each.kind) for each in branch.special] == ran.answer["start"]["special"]


@pytest.mark.slow
def test_a_kept_branch_and_a_kept_curve_are_begun_at(gearlash: Gearlash, kept: str, tmp_path: Path):
    branch = gl.load_branch(kept)
    number = 1 + next(i for i, each in enumerate(branch.special) if abs(each.value - MEETING[0]) < 1e-9)
    first = gearlash(
        "curve", "kahraman-singh", *PAIR, "--resume", kept, "--at", str(number), "--out", str(tmp_path)
    )
    assert first.code == 0
    assert "0.1459061547" in first.out
    file = str(tmp_path / "curve-1.json")
    ran = gearlash(
        "curve", "kahraman-singh", *PAIR, "--resume", file, "--at", "1", "--kind", "grazing", "--json"
    )
    (curve,) = ran.answer["curves"]
    assert (curve["kind"], ran.answer["start"]["source"]) == ("grazing", "curve")
    assert curve["touches"] == "mesh, back side"
    known = [point for point in curve["special"] if point["kind"] == "grazing with a multiplier 1"]
    assert known[0]["values"] == pytest.approx(MEETING, abs=1e-9)


def test_the_figure_and_the_table_are_in_the_units_that_were_asked(gearlash: Gearlash):
    ran = gearlash(
        "curve", "article", "--over", "pinion_speed=3650:3850rpm", "--over", "backlash=98:102um",
        "--near", "3800", "--from", "grazing",
    )  # fmt: skip
    assert ran.code == 0
    flat = " ".join(ran.out.split())
    assert flat.startswith(
        "pinion speed from 3650 to 3850 rpm and backlash from 98 to 102 µm: grazing of 1-0-0; "
    )
    assert "pinion speed 3714.922 rpm, backlash 98 µm †: limit of backlash" in flat
    assert "† rests on assumed values: " in flat


def test_one_curve_through_two_points_is_followed_once(gearlash: Gearlash, kept: str):
    over = ("--over", "omega=0.65:1.1", "--over", "load=0.05:0.5")
    twice = ("--from", "fold=0.70", "--from", "fold=0.83", "--step", "0.1")
    ran = gearlash("curve", "kahraman-singh", *over, "--resume", kept, *twice, "--json")
    curves, missed = ran.answer["curves"], ran.answer["not_begun"]
    folds = [curve for curve in curves if curve["kind"] == "fold"]
    assert [point["kind"] for point in folds[0]["special"]] == ["cusp"]
    assert len(folds) == 1
    assert [each["why"] for each in missed] == [f"it lies on the curve from {folds[0]['begun_at']}"]


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("--over", "omega=0.65:0.9"), "--over = given 1 times: expected two parameters"),
        (("--over", "D=0.1:1", "--over", "D=0.2:1"), "another parameter than D"),
        (PAIR, "--from: expected a special point to begin at, such as fold"),
        ((*PAIR, "--from", "crease"), "--from = 'crease': expected the number of a special point, grazing"),
        ((*PAIR, "--from", "fold", "--at", "1"), "--resume FILE with it"),
        ((*PAIR, "--from", "fold", "--kind", "bend"), "--kind = 'bend': expected grazing, fold"),
        (("--over", "omega=0.65:0.9", "--over", "D=0.1:0.5", "--from", "fold"), "begin at, omega = 0.5"),
    ],
)
def test_what_cannot_be_asked_is_told(gearlash: Gearlash, arguments: tuple[str, ...], told: str):
    ran = gearlash("curve", "kahraman-singh", *arguments)
    assert ran.code == 2
    assert told in ran.complaint


def test_what_the_file_does_not_have_is_told(gearlash: Gearlash, kept: str, tmp_path: Path):
    resumed = ("curve", "kahraman-singh", *PAIR, "--resume", kept)
    assert (
        "--from = 40: expected a special point of a branch which has 1 grazing, "
        in gearlash(*resumed, "--at", "40").complaint
    )
    assert "--from = Neimark-Sacker: " in gearlash(*resumed, "--from", "neimark-sacker").complaint
    other = gearlash(*resumed[:2], "--set", "load=0.2", *resumed[2:], "--at", "1")
    assert "--resume load = 0.1: expected 0.2 as in the case" in other.complaint
    nothing = tmp_path / "nothing.json"
    nothing.write_text("{}")
    ran = gearlash("curve", "kahraman-singh", *PAIR, "--resume", str(nothing), "--at", "1")
    assert "a file of a branch or of a curve" in ran.complaint


def test_a_point_at_which_no_curve_begins(gearlash: Gearlash, kept: str):
    ran = gearlash("curve", "kahraman-singh", *PAIR, "--resume", kept, "--at", "1", "--doubled", "--json")
    assert ran.answer["status"] == "not-found"
    assert ran.answer["curves"] == []
    assert "only where a grazing orbit has a multiplier -1" in ran.answer["message"]


def test_where_no_motion_can_be_followed(gearlash: Gearlash):
    ran = gearlash(*SPUR, "--set", "error=0", "--from", "fold", "--json")
    assert ran.answer["status"] == "not-excited"


def test_what_the_point_brings_with_it_is_told(gearlash: Gearlash, kept: str):
    """A branch over omega, a curve over others: omega is that of the point."""
    over = ("--over", "D=0.9:1.1", "--over", "load=0.09:0.11")
    ran = gearlash("curve", "kahraman-singh", *over, "--resume", kept, "--from", "grazing=0.82", "--json")
    (curve,) = ran.answer["curves"]
    assert list(curve["fixed"]) == ["omega"]
    assert curve["fixed"]["omega"] == pytest.approx(0.8206310877, abs=1e-9)
    shown = gearlash("curve", "kahraman-singh", *over, "--resume", kept, "--from", "grazing=0.82").out
    assert "omega = 0.8206310877, as at the point that it begins at" in shown


@pytest.fixture
def interrupted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ctrl-C after three orbits."""

    @contextmanager
    def interrupting(title: str) -> Iterator[object]:
        def tell(progress: gl.Progress) -> None:
            if progress.done == 3:
                os.kill(os.getpid(), signal.SIGINT)

        yield tell

    monkeypatch.setattr("gearlash.cli.progress.progress_bar", interrupting)


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="sends SIGINT to this process")
@pytest.mark.usefixtures("interrupted")
def test_ctrl_c_keeps_what_was_found(gearlash: Gearlash, kept: str, tmp_path: Path):
    ran = gearlash(
        "curve", "kahraman-singh", *PAIR, "--resume", kept, "--from", "all", "--out", str(tmp_path), "--json"
    )
    assert ran.code == 130
    assert (ran.answer["status"], len(ran.answer["curves"])) == ("incomplete", 1)
    found = gl.load_curve(tmp_path / "curve-1.json")
    assert "cancelled" in {str(end.kind) for end in found.ends}
    assert gl.load_dataset(tmp_path / "curve-1.nc").attrs["complete"] == 0
    assert not (tmp_path / "curve.svg").exists()


@pytest.mark.skipif(os.name == "nt", reason="sends SIGINT to this process")
@pytest.mark.usefixtures("interrupted")
def test_ctrl_c_on_the_way_along_the_branch_keeps_that(gearlash: Gearlash, tmp_path: Path):
    ran = gearlash(*SPUR, "--from", "fold", "--out", str(tmp_path), "--json")
    assert ran.code == 130
    assert (ran.answer["status"], ran.answer["curves"]) == ("incomplete", [])
    kept = gl.load_branch(tmp_path / "branch-1.json")
    assert {str(end.kind) for end in kept.ends} == {"cancelled"}
