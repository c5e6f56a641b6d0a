"""Commands in a folder full of files that are named like every module there is: none of them may run."""

from __future__ import annotations

import os
import pkgutil
import shutil
import subprocess
import sys
import sysconfig
from collections.abc import Iterable
from pathlib import Path

import pytest

from gearlash import flow  # noqa: F401 - declares the kernels
from gearlash._kernel import compile_all, load_all
from gearlash._kernel.cache import version_folder

SCRIPT = Path(sysconfig.get_path("scripts")) / "gearlash"
pytestmark = pytest.mark.skipif(not SCRIPT.exists(), reason="gearlash is not installed as a command here")

RUNS = """
with open({marker!r}, "a") as file:
    print(__name__, file=file)
raise ImportError("a module of the current folder was run")
"""
START = {"sitecustomize", "usercustomize", "re", "enum", "functools", "types", "typing", "collections"}
"""What Python and its script import before a line of this package runs."""
SWEEP = ("sweep", "kahraman-singh", "--over", "omega=0.9:0.95:6", "--cold", "--workers", "2")
COMMANDS = [
    ("run", "kahraman-singh", "--out", "out"),
    ("check", "article"),
    (*SWEEP, "--out", "out"),
    ("map", *SWEEP[1:4], "--over", "D=0.9:1:3", "--workers", "2", "--out", "out"),
    ("branch", "kahraman-singh", "--over", "omega=0.45:0.55", "--out", "out"),
    ("graze", "kahraman-singh", "--json"),
    ("schema",),
    ("--version",),
]  # fmt: skip


def every_module() -> set[str]:
    top = {found.name for found in pkgutil.iter_modules()}
    return {*sys.stdlib_module_names, *top, "sitecustomize", "usercustomize", "gearlash", "evil"}


def hostile(folder: Path, names: Iterable[str]) -> Path:
    """The file that tells which module was run; the folder has one of each name, as file and as package."""
    folder.mkdir()
    marker = folder.parent / "marker"
    for name in names:
        (folder / f"{name}.py").write_text(RUNS.format(marker=str(marker)), encoding="utf-8")
    (folder / "matplotlibrc").write_text("backend: module://evil\n", encoding="utf-8")
    (folder / ".numba_config.yaml").write_text("debug: 1\nopt: 0\n", encoding="utf-8")
    info = folder / "evil-1.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: evil\nVersion: 1\n", encoding="utf-8")
    groups = ("xarray.backends", "numba_extensions", "pydantic", "matplotlib.backend")
    entries = "".join(f"[{group}]\ninit = evil:init\n" for group in groups)
    (info / "entry_points.txt").write_text(entries, encoding="utf-8")
    return marker


def in_folder(folder: Path, *arguments: str, **env: str) -> subprocess.CompletedProcess[str]:
    every = {
        name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYTHONSAFEPATH")
    }
    return subprocess.run(
        [SCRIPT, *arguments], cwd=folder, env={**every, **env}, capture_output=True, text=True, check=False
    )


def ran(marker: Path) -> list[str]:
    return marker.read_text(encoding="utf-8").split() if marker.exists() else []


@pytest.mark.slow
@pytest.mark.parametrize("arguments", COMMANDS, ids=lambda arguments: arguments[0])
def test_no_module_of_the_current_folder_is_run(arguments: tuple[str, ...], tmp_path: Path):
    marker = hostile(tmp_path / "here", every_module())
    found = in_folder(tmp_path / "here", *arguments)
    assert (ran(marker), found.returncode) == ([], 0), found.stderr
    assert "Traceback" not in found.stderr


@pytest.mark.slow
def test_nor_while_kernels_are_compiled(tmp_path: Path):
    """Two that are missing: the processes that compile them are those that would compile all."""
    compile_all(load_all())
    cache = tmp_path / "cache"
    shutil.copytree(version_folder(), cache / version_folder().name)
    missing = [file for name in ("extrema", "spectral_radius") for file in cache.glob(f"*/*.{name}-*.kernel")]
    for file in missing:
        file.unlink()
    marker = hostile(tmp_path / "here", every_module())
    found = in_folder(tmp_path / "here", *SWEEP, GEARLASH_CACHE_DIR=str(cache))
    assert (ran(marker), found.returncode) == ([], 0), found.stderr
    assert found.stderr.count("compiling kernels") == 1
    assert len([file for file in missing if file.exists()]) == 2


@pytest.mark.slow
@pytest.mark.parametrize("named", ["", ".", "/nowhere:", ":/nowhere"])
def test_nor_where_a_part_of_pythonpath_is_empty(named: str, tmp_path: Path):
    started = START | {name for name in sys.modules if "." not in name and name in sys.stdlib_module_names}
    later = {"json", "multiprocessing", "numpy", "xarray", "h5netcdf", "scipy", "typer", "rich", "llvmlite"}
    marker = hostile(tmp_path / "here", later)
    assert later - started - {"json"}
    found = in_folder(tmp_path / "here", *SWEEP, "--out", "out", PYTHONPATH=named or os.pathsep)
    assert (ran(marker), found.returncode) == ([], 0), found.stderr


@pytest.mark.slow
def test_a_family_in_a_script_still_finds_the_modules_beside_it(tmp_path: Path):
    """The folder of a script is the user's choice: its modules are there for workers too."""
    (tmp_path / "own_system.py").write_text(OWN, encoding="utf-8")
    script = tmp_path / "study.py"
    script.write_text(STUDY, encoding="utf-8")
    found = subprocess.run(
        [sys.executable, script], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert (found.returncode, found.stdout.strip()) == (0, "3 True"), found.stderr


OWN = """
import numpy as np
import gearlash as gl

def build(p):
    matrix = np.array([[0.0, 1.0], [-1.0, -0.1]])
    forcing = np.array([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    stop = gl.Clearance(np.array([1.0, 0.0]), np.array([0.0, -1.0]), p["gap"], 100.0, np.array([8.0]),
                        np.array([0.0]), contact=gl.ContactRule.ALWAYS, name="stop")
    return gl.System(p["omega"], matrix, forcing, (stop,))

def cold_start(p):
    return np.zeros(2)

parameters = gl.Parameter("omega", 0.8), gl.Parameter("gap", 5.0)
family = gl.Family(parameters, ("x", "v"), build, cold_start=cold_start)
"""
STUDY = """
import os
import gearlash as gl
from own_system import family

if __name__ == "__main__":
    before = dict(os.environ)
    with gl.open_workers(family, 2) as executor:
        found = gl.sweep(family, gl.Axis.even("gap", 4.0, 5.0, 3), execution=gl.Execution(executor))
    assert dict(os.environ) == before
    print(len([p for p in found.points if p.label]), found.complete)
"""
