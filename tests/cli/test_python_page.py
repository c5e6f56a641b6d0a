"""docs/python.md: every script on it runs, and finds what the page says."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import gearlash as gl

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "python.md").read_text(encoding="utf-8")
SCRIPTS = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)


def test_functions_named_on_the_page_exist():
    named = set(re.findall(r"`gl\.(\w+)", PAGE))
    assert len(named) > 15
    assert named <= set(gl.__all__)


@pytest.fixture
def ran(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> dict[str, Any]:
    """The names of a script after it has run in an empty folder."""
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {"__name__": "script"}
    exec(compile(SCRIPTS[request.param], "python.md", "exec"), names)  # the point of this test
    return names


@pytest.mark.parametrize("ran", [0], indirect=True)
def test_one_motion(ran: dict[str, Any]):
    assert isinstance(ran["orbit"], gl.Orbit)
    assert ran["scales"].pinion_rpm(ran["family"].defaults["omega"]) == pytest.approx(3600.0)


@pytest.mark.parametrize("ran", [1], indirect=True)
def test_a_map(ran: dict[str, Any], tmp_path: Path):
    assert ran["plane"].complete
    assert sum(ran["plane"].shares.values()) == 20
    assert {path.name for path in tmp_path.iterdir()} == {"map.nc", "map.svg", "map.pdf"}


@pytest.mark.parametrize("ran", [2], indirect=True)
def test_tables_and_files(ran: dict[str, Any]):
    assert ran["table"]["label"].tolist() == [point.label for sweep in ran["found"] for point in sweep.points]
    assert ran["same"]["label"].tolist() == ran["table"]["label"].tolist()
    assert len(ran["forces"]) == sum(
        len(point.drive_force) for sweep in ran["found"] for point in sweep.points
    )


@pytest.mark.parametrize("ran", [3], indirect=True)
def test_many_motions(ran: dict[str, Any], capsys: pytest.CaptureFixture[str]):
    labels = sorted(gl.attractor(ran["props"], end).label for end in ran["reached"])
    assert labels == ["1-0-0", "1-1-0"]
    assert min(np.bincount(ran["which"])) > 100


@pytest.mark.parametrize("ran", [4], indirect=True)
def test_a_zone_in_a_plane(ran: dict[str, Any], tmp_path: Path):
    assert ran["zone"].complete
    assert [margin.bounded for margin in ran["zone"].margins] == [False, True, False, False]
    assert {path.name for path in tmp_path.iterdir()} == {"zone.svg", "zone.pdf"}


def test_every_command_has_its_functions_on_the_page():
    table = PAGE.partition("## The commands as functions")[2].partition("\n## ")[0]
    rows = dict(re.findall(r"^\| `(\w+)` \| (.*) \|$", table, re.MULTILINE))
    commands = {path.stem for path in (Path(gl.__file__).parent / "cli" / "commands").glob("[a-z]*.py")}
    assert set(rows) == commands
    assert all(re.search(r"`gl\.\w+", functions) for functions in rows.values())
