"""Speed and torque of the gear in place of the pinion's: the same motion, told as what was typed."""

from __future__ import annotations

import csv
from pathlib import Path

import pytest

import gearlash as gl
from cli.conftest import Gearlash

DRAWING = str(Path(__file__).resolve().parents[1] / "cases" / "drawing.toml")
RATIO = 57 / 25


def words(gearlash: Gearlash, *arguments: str) -> str:
    ran = gearlash(*arguments)
    assert ran.code == 0, ran.complaint
    return " ".join(ran.out.split())


def test_both_names_mean_the_same_parameter():
    case = gl.load_case(DRAWING)
    for of_gear, of_pinion in (
        (("gear_speed", "1000 rpm"), ("pinion_speed", f"{1000 * RATIO!r} rpm")),
        (("operation.gear_torque", "200 N m"), ("torque", f"{200 / RATIO!r} N m")),
    ):
        name, value = case.resolve(*of_pinion)
        assert case.resolve(*of_gear) == (name, pytest.approx(value, rel=1e-14))
        assert case.held(of_gear[0]) == case.held(of_pinion[0])
    path, rpm, unit = case.at_gear("omega") or ("", 0.0, "")
    assert (path, unit) == ("operation.gear_speed", "rpm")
    assert rpm * RATIO == pytest.approx(float(case.scales.pinion_rpm(1.0)))
    assert case.at_gear("D") is None
    assert gl.load_case("kahraman-singh").at_gear("omega") is None


def test_what_the_case_states_of_the_gear_comes_first(gearlash: Gearlash):
    said = words(gearlash, "run", DRAWING, "--set", "gear_speed=1500rpm")
    assert said.startswith("1500 rpm of the gear, 3420 rpm of the pinion: ")
    assert words(gearlash, "run", DRAWING, "--set", "pinion_speed=3420rpm").startswith("3420 rpm: ")


def test_zones_over_the_speed_of_the_gear_are_those_over_that_of_the_pinion(gearlash: Gearlash):
    low, high = (round(rpm * RATIO, 6) for rpm in (1600.0, 1900.0))
    kind = ("--kind", "impact-free")
    of_gear = gearlash("zones", DRAWING, "--over", "gear_speed=1600:1900rpm:3", *kind, "--json").answer
    other = gearlash("zones", DRAWING, "--over", f"pinion_speed={low}:{high}rpm:3", *kind, "--json").answer
    ends = [
        [(zone["lower"]["value"], zone["upper"]["value"]) for zone in a["zones"]] for a in (of_gear, other)
    ]
    assert ends[0]
    assert ends[0] == [pytest.approx(pair, rel=1e-9) for pair in ends[1]]
    assert " rpm of the gear lies" in of_gear["sentence"]
    said = words(gearlash, "zones", DRAWING, "--over", "gear_speed=1600:1900rpm:3", *kind)
    assert "from 1600 rpm of the gear †, omega" in said


def test_a_sweep_has_its_speeds_as_typed(gearlash: Gearlash, tmp_path: Path):
    out = tmp_path / "out"
    sweep = ("sweep", DRAWING, "--over", "gear_speed=1600:1900rpm:3", "--cold")
    words(gearlash, *sweep, "--csv", "--out", str(out))
    rows = list(csv.DictReader((out / "sweep.csv").read_text(encoding="utf-8").splitlines()))
    assert next(iter(rows[0])) == "gear_speed [rpm]"
    assert [float(row["gear_speed [rpm]"]) for row in rows] == [1600.0, 1750.0, 1900.0]


def test_tolerances_go_over_the_speed_of_the_gear(gearlash: Gearlash):
    axis = ("--over", "gear_speed=1600:1900rpm:3", "--limits", "error=1:2um", "--samples", "2")
    assert "rpm of the gear" in words(gearlash, "tolerance", DRAWING, *axis, "--workers", "1")


def test_a_range_of_speed_of_the_gear_is_that_of_the_pinion_over_the_ratio():
    stated = {"least_gear_speed": "1000 rpm", "greatest_gear_speed": "2000 rpm"}
    case = gl.load_case(DRAWING, stated)
    values = {value.path: value.value for value in case.values()}
    assert values["operation.least_speed"] == pytest.approx(1000.0 * RATIO)
    with pytest.raises(gl.GearlashError, match=r"least_gear_speed.*operation\.greatest_gear_speed beside it"):
        gl.load_case(DRAWING, {"least_gear_speed": "1000 rpm"})
    with pytest.raises(gl.GearlashError, match="one of two"):
        gl.load_case(DRAWING, {**stated, "least_speed": "2000 rpm"})
