"""Which cases real teeth can stand for, what these take from them, and what is refused at once."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import gearlash as gl
from gearlash.case import loads
from gearlash.gears import backlash
from gearlash.multibody import Modes
from gearlash.studies.verification import NotVerifiableError, Setting, inputs_of
from gearlash.studies.verification.lumped import LumpedInputs, lumped_family
from gearlash.studies.verification.mesh import matched_mesh, mesh_of
from gearlash.studies.verification.point import machine_of
from multibody.standin import standins

CASES = Path(__file__).parents[1] / "cases"
SPUR = (CASES / "spurs.toml").read_text(encoding="utf-8")


def _refused(case: gl.Case, *told: str) -> None:
    with pytest.raises(NotVerifiableError) as refused:
        inputs_of(case, (1.0,))
    text = str(refused.value)
    assert all(each in text for each in told), text


@pytest.mark.parametrize(
    ("path", "value", "told"),
    [
        ("mesh.back_stiffness", 0.5, "mesh.back_stiffness = 0.5: expected 1, or nothing"),
        ("back_stiffness", 0.0, "back_stiffness = 0"),
        ("mesh.back_gap", 2.0, "mesh.back_gap = 2.0: expected 1, or nothing"),
        (
            "operation.torque",
            "-50 N m",
            "operation.torque = -50 N m: expected a torque above 0: the pinion drives",
        ),
        (
            "operation.torque",
            "0 N m",
            "expected a torque above 0: the stiffness of real teeth is that under a load",
        ),
        ("mesh.backlash", "0 um", "mesh.backlash = 0 um: expected a backlash above 0"),
        ("pinion.runout", "20 um", "pinion.runout = 20 um: expected 0, or nothing"),
        ("rotation_factor", 0.5, "rotation_factor = 0.5: expected nothing"),
    ],
)
@pytest.mark.parametrize("name", ["article", "drive.toml"])
def test_what_real_teeth_cannot_have_is_refused(name: str, path: str, value: object, told: str):
    case = gl.load_case(CASES / name if name.endswith("toml") else name, {path: value})
    _refused(case, told)


def test_what_is_stated_and_says_nothing_is_taken():
    plain = inputs_of(gl.load_case("article"), (1.0,))
    same = {"mesh.back_stiffness": 1.0, "mesh.back_gap": 1.0, "pinion.runout": "0 um"}
    assert inputs_of(gl.load_case("article", same), (1.0,)) == plain


def test_bearings_are_as_far_apart_as_stated_or_as_the_size_has_it():
    """Tilt stiffness k_y span²/4; a stated span makes no drawing of the case, and all else stays."""
    drive = CASES / "drive.toml"
    plain = inputs_of(gl.load_case(drive), (1.0,))
    assert all(0.04 + 0.03 < span < 0.10 for span in plain.bearing_spans)
    stated = inputs_of(gl.load_case(drive, {"pinion.bearing_span": "200 mm"}), (1.0,))
    assert stated == replace(plain, bearing_spans=(0.2, plain.bearing_spans[1]))
    tilt = [
        machine_of(one, Setting(tilt=tilt), one.torque, 100.0, 1e-3, Modes()).bearings[0].stiffness[3]
        for one, tilt in ((plain, 1.0), (stated, 1.0), (stated, 4.0))
    ]
    assert plain.bearing_y is not None
    assert tilt[0] == pytest.approx(0.25 * plain.bearing_y[0] * plain.bearing_spans[0] ** 2)
    assert tilt[1:] == pytest.approx([0.01 * plain.bearing_y[0], 0.04 * plain.bearing_y[0]])


@pytest.mark.parametrize(
    ("name", "told"),
    [
        (
            "kahraman-singh",
            ("pinion.teeth is missing", "mesh.module is missing", "operation.torque is missing"),
        ),
        ("blankenship-kahraman", ("gear.face_width is missing", "mesh.mean_stiffness is missing")),
        ("wind-turbine", ("pinion.face_width is missing", "mesh.module is missing")),
        ("shaw-holmes", ("kind = piecewise-linear: expected helical-pair or spur-1dof",)),
        ("two-stage", ("kind = piecewise-linear",)),
        ("geared-rotor", ("kind = piecewise-linear",)),
    ],
)
def test_cases_without_teeth_are_refused_with_every_field(name: str, told: tuple[str, ...]):
    _refused(gl.load_case(name), *told)


@pytest.mark.parametrize("period", ["pinion turn", "gear turn"])
@pytest.mark.parametrize("name", ["stiffness", "error"])
def test_curves_that_repeat_with_a_shaft_are_refused(name: str, period: str):
    _refused(_with_curve(name, period), f"curves.{name}.over = {period!r}: expected 'mesh cycle'")


def _with_curve(name: str, period: str) -> gl.Case:
    """Two harmonics, 5 and 2 µm or 5 and 2 % of the mean, at phases 0.3 and -1.0."""
    angle = np.linspace(0.0, 1.0, 64, endpoint=False)
    values = 5.0 * np.cos(2.0 * np.pi * angle + 0.3) + 2.0 * np.cos(4.0 * np.pi * angle - 1.0)
    shown, unit = (values, "um") if name == "error" else (3e8 * (1.0 + values / 100.0), "N/m")
    points = [[float(u), float(v)] for u, v in zip(angle, shown, strict=True)]
    tail = f'unit = "{unit}"\nangle = "{"cycle" if period == "mesh cycle" else period}"'
    tail += '\nstate = "unloaded"' if name == "error" else ""
    return loads(f'{SPUR}\n[curves.{name}]\nover = "{period}"\npoints = {points}\n{tail}\n')


def test_harmonics_of_an_error_are_those_of_names_and_curve():
    inputs = inputs_of(_with_curve("error", "mesh cycle"), (1.0,))
    for (amplitude, phase), (size, angle) in zip(inputs.errors, [(5e-6, 0.3), (2e-6, -1.0)], strict=False):
        assert (amplitude, phase) == pytest.approx((size, angle), rel=4e-3)  # straight between the points
    theta = np.linspace(0.0, 2.0 * np.pi, 100_001)
    wave = 5e-6 * np.cos(theta + 0.3) + 2e-6 * np.cos(2.0 * theta - 1.0)
    assert inputs.error == pytest.approx(0.5 * np.ptp(wave), rel=4e-3)


def test_the_larger_order_of_the_stiffness_is_that_of_names_and_curve():
    """The error keeps its phase against it. A ripple below 0 is one half a turn away."""
    inputs = inputs_of(_with_curve("stiffness", "mesh cycle"), (1.0,))
    assert (inputs.ripple_order, inputs.ripple_phase) == (1, pytest.approx(0.3, rel=1e-3))
    assert inputs.mean_stiffness == pytest.approx(3e8)
    below = inputs_of(gl.load_case("article", {"ripple_2": -0.2}), (1.0,))
    assert (below.ripple_order, abs(below.ripple_phase)) == (2, pytest.approx(np.pi))


def test_the_lumped_model_gets_no_curve_beside_what_it_is_given():
    """Nor run-out, nor the error of a relief: η and E are the given harmonics alone."""
    given = LumpedInputs(2e8, (0.1, 0.05), (0.4, 0.0), 60.0, (3e-6 + 0j, 1e-6j))
    relieved = {"pinion.tip_relief": "20 um", "pinion.tip_relief_length": "3 mm", "gear.crowning": "8 um"}
    cases = [
        _with_curve("stiffness", "mesh cycle"),
        _with_curve("error", "mesh cycle"),
        gl.load_case(CASES / "drawing.toml", relieved),
    ]
    for case in cases:
        family, scales = lumped_family(case, given, gl.ContactRule.NO_TENSION), case.scales
        assert scales.length is not None
        system = family.system({"omega": 1.0})
        eta = [1.0, 0.1 * np.cos(0.4), -0.1 * np.sin(0.4), 0.05, 0.0]
        assert system.cycles == 1
        assert system.clearances[0].stiffness_plus == pytest.approx(np.array(eta))
        rate = np.array([3e-6, 0.0, 0.0, -4e-6]) / scales.length  # −E″ of both orders
        assert system.forcing[-1][1:] == pytest.approx(rate)
        assert scales.radii is not None
        force = 60.0 / scales.radii[0] * scales.c_t / (2e8 * scales.length)  # c_t W/(k D_c)
        assert system.forcing[-1][0] == pytest.approx(force)


def test_bearings_in_series_and_by_number_carry_real_teeth():
    shafts = {"pinion.shaft_stiffness_y": "4e8 N/m", "pinion.housing_stiffness_y": "8e8 N/m"}
    case = gl.load_case("article", shafts)
    inputs = inputs_of(case, (1.0,))
    assert inputs.bearing_y == pytest.approx((1.0 / (1 / 8e8 + 1 / 4e8 + 1 / 8e8), 4e8))
    numbered = gl.load_case("article", {"bearing_frequency_yp": 0.5})
    omega_n = numbered.scales.omega_n
    assert omega_n is not None
    found = inputs_of(numbered, (1.0,)).bearing_y
    assert found is not None
    assert found[0] == pytest.approx((0.5 * omega_n) ** 2 * 5.98)


def test_bearings_with_a_damping_of_each_direction():
    ratios = {f"{gear}.bearing_damping_{axis}": 0.01 * i for i, (gear, axis) in enumerate(EACH, start=1)}
    inputs = inputs_of(gl.load_case("article", ratios), (1.0,))
    assert inputs.bearing_damping == ((0.01, 0.02), (0.03, 0.04))
    machine = machine_of(inputs, Setting(), 1.0, 1.0, 1.0, Modes())
    for i, bearings in enumerate(machine.bearings):
        mass = (inputs.masses[i],) * 3
        ratio = np.array(bearings.damping[:3]) / (2.0 * np.sqrt(np.array(bearings.stiffness[:3]) * mass))
        y, z = inputs.bearing_damping[i]
        assert ratio == pytest.approx([y, y, z])


EACH = [("pinion", "y"), ("pinion", "z"), ("gear", "y"), ("gear", "z")]


def test_a_pair_that_only_rotates_needs_no_mass():
    bodies = {"pinion.inertia": "9e-5 kg m^2", "gear.inertia": "2.5e-3 kg m^2"}
    stated = {"mesh.mean_stiffness": "4e8 N/m", "mesh.damping_ratio": 0.05}
    inputs = inputs_of(loads(SPUR, {**bodies, **stated}), (1.0,))
    assert inputs.axial_inertias == (9e-5, 2.5e-3)
    assert inputs.bearing_y is None
    assert min(inputs.masses) > 0.0


def test_temperature_and_centre_distance_at_work_are_those_of_the_teeth():
    work = {"mesh.temperature": "80 degC", "mesh.housing_temperature": "60 degC"}
    work |= {"mesh.housing_material": "aluminium"}
    case = loads(SPUR, work)
    inputs = inputs_of(case, (1.0,))
    at_work = {value.path: value.value for value in case.values()}["mesh.backlash_at_work"]
    assert inputs.backlash * 1e6 == pytest.approx(at_work, rel=1e-6)
    assert abs(inputs.backlash - 80e-6) > 1e-6
    assert backlash.of_pair(inputs.pair).normal == pytest.approx(inputs.backlash, rel=1e-9)


def test_teeth_that_do_not_hand_over_the_contact_are_refused_before_finite_elements():
    """Tips below the involute of the mate; a pair whose helix alone keeps teeth in contact."""
    _refused(loads(SPUR, {"pinion.teeth": 12}), "gear.tip_diameter = 118 mm: expected up to")
    short = {"pinion.tip_diameter": "80 mm", "gear.tip_diameter": "178 mm"}
    _refused(gl.load_case(CASES / "drawing.toml", short), "mesh = ε_α 0.")


@pytest.mark.slow
@pytest.mark.parametrize("width", ["2 mm", "20 mm"])
@pytest.mark.parametrize("share", [0.3, 2.5])
def test_the_matched_width_has_the_stiffness_of_the_case(
    width: str, share: float, monkeypatch: pytest.MonkeyPatch
):
    """Of a narrow face, too: widths are told to a hundredth of themselves or finer."""
    monkeypatch.setattr("gearlash.multibody.compliance.pair_compliances", standins)
    widths = {"pinion.face_width": width, "gear.face_width": width}
    inputs = inputs_of(loads(SPUR, widths), (1.0,))
    full = mesh_of(inputs, inputs.pair.face_width, inputs.torque)
    wanted = share * full.stiffness
    stated = {**widths, "mesh.mean_stiffness": f"{wanted} N/m"}
    found = matched_mesh(inputs_of(loads(SPUR, stated), (1.0,)), full)
    assert found.stiffness == pytest.approx(wanted, rel=5e-3)


@pytest.mark.parametrize("share", [0.05, 0.2, 0.3, 0.9])
def test_the_width_is_found_of_teeth_that_bear_on_a_part_of_their_face(share: float, monkeypatch):
    """Stiffness that saturates with the width, as that of crowned flanks: k ∝ 1 − exp(−w/10 mm)."""
    inputs, tried = inputs_of(loads(SPUR), (1.0,)), []

    def at(_inputs: object, width: float, _torque: float) -> Any:
        tried.append(width)
        return SimpleNamespace(width=width, stiffness=1e9 * (1.0 - np.exp(-width / 10e-3)))

    monkeypatch.setattr("gearlash.studies.verification.mesh.mesh_of", at)
    full = at(inputs, 65e-3, 1.0)
    wanted = replace(inputs, mean_stiffness=share * full.stiffness)
    assert matched_mesh(wanted, full).stiffness == pytest.approx(wanted.mean_stiffness, rel=5e-3)
    beyond = replace(inputs, mean_stiffness=1.2e9)  # no width is so stiff
    assert matched_mesh(beyond, full).width == max(tried)
    assert max(tried) <= 16.0 * full.width
