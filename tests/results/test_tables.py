"""Result files as tables: one row a point, whatever else is in them, and whatever a parameter is called."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import gearlash as gl
from gearlash.results import blank
from gearlash.system import Status

SPUR = gl.load_case("kahraman-singh")


def read(path: Path):
    """As somebody without gearlash does."""
    with xr.open_dataset(path) as dataset:
        return dataset.to_dataframe()


def test_a_sweep_without_back_impacts_has_a_row_a_point(tmp_path: Path):
    sweeps = gl.sweeps(SPUR, gl.Axis.even("omega", 1.2, 1.4, 3), ("cold", "up"))
    assert not any(point.back for sweep in sweeps for point in sweep.points)
    frame = read(gl.save_dataset(gl.sweep_dataset(SPUR, sweeps), tmp_path / "sweep.nc"))
    assert frame.index.names == ["direction", "omega"]
    assert frame["label"].tolist() == [point.label for sweep in sweeps for point in sweep.points]
    assert frame.loc[("up", 1.4), "maximum"] == sweeps[1].points[2].maximum
    again = gl.table(gl.load_dataset(tmp_path / "sweep.nc"))
    assert again["label"].tolist() == frame["label"].tolist()


def test_long_motions_do_not_multiply_the_rows(tmp_path: Path):
    """Chaos has 200 strobes and hundreds of impacts on both sides: a row for every combination would not fit
    into any memory."""
    case = gl.load_case("article-first-harmonic")
    found = gl.sweep(case, gl.Axis("omega", np.array([1.0, 1.2])), settings=gl.Settings(budget=4000))
    assert len(found.points[1].strobes) == 200
    path = gl.save_dataset(gl.sweep_dataset(case, [found]), tmp_path / "sweep.nc")
    assert len(read(path)) == 2
    with xr.open_dataset(path, group="strobe") as group:
        strobes = group.to_dataframe()["strobes"].dropna()
    np.testing.assert_array_equal(strobes.loc["cold", 1.2], found.points[1].strobes)
    with xr.open_dataset(path, group="state_name") as group:
        state = group.to_dataframe()["state"].loc["cold", 1.0]
    np.testing.assert_array_equal(state, found.points[0].state)
    assert state.index.tolist() == list(case.family()[0].states)


def test_a_sweep_of_nothing_but_blanks_has_its_rows(tmp_path: Path):
    axis = gl.Axis.even("omega", 1.2, 1.4, 3)
    points = tuple(blank(float(value), Status.NOT_COMPUTED, "stopped") for value in axis.values)
    sweep = gl.Sweep(axis, "cold", points, complete=False)  # pyright: ignore[reportArgumentType]
    frame = read(gl.save_dataset(gl.sweep_dataset(SPUR, [sweep]), tmp_path / "sweep.nc"))
    assert frame["status"].tolist() == [Status.NOT_COMPUTED] * 3


@pytest.mark.parametrize("gaps", [(0.5, 1.0), (-2.0, -1.0)])
def test_a_map_has_a_row_a_pixel(gaps: tuple[float, float], tmp_path: Path):
    """All pixels of the second one fail, and it has no labels at all."""
    plane = gl.map_plane(SPUR, gl.Axis.even("omega", 1.2, 1.4, 3), gl.Axis.even("D", *gaps, 2))
    path = gl.save_dataset(gl.plane_dataset(SPUR, plane), tmp_path / "map.nc")
    frame = read(path)
    assert frame.index.names == ["D", "omega"]
    assert frame["label"].tolist() == plane.label.ravel().tolist()
    named = gl.table(gl.load_dataset(path))
    labels = [plane.label_at(row, column) for row in (0, 1) for column in range(3)]
    assert named["label"].tolist() == [label or "" for label in labels]
    assert set(named["status"]) == set(plane.statuses)
    with xr.open_dataset(path, group="label_name") as group:
        assert group["label_name"].values.tolist() == list(plane.labels or ("",))


@pytest.mark.parametrize("name", ["label", "status", "strobe", "direction", "state", "state_name", "a/b"])
def test_a_parameter_may_be_called_as_a_variable_is(name: str, tmp_path: Path):
    base = SPUR.family()[0]
    family = gl.Family(
        (gl.Parameter(name, 1.2), gl.Parameter("D", 1.0)), base.states,
        lambda values: base.system({"omega": values[name]}), lambda values: base.start(),
    )  # fmt: skip
    axis = gl.Axis.even(name, 1.2, 1.4, 2)
    frame = read(gl.save_dataset(gl.sweep_dataset(family, [gl.sweep(family, axis)]), tmp_path / "s.nc"))
    assert frame.reset_index().iloc[:, 1].tolist() == [1.2, 1.4]
    plane = gl.map_plane(family, axis, gl.Axis.even("D", 0.5, 1.0, 2))
    dataset = gl.load_dataset(gl.save_dataset(gl.plane_dataset(family, plane), tmp_path / "m.nc"))
    assert len(gl.table(dataset)) == 4
    from gearlash import plots

    plots.plane(dataset)
