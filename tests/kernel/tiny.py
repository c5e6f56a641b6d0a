"""A package of a few kernels that stands for the whole one: `_kernel` is copied into it and looks at its
files."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import gearlash._kernel as kernels

CALLEE = """
from tiny._kernel.jit import inner

@inner
def factor(x):
    return 2.0 * x
"""
CALLER = """
from tiny._callee import factor
from tiny._kernel.jit import float64, kernel

@kernel(float64(float64))
def doubled(x):
    return factor(x) + 1.0
"""
PROGRAM = """
from tiny._caller import doubled
from tiny._kernel import load_all
missing = len(load_all())
print(doubled(10.0), missing == 0)
"""


def write(folder: Path, caller: str = CALLER) -> Path:
    """The folder with the package `tiny` in it."""
    package = folder / "tiny"
    package.mkdir()
    (package / "__init__.py").touch()
    shutil.copytree(Path(kernels.__file__).parent, package / "_kernel")
    (package / "_callee.py").write_text(CALLEE, encoding="utf-8")
    (package / "_caller.py").write_text(caller, encoding="utf-8")
    return folder


def process(
    folder: Path, cache: Path, program: str = PROGRAM, **env: str
) -> subprocess.CompletedProcess[str]:
    """A program in a process of its own, with that cache."""
    own = {
        "PYTHONPATH": str(folder),
        "GEARLASH_CACHE_DIR": str(cache),
        "NUMBA_DISABLE_JIT": "0",
        "GEARLASH_QUIET": "1",
        "PYTHONDONTWRITEBYTECODE": "1",  # two versions of a file may be as long, and made in one second
    }
    return subprocess.run(
        [sys.executable, "-c", program],
        capture_output=True,
        text=True,
        env={**os.environ, **own, **env},
        check=False,
    )


def run(folder: Path, cache: Path, before: str = "", **env: str) -> tuple[float, bool]:
    """What the kernel returns for 10 in a new process, and whether it came out of the cache."""
    ran = process(folder, cache, before + PROGRAM, **env)
    assert (ran.returncode, ran.stderr) == (0, "")
    value, found = ran.stdout.split()
    return float(value), found == "True"
