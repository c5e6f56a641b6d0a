"""Functions of a branch take a case or its family alike, and names and units of the case."""

from __future__ import annotations

import pytest

import gearlash as gl

CASE = gl.load_case("article")
FAMILY, _ = CASE.family()
RPM = {"pinion_speed": "4000 rpm"}
OMEGA = CASE.resolve("pinion_speed", "4000 rpm")[1]


@pytest.fixture(scope="module")
def orbit() -> gl.Orbit:
    found = gl.attractor(FAMILY.system({"omega": OMEGA}), FAMILY.start())
    assert isinstance(found, gl.Orbit)
    return found


def test_a_touch_is_the_same_of_a_case_in_rpm_and_of_its_family(orbit: gl.Orbit):
    check = gl.grazing_checks(orbit)[0]
    plain = gl.locate_grazing(FAMILY, "omega", orbit, check, values={"omega": OMEGA})
    named = gl.locate_grazing(CASE, "pinion_speed", orbit, check, values=RPM)
    assert (named.name, named.value, named.values) == (plain.name, plain.value, plain.values)
    assert named.status is gl.Status.OK


def test_transitions_of_a_case_are_those_of_its_family():
    up = gl.sweep(CASE, gl.Axis.even("pinion_speed", "3700 rpm", "3740 rpm", 3), direction="up")
    _, backlash, unit = CASE.physical("D", FAMILY.defaults["D"])[0]
    (one,) = gl.transitions(
        CASE, "pinion_speed", up.points, values={"backlash": f"{float(backlash)!r} {unit}"}
    )
    (other,) = gl.transitions(FAMILY, "omega", up.points)
    assert (one.kind, one.label_below) == (other.kind, other.label_below)
    assert one.value == pytest.approx(other.value, rel=1e-12)


@pytest.mark.parametrize("name", ["omgea", "pinion_sped", 3, {}])
def test_a_name_of_no_parameter_is_refused(orbit: gl.Orbit, name: object):
    check = gl.grazing_checks(orbit)[0]
    with pytest.raises(gl.GearlashError):
        gl.locate_grazing(CASE, name, orbit, check, values=RPM)  # pyright: ignore[reportArgumentType]
