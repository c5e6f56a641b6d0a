"""What numba is not loaded for: anything, once kernels are compiled."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from gearlash import flow
from gearlash._kernel import compile_all, load_all

PROGRAM = """
import sys
from gearlash.cli import main
sys.argv[0] = "gearlash"
try:
    main()
finally:
    print("numba" in sys.modules, file=sys.stderr)
"""


@pytest.fixture(scope="module", autouse=True)
def compiled() -> None:
    """All kernels are in the cache."""
    assert flow
    compile_all(load_all())


@pytest.mark.parametrize(
    "arguments",
    [
        ("run", "article"),
        ("sweep", "kahraman-singh", "--over", "omega=0.9:0.95:3", "--workers", "1"),
        ("map", "kahraman-singh", "--over", "omega=0.9:0.95:2", "--over", "D=0.9:1.1:2", "--workers", "1"),
        ("graze", "kahraman-singh"),
    ],
    ids=lambda arguments: arguments[0],
)
def test_commands(arguments: tuple[str, ...], tmp_path: Path):
    ran = subprocess.run(
        [sys.executable, "-c", PROGRAM, *arguments, "--out", str(tmp_path)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert ran.returncode == 0
    assert ran.stderr.splitlines()[-1] == "False"


def test_declaring_kernels():
    script = "import sys, gearlash.flow; print({'numba', 'llvmlite', 'scipy'} & set(sys.modules))"
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == "set()"
