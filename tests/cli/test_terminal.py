"""Terminals without Greek, pipes that close, notices about compiling."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import cast

import pytest

from gearlash._kernel import Kernel, compile_all, load_all
from gearlash.cli.notice import load_engine
from gearlash.cli.spelling import spelled
from gearlash.cli.terminal import prepare_streams
from gearlash.flow._cells import spectral_radius

COMMAND = [sys.executable, "-c", "from gearlash.cli import main; main()"]


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "cp437"])
def test_letters_that_the_encoding_lacks_are_spelled(encoding: str):
    env = {**os.environ, "PYTHONIOENCODING": encoding, "PYTHONUTF8": "0"}
    ran = subprocess.run([*COMMAND, "check", "article"], capture_output=True, env=env, check=True)
    text = ran.stdout.decode(encoding)
    assert ran.stderr == b""
    assert "?" not in text
    assert "kg" in text
    if encoding == "ascii":
        assert "damping ratio xi_m" in text
        assert "16000 N *" in text


def test_json_is_plain_ascii_where_the_terminal_is_not_utf8():
    env = {**os.environ, "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0"}
    ran = subprocess.run([*COMMAND, "check", "article", "--json"], capture_output=True, env=env, check=True)
    assert ran.stdout.isascii()
    assert b"\\u03be_m" in ran.stdout


@pytest.mark.parametrize(
    ("letter", "text"), [("ξ", "xi"), ("Σ", "Sigma"), ("†", "*"), ("é", "e"), ("₂", "2"), ("漢", "?")]
)
def test_spellings(letter: str, text: str):
    assert spelled(letter) == text


@pytest.mark.parametrize("options", [[], ["--json"]])
def test_a_reader_that_leaves_early_is_no_error(options: list[str]):
    started = subprocess.Popen(
        [*COMMAND, "check", "article", *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    assert started.stdout is not None
    assert started.stderr is not None
    started.stdout.close()
    assert started.stderr.read() == b""
    started.stderr.close()
    assert started.wait() == 0


def test_standard_output_closed_from_the_start():
    script = f"exec {COMMAND[0]} -c '{COMMAND[2]}' check article >&-"
    ran = subprocess.run(["sh", "-c", script], capture_output=True, check=False)
    assert (ran.returncode, ran.stderr) == (0, b"")


def test_compiling_is_told_once_and_only_if_it_happens(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
):
    prepare_streams()
    kernel = cast(Kernel, spectral_radius)
    compile_all(load_all())
    capfd.readouterr()
    load_engine()
    assert capfd.readouterr().err == ""
    missing = [[kernel], []]
    monkeypatch.setenv("GEARLASH_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr("gearlash._kernel.prepare._READY", set())
    monkeypatch.setattr("gearlash._kernel.load_all", lambda: missing.pop(0))
    load_engine()
    told = capfd.readouterr()
    assert told.out == ""
    assert told.err.count("compiling kernels, about 30 s on two free cores, once") == 1
    assert "compiled in" in told.err
    load_engine()
    assert capfd.readouterr().err == ""


def test_compiling_without_a_folder_to_keep_it_says_so(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setenv("GEARLASH_CACHE_DIR", "/dev/null/nowhere")
    monkeypatch.setattr("gearlash._kernel.load_all", lambda: [spectral_radius])
    load_engine()
    text = " ".join(capfd.readouterr().err.split())
    assert "cannot be written, so every run will" in text
    assert "GEARLASH_CACHE_DIR" in text
