"""K_v of ISO 6336-1, Method B, below resonance, and the highest mesh force of the model over the static one.

The standard's K_v is a straight line in N = ω/ω_E: forces of pitch and form deviations (here of grade 6)
and of the varying stiffness, less what tip relief takes. The model, here without deviations, has the
resonances at which harmonics of the mesh meet its natural frequency, N = 1/2, 1/3 …; the line passes
through them. Between them and with relief that fits the load both are near each other. Steps of the
stiffness of unmodified spur teeth excite more than the standard has.
"""

from __future__ import annotations

import pytest

from gearlash import attractor
from gearlash.case import Case, loads
from gearlash.case.rating import materials_of, method_b, pair_of
from gearlash.gears import dynamic_factor, equivalent_mass, mesh_stiffness
from gearlash.orbits.contact_force import force_extrema

TEXT = """
kind = "spur-1dof"
pinion = {teeth = 25, face_width = "20 mm", quality = 6, bore = "15 mm"}
gear = {teeth = 57, face_width = "20 mm", quality = 6, bore = "25 mm"}
mesh = {module = "2 mm", backlash = "100 um", error = "0 um"}
operation = {pinion_speed = "2000 rpm", torque = "60 N m"}
"""
PLAIN = loads(TEXT)
RELIEVED = loads(TEXT, {"pinion.tip_relief": "15 um", "gear.tip_relief": "15 um"})


def both(case: Case, omega: float) -> tuple[float, float, float]:
    """N, K_v of the model, K_v of the standard."""
    family, _ = case.family()
    found = attractor(family.system({"omega": omega}), family.start())
    static = family.defaults["load"] / family.defaults["rotation_factor"]
    standard = method_b(case, omega, (6, 6))
    return standard.resonance_ratio, float(max(force_extrema(found.trace, 0).force)) / static, standard.value


@pytest.mark.parametrize("omega", [0.22, 0.27])
def test_between_resonances_relieved_teeth_are_near_the_factor_of_the_standard(omega):
    ratio, own, standard = both(RELIEVED, omega)
    assert 0.15 < ratio < 0.3
    assert own == pytest.approx(standard, rel=0.03)


def test_where_a_harmonic_meets_the_natural_frequency_the_model_has_more():
    ratio, own, standard = both(RELIEVED, 0.45)
    assert 0.4 < ratio < 0.5
    assert own > 1.2 * standard


def test_steps_of_unmodified_teeth_excite_more():
    # Between harmonics 3 and 4, with the static error of contact beyond the path of contact.
    _, own, standard = both(PLAIN, 0.27)
    assert 1.2 * standard < own < 1.25 * standard


def test_the_factor_of_the_standard_has_the_relief_and_the_teeth_of_the_case():
    pair, body = pair_of(RELIEVED), RELIEVED.numbers.body
    mesh = mesh_stiffness.method_b(pair, materials_of(RELIEVED))
    reduced = equivalent_mass(body.geometry.base_radii, body.inertias) / pair.face_width
    load = 60.0 / body.geometry.pitch_radii[0] / pair.face_width
    errors = dynamic_factor.EffectiveErrors.of_grades(pair, (6, 6))
    speed = float(RELIEVED.scales.pinion_speed(0.3))
    expected = dynamic_factor.dynamic_factor(pair, mesh, reduced, speed, load, errors, 15e-6)
    assert method_b(RELIEVED, 0.3, (6, 6)).value == pytest.approx(expected.value, rel=1e-12)
