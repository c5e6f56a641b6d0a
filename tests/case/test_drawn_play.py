"""What a drawing leaves of play: none at all, and shifts that are too large for the centre distance."""

from math import cos, pi, radians, sqrt

import pytest

from gearlash.case import CaseError, loads
from gearlash.case.rating import method_b
from gearlash.gears import materials

TEXT = """
kind = "spur-1dof"
[pinion]
teeth = 23
face_width = "30 mm"
[gear]
teeth = 43
quality = 7
face_width = "30 mm"
[mesh]
module = "3 mm"
[operation]
pinion_speed = "3000 rpm"
torque = "100 N m"
"""


def _loads(mesh: str = "", pinion: str = "", gear: str = ""):
    text = TEXT.replace("[mesh]", f"[mesh]\n{mesh}")
    text = text.replace("[pinion]", f"[pinion]\n{pinion}").replace("[gear]", f"[gear]\n{gear}")
    return loads(text)


def test_no_backlash_is_measured_in_hundredths_of_the_module():
    case = _loads('backlash = "0 um"')
    assert case.family()[0].defaults["D"] == 0.0
    unit = next(v for v in case.values() if v.path == "model.reference_length")
    assert (unit.value, unit.unit) == (30.0, "um")
    assert "hundredth of the module" in unit.reason
    other = loads(TEXT.replace("[mesh]", '[model]\nreference_length = "50 um"\n[mesh]\nbacklash = "0 um"'))
    ours, theirs = case.scales, other.scales  # in SI both are one case
    assert ours.torque(case.family()[0].defaults["load"]) == pytest.approx(
        theirs.torque(other.family()[0].defaults["load"])
    )


def test_shifts_that_leave_play_only_by_allowances_are_told_with_those_that_fit():
    case = _loads('centre_distance = "100 mm"', 'profile_shift = "0.215"', 'profile_shift = "0.215"')
    (note,) = [n for n in case.notes() if "before anything" in n.text]
    assert note.path == "pinion.profile_shift"
    # 23 + 43 teeth, inv α_wt − inv α at cos α_wt = 99 cos 20° / 100, over 2 tan 20° / 66
    assert "room for 0.3456" in note.text
    assert "a shift of one gear alone is written 0.215/" in note.text
    fitting = _loads('centre_distance = "100 mm"', "profile_shift = 0.1728", "profile_shift = 0.1728")
    assert not [n for n in fitting.notes() if "before anything" in n.text]
    without = _loads("", "profile_shift = 0.215", "profile_shift = 0.215")  # the distance follows
    assert not [n for n in without.notes() if "before anything" in n.text]


def test_shifts_that_leave_no_play_are_refused_with_those_that_do():
    with pytest.raises(CaseError) as refused:
        _loads('centre_distance = "100 mm"', "profile_shift = 0.25", "profile_shift = 0.25")
    (problem,) = refused.value.problems
    assert problem.path == "mesh.centre_distance"
    assert "shifts that sum to 0.3456 and less, where these have 0.5" in problem.expected


def test_a_designation_is_told_with_what_it_is_taken_for_and_own_values_are_used():
    case = _loads(
        "", 'material = "GGG40"', 'material = "CuSn12"\nyoungs_modulus = "110 GPa"\ndensity = "8.9 g/cm^3"'
    )
    told = {n.path: n.text for n in case.notes()}
    assert "GGG40 is taken for nodular-cast-iron: E 173 GPa" in told["pinion.material"]
    drawing = case.numbers.body
    assert drawing is not None
    values = {v.path: float(v.value) for v in case.values() if not isinstance(v.value, str)}
    other = _loads("", 'material = "GGG40"', 'material = "CuSn12"')
    listed = {v.path: float(v.value) for v in other.values() if not isinstance(v.value, str)}
    ratio = 8900.0 / materials.named("tin-bronze").density
    assert values["gear.mass"] == pytest.approx(listed["gear.mass"] * ratio)
    assert values["mesh.mean_stiffness"] > listed["mesh.mean_stiffness"]


@pytest.mark.parametrize(
    ("mesh", "own", "listed"),
    [
        ("", 'thermal_expansion = "23 um/(m*K)"', 'material = "aluminium"'),
        ("", 'thermal_expansion = "23e-6/K"', 'material = "aluminium"'),
        ('housing_thermal_expansion = "12.7777777778 uin/in/°F"', "", 'housing_material = "aluminium"'),
    ],
)
def test_an_own_thermal_expansion_stands_for_that_of_the_material(mesh: str, own: str, listed: str):
    """Steel with the expansion of aluminium has the backlash at work of aluminium."""
    warm = '[mesh]\ntemperature = "80 degC"\nbacklash = "100 um"\nmean_stiffness = "3e8 N/m"\n'
    housing = listed if mesh else ""

    def play(text: str) -> float:
        values = loads(text.replace("[mesh]", warm)).values()
        return next(float(v.value) for v in values if v.path == "mesh.backlash_at_work")

    plain = play(TEXT)
    stated = play(TEXT.replace("[mesh]", f"[mesh]\n{mesh}").replace("[gear]", f"[gear]\n{own}"))
    named = play(
        TEXT.replace("[mesh]", f"[mesh]\n{housing}").replace("[gear]", f"[gear]\n{'' if mesh else listed}")
    )
    assert stated == pytest.approx(named, rel=1e-9)
    assert abs(stated - plain) > 1.0  # µm


def test_bearings_are_as_far_apart_as_the_size_of_the_pair_has_it_or_as_stated():
    helical = TEXT.replace("spur-1dof", "helical-pair").replace(
        "[mesh]\nmodule", '[mesh]\nhelix_angle = "10 deg"\nnormal_module'
    )
    case = loads(helical.replace("[gear]", '[gear]\nbearing_span = "300 mm"'))
    found = {v.path: v for v in case.values() if v.path.endswith("bearing_span")}
    assert found["gear.bearing_span"].text == "300 mm"
    estimated = found["pinion.bearing_span"]
    assert (estimated.provenance, estimated.least) == ("assumed", None)
    assert "half to twice as far" in estimated.reason
    drawing = case.numbers.body.teeth
    assert drawing is not None
    assert 1e3 * drawing.face_width + 30.0 < float(estimated.value) < 1e3 * drawing.face_width + 80.0


def test_a_speed_that_looks_like_thousands_is_told_as_it_is_read():
    case = loads(TEXT.replace("3000 rpm", "3.000 rpm"))
    told = {note.path: note.text for note in case.notes()}
    assert "as 3; thousands are written without one, 3000" in told["operation.pinion_speed"]
    for text in ("0.300 rpm", "3000.000 rpm", "300.5 rpm"):
        case = loads(TEXT.replace("3000 rpm", text))
        assert "operation.pinion_speed" not in [n.path for n in case.notes()], text


def test_bearings_are_estimated_on_the_shaft_that_is_stated():
    helical = TEXT.replace("spur-1dof", "helical-pair").replace(
        "[mesh]\nmodule", '[mesh]\nhelix_angle = "10 deg"\nnormal_module'
    )
    on_bore = loads(helical.replace("[pinion]", '[pinion]\nbore = "25 mm"'))
    on_shaft = loads(helical.replace("[pinion]", '[pinion]\nbore = "40 mm"\nshaft_diameter = "25 mm"'))
    path = "pinion.bearing_stiffness_y"
    first, second = (next(v for v in case.values() if v.path == path) for case in (on_bore, on_shaft))
    assert first.value == second.value
    assert "25 mm (as stated)" in second.reason


@pytest.mark.parametrize(
    ("mesh", "gear", "jams"),
    [
        ('distance_grade = "11"', 'fit = "25h"', True),
        ('distance_grade = "7"', 'fit = "25cd"', False),
        ('centre_distance_deviation = "-200 um"', "", True),
        ('temperature = "20 degC"', "", False),
        ('backlash = "10 um"', "", False),
    ],
)
def test_tolerances_that_let_teeth_jam_are_told(mesh: str, gear: str, jams: bool):
    case = _loads(mesh, "", gear)
    told = [note.text for note in case.notes() if note.path == "mesh.backlash" and "jams" in note.text]
    assert bool(told) == jams
    if mesh.startswith(
        "distance"
    ):  # both gears have 25h: 0 at the thick end; js11 of 99 mm is ±110 µm, times 2 sin 20°
        assert not jams or "overlap by 7" in told[0]


def test_resonance_in_the_words_of_the_standard():
    """N beside that of the dynamic factor, n_E1 beside the natural frequency of one degree of freedom."""
    case = _loads()
    found = {
        v.path.removeprefix("derived."): float(v.value) for v in case.values() if not isinstance(v.value, str)
    }
    own = method_b(case, case.family()[0].defaults["omega"], (7, 7))
    assert found["resonance_ratio"] == pytest.approx(own.resonance_ratio, rel=1e-9)
    assert found["resonance_ratio"] == pytest.approx(3000.0 / found["resonance_speed"], rel=1e-12)
    # J/r_b² of both gears in parallel, over 30 mm; kg/mm
    radii = [1.5e-3 * z * cos(radians(20.0)) for z in (23, 43)]
    masses = [found[f"{gear}.inertia"] / r**2 for gear, r in zip(("pinion", "gear"), radii, strict=True)]
    reduced = masses[0] * masses[1] / sum(masses) / 30.0
    assert found["reduced_mass"] == pytest.approx(reduced, rel=1e-9)
    natural = sqrt(found["mesh.mean_stiffness"] / (reduced * 30.0)) / 23 * 30 / pi
    assert found["resonance_speed"] == pytest.approx(natural, rel=1e-9)
    assert 0.4 < found["single_stiffness"] / found["stiffness_per_width"] < 1.0


@pytest.mark.parametrize(
    ("table", "twice"),
    [
        ("operation", 'gear_speed = "900 rpm"'),
        ("operation", 'gear_torque = "60 N m"'),
        ("mesh", "diametral_pitch = 8.5"),
        ("mesh", 'backlash = "100 um"\nbacklash_circumferential = "110 um"'),
        ("mesh", 'diametral_pitch = 8.5\nbacklash = "100 um"\nbacklash_circumferential = "110 um"'),
    ],
)
@pytest.mark.parametrize("words", ['temperature = "80 degC"', 'centre_distance_deviation = "17 um"'])
@pytest.mark.parametrize("gear", ["", 'tip_relief = "12 um"'])
def test_what_is_stated_twice_brings_no_problem_of_teeth_that_are_there(
    words: str, gear: str, table: str, twice: str
):
    text = TEXT.replace("[mesh]", f"[mesh]\n{words}").replace("[gear]", f"[gear]\n{gear}")
    with pytest.raises(CaseError) as caught:
        loads(text.replace(f"[{table}]", f"[{table}]\n{twice}"))
    assert all("name the same quantity" in problem.expected for problem in caught.value.problems)
