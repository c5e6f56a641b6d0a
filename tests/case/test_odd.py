"""Values that do not fit to each other, or to usual gears, are told."""

from __future__ import annotations

from pathlib import Path

import pytest

import gearlash as gl

DRAWING = Path(__file__).resolve().parents[1] / "cases" / "drawing.toml"


@pytest.mark.parametrize(
    ("values", "path", "said"),
    [
        ({"backlash": "5 mm"}, "mesh.backlash", "usual fits"),
        ({"pinion.face_width": "900 mm"}, "pinion.face_width", "times the reference diameter"),
        ({"least_speed": "5000 rpm", "greatest_speed": "6000 rpm"}, "operation.least_speed", "outside"),
        ({"least_speed": "1000 rpm", "greatest_speed": "4000 rpm"}, "operation.greatest_speed", "outside"),
        (
            {"pinion.thickness_allowance": "-200 um", "gear.thickness_allowance": "-200 um"},
            "mesh.backlash", "leave 375.9 µm",
        ),
    ],
)  # fmt: skip
def test_it_is_told(values: dict[str, str], path: str, said: str):
    before = {note.path for note in gl.load_case(DRAWING).notes()}
    assert path not in before
    told = [note.text for note in gl.load_case(DRAWING, values).notes() if note.path == path]
    assert len(told) == 1
    assert said in told[0]


def test_a_rotor_without_its_mass_is_told():
    """Of a pair on bearings only, and not where the mass is stated or the rotor is lighter than the gear."""
    rotor, told = (
        {"pinion.added_inertia": "0.8 kg*m^2"},
        "the mass on its bearings is that of the pinion alone",
    )
    light, massive = {"pinion.added_inertia": "1e-5 kg*m^2"}, rotor | {"pinion.mass": "60 kg"}
    for values, expected in ((rotor, True), (light, False), (massive, False)):
        notes = [n.text for n in gl.load_case(DRAWING, values).notes() if n.path == "pinion.added_inertia"]
        assert [told in text for text in notes] == [True] * expected


def test_teeth_that_leave_the_stated_play_are_not():
    thin = {f"{gear}.thickness_allowance": "-42.6 um" for gear in ("pinion", "gear")}
    case = gl.load_case(DRAWING, thin)
    assert not any(note.path == "mesh.backlash" for note in case.notes())


def test_a_range_where_one_value_is_wanted():
    for text in ("60um..140um", "60:140um", "60 to 140 um", "100±40 um", "60um/140um"):
        with pytest.raises(gl.CaseError, match="with --limits"):
            gl.load_case(DRAWING, {"backlash": text})
