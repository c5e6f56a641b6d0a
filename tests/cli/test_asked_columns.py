"""In every table the varied parameter stands first in the unit that it was typed in."""

from __future__ import annotations

import re
from io import StringIO
from pathlib import Path

import pandas as pd
import pytest
from matplotlib.figure import Figure

import gearlash as gl
from cli.conftest import Gearlash
from gearlash import plots
from gearlash.plots.scales import scales

CASE = str(Path(__file__).parents[1] / "cases" / "drive.toml")
RPM = "pinion_speed=4050:4150rpm"


def heads(text: str) -> list[str]:
    return text.splitlines()[0].split(",")


@pytest.mark.parametrize(
    ("command", "first"),
    [
        (("sweep", CASE, "--over", f"{RPM}:2", "--up"), ["pinion_speed [rpm]"]),
        (
            ("map", CASE, "--over", f"{RPM}:2", "--over", "torque=140:150Nm:2"),
            ["pinion_speed [rpm]", "torque [N*m]"],
        ),
        (("graze", CASE, "--near", "4150rpm"), ["pinion_speed [rpm]"]),
        (("sweep", CASE, "--over", "backlash=0.07:0.08mm:2", "--up"), ["backlash [mm]"]),
        (("sweep", CASE, "--over", "omega=0.5:0.6:2", "--up"), ["omega"]),
    ],
)  # fmt: skip
def test_it_is_the_first_of_its_columns(gearlash: Gearlash, command: tuple[str, ...], first: list[str]):
    found = heads(gearlash(*command, "--csv").out)
    axes = [name for name in found if re.match(r"pinion_speed|torque|backlash|omega|load|D$|value", name)]
    assert axes[0] == first[0]
    assert [name for name in axes if name in first] == first
    dimensionless = [axes.index(name) for name in axes if name in ("omega", "load", "D", "value")]
    assert [axes.index(name) for name in first] <= dimensionless


def test_converted_speeds_are_as_they_were_typed(gearlash: Gearlash):
    ran = gearlash("sweep", CASE, "--over", "pinion_speed=3000:3300rpm:2", "--up", "--csv")
    assert [line.partition(",")[0] for line in ran.out.splitlines()[1:]] == ["3000.0", "3300.0"]


def test_special_points_and_stretches_have_units(gearlash: Gearlash, tmp_path: Path):
    assert (
        gearlash("branch", CASE, "--over", "pinion_speed=4050:4250rpm", "--csv", "--out", str(tmp_path)).code
        == 0
    )
    table = pd.read_csv(tmp_path / "special.csv")
    assert list(table.columns[:4]) == ["branch", "number", "pinion_speed [rpm]", "value"]
    assert {"mesh_frequency [Hz]", "maximum [um]", "force_max [N]"} <= set(table.columns)
    assert list(pd.read_csv(tmp_path / "branch-1.csv").columns[:3]) == [
        "pinion_speed [rpm]", "mesh_frequency [Hz]", "omega"
    ]  # fmt: skip


def test_a_history_begins_with_what_has_a_unit(gearlash: Gearlash):
    table = pd.read_csv(StringIO(gearlash("run", CASE, "--csv").out))
    names = list(table.columns)
    assert names[:3] == ["time [ms]", "mesh_cycle", "tau"]
    with_unit = [bool(re.search(r"\[", name)) for name in names[3:]]
    assert with_unit == sorted(with_unit, reverse=True)
    assert all(kind.kind == "f" for kind in table.dtypes)


DRAWN = str(Path(__file__).parents[1] / "cases" / "drawing.toml")


def test_a_quantity_that_varies_itself_is_told_in_its_unit_alone(gearlash: Gearlash):
    """Where estimates follow it, a quantity is the parameter, in SI: nobody reads 0.028 as millimetres."""
    asked = ("sweep", DRAWN, "--over", "gear.face_width=28:30mm:2", "--up")
    assert heads(gearlash(*asked, "--csv").out)[:2] == ["face_width [mm]", "direction"]
    for command in (asked, ("zones", *asked[1:-1]), ("graze", DRAWN, "--over", "gear.face_width")):
        out = gearlash(*command).out
        assert " mm" in out
        assert not re.search(r"(?<![\d.])0\.0(?:28|3)\b", out), command


def test_figures_of_such_a_quantity_have_one_scale_of_it():
    case = gl.load_case(DRAWN).varying("gear.face_width")
    twin = plots.Units.of(case).of_parameter("gear.face_width")
    assert twin is not None
    assert (twin.own, twin.unit, twin.assumed) == (True, "mm", False)
    figure = Figure()
    for first in (True, False):
        panel = figure.add_subplot()
        scales(panel, "x", "gear.face_width", twin, first=first)
        assert [each.get_xlabel() for each in (panel, *panel.child_axes)] == ["", twin.label]
