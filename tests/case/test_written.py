"""What drawings write beside numbers: standards beside classes, hands, pitches, fits; and what is refused."""

from math import degrees

import pytest

from gearlash.case.kinds import kind_named
from gearlash.case.stated import ValueRefusedError, read_one, read_stated

PLACES = kind_named("helical-pair").places
CLASS, HELIX, BORE = PLACES["pinion.quality"], PLACES["mesh.helix_angle"], PLACES["pinion.bore"]


@pytest.mark.parametrize(
    "text",
    ["7", "ISO 7", "7 (ISO 1328)", "ISO 1328-1:2013 class 7", "DIN ISO 1328-1 7", "JIS N7", "JIS B 1702-1 N7",
     "ISO1328 class 7", "ISO1328-1:2013 7", "ISO7", "class7",
     "GB/T 10095 7", "Klasse 7", "7 ISO 1328-1"],
)  # fmt: skip
def test_a_class_beside_its_standard(text: str):
    assert read_stated(text, CLASS).value == 7.0


@pytest.mark.parametrize(
    ("text", "nearest", "told"),
    [
        ("DIN 7", "7", "DIN 3961"),
        ("8 DIN 3962", "8", "DIN 3961"),
        ("DIN 6 e 25", "6", "DIN 3961"),
        ("DIN 58405 8", "8", "DIN 3961"),
        ("AGMA Q10", "7", "grow as gears get finer"),
        ("AGMA 2000-A88 Q11", "6", "grow as gears get finer"),
        ("AGMA 12", "5", "grow as gears get finer"),
        ("AGMA 2015-A8", "8", "AGMA 2015"),
        ("JIS 4", "8", "JIS B 1702 of 1976"),
        ("6-7", "7", "several"),
        ("7-6-6 GM", "7", "several"),
        ("7 cd 25", "7", "fit"),
        ("JIS4", "8", "JIS B 1702 of 1976"),
        ("7cd25", "7", "fit"),
        ("6 HK", "6", "without other words"),
        ("IT7", "7", "without other words"),
    ],
)
def test_a_class_of_another_standard_is_refused_with_the_one_mostly_taken_for_it(
    text: str, nearest: str, told: str
):
    with pytest.raises(ValueRefusedError) as refused:
        read_stated(text, CLASS)
    assert refused.value.nearest == nearest
    assert told in refused.value.expected
    assert read_stated(nearest, CLASS).value == float(nearest)


@pytest.mark.parametrize("text", ["DIN 6", "AGMA 2015-A8", "JIS 4", "AGMA Q10"])
def test_what_is_said_of_another_standard_agrees_with_the_class_offered(text: str):
    """A class that is offered has to be one that is taken for it: limits of their own alone would speak
    against the hint behind them."""
    with pytest.raises(ValueRefusedError) as refused:
        read_stated(text, CLASS)
    assert "limits" in refused.value.expected
    assert "mostly taken for" in refused.value.expected


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("460.0 js7", "the 7 of js7 stands at distance_grade"),
        ("460 JS7 mm", "the 7 of JS7 stands at distance_grade"),
        ("460js10", "the 10 of js10 stands at distance_grade"),
        ("460 mm2", None),
        ("460 in4", None),
        ("0x10 mm", None),
        ("4x1e5 mm", None),
        ("460 furlog", None),
    ],
)
def test_a_tolerance_zone_behind_a_centre_distance_is_told_where_it_stands(text: str, told: str | None):
    with pytest.raises(ValueRefusedError) as refused:
        read_stated(text, PLACES["mesh.centre_distance"])
    assert ("distance_grade" in refused.value.expected) == (told is not None)
    assert told is None or told in refused.value.expected
    assert told is None or refused.value.nearest in ("460.0 mm", "460 mm")


def test_a_tolerance_zone_behind_another_length_is_called_one():
    with pytest.raises(ValueRefusedError, match="H7 is a tolerance zone") as refused:
        read_stated("30 H7", BORE)
    assert refused.value.nearest == "30 mm"


@pytest.mark.parametrize("text", ["IT13", "AGMA Q3", "DIN 30", "AGMA 2015-A13", "JIS 9", "7-13"])
def test_no_class_is_offered_that_there_is_not(text: str):
    with pytest.raises(ValueRefusedError) as refused:
        read_stated(text, CLASS)
    assert refused.value.nearest is None


@pytest.mark.parametrize("text", ["7.5", "13", "0", "-7", "766", "7e1", "seven", "٧", "7 * 2", "ISO 7.5"])
def test_what_is_no_class(text: str):
    with pytest.raises(ValueRefusedError):
        read_stated(text, CLASS)


@pytest.mark.parametrize(
    ("text", "degrees"),
    [("15° RH", 15.0), ("15° LH", -15.0), ("LH 15°30'", -15.5), ("15 deg left hand", -15.0),
     ("15° rechts", 15.0), ("-15 deg L", -15.0), ("15,5° links", -15.5), ("15°", 15.0),
     ("15° (LH)", -15.0), ("L15°", -15.0), ("15 LH", -15.0), ("RH 15°", 15.0), ("15L", -15.0),
     ("[R] 15°", 15.0),
     ("15° L.H.", -15.0), ("15 deg, left-hand helix", -15.0), ("左旋15°", -15.0),
     ("15° linkssteigend", -15.0),
     ("15° RH/LH", 15.0), ("15° LH / 15° RH", -15.0), ("R/L 15°", 15.0), ("0.2 rad R", degrees(0.2))],
)  # fmt: skip
def test_a_left_hand_helix_is_below_0(text: str, degrees: float):
    assert read_stated(text, HELIX).value == pytest.approx(degrees * 3.141592653589793 / 180.0, rel=1e-14)


@pytest.mark.parametrize("text", ["-15° RH", "RH -15°", "–15° R", "−15 deg right", "+15° LH", "L +15°"])
def test_a_hand_against_its_sign_is_refused(text: str):
    with pytest.raises(ValueRefusedError, match="by its sign or its hand, which are two here: 15"):
        read_stated(text, HELIX)


@pytest.mark.parametrize("text", ["15° LH/LH", "15° LH/16° RH", "15° L / 15° L"])
def test_hands_of_both_gears_that_parallel_shafts_cannot_have_are_refused(text: str):
    with pytest.raises(ValueRefusedError, match="one is left and one right"):
        read_stated(text, HELIX)


@pytest.mark.parametrize(
    ("text", "near"), [("1 LH", "-1 deg"), ("15", "15 deg"), ("LH", None), ("15° L R", None)]
)
def test_an_angle_that_a_hand_does_not_tell_is_refused(text: str, near: str | None):
    """1 may be a degree or a radian, and two hands of one gear say neither."""
    with pytest.raises(ValueRefusedError) as refused:
        read_stated(text, HELIX)
    assert refused.value.nearest == near


@pytest.mark.parametrize("text", ["8", "8/in", "8 DP", "DP 8", "P8", "Pnd 8", "8 per inch", "8 in^-1", "8,0"])
def test_a_diametral_pitch_with_its_letters(text: str):
    assert read_stated(text, PLACES["mesh.diametral_pitch"]).value == 8.0


@pytest.mark.parametrize(
    "text", ["25cd", "25 cd", "cd25", "DIN 3967 - cd 25", "CD 25", "7 cd 25",
     "7cd25", "25cd (DIN 3967)", "DIN 3967:1978-08 7 25 cd"],
)  # fmt: skip
def test_a_fit_in_either_order(text: str):
    assert read_stated(text, PLACES["pinion.fit"]).value == "25cd"


@pytest.mark.parametrize("text", ["25k", "20cd", "31cd", "H7", "backlash 25", "none 25", "25cde", "125cd"])
def test_what_is_no_fit(text: str):
    with pytest.raises(ValueRefusedError, match="DIN 3967"):
        read_stated(text, PLACES["pinion.fit"])


@pytest.mark.parametrize(
    ("text", "nearest"),
    [("fit 25cd", "25cd"), ("25 cd or 26 c", None), ("cd25/c26", None), ("25cd 25cd", None)],
)
def test_a_fit_among_other_words_is_refused_with_it_where_it_is_the_only_one(text: str, nearest: str | None):
    with pytest.raises(ValueRefusedError, match="DIN 3967") as refused:
        read_stated(text, PLACES["pinion.fit"])
    assert refused.value.nearest == nearest
    assert ("several" in refused.value.expected) == (nearest is None)


@pytest.mark.parametrize("text", ["0", "0rpm", "0 rpm", "0.0 1/min", "-0", "0,00 U/min"])
@pytest.mark.parametrize("path", ["operation.least_speed", "operation.least_gear_speed"])
def test_a_range_from_standstill_is_answered_with_what_to_write(path: str, text: str):
    with pytest.raises(ValueRefusedError, match="from standstill the least one that is to be examined"):
        read_stated(text, PLACES[path])
    for above in ("0,5 rpm", "0.01rpm", "05 rpm"):
        assert read_stated(above, PLACES[path]).text == above


def test_a_diameter_with_its_sign():
    assert read_stated("ø30 mm", BORE).value == 0.03


@pytest.mark.parametrize(
    ("path", "text", "nearest"),
    [
        ("pinion.bore", "30", "30 mm"),
        ("pinion.bore", "Ø30", "30 mm"),
        ("pinion.bore", "30 H7", "30 mm"),
        ("pinion.bore", "30 H7 mm", "30 mm"),
        ("pinion.bore", "dia 30 mm", "30 mm"),
        ("mesh.centre_distance", "128 ±0.02 mm", "128 mm"),
        ("mesh.centre_distance", "128 +0.02/-0.01 mm", "128 mm"),
        ("mesh.centre_distance", "128 mm (5.04 in)", "128 mm"),
        ("mesh.normal_module", "m3", "3 mm"),
        ("mesh.backlash", ".004/.006 in", ".004 in to .006 in"),
        ("mesh.backlash", "80 um 90 um", None),
        ("mesh.pressure_angle", "20", "20 deg"),
        ("operation.torque", "150 NM", "150 N m"),
        ("operation.torque", "150 nm", "150 N m"),
        ("operation.torque", "15 kgm", "15 kgf m"),
        ("operation.torque", "1.53 kgcm", "1.53 kgf cm"),
        ("operation.pinion_speed", "4200", "4200 rpm"),
        ("operation.pinion_speed", "4200 r.p.m.", "4200 rpm"),
        ("operation.pinion_speed", "4200 rev per min", "4200 rev/min"),
        ("operation.pinion_speed", "4200 u/min", "4200 U/min"),
        ("operation.power", "20 kw", "20 kW"),
        ("operation.power", "20 metric hp", "20 PS"),
        ("operation.power", "20 hp(M)", "20 PS"),
        ("mesh.backlash", "0.08", "0.08 mm"),
        ("mesh.backlash", "80", "80 um"),
        ("mesh.backlash", "0.5", None),
        ("pinion.thickness_allowance", "-0.07", "-0.07 mm"),
        ("pinion.tip_relief", "0,02", "0.02 mm"),
        ("pinion.density", "7.85", "7.85 g/cm^3"),
        ("pinion.density", "7850", "7850 kg/m^3"),
        ("pinion.youngs_modulus", "206000", "206000 MPa"),
        ("pinion.youngs_modulus", "30e6", "30e6 psi"),
        ("pinion.youngs_modulus", "21000", None),
        ("operation.torque", "150000", "150000 N mm"),
        ("operation.torque", "20000", "20000 N*m"),
        ("mesh.helix_angle", "0.2618", None),
        ("mesh.helix_angle", "β = 15", "15 deg"),
        ("mesh.helix_angle", "15° sinistral", None),
        ("mesh.helix_angle", "15° à gauche", None),
        ("mesh.helix_angle", "minus 15°", None),
        ("mesh.helix_angle", "— 15°", None),
        ("pinion.thickness_allowance", "minus 70 um", None),
        ("pinion.tip_diameter", "R46.5 mm", None),
        ("pinion.bore", "30 mm radius", None),
        ("pinion.bore", "1.25", None),
        ("pinion.bore", "0.03", "0.03 m"),
        ("mesh.backlash", "0.04 mm per flank", None),
        ("mesh.backlash", "4", None),
        ("pinion.density", "490", None),
        ("pinion.face_width", "b = -40", None),
        ("pinion.temperature", "30 K", None),
        ("pinion.temperature", "140 °F", "60 degC"),
        ("pinion.temperature", "333.15 K", "60 degC"),
    ],
)
def test_the_value_that_was_probably_meant(path: str, text: str, nearest: str | None):
    with pytest.raises(ValueRefusedError) as refused:
        read_stated(text, PLACES[path])
    assert refused.value.nearest == nearest
    if nearest is not None:
        read_stated(nearest, PLACES[path])


@pytest.mark.parametrize(
    ("path", "text", "told"),
    [
        ("mesh.normal_module", "8 DP", "stands at diametral_pitch"),
        ("mesh.mean_stiffness", "20 N/(mm·µm)", "its product with b"),
        ("operation.torque", "20 kW", "that is a power"),
        ("mesh.backlash", "80 parsecish", "units are mm, µm"),
    ],
)
def test_a_unit_of_another_quantity_is_named(path: str, text: str, told: str):
    with pytest.raises(ValueRefusedError) as refused:
        read_stated(text, PLACES[path])
    assert told in refused.value.expected


def test_a_material_that_is_not_known_is_answered_with_how_to_state_it():
    with pytest.raises(ValueRefusedError) as refused:
        read_stated("aluminium bronze", PLACES["gear.material"])
    assert refused.value.nearest == "tin-bronze"
    assert "youngs_modulus, poisson_ratio, density and thermal_expansion" in refused.value.expected
    assert read_stated("EN-GJL-250", PLACES["mesh.housing_material"]).value == "EN-GJL-250"


@pytest.mark.parametrize(
    "text", ["16MnCr5 einsatzgehärtet 60HRC", "case-hardened 16MnCr5", "16MnCr5, nitrided"]
)
def test_a_designation_among_other_words_is_offered_alone(text: str):
    with pytest.raises(ValueRefusedError) as refused:
        read_stated(text, PLACES["gear.material"])
    assert refused.value.nearest == "16MnCr5"


@pytest.mark.parametrize("text", ["0.08-0.12 mm", "80..120 um", "0.1~0.2 mm", "80 to 120 um"])
def test_two_values_are_answered_with_where_two_go(text: str):
    with pytest.raises(ValueRefusedError, match="two ends go to gearlash tolerance"):
        read_one(text, PLACES["mesh.backlash"])
