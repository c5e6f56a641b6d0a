"""Tip relief in a case: what the model has of it at the torque of the case and at others."""

from __future__ import annotations

import re
from math import pi
from pathlib import Path

import numpy as np
import pytest

from gearlash.case import Case, CaseError, load, loads
from gearlash.gears.stiffness_estimates import loaded_mesh
from gearlash.system import System, evaluate

FILE = Path(__file__).parents[1] / "cases" / "drawing.toml"
RELIEVED = {"pinion.tip_relief": "20 um", "gear.tip_relief": "15 um"}
CASE = load(FILE, RELIEVED)
EXACT = load(FILE, {**RELIEVED, "mesh.error": "0 um"})
"""Without deviations of the flanks."""
THETA = 2.0 * pi * np.arange(512) / 512


def static_error(system: System, case: Case) -> np.ndarray:
    """Harmonics 1 to 8 of F/K + E of a model under its own load, complex, m."""
    driven = system.forcing[-1]  # f_m − E″
    orders = np.arange(1, 9)
    error = (driven[1::2] - 1j * driven[2::2])[:8] / (orders * system.omega) ** 2
    bent = driven[0] / case.scales.c_t**2 / evaluate(system.clearances[0].stiffness_plus, THETA)
    return np.asarray(case.scales.length_m(1.0) * (np.fft.rfft(bent)[1:9] / 256 + error))


def contact_lines_error(case: Case) -> np.ndarray:
    """The same of the contact lines at the torque of a case."""
    mesh = loaded_mesh(case.content.completed.drawing)  # type: ignore[attr-defined]
    turn = np.exp(-2j * pi * np.outer(np.arange(1, 9), mesh.phases - 0.5 * mesh.total_contact_ratio))
    return np.asarray(turn @ mesh.deflection * 2.0 / len(mesh.phases))


def test_the_model_has_the_loaded_error_of_the_contact_lines():
    expected = contact_lines_error(EXACT)
    assert np.abs(expected[0]) > 3e-8
    assert static_error(EXACT.family()[0].system(), EXACT) == pytest.approx(expected, abs=1e-11)


def test_and_at_every_other_torque_the_one_of_that_torque():
    light = EXACT.with_overrides({"torque": "40 N m"})
    expected = contact_lines_error(light)
    assert np.abs(expected - contact_lines_error(EXACT)).max() > 3e-8
    at = float(EXACT.scales.load_from_torque(40.0))
    member = EXACT.family()[0].system({"load": at})
    assert static_error(member, EXACT) == pytest.approx(expected, abs=1e-11)
    ratios = [value_of(case, "derived.loaded_contact_ratio") for case in (light, EXACT)]
    assert ratios[0] < ratios[1] < value_of(EXACT, "derived.transverse_contact_ratio")


def value_of(case: Case, path: str) -> float:
    return next(float(v.value) for v in case.values() if v.path == path)


@pytest.mark.parametrize("torque", ["150 N m", "60 N m"])
@pytest.mark.parametrize("curve", [False, True])
def test_a_measured_loaded_error_is_counted_once(torque, curve):
    # found at some torque: there the model has what was measured, and elsewhere what the relief makes of it
    if curve:
        text = FILE.read_text(encoding="utf-8") + (
            f'\n[curves.error]\namplitudes = [4.0, 1.0]\nphases = [0.3, 1.0]\nunit = "um"\nharmonics = 8\n'
            f'state = "loaded"\ntorque = "{torque}"\n'
        )
        measured = loads(text, RELIEVED)
    else:
        stated = {
            "mesh.loaded_error": "4 um", "mesh.loaded_error_phase": "0.3 rad", "mesh.loaded_error_2": "1 um",
            "mesh.loaded_error_phase_2": "1 rad", "mesh.loaded_error_torque": torque,
        }  # fmt: skip
        measured = load(FILE, {**RELIEVED, **stated})
    at = float(measured.scales.load_from_torque(float(torque.split()[0])))
    found = static_error(measured.family()[0].system({"load": at}), measured)
    expected = 1e-6 * np.array([4.0 * np.exp(0.3j), np.exp(1j), 0, 0, 0, 0, 0, 0])
    assert found == pytest.approx(expected, abs=2e-10)


def test_what_is_counted_and_what_follows_the_torque_is_said():
    note = next(note for note in CASE.notes() if note.path == "pinion.tip_relief")
    assert "static error under load" in note.text
    assert "Left out" in note.text
    assert CASE.held("load").startswith("stiffness, contact ratio and the error of relief")
    assert "error of the flanks is the same at every torque" in CASE.held("load")
    assert "no tip relief is stated" in load(FILE).held("load")
    rippled = load(FILE, {**RELIEVED, "ripple": 0.1})
    assert any("is kept at every torque" in note.text for note in rippled.notes())


def test_more_relief_than_the_torque_bends_away_is_told():
    """By hand: F_bt over c′ b, with c′ as `check` has it. The torque at which both are alike has none."""
    values = {value.path: value.value for value in CASE.values()}
    force, helix = (float(values[f"derived.{leaf}"]) for leaf in ("normal_force", "base_helix_angle"))
    bent = force * np.cos(np.deg2rad(helix)) / (float(values["derived.single_stiffness"]) * 40.0)  # µm
    (text,) = [note.text for note in CASE.notes() if note.text.startswith("flanks lack")]
    times, fits = (
        float(re.findall(pattern, text)[0]) for pattern in (r"([\d.]+) times", r"about ([\d.]+) N")
    )
    assert times == pytest.approx(20.0 / bent, rel=0.03)
    assert fits == pytest.approx(150.0 * 20.0 / bent, rel=0.01)
    enough = load(FILE, {**RELIEVED, "torque": f"{fits} N m"})
    assert not [note for note in enough.notes() if note.text.startswith("flanks lack")]


def test_a_relief_can_be_varied_and_said_by_its_diameter():
    varied = CASE.varying("pinion.tip_relief")
    other = CASE.with_overrides({"pinion.tip_relief": "5 um"})
    one, two = varied.family()[0].system({"pinion.tip_relief": 5e-6}), other.family()[0].system()
    ratio = one.clearances[0].stiffness_plus[1:] / one.clearances[0].stiffness_plus[0]
    assert ratio == pytest.approx(two.clearances[0].stiffness_plus[1:], rel=1e-9)
    drawing = CASE.content.completed.drawing  # type: ignore[attr-defined]
    pinion = drawing.pair.pinion
    roll = pinion.roll_length(pinion.tip_form_diameter) - 2e-3
    diameter = 2e3 * float(np.hypot(roll, 0.5 * pinion.base_diameter))
    said = load(FILE, {**RELIEVED, "pinion.tip_relief_diameter": f"{diameter!r} mm"})
    length = load(FILE, {**RELIEVED, "pinion.tip_relief_length": "2 mm"})
    first, second = (each.family()[0].system().clearances[0].stiffness_plus for each in (said, length))
    assert first == pytest.approx(second, abs=1e-9)


def test_what_is_stated_stays_beside_a_relief():
    stated = load(FILE, {**RELIEVED, "mean_stiffness": "6e8 N/m"})
    assert stated.scales.mean_stiffness == pytest.approx(6e8)
    assert load(FILE, {"pinion.tip_relief": "0 um"}).family()[0].defaults == load(FILE).family()[0].defaults


@pytest.mark.parametrize(
    ("stated", "word"),
    [
        ({"pinion.tip_relief_length": "2 mm"}, "the amount that belongs to pinion.tip_relief_length"),
        ({"pinion.tip_relief": "9 um", "pinion.tip_relief_length": "40 mm"}, "mm of roll that touch"),
        ({"gear.tip_relief": "9 um", "gear.tip_relief_diameter": "300 mm"}, "a diameter between those that"),
        ({"gear.tip_relief": "9 um", "load": 0.1}, "a torque with its unit"),
        (
            {
                f"gear.tip_relief{what}": text
                for what, text in (("", "9 um"), ("_length", "2 mm"), ("_diameter", "170 mm"))
            },
            "one of two that name the same quantity",
        ),
    ],
)  # fmt: skip
def test_what_cannot_be_is_told(stated, word):
    with pytest.raises(CaseError, match=word):
        load(FILE, stated)


def test_a_relief_of_teeth_that_are_not_known_is_told():
    with pytest.raises(CaseError, match="teeth, module and helix angle beside it"):
        loads("""
            kind = "spur-1dof"
            pinion = {teeth = 20, base_radius = "40 mm", inertia = "0.01 kg m^2", tip_relief = "20 um"}
            gear = {teeth = 30, base_radius = "60 mm", inertia = "0.05 kg m^2"}
            mesh = {mean_stiffness = "3e8 N/m", backlash = "80 um", damping_ratio = 0.05, ripple = 0.1}
            operation = {pinion_speed = "1000 rpm", torque = "100 N m"}
        """)


def test_a_relief_is_not_at_fault_where_the_module_is():
    """A module without a unit is one problem, and not two; where it is not stated at all, both are told."""
    text = FILE.read_text()
    module = next(line for line in text.splitlines() if line.startswith("normal_module"))
    text = text.replace("[gear]", '[gear]\ntip_relief = "10 um"')
    for written, others in (('normal_module = "3"', []), ("", ["gear.tip_relief"])):
        with pytest.raises(CaseError) as refused:
            loads(text.replace(module, written))
        told = [problem.path for problem in refused.value.problems]
        assert "mesh.normal_module" in told
        assert [path for path in told if path != "mesh.normal_module"] == others
