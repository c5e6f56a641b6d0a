"""gearlash graze: the points against the solver, closed forms, and what is said where there is none."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import gearlash as gl
from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.branches import locate_grazing
from gearlash.case import load
from gearlash.cli.answers.graze import JUMPS, graze_answer
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema
from gearlash.cli.show.graze import graze_view
from gearlash.orbits import Orbit, attractor, grazing_checks

SCHEMA = answer_schema(answer_kind("graze"))
FAMILY = load("article").family()[0]


def test_both_neighbours_nearest_first(gearlash: Gearlash):
    ran = gearlash("graze", "article", "--near", "1.05", "--json")
    answer = ran.answer
    assert ran.code == 0
    assert problems(answer, SCHEMA) == []
    assert answer["label"] == "1-0-0"
    upper, lower = answer["points"]
    assert (upper["label_below"], upper["label_above"]) == ("1-0-0", "1-1-0")
    assert (lower["label_below"], lower["label_above"]) == ("1-1-0", "1-0-0")
    values = FAMILY.complete({"omega": 1.05})
    orbit = attractor(FAMILY.system(values), FAMILY.start(values))
    assert isinstance(orbit, Orbit)
    near = locate_grazing(FAMILY, "omega", orbit, grazing_checks(orbit)[0], values=values)
    assert min(abs(p["value"] - near.value) for p in answer["points"]) <= 1e-10


def test_the_point_is_what_it_says(gearlash: Gearlash):
    point = gearlash("graze", "article", "--near", "1.05", "--json").answer["points"][0]
    assert point["side"] == "drive"
    assert point["kind"].startswith("loss of contact")
    assert point["type"] == "standard grazing"
    assert point["error"] <= 1e-10
    assert [c["holds"] for c in point["conditions"]] == [True] * 4
    assert point["conditions"][3]["value"] == point["a0"] > 0.0
    assert point["state"]["X"] == pytest.approx(1.0, abs=1e-13)
    assert point["state"]["X'"] == pytest.approx(0.0, abs=1e-12)
    multipliers = np.array([m["re"] + 1j * m["im"] for m in point["multipliers"]])
    assert len(multipliers) == 10
    assert point["to_doubling"] == pytest.approx(np.abs(multipliers + 1.0).min(), rel=1e-12)
    assert point["to_fold"] == pytest.approx(np.abs(multipliers - 1.0).min(), rel=1e-12)
    assert point["largest_exponent"] < 0.0
    rpm = next(p for p in point["physical"] if p["unit"] == "rpm")
    assert rpm["value"] == pytest.approx(float(load("article").scales.pinion_rpm(point["value"])), rel=1e-13)


def test_closed_form_in_the_load(gearlash: Gearlash):
    """Constant stiffness: X − D = f + a cos(…), so contact is lost where f is the amplitude a."""
    ran = gearlash("graze", "kahraman-singh", "--over", "load", "--near", "0.05", "--json")
    assert problems(ran.answer, SCHEMA) == []
    omega, damping, error = (ran.answer["parameters"][name] for name in ("omega", "mesh_damping", "error"))
    amplitude = omega**2 * error / abs(complex(1.0 - omega**2, 2.0 * damping * omega))
    assert ran.answer["points"][0]["value"] == pytest.approx(amplitude, abs=1e-10)


def test_back_side_and_a_doubling_on_the_way(gearlash: Gearlash):
    ran = gearlash(
        "graze", "article-first-harmonic", "--over", "D", "--near", "0.3855", "--set", "omega=0.78", "--json"
    )
    assert problems(ran.answer, SCHEMA) == []
    assert ran.answer["label"] == "6-6-1"
    by_label = {p["label_below"]: p for p in ran.answer["points"]}
    back = by_label["6-6-1"]
    assert back["label_above"] == "6-6-2"
    assert back["side"] == "back"
    assert back["state"]["X"] == pytest.approx(-back["value"], abs=1e-12)
    down = next(path for path in ran.answer["paths"] if path["direction"] == "down")
    assert [change["kind"] for change in down["passed"]] == ["doubling"]


def test_a_physical_name_and_value(gearlash: Gearlash):
    plain = gearlash("graze", "article", "--near", "1.05", "--json").answer["points"][0]["value"]
    ran = gearlash("graze", "article", "--over", "pinion_speed", "--near", "4011 rpm")
    assert ran.code == 0
    rpm = float(load("article").scales.pinion_rpm(plain))
    shown = f"{rpm:.8g} rpm (omega = {plain:.10g})"
    assert shown in " ".join(ran.out.split())
    assert "conditions" in ran.out
    assert f"{rpm:.10g} rpm, omega = {plain:.13g}" in ran.out
    assert f"{abs(rpm - 4011.0):.4g} rpm above the start ({100.0 * abs(rpm / 4011.0 - 1.0):.4g} %)" in ran.out


def test_an_aperiodic_motion_cannot_be_followed(gearlash: Gearlash):
    ran = gearlash("graze", "article", "--set", "omega=0.78", "--over", "D", "--near", "0.25")
    assert ran.code == 3
    assert "no grazing was found" in ran.out
    assert "only a periodic motion can be followed" in " ".join(ran.out.split())


def test_the_end_of_the_search_is_said(gearlash: Gearlash):
    ran = gearlash("graze", "kahraman-singh", "--over", "D", "--json")
    assert ran.code == 3  # X ∓ D does not depend on D
    assert ran.answer["status"] == "not-found"
    assert {path["ended"] for path in ran.answer["paths"]} == {"end of the search"}
    assert problems(ran.answer, SCHEMA) == []


def test_a_system_that_cannot_be_built_is_said_to_be(gearlash: Gearlash):
    ran = gearlash("graze", "article", "--near", "1e-6", "--json")
    assert ran.code == 3
    assert problems(ran.answer, SCHEMA) == []
    assert ran.answer["status"] == "failed"
    assert "cells a period would be needed, more than 200,000: omega = 1e-06 is slow" in ran.answer["message"]


def test_advice_is_given_once(gearlash: Gearlash):
    ran = gearlash("graze", "article", "--near", "0.9", "--periods", "200")
    assert ran.code == 3
    assert " ".join(ran.out.split()).count("allow more periods") == 1


STOP = """
kind = "piecewise-linear"
name = "soft-stop"
states = ["x", "v"]
[parameters]
omega = 0.75
a = 0.7
zeta = 0.01
beta = 29.0
limit = 10.0
[matrix]
x = { v = 1 }
v = { x = -1, v = "-2*zeta" }
[forcing]
v = { cos = ["a/1.26*omega^2*sqrt(limit-omega)/sqrt(limit-omega)"] }
[[clearance]]
name = "stop"
h = { x = 1 }
g = { v = -1 }
gap_plus = 1
gap_minus = 1000
stiffness_plus = "beta"
stiffness_minus = 0
"""
TOUCH = 0.8019281065932358  # amplitude (a/1.26)ω²/√((1-ω²)² + (2ζω)²) = 1, from below
RETURN = 1.4997299367834077  # the same from above


@pytest.fixture
def stop(tmp_path: Path) -> str:
    """A stiff one-sided stop, behind whose touch lies chaos."""
    file = tmp_path / "stop.toml"
    file.write_text(STOP)
    return str(file)


def linear_start(omega: float) -> list[str]:
    """The state of the linear motion, as options."""
    z = 0.7 / 1.26 * omega**2 / complex(1.0 - omega**2, 0.02 * omega)
    return ["--initial", f"x={z.real!r}", "--initial", f"v={-omega * z.imag!r}"]


@pytest.mark.parametrize("near", [0.5, 0.79, 0.8019, 0.801928, 0.8019281065])
def test_chaos_behind_the_touch(gearlash: Gearlash, stop: str, near: float):
    """The next touch of this motion, from however near; not one of what lies behind it."""
    answer = gearlash("graze", stop, "--near", repr(near), "--json", *linear_start(near)).answer
    assert answer["label"] == "1-0-0"
    (point,) = (p for p in answer["points"] if p["value"] > near)
    assert point["value"] == pytest.approx(TOUCH, abs=1e-11)
    assert (point["label_below"], point["label_above"]) == ("1-0-0", "1-1-0")
    assert (point["stable_below"], point["stable_above"]) == (True, True)
    up = next(path for path in answer["paths"] if path["direction"] == "up")
    assert up["passed"] == []
    assert "its period doubles" in up["beyond"]
    assert (
        f"nearest grazing found along this motion is engagement on side + at omega = {TOUCH:.10g}"
        in (answer["sentence"])
    )


def test_from_the_touch_itself(gearlash: Gearlash, stop: str):
    answer = gearlash("graze", stop, "--near", repr(TOUCH), "--json", *linear_start(TOUCH)).answer
    assert [p["value"] for p in answer["points"]] == pytest.approx([TOUCH], abs=1e-11)
    assert [path["decided"] for path in answer["paths"]] == [True, True]


def test_from_beyond_the_resonance(gearlash: Gearlash, stop: str):
    answer = gearlash("graze", stop, "--near", "1.6", "--json", *linear_start(1.6)).answer
    (point,) = answer["points"]
    assert point["value"] == pytest.approx(RETURN, abs=1e-11)
    assert (point["label_below"], point["label_above"]) == ("1-1-0", "1-0-0")


def test_a_motion_without_a_grazing_says_how_far(gearlash: Gearlash, stop: str):
    ran = gearlash("graze", stop, "--near", "1.38", "--json", "--initial", "x=0.9989")
    assert ran.code == 3
    assert ran.answer["label"] == "1-1-0"
    assert ran.answer["points"] == []
    down, up = ran.answer["paths"]
    assert "the orbit ends in a fold" in up["ended"]
    assert [p["kind"] for p in up["passed"]] == ["fold"]
    shown = f"from omega = {down['reached']:.7g} to {up['reached']:.7g}"
    assert f"no grazing of this motion was found {shown}" in ran.answer["sentence"]


def test_nearest_is_not_said_where_the_other_way_was_lost(gearlash: Gearlash, stop: str):
    """No system can be built above 0.79: there a nearer touch may lie, for all that is known."""
    options = ["--set", "limit=1.61", "--near", "1.6", "--json", *linear_start(1.6)]
    answer = gearlash("graze", stop, *options).answer
    assert answer["points"][0]["value"] == pytest.approx(RETURN, abs=1e-11)
    assert "nearest grazing" not in answer["sentence"]
    assert "whether one lies nearer above is not known, followed to omega = 1.6" in answer["sentence"]
    up = next(path for path in answer["paths"] if path["direction"] == "up")
    assert not up["decided"]
    assert "no system can be built" in up["ended"]


def test_a_doubling_beyond_the_largest_period_ends_the_way(gearlash: Gearlash):
    options = ("--over", "D", "--near", "0.3855", "--set", "omega=0.78", "--max-period", "6", "--json")
    down = gearlash("graze", "article-first-harmonic", *options).answer["paths"][0]
    assert not down["decided"]
    assert "the period is longer than was to be followed (--max-period)" in down["ended"]


def test_what_was_not_found_is_told_in_the_unit_that_was_asked_for(gearlash: Gearlash):
    options = ("--over", "backlash", "--near", "0.1 mm", "--json")
    sentence = gearlash("graze", "article", *options).answer["sentence"]
    assert sentence.startswith("0.1 mm, 1-0-0: no grazing of this motion was found from 0.005 to 0.195 mm")


def test_two_extrema_that_touch_at_once_are_one_grazing(gearlash: Gearlash):
    """Without the error of the first harmonic the motion repeats twice a cycle: two minima touch together."""
    options = ("--near", "0.37", "--set", "error=0", "--set", "load=5", "--json")
    first = gearlash("graze", "article", *options).answer["points"][0]
    assert (first["label_below"], first["label_above"]) == ("1-2-0", "1-0-0")


def test_the_value_found_is_told_in_the_unit_that_was_asked_for(gearlash: Gearlash):
    options = ("--over", "mesh_frequency", "--near", "1.87 kHz", "--json")
    answer = gearlash("graze", "article", *options).answer
    assert answer["sentence"].startswith("1.87 kHz, 1-0-0: ")
    kilohertz = answer["asked"]["factor"] * answer["points"][0]["value"]
    assert f"{kilohertz:.8g} kHz (omega = " in answer["sentence"]
    for point in answer["points"]:
        assert point["margin"] == point["value"] - answer["near"]
        assert point["margin_asked"] == pytest.approx(answer["asked"]["factor"] * point["margin"], rel=1e-9)
    assert "found along this motion" in answer["sentence"]


def test_the_parameter_is_named_alone(gearlash: Gearlash):
    ran = gearlash("graze", "article", "--over", "pinion_speed=3600:4000rpm")
    assert ran.code == 2
    assert "the name of a parameter alone, such as pinion_speed" in " ".join(ran.complaint.split())


def test_a_boundary_that_is_jumped_over_is_said_to_be():
    """Where numbers of a system jump, H may change its sign without being 0. Here the load jumps by 1e-6 at
    the touch, in the middle between both signs."""
    case = load("kahraman-singh")
    family, _ = case.family()
    start = gl.point(family, {"load": 0.05}, name="load")
    path, touch = gl.first_grazing(family, "load", start, "down")
    assert touch is not None
    edge = touch.value - 5e-7

    def build(p: Mapping[str, float]) -> gl.System:
        return family.build({**p, "load": p["load"] + (1e-6 if p["load"] > edge else 0.0)})

    for model, note in ((family, ""), (replace(family, build=build), JUMPS)):
        path, touch = gl.first_grazing(model, "load", start, "down")
        assert touch is not None
        parameters = family.complete({"load": 0.05})
        answer = graze_answer(case, model, parameters, "load", "load", "", start, (path,), [touch])
        (found,) = answer.points
        assert (found.note, found.conditions[0].holds) == (note, not note)
        assert abs(found.conditions[0].value) == pytest.approx(
            5e-7 if note else 0.0, abs=1e-8 if note else 1e-12
        )
        shown = " ".join(str(line) for line in graze_view(answer, 100))
        assert ("does not hold to 1e-09" in shown) == bool(note)
