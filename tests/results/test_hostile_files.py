"""Files of results that are damaged, or none at all, are refused in a few words."""

from __future__ import annotations

import os
import random
import sys
from pathlib import Path

import pytest
import xarray as xr

import gearlash as gl
from gearlash.results import store

SPUR = gl.load_case("kahraman-singh")


@pytest.fixture(scope="module")
def right(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """A sweep with impacts, as saved."""
    found = gl.sweeps(SPUR, gl.Axis.even("omega", 0.8, 1.2, 3), ("cold", "up"))
    path = tmp_path_factory.mktemp("right") / "sweep.nc"
    return gl.save_dataset(gl.sweep_dataset(SPUR, found), path).read_bytes()


def refusal(path: Path) -> str:
    """What is told of a file, in a few words; nothing where it is taken."""
    try:
        gl.load_dataset(path)
    except gl.GearlashError as error:
        told = str(error)
    else:
        told = ""
    assert len(told) < 700
    return told


def test_bytes_that_are_lost_or_changed(right: bytes, tmp_path: Path):
    path, choose, told = tmp_path / "sweep.nc", random.Random(5), set()
    for _ in range(200):
        data = bytearray(right)
        for _ in range(choose.choice((1, 3, 30))):
            at = choose.randrange(len(data))
            data[at : at + choose.choice((1, 8, 100))] = choose.randbytes(choose.choice((0, 1, 8)))
        path.write_bytes(data if choose.random() < 0.8 else data[: choose.randrange(len(data))])
        told.add(bool(refusal(path)))
    assert told == {True, False} or told == {True}


@pytest.mark.parametrize(
    "content", [b"", b"{}", b"[" * 1_000_000, b"CDF\x01" + bytes(99), b"\x89HDF\r\n\x1a\n"]
)
def test_what_is_no_such_file(content: bytes, tmp_path: Path):
    path = tmp_path / "sweep.nc"
    path.write_bytes(content)
    assert "not a NetCDF file of gearlash" in refusal(path)


def test_a_file_of_somebody_else(tmp_path: Path):
    path = tmp_path / "other.nc"
    xr.Dataset({"a": ("x", [1.0])}).to_netcdf(path, engine="h5netcdf")
    assert "not one of gearlash" in refusal(path)


def test_no_file_and_too_large_a_file(right: bytes, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    assert "No such file" in refusal(tmp_path / "none.nc")
    assert "it is a directory" in refusal(tmp_path)
    path = tmp_path / "sweep.nc"
    path.write_bytes(right)
    monkeypatch.setattr(store, "LARGEST_FILE", 1000)
    assert "larger than" in refusal(path)
    monkeypatch.setattr(store, "check_file", lambda *_: None)
    assert "holds more than" in refusal(path)


@pytest.mark.skipif(sys.platform == "win32", reason="devices and pipes as POSIX has them")
def test_what_has_no_end(tmp_path: Path):
    pipe = tmp_path / "pipe.nc"
    os.mkfifo(pipe)
    assert "no regular file" in refusal(pipe)
    assert "no regular file" in refusal(Path("/dev/zero"))


def test_a_map_whose_codes_say_nothing():
    axes = gl.Axis.even("omega", 0.8, 1.2, 2), gl.Axis.even("D", 0.8, 1.2, 2)
    dataset = gl.plane_dataset(SPUR, gl.map_plane(SPUR, *axes))
    dataset["status"].attrs["flag_meanings"] = 3
    with pytest.raises(gl.GearlashError, match="codes that say nothing"):
        gl.table(dataset)
