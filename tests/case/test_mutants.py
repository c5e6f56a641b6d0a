"""Thousands of damaged case files are taken or refused in a few words; what is taken can be checked and run.

`GEARLASH_MUTANTS=50000 pytest -n 0 tests/case/test_mutants.py` makes ten times as many, `python -m
case.mutants` those of another seed."""

from __future__ import annotations

import json
import os
import random
import time
from pathlib import Path

import pytest
from typer.testing import CliRunner

from case.mutants import SOON, files, sources, wrong
from gearlash.case import Case, load
from gearlash.cli.app import app
from gearlash.cli.exits import MEANINGS, ExitCode
from gearlash.flow.budget import VARIABLE
from gearlash.system import GearlashError

FILES = int(os.environ.get("GEARLASH_MUTANTS", "5000"))
PARTS = 4
RUNS = FILES // 80  # of those that are taken
BRIEF = ("--periods", "40", "--max-period", "4")


@pytest.mark.parametrize("part", range(PARTS))
def test_every_file_is_taken_or_refused_in_words(part: int, tmp_path: Path):
    taken, told = [], {}
    for number, data in enumerate(files(FILES // PARTS, part)):
        problem, case = wrong(tmp_path / "case.toml", data)
        if problem:
            told[number] = problem
        if case is not None:
            taken.append(data)
    assert told == {}
    assert FILES // PARTS // 10 < len(taken) < FILES // PARTS // 2
    chosen = random.Random(part).sample(sorted({*taken}), RUNS // PARTS)
    assert {i: why for i, data in enumerate(chosen) if (why := _ends(tmp_path / "case.toml", data))} == {}


def _ends(path: Path, data: bytes) -> str:
    """What is wrong with how commands end on a file, if anything is."""
    path.write_bytes(data)
    for command in (("check",), ("run", *BRIEF)):
        began = time.monotonic()
        with pytest.MonkeyPatch.context() as patch:
            patch.setenv(VARIABLE, "20MB")
            ran = CliRunner().invoke(app, [command[0], str(path), *command[1:]])
        crashed = ran.exception is not None and not isinstance(ran.exception, SystemExit)
        if crashed or ran.exit_code not in MEANINGS or ran.exit_code == ExitCode.BUG:
            return f"{command[0]} ends with {ran.exit_code}: {ran.exception!r} {ran.stderr[-500:]}"
        if time.monotonic() - began > 3 * SOON:
            return f"{command[0]} took {time.monotonic() - began:.0f} s"
    return ""


def test_files_are_made_the_same_each_time():
    assert list(files(50, 3)) == list(files(50, 3))
    assert len(set(files(200, 3))) > 150
    assert len(sources()) > 10


JSONS = [
    "",
    "[" * 100_000,
    '{"a":' * 100_000,
    "[]",
    "3",
    '{"format": 1}',
    '{"entries": 3}',
    '"' + "x" * 10**6,
]


@pytest.mark.parametrize("text", JSONS, ids=range(len(JSONS)))
def test_what_is_no_json_of_a_case(text: str):
    with pytest.raises(GearlashError) as refused:
        Case.from_json(text)
    assert len(str(refused.value)) < 500


def test_a_json_of_a_case_with_one_part_wrong():
    right = json.loads(load("kahraman-singh").to_json())
    for name in right:
        for value in (None, 3, [], {}, [[]], {"a": 1}, "x"):
            try:
                Case.from_json(json.dumps({**right, name: value}))
            except GearlashError as error:
                told = str(error)
            else:
                told = ""
            assert len(told) < 500
