"""Each command imports the rooms and the libraries that it uses, and no others."""

from __future__ import annotations

import subprocess
import sys

import pytest

ROOMS = ("flow", "orbits", "branches", "results", "jobs", "studies", "plots", "report", "article")
LIBRARIES = ("numba", "xarray", "h5py", "matplotlib", "pint", "jinja2")
SOLVING = {"flow", "orbits", "branches", "results", "jobs", "studies", "numba"}


def loaded(arguments: tuple[str, ...]) -> set[str]:
    """Rooms and libraries that a process has imported at the end of a command."""
    script = (
        "import sys\n"
        f"sys.argv = ['gearlash', *{list(arguments)!r}, '--json']\n"
        "from gearlash.cli import main\n"
        "try:\n    main()\n"
        f"finally:\n    found = [r for r in {ROOMS!r} if f'gearlash.{{r}}' in sys.modules]\n"
        f"    found += [m for m in {LIBRARIES!r} if m in sys.modules]\n"
        "    print('loaded', *found, file=sys.stderr)\n"
    )
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    return set(ran.stderr.splitlines()[-1].split()[1:])


@pytest.mark.parametrize(
    ("arguments", "wanted"),
    [
        (("check", "article"), set()),
        (("run", "article"), SOLVING),
        (("sweep", "article", "--over", "omega=1:1.01:2", "--workers", "0"), SOLVING),
    ],
    ids=["check", "run", "sweep"],
)
def test_a_command_loads_what_it_uses(arguments: tuple[str, ...], wanted: set[str]):
    assert loaded(arguments) == wanted
