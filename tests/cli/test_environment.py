"""What the surroundings lack: each command ends as docs/cli.md says. Real processes, nothing replaced."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import gearlash as gl
from gearlash._kernel import compile_all, load_all
from gearlash._kernel.cache import version_folder
from gearlash.cli.marker import MARKER
from gearlash.results import load

resource = pytest.importorskip("resource")
pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="devices and limits of Linux")

COMMAND = [sys.executable, "-c", "from gearlash.cli import main; main()"]
RUN = ("run", "kahraman-singh")
SWEEP = ("sweep", "kahraman-singh", "--over", "omega=0.9:0.95:3", "--cold", "--workers", "1")


def process(
    *arguments: str, env: dict[str, str] | None = None, **options: Any
) -> subprocess.CompletedProcess[str]:
    """One command in a process of its own."""
    options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options}
    every = {**os.environ, "PYTHONUTF8": "1", **(env or {})}
    return subprocess.run([*COMMAND, *arguments], env=every, text=True, check=False, **options)


@pytest.mark.parametrize(
    "arguments", [("check", "article"), ("schema",), ("check", "--help"), ("--version",)]
)
def test_standard_output_on_a_full_disk(arguments: tuple[str, ...]):
    with open("/dev/full", "w") as full:  # noqa: PTH123
        ran = process(*arguments, stdout=full)
    assert (ran.returncode, ran.stderr) == (
        4,
        "gearlash: standard output cannot be written (No space left on device)\n",
    )


def test_a_problem_as_json_on_a_full_disk_is_still_a_problem():
    with open("/dev/full", "w") as full:  # noqa: PTH123
        ran = process("check", "artcle", "--json", stdout=full)
        nowhere = process("check", "artcle", stdout=full, stderr=full)
    assert ran.returncode == nowhere.returncode == 2
    assert "'article'" in ran.stderr
    assert "Traceback" not in ran.stderr


FEW_BYTES_A_FILE = """
import resource
from gearlash.cli import main
from gearlash.cli.notice import load_engine
load_engine()  # whose temporary files are larger
resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
main()
"""


@pytest.mark.parametrize(("arguments", "shown"), [(RUN, "1-"), (SWEEP, "From cold starts")])
def test_a_disk_that_is_full_when_results_are_written(arguments: tuple[str, ...], shown: str, tmp_path: Path):
    every = {**os.environ, "PYTHONUTF8": "1"}
    ran = subprocess.run(
        [sys.executable, "-c", FEW_BYTES_A_FILE, *arguments, "--out", str(tmp_path)],
        env=every, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert ran.returncode == 4
    assert shown in ran.stdout
    name = tmp_path / ("run.json" if "run" in arguments else "sweep.nc")
    assert " ".join(ran.stderr.split()) == f"gearlash: {name} cannot be written (File too large)"
    assert [path.name for path in tmp_path.iterdir()] == [MARKER]


@pytest.mark.parametrize("place", ["file", "file/below"])
def test_out_where_nothing_can_be_written(place: str, tmp_path: Path):
    (tmp_path / "file").write_text("mine", encoding="utf-8")
    ran = process(*RUN, "--out", str(tmp_path / place))
    assert (ran.returncode, ran.stdout) == (2, "")
    assert "cannot be written" in " ".join(ran.stderr.split())
    assert (tmp_path / "file").read_text(encoding="utf-8") == "mine"


def test_a_reader_that_leaves_before_the_first_line_still_gets_its_files(tmp_path: Path):
    started = subprocess.Popen(
        [*COMMAND, "graze", "article", "--out", str(tmp_path)], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    assert started.stdout is not None
    assert started.stderr is not None
    started.stdout.close()
    said = started.stderr.read()  # how far it is, where the machine is slow
    started.stderr.close()
    assert started.wait() == 0
    assert all(line.startswith(b"following") for line in said.splitlines()), said
    assert json.loads((tmp_path / "graze.json").read_text(encoding="utf-8"))["points"]


@pytest.mark.parametrize("arguments", [("--help",), ("check", "--help"), ("--version",), ("schema",)])
def test_help_may_be_cut_short_too(arguments: tuple[str, ...]):
    started = subprocess.Popen([*COMMAND, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    assert started.stdout is not None
    assert started.stderr is not None
    started.stdout.close()
    assert started.stderr.read() == b""
    started.stderr.close()
    assert started.wait() == 0


@pytest.mark.parametrize(("case", "code"), [("article", 0), ("artcle", 2)])
@pytest.mark.parametrize("closed", ["2>&-", ">&- 2>&-", "2>/dev/full", "<&-"])
def test_streams_closed_from_the_start(closed: str, case: str, code: int):
    script = f"exec {COMMAND[0]} -c '{COMMAND[2]}' check {case} {closed}"
    assert subprocess.run(["sh", "-c", script], capture_output=True, check=False).returncode == code


ASCII = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}


@pytest.mark.parametrize("arguments", [RUN, SWEEP, ("check", "--help"), ("schema",), ("check", "ärticle")])
def test_a_terminal_that_knows_ascii_only(arguments: tuple[str, ...]):
    ran = process(*arguments, env=ASCII, encoding="ascii")
    assert ran.returncode == (2 if "ärticle" in arguments else 0)
    assert ran.stdout + ran.stderr
    assert "Traceback" not in ran.stderr


def test_a_case_in_signs_that_the_terminal_lacks(tmp_path: Path):
    path = tmp_path / "räder-🦷.toml"
    path.write_text((Path(gl.__file__).parent / "case/data/article.toml").read_text("utf-8"), "utf-8")
    ran = process("check", str(path), env=ASCII, encoding="ascii")
    assert (ran.returncode, ran.stderr) == (0, "")
    out = process("graze", str(path), "--out", str(tmp_path / "größe"), env=ASCII, encoding="ascii")
    assert out.returncode == 0
    told = out.stderr.splitlines()  # how far it is, where the machine is slow
    assert all(line.startswith("following") for line in told), out.stderr
    assert (tmp_path / "größe" / "graze.json").exists()


def in_terminal(
    *arguments: str, env: dict[str, str], seen: Callable[[str], object] | None = None
) -> tuple[int, str]:
    """Exit code and what a terminal gets; ``seen`` is called with all of it so far."""
    import pty

    parent, child = pty.openpty()
    every = {**os.environ, "PYTHONUTF8": "1", **env}
    started = subprocess.Popen(
        [*COMMAND, *arguments], stdin=child, stdout=child, stderr=child, env=every, start_new_session=True
    )
    os.close(child)
    text = b""
    while True:
        try:
            part = os.read(parent, 65536)
        except OSError:  # the terminal of a process that has ended
            part = b""
        if not part:
            break
        text += part
        if seen is not None and seen(text.decode("utf-8", "replace")):
            os.killpg(started.pid, signal.SIGINT)
            seen = None
    os.close(parent)
    return started.wait(), text.decode("utf-8")


COLOUR = re.compile(r"\x1b\[[0-9;]*3[0-9]")


def test_colours_only_where_they_are_wanted():
    wanted = {"TERM": "xterm-256color", "COLUMNS": "80"}
    os.environ.pop("NO_COLOR", None)
    code, text = in_terminal("check", "artcle", env=wanted)
    assert code == 2
    assert COLOUR.search(text)
    code, text = in_terminal("check", "artcle", env={**wanted, "NO_COLOR": "1"})
    assert not COLOUR.search(text)
    code, text = in_terminal(*SWEEP, env={"TERM": "dumb", "COLUMNS": "80"})
    assert code == 0
    assert "\x1b" not in text


@pytest.mark.parametrize("columns", ["20", "1", "0", "-5", "many"])
def test_a_terminal_of_any_width(columns: str):
    ran = process("check", "article", env={"COLUMNS": columns})
    assert (ran.returncode, ran.stderr) == (0, "")
    assert "mesh.backlash" in ran.stdout
    assert process("check", "artcle", env={"COLUMNS": columns}).returncode == 2


@pytest.mark.parametrize("workers", ["1", "2"])
def test_ctrl_c_from_the_terminal_leaves_a_usable_file(workers: str, tmp_path: Path):
    def some_are_done(text: str) -> bool:
        return re.search(r"[1-9]\d*/3000\b", text) is not None

    arguments = ("--over", "omega=0.9:0.95:3000", "--cold", "--workers", workers, "--out", str(tmp_path))
    code, text = in_terminal(
        "sweep", "kahraman-singh", *arguments, env={"TERM": "xterm", "COLUMNS": "100"}, seen=some_are_done
    )
    assert code == 130
    assert "Traceback" not in text
    assert "incomplete" in text
    dataset = load(tmp_path / "sweep.nc")
    status = [str(s) for s in dataset["status"].values[0]]
    assert dataset.attrs["complete"] == 0
    assert 0 < status.count("not-computed") < 3000
    assert not (tmp_path / "sweep.svg").exists()


def test_a_damaged_cache_is_compiled_again_and_told(tmp_path: Path):
    from gearlash import flow  # noqa: F401 - declares the kernels

    compile_all(load_all())
    shutil.copytree(version_folder(), tmp_path / version_folder().name)
    for file in tmp_path.glob("*/*spectral_radius*.kernel"):
        file.write_bytes(file.read_bytes()[:-9])
    env = {"GEARLASH_CACHE_DIR": str(tmp_path)}
    ran = process(*RUN, env=env)
    assert ran.returncode == 0
    assert "compiling kernels" in ran.stderr
    again = process(*RUN, env=env)
    assert (again.stdout, again.stderr) == (ran.stdout, "")


@pytest.mark.slow
def test_a_home_that_cannot_be_written(tmp_path: Path):
    (tmp_path / "home").touch()
    env = {"HOME": str(tmp_path / "home"), "XDG_CACHE_HOME": "", "LOCALAPPDATA": "", "GEARLASH_CACHE_DIR": ""}
    ran = process(*RUN, env=env)
    assert ran.returncode == 0
    assert "cannot be written, so every run will" in " ".join(ran.stderr.split())
    assert ran.stdout == process(*RUN).stdout
