"""What is the same at every torque is told by whatever varies the torque: in words, in JSON and in files."""

from __future__ import annotations

from pathlib import Path

import pytest

import gearlash as gl
from cli.conftest import Gearlash

DRAWING = str(Path(__file__).resolve().parents[1] / "cases" / "drawing.toml")
RELIEF = "no tip relief is stated"
STATED = "stiffness and error are the same at every torque"


def words(text: str) -> str:
    """Without line ends."""
    return " ".join(text.split())


COMMANDS = (
    ("sweep", "article", "--over", "torque=90:91Nm:2"),
    ("map", "article", "--over", "torque=90:91Nm:2", "--over", "D=0.9:1:2"),
    ("branch", "article", "--over", "torque=96:98Nm"),
    ("graze", "article", "--over", "torque", "--set", "omega=1.05"),
    (
        *("tolerance", DRAWING, "--over", "pinion_speed=4100:4200rpm:2", "--limits", "torque=140:150Nm"),
        *("--samples", "2", "--replicates", "2"),
    ),
)  # fmt: skip


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command[0])
def test_a_command_over_torque_says_what_is_held(gearlash: Gearlash, command: tuple[str, ...]):
    ran = gearlash(*command)
    assert (RELIEF if DRAWING in command else STATED) in words(ran.out)
    assert "Assumed:" in ran.out


def test_json_has_the_sentence(gearlash: Gearlash):
    case = gl.load_case("article")
    ran = gearlash("branch", "article", "--over", "torque=96:98Nm", "--json")
    assert ran.answer["axis"]["held"] == case.held("load") == case.held("operation.torque")
    ran = gearlash("branch", "article", "--over", "omega=1.045:1.05", "--json")
    assert ran.answer["axis"]["held"] == case.held("omega") == ""


def test_a_dataset_has_the_sentence():
    case = gl.load_case("article")
    sweeps = [gl.sweep(case, gl.Axis.even("load", 0.05, 0.06, 2))]
    assert gl.sweep_dataset(case, sweeps).attrs["held"].startswith(STATED)
    beside = [gl.sweep(case, gl.Axis.even("omega", 1.05, 1.06, 2))]
    assert "held" not in gl.sweep_dataset(case, beside).attrs


def test_every_name_of_the_torque_has_it():
    case = gl.load_case(DRAWING)
    names = ("load", "torque", "gear_torque", "power", "operation.torque")
    assert {case.held(name) for name in names} == {case.held("load")} != {""}
    assert case.held("backlash") == case.held("nothing") == ""
