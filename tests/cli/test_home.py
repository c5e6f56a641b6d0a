"""`~` at the beginning of a path is home, also where no shell has made it so."""

from __future__ import annotations

from pathlib import Path

import pytest

import gearlash as gl
from cli.conftest import Gearlash


@pytest.fixture
def home(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """Another home, and another current folder."""
    place = tmp_path / "home"
    (tmp_path / "here").mkdir()
    place.mkdir()
    monkeypatch.setenv("HOME", str(place))
    monkeypatch.setenv("USERPROFILE", str(place))
    monkeypatch.chdir(tmp_path / "here")
    return place


@pytest.mark.slow
def test_every_path_of_a_command_may_begin_at_home(gearlash: Gearlash, home: Path):
    case = (Path(gl.__file__).parent / "case" / "data" / "kahraman-singh.toml").read_text("utf-8")
    (home / "mine.toml").write_text(case, "utf-8")
    assert gearlash("run", "~/mine.toml", "--out", "~/out").code == 0
    assert (home / "out" / "run.json").is_file()
    again = gearlash("run", "~/mine.toml", "--initial", "~/out/run.json", "--out=~/again")
    assert again.code == 0
    assert (home / "again" / "portrait.svg").is_file()
    assert not any(Path.cwd().iterdir())


def test_every_path_from_python_may_begin_at_home(home: Path):
    case = gl.load_case("kahraman-singh")
    dataset = gl.sweep_dataset(case, [gl.sweep(case, gl.Axis.even("omega", 1.2, 1.3, 2))])
    assert gl.save_dataset(dataset, "~/s.nc") == home / "s.nc"
    assert gl.load_dataset("~/s.nc").identical(dataset)


def test_a_home_that_is_not_there_is_refused(gearlash: Gearlash, home: Path):
    for arguments in (("run", "~no_body/case.toml"), ("run", "kahraman-singh", "--out", "~no_body/out")):
        ran = gearlash(*arguments)
        assert ran.code == 2
        assert "~no_body/" in ran.complaint
    assert not any(Path.cwd().iterdir())


def test_a_unit_finds_its_quantity_in_every_option(gearlash: Gearlash):
    swept = gearlash("sweep", "article", "--over", "error=0um:10um:3", "--json").answer
    by_name = gearlash("sweep", "article", "--over", "mesh.error=0um:10um:3", "--json").answer
    assert swept["axis"]["named"] == "mesh.error"
    assert swept["axis"] == by_name["axis"]
    assert swept["sweeps"] == by_name["sweeps"]
    near = gearlash("graze", "article", "--over", "omega", "--near", "4200 1/min")
    assert near.code == 2
    assert "pinion_speed or operation.mesh_frequency" in near.complaint
    assert (
        gearlash("run", "article", "--set", "omega=3600rpm", "--json").answer["parameters"]
        == (gearlash("run", "article", "--set", "pinion_speed=3600rpm", "--json").answer["parameters"])
    )
    powers = gearlash("check", "article", "--set", "mean_stiffness=3.4·10⁸N/m")
    assert powers.code == 0
    assert "3.4e8 N/m" in powers.out


@pytest.mark.parametrize("command", ["run", "reproduce"])
@pytest.mark.parametrize("empty", ["", " "])
def test_a_folder_without_a_name_is_not_the_current_one(
    command: str, empty: str, gearlash: Gearlash, home: Path
):
    found = gearlash(command, *(["kahraman-singh"] if command == "run" else []), "--out", empty)
    assert found.code == 2
    assert "no folder is named" in found.err
    assert not any(Path.cwd().iterdir())
