"""Worked examples as `gearlash new` takes them, with the addresses of what prints the numbers.

- KHK: tables of Kohara Gear Industry's Gear Technical Reference. The profile shifted spur pair stands on
  bolsover.com/utilitiesforalibre/profile-shifted-external-spur-gears.html; it and the helical pair of the
  normal system also in UnitTests of github.com/bolsover/UtilitiesForAlibre. The helical pair of the
  transverse system is the same table's for teeth that are cut in it (tips with y, quoted from memory).
- DIN: tests/test_1.py of github.com/hanslhansl/din3990, geometry by DIN ISO 21771 of a pair of DIN 3990.
- Span: machinecalcs.com/span-measurement-over-teeth-calculator, its own worked example.
- SDP/SI: Elements of metric gear technology, section 10 (fdocuments.us, scribd.com/document/244615472):
  thickness of teeth.
- Shifts: scribd.com/document/376176518, here as a drawing with centre distance and one shift.
- Helical: a question with normal and transverse diametral pitches (wizedu.com/questions/73138).
- Pins: test_corrected.py of github.com/bfoster59/MOP, with its reference of AGMA. (README.md there has 5.438
  in for 45 teeth, 8 per inch, which is less than their reference diameter of 5.625 in.)
- FVA: a helical pair of the FVA-Workbench, as tests/test_iso6336_dynamics.py of 20_code/40_backend in
  github.com/tkuhn39/semesterthesis has it.
"""

from __future__ import annotations

from math import cos, degrees, radians

import pytest

from gearlash.case import CaseError, loads
from gearlash.gears import CylindricalPair, inspection
from gearlash.gears.cylindrical_pair import shift_sum, tip_shortening
from gearlash.gears.mesh_stiffness import SOLID, method_b, theoretical_stiffness

MM = 1e-3
REST = '[operation]\npinion_speed = "1000 rpm"\ntorque = "50 N m"\n'


def drawn(kind: str = "spur-1dof", mesh: str = "", pinion: str = "", gear: str = "") -> CylindricalPair:
    """The teeth of a file."""
    text = f'kind = "{kind}"\n[pinion]\n{pinion}\n[gear]\n{gear}\n[mesh]\n{mesh}\n{REST}'
    found = loads(text, label="example.toml").numbers.body.teeth
    assert found is not None
    return found


def test_profile_shifted_spur_pair_of_khk():
    pair = drawn(
        mesh='module = "3 mm"\ncentre_distance = "56.5 mm"\ntips = "shortened"',
        pinion="teeth = 12\nprofile_shift = 0.6",
        gear="teeth = 24",
    )
    first, second = pair.gears
    assert second.profile_shift == pytest.approx(0.36, abs=1e-4)  # printed: 0.9600 for the sum
    assert degrees(pair.working_pressure_angle) == pytest.approx(26.0888, abs=1e-4)
    assert [one.base_diameter / MM for one in pair.gears] == pytest.approx([33.8289, 67.6579], abs=1e-4)
    assert [d / MM for d in pair.working_diameters] == pytest.approx([37.667, 75.333], abs=5e-4)
    assert [one.tip_diameter / MM for one in pair.gears] == pytest.approx([44.840, 79.400], abs=1e-3)
    assert [one.root_diameter / MM for one in pair.gears] == pytest.approx([32.1, 66.66], abs=1e-3)
    # printed: 1.202; by its own tip diameters: 1.2021
    whole = pair.tangent_length
    ends = first.roll_length(first.tip_diameter) + second.roll_length(second.tip_diameter) - whole
    assert ends / first.transverse_base_pitch == pytest.approx(1.2021, abs=1e-4)


def test_helical_pair_of_khk_in_the_transverse_system():
    along = cos(radians(30.0))
    heights = f"addendum = {1 / along}\ndedendum = {1.25 / along}"  # which are over m_t
    pair = drawn(
        "helical-pair",
        mesh='transverse_module = "3 mm"\ntransverse_pressure_angle = "20 deg"\nhelix_angle = "30 deg"\n'
        'centre_distance = "109 mm"\ntips = "shortened"',
        pinion=f"teeth = 12\ntransverse_profile_shift = 0.34462\n{heights}",
        gear=f"teeth = 60\n{heights}",
    )
    assert degrees(pair.pinion.transverse_pressure_angle) == pytest.approx(20.0, abs=1e-9)
    assert pair.reference_centre_distance / MM == pytest.approx(108.0)
    assert degrees(pair.working_pressure_angle) == pytest.approx(21.3975, abs=1e-4)
    assert shift_sum(pair) * along == pytest.approx(0.34462, abs=1e-5)
    assert [one.tip_diameter / MM for one in pair.gears] == pytest.approx([44.0, 185.932], abs=1e-3)


def test_spur_pair_of_din_3990():
    pair = drawn(
        mesh='module = "4 mm"\npressure_angle = "20 deg"\nrack = "DIN867"',
        pinion='teeth = 19\nprofile_shift = 0.5\nface_width = "48.64 mm"',
        gear="teeth = 104\nprofile_shift = 0.15",
    )
    assert degrees(pair.working_pressure_angle) == pytest.approx(21.531902292465457, rel=1e-12)
    assert pair.centre_distance / MM == pytest.approx(248.506843355171, rel=1e-12)
    assert [d / MM for d in pair.working_diameters] == pytest.approx([76.77447193, 420.23921478], rel=1e-9)
    assert [one.tip_diameter / MM for one in pair.gears] == pytest.approx([88.0, 425.2])
    assert [one.root_diameter / MM for one in pair.gears] == pytest.approx([70.0, 407.2])
    assert pair.transverse_contact_ratio == pytest.approx(1.5363235945832296, rel=1e-12)


def test_span_of_a_calculator():
    pair = drawn(
        mesh='module = "2 mm"', pinion='teeth = 20\nspan = "15.321 mm"\nspan_teeth = 3', gear="teeth = 20"
    )
    assert pair.pinion.profile_shift == pytest.approx(0.0, abs=2e-4)
    assert inspection.span_teeth(pair.gear) == 3
    assert inspection.span_measurement(pair.gear, 3) / MM == pytest.approx(15.321, abs=5e-4)


@pytest.mark.parametrize(
    ("teeth", "module", "helix", "shift", "thickness"), [(12, 10, 0, 0.3, 17.8918), (16, 5, 25, 0.2, 8.5819)]
)
def test_tooth_thickness_of_sdp(teeth: int, module: float, helix: float, shift: float, thickness: float):
    angle = f'\nhelix_angle = "{helix} deg"' if helix else ""
    pair = drawn(
        "helical-pair" if helix else "spur-1dof",
        mesh=f'normal_module = "{module} mm"{angle}',
        pinion=f'teeth = {teeth}\ntooth_thickness = "{thickness} mm"',
        gear="teeth = 40",
    )
    assert pair.pinion.profile_shift == pytest.approx(shift, abs=2e-5)
    assert pair.pinion.normal_thickness() / MM == pytest.approx(thickness, abs=1e-9)


def test_one_shift_and_the_centre_distance():
    pair = drawn(
        "helical-pair",
        mesh='normal_module = "3.5 mm"\nhelix_angle = "21 deg"\ncentre_distance = "116.5 mm"',
        pinion="teeth = 31\nprofile_shift = 0.291",
        gear="teeth = 30",
    )
    assert pair.gear.profile_shift == pytest.approx(0.651877131252 - 0.291, abs=1e-10)
    assert degrees(pair.working_pressure_angle) == pytest.approx(23.8707609654, abs=1e-10)


def test_helical_pair_in_inches():
    mesh = 'diametral_pitch = 11.3137085\npressure_angle = "14.5 deg"\nhelix_angle = "45 deg"'
    pair = drawn("helical-pair", mesh=mesh, pinion='teeth = 12\nface_width = "1.5 in"', gear="teeth = 32")
    assert [one.reference_diameter / 25.4e-3 for one in pair.gears] == pytest.approx([1.5, 4.0], rel=1e-7)
    transverse = mesh.replace("diametral_pitch = 11.3137085", "transverse_diametral_pitch = 8")
    other = drawn(
        "helical-pair", mesh=transverse, pinion='teeth = 12\nface_width = "1.5 in"', gear="teeth = 32"
    )
    assert other.transverse_contact_ratio == pytest.approx(pair.transverse_contact_ratio, rel=1e-7)
    assert pair.overlap_ratio == pytest.approx(1.5 * 8 / 3.14159265, rel=1e-7)  # b tan β P_t / π


@pytest.mark.parametrize("angle", [14.5, 17.5, 20.0, 22.5, 25.0])
@pytest.mark.parametrize("rack", ["ISO53-A", "ISO53-D", "stub"])
def test_usual_pressure_angles_and_racks(angle: float, rack: str):
    pair = drawn(
        mesh=f'module = "2 mm"\npressure_angle = "{angle} deg"\nrack = "{rack}"',
        pinion="teeth = 36",
        gear="teeth = 60",
    )
    # the closed form of full racks, at the reference centre distance
    height = pair.pinion.rack.addendum * 2 * MM
    path = sum(
        ((one.reference_diameter / 2 + height) ** 2 - (one.base_diameter / 2) ** 2) ** 0.5
        for one in pair.gears
    )
    expected = (path - pair.tangent_length) / pair.pinion.transverse_base_pitch
    assert pair.transverse_contact_ratio == pytest.approx(expected, rel=1e-9)


def test_tip_alteration_is_that_of_shortened_tips():
    shifts = {"pinion": "teeth = 12\nprofile_shift = 0.6", "gear": "teeth = 24\nprofile_shift = 0.36"}
    full = drawn(mesh='module = "3 mm"', **shifts)
    off = f'tip_alteration = "{tip_shortening(full) / MM!r} mm"'
    stated = drawn(mesh='module = "3 mm"', **{name: f"{text}\n{off}" for name, text in shifts.items()})
    short = drawn(mesh='module = "3 mm"\ntips = "shortened"', **shifts)
    for one, other in zip(stated.gears, short.gears, strict=True):
        assert one.tip_diameter == pytest.approx(other.tip_diameter, rel=1e-12)
    assert min(stated.tip_clearances) == pytest.approx(0.25 * 3 * MM, rel=1e-9)


@pytest.mark.parametrize(
    ("mesh", "gear", "said"),
    [
        ('module = "2 mm"', "teeth = -60", "internal gear"),
        ('module = "2 mm"', "teeth = 2", "those of a worm"),
        ('module = "2 mm"\ncentre_distance = "40 mm"', "teeth = 60", "no model of internal gears"),
        ('module = "2 mm"\ndiametral_pitch = 12', "teeth = 60", "one of two that name the same quantity"),
        (
            'module = "2 mm"\npressure_angle = "20 deg"\ntransverse_pressure_angle = "20 deg"', "teeth = 60",
            "one of two that name the same quantity",
        ),
    ],
)  # fmt: skip
def test_what_no_pair_here_has_is_refused_in_words(mesh: str, gear: str, said: str):
    with pytest.raises(CaseError, match=said):
        drawn(mesh=mesh, pinion="teeth = 20", gear=gear)


def test_a_gear_steel_by_its_designation():
    text = f'kind = "spur-1dof"\n[pinion]\nteeth = 20\n[gear]\nteeth = 40\n[mesh]\nmodule = "2 mm"\n{REST}'
    steel, own = (
        loads(text.replace("teeth = 20", f'teeth = 20\nmaterial = "{name}"')) for name in ("steel", "20MnCr5")
    )
    assert own.family()[0].defaults == steel.family()[0].defaults


def test_odd_helical_teeth_over_pins_in_inches():
    mesh = 'diametral_pitch = 12\nhelix_angle = "10.5 deg"\nface_width = "1 in"'
    other = "teeth = 60"
    thick = drawn("helical-pair", mesh, 'teeth = 127\ntooth_thickness = "0.130900 in"', other).pinion
    over = inspection.dimension_over_pins(thick, 0.144 * 25.4e-3) / 25.4e-3
    assert over == pytest.approx(10.967749, abs=2e-6)
    stated = 'teeth = 127\nover_pins = "10.967749 in"\nball_diameter = "0.144 in"'
    measured = drawn("helical-pair", mesh, stated, other).pinion
    assert measured.normal_thickness() / 25.4e-3 == pytest.approx(0.130900, abs=1e-6)


def test_helical_pair_of_the_fva_workbench():
    pair = drawn(
        "helical-pair",
        'normal_module = "2 mm"\nhelix_angle = "20 deg"\nface_width = "26 mm"',
        'teeth = 25\ntip_diameter = "57.209 mm"\ndedendum = 1.3',
        'teeth = 40\ntip_diameter = "89.134 mm"\ndedendum = 1.3',
    )
    assert [one.base_diameter / MM for one in pair.gears] == pytest.approx([49.617, 79.387], abs=6e-4)
    assert [one.virtual_teeth for one in pair.gears] == pytest.approx([29.669, 47.471], abs=6e-4)
    assert pair.transverse_contact_ratio == pytest.approx(1.527, abs=6e-4)
    assert pair.overlap_ratio == pytest.approx(1.4153, abs=6e-5)
    mesh = method_b(pair, rims=(SOLID, SOLID))
    assert theoretical_stiffness(pair) / 1e9 == pytest.approx(17.27, abs=6e-3)
    assert [mesh.single / 1e9, mesh.mean / 1e9] == pytest.approx([12.33, 17.21], abs=6e-3)
