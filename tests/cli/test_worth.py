"""A folder of --out keeps what is worth more: what ends early takes the place of no complete answer."""

from __future__ import annotations

import json
import os
import signal
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

import gearlash as gl
from cli.conftest import Gearlash
from cli.short_verify import shorten
from gearlash import plots
from gearlash.cli.commands.reproduce import _keeper
from gearlash.cli.folder import claim
from gearlash.cli.interrupt import signals_answered
from gearlash.cli.marker import MARKER, Worth
from gearlash.jobs import Progress
from gearlash.studies import comparison

pytestmark = pytest.mark.skipif(os.name == "nt", reason="sends SIGINT to this process")
CASES = Path(__file__).resolve().parents[1] / "cases"
DRIVE = str(CASES / "drive.toml")
SWEEP = ("sweep", "kahraman-singh", "--over", "omega=0.5:1.4:13")
BRANCH = ("branch", "article", "--set", "omega=0.942", "--over", "D=0.9:1.1")
LINES = {
    "sweep": SWEEP,
    "map": ("map", "kahraman-singh", "--over", "omega=0.6:0.8:5", "--over", "D=0.5:1.0:4"),
    "zones": ("zones", "kahraman-singh", "--over", "omega=0.5:0.7:7"),
    "zone": ("zones", "article", "--over", "omega=0.95:1.05", "--over", "D=0.9:1.1"),
    "tolerance": ("tolerance", DRIVE, "--over", "omega=0.5:1.4:7", "--limits", "backlash=60:120um",
                  "--samples", "4", "--replicates", "2"),
    "run": ("run", "article"),
    "graze": ("graze", "kahraman-singh", "--set", "omega=0.5"),
    "branch": BRANCH,
    "curve": ("curve", "article", "--set", "omega=0.75", "--near", "0.6", "--over", "D=0.3:0.8",
              "--over", "omega=0.7:0.8", "--from", "1"),
    "atlas": ("atlas", "kahraman-singh", "--over", "omega=0.6:0.8:5", "--over", "D=0.5:1.0:4",
              "--curves", "2", "--lines", "1", "--depth", "0"),
    "report": ("report", DRIVE, "--over", "pinion_speed=3700:4300rpm:13", "--workers", "1"),
    "verify": ("verify", "article", "--quick", "--speed", "4000rpm", "--workers", "1"),
}  # fmt: skip
STAYS = "has more of the answer to this question, which stays; this one, which ended early, is not kept"


@pytest.fixture
def ctrl_c(monkeypatch: pytest.MonkeyPatch) -> Callable[[], None]:
    """From its call on SIGINT is sent, once, when a command tells that it has begun and is not done."""

    def install() -> None:
        sent = []

        def meet(done: int, total: int) -> None:
            if done and done != total and not sent:
                sent.append(done)
                os.kill(os.getpid(), signal.SIGINT)

        def tell(_: object, stage: str, progress: Progress | None) -> None:
            if progress is not None:
                meet(progress.done, progress.total)

        @contextmanager
        def late_bar(title: str, steady: bool = True) -> Iterator[Callable[[int, int], None]]:
            yield meet

        monkeypatch.setattr("gearlash.cli.progress.Lines.tell", tell)
        monkeypatch.setattr("gearlash.cli.late.late_bar", late_bar)

    return install


def _files(folder: Path) -> dict[str, bytes]:
    found = (path for path in folder.rglob("*") if path.is_file() and path.name != MARKER)
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in found}


@pytest.mark.parametrize("name", [pytest.param(name, marks=pytest.mark.slow) for name in LINES])
def test_the_complete_answer_to_the_same_question_stays(
    gearlash: Gearlash, tmp_path: Path, ctrl_c: Callable[[], None], monkeypatch: pytest.MonkeyPatch, name: str
):
    if name == "verify":
        shorten(monkeypatch.setattr)
    monkeypatch.setattr("gearlash.studies.grids.PIXELS", (4, 3))  # of maps in a report
    line = (*LINES[name], "--json", "--out", str(tmp_path))
    assert gearlash(*line).answer["status"] not in ("incomplete", "problem")
    before = _files(tmp_path)
    ctrl_c()
    ran = gearlash(*line)
    assert (ran.code, ran.answer["status"]) == (130, "incomplete"), ran.complaint
    assert STAYS in ran.complaint
    assert _files(tmp_path) == before
    assert not ran.answer.get("report")  # where the page is that this one made


@pytest.mark.slow
def test_a_comparison_that_stays(gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """Stopped between rising and falling speed."""
    data, out = tmp_path / "measured.csv", tmp_path / "out"
    data.write_text(
        "speed [rpm];transmission error peak-to-peak [um]\n4000;9,1\n4010;9,0\n", encoding="utf-8"
    )
    line = ("compare", DRIVE, str(data), "--json", "--out", str(out))
    assert gearlash(*line).answer["status"] == "ok"
    before, run = _files(out), comparison.run

    def signalled(*given: Any) -> Any:
        found = run(*given)
        os.kill(os.getpid(), signal.SIGINT)
        return found

    monkeypatch.setattr(comparison, "run", signalled)
    ran = gearlash(*line)
    assert (ran.code, ran.answer["status"], STAYS in ran.complaint) == (130, "incomplete", True)
    assert _files(out) == before


def test_a_complete_answer_takes_the_place_of_one_that_ended_early(
    gearlash: Gearlash, tmp_path: Path, ctrl_c: Callable[[], None], monkeypatch: pytest.MonkeyPatch
):
    line = (*SWEEP, "--out", str(tmp_path))
    with monkeypatch.context():
        ctrl_c()
        assert gearlash(*line).code == 130
    kept = json.loads((tmp_path / "sweep.json").read_text(encoding="utf-8"))
    assert (kept["status"], (tmp_path / "sweep.svg").exists()) == ("incomplete", False)
    ran = gearlash(*line)
    assert (ran.code, "stays" in ran.complaint) == (0, False)
    kept = json.loads((tmp_path / "sweep.json").read_text(encoding="utf-8"))
    assert (kept["status"], (tmp_path / "sweep.svg").exists()) == ("ok", True)
    assert not list(tmp_path.glob("earlier-*"))


@pytest.mark.parametrize(
    ("line", "beside"),
    [
        (SWEEP, "gearlash.studies.transitions.by_step"),
        (BRANCH, "gearlash.results.branch_dataset.branch_dataset"),
    ],
)
def test_an_answer_without_what_lies_beside_it_takes_the_place_of_no_whole_one(
    gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, line: Sequence[str], beside: str
):
    """It is complete; but its figure, or the extremes of its motions, were given up."""
    line = (*line, "--out", str(tmp_path))
    assert gearlash(*line).code == 0
    before = _files(tmp_path)

    def signalled(*_: Any, **__: Any) -> None:
        os.kill(os.getpid(), signal.SIGINT)

    monkeypatch.setattr(beside, signalled)
    ran = gearlash(*line)
    assert (ran.code, STAYS in ran.complaint) == (130, True)
    assert _files(tmp_path) == before


def test_what_was_deleted_is_worth_nothing(
    gearlash: Gearlash, tmp_path: Path, ctrl_c: Callable[[], None], monkeypatch: pytest.MonkeyPatch
):
    """Nor is an answer to another question, whose note is there."""
    assert gearlash(*SWEEP, "--out", str(tmp_path)).code == 0
    for name in _files(tmp_path):
        if not name.startswith("."):
            (tmp_path / name).unlink()
    ctrl_c()
    ran = gearlash(*SWEEP, "--set", "mesh_damping=0.06", "--out", str(tmp_path))
    assert (ran.code, "stays" in ran.complaint) == (130, False)
    kept = json.loads((tmp_path / "sweep.json").read_text(encoding="utf-8"))
    assert kept["status"] == "incomplete"


def test_figures_stay_until_they_are_drawn_again(
    gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    line = (*SWEEP, "--out", str(tmp_path))
    assert gearlash(*line).code == 0
    before = set(_files(tmp_path))
    monkeypatch.setattr(plots, "save", lambda *_: os.kill(os.getpid(), signal.SIGINT))
    assert gearlash(*line).code == 130
    assert set(_files(tmp_path)) == before


def test_sweeps_of_a_reproduction_are_kept_by_the_same_rule(tmp_path: Path):
    case = gl.load_case("article")
    axis = gl.Axis.even("omega", 0.99, 1.0, 2)
    whole = gl.sweep(case, axis)
    keep = _keeper(case, claim(tmp_path, ["sweep-omega.json", "sweep-omega.nc"]))
    with signals_answered():
        keep("omega", [whole])
    before = _files(tmp_path)
    assert set(before) == {"sweep-omega.json", "sweep-omega.nc"}
    part = gl.sweep(case, axis, execution=gl.Execution(cancel=_AfterOne()))
    assert (part.complete, part.computed) == (False, 1)
    with signals_answered():
        keep("omega", [part])
    assert _files(tmp_path) == before
    folder = claim(tmp_path, ["sweep-omega.json", "sweep-omega.nc"])
    assert folder.make_room() == {"sweep-omega.json": Worth.WHOLE}


class _AfterOne:
    """Stops a study after its first point."""

    def __init__(self) -> None:
        self.asked = 0

    def is_set(self) -> bool:
        self.asked += 1
        return self.asked > 1
