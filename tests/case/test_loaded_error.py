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
    assert "that the stiffness makes" in values["mesh.error"].reason
    assert values["mesh.error"].least is None


@pytest.mark.parametrize(
    ("old", "new", "word"),
    [
        ('loaded_error = "8 um"', 'loaded_error = "8 um"\nerror = "3 um"', "no error beside it"),
        ('loaded_error_torque = "150 N m"\n', "", "the pinion torque it was found at"),
        ("[operation]", "[dimensionless]\nerror_2 = 0.1\n[operation]", "no error beside it"),
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
