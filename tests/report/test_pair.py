"""The report of a pair: K_v by hand, noise without impacts, what does not matter, bands between zones."""

from __future__ import annotations

import re
from dataclasses import fields, replace
from itertools import pairwise
from math import atan, cos, radians, sin, sqrt, tan
from pathlib import Path
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
import xarray as xr

import gearlash as gl
from gearlash.case import loads
from gearlash.case.rating import band_of_grades, grades_of, method_b, pair_of
from gearlash.cli.answers.report import ReportPart, report_answer
from gearlash.gears import flank_tolerances, mesh_stiffness
from gearlash.orbits import motion_statistics
from gearlash.orbits.signals import Signal
from gearlash.report.blocks import Marked, Table
from gearlash.report.pair import Contents, document, speed
from gearlash.report.pair.maps import other_torques
from gearlash.report.pair.noise import backlash_matters, loudest, not_quiet, unloaded
from gearlash.report.pair.orders import exciting, meetings, meetings_within, natural_frequencies
from gearlash.report.pair.ranges import speed_ends
from gearlash.report.pair.stated import in_brief, of_either, pair_tables
from gearlash.report.pair.verdict import Verdict, verdict
from gearlash.report.pair.words import Words
from gearlash.results import NO_LABEL, Axis
from gearlash.results.impact_free import ImpactFree
from gearlash.results.pair_question import carrying_forwards, speeds_around
from gearlash.results.pair_units import PairUnits
from gearlash.results.tolerance import LIMITS_OF_CASE, ToleranceInput
from gearlash.studies.assessment import Assessment, assess
from gearlash.studies.bands import Band, back_bands, bands
from gearlash.studies.ranges import AcrossRanges, Corner, Varied
from gearlash.studies.speed_run import SpeedRun, speed_run, with_modes
from gearlash.studies.speeds_across import SpeedsAcross
from gearlash.studies.tolerances.inputs import ranged_inputs
from gearlash.studies.worst_of_ranges import margin_of
from gearlash.studies.zone_end import Interval, ZoneEnd

CASES = Path(__file__).resolve().parents[1] / "cases"


def line_of(said: Verdict, title: str) -> str:
    """The line of a verdict with this title."""
    return next(line.text for line in said.lines if line.title == title)


def test_k_v_of_the_standard_by_hand():
    """Clause 6.5 of ISO 6336-1 for drive.toml at 4200 rpm, grade 6, written out in numbers."""
    case, grade = gl.load_case(CASES / "drive.toml"), 6
    m, z, beta, alpha, b = 3e-3, (25, 57), radians(15.0), radians(20.0), 40e-3
    alpha_t = atan(tan(alpha) / cos(beta))
    r = [m * n / (2.0 * cos(beta)) for n in z]
    base = [x * cos(alpha_t) for x in r]
    inertia = [mass * x * x / 2.0 for mass, x in zip((2.6, 8.5), r, strict=True)]
    reduced = 1.0 / sum(x * x / j for x, j in zip(base, inertia, strict=True)) / b
    pair = pair_of(case)
    load = 150.0 / r[0] / b
    assert load < 100e3  # where c′ is smaller by (w/100)^¼
    mesh = mesh_stiffness.method_b(pair, line_load=load)
    n = 4200.0 * np.pi / 30.0 * z[0] / sqrt(mesh.mean / reduced)
    worst = [flank_tolerances.flank_tolerances(gear, grade, b) for gear in pair.gears]
    pitch = cos(alpha_t) * max(one.single_pitch for one in worst)
    form = max(one.profile_form for one in worst)
    steady = 0.925 * mesh.single / load
    ratio = pair.total_contact_ratio
    c2, c3 = 0.57 / (ratio - 0.3), 0.096 / (ratio - 1.56)
    k_v = 1.0 + n * (0.32 * steady * pitch + c2 * steady * form + c3)
    found = method_b(case, case.family()[0].defaults["omega"], (grade, grade))
    assert found.resonance_ratio == pytest.approx(n, rel=1e-9)
    assert found.value == pytest.approx(k_v, rel=1e-9)
    assert sin(beta) * b / (np.pi * m) == pytest.approx(pair.overlap_ratio, rel=1e-9)


def test_grades_are_those_of_the_drawing_and_else_a_range():
    drawn, bare = gl.load_case(CASES / "drawing.toml"), gl.load_case(CASES / "drive.toml")
    assert grades_of(drawn).own == (7, 7)
    assert "for grade 7 of ISO 1328-1, assumed for the gear" in band_of_grades(drawn, 0.3)
    assert "the case states no grade" in band_of_grades(bare, 0.5)
    assert "does not stand beside it" in band_of_grades(gl.load_case("kahraman-singh"), 0.5)


def test_k_v_of_the_standard_has_the_stiffness_of_the_materials_and_is_for_metals():
    drawn = gl.load_case(CASES / "drawing.toml")
    bronze = drawn.with_overrides({"gear.material": "tin-bronze"})
    steel, soft = (method_b(case, 0.3, (7, 7)).resonance_ratio for case in (drawn, bronze))
    # N goes with the root of the reduced mass over the stiffness; both are of the material
    mass = [gl.gears.equivalent_mass(c.numbers.body.geometry.base_radii, c.numbers.body.inertias)
            for c in (drawn, bronze)]  # fmt: skip
    speed = [float(c.scales.pinion_speed(0.3)) for c in (drawn, bronze)]
    modulus = 2.0 * 103.0 / (206.0 + 103.0)
    expected = steel * speed[1] / speed[0] * sqrt(mass[1] / mass[0] / modulus)
    assert soft == pytest.approx(expected, rel=1e-9)
    said = band_of_grades(drawn.with_overrides({"gear.material": "POM"}), 0.3)
    assert said.startswith("K_v of ISO 6336-1 does not stand beside it")
    assert "for metals" in said
    assert "POM" in said


@pytest.fixture(scope="module")
def window() -> tuple[Assessment, SpeedRun]:
    """The article's pair around its window without impacts."""
    case = gl.load_case("article")
    low, high = (float(case.scales.omega_from_rpm(rpm)) for rpm in (3500.0, 4400.0))
    axis = Axis.even("omega", low, high, 10)
    return assess(case, axis), speed_run(case, axis)


def test_what_no_motion_tells_stands_in_the_answer_too(window: tuple[Assessment, SpeedRun]):
    """A reader of bands alone would take the rest for quiet."""
    found = replace(window[0])
    assert report_answer(found).not_told == ()
    vars(found)["not_told"] = (Interval(ZoneEnd(0.95, "fold"), ZoneEnd(0.96, "seen")),)
    assert report_answer(found).not_told == (ReportPart(0.95, 0.96),)


def test_what_no_motion_tells_is_drawn_in_the_panels_over_speed(window: tuple[Assessment, SpeedRun]):
    found = replace(window[0])
    vars(found)["not_told"] = (Interval(ZoneEnd(0.95, "fold"), ZoneEnd(0.96, "seen")),)
    _, pictures = document(Contents(found, window[1], ()))
    axes = [one.arguments[0] for one in pictures if one.stem in ("speed-forces", "speed-errors")]
    expected = [float(found.case.scales.pinion_rpm(omega)) for omega in (0.95, 0.96)]
    assert len(axes) == 2
    for axis in axes:
        assert axis.not_told == (pytest.approx(expected),)


@pytest.mark.parametrize(
    ("codes", "said"),
    [
        ((0, 0, 0, 0, 0), "Teeth stay in contact at all of 5 torques from 10 N·m to 50 N·m, "),
        ((0, 1, 1, 0, -1), ": 1-1 at 20 N·m to 30 N·m; nothing settled at 50 N·m; at the others teeth stay"),
        ((1, 1, 1, 1, 1), ": 1-1 at 10 N·m to 50 N·m."),
    ],
)
def test_what_other_torques_do_at_the_present_speed(
    window: tuple[Assessment, SpeedRun], codes: tuple[int, ...], said: str
):
    """The column of the map that is nearest; the others, which hold the other label, are not asked."""
    found, run = window
    loads = [float(found.case.scales.load_from_torque(torque)) for torque in (10, 20, 30, 40, 50)]
    label = np.ones((2, 5), dtype=np.int64)
    label[1] = [NO_LABEL if code < 0 else code for code in codes]
    plane = xr.Dataset(
        {"label": (("omega", "load"), label)},
        {"omega": [0.9 * found.here, 1.01 * found.here], "load": loads, "label_name": ["1-0-0", "1-1-0"]},
    )
    text = other_torques(Contents(found, run, (), {"load": plane}))
    assert said in text
    assert f"{float(found.case.scales.pinion_rpm(1.01 * found.here)):.4g} rpm, from the cold start" in text
    assert other_torques(Contents(found, run, ())) == ""


def test_which_part_of_the_force_across_a_shaft_bearings_carry(window: tuple[Assessment, SpeedRun]):
    """By hand: the mean lateral force is F_wt along the tangent of the pitch circles, and along the line of
    action F_bt = F_wt / cos α_wt; the page says which of them it is."""
    case, told = window[0].case, []
    tangent = atan(tan(radians(20.0)) / cos(radians(18.0)))  # α_wt of the article's pair: no profile shift
    for axis in ("pitch-tangent", "line-of-action"):
        turned = case.with_overrides({"model.y_axis": axis})
        run = speed_run(turned, Axis.even("omega", 0.9 * window[0].here, window[0].here, 2))
        contents = Contents(replace(window[0], case=turned), run, ())
        tables = (block for block in speed.section(contents, "")[0].blocks if isinstance(block, Table))
        caption = next(table.caption for table in tables if table.id == "table-bearings")
        assert ("what pushes the shafts apart is not in them" in caption) == (axis == "pitch-tangent")
        assert ("all of the force across a shaft" in caption) == (axis == "line-of-action")
        told.append(abs(run.column(0, "bearing_force_yp.mean")[0]))
    assert told[0] / told[1] == pytest.approx(cos(tangent), rel=1e-9)


def test_factors_alone_do_not_say_which_way_bearings_give():
    """A model in numbers has no directions of a drawing: the page names no `model.y_axis` that it has not."""
    whole = gl.load_case("article")
    pair, numbers = whole.numbers.pair, whole.family()[0].defaults
    lines = [f"{name} = {value!r}" for name, value in numbers.items() if not name.startswith("bearing_")]
    lines += [f"{one}_factor = {getattr(pair, f'{one}_factor')!r}" for one in "yz"]
    lines += [f"mass_ratio_{gear} = {ratio!r}" for gear, ratio in zip("pg", pair.mass_ratios, strict=True)]
    bearings = zip(("yp", "zp", "yg", "zg"), pair.bearing_frequencies, strict=True)
    lines += [f"bearing_frequency_{name} = {value!r}" for name, value in bearings]
    lines.append(f"bearing_damping = {numbers['bearing_damping_yp']!r}")
    case = loads('kind = "helical-pair"\n[dimensionless]\n' + "\n".join(lines))
    axis = Axis.even("omega", 0.9, 0.95, 2)
    contents = Contents(assess(case, axis), speed_run(case, axis), ())
    tables = (block for block in speed.section(contents, "")[0].blocks if isinstance(block, Table))
    caption = next(table.caption for table in tables if table.id == "table-bearings")
    assert caption == "Peaks of bearing forces over these speeds."


def test_impact_free_is_not_quiet_and_the_report_says_so(window: tuple[Assessment, SpeedRun]):
    found, run = window
    units = PairUnits.of(found.case)
    words = Words(units, found.here)
    said = not_quiet(run, units, words)
    assert said.startswith("Impact-free is not quiet: without any impact the bearing force, pinion, lateral")
    pinion = loudest(run)[0]
    assert pinion.quiet is not None
    assert pinion.quiet[0] > 5.0 * pinion.mean
    mode = unloaded(run, units, words)
    rpm = float(units.speed.factor * found.case.numbers.pair.bearing_frequencies[0])
    assert f"(pinion, lateral) lies at {rpm:.5g} rpm" in mode
    at = next(one for point, one in run.measured() if units.speed.factor * point.value == pytest.approx(rpm))
    assert at.share_without_contact == 0.0
    assert at.read[0].peak_to_peak > 5.0 * at.force.peak_to_peak


def test_impact_free_is_not_quiet_in_whatever_direction_it_is_so(window: tuple[Assessment, SpeedRun]):
    """The sentence takes the direction that is worse without impacts, though another one carries more."""
    found, run = window
    units = PairUnits.of(found.case)
    words = Words(units, found.here)
    order = {readout.name: i for i, readout in enumerate(run.readouts)}
    low, high = order["bearing_force_yp"], order["bearing_force_yg"]

    def changed(quiet: float, hitting: float) -> SpeedRun:
        """The lateral forces of the gear times a factor, those of the pinion without impacts small."""
        rows = []
        for way, row in zip(run.sweeps, run.signals, strict=True):
            rows.append(tuple(
                None if one is None else replace(one, read=tuple(
                    _times(each, (quiet if p.impact_free else hitting) if i == high
                           else (1e-3 if p.impact_free else 1.0) if i == low else 1e-6)
                    for i, each in enumerate(one.read)))
                for p, one in zip(way.points, row, strict=True)))  # fmt: skip
        return replace(run, signals=tuple(rows))

    said = not_quiet(changed(1.0, 1e-3), units, words)
    assert said.startswith("Impact-free is not quiet: without any impact the bearing force, gear, lateral")
    assert "more than in the same direction wherever teeth separate" in said
    assert not_quiet(changed(1e-3, 1.0), units, words).startswith("Without impacts the bearing force")


def _times(signal: Signal, factor: float) -> Signal:
    return replace(
        signal, **{f.name: factor * getattr(signal, f.name) for f in fields(signal) if f.type == "float"}
    )


def test_backlash_does_not_matter_where_the_back_side_is_not_met(window: tuple[Assessment, SpeedRun]):
    found, run = window
    said = backlash_matters(found, run, PairUnits.of(found.case))
    assert said.startswith("The backlash does not matter for the motions found: none reaches the back side")
    wider = speed_run(found.case.with_overrides({"backlash": "160 um"}), run.axis)
    scale = wider.case.scales.force_N(1.0) / found.case.scales.force_N(1.0)
    for way in (0, 1):
        own, other = (each.column(way, "force.rms") for each in (run, wider))
        periodic = [p.periodic and p.period == 1 for p in run.sweeps[way].points]
        assert scale * other[periodic] == pytest.approx(own[periodic], rel=1e-6)


def test_bands_fill_what_zones_leave(window: tuple[Assessment, SpeedRun]):
    found, _ = window
    first, last = float(found.axis.values[0]), float(found.axis.values[-1])
    rows = sorted(
        [(z.lower.value, z.upper.value) for z in found.impact_free.zones]
        + [(b.lower.value, b.upper.value) for b in bands(found.impact_free)]
    )
    assert rows[0][0] == first
    assert rows[-1][1] == last
    assert all(a[1] == b[0] for a, b in pairwise(rows))
    beside = [band for band in found.separating if not band.every]
    assert beside  # above the fold at 4170 rpm a motion with impacts lives beside the quiet one
    assert all(zone.quiet == "impact-free" for zone in found.impact_free.zones)
    assert back_bands(found.drive_side, -1.0) == ()


def test_bands_name_motions_that_live_between_the_speeds_that_were_swept(
    window: tuple[Assessment, SpeedRun],
):
    """What a coarse axis steps over is named all the same, as it was followed there. A fine axis sees it."""
    found, _ = window
    low, high = (float(found.axis.values[i]) for i in (0, -1))
    coarse = gl.zones(found.case, Axis.even("omega", low, high, 4))
    assert "1-1-0" not in {str(point.label) for sweep in coarse.sweeps for point in sweep.points}
    fine = gl.sweep(found.case, Axis.even("omega", low, high, 31), direction="up")
    for band in bands(coarse):
        labels = {p.label for p in fine.points if band.contains(p.value) and not p.impact_free}
        periodic = {label for label in labels if isinstance(label, gl.Signature)}
        assert periodic <= set(band.labels)
    assert "1-1-0" in map(str, bands(coarse)[0].labels)


def test_speeds_of_bearing_modes_are_among_those_measured():
    case = gl.load_case("article")
    modes = case.numbers.pair.bearing_frequencies
    values = with_modes(case, speeds_around(case, 5)).values
    assert len(values) == 5 + sum(values[0] < mode < values[-1] for mode in modes)
    assert all(mode in values for mode in modes if values[0] < mode < values[-1])


def test_the_range_of_speed_that_a_case_states_is_examined_and_judged(window: tuple[Assessment, SpeedRun]):
    found, _ = window
    case = found.case

    def over_its_range(least: float, greatest: float) -> str:
        stated = {"operation.least_speed": f"{least} rpm", "operation.greatest_speed": f"{greatest} rpm"}
        ranged = case.with_overrides(stated)
        speeds = ranged.scales.pinion_rpm(speeds_around(ranged, 5).values)
        assert speeds == pytest.approx(np.linspace(least, greatest, 5))
        said = {line.title: line.text for line in verdict(replace(found, case=ranged)).lines}
        return said["Over its speed range"]

    zone = next(z for z in found.impact_free.zones if z.lower.value < found.here < z.upper.value)
    low, high = (float(case.scales.pinion_rpm(end.value)) for end in (zone.lower, zone.upper))
    assert over_its_range(low + 1, high - 1).endswith("no motion was found in which teeth separate.")
    below = over_its_range(low - 60, high - 1)
    assert below.startswith("Not at every speed from")
    assert "teeth separate at" in below
    first, last = (float(case.scales.pinion_rpm(found.axis.values[i])) for i in (0, -1))
    if high < last - 1:
        assert over_its_range(high + 1, last + 500).startswith("Not at every speed from")
    assert first < low
    assert all(line.title != "Over its speed range" for line in verdict(found).lines)


def _ranges(margin: float, *varied: Varied, together: float | None = None) -> AcrossRanges:
    single = tuple(Corner({v.input.path: v.input.text(v.worst)}, v.margin) for v in varied)
    both = {key: value for one in single for key, value in one.values.items()}
    last = None if together is None else Corner(both, together)
    return AcrossRanges(margin, varied, single, last)


def test_a_verdict_must_hold_across_the_ranges_of_estimates(window: tuple[Assessment, SpeedRun]):
    found = window[0]
    error = ToleranceInput("mesh.error", "um", 0.0, 16.3, 5.0)
    mass = ToleranceInput("gear.mass", "kg", 6.0, 7.0, 6.5)
    harmless, harmful = Varied(mass, (), 7.0, 0.5), Varied(error, ((11.234, 16.3),), 16.3, -0.2)

    def said(ranges: AcrossRanges) -> tuple[str, str, str]:
        told = verdict(replace(found, ranges=ranges))
        lines = {line.title: line.text for line in told.lines}
        return told.kind, lines["May it run there"], lines["Across its ranges"]

    kind, first, line = said(_ranges(0.6, harmless, Varied(error, (), 16.3, 0.4), together=0.3))
    assert kind == "good"
    assert "the teeth stay in contact; there the least mesh force over a cycle is 40.9 % of the" in first
    assert first.endswith("a motion without impacts exists there across the ranges of its 2 estimates.")
    assert "30 % of the static one (60 % as estimated)" in line
    kind, first, line = said(_ranges(0.6, harmless, harmful, together=-0.3))
    assert kind == "doubt"
    assert first.endswith("no motion without impacts exists if mesh.error is above 11.2 µm.")
    assert "mesh.error is above 11.2 µm (its range: 0 to 16.3 µm)" in line
    assert "holds across the ranges of the other 1 estimate, one at a time" in line
    kind, first, line = said(_ranges(0.6, harmless, Varied(error, (), 16.3, 0.4), together=-0.1))
    assert kind == "doubt"
    assert "not for all together: with gear.mass = 7 kg, mesh.error = 16.3 µm" in line
    kind, first, line = said(_ranges(-0.1, replace(harmful, broken=((4.0, 16.3),))))
    assert "a motion without impacts exists if mesh.error is below 4 µm" in line
    assert "no value of this case is an estimate" in line_of(verdict(found), "Across its ranges").lower()


def test_stated_limits_are_ranges_of_the_verdict_and_named(window: tuple[Assessment, SpeedRun]):
    error = ToleranceInput("mesh.error", "um", 0.0, 16.3, 5.0)
    load = ToleranceInput("operation.torque", "N*m", 50.0, 250.0, 150.0, LIMITS_OF_CASE)
    harmless, harmful = Varied(error, (), 16.3, 0.5), Varied(load, ((50.0, 61.234),), 50.0, -0.2)
    case = window[0].case.with_overrides({"torque": "150 N m +100/-100", "backlash": "60 to 100 um"})
    found = replace(window[0], case=case)

    def said(ranges: AcrossRanges) -> tuple[str, dict[str, str]]:
        told = verdict(replace(found, ranges=ranges))
        return told.short, {line.title: line.text for line in told.lines}

    short, lines = said(_ranges(0.6, harmless, harmful, together=-0.3))
    assert short == "not across the ranges of its estimates and stated limits"
    assert lines["May it run there"].endswith("exists if operation.torque is below 61.2 N·m.")
    assert (
        "all else as the case has it. It holds across the ranges of the other 1 estimate,"
        in lines["Across its ranges"]
    )
    assert "mesh.backlash 60 to 100 µm, here 80 µm, the middle of its limits; " in lines["Stated limits"]
    assert "operation.torque 50 to 250 N·m, here 150 N·m. Where nothing is" in lines["Stated limits"]
    short, lines = said(_ranges(0.6, replace(harmful, broken=(), margin=0.3), harmless, together=0.2))
    assert "across the ranges of its 1 estimate and 1 value with stated limits." in lines["May it run there"]
    short, lines = said(_ranges(0.6, harmful, together=-0.3))
    assert short == "not across the ranges of its stated limits"


def test_where_the_back_side_carries_the_mirror_image_is_examined():
    """It moves alike: the same bands, forces and labels with both sides exchanged."""
    case = gl.load_case(CASES / "drive.toml")
    low, high = (float(case.scales.omega_from_rpm(rpm)) for rpm in (3900.0, 4300.0))
    found = assess(case.with_overrides({"torque": "-150 N m"}), Axis.even("omega", low, high, 3))
    back = case.with_overrides({"torque": "-150 N m"})
    family = back.family()[0]
    own = motion_statistics(gl.attractor(family.system(), family.start())).force
    assert found.turned
    assert found.signals is not None
    seen = found.signals.force.most, found.signals.force.least
    assert seen == pytest.approx((-own.minimum, -own.maximum), abs=1e-8)  # what signals promise of peaks
    lines = {line.title: line.text for line in verdict(found).lines}
    assert lines["May it run there"].startswith("At 4200 rpm and -150 N·m")
    assert "the side that carries is called the drive side" in lines["Turned round"]
    with pytest.raises(gl.GearlashError, match="needs both sides alike"):
        carrying_forwards(back.with_overrides({"back_stiffness": 0.9}))
    assert carrying_forwards(case) is case


def test_an_estimated_error_keeps_its_range_in_the_mirror_image():
    case = gl.load_case(CASES / "drawing.toml", {"torque": "-150 N m"})
    mirrored = carrying_forwards(case)
    (error,) = (value for value in mirrored.values() if value.path == "mesh.error")
    assert error.least is not None
    one, other = (each.family()[0].complete({}) for each in (case, mirrored))
    assert abs(one["error_phase"] - other["error_phase"]) == pytest.approx(np.pi)
    assert other["load"] > 0.0


@pytest.mark.parametrize(
    ("name", "stated"),
    [
        ("drawing.toml", {"torque": "-15 N m"}),  # below 100 N/mm, where estimates depend on it
        ("drawing.toml", {"torque": "-15 N m", "pinion.tip_relief": "12 um", "gear.crowning": "4 um"}),
        ("drawing.toml", {"gear_torque": "-40 N m"}),
        ("drawing.toml", {"power": "-5 kW", "pinion_speed": "4200 rpm"}),
        ("spurs.toml", {"torque": "-3 N m"}),
        ("drive.toml", {"torque": "-15 N m", "error_2": "2 um"}),
    ],
)
def test_the_mirror_image_is_the_same_pair_at_the_same_torque_turned_round(name: str, stated: dict[str, str]):
    case = gl.load_case(CASES / name, stated)
    mirrored = carrying_forwards(case)
    assert mirrored.scales == case.scales
    one, other = ({v.path: v.value for v in each.values()} for each in (case, mirrored))
    assert {path for path in set(one) ^ set(other) if "phase" not in path} == set()
    ranged = [{v.path for v in each.values() if v.estimated} for each in (case, mirrored)]
    assert ranged[0] == ranged[1]
    size = {path: abs(x) for path, x in one.items() if isinstance(x, float) and "error_phase" not in path}
    assert size == pytest.approx({path: abs(float(other[path])) for path in size}, rel=1e-9)
    back, front = (each.family()[0].system() for each in (case, mirrored))
    assert back.forcing == pytest.approx(-front.forcing, rel=1e-12, abs=1e-15)
    assert (back.matrix == front.matrix).all()
    for one_side, other_side in zip(back.clearances, front.clearances, strict=True):
        assert one_side.gap_plus == one_side.gap_minus == other_side.gap_plus == other_side.gap_minus
        assert one_side.stiffness_plus == pytest.approx(other_side.stiffness_minus, rel=1e-12)


def test_an_assumed_range_of_the_torque_is_turned_round():
    torque = {
        "value": "-150 N*m",
        "range": ["-200 N*m", "-15 N*m"],
        "provenance": "assumed",
        "reason": "guess",
    }
    case = gl.load_case(CASES / "drive.toml", {"operation.torque": torque})
    (found,) = (v for v in carrying_forwards(case).values() if v.path == "operation.torque")
    assert (found.least, found.value, found.greatest) == (15.0, 150.0, 200.0)
    assert (found.provenance, found.reason, found.estimated) == ("assumed", "guess", True)


@pytest.mark.parametrize(
    ("stated", "path", "ends"),
    [
        ({"torque": "-250 to -50 N m"}, "operation.torque", (50.0, 150.0, 250.0)),
        ({"gear_torque": "-300 N m ± 10 %"}, "operation.gear_torque", (270.0, 300.0, 330.0)),
        ({"power": "-50 to -30 kW"}, "operation.power", (30.0, 40.0, 50.0)),
    ],
)
def test_stated_limits_are_turned_round_in_the_mirror_image(
    stated: dict[str, str], path: str, ends: tuple[float, float, float]
):
    case = gl.load_case(
        CASES / "drive.toml", {**stated, "error": "8 ± 2 um", "mesh.error_phase": "80 to 100 deg"}
    )
    mirrored = carrying_forwards(case)
    limited = {v.path: (v.least, v.value, v.greatest) for v in mirrored.values() if v.limited}
    expected = {path: ends, "mesh.error": (6.0, 8.0, 10.0), "mesh.error_phase": (-100.0, -90.0, -80.0)}
    assert limited == {name: pytest.approx(three, rel=1e-12) for name, three in expected.items()}
    one, other = (each.family()[0].complete({}) for each in (case, mirrored))
    assert other["load"] == pytest.approx(-one["load"], rel=1e-12)


def test_assumed_limits_are_the_range_of_an_estimate():
    assumed = {"value": "8 um", "range": ["6 um", "10 um"], "provenance": "assumed", "reason": "as usual"}
    case = gl.load_case(CASES / "drive.toml", {"error": assumed, "torque": "100 to 200 N m"})
    assert [(one.path, one.of_case, one.reason) for one in ranged_inputs(case)] == [
        ("operation.torque", True, "limits of the case file"),
        ("mesh.error", False, "as usual"),
    ]


def test_without_a_torque_nothing_presses_teeth_together():
    case = gl.load_case(CASES / "drive.toml", {"torque": "-50 to 250 N m"})
    assert margin_of(case, {"operation.torque": "0.0 N*m"}) == 0.0


def test_a_motion_with_impacts_beside_the_quiet_one_is_in_the_first_sentence():
    """From rest the teeth stay in contact, and below the resonance another motion hammers."""
    case = gl.load_case("kahraman-singh", {"omega": 0.8})
    found = assess(case, Axis.even("omega", 0.7, 0.9, 5))
    assert str(found.attractor.label) == "1-0-0"
    assert found.signals is not None
    assert found.other is not None
    label, loud = found.other
    assert str(label) == "1-1-0"
    assert loud.force.most > found.signals.force.most
    told = verdict(found)
    assert told.kind == "doubt"
    assert "it depends on how the pair came there" in told.lines[0].text
    assert "one in which teeth separate (1-1), with a mesh force of up to" in told.lines[0].text


def test_the_first_sentence_names_what_was_found_at_that_speed_and_not_all_of_its_band():
    case = gl.load_case("kahraman-singh", {"omega": 0.8})
    found = assess(case, Axis.even("omega", 0.7, 0.9, 5))
    first, *rest = found.impact_free.sweeps
    points = list(first.points)
    kinds = ((gl.MotionKind.UNRESOLVED, gl.Status.UNRESOLVED), (gl.MotionKind.APERIODIC, gl.Status.UNCERTAIN))
    for i, (label, status) in enumerate(kinds, 1):  # as if the speeds 0.75 and 0.8 - 1e-3 had it
        value = points[i].value - 1e-3
        points[i] = replace(points[i], value=value, label=label, status=status, period=0)
    zones = replace(found.impact_free, sweeps=(replace(first, points=tuple(points)), *rest))
    told = replace(found, impact_free=zones)
    band = next(band for band in told.separating if band.contains(found.here))
    assert {"1-1-0", "aperiodic"} <= set(map(str, band.labels))
    assert "unresolved" not in map(str, band.labels)
    assert "one in which teeth separate (1-1)," in verdict(told).lines[0].text
    assert found.beside is not None
    alone = replace(told, beside=replace(found.beside, others=()))
    assert "one in which teeth separate (1-1)," in verdict(alone).lines[0].text  # followed to that speed


def test_what_was_not_followed_is_told_as_neither(monkeypatch: pytest.MonkeyPatch):
    """With no work allowed: sweeps and starts show no impacts, and nothing was followed."""
    monkeypatch.setattr("gearlash.studies.assessment.WORK", 1)
    case = gl.load_case("kahraman-singh", {"omega": 0.55})
    found = assess(case, Axis.even("omega", 0.5, 0.6, 3))
    told = verdict(found)
    lines = {line.title: line.text for line in told.lines}
    assert "no impacts were found: in every motion found there (1-0)" in lines["May it run there"]
    assert lines["Teeth separate"].startswith("In no motion that was found; examined: ")
    assert "Not told for omega = 0.5 to 0.6: no sweep shows impacts there, but not" in lines["Teeth separate"]
    assert lines["Margin"].startswith("Not known: the present speed lies in omega = 0.5 to 0.6, where no")


def test_what_sweeps_reach_next_to_a_speed_is_among_the_starts_there():
    case = gl.load_case("kahraman-singh", {"omega": 0.8})
    axis = Axis.even("omega", 0.7, 0.9, 5)
    found = assess(case, axis)
    family = case.family()[0]
    alone = gl.motions_beside(
        found.attractor, dict(zip(family.states, family.start(), strict=True)), family.start()
    )
    assert alone is not None
    assert found.beside is not None
    assert found.beside.starts > alone.starts


def test_estimates_at_the_ends_of_their_ranges_are_held_against_the_stated_range_of_speed(
    window: tuple[Assessment, SpeedRun],
):
    found = window[0]
    zone = next(z for z in found.impact_free.zones if z.lower.value < found.here < z.upper.value)
    low, high = (float(found.case.scales.pinion_rpm(end.value)) for end in (zone.lower, zone.upper))
    stated = {"operation.least_speed": f"{low + 1} rpm", "operation.greatest_speed": f"{high - 1} rpm"}
    ranged = replace(found, case=found.case.with_overrides(stated))
    error = ToleranceInput("mesh.error", "um", 0.0, 16.3, 5.0)
    quiet = AcrossRanges(0.6, (Varied(error, (), 16.3, 0.4),), speeds=(SpeedsAcross({}, (), 0.5),))
    apart = SpeedsAcross({"mesh.error": "16.3 um"}, ((1.0, 1.05),), -0.1)

    def told(ranges: AcrossRanges) -> tuple[str, str, str]:
        said = verdict(replace(ranged, ranges=ranges))
        return said.kind, said.lines[0].text, line_of(said, "Over its speed range")

    kind, _, line = told(quiet)
    assert kind == "good"
    assert "with each of its 1 estimate at both ends of its range" in line
    kind, first, line = told(replace(quiet, speeds=(*quiet.speeds, apart)))
    assert kind == "doubt"
    assert first.endswith("as estimated; with an estimate elsewhere in its range they do.")
    assert line.endswith("closer where teeth are pressed together least).")
    assert re.search(r"exists at \d+ to \d+\S* rpm with mesh.error = 16.3 µm; all else as estimated", line)
    narrow = {"operation.least_speed": f"{low - 60} rpm", "operation.greatest_speed": f"{high - 1} rpm"}
    said = verdict(replace(found, case=found.case.with_overrides(narrow), ranges=quiet))
    assert (said.kind, said.short) == ("doubt", "not over its range of speed")
    assert "Not at every speed from" in said.lines[0].text
    beyond = {"operation.least_speed": "29000 rpm", "operation.greatest_speed": "30000 rpm"}
    said = verdict(replace(found, case=found.case.with_overrides(beyond), ranges=quiet))
    assert (said.kind, said.short) == ("doubt", "not told over its range of speed")


def test_an_end_of_the_band_within_the_stated_range_is_told_though_another_is_nearer(
    window: tuple[Assessment, SpeedRun],
):
    """Stated from 0.9 to 2 times the present speed; the band goes from 0.85 to 1.5 times. The nearer end is
    beyond the stated range."""
    found = window[0]
    rpm = float(found.case.scales.pinion_rpm(found.here))
    stated = {"operation.least_speed": f"{0.9 * rpm} rpm", "operation.greatest_speed": f"{2.0 * rpm} rpm"}
    speeds = SimpleNamespace(here=True, lower=0.85 * found.here, upper=1.5 * found.here)
    corner = Corner({"mesh.error": "12 um"}, 0.1, cast(ImpactFree, speeds))
    words = Words(PairUnits.of(found.case), found.here)
    for case, expected in (
        (found.case, f"{0.85 * rpm:.4g}"),
        (found.case.with_overrides(stated), f"{1.5 * rpm:.4g}"),
    ):
        assessed = replace(found, case=case, ranges=AcrossRanges(0.6, (), single=(corner,)))
        assert f"ends with mesh.error = 12 µm at {expected}" in speed_ends(assessed, words)


def test_what_is_unusual_about_the_case_stands_before_what_was_computed(
    window: tuple[Assessment, SpeedRun],
):
    """The article states a stiffness that is a quarter of what the standard gives."""
    second = verdict(window[0]).lines[1]
    assert second.title == "Remarks on the case"
    assert second.text.startswith("mesh.mean_stiffness: stated 3.2e+08 N/m; ISO 6336-1:2019")
    plain = replace(window[0], case=window[0].case.with_overrides({"mesh.mean_stiffness": "1.4e9 N/m"}))
    assert verdict(plain).lines[1].title != "Remarks on the case"


def test_a_page_tells_the_pair_that_it_is_of():
    """Stated values in their units, of either gear in its column; what rests on estimates is marked."""
    case = gl.load_case(CASES / "drawing.toml")
    assert in_brief(case).startswith("25/57 teeth, normal module 3 mm, helix angle 15°")
    stated, follows = pair_tables(case)
    rows = {row[0]: row[1:] for row in stated.rows}
    assert rows["teeth"] == ("25", "57")
    assert rows["normal module m_n"] == ("3 mm", "")
    given = {value.path for value in case.values() if value.provenance == "given"}
    count = sum(cell != "" for row in stated.rows for cell in row[1:])
    assert count == len(given - {"model.reference_length"})
    derived = {str(row[0]).partition(" (")[0]: row[1:] for row in follows.rows}
    base = [
        3.0 * z / cos(radians(15.0)) * cos(atan(tan(radians(20.0)) / cos(radians(15.0)))) for z in (25, 57)
    ]
    assert [float(str(cell).split()[0]) for cell in derived["base diameter d_b"]] == pytest.approx(
        base, rel=1e-4
    )
    assert isinstance(
        derived["mean mesh stiffness c_γ per common face width, transverse, as in ISO 6336-1"][0], Marked
    )
    assert [table.id for table in pair_tables(gl.load_case("kahraman-singh"))] == ["stated"]


@pytest.mark.parametrize("name", ["drawing.toml", "spurs.toml"])
def test_words_of_either_gear_are_the_same_in_its_column(name: str):
    """Every quantity that a case may state of a gear: what is left of its words names neither gear, and is
    whole. Two rows would stand in the table where one says what the other does."""
    case = gl.load_case(CASES / name)
    places = {place.path: place.description for place in case.content.places.values() if "." in place.path}
    rows = 0
    for path, words in places.items():
        table, _, rest = path.partition(".")
        if table == "pinion":
            own, other = of_either(words, "pinion"), of_either(places[f"gear.{rest}"], "gear")
            assert own == other, path
            assert not re.search(r"'s\b(?! (modulus|ratio))|itself|likewise|  |\b(pinion|gear)\b", own), own
            rows += 1
    assert rows > 30
    assert of_either("mass beside that of the gear itself, of its shaft", "gear") == (
        "mass beside its own, of its shaft"
    )


def test_the_order_of_the_mesh_that_meets_a_natural_frequency_in_a_band_is_named():
    """Order 4 of a stiffness with many harmonics, at a quarter of the natural frequency."""
    case = gl.load_case("blankenship-kahraman")
    values = {**case.family()[0].complete(), "omega": 0.25}
    more = case.with_overrides({"omega": 0.25, "ripple_4": 0.1})
    assert 4 in exciting(more)
    assert 4 not in exciting(case)
    at = {one.order: one for one in meetings(more, 0.2, 0.3)}
    (first,) = natural_frequencies(more)
    assert at[4].omega == pytest.approx(first / 4.0)
    assert at[4].text == "f1/4"
    end = ZoneEnd(0.2, "range"), ZoneEnd(0.3, "range")
    words = Words(PairUnits.of(more), values["omega"])
    said = meetings_within(more, (Band(*end, True, ()),), words)
    assert "order 4 of the mesh meets natural frequency 1 at omega = " in said
    assert meetings_within(case, (Band(*end, True, ()),), words) == ""


def test_a_motion_that_only_a_throw_leads_to_counts():
    """With little damping a 1-1-1 lives beside the 1-0: sweeps up, down and from the cold start miss it."""
    case = gl.load_case(CASES / "drive.toml", {"mesh.damping_ratio": "0.01", "torque": "100 N m"})
    factor = PairUnits.of(case).speed.factor
    axis = Axis.even("omega", 5950.0 / factor, 6230.0 / factor, 3)
    found = assess(case.with_overrides({"pinion_speed": "6090 rpm"}), axis)
    *usual, _, _, _ = found.impact_free.sweeps
    assert found.throws == 3
    assert {str(point.label) for sweep in usual for point in sweep.points} == {"1-0-0"}
    assert [sweep.way for sweep in found.impact_free.sweeps[3:]] == ["thrown +4", "thrown -4", "thrown +16"]
    ways = {way for zone in found.impact_free.wider for one in zone.motions if not one.quiet
            for way in one.directions}  # fmt: skip
    assert ways  # neither sweep nor the cold start leads to it
    assert all(way.startswith("thrown") for way in ways), ways
    family = case.family()[0]
    values = {"omega": float(axis.values[1])}
    oracle = gl.attractor(family.system(values), _beside(found, "1-1-1"))
    assert str(oracle.label) == "1-1-1"
    said = {line.title: line.text for line in verdict(found).lines}
    assert "1-1-1" in said["Teeth separate"]
    assert "the cold start and from 3 starts with teeth thrown" in said["Teeth separate"]
    assert said["Back side"].startswith("It is met at")
    assert verdict(found).kind == "doubt"


def _beside(found: Assessment, label: str) -> np.ndarray:
    """The state of a motion that was found in the middle of the axis."""
    states = [sweep.points[1] for sweep in found.impact_free.sweeps]
    return next(point.state for point in states if str(point.label) == label)
