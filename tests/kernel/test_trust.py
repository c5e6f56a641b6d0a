"""Machine code is loaded from a folder of the user that nobody else may write, and from no other."""

from __future__ import annotations

import os
import stat
from collections.abc import Callable
from pathlib import Path

import pytest

from gearlash._kernel import cache as kept
from gearlash._kernel import trust
from kernel.tiny import process, run, write

pytestmark = pytest.mark.skipif(not trust.KNOWS_OWNERS, reason="owners and modes of files, as POSIX has them")
ROOT = hasattr(os, "geteuid") and os.geteuid() == 0
CODE = {"some.nbi": b"\x7fELF\nand so on" * 9}


def mode(path: Path) -> int:
    return stat.S_IMODE(path.stat().st_mode)


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """One kernel in a cache that did not exist before."""
    folder = tmp_path / "in" / "cache"
    monkeypatch.setenv("GEARLASH_CACHE_DIR", str(folder))
    kept.trouble.cache_clear()
    kept.write("some.kernel", CODE)
    assert kept.read("some.kernel") == CODE
    kept.trouble.cache_clear()
    return folder


@pytest.mark.parametrize("umask", [0o000, 0o002, 0o022, 0o077])
def test_the_cache_is_made_for_this_user_alone(umask: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setenv("GEARLASH_CACHE_DIR", str(tmp_path / "cache"))
    before = os.umask(umask)
    try:
        kept.write("some.kernel", CODE)
    finally:
        os.umask(before)
    (file,) = tmp_path.glob("cache/*/*.kernel")
    assert mode(file) == 0o600
    assert mode(file.parent) == mode(tmp_path / "cache") == 0o700
    assert kept.read("some.kernel") == CODE


def widen(which: int) -> Callable[[Path], None]:
    def change(cache: Path) -> None:
        (file,) = cache.glob("*/*.kernel")
        chosen = (cache, file.parent, file)[which]
        chosen.chmod(mode(chosen) | 0o020)

    return change


def give_away(which: int) -> Callable[[Path], None]:
    def change(cache: Path) -> None:
        (file,) = cache.glob("*/*.kernel")
        os.chown((cache, file.parent, file)[which], 12345, -1)

    return change


def link_the_file(cache: Path) -> None:
    (file,) = cache.glob("*/*.kernel")
    file.rename(cache / "elsewhere")
    file.symlink_to(cache / "elsewhere")


def link_the_version(cache: Path) -> None:
    (file,) = cache.glob("*/*.kernel")
    file.parent.rename(cache / "elsewhere")
    file.parent.symlink_to(cache / "elsewhere")


def pipe(cache: Path) -> None:
    (file,) = cache.glob("*/*.kernel")
    file.unlink()
    os.mkfifo(file, 0o600)


CHANGES = [widen(0), widen(1), widen(2), link_the_file, link_the_version, pipe]
if ROOT:
    CHANGES += [give_away(0), give_away(1), give_away(2)]


@pytest.mark.parametrize("change", CHANGES)
def test_what_somebody_else_may_have_written_is_not_read(change: Callable[[Path], None], cache: Path):
    change(cache)
    assert kept.read("some.kernel") is None


@pytest.mark.parametrize(("which", "words"), [(0, "others may write to it"), (1, "others may write to it")])
def test_nor_is_anything_written_there(which: int, words: str, cache: Path):
    widen(which)(cache)
    (file,) = cache.glob("*/*.kernel")
    file.unlink()
    kept.write("some.kernel", CODE)
    assert list(cache.glob("*/*.kernel")) == []
    assert words in kept.trouble(cache)


def test_a_link_of_the_user_to_a_folder_of_his_is_followed(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    (tmp_path / "link").symlink_to(cache)
    monkeypatch.setenv("GEARLASH_CACHE_DIR", str(tmp_path / "link"))
    assert kept.trouble(tmp_path / "link") == ""
    assert kept.read("some.kernel") == CODE
    if ROOT:
        os.chown(tmp_path / "link", 12345, -1, follow_symlinks=False)
        assert kept.read("some.kernel") is None


def test_a_relative_folder_is_not_used(cache: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.chdir(cache.parent)
    monkeypatch.setenv("GEARLASH_CACHE_DIR", "cache")
    assert kept.read("some.kernel") is None
    assert "no absolute path" in kept.trouble(Path("cache"))
    monkeypatch.delenv("GEARLASH_CACHE_DIR")
    monkeypatch.setenv("XDG_CACHE_HOME", "cache")
    assert kept.cache_folder().is_absolute()


def test_a_cache_made_wider_by_an_older_version_is_closed_and_a_home_is_not(cache: Path, tmp_path: Path):
    cache.chmod(0o755)
    assert kept.trouble(cache) == ""
    assert mode(cache) == 0o700
    home = tmp_path / "home"
    home.mkdir(mode=0o755)
    (home / "letter.txt").touch()
    assert kept.trouble(home) == ""
    assert mode(home) == 0o755


def test_a_place_where_all_may_write_holds_a_folder_of_ones_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    everybody = tmp_path / "everybody"
    everybody.mkdir()
    everybody.chmod(0o1777)
    monkeypatch.setenv("GEARLASH_CACHE_DIR", str(everybody / "mine"))
    kept.write("some.kernel", CODE)
    assert kept.read("some.kernel") == CODE
    assert mode(everybody / "mine") == 0o700


def test_a_whole_process_compiles_in_memory_and_says_why(tmp_path: Path):
    folder = write(tmp_path)
    cache = folder / "cache"
    assert run(folder, cache) == (21.0, False)
    first = list(cache.glob("*/*.kernel"))
    written = first[0].stat().st_mtime_ns
    cache.chmod(0o777)
    ran = process(folder, cache, GEARLASH_QUIET="0")
    assert ran.stdout.split() == ["21.0", "False"]
    assert f"{cache} is not used, as others may write to it (mode 0777), so every run will" in ran.stderr
    assert ran.stderr.count("compiling kernels") == 1
    assert [file.stat().st_mtime_ns for file in cache.glob("*/*.kernel")] == [written]


def test_the_first_call_on_a_machine_says_that_it_compiles(tmp_path: Path):
    folder = write(tmp_path)
    first = process(folder, folder / "cache", GEARLASH_QUIET="")
    one, two = first.stderr.splitlines()
    assert (
        one == f"gearlash: compiling kernels, about 30 s on two free cores, once (kept in {folder / 'cache'})"
    )
    assert two.startswith("gearlash: compiled in ")
    assert process(folder, folder / "cache", GEARLASH_QUIET="").stderr == ""
    assert process(folder, folder / "other").stderr == ""  # GEARLASH_QUIET=1
