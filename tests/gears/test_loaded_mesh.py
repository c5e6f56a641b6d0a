"""Modified flanks under load: against closed forms, a root finder on the same springs, and unmodified meshes.

Harris' map: S. L. Harris, Dynamic loads on the teeth of spur gears, Proc. Inst. Mech. Eng. 172 (1958) 87.
With teeth of equal stiffness k and a long linear relief C at both tips, over (ε_α − 1) p_bt, the loaded error
is |C − F/k|/2 peak to peak: constant at F = kC (C_eff = F_t/(b c′) of ISO/TS 6336-20), and C/2 without load.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from math import cos, pi, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from gearlash.gears import CylindricalGear, CylindricalPair, materials, mesh_stiffness
from gearlash.gears.drawing import Drawing
from gearlash.gears.estimates import estimates
from gearlash.gears.flank_modification import FlankModification, PairModification, Relief, ReliefForm
from gearlash.gears.loaded_mesh import SLICES, ContactLines, contact_lines
from gearlash.gears.mesh_cycle import MeshCycle
from gearlash.gears.pair_shape import PairShape
from gearlash.gears.stiffness_estimates import loaded_mesh, mean_stiffness
from gearlash.gears.tooth_pair import calculated_mesh, pair_stiffness
from gearlash.system import GearlashError, evaluate

STEEL = materials.named("steel"), materials.named("steel")
SPUR = CylindricalPair(CylindricalGear(30, 4e-3), CylindricalGear(60, 4e-3), face_width=0.04)
HELICAL = CylindricalPair(CylindricalGear(25, 3e-3, 0.26), CylindricalGear(57, 3e-3, 0.26), face_width=0.04)
DOUBLE = (SPUR.transverse_contact_ratio - 1.0) * SPUR.pinion.transverse_base_pitch
AMOUNT = 20e-6
TIPS = FlankModification(tip=Relief(AMOUNT, DOUBLE))
LONG = PairModification(TIPS, TIPS)


def equal_teeth(modification: PairModification, pair: CylindricalPair = SPUR) -> ContactLines:
    """Every pair with the stiffness b (N/m for N/m² of 1)."""
    return contact_lines(pair, modification, 1e5, STEEL, PairShape.CONSTANT)


@pytest.mark.parametrize("load", [1e-9, 0.3, 0.7, 1.0, 1.4, 3.0])
def test_harris_map_of_a_long_relief(load):
    mesh = equal_teeth(LONG).under(load * AMOUNT * SPUR.face_width)
    assert np.ptp(mesh.deflection) == pytest.approx(0.5 * abs(1.0 - load) * AMOUNT, abs=2e-3 * AMOUNT)


def test_at_the_design_load_the_loaded_error_is_constant_although_stiffness_and_error_are_not():
    mesh = equal_teeth(LONG).under(AMOUNT * SPUR.face_width)
    assert mesh.deflection == pytest.approx(AMOUNT, rel=1e-9)
    assert mesh.stiffness.max() == pytest.approx(2.0 * mesh.stiffness.min())
    assert np.ptp(mesh.unloaded_error) == pytest.approx(0.5 * AMOUNT, rel=1e-9)


def test_a_short_relief_leaves_no_error_without_load():
    half = FlankModification(tip=Relief(AMOUNT, 0.5 * DOUBLE))
    assert np.ptp(equal_teeth(PairModification(half, half)).under(1e-12).deflection) < 2e-3 * AMOUNT


def test_relief_of_the_roots_is_relief_of_the_mates_tips():
    roots = FlankModification(root=Relief(AMOUNT, DOUBLE))
    places = np.linspace(*SPUR.path_of_contact, 33)
    assert PairModification(roots, roots).gap(SPUR, places) == pytest.approx(
        LONG.gap(SPUR, places), abs=1e-18
    )


def test_a_parabola_begins_more_gently():
    start, end = SPUR.path_of_contact
    place = end - 0.5 * DOUBLE
    curved = PairModification(TIPS, TIPS, ReliefForm.PARABOLIC)
    assert float(LONG.gap(SPUR, place)) == pytest.approx(0.5 * AMOUNT)
    assert float(curved.gap(SPUR, place)) == pytest.approx(0.25 * AMOUNT)
    assert float(curved.gap(SPUR, start)) == pytest.approx(AMOUNT)


def test_a_gap_along_the_normal_is_cos_of_the_base_helix_angle_of_that_of_a_drawing():
    tips = FlankModification(tip=Relief(AMOUNT, 2e-3))
    end = HELICAL.path_of_contact[1]
    along = cos(HELICAL.pinion.base_helix_angle)
    assert float(PairModification(tips).gap(HELICAL, end)) == pytest.approx(AMOUNT * along)


@pytest.mark.parametrize("load", [0.05, 0.5, 0.667, 2.0])
def test_crowned_teeth_of_equal_stiffness(load):
    # one pair bears over |2y| < √(δ/C): F = 2/3 k δ √(δ/C); over the whole width F = k (δ − C/3)
    crowned = PairModification(FlankModification(crowning=AMOUNT))
    mesh = equal_teeth(crowned).under(load * AMOUNT * SPUR.face_width)
    expected = AMOUNT * ((1.5 * load) ** (2 / 3) if load < 2 / 3 else load + 1 / 3)
    assert mesh.deflection.max() == pytest.approx(expected, rel=2e-3)
    width = min(1.0, sqrt(expected / AMOUNT))
    assert mesh.stiffness.min() == pytest.approx(width * SPUR.face_width, abs=1e-3 * SPUR.face_width)


@pytest.mark.parametrize("pair", [SPUR, HELICAL])
@pytest.mark.parametrize("crowning", [0.0, 5e-6])
@pytest.mark.parametrize("force", [1e3, 4e3, 1.7e4])
def test_stiffness_and_error_are_continuous_in_the_load(pair, crowning, force):
    """What they change over a step of the load halves with the step, however small."""
    tips = FlankModification(tip=Relief(AMOUNT, 4e-3), crowning=crowning)
    lines = contact_lines(pair, PairModification(tips, tips), 1e5, STEEL)
    largest = []
    for step in 4e-3 * 0.5 ** np.arange(5):
        meshes = [lines.under(force * (1.0 + step * i)) for i in range(40)]
        told = np.array([[m.mean_stiffness / lines.mean, *m.error_series(3) / AMOUNT] for m in meshes])
        largest.append(np.abs(np.diff(told, axis=0)).max() / step)
    assert max(largest) < 1.0  # a jump J within a step makes it J over the step
    assert largest[-1] < 1.5 * largest[0]


def test_profile_crowning_is_none_in_the_middle():
    crowned = PairModification(
        FlankModification(profile_crowning=8e-6), FlankModification(profile_crowning=2e-6)
    )
    start, end = SPUR.path_of_contact
    gaps = crowned.gap(SPUR, [start, 0.5 * (start + end), 0.25 * start + 0.75 * end])
    assert gaps == pytest.approx([10e-6, 0.0, 2.5e-6], abs=1e-15)


@settings(max_examples=20)
@given(
    st.sampled_from([SPUR, HELICAL]),
    st.floats(0.0, 60e-6), st.floats(0.3e-3, 6e-3), st.floats(0.0, 15e-6), st.floats(1.5, 5.0),
)  # fmt: skip
def test_the_deflection_is_the_root_of_the_sum_of_all_springs(pair, amount, length, crowning, exponent):
    tips = FlankModification(tip=Relief(amount, length), crowning=crowning)
    lines = contact_lines(pair, PairModification(tips), 2e5, STEEL)
    force = 10.0**exponent
    mesh = lines.under(force)
    for index in range(0, len(mesh.phases), 97):
        k, g = lines.stiffness[index], lines.gaps[index]
        root = float(brentq(lambda x, k=k, g=g: k @ np.maximum(x - g, 0.0) - force, 0.0, 1.0, xtol=1e-16))  # type: ignore[arg-type]
        assert mesh.deflection[index] == pytest.approx(root + lines.shared * force, rel=1e-8)
        least, most = g - lines.below[index], g + lines.above[index]
        whole, some = k[most < root * (1 - 1e-9)].sum(), k[least < root * (1 + 1e-9)].sum()
        stiff = 1.0 / (lines.shared + 1.0 / whole) if whole > 0.0 else 0.0
        assert stiff * (1 - 1e-6) <= mesh.stiffness[index] <= (1 + 1e-6) / (lines.shared + 1.0 / some)


@pytest.mark.parametrize("pair", [SPUR, HELICAL])
def test_without_load_unmodified_flanks_touch_on_the_path_of_contact(pair):
    lines = contact_lines(pair, PairModification(), 3e5, STEEL)
    known, mesh = calculated_mesh(pair, 8, 3e5), lines.under(1e-3)
    assert lines.mean == pytest.approx(known.mean, rel=3e-4)
    # of the pieces that the ends of the path go through, a quarter in the mean is told not to bear
    half = 0.5 * pair.overlap_ratio / SLICES
    assert mesh.contact_ratio == pytest.approx(pair.transverse_contact_ratio, abs=half + 1e-3)
    assert 0.9 * known.mean < mesh.mean_stiffness < known.mean  # pairs share what of the bodies gives way
    shapes = contact_lines(pair, PairModification(), 3e5, STEEL, PairShape.PARABOLA).under(1e4)
    cycle = MeshCycle.of_pair(pair, PairShape.PARABOLA).harmonics(4)
    assert shapes.stiffness_harmonics(4) == pytest.approx(cycle, abs=1e-3)


def test_one_pair_alone_is_as_stiff_as_it_is_calculated():
    lines = contact_lines(SPUR, PairModification(), 3e5, STEEL)
    mesh = lines.under(1e-3)
    one = (
        np.count_nonzero(lines.stiffness * (lines.gaps == lines.below), axis=1) == 1
    )  # nowhere another touches
    start, end = SPUR.path_of_contact
    pitch = SPUR.pinion.transverse_base_pitch
    for index in np.flatnonzero(one)[::40]:
        turns = mesh.phases[index] + np.arange(3)
        place = next(float(x) for x in start + turns * pitch if start <= x <= end)
        assert mesh.stiffness[index] == pytest.approx(
            SPUR.face_width * pair_stiffness(SPUR, place, 3e5), rel=1e-3
        )


@pytest.mark.parametrize("pair", [SPUR, HELICAL])
@pytest.mark.parametrize("force", [300.0, 5e3, 3e4])
def test_both_excitations_make_the_loaded_error(pair, force):
    tips = FlankModification(tip=Relief(AMOUNT, 3e-3))
    mesh = contact_lines(pair, PairModification(tips, FlankModification()), 2e5, STEEL).under(force)
    assert np.ptp(np.abs(mesh.stiffness_harmonics(3))) > 1e-4
    count, theta = 8, 2.0 * pi * np.arange(4096) / 4096
    harmonics = mesh.stiffness_harmonics(count)
    orders = np.arange(1, count + 1)
    k = mesh.mean_stiffness * (1.0 + (np.exp(1j * np.outer(theta, orders)) @ harmonics).real)
    model = np.fft.rfft(force / k + evaluate(mesh.error_series(count), theta))[1 : count + 1] / 2048
    turn = np.exp(-2j * pi * np.outer(orders, mesh.phases - 0.5 * mesh.total_contact_ratio))
    assert model == pytest.approx(turn @ mesh.deflection * 2.0 / len(mesh.phases), abs=1e-12)


def test_with_more_torque_more_bears_until_all_of_it_does():
    def at(torque: float):
        return loaded_mesh(Drawing(SPUR, torque=torque, modification=LONG))

    ratios = [at(torque).contact_ratio for torque in (1.0, 100.0, 300.0, 900.0, 3000.0)]
    assert ratios == sorted(ratios)
    assert ratios[0] < 1.1
    assert ratios[-1] > SPUR.transverse_contact_ratio  # teeth that bend touch beyond the path of contact


def test_estimates_of_modified_flanks_make_the_mesh_that_is_solved():
    plain, relieved = Drawing(SPUR, torque=300.0), Drawing(SPUR, torque=300.0, modification=LONG)
    mesh, found = loaded_mesh(relieved), estimates(relieved, 8)
    assert found["mean_stiffness"].value == pytest.approx(mesh.mean_stiffness, rel=1e-9)
    assert found["mean_stiffness"].value < 0.95 * estimates(plain, 8)["mean_stiffness"].value
    complex_ripples = [
        found[f"ripple_{n}"].value * np.exp(1j * found[f"ripple_phase_{n}"].value) for n in range(1, 9)
    ]
    assert complex_ripples == pytest.approx(mesh.stiffness_harmonics(8), abs=1e-12)
    assert all(one.least <= one.value <= one.greatest for one in found.values())


def test_a_stated_mean_is_that_of_what_bears():
    stated = Drawing(SPUR, torque=300.0, modification=LONG, stated_stiffness=4e8)
    assert loaded_mesh(stated).mean_stiffness == pytest.approx(4e8, rel=1e-6)


def test_teeth_that_leave_before_the_next_come_are_refused():
    short = CylindricalGear(30, 4e-3, stated_tip_diameter=0.1205)
    far = CylindricalPair(short, CylindricalGear(60, 4e-3, stated_tip_diameter=0.2405), face_width=0.04)
    assert 0.0 < far.total_contact_ratio < 1.0
    with pytest.raises(GearlashError, match="no pair touches"):
        contact_lines(far, LONG, 1e5, STEEL).under(1e3)


@pytest.mark.parametrize(
    ("torque", "amount", "length", "crowning", "elements", "within"),
    [(77.0, 0.0, 1e-3, 0.0, 16.1e8, 0.05), (400.0, 49e-6, 3.25e-3, 60e-6, 7.7e8, 0.1),
     (80.0, 69e-6, 7.6e-3, 37e-6, 3.75e8, 0.2)],
)  # fmt: skip
def test_the_mesh_of_the_article_against_three_dimensional_finite_elements(
    torque, amount, length, crowning, elements, within
):
    # Mean stiffness that the quasi-static contact of `gearlash.multibody` has for this pair, 65 mm wide, with
    # the same relief at both tips. There neighbouring slices help each other; here they do not: the less of
    # the width bears, the softer are these.
    gears = [CylindricalGear(z, 4e-3, np.radians(18.0)) for z in (28, 70)]
    pair = CylindricalPair(gears[0], gears[1], face_width=65e-3)
    tip = Relief(amount, length)
    modification = PairModification(FlankModification(tip, crowning=crowning), FlankModification(tip))
    drawing = Drawing(pair, torque=torque, modification=modification)
    lines = contact_lines(pair, modification, drawing.line_load or 0.0, STEEL)
    found = lines.under(drawing.normal_force).mean_stiffness
    assert found == pytest.approx(elements, rel=within)
    assert found < elements


def of(kind: str, torque: float | None) -> Drawing:
    """A spur pair of steel, a helical one, and one of plastic, which bends most."""
    angle, name = {"spur": (0.0, "steel"), "helical": (20.0, "steel"), "plastic": (0.0, "POM")}[kind]
    gears = [CylindricalGear(z, 2e-3, np.radians(angle)) for z in (25, 57)]
    bodies = materials.named(name), materials.named(name)
    return Drawing(CylindricalPair(gears[0], gears[1], face_width=20e-3), bodies, torque=torque)


@pytest.mark.parametrize("kind", ["spur", "helical", "plastic"])
@pytest.mark.parametrize("torque", [None, 3.0, 60.0])
def test_a_modification_of_nothing_changes_nothing_and_none_makes_a_mesh_stiffer(
    kind: str, torque: float | None
):
    """The stiffness of unmodified flanks is the standard's, and falls from there with relief and crowning, as
    less of the flanks bears."""
    plain = of(kind, torque)
    pair = plain.pair
    standard = mesh_stiffness.method_b(pair, plain.chosen_materials, plain.rims, plain.line_load)
    whole = mean_stiffness(plain).value
    assert whole == pytest.approx(standard.along_normal(pair.face_width), rel=1e-12)
    assert loaded_mesh(plain).mean_stiffness == pytest.approx(whole, rel=1e-8)
    for many in (
        [FlankModification(tip=Relief(amount, 2e-3)) for amount in (1e-9, 1e-7, 1e-6, 5e-6, 20e-6)],
        [FlankModification(crowning=amount) for amount in (1e-9, 1e-7, 1e-6, 5e-6, 20e-6)],
    ):
        found = [
            mean_stiffness(replace(plain, modification=PairModification(one, one))).value for one in many
        ]
        assert found[0] == pytest.approx(whole, rel=3e-5)
        assert all(more <= less * (1.0 + 1e-12) for less, more in pairwise([whole, *found]))


@pytest.mark.parametrize("kind", ["spur", "helical", "plastic"])
@pytest.mark.parametrize("relief", [0.0, 6e-6])
def test_stating_the_mean_that_is_estimated_changes_nothing(kind: str, relief: float):
    tips = FlankModification(tip=Relief(relief, 2e-3)) if relief else FlankModification()
    drawing = replace(of(kind, 20.0), modification=PairModification(tips, tips))
    stated = replace(drawing, stated_stiffness=mean_stiffness(drawing).value)
    own, other = loaded_mesh(drawing), loaded_mesh(stated)
    assert other.stiffness == pytest.approx(own.stiffness, rel=1e-8)
    assert other.deflection == pytest.approx(own.deflection, rel=1e-8)
    assert other.contact_ratio == pytest.approx(own.contact_ratio, rel=1e-8)
