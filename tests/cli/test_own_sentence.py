"""The sentence of `run` for systems that need not have teeth."""

from __future__ import annotations

from pathlib import Path

import pytest

from cli.conftest import Gearlash


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("shaw-holmes",), "ω = 0.8: 1-1, stop met on side + once per cycle"),
        (("shaw-holmes", "--set", "gap=5"), "ω = 0.8: 1-0, stop never in contact"),
        (
            ("geared-rotor",),
            "ω = 0.5: 1-0-0/0-0/0-0, mesh always in contact on side +; bearing-1 always in contact on side "
            "-; bearing-2 always in contact on side +",
        ),
        (
            ("geared-rotor", "--set", "load=-0.1"),
            "ω = 0.5: 1-0-0/0-0/0-0, mesh always in contact on side -; bearing-1 always in contact on side "
            "+; bearing-2 always in contact on side -",
        ),
    ],
)
def test_contacts_are_told_by_name_and_side(gearlash: Gearlash, arguments: tuple[str, ...], sentence: str):
    assert gearlash("run", *arguments, "--json").answer["sentence"].startswith(f"{sentence}; ")


LOADED = """
kind = "piecewise-linear"
name = "loaded"
states = ["x", "v"]
[parameters]
omega = { value = 0.7, lower = 0.5, upper = 0.9 }
load = 0.3
[matrix]
x = { v = 1 }
v = { x = -1, v = -0.1 }
[forcing]
v = { mean = "load", cos = [1.5] }
[[clearance]]
name = "stop"
h = { x = 1 }
g = { v = -1 }
gap_plus = 3
gap_minus = 3
stiffness_plus = 10
stiffness_minus = 10
"""


def test_a_parameter_called_load_makes_no_teeth(gearlash: Gearlash, tmp_path: Path):
    """The search for speeds at which teeth never part is one for gear pairs; here it left the range of ω."""
    case = tmp_path / "loaded.toml"
    case.write_text(LOADED)
    ran = gearlash("run", str(case), "--json")
    assert ran.code == 0, ran.err
    assert ran.answer["impact_free"] is None
    assert "impact-free" not in ran.answer["sentence"]
