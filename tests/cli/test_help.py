"""What can be asked without computing: help, version, unknown names; and what that loads."""

from __future__ import annotations

import re
import subprocess
import sys
from importlib.metadata import version

import pytest

from cli.conftest import Gearlash
from gearlash.case import bundled
from gearlash.cli.app import app

COMMANDS = (
    "new",
    "report",
    "run",
    "check",
    "sweep",
    "map",
    "branch",
    "curve",
    "atlas",
    "graze",
    "zones",
    "tolerance",
    "compare",
    "verify",
    "reproduce",
    "schema",
)
HEAVY = ("numpy", "numba", "pint", "matplotlib", "xarray", "rich")


def test_commands_are_these(gearlash: Gearlash):
    text = gearlash("--help").out
    listed = re.findall(r"^  (\w+)  ", text.partition("Commands:")[2], re.MULTILINE)
    assert tuple(listed) == COMMANDS
    assert len(app.registered_commands) == len(COMMANDS)


@pytest.mark.parametrize("arguments", [("--help",), ("run", "--help"), ("--version",), ("swep",)])
def test_help_loads_nothing_heavy(arguments: tuple[str, ...]):
    script = (
        "import sys\n"
        f"sys.argv = ['gearlash', *{list(arguments)!r}]\n"
        "from gearlash.cli import main\n"
        "try:\n    main()\n"
        f"finally:\n    print('loaded', [m for m in {HEAVY!r} if m in sys.modules])\n"
    )
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False)
    assert "loaded []" in ran.stdout


@pytest.mark.parametrize("command", COMMANDS)
def test_help_begins_with_the_question_that_the_command_answers(command: str, gearlash: Gearlash):
    ran = gearlash(command, "--help")
    assert ran.code == 0
    assert re.search(r"^  [A-Z][^.]*\?", ran.out, re.MULTILINE)


def test_help_names_the_bundled_cases(gearlash: Gearlash):
    text = re.sub(r"-\s+", "-", gearlash("run", "--help").out)
    assert ", ".join(bundled()) in " ".join(text.split())


def test_version(gearlash: Gearlash):
    assert gearlash("--version").out == f"gearlash {version('gearlash')}\n"


def test_unknown_command_and_option_name_the_nearest(gearlash: Gearlash):
    ran = gearlash("swep", "article")
    assert ran.code == 2
    assert "'sweep'" in ran.err
    ran = gearlash("run", "article", "--inital", "X=1")
    assert ran.code == 2
    assert "--initial" in ran.err
