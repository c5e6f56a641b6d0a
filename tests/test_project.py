"""The project around the package: what is shipped, what is pinned, what its pages point to."""

from __future__ import annotations

import re
import shutil
import subprocess
import tomllib
import zipfile
from importlib.metadata import packages_distributions, version
from pathlib import Path

import pytest
from hatchling.builders.wheel import WheelBuilder

ROOT = Path(__file__).resolve().parents[1]
PAGES = [*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")]
LOCKS = sorted((ROOT / "requirements").glob("*.txt"))


def test_wheel_holds_every_file_of_the_package(tmp_path: Path):
    wheel = next(WheelBuilder(str(ROOT)).build(directory=str(tmp_path), versions=["standard"]))
    source = ROOT / "src"
    present = (f for f in source.glob("gearlash/**/*") if f.is_file() and "__pycache__" not in f.parts)
    expected = {f.relative_to(source).as_posix() for f in present}
    with zipfile.ZipFile(wheel) as archive:
        shipped = {name for name in archive.namelist() if ".dist-info/" not in name}
    assert shipped == expected
    assert "gearlash/py.typed" in shipped


def test_version_is_the_same_everywhere():
    stated = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["version"]
    assert version("gearlash") == stated
    assert f"\nversion: {stated}\n" in (ROOT / "CITATION.cff").read_text()


@pytest.mark.parametrize("lock", LOCKS, ids=lambda lock: lock.name)
def test_lock_pins_everything_and_names_no_host(lock: Path):
    lines = [line for line in lock.read_text().splitlines() if not line.startswith("#")]
    assert lines
    assert [line for line in lines if not re.match(r"[A-Za-z0-9._-]+==[0-9]", line)] == []
    assert "://" not in lock.read_text()


def test_locks_agree():
    run, dev = ((ROOT / "requirements" / name).read_text() for name in ("run.txt", "dev.txt"))

    def pins(text: str) -> set[str]:
        return {line.partition("#")[0].strip() for line in text.splitlines() if "==" in line}

    assert pins(run) <= pins(dev)


def test_extras_have_code_that_imports_them():
    """`dev` is what tests and benchmarks need; any other extra is imported somewhere in the package."""

    def imported(distribution: str) -> str:
        """The name under which a distribution is imported: that of scikit-fem is another one."""
        return next(name for name, of in packages_distributions().items() if distribution in of)

    stated = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
    source = "\n".join(f.read_text(encoding="utf-8") for f in (ROOT / "src").rglob("*.py"))
    names = {
        extra: [imported(re.split(r"[<>=\[; ]", wanted)[0]) for wanted in needs]
        for extra, needs in stated.items()
        if extra != "dev"
    }
    unused = {
        extra: [n for n in needs if not re.search(rf"^\s*(from|import) {n}\b", source, re.MULTILINE)]
        for extra, needs in names.items()
    }
    assert {extra: needs for extra, needs in unused.items() if needs} == {}


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_pages_point_to_what_exists(page: Path):
    targets = re.findall(r"\]\(([^)#\s]+)[^)]*\)", page.read_text(encoding="utf-8"))
    local = [target for target in targets if "://" not in target and not target.startswith("mailto:")]
    assert [target for target in local if not (page.parent / target).exists()] == []


def test_make_says_what_it_needs_where_no_python_is_suitable(tmp_path: Path):
    shutil.copy(ROOT / "Makefile", tmp_path)
    run = subprocess.run(
        ["make", "PYTHON=no-such-python", ".venv/bin/python"], cwd=tmp_path, capture_output=True, text=True
    )
    assert run.returncode != 0
    assert "needs Python 3.11 or newer" in run.stderr
    assert "no-such-python" in run.stderr
    assert not (tmp_path / ".venv").exists()
