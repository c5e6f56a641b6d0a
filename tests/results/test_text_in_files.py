"""NetCDF files hold what MATLAB, Octave and old readers take: numbers, and text as characters."""

from __future__ import annotations

from io import BytesIO

import h5py
import numpy as np
import pytest
import xarray as xr

import gearlash as gl
from gearlash.results.columns import dataset_of_table
from gearlash.results.store import netcdf
from gearlash.studies.series import series_of

PLAIN = {"float64", "float32", "int64", "int32", "int16", "int8", "uint8", "|S1"}
"""NC_DOUBLE, NC_FLOAT, NC_INT64, NC_INT, NC_SHORT, NC_BYTE, NC_UBYTE and NC_CHAR."""
OF_HDF5 = {"DIMENSION_LIST", "REFERENCE_LIST"}
"""How the NetCDF library keeps dimensions: it shows them to nobody."""


def types_in(content: memoryview) -> dict[str, str]:
    """Type of every variable and attribute."""
    found: dict[str, str] = {}

    def look(name: str, item: h5py.Group | h5py.Dataset) -> None:
        if isinstance(item, h5py.Dataset):
            found[name] = str(item.dtype.newbyteorder("="))
        for attribute in set(item.attrs) - OF_HDF5:
            kept = h5py.h5a.open(item.id, attribute.encode()).get_type()
            text = isinstance(kept, h5py.h5t.TypeStringID)
            fixed = text and not kept.is_variable_str()
            found[f"{name}@{attribute}"] = "|S1" if fixed else "any length" if text else str(kept.dtype)

    with h5py.File(BytesIO(content)) as file:
        look("/", file)
        file.visititems(look)
    return found


@pytest.fixture(scope="module")
def made() -> dict[str, xr.Dataset]:
    case = gl.load_case("kahraman-singh")
    family = case.family()[0]
    speeds = gl.Axis.even("omega", 0.81, 0.83, 2)
    branch = gl.continue_branch(case, "omega", lower=1.4, upper=1.6, values={"omega": 1.5})
    orbit = gl.attractor(family.system(), family.start())
    pair, few = gl.load_case("article"), gl.Axis.even("omega", 1.04, 1.05, 2)
    return {
        "sweep": gl.sweep_dataset(pair, gl.sweeps(pair, few, ["up"])),
        "map": gl.plane_dataset(case, gl.map_plane(case, speeds, gl.Axis.even("D", 0.9, 1.1, 2))),
        "branch": gl.branch_dataset(case, branch),
        "history": dataset_of_table(series_of(case, family.defaults, orbit), "sample", {"case": "µ, ω"}),
    }


@pytest.mark.parametrize("name", ["sweep", "map", "branch", "history"])
def test_types_are_those_that_every_reader_has(made: dict[str, xr.Dataset], name: str):
    other = {where: kind for where, kind in types_in(netcdf(made[name])).items() if kind not in PLAIN}
    assert other == {}


def test_text_comes_back_as_it_was(tmp_path):
    texts = np.array(["1-0-0", "Φ über 0", ""], dtype=object)
    long = "what µ is not given; " * 10_000
    dataset = xr.Dataset(
        {
            "label": ("omega", texts),
            "empty": ("omega", np.array(["", "", ""])),
            "true": ("omega", np.array([True, False, True])),
            "point": (("omega", "state_name"), np.zeros((3, 2))),
        },
        {"omega": [1.0, 2.0, 3.0], "state_name": ["x", "x'"]},
        {"gearlash_format": 2, "message": "", "not_given": long},
    )
    content = netcdf(dataset)
    assert set(types_in(content).values()) <= PLAIN
    path = tmp_path / "texts.nc"
    path.write_bytes(content)
    assert gl.load_dataset(path).identical(dataset)
    with h5py.File(path) as file:
        label = file["label"]
        assert isinstance(label, h5py.Dataset)
        assert label.shape == (3, len("Φ über 0".encode()))


def test_files_with_text_of_any_length_are_still_read(tmp_path):
    """As they were written before."""
    dataset = xr.Dataset(
        {"label": ("omega", ["1-0-0", "aperiodic"])}, {"omega": [1.0, 2.0]}, {"gearlash_format": 2}
    )
    dataset.to_netcdf(tmp_path / "old.nc", engine="h5netcdf")
    assert "object" in types_in(memoryview((tmp_path / "old.nc").read_bytes())).values()
    assert gl.load_dataset(tmp_path / "old.nc").identical(dataset)
