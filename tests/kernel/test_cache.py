"""The cache of compiled kernels: no stale one, none damaged, none of another machine, no end of old ones."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from gearlash._kernel import cache as kept
from kernel.tiny import CALLEE, CALLER, PROGRAM, process, run, write


@pytest.fixture
def tiny(tmp_path: Path) -> Path:
    return write(tmp_path)


def test_a_changed_callee_in_another_file_is_compiled_again(tiny: Path):
    cache = tiny / "cache"
    assert run(tiny, cache) == (21.0, False)
    assert run(tiny, cache) == (21.0, True)
    (first,) = cache.iterdir()
    callee = tiny / "tiny" / "_callee.py"
    callee.write_text(CALLEE.replace("2.0", "3.0"), encoding="utf-8")
    assert run(tiny, cache) == (31.0, False)
    assert len(list(cache.iterdir())) == 2
    callee.write_text(CALLEE, encoding="utf-8")
    assert run(tiny, cache) == (21.0, True)
    assert first in cache.iterdir()


def truncated(data: bytes) -> bytes:
    return data[: len(data) // 2]


def one_bit(data: bytes) -> bytes:
    middle = len(data) // 2
    return data[:middle] + bytes([data[middle] ^ 1]) + data[middle + 1 :]


DAMAGES = [truncated, one_bit, lambda data: b"", lambda data: b"\x80garbage" * 9]


@pytest.mark.parametrize("damage", DAMAGES[:2])
def test_damaged_files_are_compiled_again(damage: Callable[[bytes], bytes], tiny: Path):
    cache = tiny / "cache"
    run(tiny, cache)
    (file,) = cache.glob("*/*.kernel")
    file.write_bytes(damage(file.read_bytes()))
    assert run(tiny, cache) == (21.0, False)
    assert run(tiny, cache) == (21.0, True)


@pytest.mark.parametrize("damage", DAMAGES)
def test_damage_is_seen_before_anything_is_loaded(
    damage: Callable[[bytes], bytes], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setenv("GEARLASH_CACHE_DIR", str(tmp_path))
    code = {"some.nbi": b"\x7fELF\nand so on" * 9, "some.1.nbc": b"", "some.2.nbc": b"\n"}
    assert kept.read("some.kernel") is None
    kept.write("some.kernel", code)
    assert kept.read("some.kernel") == code
    (file,) = tmp_path.glob("*/*")
    assert hashlib.sha256(file.read_bytes()[:-32]).digest() == file.read_bytes()[-32:]
    file.write_bytes(damage(file.read_bytes()))
    assert kept.read("some.kernel") is None


def test_another_processor_gets_kernels_of_its_own_in_the_same_folder(tiny: Path):
    cache = tiny / "cache"
    other = {"NUMBA_CPU_NAME": "generic", "NUMBA_CPU_FEATURES": ""}
    assert run(tiny, cache) == (21.0, False)
    assert run(tiny, cache, **other) == (21.0, False)
    assert len(list(cache.glob("*/*.kernel"))) == 2
    assert run(tiny, cache) == run(tiny, cache, **other) == (21.0, True)


@pytest.mark.parametrize("what", ["get_host_cpu_name", "get_process_triple"])
def test_machine_code_is_named_by_the_machine(what: str, monkeypatch: pytest.MonkeyPatch):
    from llvmlite import binding

    here = kept.machine_hash.__wrapped__()
    assert here == kept.machine_hash()
    monkeypatch.setattr(binding, what, lambda: "another")
    assert kept.machine_hash.__wrapped__() != here


def test_a_processor_with_one_feature_less_is_another_machine(monkeypatch: pytest.MonkeyPatch):
    from llvmlite import binding

    features = binding.get_host_cpu_features()
    present = next(name for name, there in features.items() if there)
    here = kept.machine_hash()
    monkeypatch.setattr(
        binding, "get_host_cpu_features", lambda: type(features)({**features, present: False})
    )
    assert kept.machine_hash.__wrapped__() != here


def test_a_cache_that_cannot_be_written_still_computes(tiny: Path):
    (tiny / "file").touch()
    assert run(tiny, tiny / "file" / "cache") == (21.0, False)
    assert run(tiny, tiny / "file" / "cache") == (21.0, False)


READ_ONLY = """
import os, pathlib
cache = os.environ["GEARLASH_CACHE_DIR"]
def refuse(home, name):
    allowed = getattr(home, name)
    def refused(path, *arguments, **options):
        if str(path).startswith(cache) and not (name == "open" and not arguments[0] & os.O_CREAT):
            raise OSError(30, "Read-only file system")
        return allowed(path, *arguments, **options)
    setattr(home, name, refused)
for name in ("touch", "mkdir", "write_bytes", "replace"):
    refuse(pathlib.Path, name)
for name in ("utime", "mkdir", "open"):
    refuse(os, name)
"""
NO_ROOM = """
import tempfile
def full(*arguments, **options):
    raise OSError(28, "No space left on device")
tempfile.TemporaryDirectory = full
"""


def test_a_cache_that_can_only_be_read_is_read(tiny: Path):
    cache = tiny / "cache"
    run(tiny, cache)
    assert run(tiny, cache, READ_ONLY) == (21.0, True)
    for file in cache.glob("*/*.kernel"):
        file.unlink()
    assert run(tiny, cache, READ_ONLY) == (21.0, False)


def test_without_room_for_temporary_files_it_is_compiled_in_memory_and_told(tiny: Path):
    cache = tiny / "cache"
    run(tiny, cache)
    ran = process(tiny, cache, NO_ROOM + PROGRAM, GEARLASH_QUIET="0")
    assert ran.stdout.split() == ["21.0", "False"]
    assert "no room for temporary files (No space left on device), so every run will" in ran.stderr
    assert run(tiny, cache) == (21.0, True)


def test_a_disk_that_is_full_leaves_nothing_unfinished(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    def full(file: Path, target: Path) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setenv("GEARLASH_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(Path, "replace", full)
    kept.write("some.kernel", {"some.nbi": b"code"})
    assert list(tmp_path.glob("*/*")) == []


def test_without_a_python_to_start_this_process_compiles(tiny: Path):
    cache = tiny / "cache"
    assert run(tiny, cache, "import sys; sys.frozen = True\n") == (21.0, False)
    assert run(tiny, cache) == (21.0, True)


def test_a_kernel_that_cannot_be_compiled_says_why(tmp_path: Path):
    folder = write(tmp_path, CALLER.replace("+ 1.0", "+ 'one'"))
    ran = process(folder, folder / "cache")
    assert ran.returncode == 1
    assert "TypingError" in ran.stderr
    assert list((folder / "cache").glob("*/*.kernel")) == []


def old(folder: Path, days: float) -> Path:
    """A cache folder last used so many days ago."""
    folder.mkdir()
    (folder / "run-0123456789abcdef.kernel").touch()
    (folder / "unfinished-0123456789abcdef.kernel").touch()
    (folder / "compiling.lock").touch()
    then = folder.stat().st_mtime - 86400.0 * days
    os.utime(folder, (then, then))
    return folder


def test_kernels_of_versions_long_unused_go_and_nothing_else(tmp_path: Path):
    mixed = old(tmp_path / "3456789abcdef012", 0.0)
    (mixed / "letter.txt").touch()
    os.utime(mixed, (0.0, 0.0))
    gone = [old(tmp_path / name, 31.0) for name in ("0123456789abcdef", "456789abcdef0123")]
    recent = old(tmp_path / "123456789abcdef0", 29.0)
    foreign = old(tmp_path / "photographs", 99.0)
    own = old(tmp_path / "23456789abcdef01", 99.0)
    kept.prune(own)
    assert not any(folder.exists() for folder in gone)
    assert {folder.name for folder in tmp_path.iterdir()} == {
        recent.name,
        foreign.name,
        own.name,
        mixed.name,
    }
    assert [file.name for file in mixed.iterdir()] == ["letter.txt"]


def test_a_user_without_a_home_has_no_cache_and_no_problem(monkeypatch: pytest.MonkeyPatch):
    def nowhere() -> Path:
        raise RuntimeError("Could not determine home directory.")

    for name in ("GEARLASH_CACHE_DIR", "XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(Path, "home", nowhere)
    assert kept.trouble(kept.cache_folder()) == "cannot be written"
