"""--out never writes over what gearlash did not write."""

from __future__ import annotations

from pathlib import Path

import pytest

from cli.conftest import Gearlash
from gearlash.cli.folder import MARKER, claim
from gearlash.system import GearlashError


def test_own_files_may_be_written_again(tmp_path: Path):
    folder = claim(tmp_path / "deep" / "out", ["run.json"])
    folder.file("run.json").write_text("1", encoding="utf-8")
    assert claim(folder.path, ["run.json", "more.json"]).file("run.json").read_text(encoding="utf-8") == "1"
    folder.file("more.json").write_text("2", encoding="utf-8")
    claim(folder.path, ["more.json"])


@pytest.mark.parametrize("with_marker", [True, False])
def test_foreign_files_are_left_alone(with_marker: bool, tmp_path: Path):
    if with_marker:
        claim(tmp_path, ["other.json"])
    (tmp_path / "run.json").write_text("mine", encoding="utf-8")
    with pytest.raises(GearlashError, match=r"run\.json is there and was not written by gearlash"):
        claim(tmp_path, ["run.json"])
    assert (tmp_path / "run.json").read_text(encoding="utf-8") == "mine"


def test_foreign_files_of_other_names_do_not_matter(tmp_path: Path):
    (tmp_path / "notes.txt").write_text("mine", encoding="utf-8")
    claim(tmp_path, ["run.json"])
    assert (tmp_path / "notes.txt").read_text(encoding="utf-8") == "mine"


def test_a_marker_that_is_not_ours_is_respected(tmp_path: Path):
    (tmp_path / MARKER).write_text("[]", encoding="utf-8")
    with pytest.raises(GearlashError, match="not one of gearlash"):
        claim(tmp_path, ["run.json"])
    assert (tmp_path / MARKER).read_text(encoding="utf-8") == "[]"


def test_a_file_in_the_place_of_the_folder(tmp_path: Path):
    (tmp_path / "out").write_text("mine", encoding="utf-8")
    with pytest.raises(GearlashError, match="cannot be written"):
        claim(tmp_path / "out", ["run.json"])


def test_refused_before_anything_is_computed(
    gearlash: Gearlash, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    (tmp_path / "graze.json").write_text("mine", encoding="utf-8")
    monkeypatch.setattr("gearlash.studies.point", None)  # computing would fail
    ran = gearlash("graze", "article", "--out", str(tmp_path))
    assert ran.code == 2
    assert "graze.json is there" in ran.complaint


def test_halves_of_files_that_a_killed_command_left_go(tmp_path: Path):
    """Its own, of the names that are claimed; nothing else."""
    claim(tmp_path, ["run.json"])
    halves = [tmp_path / ".run.json.0123456789ab.part", tmp_path / ".sweep.nc.0123456789ab.part"]
    for path in (*halves, tmp_path / "run.json.part"):
        path.write_text("half", encoding="utf-8")
    claim(tmp_path, ["run.json"])
    left = sorted(path.name for path in tmp_path.iterdir())
    assert left == sorted([MARKER, halves[1].name, "run.json.part"])
