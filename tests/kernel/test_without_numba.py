"""What numba is not loaded for, and that its settings stay the user's."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from kernel.tiny import PROGRAM, process, run, write

COMMAND = """
import sys
from gearlash.cli import main
sys.argv[0] = "gearlash"
try:
    main()
finally:
    print("numba" in sys.modules, file=sys.stderr)
"""


@pytest.mark.parametrize("arguments", [("check", "article"), ("schema",), ("--help",), ("--version",)])
def test_commands_that_compute_nothing(arguments: tuple[str, ...]):
    ran = subprocess.run(
        [sys.executable, "-c", COMMAND, *arguments], capture_output=True, text=True, check=False
    )
    assert ran.returncode == 0
    assert ran.stderr.splitlines()[-1] == "False"


@pytest.mark.parametrize("imported", ["gearlash", "gearlash.case, gearlash.jobs, gearlash._kernel"])
def test_imports_that_compute_nothing(imported: str):
    script = f"import sys, {imported}; print({{'numba', 'llvmlite', 'scipy'}} & set(sys.modules))"
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == "set()"


OWN = """
import numba
from pathlib import Path
before = dict(vars(numba.config))
{setting}

def own():
    @numba.njit(cache=True)
    def function(x):
        return x + 1.0
    return Path(function.stats.cache_path)

first = own()
{program}
assert own() == first
assert Path({cache!r}) not in first.parents
changed = {{name for name in before if getattr(numba.config, name) != before[name]}}
assert changed <= {{"CACHE_DIR"}} and numba.config.CACHE_DIR == {folder!r}, changed
"""


@pytest.mark.parametrize("own", [True, False])
def test_the_settings_of_numba_are_the_users(own: bool, tmp_path: Path):
    """Where his functions are kept, too; and nothing of ours is kept there."""
    package, cache, folder = write(tmp_path), tmp_path / "cache", str(tmp_path / "his") if own else ""
    script = tmp_path / "script.py"
    setting = f"numba.config.CACHE_DIR = {folder!r}"
    script.write_text(OWN.format(setting=setting, program=PROGRAM, cache=str(cache), folder=folder), "utf-8")
    for _ in range(2):
        ran = process(package, cache, f"import runpy; runpy.run_path({str(script)!r})")
        assert (ran.returncode, ran.stderr) == (0, "")
    assert not list(tmp_path.glob("his/**/_caller*"))
    assert not list((tmp_path / "tiny").glob("**/*.nbi"))
    assert run(package, cache) == (21.0, True)
