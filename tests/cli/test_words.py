"""No command says words of gears of a system that has none."""

from __future__ import annotations

from pathlib import Path

import pytest

from cli.conftest import Gearlash

GEARS = ("mesh", "gear pair", "pinion", "teeth", "tooth", "backlash", "transmission error", "line of action")
STOP = """
kind = "piecewise-linear"
name = "stop"
states = ["x", "v"]
[parameters]
omega = 0.9
force = 1.0
error = 0.0
D = 1.3
load = 0.0
[matrix]
x = { v = 1 }
v = { x = -1, v = -0.08 }
[forcing]
v = { mean = "load + error", cos = ["force"] }
[[clearance]]
name = "stop"
h = { x = 1 }
g = { v = -1 }
gap_plus = "D"
gap_minus = 100
stiffness_plus = 15
stiffness_minus = 0
contact = "in-contact"
"""
COMMANDS = (
    ("check",),
    ("run",),
    ("run", "--set", "D=0.5"),
    ("sweep", "--over", "omega=0.8:0.9:3"),
    ("map", "--over", "omega=0.8:0.9:2", "--over", "D=1.2:1.3:2"),
    ("zones", "--over", "omega=0.85:0.95:3"),
    ("graze", "--over", "D"),
    ("branch", "--over", "D=1.2:1.4"),
)


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_no_word_of_gears_is_said_of_an_oscillator(
    gearlash: Gearlash, tmp_path: Path, command: tuple[str, ...]
):
    case = tmp_path / "stop.toml"
    case.write_text(STOP)
    name, *rest = command
    ran = gearlash(name, str(case), *rest)
    said = f"{ran.out}{ran.err}".lower()
    assert said
    for word in GEARS:
        assert word not in said
    if name == "run":
        assert "side +" in said
        assert "x + d⁻" not in said, "that side does not act"
