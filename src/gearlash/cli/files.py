"""Datasets and figures in the folder of --out."""

from __future__ import annotations

import logging
from collections.abc import Sequence
from typing import TYPE_CHECKING

from gearlash.case import Case
from gearlash.results import PlaneMap, Sweep, plane_dataset, save, sweep_dataset

from .folder import OutFolder

if TYPE_CHECKING:
    from gearlash.orbits import Attractor
    from gearlash.studies import Zones


logging.getLogger("fontTools").setLevel(logging.ERROR)  # it remarks on figures without a date


def write_sweep(folder: OutFolder, case: Case, sweeps: Sequence[Sweep]) -> None:
    """The dataset as NetCDF and, of a complete sweep, the bifurcation diagram as SVG and PDF."""
    dataset = sweep_dataset(case, sweeps)
    save(dataset, folder.file("sweep.nc"))
    if all(sweep.complete for sweep in sweeps):
        from gearlash import plots

        plots.save(plots.diagram(dataset, units=plots.Units.of(case)), folder.file("sweep"))


def write_zones(folder: OutFolder, case: Case, found: Sequence[Zones], present: float) -> None:
    """The sweeps as NetCDF and, where all was computed, the zones over them as SVG and PDF; ``present`` is
    the case's own value."""
    dataset = sweep_dataset(case, found[0].sweeps)
    save(dataset, folder.file("zones.nc"))
    if all(zones.complete for zones in found):
        from gearlash import plots

        figure = plots.zone_bands(dataset, found, f"Zones of {case.name}", present, plots.Units.of(case))
        plots.save(figure, folder.file("zones"))


def write_map(folder: OutFolder, case: Case, plane: PlaneMap) -> None:
    """The dataset as NetCDF and, of a complete map, the figure as SVG and PDF."""
    dataset = plane_dataset(case, plane)
    save(dataset, folder.file("map.nc"))
    if plane.complete:
        from gearlash import plots

        plots.save(plots.plane(dataset, units=plots.Units.of(case)), folder.file("map"))


def write_motion(folder: OutFolder, case: Case, attractor: Attractor) -> None:
    """Phase portrait and history of one motion as SVG and PDF."""
    from gearlash import plots
    from gearlash.studies.motion import motion

    found = motion(attractor)
    units = plots.Units.of(case)
    plots.save(plots.portrait(found, units=units), folder.file("portrait"))
    plots.save(plots.history(found, units=units), folder.file("history"))
