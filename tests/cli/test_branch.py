"""gearlash branch: its special points against the study, what is said of them, and what is kept."""

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
from gearlash.cli.branch_inputs import read_zoom
from gearlash.cli.inputs import read_between
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema

SCHEMA = answer_schema(answer_kind("branch"))
SPUR = ("branch", "kahraman-singh", "--set", "omega=1.5", "--over", "omega=0.7:1.6")
SIX = ("branch", "article", "--set", "omega=0.78", "--set", "D=0.37", "--over", "D=0.34:0.5")


def test_special_points_are_those_of_the_study(gearlash: Gearlash):
    ran = gearlash(*SPUR, "--json")
    assert ran.code == 0
    assert problems(ran.answer, SCHEMA) == []
    expected = gl.continue_branch(
        gl.load_case("kahraman-singh"), "omega", lower=0.7, upper=1.6, values={"omega": 1.5}
    )
    (branch,) = ran.answer["branches"]
    assert [each["value"] for each in branch["special"]] == [each.value for each in expected.special]
    assert [each["kind"] for each in branch["special"]] == ["grazing", "fold", "fold", "grazing"]
    for each, special in zip(branch["special"], expected.special, strict=True):
        assert (each["label_before"], each["label_after"]) == (special.label_before, special.label_after)
        assert (each["unstable_before"], each["unstable_after"]) == (
            special.unstable_before, special.unstable_after,
        )  # fmt: skip
    assert branch["special"][0]["clearance"] == "mesh"
    assert branch["special"][0]["side"] == "drive"
    assert branch["special"][1]["side"] is None
    assert [orbit["value"] for orbit in branch["orbits"]] == expected.parameter.tolist()
    assert [end["kind"] for end in branch["ends"]] == [str(end.kind) for end in expected.ends]


def test_stable_motions_that_coexist_are_said_first(gearlash: Gearlash):
    """Between the folds two stable orbits lie at every value, told with their labels."""
    ran = gearlash(*SPUR, "--json")
    low, high = (s["value"] for s in sorted(ran.answer["branches"][0]["special"], key=lambda s: s["value"])
                 if s["kind"] == "fold")  # fmt: skip
    beside = ran.answer["coexisting"]
    assert (beside[0]["low"], beside[-1]["high"]) == (low, high)
    assert sorted(beside[0]["labels"]) == ["1-0-0", "1-1-0"]
    assert "stable motions coexist: " in ran.answer["sentence"]
    text = " ".join(gearlash(*SPUR).out.split())
    assert "Stable motions of these branches that coexist" in text
    assert "quasi-periodic and chaotic motions" in text, "what was not looked for"


def test_the_unit_that_was_asked(gearlash: Gearlash):
    case = gl.load_case("article")
    asked = ("branch", "article", "--over", "pinion_speed=3650:4300rpm")
    ran = gearlash(*asked, "--json")
    answer = ran.answer
    assert answer["sentence"].startswith("pinion speed from 3650 to 4300 rpm, from 1-0-0 at 4000 rpm: ")
    for special in answer["branches"][0]["special"]:
        rpm = float(case.scales.pinion_rpm(special["value"]))
        assert special["value_asked"] == pytest.approx(rpm, rel=1e-12)
    shown = gearlash(*asked).out
    assert "4247.808014" in shown
    assert "1-0-0 | 1-1-0" in shown
    assert "0 | 1" in shown
    assert "ends    4300 rpm: upper limit of the parameter" in shown


@pytest.mark.slow
def test_switched_and_resumed(gearlash: Gearlash, tmp_path: Path):
    """Two switches deep; then from the file: at one point, and from it in another parameter."""
    out = str(tmp_path / "out")
    ran = gearlash(*SIX, "--switch", "all", "--depth", "2", "--out", out, "--json")
    answer = ran.answer
    assert problems(answer, SCHEMA) == []
    assert [(each["parent"], each["parent_special"]) for each in answer["branches"]] == [
        (None, None), (1, 1), (1, 3),
    ]  # fmt: skip
    assert [each["labels"] for each in answer["branches"]] == [
        ["6-6-1", "6-6-2"], ["12-12-3", "12-12-2"], ["3-3-1", "3-3-0"],
    ]  # fmt: skip
    assert [(each["branch"], each["special"], each["known"]) for each in answer["not_switched"]] == [
        (2, 2, 1), (3, 1, 1),
    ]  # fmt: skip
    labels = [each["labels"] for each in answer["coexisting"]]
    assert labels == [["6-6-2", "3-3-1"], ["6-6-2", "3-3-0"], ["3-3-1", "3-3-0"]]
    file = str(tmp_path / "out" / "branch-1.json")
    here = ("--set", "omega=0.78", "--resume", file)
    again = gearlash("branch", "article", *here, "--switch", "1", "--switch", "2", "--json")
    first, twelve = again.answer["branches"]
    assert first == answer["branches"][0]
    assert [each["value"] for each in twelve["special"]] == pytest.approx(
        [each["value"] for each in answer["branches"][1]["special"]], rel=1e-12
    )
    assert [each["why"] for each in again.answer["not_switched"]] == [
        "at a grazing no other branch of periodic orbits begins",
    ]  # fmt: skip
    other = gearlash("branch", "article", *here, "--at", "2", "--over", "omega=0.77:0.79", "--json")
    touch = min(other.answer["branches"][0]["special"], key=lambda each: abs(each["value"] - 0.78))
    assert touch["value"] == pytest.approx(0.78, abs=1e-9)
    assert other.answer["parameters"]["D"] == answer["branches"][0]["special"][1]["value"]


def test_a_point_to_switch_at_that_there_is_not(gearlash: Gearlash, tmp_path: Path):
    """Refused before anything is followed from a file, else after the first branch."""
    narrow, out = (*SIX[:-1], "D=0.352:0.38"), tmp_path / "out"
    ran = gearlash(*narrow, "--switch", "33", "--out", str(out))
    assert ran.code == 2
    assert "--switch = 33: expected a special point of branch 1, which has 1 special point: " in ran.complaint
    assert "other branches begin at 1" in ran.complaint
    assert not (out / "branch-1.json").exists()
    case = gl.load_case("kahraman-singh")
    branch = gl.continue_branch(case, "omega", lower=1.45, upper=1.5, values={"omega": 1.5})
    file = str(gl.save_branch(branch, tmp_path / "branch.json", case))
    ran = gearlash("branch", "kahraman-singh", "--resume", file, "--switch", "1")
    assert (ran.code, "--switch = 1: expected nothing: branch 1 has no special point" in ran.complaint) == (
        2,
        True,
    )


@pytest.mark.slow
def test_a_resumed_branch_replaces_no_other(gearlash: Gearlash, tmp_path: Path):
    """It is number 1 of its own answer, and its folder has others."""
    narrow, out = (*SIX[:-1], "D=0.352:0.38"), tmp_path / "out"
    gearlash(*narrow, "--switch", "all", "--out", str(out))
    before = {path.name: path.read_bytes() for path in out.iterdir()}
    resumed = ("branch", "article", "--set", "omega=0.78", "--resume")
    for number, more in ((2, ()), (1, ()), (1, ("--at", "1"))):
        ran = gearlash(*resumed, str(out / f"branch-{number}.json"), *more, "--out", str(out))
        assert ran.code == 2
        lost = "branch-2" if number == 1 and not more else "branch-1, branch-2"
        assert f"another folder: in this one {lost} (.json, .nc, .csv) would be replaced" in ran.complaint
    assert {path.name: path.read_bytes() for path in out.iterdir()} == before
    for name in ("branch-2.json", "branch-2.nc", "branch-2.csv"):
        (out / name).unlink()
    assert gearlash(*resumed, str(out / "branch-1.json"), "--switch", "1", "--out", str(out)).code == 0
    assert len(gl.load_branch(out / "branch-2.json").points) > 1


@pytest.mark.slow
def test_the_first_sentence_is_short(gearlash: Gearlash):
    """However many branches there are: the tables have the rest."""
    ran = gearlash(*SIX, "--switch", "all", "--depth", "2")
    first = ran.out.partition("\n\n")[0]
    assert len(first.splitlines()) <= 3
    assert "3 branches, " in " ".join(first.split())
    assert "stable on branch 1: 6-6-1" in " ".join(first.split())


def test_a_file_of_other_values_or_points_is_refused(gearlash: Gearlash, tmp_path: Path):
    case = gl.load_case("kahraman-singh")
    branch = gl.continue_branch(case, "omega", lower=1.3, upper=1.6, values={"omega": 1.5})
    file = str(gl.save_branch(branch, tmp_path / "branch.json", case))
    ran = gearlash("branch", "kahraman-singh", "--set", "load=0.2", "--set", "D=2", "--resume", file)
    assert ran.code == 2
    assert "--resume load = 0.1: expected 0.2 as in the case; or --set load=0.1" in ran.complaint
    assert "--resume D = 1: " in ran.complaint, "all at once"
    ran = gearlash("branch", "kahraman-singh", "--resume", file, "--at", "7")
    assert "--at = 7: expected a special point of the file, which has 1" in ran.complaint
    assert "a branch of this case" in gearlash("branch", "shaw-holmes", "--resume", file).complaint


@pytest.mark.parametrize("zoom", ["0.6", "0.7:0.6", "0.8:0.9", "omega=0.5:0.6", "a:b", "0.6:0.7um"])
def test_a_part_to_draw_that_is_none_is_refused(gearlash: Gearlash, zoom: str):
    ran = gearlash("branch", "kahraman-singh", "--over", "omega=0.5:0.75", "--near", "0.6", "--zoom", zoom)
    assert ran.code == 2
    assert "FROM:TO, a rising part of the interval of --over in the unit of omega" in ran.complaint


def test_a_part_to_draw_has_the_unit_of_the_interval():
    case = gl.load_case("article")
    over = read_between(case, "pinion_speed=3500:4400rpm")
    typed = [read_zoom(case, over, text) for text in ("3600:4000", "3600rpm:4000rpm", "3600:4000 rpm")]
    assert len(set(typed)) == 1
    assert case.scales.pinion_rpm(typed[0][0]) == pytest.approx(3600.0)


def test_the_folder_has_all_of_it(gearlash: Gearlash, tmp_path: Path):
    ran = gearlash(*SPUR, "--out", str(tmp_path), "--json", "--measure", "amplitude")
    names = {path.name for path in tmp_path.iterdir() if not path.name.startswith(".")}
    assert names == {
        "branch.json", "special.csv", "branch.svg", "branch.pdf",
        "branch-1.json", "branch-1.nc", "branch-1.csv",
    }  # fmt: skip
    assert json.loads((tmp_path / "branch.json").read_text(encoding="utf-8")) == ran.answer
    special = pd.read_csv(tmp_path / "special.csv")
    assert special["value"].tolist() == [each["value"] for each in ran.answer["branches"][0]["special"]]
    orbits, dataset = pd.read_csv(tmp_path / "branch-1.csv"), gl.load_dataset(tmp_path / "branch-1.nc")
    np.testing.assert_allclose(orbits["omega"], dataset["omega"].values, rtol=1e-15)
    np.testing.assert_allclose(orbits["maximum"], dataset["maximum"].values, rtol=1e-12)
    assert len(gl.load_branch(tmp_path / "branch-1.json").points) == len(orbits)


@pytest.mark.slow
def test_branches_of_an_earlier_call_go(gearlash: Gearlash, tmp_path: Path):
    narrow = (*SIX[:-1], "D=0.352:0.38")
    gearlash(*narrow, "--switch", "all", "--out", str(tmp_path))
    assert (tmp_path / "branch-2.nc").exists()
    (tmp_path / "branch-notes.txt").write_text("mine", encoding="utf-8")
    assert gearlash(*narrow, "--out", str(tmp_path)).code == 0
    left = {path.name for path in tmp_path.glob("branch-*")}
    assert left == {"branch-1.json", "branch-1.nc", "branch-1.csv", "branch-notes.txt"}


def test_the_law_at_a_touch(gearlash: Gearlash):
    ran = gearlash(*SPUR, "--law", "--json")
    assert problems(ran.answer, SCHEMA) == []
    low = ran.answer["branches"][0]["special"][0]
    law = low["law"]
    assert law["missing"] == []
    assert (law["predicted"]["kind"], law["computed"]["kind"]) == ("fold", "fold")
    assert law["computed"]["value"] == ran.answer["branches"][0]["special"][1]["value"]
    text = gearlash(*SPUR, "--law").out
    assert "conditions  all hold" in text
    assert "predicted   fold at depth" in text
    assert "computed    no fold or doubling before" not in text
    assert low["law"]["until"] == ""
    short = gearlash(*SPUR[:-1], "omega=1.3:1.6", "--law").out
    assert (
        "computed    no fold or doubling before the end of the branch (lower limit of the parameter)" in short
    )
    corner = ("branch", "kahraman-singh", "--set", "contact=no-tension", "--set", "omega=1.5")
    tried = gearlash(*corner, "--over", "omega=0.7:1.6", "--law", "--json").answer["branches"][0]["special"]
    touches = [each for each in tried if each["kind"] == "grazing"]
    assert touches
    assert all((each["law"] is None) == bool(each["law_missing"]) for each in touches)


def test_where_no_motion_can_be_followed(gearlash: Gearlash):
    ran = gearlash("branch", "article", "--over", "omega=1.1:1.3", "--near", "1.2", "--json")
    assert ran.code == 3
    assert problems(ran.answer, SCHEMA) == []
    assert (ran.answer["status"], ran.answer["branches"]) == ("not-found", [])
    assert "no branch was followed, aperiodic there" in ran.answer["sentence"]
    idle = gearlash("branch", "kahraman-singh", "--set", "error=0", "--over", "omega=0.4:0.6", "--json")
    assert idle.answer["status"] == "not-excited"


def test_a_base_period_of_three_cycles(gearlash: Gearlash):
    ran = gearlash("branch", "two-stage", "--over", "omega=0.5:0.6", "--near", "0.55", "--json")
    assert problems(ran.answer, SCHEMA) == []
    (branch,) = ran.answer["branches"]
    assert branch["period"] % 3 == 0


@pytest.mark.skipif(os.name == "nt", reason="sends SIGINT to this process")
def test_ctrl_c_keeps_what_was_found(gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    heard = []

    @contextmanager
    def interrupting(title: str) -> Iterator[object]:
        def tell(progress: gl.Progress) -> None:
            heard.append(progress.done)
            if progress.done == 3:
                os.kill(os.getpid(), signal.SIGINT)

        yield tell

    monkeypatch.setattr("gearlash.cli.progress.progress_bar", interrupting)
    ran = gearlash(*SPUR, "--out", str(tmp_path), "--json")
    assert ran.code == 130
    kept = gl.load_branch(tmp_path / "branch-1.json")
    assert {str(end.kind) for end in kept.ends} == {"cancelled"}
    assert len(kept.points) == len(heard) + 1
    assert json.loads((tmp_path / "branch.json").read_text(encoding="utf-8"))["status"] == "incomplete"
    dataset = gl.load_dataset(tmp_path / "branch-1.nc")
    assert (dataset.attrs["complete"], dataset.sizes["point"]) == (0, len(kept.points))
    assert not (tmp_path / "branch.svg").exists()
    assert ran.answer["advice"] == "call it again for the rest"


@pytest.mark.slow
def test_what_varies_beside_the_model_is_named_whole_and_resumed_without_over(
    gearlash: Gearlash, tmp_path: Path
):
    case = str(Path(__file__).parents[1] / "cases" / "drawing.toml")
    out = tmp_path / "out"
    ran = gearlash("branch", case, "--over", "pinion.face_width=39.9:40.1mm", "--out", str(out), "--json")
    assert ran.code == 0
    assert ran.answer["axis"]["asked"]["gear"] == "pinion"
    assert "over pinion face width" in (out / "branch.svg").read_text(encoding="utf-8")
    again = gearlash("branch", case, "--resume", str(out / "branch-1.json"), "--json")
    assert again.code == 0
    assert again.answer["axis"]["name"] == "pinion.face_width"
    assert again.answer["axis"]["asked"]["unit"] == "mm"
    other = gearlash("branch", "article", "--resume", str(out / "branch-1.json"))
    assert (other.code, "a branch of this case" in other.complaint) == (2, True)
