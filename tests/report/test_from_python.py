"""A report from Python: of a script that guards nothing, as a notebook guards nothing, with workers."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

CASES = Path(__file__).resolve().parents[1] / "cases"
SCRIPT = f"""
import gearlash as gl
from gearlash.report.pair import Contents, render
from gearlash.studies.assessment import assess
from gearlash.studies.speed_run import histories, speed_run

case = gl.load_case({str(CASES / "drive.toml")!r})
low, high = (float(case.scales.omega_from_rpm(rpm)) for rpm in (4150.0, 4250.0))
axis = gl.Axis.even("omega", low, high, 5)
with gl.open_workers(case, 2) as workers:
    execution = gl.Execution(workers)
    found = assess(case, axis, execution=execution)
    run = speed_run(found.case, axis, execution=execution)
    print(render(Contents(found, run, histories(found, run)), "page", workers))
"""


@pytest.mark.slow
@pytest.mark.parametrize("way", ["file", "input"])
def test_no_guard_is_needed(way: str, tmp_path: Path):
    script = tmp_path / "script.py"
    script.write_text(SCRIPT, encoding="utf-8")
    ran = subprocess.run(
        [sys.executable, *([script] if way == "file" else [])],
        input=None if way == "file" else SCRIPT,
        cwd=tmp_path, capture_output=True, text=True, timeout=300, check=False,
    )  # fmt: skip
    assert (ran.returncode, ran.stderr) == (0, "")
    assert Path(ran.stdout.strip()) == Path("page/report.html")
    assert "no impacts found" in (tmp_path / "page" / "report.html").read_text(encoding="utf-8")
