"""What the program reads, writes and says is on the pages that describe it."""

from __future__ import annotations

import re
from pathlib import Path
from typing import get_type_hints

import pytest

from gearlash.branches.continuation import SpecialKind
from gearlash.cli.answers import excitation, outcome
from gearlash.cli.answers.zones_parts import ZoneEnd
from gearlash.cli.exits import MEANINGS, ExitCode
from gearlash.cli.folder import MOTION_FILES
from gearlash.studies import zone_end
from gearlash.system import Status
from tools.reference_results import FOLDER, results_page

ROOT = Path(__file__).resolve().parents[2]
SOURCES = sorted((ROOT / "src" / "gearlash").rglob("*.py"))
READ = re.compile(r"""environ(?:\.get\(|\[)\s*["'](\w+)["']""")
WRITTEN = re.compile(r"""["']([\w-]+\.(?:json|nc|svg|pdf|html|md))["']""")


def test_every_environment_variable_that_is_read_is_described():
    read = {name for path in SOURCES for name in READ.findall(path.read_text(encoding="utf-8"))}
    assert "GEARLASH_CACHE_DIR" in read
    pages = [(ROOT / name).read_text(encoding="utf-8") for name in ("docs/cli.md", "CONTRIBUTING.md")]
    assert [name for name in sorted(read) if not any(name in page for page in pages)] == []


def test_every_file_that_a_command_writes_is_described():
    commands = [path for path in SOURCES if path.parent.name == "commands"]
    files = {name for path in commands for name in WRITTEN.findall(path.read_text(encoding="utf-8"))}
    files |= {
        *MOTION_FILES,
        *(f"sweep-{axis}{ending}" for axis in ("omega", "D") for ending in (".nc", ".json")),
    }
    assert len(files) > 15
    assert [name for name in sorted(files) if f"`{name}`" not in FOLDER] == []


def test_every_exit_code_has_its_meaning():
    assert set(MEANINGS) == set(ExitCode)


def test_every_status_is_described():
    page = results_page()
    ours = {
        outcome.INCOMPLETE,
        outcome.FAILED,
        outcome.PARTLY_FAILED,
        excitation.NOT_EXCITED,
    }
    assert [status for status in {*map(str, Status), *ours} if f"`{status}`" not in page] == []


@pytest.mark.parametrize(
    "kind",
    [*map(str, SpecialKind), zone_end.SEEN, zone_end.RANGE, zone_end.UNKNOWN],
)
def test_every_kind_of_end_is_described(kind: str):
    (text,) = get_type_hints(ZoneEnd, include_extras=True)["kind"].__metadata__
    assert kind in text.split(", ")
