"""Cases: the bundled ones, overrides, the two-way map, scales, values and what they rest on, round trips."""

import json
import subprocess
import sys
from math import pi

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gearlash.case import Case, CaseError, Scales, bundled, load, loads
from gearlash.case.kinds.gears.units import to_dimensionless, to_physical
from gearlash.case.kinds.helical.places import PLACES
from gearlash.gears import helical
from gearlash.system import GearlashError, UnknownNameError

PARAMETRIC = """
kind = "spur-1dof"
[dimensionless]
omega = 0.9
D = 1
load = 0.1
mesh_damping = 0.05
ripple = 0.2
"""


@pytest.fixture(scope="module")
def article():
    return load("article")


def test_the_article_case_is_the_design(article):
    family, scales = article.family()
    assert family.states == helical.STATES
    p = family.defaults
    assert (p["D"], p["load"], p["mesh_damping"], p["bearing_damping"]) == (
        1.0,
        0.09196833369833139,
        0.07,
        0.0378,
    )
    assert (p["ripple"], p["ripple_2"], p["ripple_phase_2"]) == (0.0, 0.23289493255552876, 0.0)
    assert p["error"] / p["load"] == pytest.approx(2.6685489735383907, rel=1e-14)
    assert p["error_phase"] == 0.7465
    assert round(scales.equivalent_mass, 4) == 2.5507
    assert round(scales.omega_n) == 11201
    assert scales.length == 50e-6
    assert round(p["omega"], 3) == 1.047
    assert scales.pinion_rpm(p["omega"]) == pytest.approx(4000, rel=1e-14)
    assert round(article.resolve("pinion_speed", "3600 rpm")[1], 3) == 0.942
    assert scales.mesh_hz(article.resolve("pinion_speed", "3600 rpm")[1]) == pytest.approx(1680, rel=1e-14)


@pytest.mark.parametrize(
    ("projection", "listed"),
    [
        ("pitch", (0.269, 0.291, 0.717, 0.960, 1.336)),
        ("base", (0.269, 0.291, 0.717, 0.960, 1.336)),
        ("article-literal", (0.269, 0.290, 0.686, 0.960, 1.315)),
    ],
)
def test_natural_frequencies_of_each_projection(article, projection, listed):
    case = article.with_overrides({"projection": projection})
    shown = {v.path: v.value for v in case.values()}
    over = [2 * pi * shown[f"derived.natural_frequency_{i}_hz"] / 11201 for i in range(1, 6)]
    assert over == pytest.approx(listed, abs=6e-4)


def test_everything_the_article_states_is_given_and_the_rest_has_a_reason(article):
    stated = {
        "pinion.teeth", "gear.teeth", "pinion.mass", "gear.mass", "mesh.normal_module", "mesh.pressure_angle",
        "mesh.helix_angle", "mesh.mean_stiffness", "mesh.damping_ratio", "pinion.bearing_stiffness_y",
        "pinion.bearing_stiffness_z", "gear.bearing_stiffness_y", "gear.bearing_stiffness_z",
        "model.contact", "model.y_axis",
    }  # fmt: skip
    given_values = {v.path for v in article.values() if v.provenance == "given"}
    assert given_values == stated
    for v in article.values():
        assert v.provenance == "given" or v.reason, v.path


@pytest.mark.parametrize("name", bundled())
def test_bundled_cases_make_systems_and_name_their_source(name):
    case = load(name)
    family, _ = case.family()
    assert family.system().size == len(family.states) == len(family.start())
    assert case.source["title"]
    for entry in case.entries.values():
        assert entry.provenance == "given" or entry.reason, entry.path


def test_the_published_spur_pair_has_its_published_mass_and_stiffness():
    case = load("wind-turbine")
    family, scales = case.family()
    assert scales.equivalent_mass == pytest.approx(0.23, rel=1e-12)
    assert scales.length == 1e-4
    stiffness = family.system().clearances[0].stiffness_plus
    assert stiffness == pytest.approx([1, -0.2, 0, -0.1, 0, -0.05, 0], abs=1e-15)
    # F_te n² ω² cos(nθ) of the authors' code, ω = 0.5
    forcing = family.system().forcing[1]
    assert forcing == pytest.approx([0.1, 0.01 * 0.25, 0, 0.004 * 1.0, 0, 0.002 * 2.25, 0], abs=1e-15)


def test_the_classical_spur_pair_is_driven_by_a_sine():
    system = load("kahraman-singh").family()[0].system()
    assert system.forcing[1] == pytest.approx([0.1, 0.0, 0.05 * 0.25], abs=1e-17)
    assert not load("kahraman-singh").scales.physical


def test_no_override_moves_the_unit_of_length(article):
    for overrides in ({"backlash": "120 um"}, {"D": 1.2}, {"mesh.normal_module": "5 mm"}):
        case = article.with_overrides(overrides)
        assert case.scales.length == 50e-6
    assert article.with_overrides({"backlash": "120um"}).family()[0].defaults["D"] == pytest.approx(1.2)
    again = article.with_overrides({"backlash": "120 um"}).with_overrides({"backlash": "80 um"})
    assert again.family()[0].defaults["D"] == pytest.approx(0.8)
    assert load("article", {"D": 0.8}).scales.backlash_um(0.8) == pytest.approx(80)


def test_a_reference_length_of_the_file_wins_over_half_the_backlash():
    text = (
        PARAMETRIC.replace("D = 1\n", "")
        + """
        [model]
        reference_length = "20 um"
        [pinion]
        teeth = 20
        [mesh]
        mean_stiffness = "1e8 N/m"
        equivalent_mass = "1 kg"
        backlash = "60 um"
        """
    )
    case = loads(text)
    assert case.scales.length == 20e-6
    assert case.family()[0].defaults["D"] == pytest.approx(1.5)


def test_an_unequal_back_side_shares_the_backlash_and_sweeps(article):
    case = article.with_overrides({"back_gap": 1.5, "back_stiffness": 0.5})
    family, scales = case.family()
    assert family.defaults["D"] == pytest.approx(100e-6 / 2.5 / 50e-6)
    assert scales.backlash_um(family.defaults["D"]) == pytest.approx(100)
    for d in (0.2, 1.7):
        clearance = family.system({"D": d}).clearances[0]
        assert (clearance.gap_plus, clearance.gap_minus) == (d, 1.5 * d)
        assert clearance.stiffness_minus == pytest.approx(0.5 * clearance.stiffness_plus)


def test_a_negative_torque_gives_the_mirrored_cold_start(article):
    torque = float(article.scales.torque(0.09))
    forward = article.with_overrides({"torque": f"{torque!r} N·m"}).family()[0]
    backward = article.with_overrides({"torque": f"{-torque!r} N·m"}).family()[0]
    assert forward.defaults["load"] == pytest.approx(0.09, rel=1e-14)
    assert backward.start() == pytest.approx(-forward.start(), rel=1e-15)
    assert forward.start()[8] == pytest.approx(1 + 0.09 / forward.defaults["rotation_factor"], rel=1e-14)


def test_an_override_replaces_the_quantity_however_it_was_named(article):
    case = article.with_overrides({"mesh_frequency": "1680 Hz", "torque": "200 Nm", "mesh.error": "10 um"})
    p = case.family()[0].defaults
    assert case.scales.pinion_rpm(p["omega"]) == pytest.approx(3600, rel=1e-14)
    assert case.scales.torque(p["load"]) == pytest.approx(200, rel=1e-14)
    assert p["error"] == pytest.approx(0.2, rel=1e-14)
    one = article.with_overrides({"bearing_damping_yg": 0.05}).family()[0]
    assert [one.defaults[f"bearing_damping_{b}"] for b in helical.BEARINGS] == [0.0378, 0.0378, 0.05, 0.0378]
    all_four = article.with_overrides({"bearing_damping": "4 %"}).family()[0].defaults
    assert all_four["bearing_damping"] == all_four["bearing_damping_zp"] == 0.04


def test_the_rotation_factor_may_be_replaced_without_moving_the_scales(article):
    case = article.with_overrides({"rotation_factor": 0.95})
    family, scales = case.family()
    assert scales == article.scales
    assert family.start()[8] == 1 + article.family()[0].defaults["load"] / 0.95


@pytest.mark.parametrize(
    ("name", "value", "short", "number"),
    [
        ("omega", 0.9, "omega", 0.9),
        ("omega", "0.9", "omega", 0.9),
        ("dimensionless.omega", 0.9, "omega", 0.9),
        ("mesh_frequency", "1680 Hz", "omega", 0.9424154746983821),
        ("operation.pinion_speed", "3600rpm", "omega", 0.9424154746983821),
        ("backlash", "80 µm", "D", 0.8),
        ("mesh.error_phase", "90 deg", "error_phase", pi / 2),
        ("error_phase", 1.5, "error_phase", 1.5),
        ("mesh.error", "5 um", "error", 0.1),
        ("ripple", "25 %", "ripple", 0.25),
        ("bearing_damping", 0.05, "bearing_damping", 0.05),
        ("pinion.bearing_damping_y", 0.05, "bearing_damping_yp", 0.05),
    ],
)
def test_parameters_resolve_from_every_name(article, name, value, short, number):
    found = article.resolve(name, value)
    assert found[0] == short
    assert found[1] == pytest.approx(number, rel=1e-14)


def test_what_is_no_parameter_does_not_resolve(article):
    with pytest.raises(UnknownNameError, match="omega"):
        article.resolve("mesh.mean_stiffness", "3e8 N/m")
    with pytest.raises(UnknownNameError):
        article.resolve("error_2", 0.1)  # the case has one harmonic
    with pytest.raises(UnknownNameError):
        article.resolve("projection", "base")
    with pytest.raises(CaseError, match="did you mean 'backlash'"):
        article.resolve("baklash", "1 um")
    with pytest.raises(CaseError, match="with its unit"):
        article.resolve("backlash", 100)


def test_parameters_are_shown_physically(article):
    shown = {path: (float(value), unit) for path, value, unit in article.physical("omega", 1.0)}
    assert shown["operation.pinion_speed"][1] == "rpm"
    assert shown["operation.pinion_speed"][0] == pytest.approx(
        float(article.scales.pinion_rpm(1.0)), rel=1e-14
    )
    assert shown["operation.mesh_frequency"][0] == pytest.approx(11200.74 / 2 / pi, rel=1e-6)
    ((path, values, unit),) = article.physical("D", np.array([0.5, 1.0]))
    assert (path, unit) == ("mesh.backlash", "um")
    assert values == pytest.approx([50, 100])
    assert article.physical("error_phase", pi)[0][1:] == (pytest.approx(180), "deg")
    assert article.physical("ripple", 0.3) == []
    assert load("kahraman-singh").physical("omega", 1.0) == []


numbers_ = st.floats(1e-6, 1e6) | st.floats(-1e6, -1e-6)


@given(numbers_)
def test_physical_to_dimensionless_to_physical_is_exact_to_1e_14(value):
    scales = load("article").scales
    pairs = [
        (scales.pinion_speed, scales.omega_from_pinion_speed),
        (scales.pinion_rpm, scales.omega_from_rpm),
        (scales.mesh_hz, scales.omega_from_hz),
        (scales.time_s, scales.tau_from_s),
        (scales.length_m, scales.displacement_from_m),
        (scales.length_um, scales.displacement_from_um),
        (scales.backlash_m, scales.half_backlash_from_m),
        (scales.backlash_um, scales.half_backlash_from_um),
        (scales.force_N, scales.contact_force_from_N),
        (scales.torque, scales.load_from_torque),
    ]
    for forward, back in pairs:
        assert forward(back(value)) == pytest.approx(value, rel=1e-14)
        assert back(forward(value)) == pytest.approx(value, rel=1e-14)
        assert forward(back(np.array([value, 1.0]))).shape == (2,)
    for paths in PLACES.two_way.values():
        for path in paths:
            there = to_dimensionless(scales, path, value)
            assert to_physical(scales, path, there) == pytest.approx(value, rel=1e-14)


@given(st.floats(1.0, 1e5), st.floats(1.0, 5e3), st.floats(0.1, 1e4))
def test_a_stated_value_comes_back_as_it_was_typed(rpm, microns, torque):
    case = load(
        "article", {"pinion_speed": f"{rpm!r} rpm", "backlash": f"{microns!r} um", "torque": f"{torque!r} Nm"}
    )
    p, scales = case.family()[0].defaults, case.scales
    assert scales.pinion_rpm(p["omega"]) == pytest.approx(rpm, rel=1e-14)
    assert scales.backlash_um(p["D"]) == pytest.approx(microns, rel=1e-14)
    assert scales.torque(p["load"]) == pytest.approx(torque, rel=1e-14)


def test_forces_and_loads_are_those_of_the_equations(article):
    scales = article.scales
    assert scales.force_N(1.0) == pytest.approx(3.2e8 * 50e-6)
    force = float(scales.torque(0.09)) / scales.radii[0]
    assert scales.c_t * force / (3.2e8 * 50e-6) == pytest.approx(0.09, rel=1e-14)
    assert scales.velocity(2.0) == pytest.approx(2.0 * 50e-6 * scales.omega_n)
    assert scales.acceleration(2.0) == pytest.approx(2.0 * 50e-6 * scales.omega_n**2)


def test_a_dimensionless_case_refuses_physical_questions():
    scales = loads(PARAMETRIC).scales
    assert not scales.physical
    for question in (scales.pinion_rpm, scales.mesh_hz, scales.length_um, scales.force_N, scales.torque):
        with pytest.raises(GearlashError, match="dimensionless numbers only"):
            question(1.0)
    lumped = Scales(omega_n=1.0, mean_stiffness=1.0, equivalent_mass=1.0, length=1.0)
    with pytest.raises(GearlashError, match="teeth"):
        lumped.pinion_rpm(1.0)
    with pytest.raises(GearlashError, match="radius"):
        lumped.torque(1.0)


def test_ratios_may_stand_in_the_mesh_table_of_a_dimensionless_case():
    text = PARAMETRIC.replace(
        "mesh_damping = 0.05\nripple = 0.2", "[mesh]\ndamping_ratio = 0.05\nripple = 0.2"
    )
    assert loads(text).family()[0].defaults == loads(PARAMETRIC).family()[0].defaults


def test_a_helical_case_in_numbers_only_is_the_article_pair(article):
    pair, p = article.numbers.pair, article.family()[0].defaults
    lines = [
        f"y_factor = {pair.y_factor!r}",
        f"z_factor = {pair.z_factor!r}",
        *(f"mass_ratio_{g} = {r!r}" for g, r in zip("pg", pair.mass_ratios, strict=True)),
        *(
            f"bearing_frequency_{b} = {k!r}"
            for b, k in zip(helical.BEARINGS, pair.bearing_frequencies, strict=True)
        ),
        *(f"{name} = {value!r}" for name, value in p.items() if not name.startswith("bearing_damping_")),
    ]
    numbers = loads('kind = "helical-pair"\n[dimensionless]\n' + "\n".join(lines))
    assert not numbers.scales.physical
    one, other = article.family()[0].system(), numbers.family()[0].system()
    assert np.array_equal(one.matrix, other.matrix)
    assert np.array_equal(one.forcing, other.forcing)
    assert np.array_equal(one.clearances[0].g, other.clearances[0].g)


def _text(value, unit):
    return f"{value!r} {unit}"


positive = st.floats(1e-15, 1e6)


@settings(max_examples=60)
@given(
    stiffness=positive,
    masses=st.tuples(positive, positive),
    bearings=st.tuples(positive, positive, positive, positive),
    angles=st.tuples(st.floats(0.1, 89), st.floats(-89, 89)),
    backlash=st.floats(2e-15, 0.02),
    projection=st.sampled_from(["pitch", "base", "article-literal"]),
    torque=st.floats(-1e9, 1e9),
)
def test_any_pair_in_range_makes_a_system_values_and_json(
    article, stiffness, masses, bearings, angles, backlash, projection, torque
):
    overrides = {
        "mean_stiffness": _text(stiffness, "N/m"),
        "pinion.mass": _text(masses[0], "kg"),
        "gear.mass": _text(masses[1], "kg"),
        "pinion.bearing_stiffness_y": _text(bearings[0], "N/m"),
        "pinion.bearing_stiffness_z": _text(bearings[1], "N/m"),
        "gear.bearing_stiffness_y": _text(bearings[2], "N/m"),
        "gear.bearing_stiffness_z": _text(bearings[3], "N/m"),
        "pressure_angle": _text(angles[0], "deg"),
        "helix_angle": _text(angles[1], "deg"),
        "backlash": _text(backlash, "m"),
        "projection": projection,
        "torque": _text(torque, "N m"),
    }
    case = article.with_overrides(overrides)
    assert case.family()[0].system().size == 10
    assert all(np.isfinite(v.value) for v in case.values() if isinstance(v.value, float))
    assert Case.from_json(case.to_json()) == case
    assert all(note.path == "mesh.mean_stiffness" for note in case.notes())


def test_derived_numbers_say_which_assumption_they_rest_on(article):
    shown = {v.path: v for v in article.values()}
    assert shown["operation.torque"].rests_on == ("model.reference_length",)
    assert shown["operation.torque"].value == pytest.approx(float(article.scales.torque(0.09196833369833139)))
    assert shown["mesh.error"].rests_on == ("model.reference_length",)
    assert shown["mesh.error"].value == pytest.approx(0.24542200248871843 * 50)
    assert shown["derived.omega_n"].rests_on == ()  # the solid disc is inferred here, not assumed
    assert shown["dimensionless.D"].rests_on == ()  # D = 1 whatever the assumed backlash
    assert shown["mesh.backlash"].uncertain
    assert shown["operation.torque"].uncertain
    assert not shown["derived.equivalent_mass"].uncertain
    moved = {v.path: v for v in article.with_overrides({"backlash": "80 um"}).values()}
    assert moved["dimensionless.D"].rests_on == ("model.reference_length",)


def test_an_unstated_body_is_an_assumption_that_speeds_rest_on():
    text = """
        kind = "spur-1dof"
        pinion.teeth = 20
        gear.teeth = 40
        pinion.mass = "1 kg"
        gear.mass = "4 kg"
        mesh = {module = "2 mm", pressure_angle = "20 deg", mean_stiffness = "1e8 N/m", backlash = "50 um"}
        dimensionless = {omega = 0.5, load = 0.1, mesh_damping = 0.05}"""
    shown = {v.path: v for v in loads(text).values()}
    assert shown["model.body"].provenance == "assumed"
    assert shown["operation.pinion_speed"].rests_on == ("model.body",)
    # J = m r²/2 with the pitch radius, turned by the base radius: m_e = m_p m_g / (2 (m_p + m_g) cos² α)
    assert shown["derived.equivalent_mass"].value == pytest.approx(0.4 / np.cos(np.radians(20)) ** 2)
    assert shown["dimensionless.ripple"].provenance == "assumed"
    assert shown["dimensionless.ripple"].value == 0.0
    stated = text + '\npinion.inertia = "2 kg cm^2"\ngear.inertia = "32 kg cm^2"'
    shown = {v.path: v for v in loads(stated).values()}
    assert "model.body" not in shown
    assert shown["operation.pinion_speed"].rests_on == ()


def test_values_list_every_derived_number_with_its_unit(article):
    shown = {v.path: (v.value, v.unit) for v in article.values()}
    assert shown["derived.radius_pinion"] == (pytest.approx(58.882, abs=1e-3), "mm")
    assert shown["derived.inertia_pinion"][1] == "kg*m^2"
    assert shown["derived.c_z"][0] == pytest.approx(0.29038, abs=1e-5)
    assert shown["derived.total_contact_ratio"][0] == pytest.approx(3.2012, abs=1e-4)
    assert shown["derived.critical_speed_3"] == (pytest.approx(2737.84, abs=0.01), "rpm")
    assert shown["derived.transmitted_force"] == (pytest.approx(96.950 / 0.0588819, rel=1e-4), "N")
    assert shown["operation.pinion_speed"] == (4000.0, "rpm")
    assert len(shown) == len(article.values())


def test_the_stiffness_conflict_is_noted_and_not_used(article):
    (note,) = article.notes()
    assert note.path == "mesh.mean_stiffness"
    assert "ISO 6336-1" in note.text
    assert "4.3 times stiffer" in note.text
    assert "65 mm" in note.text
    agreed = article.with_overrides({"mean_stiffness": "1.4e9 N/m"})
    assert agreed.notes() == []
    assert "softer" in article.with_overrides({"mean_stiffness": "5e9 N/m"}).notes()[0].text


@pytest.mark.parametrize("name", bundled())
def test_json_round_trip_gives_an_identical_family(name):
    case = load(name, {"omega": 0.73})
    again = Case.from_json(case.to_json())
    assert again == case
    assert again.hash == case.hash
    one, other = case.family()[0], again.family()[0]
    assert one.defaults == other.defaults
    assert np.array_equal(one.system().matrix, other.system().matrix)
    assert np.array_equal(one.system().forcing, other.system().forcing)


def test_foreign_json_is_refused():
    for text in ("", "{}", "[]", '{"format": 99}', json.dumps({"format": 1, "name": "x"})):
        with pytest.raises(GearlashError):
            Case.from_json(text)


def test_the_hash_sees_values_only(article):
    text = PARAMETRIC
    same = 'name = "other"\n' + text.replace("omega = 0.9", 'omega = { value = 0.90, reason = "why not" }')
    assert loads(same).hash == loads(text).hash
    assert loads(text.replace("0.9", "0.91")).hash != loads(text).hash
    assert len({load(name).hash for name in bundled()}) == len(bundled())
    assert article.with_overrides({"projection": "base"}).hash != article.hash


def test_provenance_and_reason_are_kept():
    text = PARAMETRIC.replace(
        "ripple = 0.2", 'ripple = { value = 0.2, provenance = "calibrated", reason = "fit" }'
    )
    (ripple,) = [v for v in loads(text).values() if v.short == "ripple"]
    assert (ripple.provenance, ripple.reason, ripple.text) == ("calibrated", "fit", "0.2")


def test_pint_is_loaded_for_unusual_units_only_and_pydantic_for_files_only():
    code = """
import sys
from gearlash.case import Case, load, loads
text = load("article", {"torque": "90 N m"}).to_json()
assert "pint" not in sys.modules
load("article", {"backlash": "2e-6 fathom"})
assert "pint" in sys.modules
"""
    subprocess.run([sys.executable, "-c", code], check=True)
    worker = """
import sys
from gearlash.case import Case
Case.from_json(sys.stdin.read()).family()
assert "pint" not in sys.modules
assert "pydantic" not in sys.modules
"""
    subprocess.run([sys.executable, "-c", worker], check=True, input=load("article").to_json(), text=True)
