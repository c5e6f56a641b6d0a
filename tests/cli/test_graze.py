"""gearlash graze: the points against the solver, closed forms, and what is said where there is none."""

from __future__ import annotations

import numpy as np
import pytest

from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.branches import locate_grazing
from gearlash.case import load
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema
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
    near = locate_grazing(FAMILY, values, "omega", orbit, grazing_checks(orbit)[0])
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
    shown = f"omega = {plain:.10g} ({load('article').scales.pinion_rpm(plain):.6g} rpm)"
    assert shown in " ".join(ran.out.split())
    assert "conditions" in ran.out


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
    assert "too far below" in ran.answer["message"]


def test_advice_is_given_once(gearlash: Gearlash):
    ran = gearlash("graze", "article", "--near", "0.9", "--periods", "200")
    assert ran.code == 3
    assert " ".join(ran.out.split()).count("allow more periods") == 1
