"""--out: no link is replaced, and two commands do not mix their files."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from cli.conftest import Gearlash
from gearlash.cli import hold as holding
from gearlash.cli.folder import claim
from gearlash.cli.marker import MARKER
from gearlash.system import GearlashError

linux = pytest.mark.skipif(sys.platform == "win32", reason="links and signals as POSIX has them")
KEEPER = """
import sys
from pathlib import Path
from gearlash.cli.folder import claim
folder = claim(Path(sys.argv[1]), ["run.json"])
print("claimed", flush=True)
sys.stdin.read()
"""


@linux
@pytest.mark.parametrize("own", [False, True])
@pytest.mark.parametrize("target", ["nowhere", "elsewhere"])
@pytest.mark.parametrize("name", ["run.json", MARKER])
def test_a_link_is_not_replaced(name: str, target: str, own: bool, tmp_path: Path):
    (tmp_path / "elsewhere").write_text('{"files": []}', encoding="utf-8")
    out = tmp_path / "out"
    out.mkdir()
    if own:
        claim(out, ["run.json"])
    (out / name).unlink(missing_ok=True)
    (out / name).symlink_to(tmp_path / target)
    with pytest.raises(GearlashError, match=r"is there and was not written|not one of gearlash"):
        claim(out, ["run.json"])
    assert (out / name).readlink() == tmp_path / target
    assert not (tmp_path / "nowhere").exists()
    assert (tmp_path / "elsewhere").read_text(encoding="utf-8") == '{"files": []}'


@linux
def test_a_link_in_the_place_of_the_folder(tmp_path: Path, gearlash: Gearlash):
    (tmp_path / "out").symlink_to(tmp_path / "nowhere")
    ran = gearlash("run", "kahraman-singh", "--out", str(tmp_path / "out"))
    assert ran.code == 2
    assert "is a link to what is no folder" in ran.complaint
    (tmp_path / "nowhere").mkdir()
    assert claim(tmp_path / "out", ["run.json"]).file("run.json").parent.is_dir()


@linux
def test_a_marker_that_is_no_file(tmp_path: Path):
    os.mkfifo(tmp_path / MARKER)
    with pytest.raises(GearlashError, match="not one of gearlash"):
        claim(tmp_path, ["run.json"])


@pytest.mark.parametrize(
    "content", ["[" * 100_000, '{"files": 3}', "{}", "9" * 5000, " " * 200_000, '{"files": "ab"}']
)
def test_a_marker_of_any_content(content: str, tmp_path: Path):
    (tmp_path / MARKER).write_text(content, encoding="utf-8")
    with pytest.raises(GearlashError, match="not one of gearlash"):
        claim(tmp_path, ["run.json"])


@pytest.fixture
def keeper(tmp_path: Path):
    """A process that has claimed the folder."""
    started = subprocess.Popen(
        [sys.executable, "-c", KEEPER, str(tmp_path)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    assert started.stdin is not None
    assert started.stdout is not None
    assert started.stdout.readline() == "claimed\n"
    yield started
    started.kill()
    started.wait()
    started.stdin.close()
    started.stdout.close()


def test_a_second_command_is_refused_and_told_which_runs(
    keeper: subprocess.Popen[str], tmp_path: Path, gearlash: Gearlash
):
    before = (tmp_path / MARKER).read_bytes()
    ran = gearlash("run", "kahraman-singh", "--out", str(tmp_path))
    assert ran.code == 2
    assert f"another command (process {keeper.pid}) is writing there" in ran.complaint
    assert (tmp_path / MARKER).read_bytes() == before
    assert [path.name for path in tmp_path.iterdir()] == [MARKER]


@linux
@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM])
def test_a_command_that_was_killed_leaves_no_lock(
    number: signal.Signals, keeper: subprocess.Popen[str], tmp_path: Path
):
    keeper.send_signal(number)
    keeper.wait()
    assert json.loads((tmp_path / MARKER).read_text(encoding="utf-8"))["process"] == keeper.pid
    claim(tmp_path, ["run.json"])


def test_one_process_may_claim_a_folder_again(tmp_path: Path):
    first = claim(tmp_path, ["run.json"])
    second = claim(tmp_path, ["sweep.json"])
    assert first.held is second.held


@linux
def test_where_folders_cannot_be_locked_a_file_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    def refused(*_: object) -> None:
        raise OSError(95, "Operation not supported")

    monkeypatch.setattr(holding.fcntl, "flock", refused)
    folder = claim(tmp_path, ["run.json"])
    assert (tmp_path / holding.LOCK).exists()
    again = KEEPER.replace("from gearlash.cli.folder", FLOCK + "from gearlash.cli.folder")
    command = [sys.executable, "-c", again, str(tmp_path)]
    second = subprocess.run(command, capture_output=True, text=True, check=False)
    assert "another command" in second.stderr
    del folder
    third = subprocess.run(command, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL)
    assert third.stdout == "claimed\n", third.stderr


FLOCK = """
import fcntl
def refused(*_):
    raise OSError(95, "Operation not supported")
fcntl.flock = refused
"""
