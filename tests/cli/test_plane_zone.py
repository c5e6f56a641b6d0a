"""gearlash zones with two axes: the zone around the operating point, its margins, the files."""

from __future__ import annotations

import csv
import re
from pathlib import Path

import pytest

import gearlash as gl
from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.cli.answers.asked import Asked
from gearlash.cli.answers.plane_zone import MarginAlong, MarginTogether, how_far, times
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema
from gearlash.plots import plane_zoned

OVER = ("--over", "pinion_speed=4000:4300rpm", "--over", "torque=90:105N*m")
PLAIN = ("--over", "omega=1.09:1.11", "--over", "D=0.99:1.01")
TOLERANCES = ("--tolerance", "pinion_speed=50rpm", "--tolerance", "torque=2N*m")


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("zone")


def test_margins_in_the_units_that_were_asked_for(gearlash: Gearlash, kept: Path):
    ran = gearlash(
        "zones", "article", "--set", "pinion_speed=4200rpm", *OVER, *TOLERANCES, "--json", "--out", str(kept)
    )
    answer = ran.answer
    assert ran.code == 0
    assert problems(answer, answer_schema(answer_kind("plane_zone"))) == []
    assert (answer["status"], answer["label"], answer["kind"]) == ("ok", "1-0-0", "impact-free")
    upper = next(m for m in answer["margins"] if m["parameter"] == "omega" and m["upward"])
    touch = gearlash("graze", "article", "--near", "1.1", "--json").answer["points"]
    value = next(p["value"] for p in touch if abs(p["value"] - upper["value"]) < 1e-3)
    assert upper["value"] == pytest.approx(value, abs=1e-10)
    rpm = float(gl.load_case("article").scales.pinion_rpm(value)) - 4200.0
    assert upper["asked"] == pytest.approx(rpm, rel=1e-7)
    assert upper["physical"][0]["unit"] == "rpm"
    assert [m["bounded"] for m in answer["margins"]] == [False, True, False, False]
    box, ellipse = answer["together"]
    assert box["multiple"] <= ellipse["multiple"] < upper["asked"] / 50.0
    assert abs(box["asked"][0] - 4200.0) / 50.0 == pytest.approx(box["multiple"], rel=1e-6)
    assert answer["sentence"].startswith("4200 rpm, 96.95 N·m lies in a zone free of impacts")
    (other,) = answer["beside"]["others"]
    assert other["impacts"]
    said = (
        f"there {other['starts']} of {answer['beside']['starts']} other starts lead to another motion: 2-1;"
    )
    assert said in answer["sentence"]
    assert [bool(paths) for paths in answer["rests_on"]] == [True, True]
    bounded = next(m for m in answer["margins"] if m["bounded"])
    assert f"{bounded['event']} " in answer["sentence"]
    assert "†" in answer["sentence"]


def test_out_has_the_boundary_in_both_units(gearlash: Gearlash, kept: Path):
    if not (kept / "zone.csv").exists():
        test_margins_in_the_units_that_were_asked_for(gearlash, kept)
    assert {path.name for path in kept.iterdir() if not path.name.startswith(".")} >= {
        "zone.json", "zone.csv", "zone.svg", "zone.pdf",
    }  # fmt: skip
    with (kept / "zone.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert list(rows[0])[3:] == ["pinion_speed [rpm]", "omega", "torque [N*m]", "load"]
    factor = float(gl.load_case("article").scales.pinion_rpm(1.0))
    assert all(float(r["pinion_speed [rpm]"]) == pytest.approx(factor * float(r["omega"])) for r in rows)


def test_impacts_on_the_drive_side_come_first(gearlash: Gearlash):
    limits = ("--over", "omega=0.89:0.91", "--over", "D=0.95:1.05")
    out = " ".join(gearlash("zones", "kahraman-singh", "--set", "omega=0.9", *limits).out.split())
    assert out.startswith(
        "omega = 0.9, D = 1 lies in no zone free of impacts of the motion 1-1-0 that was followed, which "
        "hits the drive side, only in one free of impacts on the back side; there "
    )


def test_in_words(gearlash: Gearlash):
    limits = ("--over", "omega=0.8:0.83", "--over", "D=0.95:1.05")
    out = " ".join(gearlash("zones", "kahraman-singh", "--set", "omega=0.81", *limits).out.split())
    assert "omega = 0.81, D = 1 lies in a zone free of impacts" in out
    assert "Curves that bound the zone free of impacts" in out
    assert "D nothing within the range, which ends 0.05 (5 %) below" in out
    assert "Other motions were looked for at the operating point alone." in out
    assert re.search(
        r"1-0-0 that was followed; there \d+ of \d+ other starts lead to another motion: 1-1;", out
    )


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--over", "omega=1:1.1", "--over", "pinion_speed=4000:4200rpm"), "name the same quantity"),
        (("--over", "omega=1:1.1:5", "--over", "D=0.5:1.5"), "NAME=FROM:TO"),
        (("--over", "omega=1:1.1", "--over", "D=0.5:1.5", "--tolerance", "omega=0.1"), "both parameters"),
        (("--over", "omega=1:1.1", "--over", "D=0.5:1.5", "--tolerance", "omega"), "NAME=VALUE"),
        (("--over", "omega=1:1.1:11", "--tolerance", "omega=0.1"), "--tolerance needs two --over"),
        (("--over", "omega=1:1.1", "--tolerance", "omega=0.1"), "--tolerance needs two --over"),
        (("--over", "omega=1.2:1.3", "--over", "D=0.5:1.5"), "from omega = 1.2 to 1.3"),
        (("--over", "pinion_speed=5000:6500rpm", "--over", "torque=20:120N*m"), "from 5000 to 6500 rpm"),
    ],
)
def test_what_cannot_be_used_is_named(gearlash: Gearlash, options: tuple[str, ...], said: str):
    ran = gearlash("zones", "article", *options)
    assert ran.code == 2
    assert said in " ".join(ran.err.split())


def test_a_motion_that_is_not_quiet_is_said_to_be_none(gearlash: Gearlash):
    limits = ("--over", "omega=0.85:0.95", "--over", "D=0.9:1.1", "--kind", "impact-free")
    ran = gearlash("zones", "kahraman-singh", "--set", "omega=0.9", *limits)
    assert ran.code == 2
    assert "which is not impact-free" in ran.err


@pytest.mark.parametrize(("upward", "value"), [(True, 0.8399996), (False, 0.7600004)])
def test_a_margin_is_never_told_as_more_than_it_is(upward: bool, value: float):
    far = abs(value - 0.8)
    margin = MarginAlong("omega", upward, far, far, 100.0 * far / 0.8, (), value, "fold", True)
    shown, share = how_far(margin, Asked("omega", "", 1.0), 0.8).split(" (")
    assert shown.startswith("0.0399")
    assert float(shown) <= far
    assert share == f"4.99 %) {'above' if upward else 'below'}"
    assert times(MarginTogether("box", 1.99999, (0.0, 0.0), (0.0, 0.0), "fold", True)) == "1.999 times"
    speed = ("pinion_speed", 99.9999, "rpm")
    axis = gl.AxisMargin("omega", upward, far, 5.0, value, "fold", True, (speed,))
    assert plane_zoned._said(axis)[1:] == "99.99 rpm"


def test_what_rests_on_assumed_values_is_marked_and_they_are_listed(gearlash: Gearlash):
    case = ("zones", "article", "--set", "pinion_speed=4200rpm")
    words, plain = (" ".join(gearlash(*case, *over).out.split()) for over in (OVER, PLAIN))
    assert "47.8 rpm (1.13 %) above †;" in words
    assert "† rests on assumed values: " in words
    assert "†" not in plain
