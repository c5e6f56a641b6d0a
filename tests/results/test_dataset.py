"""Sweeps as datasets: shapes, units, provenance, and the way to disk and back."""

from __future__ import annotations

import errno
import json
import os

import numpy as np
import pytest
import xarray as xr

import gearlash as gl
from gearlash import case, results
from gearlash.results import Axis, Point, Sweep, blank
from gearlash.system import GearlashError, Status

ARTICLE = case.load("article-first-harmonic")
AXIS = Axis("omega", np.array([0.9, 1.0, 1.1]))


def a_point(value: float, hits: int = 0, **more) -> Point:
    """A made-up point with so many impacts: datasets copy numbers, they compute none."""
    given = {
        "label": f"2-{hits}-0",
        "period": 2,
        "drive": hits,
        "leading": complex(-0.3, 0.4),
        "state": np.arange(10.0),
        "strobes": np.array([value, -value]),
        "drive_force": -(np.arange(hits) + value),
        "drive_phase": np.arange(hits) / 10,
        "minimum": -value,
        "maximum": value,
    }
    return Point(value, Status.OK, "made up", **(given | more))


def a_sweep(direction="cold", hits=(0, 1, 3)) -> Sweep:
    points = tuple(a_point(v, h) for v, h in zip(AXIS.values, hits, strict=True))
    return Sweep(AXIS, results.Direction(direction), points)


def test_every_number_of_a_point_is_there_padded_with_nan():
    data = results.sweep_dataset(ARTICLE, [a_sweep("up"), a_sweep("down", (2, 0, 0))])
    sizes = {"direction": 2, "omega": 3, "state_name": 10, "strobe": 2, "drive_hit": 3}
    assert dict(data.sizes) == sizes | {"back_hit": 1, "back_release": 1}
    np.testing.assert_array_equal(data["drive_force"].sel(direction="up", omega=1.1), [1.1, 2.1, 3.1])
    np.testing.assert_array_equal(data["drive_force"].sel(direction="up", omega=1.0), [1.0, np.nan, np.nan])
    assert data["drive_force"].attrs["long_name"].startswith("F = -Φ"), "the sign of Φ is turned in files"
    np.testing.assert_array_equal(data["drive"], [[0, 1, 3], [2, 0, 0]])
    np.testing.assert_array_equal(data["strobes"].sel(direction="down", omega=0.9), [0.9, -0.9])
    assert data["state"].sel(state_name="X'", omega=1.0, direction="up") == 9.0
    assert data["leading_modulus"].values == pytest.approx(np.full((2, 3), 0.5))
    assert data["label"].sel(direction="up").values.tolist() == ["2-0-0", "2-1-0", "2-3-0"]
    assert data["coexisting"].values.tolist() == [True, True, True]


def test_units_and_physical_counterparts():
    data = results.sweep_dataset(ARTICLE, [a_sweep()])
    for name, variable in data.variables.items():
        assert variable.attrs.get("long_name"), name
        assert (
            variable.dtype.kind in "UO" or name in ("direction", "state_name") or "units" in variable.attrs
        ), name
    scales = ARTICLE.scales
    np.testing.assert_allclose(data["pinion_speed"], scales.pinion_rpm(AXIS.values), rtol=1e-14)
    assert data["pinion_speed"].attrs["units"] == "rpm"
    np.testing.assert_allclose(data["mesh_frequency"], scales.mesh_hz(AXIS.values), rtol=1e-14)
    assert data["maximum"].attrs["physical_units"] == "um"
    assert data["maximum"].attrs["physical_factor"] == pytest.approx(50.0)  # D_c of a backlash of 100 µm
    assert data["drive_force"].attrs["physical_units"] == "N"
    assert data["drive_force"].attrs["physical_factor"] == pytest.approx(3.2e8 * 50e-6)


def test_a_case_without_scales_claims_no_physical_units():
    plain = case.load("kahraman-singh")
    sweep = Sweep(AXIS, results.Direction.COLD, tuple(a_point(v, state=np.zeros(2)) for v in AXIS.values))
    data = results.sweep_dataset(plain, [sweep])
    assert "pinion_speed" not in data.coords
    assert not any("physical_units" in v.attrs for v in data.variables.values())


def test_provenance_says_what_was_not_given():
    attrs = results.sweep_dataset(ARTICLE, [a_sweep()]).attrs
    assert attrs["case_hash"] == ARTICLE.hash
    assert case.Case.from_json(attrs["case_json"]).hash == ARTICLE.hash
    listed = {item["path"]: item["provenance"] for item in json.loads(attrs["not_given"])}
    assert listed["mesh.backlash"] == "assumed"
    assert listed["bearings.damping_ratio"] == "inferred"
    assert "mesh.mean_stiffness" not in listed
    assert json.loads(attrs["parameters"])["D"] == 1.0
    assert {"gearlash_version", "numpy_version", "numba_version"} <= set(attrs)


def test_an_incomplete_sweep_says_so():
    points = (a_point(0.9), blank(1.0, Status.NOT_COMPUTED, "cancelled"), blank(1.1, Status.FAILED, "no"))
    sweep = Sweep(AXIS, results.Direction.COLD, points, complete=False, message="cancelled")
    data = results.sweep_dataset(ARTICLE, [sweep])
    assert (data.attrs["complete"], data.attrs["message"]) == (0, "cancelled")
    assert data["status"].values.tolist() == [["ok", "not-computed", "failed"]]
    assert np.isnan(data["state"].values[0, 1:]).all()


def test_sweeps_that_do_not_belong_together_are_refused():
    other = Sweep(Axis("omega", AXIS.values + 1), results.Direction.UP, a_sweep().points)
    fixed = Sweep(AXIS, results.Direction.UP, a_sweep().points, fixed={"D": 0.5})
    pairs = (
        ([], "no sweep"),
        ([a_sweep(), other], "different axes"),
        ([a_sweep(), fixed], "fixed"),
        ([a_sweep(), a_sweep()], "same direction"),
    )
    for pair, text in pairs:
        with pytest.raises(GearlashError, match=text):
            results.sweep_dataset(ARTICLE, pair)


def test_disk_and_back_is_the_same(tmp_path):
    data = results.sweep_dataset(ARTICLE, [a_sweep("up"), a_sweep("down", (2, 0, 0))])
    path = results.save(data, tmp_path / "new" / "sweep.nc")
    again = results.load(path)
    xr.testing.assert_identical(again, data)
    assert results.content_hash(again) == results.content_hash(data)
    assert [p.name for p in path.parent.iterdir()] == ["sweep.nc"]


def test_a_file_is_replaced_whole_or_not_at_all(tmp_path, monkeypatch):
    path = results.save(results.sweep_dataset(ARTICLE, [a_sweep()]), tmp_path / "sweep.nc")
    before = path.read_bytes()

    def full(handle):
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match=r"No space left.*sweep\.nc'") as caught:
        results.save(results.sweep_dataset(ARTICLE, [a_sweep("up")]), path)
    assert caught.value.filename == str(path)
    assert path.read_bytes() == before
    assert [p.name for p in tmp_path.iterdir()] == ["sweep.nc"]


def test_files_of_others_are_refused(tmp_path):
    (tmp_path / "text.nc").write_text("not a dataset")
    xr.Dataset({"a": ("x", [1.0])}).to_netcdf(tmp_path / "other.nc", engine="h5netcdf")
    for name, text in (
        ("none.nc", "No such file"),
        ("text.nc", "not a NetCDF"),
        ("other.nc", "not one of gearlash"),
    ):
        with pytest.raises(GearlashError, match=text):
            results.load(tmp_path / name)


def test_the_hash_sees_every_change():
    data = results.sweep_dataset(ARTICLE, [a_sweep()])
    hashes = {results.content_hash(data)}
    for name, change in (("maximum", 1e-16), ("period", 1), ("strobes", -1e-300)):
        changed = data.copy(deep=True)
        changed[name] = changed[name] * (1 + change) if change == 1e-16 else changed[name] + change
        if change == 1e-16:
            changed[name].values[0, 0] = np.nextafter(data[name].values[0, 0], 9)
        if change == -1e-300:
            changed[name].values[0, 0, 0] = np.nextafter(data[name].values[0, 0, 0], 9)
        hashes.add(results.content_hash(changed))
    renamed = data.rename({"maximum": "most"})
    relabelled = data.copy(deep=True)
    relabelled["label"].values[0, 0] = "2-9-0"
    hashes |= {results.content_hash(renamed), results.content_hash(relabelled)}
    assert len(hashes) == 6
    assert results.content_hash(data.assign_attrs(title="other")) in hashes


def test_sweeps_of_a_model_with_other_states_are_refused_in_words():
    other, case = gl.load_case("article"), gl.load_case("kahraman-singh")
    found = gl.sweeps(other, gl.Axis.even("omega", 1.0, 1.02, 2), ["up"])
    with pytest.raises(gl.GearlashError, match="sweeps: their motions have 10 states, those of the model 2"):
        gl.sweep_dataset(case, found)
