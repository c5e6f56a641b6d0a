"""What varies beside the parameters of a model: every member is the case with that value, in the units of the
case."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gearlash.case import Case, CaseError, load
from gearlash.system import BuildError, GearlashError, System, UnknownNameError

DRAWING = load(Path(__file__).parents[1] / "cases" / "drawing.toml")
SPUR = load("article")


def physical(system: System, case: Case) -> dict[str, np.ndarray]:
    """Numbers of a system that have units: its closed poles (1/s), static deflection (m) and force (N), mesh
    frequency (rad/s), gap (m)."""
    scales, mesh = case.scales, system.clearances[0]
    assert scales.omega_n is not None
    closed = system.matrix + np.outer(mesh.g, mesh.h * mesh.stiffness_plus[0])
    for index in range(1, system.size, 2):  # the damping of the mesh acts on X′
        assert system.matrix[index - 1, index] == pytest.approx(1.0)
    rate = np.zeros(system.size)
    rate[-1] = mesh.damping
    closed = closed + np.outer(mesh.g, rate)
    rest = np.linalg.solve(closed, -system.forcing[:, 0])
    return {
        "poles": np.sort_complex(np.linalg.eigvals(closed)) * scales.omega_n,
        "rest": np.atleast_1d(scales.length_m(rest[-2])),
        "force": np.atleast_1d(scales.force_N(mesh.stiffness_plus[0] * rest[-2])),
        "frequency": np.atleast_1d(system.omega * scales.omega_n),
        "gap": np.atleast_1d(scales.length_m(mesh.gap_plus)),
        "ripple": mesh.stiffness_plus[1:] / mesh.stiffness_plus[0],
        "error": scales.length_m(system.forcing[-1, 1:]) * scales.omega_n**2,
    }


@pytest.mark.parametrize(
    ("name", "text", "value"),
    [
        ("mesh.mean_stiffness", "9e8 N/m", 9e8),
        ("mesh.face_width", "30 mm", 30e-3),
        ("pinion.teeth", "27", 27),
        ("pinion.profile_shift", "0.2", 0.2),
        ("mesh.helix_angle", "12 deg", np.radians(12)),
        ("pinion.mass", "3 kg", 3.0),
        ("gear.bearing_stiffness_y", "1e8 N/m", 1e8),
    ],
)
def test_a_member_is_the_case_with_that_value(name, text, value):
    varied, stated = DRAWING.varying(name), DRAWING.with_overrides({name: text})
    here = physical(varied.family()[0].system({name: value}), DRAWING)
    there = physical(stated.family()[0].system(), stated)
    for what, expected in there.items():
        assert here[what] == pytest.approx(expected, rel=1e-9, abs=1e-9 * np.abs(expected).max()), what
    assert np.array_equal(
        varied.family()[0].system().matrix, DRAWING.family()[0].system().matrix
    )  # nothing moved


def test_estimates_follow_the_torque():
    light = DRAWING.with_overrides({"torque": "30 N m"})
    at = float(DRAWING.scales.load_from_torque(30.0))
    here = physical(DRAWING.family()[0].system({"load": at}), DRAWING)
    there = physical(light.family()[0].system(), light)
    for what, expected in there.items():
        assert here[what] == pytest.approx(expected, rel=1e-9, abs=1e-9 * np.abs(expected).max()), what
    full = physical(DRAWING.family()[0].system(), DRAWING)
    assert here["force"] / here["rest"] < 0.8 * full["force"] / full["rest"]


def test_what_is_the_same_at_every_torque_is_said():
    assert "estimated for each torque" in DRAWING.held("load")
    assert "error is the same at every torque" in DRAWING.held("load")
    assert "ripple and error are" in DRAWING.with_overrides({"ripple": 0.1}).held("load")
    assert SPUR.held("load").startswith("stiffness and error are the same")
    assert SPUR.held("omega") == load("kahraman-singh").held("load") == ""


def test_parameters_of_the_model_keep_what_they_are_above_the_case():
    family = DRAWING.varying("pinion.teeth").family()[0]
    twice = {**family.defaults, "error": 2 * family.defaults["error"], "pinion.teeth": 26}
    one = {**family.defaults, "pinion.teeth": 26}
    more = family.system(twice).forcing[-1, 1:3] - family.system(one).forcing[-1, 1:3]
    added = family.defaults["error"] * family.system(one).omega ** 2
    assert np.hypot(*more) == pytest.approx(added, rel=1e-9)


def test_a_varied_case_travels_and_knows_its_units():
    case = DRAWING.varying("mean_stiffness")
    again = Case.from_json(case.to_json())
    assert again.family()[0].defaults == case.family()[0].defaults
    assert again.resolve("mean_stiffness", "1e9 N/m") == ("mesh.mean_stiffness", 1e9)
    ((path, value, unit),) = again.physical("mesh.mean_stiffness", 1e9)
    assert (path, float(value), unit) == ("mesh.mean_stiffness", 1e9, "N/m")
    assert case.varying("torque") is case
    assert SPUR.varying("pinion_speed") is SPUR


def test_what_cannot_vary_is_told():
    for name in ("pinion.material", "mesh.span", "model.reference_length"):
        with pytest.raises(GearlashError):
            DRAWING.varying(name)
    with pytest.raises(CaseError, match=r"one of pinion\.teeth, gear\.teeth"):
        DRAWING.varying("teeth")
    with pytest.raises(UnknownNameError):
        load("kahraman-singh").varying("mesh.mean_stiffness")
    family = DRAWING.varying("pinion.teeth").family()[0]
    with pytest.raises(GearlashError, match="whole numbers"):
        family.system({"pinion.teeth": 24.5})
    with pytest.raises((BuildError, GearlashError), match="base circles"):
        load(
            Path(__file__).parents[1] / "cases" / "drawing.toml", {"mesh.centre_distance": "127.5 mm"}
        ).varying("mesh.centre_distance").family()[0].system({"mesh.centre_distance": 0.11})
