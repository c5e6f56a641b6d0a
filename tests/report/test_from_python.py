"""A report from Python: of a script that guards nothing, as a notebook guards nothing, with workers."""

from __future__ import annotations

import subprocess
import sys
import threading
from pathlib import Path
from typing import Any

import pytest

import gearlash as gl
from gearlash.report.pair import verdict
from gearlash.studies.assessment import assess

CASES = Path(__file__).resolve().parents[1] / "cases"
SCRIPT = f"""
import gearlash as gl

case = gl.load_case({str(CASES / "drive.toml")!r})
low, high = (float(case.scales.omega_from_rpm(rpm)) for rpm in (4050.0, 4250.0))
speeds = gl.Axis.even("omega", low, high, 5)
with gl.open_workers(case, 2) as workers:
    found = gl.pair_report(case, "page", speeds=speeds, execution=gl.Execution(workers))
print(found.page)
print(found.verdict, *(round(float(case.scales.pinion_rpm(one.upper.value)), 1) for one in found.separating))
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
    page, said = ran.stdout.splitlines()
    assert Path(page) == Path("page/report.html")
    assert said == "good 4114.1"  # as the command says: tests/cli/test_report.py
    assert "no impacts found" in (tmp_path / "page" / "report.html").read_text(encoding="utf-8")


def test_a_verdict_alone_writes_nothing_and_says_what_the_page_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.chdir(tmp_path)
    case = gl.load_case("kahraman-singh", {"omega": 0.8})
    told: list[int] = []
    axis, execution = (
        gl.Axis.even("omega", 0.7, 0.9, 5),
        gl.Execution(progress=lambda one: told.append(one.done)),
    )
    found = gl.pair_report(case, speeds=axis, execution=execution)
    assert (found.verdict, found.page, found.missing) == ("doubt", None, ())
    assert not list(tmp_path.iterdir())
    assert told
    oracle = assess(case, axis)
    assert found.sentence == verdict(oracle).lines[0].text
    assert dict(found.lines) == {line.title: line.text for line in verdict(oracle).lines[1:]}
    bands = sorted((one.lower.value, one.upper.value) for one in (*found.separating, *found.beside))
    assert bands == sorted((one.lower.value, one.upper.value) for one in oracle.separating)


def test_a_report_that_is_stopped_says_what_is_missing(tmp_path: Path):
    """After the verdict: neither curves nor maps, and a page of what there is."""
    case, axis = gl.load_case("kahraman-singh", {"omega": 0.8}), gl.Axis.even("omega", 0.7, 0.9, 5)
    stop = threading.Event()
    stop.set()
    found = gl.pair_report(case, tmp_path, speeds=axis, execution=gl.Execution(cancel=stop))
    assert found.missing == ("curves over speed", "the map over torque", "the map over backlash")
    assert found.page == tmp_path / "report.html"
    assert (tmp_path / "report.html").is_file()
    assert not found.separating
    alone = gl.pair_report(case, speeds=axis, execution=gl.Execution(cancel=stop))
    assert alone.missing == ("part of the bands of speed and of the ranges",)


@pytest.mark.parametrize("wrong", [{"speeds": [0.7, 0.9]}, {"execution": 2}, {"settings": {}}, {"folder": 3}])
def test_what_does_not_fit_is_refused_before_anything_is_computed(wrong: dict[str, Any]):
    with pytest.raises(gl.GearlashError, match=next(iter(wrong))):
        gl.pair_report(gl.load_case("kahraman-singh"), **wrong)


def test_speeds_may_have_any_name_that_a_case_has_for_them():
    case = gl.load_case(CASES / "drive.toml")
    low, high = (float(case.scales.omega_from_rpm(rpm)) for rpm in (4050.0, 4250.0))
    said = gl.pair_report(case, speeds=gl.Axis.even("omega", low, high, 5))
    named = gl.pair_report(case, speeds=gl.Axis.even("pinion_speed", "4050 rpm", "4250 rpm", 5))
    assert said.separating
    assert [(one.lower.value, one.upper.value) for one in named.separating] == [
        pytest.approx((one.lower.value, one.upper.value), rel=1e-12) for one in said.separating
    ]
    assert named.sentence == said.sentence


@pytest.mark.parametrize(
    ("axis", "said"),
    [
        (gl.Axis.even("D", 0.5, 1.0, 3), "axis D: a report goes over speed, such as pinion_speed or omega"),
        (gl.Axis.even("pinion_sped", "1 rpm", "2 rpm", 3), "pinion_speed"),
        (gl.Axis.even("pinion_speed", 1000.0, 2000.0, 3), "rpm"),
    ],
)
def test_what_is_no_speed_is_refused_with_what_is(axis: gl.Axis, said: str):
    with pytest.raises(gl.GearlashError, match=said):
        gl.pair_report(gl.load_case(CASES / "drive.toml"), speeds=axis)


@pytest.mark.slow
def test_nothing_of_an_earlier_report_stays_beside_a_new_one(tmp_path: Path):
    """And what lies there that no report wrote stays."""
    axis = gl.Axis.even("omega", 0.5, 0.6, 5)
    gl.pair_report(gl.load_case("kahraman-singh", {"omega": 0.55}), tmp_path, speeds=axis)
    assert {"speed.csv", "spectrum-nominal.nc", "speed-forces.svg"} <= _names(tmp_path)
    for mine in ("thesis.txt", "figures/mine.svg"):
        (tmp_path / mine).write_text("mine", encoding="utf-8")
    (tmp_path / "verdict.json").write_text("{}", encoding="utf-8")  # of the command, which owns that name
    stop = threading.Event()
    stop.set()
    case, fresh = gl.load_case("kahraman-singh", {"omega": 0.56}), tmp_path / "fresh"
    for folder in (tmp_path, fresh):
        found = gl.pair_report(case, folder, speeds=axis, execution=gl.Execution(cancel=stop))
        assert found.missing
    assert _names(tmp_path) == {*_names(fresh), "thesis.txt", "mine.svg"}


def _names(folder: Path) -> set[str]:
    return {path.name for part in (folder, folder / "figures") for path in part.iterdir() if path.is_file()}
