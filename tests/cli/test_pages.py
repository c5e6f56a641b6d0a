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
PACKAGE = ROOT / "src" / "gearlash"
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


def test_architecture_names_the_rooms_that_exist():
    table = ARCHITECTURE.partition("## Rooms")[2].partition("\n## ")[0]
    listed = set(re.findall(r"^\| `(\w+)/`", table, re.MULTILINE))
    assert listed == {path.parent.name for path in PACKAGE.glob("*/__init__.py")}


def test_architecture_names_files_that_exist():
    """By their path in the package or in the project; the name of a file alone stands for any with it."""
    named = set(re.findall(r"`([\w./-]+\.(?:py|toml|md)|[\w./-]+/)`", ARCHITECTURE))
    assert len(named) > 30
    alone = {path.name for path in PACKAGE.rglob("*.py")} | {"pyproject.toml"}
    missing = [n for n in named if not ((PACKAGE / n).exists() or (ROOT / n).exists() or n in alone)]
    assert missing == []


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
    choices = [each for each in helical.KIND.rules.places.choices.values() if each.path.startswith("model.")]
    assert named == {each.path.partition(".")[2] for each in choices}
    for choice in choices:
        for value in choice.choices:
            assert f"`{value}`" in table, (choice.path, value)
