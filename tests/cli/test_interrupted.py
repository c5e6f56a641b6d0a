"""Ctrl-C in the middle of a command that has something to keep: what it has, marked incomplete."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from cli.conftest import Gearlash
from gearlash.cli import interrupt
from gearlash.jobs import NoWorkersError
from gearlash.jobs.stop import interruptible, stopping
from gearlash.results import store

pytestmark = pytest.mark.skipif(os.name == "nt", reason="sends SIGINT to this process")
Tell = Callable[[int, int], None]


@pytest.fixture
def ctrl_c(monkeypatch: pytest.MonkeyPatch) -> Callable[[str, int], None]:
    """Sends SIGINT when a late bar of this title would show so much."""

    def install(where: str, at: int) -> None:
        sent = []

        @contextmanager
        def interrupting(title: str, steady: bool = True) -> Iterator[Tell]:
            def tell(done: int, total: int) -> None:
                if title == where and done >= at and not sent:
                    sent.append(done)
                    os.kill(os.getpid(), signal.SIGINT)

            yield tell

        monkeypatch.setattr("gearlash.cli.late.late_bar", interrupting)

    return install


def test_graze_keeps_the_way_it_has_gone(
    gearlash: Gearlash, tmp_path: Path, ctrl_c: Callable[[str, int], None]
):
    ctrl_c("following the motion", 10)
    ran = gearlash("graze", "kahraman-singh", "--set", "omega=0.5", "--out", str(tmp_path))
    assert ran.code == 130
    answer = json.loads((tmp_path / "graze.json").read_text(encoding="utf-8"))
    assert (answer["status"], answer["advice"]) == ("incomplete", "call it again for the rest")
    down, up = answer["paths"]
    assert (down["ended"], down["decided"], up["ended"], up["reached"]) == (
        "interrupted", False, "interrupted", 0.5,
    )  # fmt: skip
    assert down["reached"] < 0.5
    assert "interrupted there on the way down and up" in answer["sentence"]
    assert "interrupted there on the way down and up" in " ".join(ran.out.split())


@pytest.mark.parametrize("where", ["other starts", "speeds free of impacts"])
def test_run_keeps_the_motion(
    gearlash: Gearlash, tmp_path: Path, ctrl_c: Callable[[str, int], None], where: str
):
    ctrl_c(where, 2)
    ran = gearlash("run", "article", "--json", "--out", str(tmp_path))
    assert (ran.code, ran.answer["status"], ran.answer["label"]) == (130, "incomplete", "1-0-0")
    assert ran.answer["impact_free"] is None
    assert (ran.answer["beside"] is None) is (where == "other starts")
    assert "interrupted before" in ran.answer["message"]
    assert json.loads((tmp_path / "run.json").read_text(encoding="utf-8")) == ran.answer
    assert not (tmp_path / "portrait.svg").exists()


def test_run_keeps_a_motion_without_its_numbers(
    gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    """Of a slow system they take longer than anybody waits after Ctrl-C."""

    def interrupted(attractor: object, readout: object) -> None:
        os.kill(os.getpid(), signal.SIGINT)

    monkeypatch.setattr("gearlash.cli.answers.run.motion_numbers", interrupted)
    ran = gearlash("run", "article", "--json", "--out", str(tmp_path))
    assert (ran.code, ran.answer["status"], ran.answer["label"]) == (130, "incomplete", "1-0-0")
    assert (ran.answer["numbers"], ran.answer["beside"]) == (None, None)
    assert "before its numbers and other starts and speeds free of impacts" in ran.answer["message"]
    assert sorted(path.name for path in tmp_path.glob("*.*") if path.name[0] != ".") == ["run.json"]


@pytest.mark.parametrize("late", ["_hear", "_break_off"])
def test_that_the_command_stops_is_told_before_how_it_ended(
    gearlash: Gearlash, monkeypatch: pytest.MonkeyPatch, late: str
):
    """Whichever thread comes first to the signal."""

    def study(*_: object, **__: object) -> None:
        with interruptible():
            os.kill(os.getpid(), signal.SIGINT)
            while not stopping():
                time.sleep(0.01)
            raise KeyboardInterrupt

    handler, told = getattr(interrupt, late), []
    monkeypatch.setattr(interrupt, late, lambda *args: (time.sleep(0.2), handler(*args)))
    monkeypatch.setattr(interrupt, "_say", lambda text: told.append(text.decode().strip()))
    monkeypatch.setattr("gearlash.cli.exits.tell", told.append)
    monkeypatch.setattr("gearlash.studies.tolerances.tolerance", study)
    ran = gearlash("tolerance", "article", "--over", "omega=0.9:1.0:3", "--limits", "D=0.3:0.4")
    assert ran.code == 130
    assert told == [interrupt.STOPPING.decode().strip(), "interrupted"]


def test_files_that_belong_together_are_there_together_or_as_before(tmp_path: Path):
    one, other, figure = tmp_path / "a.nc", tmp_path / "a.json", tmp_path / "a.svg"
    store.write_together({one: b"1", other: b"1"})
    figure.write_bytes(b"of 1")
    with pytest.raises(OSError, match=r"missing.b\.json"):
        store.write_together({one: b"2", tmp_path / "missing" / "b.json": b"2"}, instead_of=[figure])
    assert (one.read_bytes(), other.read_bytes(), figure.exists()) == (b"1", b"1", True)
    store.write_together({one: b"3", other: b"3"}, instead_of=[figure])
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == {"a.nc": b"3", "a.json": b"3"}


def test_an_end_at_once_waits_for_files_that_are_being_moved(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """And takes away those that are not whole."""
    monkeypatch.setattr(store, "MOVED", 0.01)
    one, other = tmp_path / "a.nc", tmp_path / "a.json"
    seen = []
    replace = Path.replace

    def replaced(part: Path, path: Path) -> Path:
        found = replace(part, path)
        seen.append(store._changing.locked())
        return found

    monkeypatch.setattr(Path, "replace", replaced)
    store.write_together({one: b"1", other: b"1"})
    assert seen == [True, True]
    part = tmp_path / ".a.nc.part"
    part.write_bytes(b"half")
    monkeypatch.setattr(store, "_unfinished", {part})
    store.give_up()
    store._changing.release()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.json", "a.nc"]


def test_no_file_is_begun_after_an_end_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """The thread that ends the process takes away what is not whole; what writes goes on till then."""
    given_up = threading.Event()

    def synced(_handle: int) -> None:
        if not given_up.is_set():
            store.give_up()
            given_up.set()

    monkeypatch.setattr(os, "fsync", synced)
    contents = {tmp_path / "a.nc": b"1", tmp_path / "a.json": b"1"}

    def write() -> None:
        with contextlib.suppress(OSError):  # the first part is gone
            store.write_together(contents)

    writing = threading.Thread(target=write, daemon=True)
    writing.start()
    assert given_up.wait(10.0)
    writing.join(0.2)
    assert writing.is_alive()
    assert not list(tmp_path.iterdir())
    store._changing.release()
    writing.join(10.0)


def test_workers_that_die_before_anything_was_computed_have_exit_code_5(
    gearlash: Gearlash, monkeypatch: pytest.MonkeyPatch
):
    def died(*arguments: object, **options: object) -> None:
        raise NoWorkersError("a worker process died before anything was computed")

    monkeypatch.setattr("gearlash.studies.sweeps", died)
    ran = gearlash("sweep", "article", "--over", "omega=0.5:0.6:3", "--workers", "1")
    assert (ran.code, ran.out) == (5, "")
    assert "died before anything" in ran.err
