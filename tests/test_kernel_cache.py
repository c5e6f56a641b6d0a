"""The cache of compiled kernels: no stale one, none damaged, no end of old ones.

A package of two kernels stands for the whole one: `_kernel.py` is copied into it and looks at its files.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import gearlash._kernel as kernels

CALLEE = """
from tiny._kernel import inner

@inner
def factor(x):
    return 2.0 * x
"""
CALLER = """
from numba import float64
from tiny._callee import factor
from tiny._kernel import kernel

@kernel(float64(float64))
def doubled(x):
    return factor(x) + 1.0
"""
PROGRAM = "from tiny._caller import doubled; print(doubled(10.0), sum(doubled.stats.cache_hits.values()))"


@pytest.fixture
def tiny(tmp_path: Path) -> Path:
    """A folder with the package `tiny` in it."""
    package = tmp_path / "tiny"
    package.mkdir()
    (package / "__init__.py").touch()
    shutil.copy(kernels.__file__, package / "_kernel.py")
    (package / "_callee.py").write_text(CALLEE, encoding="utf-8")
    (package / "_caller.py").write_text(CALLER, encoding="utf-8")
    return tmp_path


def run(folder: Path, cache: Path) -> tuple[float, int]:
    """What the kernel returns for 10 in a new process, and how many kernels came out of the cache."""
    env = {
        **os.environ,
        "PYTHONPATH": str(folder),
        "GEARLASH_CACHE_DIR": str(cache),
        "NUMBA_DISABLE_JIT": "0",
    }
    ran = subprocess.run(
        [sys.executable, "-c", PROGRAM], capture_output=True, text=True, env=env, check=False
    )
    assert (ran.returncode, ran.stderr) == (0, "")
    value, hits = ran.stdout.split()
    return float(value), int(hits)


def test_a_changed_callee_in_another_file_is_compiled_again(tiny: Path):
    cache = tiny / "cache"
    assert run(tiny, cache) == (21.0, 0)
    assert run(tiny, cache) == (21.0, 1)
    (first,) = cache.iterdir()
    callee = tiny / "tiny" / "_callee.py"
    callee.write_text(CALLEE.replace("2.0", "3.0"), encoding="utf-8")
    assert run(tiny, cache) == (31.0, 0)
    assert len(list(cache.iterdir())) == 2
    callee.write_text(CALLEE, encoding="utf-8")
    assert run(tiny, cache) == (21.0, 1)
    assert first in cache.iterdir()


def truncated(data: bytes) -> bytes:
    return data[: len(data) // 2]


def one_bit(data: bytes) -> bytes:
    middle = len(data) // 2
    return data[:middle] + bytes([data[middle] ^ 1]) + data[middle + 1 :]


@pytest.mark.parametrize("suffix", ["nbi", "nbc"])
def test_damaged_files_are_compiled_again(suffix: str, tiny: Path):
    cache = tiny / "cache"
    run(tiny, cache)
    (file,) = cache.glob(f"*/*.{suffix}")
    file.write_bytes((one_bit if suffix == "nbc" else truncated)(file.read_bytes()))
    assert run(tiny, cache) == (21.0, 0)
    assert run(tiny, cache) == (21.0, 1)


@pytest.mark.parametrize("damage", [truncated, one_bit, lambda data: b"", lambda data: b"\x80garbage" * 9])
def test_damage_is_seen_before_anything_is_read(damage: Callable[[bytes], bytes], tmp_path: Path):
    file = tmp_path / "kernel.nbi"
    whole = b"content" + hashlib.sha256(b"content").digest()
    file.write_bytes(whole)
    assert kernels._unsealed(str(file)) == b"content"
    file.write_bytes(damage(whole))
    with pytest.raises(OSError, match="is damaged"):
        kernels._unsealed(str(file))


def test_a_cache_that_cannot_be_written_still_computes(tiny: Path):
    (tiny / "file").touch()
    assert run(tiny, tiny / "file" / "cache") == (21.0, 0)
    assert run(tiny, tiny / "file" / "cache") == (21.0, 0)


def old(folder: Path, days: float) -> Path:
    """A cache folder last used so many days ago."""
    folder.mkdir()
    (folder / "kernel.nbi").touch()
    (folder / "kernel.1.nbc").touch()
    then = folder.stat().st_mtime - 86400.0 * days
    os.utime(folder, (then, then))
    return folder


def test_kernels_of_versions_long_unused_go_and_nothing_else(tmp_path: Path):
    gone = old(tmp_path / "0123456789abcdef", 31.0)
    recent = old(tmp_path / "123456789abcdef0", 29.0)
    foreign = old(tmp_path / "photographs", 99.0)
    own = old(tmp_path / "23456789abcdef01", 99.0)
    kernels.prune(own)
    assert not gone.exists()
    assert {folder.name for folder in tmp_path.iterdir()} == {recent.name, foreign.name, own.name}
    mixed = old(tmp_path / "3456789abcdef012", 0.0)
    (mixed / "letter.txt").touch()
    os.utime(mixed, (0.0, 0.0))
    kernels.prune(own)
    assert [file.name for file in mixed.iterdir()] == ["letter.txt"]


def test_a_user_without_a_home_has_no_cache_and_no_problem(monkeypatch: pytest.MonkeyPatch):
    def nowhere() -> Path:
        raise RuntimeError("Could not determine home directory.")

    for name in ("GEARLASH_CACHE_DIR", "XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(Path, "home", nowhere)
    assert not kernels._writable(kernels.cache_folder())
