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
from gearlash.case.rating import materials_of, method_b, pair_of, relief_of
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
    errors = dynamic_factor.EffectiveErrors.of_grades(pair, (5, 5))
    speed = float(RELIEVED.scales.pinion_speed(0.3))
    expected = dynamic_factor.dynamic_factor(pair, mesh, reduced, speed, load, errors, 15e-6)
    assert method_b(RELIEVED, 0.3, (5, 5)).value == pytest.approx(expected.value, rel=1e-12)


def test_relief_counts_up_to_grade_5():
    # ISO 6336-1, footnote of B_k: 1 for grades 6 to 12
    assert relief_of(RELIEVED, (5, 5)) == pytest.approx(15e-6)
    assert relief_of(RELIEVED, (6, 6)) == relief_of(RELIEVED, (5, 6)) == relief_of(PLAIN, (12, 1)) == 0.0


def test_flanks_without_relief_have_what_running_in_takes():
    # C_ay = (1500/97 - 18.45)² / 18 + 1.5 µm: KISSsoft prints 2.0 µm
    assert relief_of(PLAIN, (5, 5)) == pytest.approx(2.0e-6, abs=0.01e-6)


def test_relief_is_that_of_the_smaller_end_with_the_root_of_the_other_gear():
    one = loads(TEXT, {"pinion.tip_relief": "15 um", "gear.root_relief": "5 um"})
    assert relief_of(one, (5, 5)) == relief_of(PLAIN, (5, 5))  # the other end has run in
    both_ends = {"pinion.tip_relief": "15 um", "gear.root_relief": "5 um", "gear.tip_relief": "18 um"}
    assert relief_of(loads(TEXT, both_ends), (5, 5)) == pytest.approx(18e-6)


def test_rims_and_low_loads_count():
    thin = loads(TEXT, {"gear.rim_diameter": "100 mm", "gear.web_width": "5 mm"})
    solid, softer = (method_b(case, 0.3, (6, 6)) for case in (PLAIN, thin))
    assert thin.numbers.body.rims[1].web_width == pytest.approx(5e-3)
    # at one ω both have one speed over their own ω_n: N differs by the rim of the mass alone
    assert softer.resonance_ratio != solid.resonance_ratio
    light = loads(TEXT.replace("60 N m", "1 N m"))
    pair, load = pair_of(light), 1.0 / PLAIN.numbers.body.geometry.pitch_radii[0] / 20e-3
    mesh = mesh_stiffness.method_b(pair, materials_of(light), light.numbers.body.rims, load)
    assert mesh.single < 0.6 * mesh_stiffness.method_b(pair).single
    body = light.numbers.body
    mass = equivalent_mass(body.geometry.base_radii, body.inertias) / pair.face_width
    expected = 25 * float(light.scales.pinion_speed(0.3)) / (mesh.mean / mass) ** 0.5
    assert method_b(light, 0.3, (6, 6)).resonance_ratio == pytest.approx(expected, rel=1e-12)
