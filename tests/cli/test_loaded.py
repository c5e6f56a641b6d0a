"""A command loads what it uses: rooms of the package, and libraries that take their time."""

from __future__ import annotations

import subprocess
import sys

import pytest

CODE = """
import sys
sys.argv = ["gearlash", *sys.argv[1:]]
from gearlash.cli import main
try:
    main()
except SystemExit as ended:
    assert not ended.code, ended.code
rooms = {name.split(".")[1] for name in sys.modules if name.startswith("gearlash.")}
print(*sorted(rooms), file=sys.stderr)
print(*sorted({name.partition(".")[0] for name in sys.modules}), file=sys.stderr)
"""
DRAWING = {"matplotlib", "xarray", "pandas", "h5netcdf"}


def loaded(*arguments: str) -> tuple[set[str], set[str]]:
    """Rooms and libraries that are there when a command has ended."""
    command = [sys.executable, "-c", CODE, *arguments]
    ended = subprocess.run(command, capture_output=True, text=True, check=True, encoding="utf-8")
    rooms, libraries = ended.stderr.splitlines()[-2:]
    return set(rooms.split()), set(libraries.split())


def test_help_loads_no_room_but_its_own():
    rooms, libraries = loaded("--help")
    assert rooms == {"cli", "current_folder"}
    assert not libraries & {"numpy", "rich"}


@pytest.mark.parametrize("arguments", [("check", "article"), ("schema",)])
def test_what_solves_nothing_loads_nothing_that_solves(arguments: tuple[str, ...]):
    rooms, libraries = loaded(*arguments)
    assert rooms == {"cli", "current_folder", "system", "case", "gears"}
    assert not libraries & {"numba", "scipy", *DRAWING}


def test_a_run_without_a_folder_draws_and_writes_nothing():
    rooms, libraries = loaded("run", "article")
    assert not rooms & {"plots", "report", "article"}
    assert {"flow", "orbits"} <= rooms
    assert not libraries & DRAWING


def test_a_run_loads_no_library_for_curves_or_matrices_and_numba_still_has_them_afterwards():
    code = (
        CODE
        + """
print(*sorted(sys.modules), file=sys.stderr)
import numba, numpy
matrix = numpy.array([[0.0, 1.0], [2.0, 3.0]])
assert numba.njit(lambda a: a @ a)(matrix).tolist() == [[2.0, 3.0], [6.0, 11.0]]
assert "scipy.linalg" in sys.modules
"""
    )
    command = [sys.executable, "-c", code, "run", "article"]
    ended = subprocess.run(command, capture_output=True, text=True, check=True, encoding="utf-8")
    names = set(ended.stderr.splitlines()[-1].split())
    assert "gearlash.studies.impact_free" in names
    assert not names & {"scipy.linalg", "scipy.optimize", "scipy.integrate", "gearlash.branches.curves"}
