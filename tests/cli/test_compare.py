"""gearlash compare: a synthetic measurement with known parameters, units of columns, levels, refusals."""

import json
import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

import gearlash as gl
from cli.conftest import Gearlash
from gearlash.cli.answers.compare import (
    CompareAnswer,
    ComparedPeak,
    ComparedSpeed,
    JumpFound,
    compare_answer,
)
from gearlash.cli.answers.parts import CaseUsed
from gearlash.cli.show.compare import compare_view, rows_shown
from gearlash.jobs import Outcome
from gearlash.orbits.figures import Figure, figure_of
from gearlash.studies import comparison
from gearlash.studies.comparison import known_quantities
from gearlash.studies.measured import readouts_of

DRIVE = Path(__file__).parents[1] / "cases" / "drive.toml"
RPM = np.array([4000.0, 4050.0, 4080.0, 4130.0, 4160.0, 4200.0])


@pytest.fixture(scope="module")
def case() -> gl.Case:
    return gl.load_case(DRIVE)


def compared(case: gl.Case, rpm: Sequence[float] | np.ndarray, values: Sequence[float] | np.ndarray,
             quantity: str, figure: str = "peak-to-peak", order: float = 1.0, unit: str = "",
             ) -> gl.Comparison:  # fmt: skip
    """With dimensionless values where no unit is named."""
    rows = gl.measurement(case, rpm, values, quantity, speed_unit="rpm", unit=unit)
    return gl.compare(case, rows, figure, order=order)


@pytest.mark.slow
def test_what_the_pair_does_itself_leaves_nothing(case: gl.Case, gearlash: Gearlash, tmp_path: Path):
    stepped = compared(
        case, RPM, np.where(RPM > 4114.0, 50.0, 1.0) + 0.01 * np.arange(6), "mesh_force", "peak"
    )
    (jump,) = stepped.jumps
    assert jump.lower * stepped.measurement.speed_factor == pytest.approx(RPM[2])
    events = [(way, change.value * float(case.scales.pinion_rpm(1.0))) for way, change in jump.events]
    assert {way for way, value in events if abs(value - 4114.0811) < 1e-3} == {"up", "down"}
    made = compared(case, RPM, np.arange(6.0), "transmission_error").up
    values = made * float(case.scales.length_um(1.0))
    lines = [f"{a:.0f};{b!r}".replace(".", ",") for a, b in zip(RPM.tolist(), values.tolist(), strict=True)]
    (tmp_path / "te.csv").write_text("Drehzahl [rpm];DTE [µm]\n" + "\n".join(lines))
    out = tmp_path / "out"
    ran = gearlash("compare", str(DRIVE), str(tmp_path / "te.csv"), "--workers", "1", "--out", str(out))
    assert ran.code == 0, ran.err
    answer = json.loads((out / "compare.json").read_text())
    at, largest = int(np.argmax(values)), answer["peaks"][0]
    assert (largest["curve"], largest["speed"]) == ("measured", pytest.approx(RPM[at]))
    assert largest["measured"] == pytest.approx(values[at]) == pytest.approx(largest["up"])
    assert largest["mesh_frequency"] == pytest.approx(25 * RPM[at] / 60.0)  # 25 teeth
    assert answer["rms"] < 1e-9 * answer["span"]
    assert (answer["unit"], answer["speed_unit"]) == ("µm", "rpm")
    assert (out / "compare.svg").exists()
    assert len((out / "compare.csv").read_text().splitlines()) == 7


def test_figures_stay_at_their_speeds_where_some_were_not_computed(
    case: gl.Case, monkeypatch: pytest.MonkeyPatch
):
    """A stop may cut one task short, and find the next one done."""
    speeds = np.linspace(3900.0, 4200.0, comparison.POINTS_OF_A_TASK + 2)
    asked = (case, speeds, np.ones(len(speeds)), "mesh_force", "peak")
    whole, run = compared(*asked), comparison.run

    def stopped(work, chains, execution) -> Outcome:
        results = run(work, chains, execution).results
        return Outcome({**results, 0: results[0][:1]}, "interrupted")

    monkeypatch.setattr(comparison, "run", stopped)
    part = compared(*asked)
    assert (whole.complete, part.complete) == (True, False)
    np.testing.assert_array_equal(part.up[[0, -2, -1]], whole.up[[0, -2, -1]])
    assert np.isnan(part.up[1:-2]).all()
    answer = compare_answer(case, part)
    assert f"{len(speeds)} speeds from 3900 to 4200 rpm: residual at 3 of them" in answer.sentence
    assert answer.message == "stopped before all speeds were computed"
    killed = replace(part, sweeps=(replace(part.sweeps[0], message="a worker process died"), part.sweeps[1]))
    assert compare_answer(case, killed).message.endswith(": a worker process died")


def test_a_speed_may_be_measured_several_times_in_any_order(case: gl.Case):
    found = compared(case, [4200.0, 4150.0, 4200.0], [2.0, 1.0, 3.0], "mesh_force", "peak")
    assert found.measured.tolist() == [1.0, 2.0, 3.0]
    assert found.up[1] == found.up[2] != found.up[0]
    assert [len(way) for way in (found.labels, found.residuals, found.sweeps[0].points)] == [3, 3, 2]


def test_levels_and_orders_and_accelerations(case: gl.Case, gearlash: Gearlash, tmp_path: Path):
    rows = compared(case, RPM[-2:], [1.0, 2.0], "acceleration_yp", "order").up
    size = float(case.scales.length_m(1.0)) * float(case.scales.omega_n or 0.0) ** 2
    levels = 20.0 * np.log10(rows * size / 1e-6)
    text = "\n".join(f"{a} {b!r}" for a, b in zip(RPM[-2:].tolist(), levels.tolist(), strict=True))
    (tmp_path / "a.txt").write_text(text)
    asked = ("--quantity", "acceleration_yp", "--figure", "order", "--speed-unit", "rpm", "--unit", "dB",
             "--reference", "1e-6 m/s^2")  # fmt: skip
    ran = gearlash("compare", str(DRIVE), str(tmp_path / "a.txt"), *asked, "--workers", "1", "--json")
    assert ran.code == 0, ran.err
    assert ran.answer["rms"] < 1e-9 * ran.answer["points"][0]["measured"]
    assert ran.answer["unit"] == "m/s^2"


@pytest.mark.parametrize(
    ("told", "size"),
    [
        ("dB re 1e-6 m/s²", 1e-6),
        ("dB re 10⁻⁶ m/s²", 1e-6),
        ("dB re 1µm/s²", 1e-6),
        ("dB ref. 1 g", 9.80665),
        ("dB re 1 in/s^2", 0.0254),
    ],
)
def test_references_of_levels_as_they_are_written(case: gl.Case, tmp_path: Path, told: str, size: float):
    """Behind the dB and alone, with a blank before the unit and without, as a power of ten."""
    (tmp_path / "a.csv").write_text(f"n [rpm];a [{told}]\n4200;120\n4100;100")
    stated = gl.load_measurement(case, tmp_path / "a.csv", "acceleration_yp")
    alone = told.partition("re")[2].lstrip("f. ")
    asked = gl.measurement(case, [1.0, 1.1], [120, 100], "acceleration_yp", unit="dB", reference=alone)
    one = float(case.scales.length_m(1.0)) * float(case.scales.omega_n or 0.0) ** 2
    for found in (stated, asked):
        assert found.values * one == pytest.approx([1e6 * size, 1e5 * size])


def test_an_orbit_has_no_line_between_its_own(case: gl.Case):
    """Order 1/2 of a motion that repeats every cycle is 0, and not a motion that was not found."""
    found = compared(case, RPM[-2:], [1.0, 2.0], "mesh_force", "order", order=0.5)
    assert [label for label, _ in found.labels] == ["1-0-0", "1-0-0"]
    assert found.up.tolist() == [0.0, 0.0]
    assert found.residuals.tolist() == found.measured.tolist()


def test_only_a_mean_has_a_sign(case: gl.Case):
    for figure in ("peak", "peak-to-peak", "rms", "order"):
        with pytest.raises(gl.GearlashError, match="down to -2 N: expected none below zero"):
            compared(case, RPM[-2:], [1.0, -2.0], "mesh_force", figure, unit="N")
    assert compared(case, RPM[-2:], [1.0, -2.0], "mesh_force", "mean", unit="N").figure == "mean"
    with pytest.raises(gl.GearlashError, match="above zero"):
        compared(case, RPM[-2:], [1.0, 2.0], "mesh_force", "order", order=0)


def test_lines_and_rms_agree_with_samples(case: gl.Case):
    """All lines together have the power of the signal (Parseval); the acceleration is that of the state."""
    family = case.family()[0]
    values = family.complete({})
    found = gl.attractor(family.system(values), family.start(values))
    assert isinstance(found, gl.Orbit)
    trace = gl.trace(family.system(values), found.state, found.period)
    readouts, known = readouts_of(case, values), known_quantities(case)
    for name in ("transmission_error", "bearing_force_yp", "acceleration_yp"):
        rms = figure_of(trace, readouts, known[name], Figure.RMS)
        lines = [figure_of(trace, readouts, known[name], Figure.ORDER, n) for n in range(1, 13)]
        assert np.sqrt(np.sum(np.square(lines))) == pytest.approx(rms, rel=1e-4)
    phase = np.linspace(0.1, 0.9, 7)
    step = 1e-5
    speeds = [trace.at(phase + sign * step).state[:, 1] for sign in (1.0, -1.0)]
    slope = (speeds[0] - speeds[1]) / (2.0 * step) * values["omega"] / (2.0 * np.pi)
    peak = figure_of(trace, readouts, known["acceleration_yp"], Figure.PEAK)
    assert np.abs(slope).max() <= peak * (1.0 + 1e-6)
    assert np.abs(slope).max() > 0.5 * peak


def test_computed_is_said_where_both_ways_of_speed_are_largest():
    """A value that is alike both ways is not the largest of both where one way has another elsewhere."""
    up = ComparedPeak("up", 0.84, 0.3, 0.34, 0.34, None)
    down = ComparedPeak("down", 0.72, 0.3, 0.29, 0.39, None)

    points = (ComparedSpeed(0.84, 0.3, 0.34, 0.34, "1-0-0", "1-0-0", -0.04, "up", None),)

    def names(*peaks: ComparedPeak) -> list[str]:
        answer = CompareAnswer(
            "", "ok", "", cast(CaseUsed, None), "mesh_force", "peak-to-peak", None, ("", ""), 0, "", "",
            points, None, None, None, None, peaks, 1.0, (),
        )  # fmt: skip
        text = "\n".join(line.plain for line in compare_view(answer, 100))
        return re.findall(r"(computed(?:, speed \w+)?) +0\.\d+ at", text)

    assert names(up) == ["computed"]
    assert names(up, down) == ["computed, speed rising", "computed, speed falling"]
    assert names(replace(up, down=None)) == ["computed, speed rising"]


def test_the_largest_of_a_way_is_told_though_it_equals_the_measured_one(case: gl.Case):
    """Where nothing was computed with speed rising, there is no curve that falling could repeat."""
    whole = compared(case, RPM[-2:], [1.0, 2.0], "mesh_force")
    down = np.array([1.0, 2.0])
    stopped = replace(whole, up=np.array([np.nan, np.nan]), down=down / whole.measurement.factor)
    told = [(each.curve, each.down) for each in compare_answer(case, stopped).peaks]
    assert told == [("measured", pytest.approx(2.0)), ("down", pytest.approx(2.0))]


def test_the_rows_that_are_shown_have_the_largest_of_all():
    """Of 101 rows a fifth is shown: a peak of one row would fall between."""
    speed = np.linspace(1000.0, 2000.0, 101)
    measured, up = np.ones(101), 2.0 * np.ones(101)
    measured[43], up[57] = 9.0, 8.0
    points = tuple(
        ComparedSpeed(float(n), float(m), float(u), float(u), "1-0-0", "1-0-0", float(m - u), "up", None)
        for n, m, u in zip(speed, measured, up, strict=True)
    )
    answer = SimpleNamespace(points=points, jumps=(JumpFound(1120.0, 1130.0, 1.0, "up", ()),))
    shown = [each.speed for each in rows_shown(cast(CompareAnswer, answer))]
    assert {1000.0, 1120.0, 1130.0, 1430.0, 1570.0, 2000.0} <= set(shown)
    assert len(shown) < 35
    assert shown == sorted(shown)


@pytest.mark.parametrize(
    ("text", "options", "message"),
    [
        ("1;2\n3;4", (), "the unit of the speeds"),
        ("n [rpm];x\n1000;2\n2000;4", (), "the unit of the values"),
        ("n [rpm];x [N]\n1000;2\n2000;4", (), "a unit of it, such as um"),
        ("n [rpm];x [m/s²]\n1000;2\n2000;4", (), "--quantity acceleration_yp has it"),
        ("n [rpm];x [kN]\n1000;2\n2000;4", ("--quantity", "acceleration_yp"), "--quantity mesh_force has it"),
        ("n [rpm];x [dB]\n1000;2\n2000;4", (), "what the levels refer to"),
        ("n [rpm];x [dB]\n1000;2\n2000;4", ("--reference", "1e999 um"), "what the levels refer to"),
        ("n [rpm];x [dB]\n1000;2\n2000;4", ("--reference", "1e-6"), 'such as "1e-6 um"'),
        (
            "n [rpm];x [dB re 1e-6]\n1000;2\n2000;4",
            ("--quantity", "acceleration_yp"),
            'such as "1e-6 m/s^2"',
        ),
        (
            "n [rpm];x [dB]\n1000;2\n2000;4",
            ("--quantity", "mesh_force", "--reference", "1 -"),
            "a number with its unit",
        ),
        ("n [rpm];x [dB re 1e999 um]\n1000;2\n2000;4", (), "what the levels refer to"),
        ("n [rpm];x [um]\n1000;2\n2000;4", ("--value", "y"), "the name or number of a column"),
        ("n [rpm];x [um]\n1000;2\n2000;4", ("--quantity", "mesh_forc"), "did you mean 'mesh_force'"),
        ("n [rpm];x [g]\n1000;2\n2000;4", ("--quantity", "acceleration_y"), "did you mean 'acceleration_yp'"),
        ("n [rpm];x [um]\n1000;2\n2000;4", ("--figure", "p2p"), "peak-to-peak"),
        ("n [rpm];x [um]\n1000;a\n2000;4", (), "its line 2 has no number in column 'x'"),
    ],
)
def test_what_cannot_be_read_is_said(gearlash: Gearlash, tmp_path: Path, text: str, options: tuple[str, ...],
                                     message: str):  # fmt: skip
    (tmp_path / "m.csv").write_text(text)
    ran = gearlash("compare", str(DRIVE), str(tmp_path / "m.csv"), *options, "--workers", "1")
    assert ran.code == 2
    assert message in " ".join(ran.complaint.split())


def test_speeds_and_values_come_back_as_they_were_written(gearlash: Gearlash, tmp_path: Path):
    """To the last digit, so that rows of both tables can be joined by the speed."""
    speeds = [4200.0, 5000.0, 6100.1, 7000.0, 9999.99]
    (tmp_path / "m.csv").write_text("n [rpm];x [um]\n" + "\n".join(f"{n};{n / 7000:.4f}" for n in speeds))
    ran = gearlash("compare", str(DRIVE), str(tmp_path / "m.csv"), "--workers", "1", "--json")
    assert [point["speed"] for point in ran.answer["points"]] == speeds
    assert [point["measured"] for point in ran.answer["points"]] == [float(f"{n / 7000:.4f}") for n in speeds]


@pytest.mark.slow
def test_jumps_belong_to_the_events_of_their_direction(tmp_path: Path):
    """A run upwards and one downwards in one file, noise of known size: the jumps of either are at the events
    that the speed meets that way, and what is left is the noise."""
    case = gl.load_case("kahraman-singh")
    omega = np.linspace(0.68, 0.86, 19)
    made = gl.compare(case, gl.measurement(case, omega, omega, "mesh_force"), "peak")
    noise = 1e-3 * np.random.default_rng(3).standard_normal(38)
    rows = np.concatenate([made.up, made.down[::-1]]) + noise
    lines = [f"{a:.3f}\t{b:.12f}" for a, b in zip([*omega, *omega[::-1]], rows, strict=True)]
    (tmp_path / "both.txt").write_text(
        "\n".join(["n\tF", *lines[:7], "0.73\t", *lines[7:]]).replace(".", ",")
    )
    measured = gl.load_measurement(case, tmp_path / "both.txt", "mesh_force")
    found = gl.compare(case, measured, "peak")
    falling, rising = found.jumps
    assert (falling.direction, rising.direction, measured.left_out) == ("down", "up", 1)
    assert (falling.lower, falling.upper) == pytest.approx((0.70, 0.71))
    assert [(way, change.kind) for way, change in falling.events] == [("down", "fold")]
    assert {way for way, _ in rising.events} == {"up"}
    assert np.sort(found.residuals) == pytest.approx(np.sort(noise), abs=1e-11)


def test_the_column_is_the_one_whose_unit_fits(case: gl.Case, tmp_path: Path):
    text = "t [s];n [1/min];a [dB re 1e-6 m/s^2];F1 [kN];x\n0;4200;120;1,5;1\n1;4150;121;;2\n2;4100;121;1,7;3"
    (tmp_path / "channels.csv").write_text(text)
    force = gl.load_measurement(case, tmp_path / "channels.csv", "mesh_force")
    assert (force.columns, force.unit, force.left_out) == (("n", "F1"), "kN", 1)
    assert (force.values * force.factor).tolist() == pytest.approx([1.5, 1.7])
    assert (force.omega * force.speed_factor).tolist() == pytest.approx([4200.0, 4100.0])
    sound = gl.load_measurement(case, tmp_path / "channels.csv", "acceleration_yp")
    assert (sound.columns, sound.unit) == (("n", "a"), "m/s^2")
    assert sound.values[0] * sound.factor == pytest.approx(1.0)
