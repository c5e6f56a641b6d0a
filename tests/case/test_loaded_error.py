"""What the stiffness makes of an error under load is counted once."""

from __future__ import annotations

from math import pi, radians
from pathlib import Path

import numpy as np
import pytest

from gearlash.case import CaseError, load, loads
from gearlash.gears.mesh import series
from gearlash.system import evaluate

DRIVE = (Path(__file__).parents[1] / "cases" / "drive.toml").read_text(encoding="utf-8")
LOADED = DRIVE.replace(
    'error = "8 um"\nerror_phase="90 deg"', 'loaded_error = "8 um"\nloaded_error_torque = "150 N m"'
)


def test_the_unloaded_error_and_the_deflection_are_the_loaded_error():
    case = loads(LOADED)
    values = case.family()[0].defaults
    scales = case.scales
    theta = np.linspace(0.0, 2.0 * pi, 50, endpoint=False)
    count = 8
    named = {f"{s}{'' if n == 1 else f'_{n}'}": 0.0 for s in ("ripple", "ripple_phase") for n in range(1, 9)}
    stiffness = evaluate(
        series({**named, **{k: v for k, v in values.items() if k in named}}, "ripple", 1.0, count), theta
    )
    error = scales.length_m(evaluate(series(values, "error", 0.0, count), theta))
    assert scales.radii is not None
    assert scales.mean_stiffness is not None
    force = 150.0 / (scales.radii[0] * scales.c_t)
    found = error + force / (scales.mean_stiffness * stiffness)
    assert found - found.mean() == pytest.approx(8e-6 * np.cos(theta), abs=1e-10)
    (value,) = [v for v in case.values() if v.path == "mesh.error"]
    assert value.provenance == "inferred"
    assert value.value == pytest.approx(
        8.0 + 0.12e6 * force / scales.mean_stiffness, rel=0.01
    )  # F/K sinks where K rises


def test_without_a_varying_stiffness_all_of_it_is_left():
    text = LOADED.replace("ripple = 0.12", "ripple = 0.0").replace(
        '"8 um"', '"8 um"\nloaded_error_phase = "30 deg"'
    )
    values = {v.path: v.value for v in loads(text).values()}
    assert values["mesh.error"] == pytest.approx(8.0)
    assert values["mesh.error_phase"] == pytest.approx(30.0)
    assert values["mesh.error_2"] == pytest.approx(0.0, abs=1e-9)
    assert radians(30) == pytest.approx(loads(text).family()[0].defaults["error_phase"])


def test_a_drawing_takes_the_estimated_stiffness_out():
    drawing = (Path(__file__).parents[1] / "cases" / "drawing.toml").read_text(encoding="utf-8")
    text = drawing.replace("[mesh]", '[mesh]\nloaded_error = "2 um"\nloaded_error_torque = "150 N m"')
    values = {v.path: v for v in loads(text).values()}
    assert values["mesh.error"].provenance == "inferred"
    assert "that stiffness and contact under load make" in values["mesh.error"].reason
    assert values["mesh.error"].least is None


@pytest.mark.parametrize(
    ("old", "new", "word"),
    [
        ('loaded_error = "8 um"', 'loaded_error = "8 um"\nerror = "3 um"', "no error beside it"),
        ('loaded_error_torque = "150 N m"\n', "", "the pinion torque it was found at"),
        ("[operation]", "[dimensionless]\nerror_2 = 0.1\n[operation]", "no error beside it"),
        ('loaded_error = "8 um"\n', "", "the amplitude that mesh.loaded_error_torque belongs to"),
        ('"150 N m"\n', '"0 N m"\n', "without load nothing is loaded"),
    ],
)
def test_what_would_count_twice_is_refused(old, new, word):
    assert old in LOADED
    with pytest.raises(CaseError, match=word):
        loads(LOADED.replace(old, new))


def test_an_override_of_one_takes_the_place_of_the_other():
    case = loads(LOADED, {"mesh.error": "5 um"})
    assert [v.value for v in case.values() if v.path == "mesh.error"] == [5.0]
    assert not [v for v in case.values() if v.path == "mesh.loaded_error"]
    back = load(Path(__file__).parents[1] / "cases" / "drive.toml",
                {"mesh.loaded_error": "8 um", "mesh.loaded_error_torque": "150 N m"})  # fmt: skip
    one, other = back.family()[0].defaults, loads(LOADED).family()[0].defaults
    assert one["error"] == pytest.approx(other["error"])


def phases_of(text: str) -> dict[str, tuple[object, object, object]]:
    values = loads(text).values()
    return {v.path: (v.provenance, v.least, v.greatest) for v in values if "phase" in v.path}


def test_a_phase_that_nobody_states_is_assumed_where_it_matters():
    not_known = "assumed", pytest.approx(-180.0), pytest.approx(180.0)
    assert phases_of(LOADED)["mesh.loaded_error_phase"] == not_known
    stated = LOADED.replace('"8 um"', '"8 um"\nloaded_error_phase = "0 deg"\nloaded_error_2 = "1 um"')
    found = phases_of(stated)
    assert found["mesh.loaded_error_phase"][0] == "given"
    assert found["mesh.loaded_error_phase_2"] == not_known
    plain = DRIVE.replace('error_phase="90 deg"', 'error_2 = "1 um"')
    assert phases_of(plain)["mesh.error_phase"] == phases_of(plain)["mesh.error_phase_2"] == not_known
    # of one harmonic alone the phase only says when time begins
    alone = plain.replace('error_2 = "1 um"', "").replace("ripple = 0.12", "ripple = 0.0")
    assert "mesh.error_phase" not in phases_of(alone)
    assert "mesh.ripple_phase" not in phases_of(plain)
    assert loads(LOADED).family()[0].defaults == loads(stated.replace(
        "\nloaded_error_2 = \"1 um\"", "")).family()[0].defaults  # fmt: skip


def test_a_value_without_its_unit_is_one_problem():
    with pytest.raises(CaseError) as told:
        loads(LOADED.replace('"8 um"', "8"))
    assert [p.path for p in told.value.problems] == ["mesh.loaded_error"]


CURVE = """
[curves.error]
{}
state = "loaded"
torque = "150 N m"
"""


def test_a_loaded_curve_means_the_same_however_its_units_are_written():
    plain = LOADED.replace('loaded_error = "8 um"\nloaded_error_torque = "150 N m"', "")

    def error(text: str) -> np.ndarray:
        return loads(plain + CURVE.format(text)).family()[0].system().forcing

    one = error('amplitudes = [3, 1]\nphases = [0.5, 1.0]\nunit = "um"')
    assert error('amplitudes = ["3 um", "0.001 mm"]\nphases = ["0.5 rad", 1]') == pytest.approx(
        one, rel=1e-12
    )
    one = error('points = [[0, -3], [0.25, 1], [0.5, 3], [0.75, 0]]\nunit = "um"')
    other = error('points = [[0, "-3 um"], [0.25, "1 um"], [0.5, "3e-3 mm"], [0.75, "0 um"]]')
    assert other == pytest.approx(one, rel=1e-12)
    values = {v.path: v for v in loads(plain + CURVE.format('amplitudes = [3]\nunit = "um"')).values()}
    assert values["curves.error.phases"].provenance == "assumed"


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ('amplitudes = ["3 um", 1]', "all are numbers, or all have their own unit"),
        ('amplitudes = ["3 um", "1 N"]', r"amplitudes\[1\]"),
        ('amplitudes = ["3 um"]\nphases = ["1 um"]', r"phases\[0\]"),
        ('points = [[0, "1 um"], [0.5, 2]]', "all are numbers, or all have their own unit"),
        ('low = "1 um"\nhigh = 3\ncontact_ratio = 1.6', "a number as low is"),
        ('amplitudes = [1]\nmean = "2 um"', "a number as the amplitudes are"),
        ("amplitudes = [1]", "in N and m, which are not there"),
    ],
)
def test_values_whose_unit_is_in_doubt_are_refused(text, word):
    plain = LOADED.replace('loaded_error = "8 um"\nloaded_error_torque = "150 N m"', "")
    with pytest.raises(CaseError, match=word):
        loads(plain + CURVE.format(text))
