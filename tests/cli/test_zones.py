"""gearlash zones: intervals against what ends them, the sentence, the files."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

import gearlash as gl
from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.cli.answers.asked import Asked
from gearlash.cli.answers.zones_parts import EndPoint, MarginFound, Resident, Stay, ZoneEnd, ZoneFound
from gearlash.cli.answers.zones_words import headline
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema
from gearlash.cli.show.numbers import at_least
from gearlash.results.zone_words import event

CASES = Path(__file__).resolve().parents[1] / "cases"
DRIVE = str(CASES / "drive.toml")
RPM = Asked("pinion_speed", "rpm", 1000.0)


def test_zones_against_their_grazings(gearlash: Gearlash, tmp_path: Path):
    over = ("--over", "omega=0.95:1.06:12")
    ran = gearlash("zones", "article", *over, "--kind", "impact-free", "--json", "--out", str(tmp_path))
    answer = ran.answer
    assert ran.code == 0
    assert problems(answer, answer_schema(answer_kind("zones"))) == []
    zone = answer["zones"][0]
    assert (zone["kind"], zone["every"]) == ("impact-free", True)
    assert zone["lower"]["kind"] == "grazing"
    assert zone["lower"]["solved"] is True
    assert zone["upper"]["kind"] == "end of the range"
    lower = gearlash("graze", "article", "--near", "0.98", "--json").answer["points"][0]["value"]
    assert zone["lower"]["value"] == pytest.approx(lower, abs=1e-10)
    own = answer["parameters"]["omega"]
    assert answer["present"] == own
    assert zone["margin"] == pytest.approx(own - lower, rel=1e-9)
    rpm = next(p for p in zone["lower"]["physical"] if p["unit"] == "rpm")
    assert rpm["value"] == pytest.approx(3600 * 0.9725 / 0.9424154746983821, abs=0.001)
    assert (tmp_path / "zones.nc").exists()


def test_zones_in_words(gearlash: Gearlash):
    out = gearlash("zones", "article", "--over", "omega=0.95:1.06:12").out
    first = " ".join(out.partition("\n\n")[0].split())
    assert first == (
        "omega = 1.04713 lies in a zone free of impacts for every attractor found: omega from 0.9725 to "
        "1.06; teeth begin to separate (grazing) at omega = 0.9725, 0.0746 (7.1 %) below"
    )
    assert "Free of impacts on the back side, every attractor found: omega from 0.95 to 1.06" in out
    assert "grazing, 1-0-0 inside, 1-1-0 outside" in out
    flat = " ".join(out.split())
    assert "Every periodic motion was followed along its whole branch (1 in all)" in flat
    assert "one to which none of these starts leads, such as one that lives within 0.01 between two" in flat
    assert "1-0-0 stable from 0.9725 (grazing) to 1.06 (limit of the scan)" in flat
    assert "its branch exists from 0.95 (limit of the scan) to 1.06 (limit of the scan)" in flat


@pytest.mark.parametrize("count", [5, 15, 41])
def test_the_present_speed_comes_first_however_coarse_the_axis(gearlash: Gearlash, count: int):
    """Between 3872 and 4114 rpm contact is lost, though both neighbours of 15 points are quiet."""
    ran = gearlash("zones", DRIVE, "--over", f"pinion_speed=1000rpm:6000rpm:{count}", "--json")
    answer = ran.answer
    assert answer["sentence"].startswith(
        "4200 rpm lies in a zone free of impacts for every attractor found: 4114.1 to 6000 rpm †; teeth "
        "begin to separate (grazing) at 4114.1 rpm, 85.9 rpm (2.0 %) below"
    )
    assert answer["asked"]["unit"] == "rpm"
    free = [z for z in answer["zones"] if z["kind"] == "impact-free"]
    middle = 4000.0 / 4200.0 * answer["present"]
    assert not any(z["lower"]["value"] < middle < z["upper"]["value"] for z in free)
    held = next(z for z in free if z["margin"] is not None)
    assert held["margin_asked"] == pytest.approx(85.9, abs=0.1)
    below = held["margin_below"]
    assert (held["margin_above"], below["event"]) == (None, "teeth begin to separate (grazing)")
    assert below["asked"] == pytest.approx(85.92, abs=0.01)
    assert below["percent"] == pytest.approx(100.0 * 85.92 / 4200.0, abs=1e-3)
    rpm = next(each for each in below["physical"] if each["unit"] == "rpm")
    assert rpm["value"] == pytest.approx(below["asked"], rel=1e-12)
    point = held["lower"]["point"]
    assert {point["label_before"], point["label_after"]} == {"1-0-0", "1-1-0"}
    assert (point["unstable_before"], point["unstable_after"]) == (0, 0)


def test_what_was_typed_in_other_units_is_told_in_them(gearlash: Gearlash):
    for over, start, margin in (
        ("pinion_speed=100rad/s:600rad/s:9", "439.823 rad/s lies in a zone", "rad/s (2.0 %) below"),
        ("backlash=0.02mm:0.2mm:5", "0.08 mm lies in a zone", "no end of it was met within the range"),
        (
            "torque=10Nm:300Nm:5",
            "150 Nm lies in a zone",
            "separate (grazing) at 92.19 Nm, 57.81 Nm (38 %) below",
        ),
        ("omega=0.2:0.9:9", "omega = 0.548539 lies in a zone", "0.0111 (2.0 %) below"),
    ):
        options = ("--over", over, "--kind", "impact-free", "--json")
        sentence = gearlash("zones", DRIVE, *options).answer["sentence"]
        assert sentence.startswith(start)
        assert margin in sentence


def test_a_typed_end_rests_on_nothing_and_a_computed_one_does(gearlash: Gearlash):
    answer = gearlash("zones", DRIVE, "--over", "pinion_speed=4000rpm:5000rpm:5", "--json").answer
    zone = next(z for z in answer["zones"] if z["margin"] is not None)
    for end, rests in (("lower", True), ("upper", False)):
        rpm = next(p for p in zone[end]["physical"] if p["unit"] == "rpm")
        assert bool(rpm["rests_on"]) is rests


def test_one_edge_is_one_number_in_run_and_zones(gearlash: Gearlash):
    run = gearlash("run", DRIVE, "--json").answer["sentence"]
    ran = gearlash("zones", DRIVE, "--over", "pinion_speed=3900rpm:5000rpm:5")
    assert "impact-free from 4114.1 rpm †" in run
    assert " ".join(ran.out.split()).count("4114.1 to 5000 rpm") == 2
    assert "4114.1 rpm †" in ran.out


def test_zones_of_points_that_fail_are_not_ok(gearlash: Gearlash):
    ran = gearlash("zones", str(CASES / "narrow.toml"), "--over", "gap=-3:1:2", "--json")
    assert ran.code == 3
    assert ran.answer["status"] == "partly-failed"
    assert "3 of 6 points failed, the first: gap = -3, not a valid system" in ran.answer["sentence"]
    assert sum(ran.answer["statuses"].values()) == 6


def test_out_has_zones_and_not_a_sweep_again(gearlash: Gearlash, tmp_path: Path):
    over = ("--over", "omega=0.95:1.06:12")
    zones = gearlash("zones", "article", *over, "--json", "--out", str(tmp_path / "zones"))
    gearlash("sweep", "article", *over, "--out", str(tmp_path / "sweep"))
    figure = (tmp_path / "zones" / "zones.svg").read_bytes()
    assert figure.startswith(b"<?xml")
    assert figure != (tmp_path / "sweep" / "sweep.svg").read_bytes()
    assert (tmp_path / "zones" / "zones.pdf").read_bytes().startswith(b"%PDF")
    assert json.loads((tmp_path / "zones" / "zones.json").read_text(encoding="utf-8")) == zones.answer
    assert gl.load_dataset(tmp_path / "zones" / "zones.nc").attrs["complete"] == 1


TOUCH = EndPoint("grazing", "loss of contact on the drive side (minimum of X in S1)", "1-1-0", "1-0-0", 0, 0)


def zone(
    low: float, high: float, every: bool = True, kind: str = "impact-free", here: float = 0.0
) -> ZoneFound:
    """In thousands of revolutions per minute; both ends are grazings but those at 1 and 9."""
    (lower, below), (upper, above) = (_end_and_margin(v, low <= here <= high, here) for v in (low, high))
    return ZoneFound(kind, every, lower, upper, None, None, (), below, above)  # pyright: ignore[reportArgumentType]


def _end_and_margin(v: float, inside: bool, here: float) -> tuple[ZoneEnd, MarginFound | None]:
    limit = v in (1.0, 9.0)
    what, point = ("end of the range", None) if limit else ("grazing", TOUCH)
    end = ZoneEnd(v, 0.0, (), what, not limit, "1-0-0", "1-1-0", "up", point)
    if limit or not inside:
        return end, None
    apart = abs(v - here)
    return end, MarginFound(apart, 1e3 * apart, (), 100.0 * apart / here, event(end, True))


@pytest.mark.parametrize(
    ("here", "zones", "words"),
    [
        (
            2.0,
            [zone(1.0, 3.0, here=2.0), zone(5.0, 6.0)],
            "2000 rpm lies in a zone free of impacts for every attractor found: 1000 to 3000 rpm; teeth "
            "begin to separate (grazing) at 3000 rpm, 1000 rpm (50 %) above; other zone free of impacts for "
            "every attractor found: 5000 to 6000 rpm",
        ),
        (
            4.0,
            [zone(1.0, 3.0), zone(4.5, 6.0)],
            "4000 rpm lies in no zone that was found; nearest zone free of impacts for every attractor "
            "found: 4500 to 6000 rpm, 500 rpm above; others: 1000 to 3000 rpm",
        ),
        (
            4.0,
            [zone(3.0, 5.0, every=False, here=4.0)],
            "4000 rpm lies in a zone free of impacts for at least one attractor found, but not everywhere "
            "for all: 3000 to 5000 rpm; what is not quiet was found elsewhere in it; teeth begin to separate "
            "(grazing) at 3000 rpm, 1000 rpm (25 %) below; teeth begin to separate (grazing) at 5000 rpm, "
            "1000 rpm (25 %) above; no interval was found in which every attractor found is free of impacts",
        ),
        (
            4.0,
            [zone(3.0, 5.0, every=False, here=4.0), zone(1.0, 9.0, kind="drive-side-only", here=4.0)],
            "4000 rpm lies in a zone free of impacts for at least one attractor found, but not everywhere "
            "for all: 3000 to 5000 rpm; what is not quiet was found elsewhere in it; teeth begin to separate "
            "(grazing) at 3000 rpm, 1000 rpm (25 %) below; teeth begin to separate (grazing) at 5000 rpm, "
            "1000 rpm (25 %) above; no interval was found in which every attractor found is free of impacts",
        ),
        (
            4.0,
            [zone(1.0, 9.0, kind="drive-side-only")],
            "4000 rpm lies in no zone free of impacts that was found, only in one free of impacts on the "
            "back side for every attractor found: 1000 to 9000 rpm; no end of it was met within the range; "
            "no interval was found in which every attractor found is free of impacts",
        ),
        (
            4.0,
            [zone(1.0, 9.0, kind="drive-side-only"), zone(5.0, 6.0)],
            "4000 rpm lies in no zone free of impacts that was found, only in one free of impacts on the "
            "back side for every attractor found: 1000 to 9000 rpm; no end of it was met within the range; "
            "nearest zone free of impacts for every attractor found: 5000 to 6000 rpm, 1000 rpm above",
        ),
        (
            12.0,
            [zone(1.0, 9.0)],
            "12000 rpm lies outside the range that was examined, 1000 to 9000 rpm; nearest zone free of "
            "impacts for every attractor found: 1000 to 9000 rpm, 3000 rpm below",
        ),
        (
            4.0,
            [],
            "4000 rpm lies in no zone that was found; no interval was found in which every attractor found "
            "is free of impacts",
        ),
    ],
)
def test_headlines(here: float, zones: list[ZoneFound], words: str):
    assert headline(RPM, (1.0, 9.0), here, zones) == words


def test_a_zone_of_the_kind_that_was_asked_for_comes_alone():
    words = headline(RPM, (1.0, 9.0), 4.0, [zone(1.0, 9.0, kind="drive-side-only")], ["drive-side-only"])
    assert words == (
        "4000 rpm lies in a zone free of impacts on the back side for every attractor found: 1000 to 9000 "
        "rpm; no end of it was met within the range"
    )


def test_what_has_impacts_at_the_present_value_of_a_zone_is_named():
    stay = Stay(3.5, 6.0, "fold", "grazing")
    loud = Resident("1-1-0", ("down",), 3.5, 6.0, False, True, stay)
    one = replace(zone(3.0, 5.0, every=False, here=4.0), residents=(loud,))
    assert "; at this value 1-1-0 was found as well, which is not; " in headline(RPM, (1.0, 9.0), 4.0, [one])
    away = replace(one, residents=(replace(loud, stable=Stay(4.5, 6.0, "fold", "grazing")),))
    assert "1-1-0 was found as well" not in headline(RPM, (1.0, 9.0), 4.0, [away])


def test_an_end_that_was_halved_is_shown_where_motion_was_last_seen_to_be_quiet():
    low, high = (ZoneEnd(v, 0.01, (), "jump", False, "1-0-0", "1-1-0", "up") for v in (1.0, 3.0))
    below, above = (MarginFound(0.99, 990.0, (), 49.5, event(end, True)) for end in (low, high))
    one = ZoneFound("impact-free", True, low, high, None, None, (), below, above)
    words = headline(RPM, (0.5, 9.0), 2.0, [one])
    assert "1010 to 2990 rpm; its end lies (jump) at 1010 rpm, 990 rpm (49 %) below" in words
    assert "lies in no zone" in headline(RPM, (0.5, 9.0), 2.995, [one])


@pytest.mark.parametrize(
    ("value", "shown"), [(357.142, "358"), (1750.0, "1750"), (0.05, "0.05"), (0.0090909, "0.0091")]
)
def test_what_may_have_been_missed_is_rounded_up(value: float, shown: str):
    assert at_least(value, 3) == shown


STOP = ("--over", "gap=2:3:2")


def test_a_system_without_a_back_side_is_not_asked_for_it(gearlash: Gearlash):
    """Every motion is free of impacts on a side that is not there: that says nothing."""
    answer = gearlash("zones", "shaw-holmes", *STOP, "--json").answer
    assert {zone["kind"] for zone in answer["zones"]} == {"impact-free"}
    ran = gearlash("zones", "shaw-holmes", *STOP, "--kind", "drive-side-only")
    assert ran.code == 2
    assert "no clearance of this system has a back side that acts" in ran.complaint


def test_the_state_that_was_given_is_no_cold_start(gearlash: Gearlash):
    ran = gearlash("zones", "shaw-holmes", *STOP, "--initial", "x=0.1")
    assert "From the state that was given at every value, up and down sweeps" in " ".join(ran.out.split())
