"""A branch as a dataset: its numbers, its extremes by the exact flow, and the way to disk and back."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import numpy as np
import pytest
import xarray as xr

import gearlash as gl


@cache
def branch() -> gl.Branch:
    case = gl.load_case("kahraman-singh")
    return gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5})


@cache
def dataset() -> xr.Dataset:
    return gl.branch_dataset(gl.load_case("kahraman-singh"), branch())


@cache
def six() -> tuple[gl.Branch, xr.Dataset]:
    """Of six cycles, in rpm and µm."""
    case = gl.load_case("article")
    values = {"omega": 0.78, "D": 0.365}
    found = gl.continue_branch(case, "D", lower=0.35, upper=0.39, values=values)
    return found, gl.branch_dataset(case, found)


def test_every_orbit_is_a_row_in_the_order_of_the_branch():
    found, data = branch(), dataset()
    assert data["omega"].dims == ("point",)
    np.testing.assert_array_equal(data["omega"].values, found.parameter)
    assert (np.diff(data["omega"].values) < 0.0).any(), "it turns round at its folds"
    assert (np.diff(data["arclength"].values) > 0.0).all()
    np.testing.assert_array_equal(data["stable"].values, [point.stable for point in found.points])
    assert data["label"].values.tolist() == [str(point.label) for point in found.points]
    np.testing.assert_array_equal(data["multiplier_modulus"].values[3], np.abs(found.points[3].multipliers))
    assert data["special_kind"].values.tolist() == ["grazing", "fold", "fold", "grazing"]
    assert data["special_value"].values.tolist() == [special.value for special in found.special]
    assert data["end_value"].values.tolist() == [end.value for end in found.ends]


def test_extremes_are_those_of_the_orbits():
    """Of a stable one as a study finds it; of an unstable one by closely read samples."""
    family, _ = gl.load_case("kahraman-singh").family()
    found, data = branch(), dataset()
    stable = int(np.argmax(found.parameter > 1.45))
    known = gl.point(family, {"omega": found.points[stable].value})
    for name in ("minimum", "maximum", "force_min", "force_max", "force_rms", "share_without_contact"):
        assert float(data[name][stable]) == pytest.approx(getattr(known, name), abs=1e-9)
    unstable = next(i for i, point in enumerate(found.points) if point.unstable)
    point = found.points[unstable]
    samples = gl.trace(family.system({"omega": point.value}), point.state, 1.0).samples(20_001)
    for name, read in (("minimum", samples.displacement.min()), ("maximum", samples.displacement.max())):
        assert float(data[name][unstable]) == pytest.approx(read, abs=1e-7)
    assert float(data["force_max"][unstable]) == pytest.approx(samples.force.max(), abs=1e-6)


def test_strobes_and_extremes_of_several_cycles():
    found, data = six()
    case = gl.load_case("article")
    known = gl.point(case, {"omega": 0.78, "D": found.points[0].value})
    assert data.sizes["strobe"] == 6
    stable = next(i for i, point in enumerate(found.points) if point.stable)
    known = gl.point(case, {"omega": 0.78, "D": found.points[stable].value})
    assert np.sort(data["strobes"].values[stable]) == pytest.approx(np.sort(known.strobes), abs=1e-8)
    for name in ("minimum", "maximum", "force_min", "force_max", "force_rms", "share_without_contact"):
        assert float(data[name][stable]) == pytest.approx(getattr(known, name), abs=1e-8)


def test_physical_values_and_units():
    found, data = six()
    case = gl.load_case("article")
    expected = [float(case.scales.backlash_um(point.value)) for point in found.points]
    assert data["backlash"].values == pytest.approx(expected, rel=1e-12)
    assert data["backlash"].attrs["units"] == "um"
    expected = [float(case.scales.backlash_um(special.value)) for special in found.special]
    assert data["special_backlash"].values == pytest.approx(expected, rel=1e-12)
    assert data["maximum"].attrs["physical_units"] == "um"
    for name, variable in data.variables.items():
        assert name == "state_name" or {"long_name", "units"} <= set(variable.attrs)


@pytest.mark.parametrize("made", [dataset, lambda: six()[1]])
def test_to_disk_and_back_and_as_a_table(made, tmp_path: Path):
    again = gl.load_dataset(gl.save_dataset(made(), tmp_path / "branch.nc"))
    assert again.identical(made())
    frame = gl.table(again)
    assert len(frame) == again.sizes["point"]
    assert {"label", "stable", "minimum", "maximum", again.attrs["axis"]} <= set(frame.columns)
    with xr.open_dataset(tmp_path / "branch.nc", group="special") as special:
        assert special["special_kind"].values.tolist() == made()["special_kind"].values.tolist()


def test_without_extremes_the_rest_is_the_same():
    found, data = six()
    less = gl.branch_dataset(gl.load_case("article"), found, extremes=False)
    left = {"minimum", "maximum", "force_min", "force_max", "force_rms", "share_without_contact"}
    gone = left | {f"special_{name}" for name in left}
    assert set(data.data_vars) - set(less.data_vars) == gone
    assert less.identical(data.drop_vars(gone))


def test_another_model_is_refused():
    family = gl.load_case("shaw-holmes").family()[0]
    with pytest.raises(gl.GearlashError, match="parameter"):
        gl.branch_dataset(family, six()[0])
