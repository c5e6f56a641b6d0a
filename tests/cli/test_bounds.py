"""Whatever a command is given, it ends soon and says in a few words what is wrong."""

from __future__ import annotations

import json
import os
import socket
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from case.corpus import SPUR
from cli.conftest import Gearlash, Ran

LONGEST = 4096  # characters of a refusal
SOON = 10.0  # s, generous: what has no bound takes minutes or for ever
DIGITS = "9" * 5000
RUN = ("run", "kahraman-singh")
SWEEP = ("sweep", "kahraman-singh")
posix = pytest.mark.skipif(sys.platform == "win32", reason="devices and pipes as POSIX has them")


def refused(gearlash: Gearlash, *arguments: str) -> Ran:
    began = time.monotonic()
    ran = gearlash(*arguments)
    assert ran.code == 2, ran
    assert 0 < len(ran.err) < LONGEST
    assert len(ran.out) < 3 * LONGEST  # with --json each problem stands there twice
    assert "Traceback" not in ran.err
    assert time.monotonic() - began < SOON
    return ran


ARGUMENTS = [
    (*SWEEP, "--over", f"omega=1:2:{DIGITS}"),
    (*SWEEP, "--over", f"omega=1:{DIGITS}:9"),
    (*SWEEP, "--over", f"omega={DIGITS}:2:9"),
    (*SWEEP, "--over", f"{DIGITS}=1:2:9"),
    (*SWEEP, "--over", f"omega=1:2:9{'0' * 300}"),
    (*SWEEP, "--over", "omega=1:2:9:" * 9000),
    (*SWEEP, "--over", "omega=1:2:3", "--workers", DIGITS),
    (*SWEEP, "--over", "omega=1:2:3", "--workers", "100000"),
    (*SWEEP, "--over", "omega=1:2:3", "--workers", "1e9"),
    (*SWEEP, "--over", "omega=1:2:3", "--periods", DIGITS),
    (*RUN, "--periods", DIGITS),
    (*RUN, "--periods", "9" * 400),
    (*RUN, "--periods", "9" * 40),
    (*RUN, "--max-period", DIGITS),
    (*RUN, "--set", f"omega={DIGITS}"),
    (*RUN, "--set", f"omega={'9' * 400}"),
    (*RUN, "--set", f"omega=0.{'(' * 9000}"),
    (*RUN, "--set", f"{'x' * 100_000}=1"),
    (*RUN, "--set", f"{'a.' * 50_000}x=1"),
    (*RUN, "--set", f"pinion_speed=1 {'m*' * 50_000}m"),
    (*RUN, "--set", f"omega={'1' * 100_000}"),
    (*RUN, *[f"--set=q{i}=1" for i in range(3000)]),
    (*RUN, *["--set=omega=1"] * 3000),
    (*RUN, *[f"--initial=q{i}=1" for i in range(3000)]),
    (*RUN, "--initial", f"X={DIGITS}"),
    (*RUN, "--initial", f"X=1e{DIGITS}"),
    (*RUN, "--initial", DIGITS),
    (*RUN, "--initial", "x" * 100_000),
    ("map", "kahraman-singh", *[f"--over=omega=1:2:{n}" for n in range(2, 900)]),
    ("map", "kahraman-singh", "--over", f"omega=1:2:{DIGITS}", "--over", f"D=1:2:{DIGITS}"),
    ("graze", "kahraman-singh", "--near", DIGITS),
    ("graze", "kahraman-singh", "--over", "x" * 100_000),
    ("zones", "kahraman-singh", "--over", f"omega=1:2:{DIGITS}"),
    ("reproduce", "--points", DIGITS),
    ("reproduce", "--points", "9" * 12),
    ("check", "x" * 100_000),
    ("check", DIGITS),
    ("check", "\0"),
    ("schema", "--result", DIGITS),
    ("x" * 100_000,),
    (*RUN, "--out", "x" * 100_000),
    (*RUN, "--out", "x" * 300),
    (*RUN, f"--{'x' * 100_000}"),
]


@pytest.mark.parametrize("arguments", ARGUMENTS, ids=lambda arguments: " ".join(arguments)[:50])
def test_arguments_without_end_are_refused(
    arguments: tuple[str, ...], gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    refused(gearlash, *arguments)
    assert list(tmp_path.iterdir()) == []


def pipe(path: Path) -> None:
    os.mkfifo(path)


def a_socket(path: Path) -> None:
    with socket.socket(socket.AF_UNIX) as made:
        made.bind(str(path))


def large(path: Path) -> None:
    with path.open("wb") as file:
        file.truncate(1 << 40)  # takes no room


NAMED = ["/dev/zero", "/dev/urandom", "/dev/null", "/dev/stdin", "/proc/self/mem", "/dev/tty", "/"]
MADE: list[Callable[[Path], object]] = [
    pipe,
    a_socket,
    large,
    Path.mkdir,
    lambda path: path.symlink_to("/dev/zero"),
]
READERS = [("check",), ("run",), (*RUN, "--initial"), (*SWEEP, "--over", "omega=1:2:3", "--initial")]


@posix
@pytest.mark.parametrize("command", READERS, ids=" ".join)
@pytest.mark.parametrize("name", NAMED)
def test_devices_are_not_read(name: str, command: tuple[str, ...], gearlash: Gearlash):
    refused(gearlash, *command, name)


@posix
@pytest.mark.parametrize("command", READERS, ids=" ".join)
@pytest.mark.parametrize("make", MADE)
def test_nor_is_anything_else_that_is_no_file_of_moderate_size(
    make: Callable[[Path], object],
    command: tuple[str, ...],
    gearlash: Gearlash,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
):
    monkeypatch.chdir(tmp_path)  # names of sockets must be short
    make(Path("thing"))
    refused(gearlash, *command, "thing")


STATES = [
    "[" * 100_000,
    '{"state": ' + '{"X": ' * 50_000,
    '{"state": {"X": ' + DIGITS + "}}",
    '{"state": {"X": ' + "9" * 400 + ', "X\'": 0}}',
    '{"state": {"X": 1e999, "X\'": 0}}',
    '{"state": {"' + "k" * 1_000_000 + '": 1}}',
    json.dumps({"state": {f"k{i}": 1 for i in range(100_000)}}),
    '{"state": [1, 2]}',
    '{"state": {"X": "1", "X\'": [0]}}',
    '{"state": {"X": true, "X\'": null}}',
    "\ud800".encode("utf-8", "surrogatepass").decode("latin-1"),
]


@pytest.mark.parametrize("content", STATES, ids=lambda text: text[:30])
def test_the_file_of_initial(content: str, gearlash: Gearlash, tmp_path: Path):
    (tmp_path / "run.json").write_text(content, encoding="utf-8")
    refused(gearlash, *RUN, "--initial", str(tmp_path / "run.json"))
    refused(gearlash, *RUN, "--json", "--initial", str(tmp_path / "run.json"))


GAP = """
[[clearance]]
name = "c%d"
h = [1, 0]
g = [0, -1]
gap_plus = 1
gap_minus = 1
stiffness_plus = 1
stiffness_minus = 1
"""
OWN = """
kind = "piecewise-linear"
states = ["x", "v"]
matrix = [[0, 1], [-1, -0.1]]
forcing = [0, {cos = [1]}]
[parameters]
omega = 0.8
"""
KEY = ".".join("a" for _ in range(100_000))
FILES = {
    "arrays in arrays": f"x = {'[' * 10_000}{']' * 10_000}",
    "arrays in arrays that Python still reads": f"{SPUR}x = {'[' * 300}{']' * 300}",
    "tables in tables": "x = " + "{a=" * 10_000 + "1" + "}" * 10_000,
    "tables in tables that Python still reads": f"{SPUR}x = " + "{a=" * 200 + "1" + "}" * 200,
    "a key of 100,000 parts": f"{SPUR}{KEY} = 1",
    "a key of 100,000 quoted parts": f"{SPUR}{KEY.replace('a', chr(34) + 'a' + chr(34))} = 1",
    "a table of 100,000 parts": f"[{KEY}]",
    "a key of 100,000 parts in a table": f"{SPUR}x = {{ {KEY} = 1 }}",
    "many keys of many parts": SPUR + "".join(f"k{i}.{KEY[:5000]} = 1\n" for i in range(80)),
    "a key of 5 MB": SPUR + "k" * 5_000_000 + " = 1",
    "a key of 400 kB": SPUR + "k" * 400_000 + " = 1",
    "a text of 400 kB": SPUR.replace('"50 mm"', '"' + "5" * 400_000 + ' mm"'),
    "a unit of 400 kB": SPUR.replace('"50 mm"', '"5 ' + "m" * 400_000 + '"'),
    "a unit of 100,000 factors": SPUR.replace('"50 mm"', '"5 ' + "mm*" * 100_000 + 'mm"'),
    "units to high powers": SPUR.replace('"50 mm"', '"5 ' + "Gm^9*" * 20 + 'm"'),
    "400 digits": SPUR.replace("omega = 0.5", "omega = " + "9" * 400),
    "5000 digits": SPUR.replace("omega = 0.5", "omega = " + DIGITS),
    "100,000 digits of base 16": SPUR.replace("omega = 0.5", "omega = 0x" + "f" * 100_000),
    "an exponent of 5000 digits": SPUR.replace('"50 mm"', '"5e' + DIGITS + ' mm"'),
    "50,000 tables": SPUR + "".join(f"[q{i}]\n" for i in range(50_000)),
    "50,000 names": SPUR + "".join(f"q{i} = 1\n" for i in range(50_000)),
    "4,000 names": SPUR + "".join(f"q{i} = 1\n" for i in range(4_000)),
    "4,000 tables of an own system": OWN + GAP % 1 + "".join(f"[q{i}]\n" for i in range(4_000)),
    "100,000 authors": SPUR + "[source]\nauthors = [" + "1," * 100_000 + "]",
    "40,000 authors": SPUR + "[source]\nauthors = [" + "1," * 40_000 + "]",
    "1,000 clearances": OWN + "".join(GAP % i for i in range(1000)),
    "300 clearances": OWN + "".join(GAP % i for i in range(300)),
    "9 clearances": OWN + "".join(GAP % i for i in range(9)),
    "3,000 wrong numbers": OWN.replace("cos = [1]", "cos = [" + "'nn'," * 3000 + "]") + GAP % 1,
    "40,000 rows": OWN.replace("[[0, 1],", "[[0, 1]," + "[]," * 40_000) + GAP % 1,
    "a name of a state without end": OWN.replace('"x"', '"' + "x" * 400_000 + '"') + GAP % 1,
    "parentheses": OWN.replace("-0.1", f"'{'(' * 100_000}1{')' * 100_000}'") + GAP % 1,
    "deep parentheses": OWN.replace("-0.1", f"'{'sqrt(' * 66}1{')' * 66}'") + GAP % 1 + "h = 1",
    "a tower of powers": OWN.replace("-0.1", "'9**9**9**9'") + GAP % 1,
    "division by zero": OWN.replace("-0.1", "'1/(omega-omega)'") + GAP % 1,
    "cycles of 4000 digits": "cycles = " + "9" * 4000 + OWN + GAP % 1,
    "an order of 4000 digits": OWN.replace("cos = [1]", "cos = [1], orders = [" + "9" * 4000 + "]") + GAP % 1,
    "a bound of 4000 digits": OWN + "q = {value = 1, lower = " + "9" * 4000 + "}" + GAP % 1,
    "ω below all bounds": OWN.replace("omega = 0.8", "omega = 5e-324") + GAP % 1,
    "a null character": SPUR + "\0",
    "names that turn round": SPUR + '"\u202e\u2066" = 1',
    "digits of other scripts": OWN.replace("-0.1", "'١'") + GAP % 1,
}


@pytest.mark.parametrize("content", FILES.values(), ids=FILES)
def test_files_without_measure_are_refused(content: str, gearlash: Gearlash, tmp_path: Path):
    (tmp_path / "case.toml").write_text(content, encoding="utf-8")
    refused(gearlash, "check", str(tmp_path / "case.toml"))
    refused(gearlash, "run", "--json", str(tmp_path / "case.toml"))


def test_of_many_problems_the_first_are_told_and_the_rest_counted(gearlash: Gearlash, tmp_path: Path):
    (tmp_path / "case.toml").write_text(FILES["4,000 names"], encoding="utf-8")
    ran = refused(gearlash, "check", str(tmp_path / "case.toml"), "--json")
    assert "4,000 problems" in ran.complaint
    assert "and 3,980 more" in ran.complaint
    assert len(ran.answer["problems"]) == 20


@pytest.mark.parametrize("direction", ["h = { x = 5e-324", "h = { x = 1e-120", "g = { v = -1e-310"])
@pytest.mark.parametrize(
    "command",
    [("check",), ("run",), ("graze",), *((name, "--over", "a=0.5:0.9:3") for name in ("sweep", "zones"))],
    ids=lambda command: command[0],
)
def test_a_direction_whose_square_is_no_number(
    direction: str, command: tuple[str, ...], gearlash: Gearlash, tmp_path: Path
):
    text = (Path(__file__).parents[1] / "cases" / "soft-stop.toml").read_text(encoding="utf-8")
    name = direction[0]
    right = {"h": "h = { x = 1", "g": "g = { v = -1"}[name]
    assert right in text
    path = tmp_path / "case.toml"
    path.write_text(text.replace(right, direction), encoding="utf-8")
    ran = refused(gearlash, command[0], str(path), *command[1:])
    assert f"clearance.stop.{name}: expected a direction of a usual size" in ran.complaint
