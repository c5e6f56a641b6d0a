"""--csv: tables on standard output or in the folder, for pandas, xarray and spreadsheets."""

from __future__ import annotations

from io import StringIO
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import gearlash as gl
from cli.conftest import Gearlash
from gearlash.case.columns import read_columns
from gearlash.cli.answers.reproduce import Claim, Part
from gearlash.cli.tables import table_of
from gearlash.results.columns import COMMAS, Column, csv_text

SPUR = ("kahraman-singh", "--set", "omega=0.9")


def test_a_table_as_text():
    table = [
        Column("force", [1.5, float("nan"), None], "N·m"),
        Column("label", ["1-1-0", "a;b", ""]),
        Column("stable", np.array([True, False, True])),
        Column("count", np.array([1, 2, 3])),
    ]
    assert csv_text(table) == "force [N*m],label,stable,count\n1.5,1-1-0,1,1\n,a;b,0,2\n,,1,3\n"
    assert csv_text(table, COMMAS).splitlines()[1:3] == ["1,5;1-1-0;1;1", ';"a;b";0;2']


@pytest.mark.slow
def test_a_run_as_history_spectrum_and_events(gearlash: Gearlash, tmp_path: Path):
    assert gearlash("run", *SPUR, "--decimal-comma", "--out", str(tmp_path)).code == 0
    history = pd.read_csv(tmp_path / "history.csv", sep=";", decimal=",")
    with xr.open_dataset(tmp_path / "history.nc") as data:
        assert data["X"].attrs == {"units": "1", "long_name": "state X"}
        assert {"mesh_cycle", "tau"} <= set(data.coords)
        assert data["X"].values == pytest.approx(history["X"].to_numpy(), rel=1e-15)
    assert len(history) == 256
    case = gl.load_case("kahraman-singh", {"omega": 0.9})
    orbit = gl.attractor(case.family()[0].system(), case.family()[0].start())
    assert isinstance(orbit, gl.Orbit)
    samples = orbit.trace.at(history["mesh_cycle"].to_numpy())
    assert history["Phi"].to_numpy() == pytest.approx(samples.force, abs=1e-12)
    lines = pd.read_csv(tmp_path / "spectrum.csv", sep=";", decimal=",")
    power = float(np.sum(lines["Phi_rms"].to_numpy() ** 2))  # with the mean in order 0
    assert power == pytest.approx(float(np.mean(history["Phi"].to_numpy() ** 2)), rel=1e-6)
    first = lines.set_index("order").loc[1.0]
    assert first["Phi_level [dB re 1]"] == pytest.approx(20.0 * np.log10(first["Phi_rms"]))
    events = pd.read_csv(tmp_path / "events.csv", sep=";", decimal=",")
    assert events["event"].tolist() == ["engagement", "release"]
    assert read_columns(tmp_path / "history.csv").names == tuple(history.columns)
    assert gearlash("run", *SPUR, "--out", str(tmp_path)).code == 0
    assert not (tmp_path / "events.csv").exists()  # it would be that of another command


def test_the_history_of_a_pair_has_units(gearlash: Gearlash):
    ran = gearlash("run", "article", "--csv")
    table = pd.read_csv(StringIO(ran.out))
    factor = gl.load_case("article").scales.force_N(1.0)
    assert table["mesh_force [N]"].to_numpy() == pytest.approx(factor * table["Phi"].to_numpy())
    assert {"time [ms]", "transmission_error [um]", "bearing_force_yp [N]"} <= set(table.columns)


def test_the_main_table_is_printed_and_nothing_else(gearlash: Gearlash):
    ran = gearlash("sweep", "article", "--over", "pinion_speed=3990:4010rpm:2", "--up", "--csv")
    table = pd.read_csv(StringIO(ran.out))
    assert table["pinion_speed [rpm]"].tolist() == pytest.approx([3990.0, 4010.0])
    assert {"force_max", "force_max [N]", "label"} <= set(table.columns)
    assert {"bearing_force_yp_peak [N]", "transmission_error_rms [um]"} <= set(table.columns)
    wide, rms = (table[f"transmission_error_{name} [um]"].to_numpy() for name in ("peak_to_peak", "rms"))
    assert np.all(wide > 2.0 * rms)
    ran = gearlash("map", "kahraman-singh", "--over", "omega=0.7:0.9:2", "--over", "D=0.9:1.1:2",
                   "--decimal-comma")  # fmt: skip
    table = pd.read_csv(StringIO(ran.out), sep=";", decimal=",")
    assert table["label"].tolist() == ["1-0-0", "1-1-0"] * 2
    assert table["D"].tolist() == [0.9, 0.9, 1.1, 1.1]


def test_points_and_zones_with_their_ends(gearlash: Gearlash, tmp_path: Path):
    table = pd.read_csv(StringIO(gearlash("graze", "kahraman-singh", "--near", "0.8", "--csv").out))
    assert table["value"].tolist() == pytest.approx([0.8206310877], abs=1e-9)
    ran = gearlash("zones", "kahraman-singh", "--over", "omega=0.7:0.9:5", "--csv", "--out", str(tmp_path))
    assert ran.code == 0
    zones = pd.read_csv(tmp_path / "zones.csv")
    assert zones["upper_kind"].tolist()[:2] == ["fold", "grazing"]
    living = pd.read_csv(tmp_path / "residents.csv")
    assert set(living["zone"]) <= set(range(1, len(zones) + 1))
    assert len(pd.read_csv(tmp_path / "sweep.csv")) == 15


def test_what_a_case_says(gearlash: Gearlash, tmp_path: Path):
    table = pd.read_csv(StringIO(gearlash("check", "article", "--csv").out)).set_index("path")
    assert table.loc["pinion.teeth", "value"] == 28.0
    assert table.loc["pinion.mass", ["value", "unit", "origin"]].tolist() == [5.98, "kg", "given"]
    assert table["value"].dtype.kind == "f"
    drawn = str(Path(__file__).parents[1] / "cases" / "drawing.toml")
    assert gearlash("check", drawn, "--decimal-comma", "--out", str(tmp_path)).code == 0
    values = pd.read_csv(tmp_path / "check.csv", sep=";", decimal=",").set_index("path")
    stiffness = values.loc["mesh.mean_stiffness"]
    assert stiffness["least"] < stiffness["value"] < stiffness["greatest"]
    assert (tmp_path / "check.csv").read_bytes().startswith(b"\xef\xbb\xbfpath;symbol;")
    assert list(pd.read_csv(tmp_path / "notes.csv", sep=";").columns) == ["path", "text"]


def test_claims_of_the_article():
    part = Part("half", "1", "1.1", "shifted", "")
    claim = Claim("a", "said", "omega", "D = 1", "1", "1,5", 1.0, 1.5, 0.5, "1-0-0", "1-1-0", "shifted",
                  "", "µ, or not", ("mesh.error",), "", False, (part,))  # fmt: skip
    claims = table_of([claim], Claim)
    read = pd.read_csv(StringIO(csv_text(claims)))
    assert read.loc[0, ["id", "computed_value", "note"]].tolist() == ["a", 1.5, "µ, or not"]
    assert read.loc[0, "rests_on"] == "mesh.error"


def test_two_answers_do_not_share_standard_output(gearlash: Gearlash):
    ran = gearlash("run", "kahraman-singh", "--csv", "--json")
    assert ran.code == 2
    assert "one of --json and --csv" in ran.out + ran.err
