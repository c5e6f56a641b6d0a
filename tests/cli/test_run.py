"""gearlash run: the sentence, the JSON against the engine, starts, exit codes."""

from __future__ import annotations

import json
from math import pi
from pathlib import Path

import numpy as np
import pytest

import gearlash as gl
from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.case import load, loads
from gearlash.cli.answers.motion import motion_numbers
from gearlash.cli.answers.sentence import met
from gearlash.cli.files import at_what
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema
from gearlash.cli.show.numbers import in_short
from gearlash.orbits import Orbit, Unresolved, attractor, motion_statistics
from gearlash.orbits.signals import signals
from gearlash.studies.measured import readouts_of
from gearlash.system import Status
from orbits.contacts import two_gaps

SCHEMA = answer_schema(answer_kind("run"))
AT_3600 = ("run", "article", "--set", "pinion_speed=3600rpm")


def orbit_of(case: str, **overrides: object) -> Orbit:
    family, _ = load(case, overrides).family()
    found = attractor(family.system(), family.start())
    assert isinstance(found, Orbit)
    return found


def test_the_plain_sentence_comes_first(gearlash: Gearlash):
    ran = gearlash(*AT_3600)
    first = (
        "3600 rpm: 1-1, teeth separate once per mesh cycle; nearest impact-free motion found at 3715 rpm; 12 "
        "other starts lead to the same motion"
    )
    assert " ".join(ran.out.partition("\n\n")[0].split()) == first
    assert ran.code == 0
    assert ran.err == ""


def test_every_amplitude_says_which_it_is(gearlash: Gearlash):
    lines = gearlash(*AT_3600).out.splitlines()
    amplitudes = [
        line for line in lines if line.strip().startswith(("contact force", "displacement", "transmission"))
    ]
    assert len(amplitudes) == 10
    for line in amplitudes:
        assert any(word in line for word in ("peak", "rms", "mean")), line


def test_numbers_on_assumed_values_are_marked_and_others_are_not(gearlash: Gearlash):
    lines = gearlash(*AT_3600).out.splitlines()
    force = next(line for line in lines if "largest (peak)" in line)
    assert "N †" in force  # D_c rests on the assumed backlash
    speed = next(line for line in lines if "Hz" in line)
    assert "3600 rpm, 1680 Hz," in speed
    assert "backlash 100 µm †" in speed
    assert "model.reference_length" in lines[-1]


def test_harmonics_in_a_row_are_named_by_their_ends():
    ripples = [f"mesh.ripple{end}" for end in ("", "_2", "_3", "_4")]
    assert in_short(["a.mass", *ripples, "mesh.error"]) == [
        "a.mass",
        "mesh.ripple to mesh.ripple_4",
        "mesh.error",
    ]
    assert in_short([ripples[0], ripples[2], ripples[3]]) == [ripples[0], ripples[2], ripples[3]]
    assert in_short(ripples[:2]) == ripples[:2]
    assert in_short(["definitions.c_1", "mesh.back_stiffness"]) == ["definitions.c_1", "mesh.back_stiffness"]


def test_json_holds_what_the_engine_computed(gearlash: Gearlash):
    answer = gearlash(*AT_3600, "--json").answer
    assert problems(answer, SCHEMA) == []
    orbit = orbit_of("article", pinion_speed="3600 rpm")
    numbers = motion_statistics(orbit)
    assert answer["signature"] == {"period": 1, "drive": 1, "back": 0, "others": []}
    assert answer["certificate"] == {"verdict": "certified", "reasons": []}
    assert answer["stable"] is True
    assert answer["residual"] == orbit.residual <= 1e-11
    assert list(answer["state"]) == list(load("article").family()[0].states)
    assert np.array_equal(list(answer["state"].values()), orbit.state)
    assert np.array_equal([m["re"] + 1j * m["im"] for m in answer["multipliers"]], orbit.multipliers)
    assert np.array_equal(answer["exponents"], orbit.exponents)
    found = answer["numbers"]
    assert found["force"]["maximum"] == numbers.force.maximum
    assert found["force"]["peak_to_peak"] == numbers.force.maximum - numbers.force.minimum
    assert found["dynamic_factor"] == pytest.approx(numbers.force.maximum / numbers.force.mean, rel=1e-14)
    assert found["displacement"]["rms"] == numbers.error_rms
    # The article's error is stated at the teeth: the rotation of both gears has it, X has not.
    readout = readouts_of(load("article"), answer["parameters"])[-1]
    read = signals(orbit.trace, (readout,)).read[0]
    assert found["transmission_error"] == {"rms": read.rms, "peak_to_peak": read.peak_to_peak}
    assert found["transmission_error"]["rms"] != pytest.approx(found["displacement"]["rms"], rel=0.01)
    assert found["distances"]["drive"]["minimum"] == numbers.minimum - 1.0 < 0.0
    assert [(e["side"], e["event"]) for e in found["events"]] == [
        ("drive", "release"),
        ("drive", "engagement"),
    ]


def test_physical_numbers_are_the_dimensionless_ones_with_the_scales_of_the_case(gearlash: Gearlash):
    answer = gearlash(*AT_3600, "--json").answer
    scales, physical = load("article").scales, answer["physical"]
    assert physical["pinion_speed_rpm"] == pytest.approx(3600.0, rel=1e-13)
    assert physical["mesh_frequency_Hz"] == pytest.approx(1680.0, rel=1e-13)  # 28 teeth
    assert scales.mean_stiffness is not None
    assert scales.length is not None
    newtons = scales.mean_stiffness * scales.length
    for name, value in answer["numbers"]["force"].items():
        assert physical["force_N"][name] == pytest.approx(newtons * value, rel=1e-13)
    error = answer["numbers"]["transmission_error"]["peak_to_peak"]
    assert physical["transmission_error_um"]["peak_to_peak"] == pytest.approx(50.0 * error, rel=1e-13)
    event, dimensionless = physical["events"][0], answer["numbers"]["events"][0]
    assert event["time_ms"] == pytest.approx(1e3 * dimensionless["phase"] / 1680.0, rel=1e-13)
    assert scales.omega_n is not None
    speed = dimensionless["velocity"] * scales.length * scales.omega_n
    assert event["velocity_mm_s"] == pytest.approx(1e3 * speed, rel=1e-13)


def test_a_case_without_scales_has_no_physical_numbers(gearlash: Gearlash):
    answer = gearlash("run", "kahraman-singh", "--json").answer
    assert problems(answer, SCHEMA) == []
    assert answer["physical"] is None
    assert answer["sentence"].startswith(
        "ω = 0.5: 1-0, teeth stay in contact; this motion is impact-free up to ω = "
    )


def test_initial_states_lead_to_other_attractors(gearlash: Gearlash, tmp_path: Path):
    """At ω = 1.105 the impact-free motion goes on beside the one that cold starts find."""
    earlier = gearlash("run", "article", "--set", "omega=1.05", "--json")
    saved = tmp_path / "earlier.json"
    saved.write_text(earlier.out, encoding="utf-8")
    here = ("run", "article", "--set", "omega=1.105", "--json")
    cold, followed = gearlash(*here).answer, gearlash(*here, "--initial", str(saved)).answer
    assert followed["start"] == earlier.answer["state"]
    assert (cold["label"], followed["label"]) == ("2-1-0", "1-0-0")
    assert "an impact-free motion exists at this speed too, from another start" in cold["sentence"]


def test_single_states_replace_those_of_the_cold_start(gearlash: Gearlash):
    answer = gearlash("run", "article", "--initial", "X=1.3", "--initial", "X'=-0.01", "--json").answer
    moved = {name: value for name, value in answer["start"].items() if value}
    assert moved == {"X": 1.3, "X'": -0.01}


def test_a_status_that_is_not_ok_has_exit_code_3_and_says_what_to_do(gearlash: Gearlash):
    chaotic = ("run", "article", "--set", "omega=0.9", "--periods", "200")
    ran = gearlash(*chaotic)
    assert ran.code == 3
    assert "--periods" in ran.out
    answer = gearlash(*chaotic, "--json").answer
    assert problems(answer, SCHEMA) == []
    assert answer["status"] == answer["motion"] == "unresolved"
    assert answer["signature"] is None


def test_aperiodic_motion_has_no_period_and_an_error_bar(gearlash: Gearlash):
    ran = gearlash("run", "article", "--set", "omega=0.78", "--set", "D=0.25", "--json")
    answer = ran.answer
    assert ran.code == 0
    assert problems(answer, SCHEMA) == []
    assert answer["motion"] == answer["label"] == "aperiodic"
    assert answer["signature"] is answer["residual"] is answer["stable"] is None
    assert answer["multipliers"] == []
    assert answer["exponents"][0] > 2.0 * answer["exponent_error"] > 0.0
    assert "on average" in answer["sentence"]


def test_load_on_the_back_side_is_said_so(gearlash: Gearlash):
    answer = gearlash("run", "article", "--set", "load=-0.09", "--json").answer
    assert "teeth stay in contact on the back side" in answer["sentence"]
    assert answer["numbers"]["dynamic_factor"] > 1.0
    assert answer["numbers"]["force"]["mean"] < 0.0


def test_without_load_nothing_is_said_about_impact_free_speeds(gearlash: Gearlash):
    ran = gearlash("run", "kahraman-singh", "--set", "load=0", "--periods", "100", "--json")
    assert ran.answer["impact_free"] is None
    assert ran.answer["numbers"]["dynamic_factor"] is None
    assert problems(ran.answer, SCHEMA) == []


def test_out_holds_the_same_json_and_the_figures(gearlash: Gearlash, tmp_path: Path):
    ran = gearlash("run", "kahraman-singh", "--json", "--out", str(tmp_path / "here"))
    folder = tmp_path / "here"
    assert json.loads((folder / "run.json").read_text(encoding="utf-8")) == ran.answer
    names = {path.name for path in folder.iterdir()}
    figures = {f"{name}.{form}" for name in ("portrait", "history") for form in ("svg", "pdf")}
    assert names == {".gearlash.json", "run.json", "history.nc", "spectrum.nc", *figures}


def test_phase_zero_state_in_physical_units(gearlash: Gearlash):
    answer = gearlash("run", "wind-turbine", "--json").answer
    scales = load("wind-turbine").scales
    shown = answer["physical"]["state_um_and_mm_s"]
    assert shown["X"] == pytest.approx(answer["state"]["X"] * 100.0, rel=1e-13)  # D_c = 100 µm
    assert scales.omega_n is not None
    assert shown["X'"] == pytest.approx(answer["state"]["X'"] * 100e-3 * scales.omega_n, rel=1e-13)
    rpm, hz = answer["physical"]["pinion_speed_rpm"], answer["physical"]["mesh_frequency_Hz"]
    assert hz == pytest.approx(rpm / 60.0 * 16.0, rel=1e-13)
    assert hz == pytest.approx(answer["parameters"]["omega"] * scales.omega_n / (2.0 * pi), rel=1e-13)


def test_ctrl_c_ends_with_130_and_no_traceback(gearlash: Gearlash, monkeypatch: pytest.MonkeyPatch):
    def interrupted(*arguments: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("gearlash.orbits.attractor", interrupted)
    ran = gearlash("run", "article")
    assert (ran.code, ran.out, ran.err) == (130, "", "interrupted\n")


def test_a_motion_that_ran_away_is_told_without_numbers(gearlash: Gearlash, monkeypatch: pytest.MonkeyPatch):
    family = load("article").family()[0]
    nowhere = np.full(10, np.nan)
    lost = Unresolved(
        gl.propagators(family.system()),
        nowhere,
        np.nan,
        np.nan,
        24,
        Status.DIVERGED,
        "the motion could not be carried on",
    )
    monkeypatch.setattr("gearlash.orbits.attractor", lambda *arguments: lost)
    ran = gearlash("run", "article")
    assert ran.code == 3
    assert ran.out.startswith("4000 rpm: unresolved, the motion could not be carried on")
    assert "check damping" in ran.out
    answer = gearlash("run", "article", "--json").answer
    assert problems(answer, SCHEMA) == []
    assert answer["numbers"] is answer["physical"] is None


def test_the_certificate_is_a_line_of_its_own(gearlash: Gearlash):
    lines = gearlash(*AT_3600).out.splitlines()
    assert [line.split() for line in lines if line.strip().startswith("certificate")] == [
        ["certificate", "certified"]
    ]


@pytest.mark.parametrize("rule", ["always", "in-contact", "no-tension"])
def test_the_quiet_interval_ends_where_the_graze_is(gearlash: Gearlash, rule: str):
    """Two ways: the margin of the closed mesh, and the touch that is solved for together with the orbit."""
    answer = gearlash(
        "run", "article", "--set", "omega=1.05", "--set", f"model.contact={rule}", "--json"
    ).answer
    touch = gearlash("graze", "article", "--near", "1.05", "--set", f"model.contact={rule}", "--json").answer
    ends = sorted(point["value"] for point in touch["points"])
    assert [answer["impact_free"]["lower"], answer["impact_free"]["upper"]] == pytest.approx(ends, rel=2e-9)
    assert {point["surface"] for point in touch["points"]} == {"force" if rule == "no-tension" else "gap"}
    assert all(c["holds"] for point in touch["points"] for c in point["conditions"])


def test_further_gaps_are_told_by_name():
    family = two_gaps()
    found = attractor(family.system({"omega": 0.5}), family.start({}))
    assert isinstance(found, Orbit)
    assert found.label == "1-1-0/2-1"
    numbers = motion_numbers(found)
    (link,) = numbers.others
    assert link.name == "link"
    assert len(numbers.events) == 2
    assert len(link.events) == 6
    assert (
        met(link.name, link, numbers.cycles)
        == "link met on side + twice per cycle and on side - once per cycle"
    )
    samples = found.trace.at(np.linspace(0.0, 1.0, 200_001), 1)
    assert link.force.maximum == pytest.approx(samples.force.max(), abs=1e-4)
    gap = samples.state @ [1.0, 0.0, -1.0, 0.0]
    assert link.distances.drive.maximum == pytest.approx(gap.max() - 0.3, abs=1e-8)


def test_without_torque_teeth_float(gearlash: Gearlash):
    case = str(Path(__file__).resolve().parents[1] / "cases" / "drive.toml")
    said = " ".join(gearlash("run", case, "--set", "torque=0Nm").out.split())
    assert "no torque presses the teeth together, and they float in the backlash" in said


def test_the_heading_of_figures_says_which_backlash_is_an_estimate():
    """A page of a figure alone has no table of what was assumed."""
    text = (Path(__file__).parents[1] / "cases" / "drawing.toml").read_text()
    assert at_what(loads(text)) == ", at 4200 rpm, 150 N·m, 80 µm backlash"
    assert at_what(loads(text.replace('backlash = "80 um"\n', ""))).endswith(", about 197 µm backlash")
    assert at_what(load("kahraman-singh"), "load") == ", at ω = 0.5, D = 1"


def test_the_backlash_of_a_warm_pair_is_that_at_work(gearlash: Gearlash):
    """Gears at 90 °C in a housing at 20 °C have less of it than they are made with."""
    warm = ("--set", "mesh.temperature=90degC", "--set", "mesh.housing_temperature=20degC")
    path = str(Path(__file__).parents[1] / "cases" / "drawing.toml")
    cold, hot = (gearlash("run", path, *settings, "--json").answer["physical"] for settings in ((), warm))
    assert (cold["backlash_um"], cold["backlash_name"]) == (pytest.approx(80.0), "backlash")
    assert hot["backlash_name"] == "backlash at work"
    assert hot["backlash_um"] < 60.0
    assert "backlash at work" in gearlash("run", path, *warm).out
