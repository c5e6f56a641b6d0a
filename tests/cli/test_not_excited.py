"""Where nothing excites a system, nothing was asked, and every command says so."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import gearlash as gl
from cli.conftest import Gearlash
from cli.schema_check import problems
from gearlash.cli.kinds import answer_kind
from gearlash.cli.schemas import answer_schema

CASES = Path(__file__).resolve().parents[1] / "cases"
DRIVE, STOP = str(CASES / "drive.toml"), str(CASES / "soft-stop.toml")
IDLE = ("--set", "ripple=0", "--set", "error=0um")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ((DRIVE, *IDLE), "4200 rpm: nothing excites this pair: no ripple, no error; it rests, teeth stay in"),
        (
            (DRIVE, *IDLE, "--set", "torque=-150 Nm"),
            "4200 rpm: nothing excites this pair: no ripple, no error; it rests, teeth stay in contact on",
        ),
        ((DRIVE, *IDLE, "--set", "torque=0 Nm"), "no ripple, no error; it rests, teeth never touch"),
        (("kahraman-singh", "--set", "error=0"), "ω = 0.5: nothing excites this pair: no ripple, no error"),
        ((STOP, "--set", "a=0"), "nothing excites this system, as nothing in it varies with time; it rests"),
    ],
)
def test_a_run_without_excitation_answers_nothing(gearlash: Gearlash, arguments: tuple[str, ...], words: str):
    ran = gearlash("run", *arguments, "--json")
    answer = ran.answer
    assert problems(answer, answer_schema(answer_kind("run"))) == []
    assert (ran.code, answer["status"]) == (3, "not-excited")
    assert words in answer["sentence"]
    assert answer["certificate"]["verdict"] == "uncertain"
    assert answer["impact_free"] is answer["beside"] is None
    assert "give " in answer["advice"]


@pytest.mark.parametrize("arguments", [(DRIVE,), (DRIVE, "--set", "ripple=0"), (DRIVE, "--set", "error=0um")])
def test_one_excitation_is_enough(gearlash: Gearlash, arguments: tuple[str, ...]):
    ran = gearlash("run", *arguments, "--json")
    assert (ran.code, ran.answer["status"]) == (0, "ok")


@pytest.mark.parametrize("command", ["sweep", "zones"])
def test_studies_without_excitation_answer_nothing(gearlash: Gearlash, command: str):
    ran = gearlash(command, DRIVE, *IDLE, "--over", "pinion_speed=4000rpm:4400rpm:3", "--json")
    assert problems(ran.answer, answer_schema(answer_kind(command))) == []
    assert (ran.code, ran.answer["status"]) == (3, "not-excited")
    assert "nothing excites this pair: no ripple, no error (at 3 values looked at)" in ran.answer["sentence"]


def test_a_map_and_a_graze_without_excitation_answer_nothing(gearlash: Gearlash):
    over = ("--over", "a=0:0.1:2", "--over", "omega=0.4:0.5:2")
    ran = gearlash("map", STOP, "--set", "beta=29", *over, "--json")
    assert ran.answer["status"] == "ok"  # at a = 0.1 something does
    over = ("--over", "zeta=0.05:0.1:2", "--over", "omega=0.4:0.5:2")
    ran = gearlash("map", STOP, "--set", "a=0", *over, "--json")
    assert (ran.code, ran.answer["status"]) == (3, "not-excited")
    ran = gearlash("graze", "kahraman-singh", "--set", "error=0", "--json")
    assert (ran.code, ran.answer["status"]) == (3, "not-excited")
    assert "nothing excites this pair" in ran.answer["sentence"]


def test_what_varies_but_moves_nothing_is_no_question_either(gearlash: Gearlash, tmp_path: Path):
    """A spring whose stiffness varies, at rest where it is not strained."""
    text = Path(STOP).read_text(encoding="utf-8")
    case = tmp_path / "still.toml"
    case.write_text(
        text.replace("stiffness_minus = 0", "stiffness_minus = { mean = 1.0, cos = [0.1] }").replace(
            'cos = ["a/e*omega^2"]', "mean = 0"
        ),
        encoding="utf-8",
    )
    ran = gearlash("run", str(case), "--json")
    assert (ran.code, ran.answer["status"]) == (3, "not-excited")
    assert "what varies with time does not move it; it rests" in ran.answer["sentence"]


def test_excited_looks_at_what_acts():
    one, varying = np.array([1.0]), np.array([1.0, 0.0, 0.1])
    matrix, none = np.array([[0.0, 1.0], [-1.0, -0.1]]), np.zeros((2, 3))
    h, g = np.array([1.0, 0.0]), np.array([0.0, -1.0])

    def system(forcing: np.ndarray, plus: np.ndarray, offset: np.ndarray, damping: float = 0.0) -> gl.System:
        stop = gl.Clearance(h, g, 1.0, 1.0, plus, np.array([0.0]), damping, offset)
        return gl.System(1.0, matrix, forcing, (stop,))

    still = np.array([0.0])
    assert not system(none, one, still).excited
    assert system(none, varying, still).excited
    assert system(none, one, varying).excited
    assert not system(none, still, varying).excited  # no stop at all
    assert system(none, still, varying, damping=0.1).excited  # damping of the gap reads the offset
    forced = none.copy()
    forced[1, 2] = 1.0
    assert system(forced, one, still).excited
    forced = none.copy()
    forced[1, 0] = 1.0
    assert not system(forced, one, still).excited
