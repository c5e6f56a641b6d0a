"""--out never writes over what gearlash did not write."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest

import gearlash as gl
from cli.conftest import Gearlash
from gearlash.cli.folder import claim
from gearlash.cli.marker import MARKER, Marker
from gearlash.system import GearlashError

CASES = Path(__file__).resolve().parents[1] / "cases"


def test_own_files_may_be_written_again(tmp_path: Path):
    folder = claim(tmp_path / "deep" / "out", ["run.json"])
    folder.file("run.json").write_text("1", encoding="utf-8")
    assert claim(folder.path, ["run.json", "more.json"]).file("run.json").read_text(encoding="utf-8") == "1"
    folder.file("more.json").write_text("2", encoding="utf-8")
    claim(folder.path, ["more.json"])


@pytest.mark.parametrize("with_marker", [True, False])
def test_foreign_files_are_left_alone(with_marker: bool, tmp_path: Path):
    if with_marker:
        claim(tmp_path, ["other.json"])
    (tmp_path / "run.json").write_text("mine", encoding="utf-8")
    with pytest.raises(GearlashError, match=r"run\.json is there and was not written by gearlash"):
        claim(tmp_path, ["run.json"])
    assert (tmp_path / "run.json").read_text(encoding="utf-8") == "mine"


def test_foreign_files_of_other_names_do_not_matter(tmp_path: Path):
    (tmp_path / "notes.txt").write_text("mine", encoding="utf-8")
    claim(tmp_path, ["run.json"])
    assert (tmp_path / "notes.txt").read_text(encoding="utf-8") == "mine"


def test_a_marker_that_is_not_ours_is_respected(tmp_path: Path):
    (tmp_path / MARKER).write_text("[]", encoding="utf-8")
    with pytest.raises(GearlashError, match="not one of gearlash"):
        claim(tmp_path, ["run.json"])
    assert (tmp_path / MARKER).read_text(encoding="utf-8") == "[]"


def test_a_file_in_the_place_of_the_folder(tmp_path: Path):
    (tmp_path / "out").write_text("mine", encoding="utf-8")
    with pytest.raises(GearlashError, match="cannot be written"):
        claim(tmp_path / "out", ["run.json"])


def test_refused_before_anything_is_computed(
    gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    (tmp_path / "graze.json").write_text("mine", encoding="utf-8")
    monkeypatch.setattr("gearlash.studies.point", None)  # computing would fail
    ran = gearlash("graze", "article", "--out", str(tmp_path))
    assert ran.code == 2
    assert "graze.json is there" in ran.complaint


def test_halves_of_files_that_a_killed_command_left_go(tmp_path: Path):
    """Its own, of the names that are claimed; nothing else."""
    claim(tmp_path, ["run.json"])
    halves = [tmp_path / ".run.json.0123456789ab.part", tmp_path / ".sweep.nc.0123456789ab.part"]
    for path in (*halves, tmp_path / "run.json.part"):
        path.write_text("half", encoding="utf-8")
    claim(tmp_path, ["run.json"])
    left = sorted(path.name for path in tmp_path.iterdir())
    assert left == sorted([MARKER, halves[1].name, "run.json.part"])


CASE = ("run", "kahraman-singh")


def test_the_same_question_takes_the_place_of_its_own_answer(gearlash: Gearlash, tmp_path: Path):
    for more in ((), ("--json",), ("--csv",)):  # how it is told changes no question
        assert gearlash(*CASE, *more, "--out", str(tmp_path)).code == 0
    assert not list(tmp_path.glob("earlier-*"))


def test_settings_in_another_order_are_the_same_question(gearlash: Gearlash, tmp_path: Path):
    asked = ("--set", "omega=0.5"), ("--set", "load=0.3")
    for one, other in (asked, reversed(asked)):
        ran = gearlash("check", "kahraman-singh", *one, *other, "--out", str(tmp_path))
        assert (ran.code, ran.complaint) == (0, "")
    assert not list(tmp_path.glob("earlier-*"))


def test_answers_to_other_questions_are_kept_each_whole(gearlash: Gearlash, tmp_path: Path):
    answers = []
    for speed in ("0.5", "0.6", "0.7"):
        ran = gearlash(*CASE, "--set", f"omega={speed}", "--out", str(tmp_path))
        assert ran.code == 0
        assert ("is kept in" in ran.complaint) == (speed != "0.5")
        answers.append({name: (tmp_path / name).read_bytes() for name in ("run.json", "history.nc")})
    assert {path.name for path in tmp_path.glob("earlier-*")} == {"earlier-1", "earlier-2"}
    for number, answer in enumerate(answers[:-1], 1):
        for name, content in answer.items():
            assert (tmp_path / f"earlier-{number}" / name).read_bytes() == content
    assert gearlash(*CASE, "--set", "omega=0.7", "--out", str(tmp_path)).code == 0
    assert len(list(tmp_path.glob("earlier-*"))) == 2


def test_what_was_answered_stays_where_a_question_is_refused(gearlash: Gearlash, tmp_path: Path):
    claim(tmp_path, ["tolerance.json"]).file("tolerance.json").write_text("kept", encoding="utf-8")
    line = ("tolerance", str(CASES / "drive.toml"), "--over", "pinion_speed=2800:3200:4")  # without unit
    refused = gearlash(*line, "--limits", "torque=140:160Nm", "--out", str(tmp_path))
    assert refused.code == 2
    assert "is kept in" not in refused.complaint
    assert {path.name for path in tmp_path.iterdir()} == {MARKER, "tolerance.json"}
    assert (tmp_path / "tolerance.json").read_text(encoding="utf-8") == "kept"


STOPPED = """
import os, signal, sys, time
import gearlash.orbits

def stopped(*_):
    os.kill(os.getpid(), signal.SIGINT)
    time.sleep(60.0)  # another thread ends the process

signal.signal(signal.SIGINT, signal.default_int_handler)  # who started the tests may have ignored it
gearlash.orbits.attractor = stopped
from gearlash.cli import main
main()
"""


@pytest.mark.skipif(sys.platform == "win32", reason="sends SIGINT")
def test_what_was_answered_stays_where_nothing_is_computed(gearlash: Gearlash, tmp_path: Path):
    """Another question, stopped before its first point."""
    assert gearlash(*CASE, "--out", str(tmp_path)).code == 0
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir() if path.name != MARKER}
    line = [*CASE, "--set", "omega=0.6", "--out", str(tmp_path)]
    ended = subprocess.run(
        [sys.executable, "-c", STOPPED, *line], capture_output=True, text=True, check=False
    )
    assert (ended.returncode, "is kept in" in ended.stderr) == (130, False)
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir() if path.name != MARKER} == before
    assert gearlash(*CASE, "--out", str(tmp_path)).complaint == ""


def test_a_file_that_says_something_else_makes_another_question(gearlash: Gearlash, tmp_path: Path):
    case, out = tmp_path / "case.toml", tmp_path / "out"
    text = (CASES / "drive.toml").read_text(encoding="utf-8")
    for torque in ("150 N m", "160 N m"):
        case.write_text(text.replace("150 N m", torque), encoding="utf-8")
        assert gearlash("check", str(case), "--out", str(out)).code == 0
    assert (out / "earlier-1" / "check.json").is_file()
    assert (out / "check.json").is_file()


def _order(lines: Sequence[str]) -> list[str]:
    """Those of the second table the other way round."""
    begin = next(i for i, line in enumerate(lines) if line.startswith("[")) + 1
    end = next(i for i, line in enumerate(lines) if i > begin and line[:1] in ("", "["))
    return [*lines[:begin], *reversed(lines[begin:end]), *lines[end:]]


@pytest.mark.parametrize(
    "edited",
    [
        pytest.param(lambda lines: ["# seen by me", *lines], id="a comment"),
        pytest.param(lambda lines: [f"{line}  " for line in lines], id="white space"),
        pytest.param(_order, id="order"),
        pytest.param(lambda lines: [line.replace("D = 1.0", "D = 1") for line in lines], id="a number"),
    ],
)
def test_a_case_that_says_the_same_is_the_same_question(
    gearlash: Gearlash, tmp_path: Path, edited: Callable[[Sequence[str]], list[str]]
):
    case, out, points = tmp_path / "case.toml", tmp_path / "out", tmp_path / "k.csv"
    points.write_text("angle [cycle],stiffness\n0,1.0\n0.5,1.2\n", encoding="utf-8")
    text = CURVE.format(named="k.csv")
    case.write_text(text, encoding="utf-8")
    assert gearlash("check", str(case), "--out", str(out)).code == 0
    after = "\n".join(edited(text.split("\n")))
    assert after != text
    case.write_text(after, encoding="utf-8")
    points.write_text("# measured twice\nangle [cycle],stiffness\n0,1.0\n0.5,1.20\n", encoding="utf-8")
    ran = gearlash("check", str(case), "--out", str(out))
    assert (ran.code, ran.complaint) == (0, "")
    assert not list(out.glob("earlier-*"))


@pytest.mark.parametrize("way", ["beside", "deeper", "absolute"])
def test_a_file_that_the_case_names_belongs_to_its_question(way: str, gearlash: Gearlash, tmp_path: Path):
    (tmp_path / "deep").mkdir()
    case, out = tmp_path / "case.toml", tmp_path / "out"
    named = {"beside": "k.csv", "deeper": "deep/k.csv", "absolute": str(tmp_path / "k.csv")}[way]
    case.write_text(CURVE.format(named=named), encoding="utf-8")
    points, answers = tmp_path / named, []
    for ripple in (0.1, 0.3, 0.3):
        rows = [f"{turn / 8},{1.0 + ripple * (turn % 2)}" for turn in range(8)]
        points.write_text("\n".join(["angle [cycle],stiffness", *rows]), encoding="utf-8")
        ran = gearlash("run", str(case), "--out", str(out))
        assert ran.code == 0, ran.complaint
        answers.append((out / "run.json").read_bytes())
    assert answers[0] != answers[1]
    assert (out / "earlier-1" / "run.json").read_bytes() == answers[0]
    assert len(list(out.glob("earlier-*"))) == 1  # the third question was the second one


CURVE = """
kind = "spur-1dof"
[dimensionless]
omega = 0.7
D = 1.0
load = 0.2
error = 0.05
mesh_damping = 0.05
[curves.stiffness]
file = '{named}'
"""


@pytest.mark.parametrize("what", ["another answer", "another figure", "a file of it gone"])
def test_what_has_changed_since_it_was_answered_is_no_answer_to_its_question(
    what: str, gearlash: Gearlash, tmp_path: Path
):
    """The library, or anybody, may have put something else there."""
    assert gearlash(*CASE, "--out", str(tmp_path)).code == 0
    name = {"another answer": "run.json", "another figure": "history.svg"}.get(what, "portrait.pdf")
    (tmp_path / name).unlink()
    if what != "a file of it gone":
        (tmp_path / name).write_text("mine", encoding="utf-8")
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir() if path.name != MARKER}
    ran = gearlash(*CASE, "--out", str(tmp_path))
    assert ran.code == 0
    assert (
        "answered there before, changed since, or with other values or options, is kept in" in ran.complaint
    )
    kept = tmp_path / "earlier-1"
    assert {path.name: path.read_bytes() for path in kept.iterdir()} == before
    assert (tmp_path / name).read_bytes() != b"mine"


@pytest.mark.slow
def test_a_report_of_the_library_is_kept(gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("gearlash.studies.grids.PIXELS", (4, 3))  # of its maps
    line = ("report", str(CASES / "drive.toml"), "--over", "pinion_speed=3700:4300rpm:13", "--workers", "1")
    assert gearlash(*line, "--out", str(tmp_path)).code == 0
    case = gl.load_case("kahraman-singh", {"omega": 0.55})
    gl.pair_report(case, tmp_path, speeds=gl.Axis.even("omega", 0.5, 0.6, 5))
    page = (tmp_path / "report.html").read_bytes()
    ran = gearlash(*line, "--out", str(tmp_path))
    assert (ran.code, "is kept in" in ran.complaint) == (0, True)
    assert (tmp_path / "earlier-1" / "report.html").read_bytes() == page
    assert (tmp_path / "report.html").read_bytes() != page


def test_a_note_of_the_user_among_figures_changes_no_answer(tmp_path: Path):
    folder = claim(tmp_path, ["figures"])
    folder.make_room()
    folder.file("figures").mkdir()
    (folder.file("figures") / "force.svg").write_text("1", encoding="utf-8")
    folder.note()
    (folder.file("figures") / "note.txt").write_text("mine", encoding="utf-8")
    marker = Marker.read(tmp_path)
    assert marker.as_left(tmp_path, ["figures"])
    (folder.file("figures") / "force.svg").write_text("2", encoding="utf-8")
    assert not marker.as_left(tmp_path, ["figures"])


def test_a_folder_of_the_user_is_not_taken_for_what_is_kept(gearlash: Gearlash, tmp_path: Path):
    (tmp_path / "earlier-1").write_text("mine", encoding="utf-8")
    for speed in ("0.5", "0.6"):
        assert gearlash(*CASE, "--set", f"omega={speed}", "--out", str(tmp_path)).code == 0
    assert (tmp_path / "earlier-1").read_text(encoding="utf-8") == "mine"
    assert (tmp_path / "earlier-2" / "run.json").is_file()


@pytest.mark.parametrize("claimed", [True, False])
def test_a_marker_from_elsewhere_moves_what_it_wrote_alone(claimed: bool, gearlash: Gearlash, tmp_path: Path):
    out = tmp_path / "out"
    out.mkdir()
    for place in (tmp_path / "mine.txt", out / "run.json", out / "thesis.txt"):
        place.write_text("mine", encoding="utf-8")
    named = ["run.json", "../mine.txt", str(tmp_path / "mine.txt"), MARKER, "..", ".", ""]
    asked = dict.fromkeys([*named, "thesis.txt"], "1")
    marker = {"process": 1, "files": named if claimed else ["run.json"], "asked": asked}
    (out / MARKER).write_text(json.dumps(marker), encoding="utf-8")
    ran = gearlash(*CASE, "--out", str(out))
    assert ran.code == 0, ran.complaint
    assert (tmp_path / "mine.txt").read_text(encoding="utf-8") == "mine"
    assert (out / "thesis.txt").read_text(encoding="utf-8") == "mine"
    assert [path.name for path in (out / "earlier-1").iterdir()] == ["run.json"]
