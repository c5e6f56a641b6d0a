"""What is kept of finite elements: read only where it is what would be made now."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gearlash.gears import CylindricalGear
from gearlash.gears.materials import named
from gearlash.multibody import compliance, kept
from gearlash.multibody.compliance import SectorSettings, flank_compliance
from gearlash.multibody.tooth_section import Fineness

GEAR = CylindricalGear(30, 4e-3)
COARSE = SectorSettings(Fineness(flank=1, fillet=1, core=1, rim=1, axial=1), teeth=3)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    own = tmp_path / "cache"
    monkeypatch.setenv("GEARLASH_CACHE_DIR", str(own))
    return own


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """A word for each time that finite elements were solved."""
    words: list[str] = []
    solve = compliance._influence

    def solved(*arguments):
        words.append("made")
        return solve(*arguments)

    monkeypatch.setattr(compliance, "_influence", solved)
    return words


def of(gear: CylindricalGear = GEAR, width: float = 0.02, **others):
    options: dict[str, Any] = {"settings": COARSE} | others
    return flank_compliance(gear, width, **options)


def test_it_is_made_once_and_comes_back_as_it_was(folder: Path, made: list[str]):
    first, second = of(), of()
    assert made == ["made"]
    for name in ("roll", "axial", "influence", "depth", "asymmetry", "seconds"):
        assert np.array_equal(getattr(first, name), getattr(second, name))
    assert len(list(folder.glob(f"*/*{kept.SUFFIX}"))) == 1


@pytest.mark.parametrize(
    "other",
    [
        {"gear": replace(GEAR, profile_shift=0.1)},
        {"gear": replace(GEAR, helix_angle=0.1)},
        {"width": 0.021},
        {"material": named("nodular-cast-iron")},
        {"settings": replace(COARSE, layer=0.15)},
        {"settings": replace(COARSE, rim_depth=3.0)},
        {"settings": SectorSettings(Fineness(flank=1, fillet=1, core=1, rim=1, axial=2), teeth=3)},
    ],
)
def test_nothing_that_it_depends_on_is_overlooked(other: dict, folder: Path, made: list[str]):
    of()
    of(**other)
    assert len(made) == 2


def test_sources_that_changed_make_it_anew(folder: Path, made: list[str], monkeypatch: pytest.MonkeyPatch):
    of()
    monkeypatch.setattr(compliance, "_makers", lambda: kept.digest([b"changed"]))
    of()
    assert len(made) == 2


DAMAGES: list[Callable[[bytes], bytes]] = [
    lambda data: data[: len(data) // 2],
    lambda data: data[:-40] + bytes([data[-40] ^ 1]) + data[-39:],
    lambda data: b"",
    lambda data: b"something else",
]


@pytest.mark.parametrize("damage", DAMAGES)
def test_a_damaged_or_foreign_file_is_made_anew(damage, folder: Path, made: list[str]):
    first = of()
    (file,) = folder.glob(f"*/*{kept.SUFFIX}")
    file.write_bytes(damage(file.read_bytes()))
    assert np.array_equal(of().influence, first.influence)
    assert len(made) == 2
    of()
    assert len(made) == 2


def test_a_folder_that_others_may_write_to_is_not_used(folder: Path, made: list[str]):
    folder.mkdir()
    folder.chmod(0o777)
    (folder / "something").touch()
    of()
    of()
    assert len(made) == 2
    assert not list(folder.glob("*/*"))


def test_nothing_is_kept_where_that_is_not_wanted(folder: Path, made: list[str]):
    of(keep=False)
    assert not folder.exists()


def test_what_other_versions_left_goes_after_a_month(folder: Path):
    old = folder / ("0" * 16)
    folder.mkdir(mode=0o700)
    old.mkdir(mode=0o700)
    (old / f"x{kept.SUFFIX}").touch()
    os.utime(old, (0.0, 0.0))
    of()
    assert not old.exists()
