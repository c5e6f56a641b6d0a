"""A short name with a unit is the physical quantity that has it; what may mean two things is refused."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from gearlash.case import CaseError, load
from gearlash.system import GearlashError

ARTICLE = load("article-first-harmonic")


@pytest.mark.parametrize(
    ("name", "text", "path", "value"),
    [
        ("error", "6um", "mesh.error", 6e-6),
        ("error", "6 µm", "mesh.error", 6e-6),
        ("error", "6·10⁻⁶ m", "mesh.error", 6e-6),
        ("error_2", "6um", "mesh.error_2", 6e-6),
        ("load", "150Nm", "operation.torque", 150.0),
        ("load", "0.15 kN·m", "operation.torque", 150.0),
        ("omega", "4200rpm", "operation.pinion_speed", 140.0 * np.pi),
        ("omega", "4200 U/min", "operation.pinion_speed", 140.0 * np.pi),
        ("omega", "1.68 kHz", "operation.mesh_frequency", 1680.0),
        ("pinion_speed", "4200 1/min", "operation.pinion_speed", 140.0 * np.pi),
        ("pinion_speed", "4200 min⁻¹", "operation.pinion_speed", 140.0 * np.pi),
        ("bearing_frequency_yp", "8·10⁸ N/m", "pinion.bearing_stiffness_y", 8e8),
        ("error", "0.06", "dimensionless.error", 0.06),
        ("error", 0.06, "dimensionless.error", 0.06),
        ("ripple", "30%", "dimensionless.ripple", 0.3),
        ("error_phase", "90°", "dimensionless.error_phase", np.pi / 2),
        ("mean_stiffness", "3.4·10⁸ N/m", "mesh.mean_stiffness", 3.4e8),
    ],
)
def test_a_unit_finds_its_quantity(name: str, text: Any, path: str, value: float):
    case = load("article-first-harmonic", {name: text})
    (entry,) = (entry for entry in case.entries.values() if entry.text == str(text))
    assert entry.path == path
    assert entry.number == pytest.approx(value, rel=1e-14)


def test_both_ways_to_one_quantity_are_one():
    by_unit, by_path = (
        load("article-first-harmonic", {name: "6um"}) for name in ("error", "mesh.error")
    )  # fmt: skip
    assert by_unit.hash == by_path.hash
    assert ARTICLE.resolve("error", "6um") == ARTICLE.resolve("mesh.error", "6um")
    assert ARTICLE.resolve("omega", "4200rpm") == ARTICLE.resolve("pinion_speed", "4200rpm")
    assert ARTICLE.named("error", "6um") == "mesh.error"
    assert ARTICLE.named("error", "0.06") == "error"


@pytest.mark.parametrize(
    ("name", "text", "told"),
    [
        ("D", "40um", "mesh.backlash=40um if that is the whole, twice as much if it is one of two sides"),
        ("omega", "4200 1/min", "operation.pinion_speed or operation.mesh_frequency by its name"),
        ("omega", "440 rad/s", "operation.pinion_speed or operation.mesh_frequency by its name"),
        ("omega", "70/s", "operation.pinion_speed or operation.mesh_frequency by its name"),
        ("omega", "5 um", "or operation.pinion_speed="),
        ("pinion_speed", "70 1/s", "write rev/s, rad/s or rpm"),
        ("pinion_speed", "70 Hz", "write rev/s, rad/s or rpm"),
        ("load", "500 N", 'or operation.torque="450 N·m"'),
        ("dimensionless.error", "6um", 'or mesh.error="5 um"'),
        ("mean_stiffness", "3,400 N/um", "write 3.400 or 3400"),
        ("mesh_damping", "5 um", "without unit"),
    ],
)
def test_what_may_mean_something_else_is_refused_with_what_to_type(name: str, text: str, told: str):
    with pytest.raises(CaseError) as refused:
        load("article-first-harmonic", {name: text})
    (problem,) = refused.value.problems
    assert (problem.path, problem.value) == (name, repr(text))
    assert told in problem.expected
    with pytest.raises(GearlashError):
        ARTICLE.resolve(name, text)


def test_a_case_without_units_says_so():
    with pytest.raises(CaseError) as refused:
        load("kahraman-singh", {"error": "6um"})
    (problem,) = refused.value.problems
    assert "this case is given in dimensionless numbers only" in problem.expected


def test_one_quantity_named_twice_shows_both():
    with pytest.raises(CaseError, match=r"error = '6um' and mesh\.error = '7um'"):
        load("article-first-harmonic", {"error": "6um", "mesh.error": "7um"})


@pytest.mark.parametrize("value", [np.float32(0.5), np.array(0.5), Decimal("0.5"), Fraction(1, 2), "1e-1"])
def test_numbers_of_all_kinds_are_values(value: Any):
    expected = 0.1 if isinstance(value, str) else 0.5
    assert load("article", {"mesh_damping": value}).family()[0].defaults["mesh_damping"] == expected


@pytest.mark.parametrize(
    "value", [True, np.True_, 1j, None, [0.5], np.array([0.5]), object(), Decimal("NaN"), {}]
)
def test_what_is_no_value_is_refused(value: Any):
    with pytest.raises(CaseError, match="mesh_damping"):
        load("article", {"mesh_damping": value})


@pytest.mark.parametrize(
    "text", ["GD² 0,2 kgm²", "GD2 = 0.2 kgf m^2", "0.2 kg m² (GD²)", "PD² 0.2 kgm2", "GD^2 = 2000 kg cm²"]
)
def test_weight_times_diameter_squared_is_four_moments_of_inertia(text: str):
    """GD² = G (2 i)²: four times G i² = J, in kg·m² of kgf·m²."""
    with pytest.raises(CaseError) as refused:
        load("wind-turbine", {"pinion.inertia": text})
    (problem,) = refused.value.problems
    assert problem.nearest == "0.05 kg*m^2"
    assert "GD² is 4 J" in problem.expected
