"""Reports of STplus 11.1F (FVA, FZG of TU München), beside what a case file of the same data has.

They are kept as report.sta.txt in 20_code/10_gearcore/src/gearcore/data/stplus of
github.com/tkuhn39/semesterthesis: geometry by DIN 3960, allowances by DIN 3967, factors by ISO 6336-1:2019.
Every number to the digits that are printed, but for:

- d_Ff, and what ends at it: found there by iteration to some µm, next to the base circle most of all; α_wt to
  0.00002°.
- the teeth k of W_k that the program chooses itself: it takes one more than DIN 3960 has for most of them.
- C_B there is of the dedendum that the thinner tooth has, 1.39 + x - x_E, here that of the rack.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import degrees, pi, sqrt

import pytest

from gearlash.case import Case, loads
from gearlash.gears import (
    CylindricalGear,
    CylindricalPair,
    backlash,
    equivalent_mass,
    gear_fits,
    inspection,
    materials,
)
from gearlash.gears.basic_rack import BasicRack
from gearlash.gears.dynamic_factor import EffectiveErrors, dynamic_factor
from gearlash.gears.mesh_stiffness import SOLID, method_b

MM = 1e-3
Two = tuple[float, float]


@dataclass(frozen=True)
class Report:
    """What is stated, and what is printed: of pinion and gear; mm, degrees, µm for allowances."""

    kind: str
    mesh: str
    pinion: str
    gear: str
    allowances: tuple[Two, Two]
    angles: tuple[float, float, float]  # α_t, α_wt, β_b
    centre: float
    shift: Two
    generating: Two
    pitch: float
    path: float
    ratios: Two
    working: Two
    base: Two
    tip: Two
    active_root: Two
    form: Two
    root: Two
    clearance: Two
    thickness: Two
    at_tip: Two
    teeth: tuple[int, int]
    span: Two
    ball: Two
    over_balls: Two
    over_pins: Two
    over_balls_lower: Two  # by the upper and by the lower allowance of the pinion
    play: Two  # j_t, j_n of the upper allowances


REPORTS = {
    "fzg_c": Report(
        "spur-1dof", 'module = "4.5 mm"\ncentre_distance = "91.5 mm"\nface_width = "14 mm"',
        'teeth = 16\nprofile_shift = 0.1818\ntip_diameter = "82.45 mm"\ndedendum = 1.39\nroot_radius = 0.25',
        'teeth = 24\ntip_diameter = "118.35 mm"\ndedendum = 1.39\nroot_radius = 0.25',
        ((-85, -125), (-85, -125)), (20.0, 22.43879, 0.0), 91.5, (0.1818, 0.1714), (0.1559, 0.1454),
        13.285, 19.079, (1.436, 0.0), (73.2, 109.8), (67.658, 101.487), (82.45, 118.35), (68.249, 104.001),
        (67.685, 101.847), (60.893, 96.799), (1.876, 1.879), (7.664, 7.630), (2.643, 2.982),
        (3, 4), (34.779, 48.536), (8.0, 7.5), (84.660, 119.135), (84.660, 119.135), (-0.171, -0.251),
        (0.173, 0.160),
    ),
    "helix30_z25_40": Report(
        "helical-pair", 'normal_module = "3 mm"\nhelix_angle = "30 deg"\nface_width = "30 mm"',
        "teeth = 25\nprofile_shift = 0.3", "teeth = 40\nprofile_shift = -0.1",
        ((-85, -125), (-115, -165)), (22.79588, 23.49798, 28.02432), 113.175, (0.3, -0.1), (0.2611, -0.1527),
        10.033, 13.259, (1.322, 1.592), (87.057, 139.292), (79.838, 127.741), (94.403, 143.964),
        (83.326, 133.819), (82.843, 132.673), (80.669, 130.148), (0.899, 0.858), (5.368, 4.494),
        (1.978, 2.281), (6, 7), (50.905, 59.889), (6.5, 6.0), (99.572, 148.295), (99.756, 148.295),
        (-0.175, -0.258), (0.232, 0.188),
    ),
    "helix15_b_unequal": Report(
        "helical-pair", 'normal_module = "2.5 mm"\nhelix_angle = "15 deg"\nrack = "ISO53-B"',
        'teeth = 19\nprofile_shift = 0.3\nface_width = "30 mm"',
        'teeth = 47\nprofile_shift = 0.0\nface_width = "24 mm"',
        ((-65, -95), (-85, -125)), (20.64690, 21.89712, 14.07610), 86.139, (0.3, 0.0), (0.2643, -0.0467),
        7.609, 11.300, (1.485, 0.791), (49.595, 122.683), (46.017, 113.832), (55.676, 126.645),
        (46.840, 118.494), (46.427, 117.062), (44.247, 115.161), (0.720, 0.693), (4.473, 3.927),
        (1.390, 1.857), (4, 7), (27.079, 49.789), (4.5, 4.5), (56.737, 128.307), (56.916, 128.377),
        (-0.132, -0.193), (0.157, 0.141),
    ),
    "undercut_z12_x0": Report(
        "spur-1dof", 'module = "2 mm"\nface_width = "20 mm"',
        "teeth = 12\nprofile_shift = 0.0\nroot_radius = 0.25",
        'teeth = 40\nprofile_shift = 0.0\nroot_radius = 0.25\ntip_diameter = "83.166 mm"',
        ((-65, -95), (-85, -125)), (20.0, 20.0, 0.0), 52.0, (0.0, 0.0), (-0.0446, -0.0584),
        5.904, 7.241, (1.226, 0.0), (24.0, 80.0), (22.553, 75.175), (28.0, 83.166), (22.651, 77.533),
        (22.651, 76.467), (18.821, 74.766), (0.617, 1.006), (3.142, 3.142), (1.166, 1.821),
        (3, 5), (15.097, 27.690), (4.0, 3.5), (30.379, 85.002), (30.379, 85.002), (-0.118, -0.174),
        (0.150, 0.141),
    ),
    "small_z8_x05": Report(
        "spur-1dof", 'module = "1 mm"\nface_width = "10 mm"',
        'teeth = 8\nprofile_shift = 0.5\ntip_diameter = "10.990 mm"', "teeth = 30\nprofile_shift = 0.2",
        ((-48, -68), (-65, -95)), (20.0, 24.55316, 0.0), 19.629, (0.5, 0.2), (0.4341, 0.1107),
        2.952, 3.837, (1.300, 0.0), (8.265, 30.993), (7.518, 28.191), (10.990, 32.400), (7.525, 29.386),
        (7.518, 28.642), (6.368, 27.721), (0.273, 0.245), (1.935, 1.716), (0.020, 0.612),
        (3, 5), (7.834, 13.842), (2.75, 1.75), (13.542, 32.822), (13.542, 32.822), (-0.063, -0.089),
        (0.117, 0.106),
    ),
    "plastic_m05_z20": Report(
        "spur-1dof", 'module = "0.5 mm"\nface_width = "6 mm"',
        "teeth = 20\nprofile_shift = 0.1\nroot_radius = 0.2",
        "teeth = 41\nprofile_shift = 0.05\nroot_radius = 0.2",
        ((-48, -68), (-65, -95)), (20.0, 20.74365, 0.0), 15.324, (0.1, 0.05), (-0.0319, -0.1286),
        1.476, 2.357, (1.597, 0.0), (10.048, 20.599), (9.397, 19.264), (11.100, 21.550), (9.473, 19.889),
        (9.397, 19.555), (8.718, 19.121), (0.213, 0.190), (0.822, 0.804), (0.276, 0.308),
        (3, 5), (3.864, 6.947), (1.1, 1.0), (12.012, 22.213), (12.012, 22.213), (-0.090, -0.128),
        (0.114, 0.106),
    ),
}  # fmt: skip


def case_of(report: Report) -> Case:
    """A file with the teeth at the upper ends of their tolerances, as the report has them."""
    thin = [f'\nthickness_allowance = "{ends[0]} um"' for ends in report.allowances]
    text = f'kind = "{report.kind}"\n[pinion]\n{report.pinion}{thin[0]}\n[gear]\n{report.gear}{thin[1]}\n'
    text += f'[mesh]\n{report.mesh}\n[operation]\npinion_speed = "1500 rpm"\ntorque = "130 N m"\n'
    return loads(text, label="stplus.toml")


def pair_of(report: Report) -> CylindricalPair:
    found = case_of(report).numbers.body.teeth
    assert found is not None
    return found


def printed(values, digits: int = 3):
    return pytest.approx(list(values), abs=0.6 * 10**-digits)


reports = pytest.mark.parametrize("report_of", REPORTS.values(), ids=REPORTS)


@reports
def test_pair(report_of: Report):
    pair = pair_of(report_of)
    first = pair.pinion
    angles = first.transverse_pressure_angle, pair.working_pressure_angle, first.base_helix_angle
    assert [degrees(angle) for angle in angles] == pytest.approx(list(report_of.angles), abs=2e-5)
    assert pair.centre_distance / MM == pytest.approx(report_of.centre, abs=6e-4)
    assert [one.profile_shift for one in pair.gears] == printed(report_of.shift, 4)
    assert first.transverse_base_pitch / MM == pytest.approx(report_of.pitch, abs=6e-4)
    start, end = pair.path_of_contact
    undercut = pair.pinion.undercut
    assert (end - start) / MM == pytest.approx(report_of.path, abs=5e-3 if undercut else 6e-4)
    assert [pair.transverse_contact_ratio, pair.overlap_ratio] == printed(report_of.ratios)
    assert [d / MM for d in pair.working_diameters] == printed(report_of.working)
    roots = [d / MM for d in pair.active_root_diameters]
    assert roots == pytest.approx(list(report_of.active_root), abs=1.2e-3)
    assert [c / MM for c in pair.tip_clearances] == printed(report_of.clearance)


@reports
def test_gears(report_of: Report):
    gears = pair_of(report_of).gears
    assert [one.base_diameter / MM for one in gears] == printed(report_of.base)
    assert [one.tip_diameter / MM for one in gears] == printed(report_of.tip)
    assert [one.root_diameter / MM for one in gears] == printed(report_of.root)
    assert [one.generating_profile_shift for one in gears] == printed(report_of.generating, 4)
    assert [one.root_form_diameter / MM for one in gears] == pytest.approx(list(report_of.form), abs=7e-3)
    at_tip = [one.tip_thickness() / MM for one in gears]
    assert at_tip == pytest.approx(list(report_of.at_tip), abs=1.1e-3)  # of a d_a of three digits
    assert [one.nominal().normal_thickness() / MM for one in gears] == printed(report_of.thickness)


@reports
def test_measures(report_of: Report):
    gears = pair_of(report_of).gears
    bare = [one.nominal() for one in gears]
    balls = [ball * MM for ball in report_of.ball]
    spans = [inspection.span_measurement(one, k) / MM for one, k in zip(bare, report_of.teeth, strict=True)]
    assert spans == printed(report_of.span)
    for measure, values in (
        (inspection.dimension_over_balls, report_of.over_balls),
        (inspection.dimension_over_pins, report_of.over_pins),
    ):
        assert [measure(one, d) / MM for one, d in zip(bare, balls, strict=True)] == printed(values)
    nominal = inspection.dimension_over_balls(bare[0], balls[0])
    for allowance, change in zip(report_of.allowances[0], report_of.over_balls_lower, strict=True):
        thin = replace(bare[0], thickness_allowance=allowance * 1e-6)
        found = (inspection.dimension_over_balls(thin, balls[0]) - nominal) / MM
        assert found == pytest.approx(change, abs=1.1e-3)  # linear there


@reports
def test_play_and_tolerances(report_of: Report):
    pair = pair_of(report_of)
    play = backlash.of_pair(pair)
    assert [play.circumferential / MM, play.normal / MM] == printed(report_of.play)
    for one, allowances in zip(pair.gears, report_of.allowances, strict=True):
        found = gear_fits.thickness_allowances("25c", one.reference_diameter)
        assert [a * 1e6 for a in found] == pytest.approx(list(allowances))


def test_stiffness_and_dynamic_factor_by_iso_6336():
    report = REPORTS["fzg_c"]
    pair = pair_of(report)
    deeper = [
        replace(one, rack=replace(one.rack, dedendum=1.39 + one.profile_shift - one.generating_profile_shift))
        for one in pair.gears
    ]
    steel = replace(materials.named("steel"), youngs_modulus=210e9)
    mesh = method_b(
        CylindricalPair(deeper[0], deeper[1], pair.stated_centre_distance, pair.face_width),
        (steel, steel), (SOLID, SOLID), 3611.1 / 14e-3,
    )  # fmt: skip
    exact = replace(mesh, mean=mesh.single * (0.75 * pair.transverse_contact_ratio + 0.25))
    found = [exact.single, exact.mean, exact.face_load]
    assert [round(c / 1e9, 1) for c in found] == [11.5, 15.2, 12.9]
    inertias = case_of(report).numbers.body.inertias
    assert inertias is not None
    radii = (pair.pinion.base_diameter / 2, pair.gear.base_diameter / 2)
    mass = 7.85 / 7.83 * equivalent_mass(radii, inertias) / pair.face_width
    assert round(mass / 1e3, 3) == 0.012
    assert 1500 / (30 / pi / 16 * sqrt(exact.mean / mass)) == pytest.approx(0.071, abs=6e-4)
    # f_pb = 7 µm, f_fα = 8 µm, y_p and y_f 7.5 % of them, C_a = C_ay = 2 µm, grade 5
    errors = EffectiveErrors(0.925 * 7e-6, 0.925 * 8e-6)
    factor = dynamic_factor(pair, exact, mass, 1500 * pi / 30, 3611.1 / 14e-3, errors, 2e-6)
    assert round(factor.value, 2) == 1.03


def test_forces():
    values = {value.path: value.value for value in case_of(REPORTS["fzg_c"]).values()}
    assert values["derived.tangential_force"] == pytest.approx(3611.1, abs=0.06)
    assert values["derived.working_tangential_force"] == pytest.approx(3551.9, abs=0.06)
    assert values["derived.normal_force"] == pytest.approx(3842.9, abs=0.06)
    assert values["derived.pitch_line_speed"] == pytest.approx(5.749, abs=6e-4)


def test_teeth_whose_contact_ratio_is_below_one():
    # neg_shift_z17_xm08: ε_α = 0.807 there; a case is refused for it, and the geometry is the same
    rack = BasicRack(root_radius=0.25)
    pinion = CylindricalGear(17, 4 * MM, 0.0, -0.8, rack, thickness_allowance=-85e-6)
    gear = CylindricalGear(60, 4 * MM, 0.0, 0.6, rack, 246.892 * MM, thickness_allowance=-115e-6)
    pair = CylindricalPair(pinion, gear)
    assert degrees(pair.working_pressure_angle) == pytest.approx(19.14312, abs=2e-5)
    assert pair.centre_distance / MM == pytest.approx(153.183, abs=6e-4)
    assert pair.transverse_contact_ratio == pytest.approx(0.807, abs=1.5e-3)
    assert [d / MM for d in pair.active_root_diameters] == pytest.approx([64.467, 237.009], abs=2e-3)
    assert [one.root_diameter / MM for one in pair.gears] == printed((51.366, 234.484))
    assert [one.generating_profile_shift for one in pair.gears] == printed((-0.8292, 0.5605), 4)
    bare = [one.nominal() for one in pair.gears]
    assert [inspection.span_measurement(one, k) / MM for one, k in zip(bare, (2, 8), strict=True)] == printed(
        (16.476, 93.567)
    )
    balls = (8.0 * MM, 5.5 * MM)
    over = [inspection.dimension_over_balls(one, d) / MM for one, d in zip(bare, balls, strict=True)]
    assert over == printed((75.434, 248.941))
    play = backlash.of_pair(pair)
    assert [play.circumferential / MM, play.normal / MM] == printed((0.199, 0.188))
