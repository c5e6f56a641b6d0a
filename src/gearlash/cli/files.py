"""Datasets and figures in the folder of --out."""

from __future__ import annotations

import logging
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from gearlash.case import Case
from gearlash.results import PlaneMap, Sweep, plane_dataset, save, sweep_dataset

from .folder import OutFolder
from .interrupt import optional

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from gearlash.orbits import Attractor
    from gearlash.studies import Zones


logging.getLogger("fontTools").setLevel(logging.ERROR)  # it remarks on figures without a date


def write_sweep(folder: OutFolder, case: Case, sweeps: Sequence[Sweep]) -> None:
    """The dataset as NetCDF and, of a complete sweep, the bifurcation diagram as SVG and PDF."""
    dataset = sweep_dataset(case, sweeps)
    save(dataset, folder.file("sweep.nc"))
    complete = all(sweep.complete for sweep in sweeps)
    _draw(folder, "sweep", complete, lambda plots: plots.diagram(dataset, units=plots.Units.of(case)))


def write_zones(folder: OutFolder, case: Case, found: Sequence[Zones], present: float) -> None:
    """The sweeps as NetCDF and, where all was computed, the zones over them as SVG and PDF; ``present`` is
    the case's own value."""
    dataset = sweep_dataset(case, found[0].sweeps)
    save(dataset, folder.file("zones.nc"))
    title, complete = f"Zones of {case.name}", all(zones.complete for zones in found)
    _draw(
        folder, "zones", complete,
        lambda plots: plots.zone_bands(dataset, found, title, present, plots.Units.of(case)),
    )  # fmt: skip


def write_map(folder: OutFolder, case: Case, plane: PlaneMap) -> None:
    """The dataset as NetCDF and, of a complete map, the figure as SVG and PDF."""
    dataset = plane_dataset(case, plane)
    save(dataset, folder.file("map.nc"))
    _draw(folder, "map", plane.complete, lambda plots: plots.plane(dataset, units=plots.Units.of(case)))


def write_motion(folder: OutFolder, case: Case, attractor: Attractor) -> None:
    """Phase portrait and history of one motion as SVG and PDF."""
    from gearlash.studies.motion import motion

    found = motion(attractor)
    _draw(folder, "portrait", True, lambda plots: plots.portrait(found, units=plots.Units.of(case)))
    _draw(folder, "history", True, lambda plots: plots.history(found, units=plots.Units.of(case)))


def _draw(folder: OutFolder, name: str, complete: bool, figure: Callable[[Any], Figure]) -> None:
    """The figure of what was computed whole, as SVG and PDF; no older one stays beside what was not, or where
    a signal came before it was drawn."""

    def drawn() -> bool:
        from gearlash import plots

        plots.save(figure(plots), folder.file(name))
        return True

    if not (complete and optional(drawn)):
        for ending in (".svg", ".pdf"):
            folder.file(name + ending).unlink(missing_ok=True)
