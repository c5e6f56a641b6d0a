"""Pages that are written by hand say what exists."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest

import gearlash
from gearlash.case.kinds import helical, spur
from gearlash.orbits import Orbit

PAIRS = (helical.KIND, spur.KIND)
ROOT = Path(__file__).resolve().parents[2]
SYMBOLS = (ROOT / "docs" / "symbols.md").read_text(encoding="utf-8")
ARCHITECTURE = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")


def names(column: int) -> list[str]:
    """Names in backticks in a column of the table of parameters."""
    table = SYMBOLS.partition("## Parameters")[2].partition("## Scales")[0]
    rows = [line.split("|") for line in table.splitlines() if line.startswith("|")][2:]
    return [name for row in rows for name in re.findall(r"`([^`]+)`", row[column])]


def test_symbols_name_parameters_that_exist():
    known = {short for kind in PAIRS for short in kind.rules.places.two_way}
    assert len(names(3)) >= 18
    assert [name for name in names(3) if name not in known] == []


def test_symbols_name_paths_that_exist():
    known = {path for kind in PAIRS for path in kind.rules.places.quantities}
    assert len(names(4)) >= 12
    assert [name for name in names(4) if name not in known] == []


@pytest.mark.parametrize("name", ["Scales.length", "Clearance.gap_plus", "System.matrix", "Section.force"])
def test_symbols_name_attributes_that_exist(name: str):
    assert f"`{name}`" in SYMBOLS
    owner, attribute = name.split(".")
    classes: dict[str, Any] = {**vars(gearlash.orbits), **{n: getattr(gearlash, n) for n in gearlash.__all__}}
    assert attribute in classes[owner].__dataclass_fields__


def test_architecture_names_the_rooms_that_exist_and_says_of_the_others_that_they_do_not():
    table = ARCHITECTURE.partition("## Rooms")[2].partition("Two more have their place")[0]
    listed = set(re.findall(r"^\| `(\w+)/`", table, re.MULTILINE))
    package = ROOT / "src" / "gearlash"
    rooms = {path.parent.name for path in package.glob("*/__init__.py")}
    assert listed == rooms
    assert not rooms & {"multibody", "app"}


def test_the_way_of_one_question_can_be_gone():
    (script,) = re.findall(r"```python\n(.*?)```", ARCHITECTURE, re.DOTALL)
    found: dict[str, Any] = {}
    exec(compile(script, "ARCHITECTURE.md", "exec"), found)  # the point of this test
    assert isinstance(found["found"], Orbit)
    assert dict(found["dataset"].sizes)["omega"] == 5


def test_theory_names_options_that_exist():
    theory = (ROOT / "docs" / "theory.md").read_text(encoding="utf-8")
    table = theory.partition("### Named options")[2].partition("c_z = ")[0]
    named = set(re.findall(r"`model\.(\w+)`", table))
    assert named == {path.partition(".")[2] for path in helical.KIND.rules.places.choices}
    for path, choice in helical.KIND.rules.places.choices.items():
        for value in choice.choices:
            assert f"`{value}`" in table, (path, value)
