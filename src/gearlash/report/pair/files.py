"""Data beside a report: curves over speed, histories and order spectra as CSV and NetCDF, with units."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from gearlash.results.columns import POINTS, Column, CsvStyle, csv_bytes
from gearlash.results.pair_units import PairUnits, Unit
from gearlash.results.provenance import provenance
from gearlash.results.store import netcdf
from gearlash.studies.history import History, spectrum
from gearlash.studies.speed_run import SpeedRun
from gearlash.system import label_text

from .contents import Contents
from .motions import level, unit_of

FORMAT_VERSION = 2
Columns = dict[str, NDArray]
NAMES = ("nominal", "hardest")
VERDICT = "verdict.json"
"""The answer of the command that makes a report, beside its page."""


def data_files(contents: Contents, style: CsvStyle = POINTS) -> dict[str, bytes]:
    """Every file by name."""
    units, found = contents.units, {}
    about = {"gearlash_format": FORMAT_VERSION, **provenance(contents.found.case)}
    if contents.run is not None:
        columns = speed_columns(contents.run, units)
        found["speed.csv"] = as_csv(columns, style)
        found["speed.nc"] = _netcdf(columns, "row", about)
    for name, one in zip(NAMES, contents.histories, strict=False):
        for stem, columns, dim in (
            (f"history-{name}", history_columns(one, units), "sample"),
            (f"spectrum-{name}", spectrum_columns(one, units), "line"),
        ):
            found[f"{stem}.csv"] = as_csv(columns, style)
            found[f"{stem}.nc"] = _netcdf(columns, dim, about)
    return found


def file_names() -> list[str]:
    """All that `data_files` may write."""
    stems = ["speed", *(f"{kind}-{name}" for kind in ("history", "spectrum") for name in NAMES)]
    return [f"{stem}{ending}" for stem in stems for ending in (".csv", ".nc")]


def speed_columns(run: SpeedRun, units: PairUnits) -> Columns:
    """A row for every point of both sweeps."""
    ways = [str(way.direction) for way in run.sweeps]
    count = len(run.axis.values)
    columns: Columns = {
        "direction": np.repeat(np.array(ways), count),
        _named("speed", units.speed): np.tile(units.speed.factor * run.axis.values, len(ways)),
        "omega": np.tile(run.axis.values, len(ways)),
        "motion": np.array([label_text(p.label) for way in run.sweeps for p in way.points]),
    }

    def add(name: str, read: str, unit: Unit) -> None:
        rows = [unit.factor * run.column(i, read) for i in range(len(ways))]
        columns[_named(name, unit)] = np.concatenate(rows)

    for which in ("most", "least", "mean", "rms"):
        add(f"mesh_force_{_WORDS[which]}", f"force.{which}", units.force)
    for readout in run.readouts:
        unit = unit_of(units, readout.quantity)
        for which in ("most", "least", "mean", "rms"):
            add(f"{readout.name}_{_WORDS[which]}", f"{readout.name}.{which}", unit)
        add(f"{readout.name}_peak", f"{readout.name}.peak", unit)
        add(f"{readout.name}_peak_to_peak", f"{readout.name}.peak_to_peak", unit)
    add("gap_largest", "gap.most", units.length)
    add("gap_least", "gap.least", units.length)
    add("impact_velocity_drive", "impact_velocity", units.velocity)
    add("impact_velocity_back", "back_velocity", units.velocity)
    add("share_without_contact", "share_without_contact", Unit(1.0, "", ""))
    return columns


_WORDS = {"most": "largest", "least": "least", "mean": "mean", "rms": "rms_about_mean"}


def history_columns(one: History, units: PairUnits) -> Columns:
    """A row for every sample."""
    tau = 2.0 * np.pi * one.phase / one.omega
    columns: Columns = {_named("time", units.time): units.time.factor * tau, "mesh_cycle": one.phase}
    for what, row in zip(one.what, one.values, strict=True):
        unit = unit_of(units, what.quantity)
        columns[_named(what.name, unit)] = unit.factor * row
    return columns


def spectrum_columns(one: History, units: PairUnits) -> Columns:
    """A row for every line: order of mesh frequency, then of every quantity rms, phase and level."""
    lines = spectrum(one)
    columns: Columns = {"order": lines.order}
    for what, rms, phase in zip(one.what, lines.rms, lines.phase, strict=True):
        unit = unit_of(units, what.quantity)
        columns[_named(f"{what.name}_rms", unit)] = unit.factor * rms
        columns[f"{what.name}_phase_rad"] = phase
        columns[f"{what.name}_dB_re_{unit.reference_name.replace(' ', '').replace('µ', 'u')}"] = level(
            rms, unit
        )
    return columns


def _named(name: str, unit: Unit) -> str:
    return f"{name}_{unit.ascii}" if unit.ascii else name


def as_csv(columns: Columns, style: CsvStyle) -> bytes:
    """Names with units in the first line; what is not a number stays empty."""
    return csv_bytes([Column(name, values) for name, values in columns.items()], style)


def _netcdf(columns: Mapping[str, NDArray], dim: str, about: Mapping[str, object]) -> bytes:
    data = {name: (dim, values) for name, values in columns.items()}
    return bytes(netcdf(xr.Dataset(data, attrs=dict(about))))
