"""Limits of what estimates rest on are in the ranges of the estimates: chains of tolerances by hand."""

from math import cos, pi, radians, tan

import pytest

import gearlash as gl
from gearlash.case import Value, loads

SPUR = """
kind = "spur-1dof"
[pinion]
teeth = 25
face_width = "20 mm"
material = "steel"
profile_shift = 0
span = {first}
span_teeth = 3
[gear]
teeth = 57
face_width = "20 mm"
material = "steel"
profile_shift = 0
span = {second}
span_teeth = 7
[mesh]
normal_module = "2.5 mm"
[operation]
pinion_speed = "3000 rpm"
torque = "150 N·m"
"""


def span(teeth: int, over: int) -> float:
    """W_k = m cos α ((k - 1/2) π + z inv α) without play and shift, mm."""
    angle = radians(20.0)
    return 2.5 * cos(angle) * ((over - 0.5) * pi + teeth * (tan(angle) - angle))


def pair(first: str, second: str) -> gl.Case:
    return loads(SPUR.format(first=f'"{first}"', second=f'"{second}"'))


def value(case: gl.Case, path: str) -> Value:
    return next(v for v in case.values() if v.path == path)


def test_play_of_a_chain_of_tolerances():
    """A span that is shorter by some length gives as much play along the normal; so do limits, of both gears
    together, beside what js7 of the centre distance (±17.5 µm at 102.5 mm) gives, 2 sin α of it."""
    first, second = span(25, 3), span(57, 7)
    limited = value(pair(f"{first:.6f} mm -60/-90 um", f"{second:.6f} mm -0.08/-0.12 mm"), "mesh.backlash")
    alone = value(pair(f"{first - 0.075:.6f} mm", f"{second - 0.1:.6f} mm"), "mesh.backlash")
    assert alone.least is not None
    assert alone.greatest is not None
    assert limited.value == pytest.approx(175.0, abs=0.01) == alone.value
    assert 0.5 * (alone.greatest - alone.least) == pytest.approx(17.5 * 2.0 * 0.3420201, rel=0.01)
    assert limited.least == pytest.approx(alone.least - 35.0, abs=0.05)
    assert limited.greatest == pytest.approx(alone.greatest + 35.0, abs=0.05)
    assert limited.reason == f"{alone.reason}; with the limits of gear.span and pinion.span"


def test_the_tight_end_of_a_chain_is_told_where_the_pair_jams():
    case = pair(f"{span(25, 3):.6f} mm -0/-30 um", f"{span(57, 7):.6f} mm -0.00/-0.02 mm")
    (note,) = (note for note in case.notes() if note.path == "mesh.backlash")
    assert "25 µm of backlash in the middle of the tolerances; at their tight end teeth overlap" in note.text


def test_what_follows_the_torque_has_the_range_of_both_its_limits():
    case = pair("19.25 mm", "49.9 mm")
    limited = case.with_overrides({"torque": "50 to 250 N·m"})
    single = [case.with_overrides({"torque": f"{torque} N·m"}) for torque in (50, 150, 250)]
    for path in ("mesh.mean_stiffness", "mesh.ripple", "mesh.ripple_2"):
        ranges = [value(each, path) for each in single]
        wide = value(limited, path)
        assert wide.value == ranges[1].value
        assert wide.least == min(each.least for each in ranges if each.least is not None)
        assert wide.greatest == max(each.greatest for each in ranges if each.greatest is not None)
    assert value(limited, "mesh.ripple").reason.endswith("; with the limits of operation.torque")


def test_limits_that_nothing_estimated_rests_on_change_no_range():
    case = pair("19.25 mm", "49.9 mm")
    limited = case.with_overrides({"mesh.damping_ratio": "0.02:0.05", "operation.least_speed": "2000 rpm",
                                   "operation.greatest_speed": "4000 rpm"})  # fmt: skip
    for path in ("mesh.mean_stiffness", "mesh.ripple", "mesh.error", "mesh.backlash", "pinion.mass"):
        one, other = value(case, path), value(limited, path)
        assert (one.least, one.greatest, one.reason) == (other.least, other.greatest, other.reason)


def test_limits_that_no_pair_has_are_left_out():
    """At the greatest diameter nothing of the rim would be left."""
    text = SPUR.format(first='"19.25 mm"', second='"49.9 mm"').replace(
        "[mesh]", 'bore = "30 to 200 mm"\n[mesh]'
    )
    case = loads(text.replace('"30 to 200 mm"', '{value = "40 mm", range = ["30 mm", "200 mm"]}'))
    mass, thick = value(case, "gear.mass"), value(case.with_overrides({"gear.bore": "30 mm"}), "gear.mass")
    plain = value(case.with_overrides({"gear.bore": "40 mm"}), "gear.mass")
    assert (mass.least, mass.greatest) == (plain.least, thick.greatest)


def test_a_deviation_of_the_centre_distance_takes_the_place_of_its_tolerance():
    """Of ±100 µm the tight end takes 2 sin α of it, 68.4 µm, to first order; js7 is not counted beside it."""
    first, second = f"{span(25, 3) - 0.02:.6f} mm", f"{span(57, 7):.6f} mm -20/-40 um"
    case = pair(first, second).with_overrides({"mesh.centre_distance_deviation": "±100 um"})
    play = value(case, "mesh.backlash")
    assert play.reason == (
        "stated tooth thickness; deviation of the centre distance as stated; with the limits of gear.span"
    )
    assert (play.least, play.value, play.greatest) == pytest.approx((40.0, 50.0, 60.0), abs=0.02)
    (note,) = (note for note in case.notes() if note.path == "mesh.backlash")
    overlap = 200.0 * 0.3420201 - 40.0
    told = float(note.text.partition("teeth overlap by ")[2].partition(" µm")[0])
    assert told == pytest.approx(overlap, abs=0.3)
    graded = value(case.with_overrides({"mesh.distance_grade": 7}), "mesh.backlash")
    assert graded.least == pytest.approx(40.0 - 17.5 * 2.0 * 0.3420201, abs=0.2)


def test_the_tight_end_of_stated_limits_is_told_where_the_pair_jams():
    case = pair("19.25 mm", "49.9 mm").with_overrides({"backlash": "50 um"})
    assert not [note for note in case.notes() if "jams" in note.text]
    deviating = case.with_overrides({"mesh.centre_distance_deviation": "-100 to 100 um"})
    (note,) = (note for note in deviating.notes() if "jams" in note.text)
    assert (
        "50 µm of backlash at work; at the tight end of the stated limits teeth overlap by 18." in note.text
    )
