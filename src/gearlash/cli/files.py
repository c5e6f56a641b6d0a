"""Datasets and figures in the folder of --out."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterator, Sequence
from math import isclose
from typing import TYPE_CHECKING, Any

from gearlash.case import Case
from gearlash.case.units import pretty
from gearlash.results import PlaneMap, Sweep, plane_dataset, sweep_dataset
from gearlash.results.dataset import FORMAT_VERSION
from gearlash.results.physical import backlash_words
from gearlash.results.store import netcdf, write_together
from gearlash.system import Signature

from .folder import MOTION_FILES, OutFolder
from .interrupt import optional
from .jsonio import text
from .second_scale import second_scale

if TYPE_CHECKING:
    import numpy as np
    import xarray as xr
    from matplotlib.figure import Figure
    from numpy.typing import NDArray

    from gearlash.orbits import Attractor
    from gearlash.studies import Zones
    from gearlash.studies.transition import Transition

    from .answers.run import RunAnswer
    from .answers.zones import ZonesAnswer


GRAZING = "grazing"
MAIN_VALUES = ("omega", "pinion_speed"), ("load", "torque"), ("D", "backlash")
"""Short names of what a figure is drawn at, and the physical quantities that stand for them."""
SAME = 1e-9  # of a value: two directions of a sweep met one point

logging.getLogger("fontTools").setLevel(logging.ERROR)  # it remarks on figures without a date


def write_data(
    folder: OutFolder, name: str, dataset: xr.Dataset, answer: Any, figures: Sequence[str] = ()
) -> None:
    """Data and answer of one study, both or none, in place of earlier ones with their ``figures``."""
    contents = {
        folder.file(f"{name}.nc"): netcdf(dataset),
        folder.file(f"{name}.json"): text(answer).encode("utf-8"),
    }
    write_together(contents, instead_of=folder.outdated(f"{name}.json", figures))


def write_sweep(
    folder: OutFolder, case: Case, sweeps: Sequence[Sweep], answer: Any, changes: Sequence[Transition] = ()
) -> None:
    """Data (NetCDF) and answer (JSON) and, of a complete sweep, the bifurcation diagram as SVG and PDF, with
    the special points at which its motions change."""
    dataset = sweep_dataset(case, sweeps)
    write_data(folder, "sweep", dataset, answer, ("sweep.svg", "sweep.pdf"))
    asked, name = answer.axis.asked, sweeps[0].axis.name
    title = f"{case.name}: sweep over {asked.title}{at_what(case, name)}"
    present = case.family()[0].defaults[name]

    def figure(plots: Any) -> Figure:
        typed = second_scale(asked)
        units = plots.Units.of(case)
        marks = [
            plots.Mark(value, kind, "" if kind != GRAZING else f"{asked.factor * value:.5g}")
            for value, kind in _once(changes)
        ]
        return plots.diagram(
            dataset, marks, units, title=title, present=present, asked=typed, apart=_apart(case, sweeps)
        )

    draw_if(folder, "sweep", _drawable(sweeps), figure)


def _apart(case: Case, sweeps: Sequence[Sweep]) -> tuple[NDArray[np.bool_], ...]:
    """Steps of sweeps over which no line is drawn; it is told how many are looked at."""
    from gearlash.studies.joined import apart_in

    from .progress import progress_bar

    with progress_bar("steps of the figure, each followed") as progress:
        return apart_in(case, sweeps, progress)


def _once(changes: Sequence[Transition]) -> Iterator[tuple[float, str]]:
    """Value and kind of every change, those that several directions show once."""
    last = None
    for change in sorted(changes, key=lambda each: each.value):
        if last is None or change.kind != last.kind or not isclose(change.value, last.value, rel_tol=SAME):
            yield change.value, change.kind
        last = change


def write_zones(folder: OutFolder, case: Case, found: Sequence[Zones], answer: ZonesAnswer) -> None:
    """The sweeps (NetCDF) and the answer (JSON) and, where all was computed, the zones over the sweeps as SVG
    and PDF."""
    dataset = sweep_dataset(case, found[0].sweeps)
    write_data(folder, "zones", dataset, answer, ("zones.svg", "zones.pdf"))
    title = f"Zones of {case.name}{at_what(case, found[0].axis.name)}"
    sweeps = found[0].sweeps

    def figure(plots: Any) -> Figure:
        scales = plots.Units.of(case), second_scale(answer.asked)
        return plots.zone_bands(dataset, found, title, answer.present, *scales, _apart(case, sweeps))

    draw_if(folder, "zones", all(zones.complete for zones in found) and _drawable(sweeps), figure)


def at_what(case: Case, *varied: str) -> str:
    """Where a figure is drawn, behind its title: speed, torque and backlash of a case in physical units, else
    as the numbers that they are, but for what is ``varied``, an estimate as such; empty without."""
    family = case.family()[0]
    told, assumed = [], {value.path for value in case.values() if value.uncertain}
    for short, leaf in MAIN_VALUES:
        if short in varied or short not in family.defaults:
            continue
        named = case.physical(short, family.defaults[short])
        if not named:
            told.append(f"{'ω' if short == 'omega' else short} = {family.defaults[short]:.4g}")
        for path, value, unit in named:
            if path.rpartition(".")[2] in (leaf, f"{leaf}_at_work"):
                size = f"about {float(value):.3g}" if path in assumed else f"{float(value):.5g}"
                told.append(
                    f"{size} {pretty(unit)}{f' {backlash_words(case)}' if leaf == 'backlash' else ''}"
                )
    return f", at {', '.join(told)}" if told else ""


def _drawable(sweeps: Sequence[Sweep]) -> bool:
    """Whether all was computed, and there is a motion to draw in each."""
    return all(sweep.complete and any(point.computed for point in sweep.points) for sweep in sweeps)


def write_map(folder: OutFolder, case: Case, plane: PlaneMap, answer: Any) -> None:
    """Data (NetCDF) and answer (JSON) and, of a complete map, the figure as SVG and PDF."""
    dataset = plane_dataset(case, plane)
    write_data(folder, "map", dataset, answer, ("map.svg", "map.pdf"))
    asked = answer.x.asked, answer.y.asked
    over = f"{asked[0].title} and {asked[1].title}{at_what(case, answer.x.name, answer.y.name)}"

    def figure(plots: Any) -> Figure:
        typed = [second_scale(one) for one in asked]
        title = f"{case.name}: map over {over}"
        return plots.plane(dataset, units=plots.Units.of(case), along=typed, title=title)

    draw_if(folder, "map", plane.complete, figure)


def write_motion(folder: OutFolder, case: Case, attractor: Attractor, answer: RunAnswer) -> None:
    """The answer (JSON) and, where a motion was found, phase portrait and history as SVG and PDF."""
    older = folder.outdated("run.json", MOTION_FILES)
    write_together({folder.file("run.json"): text(answer).encode("utf-8")}, instead_of=older)
    from gearlash.studies.motion import motion

    found = None if answer.numbers is None else optional(lambda: motion(attractor))
    if found is None:
        return
    optional(lambda: _write_series(folder, case, attractor, answer))
    label = found.label.short if isinstance(found.label, Signature) else str(found.label)
    gaps = [gap.name for gap in attractor.propagators.system.clearances]
    which = f"X and Φ of {gaps[0]}, the first of {len(gaps)} gaps" if len(gaps) > 1 else ""
    said = f"{case.name}:  {label}", at_what(case).removeprefix(", at "), which
    title = "\n".join(filter(None, said))

    def drawn(name: str) -> Callable[[Any], Figure]:
        return lambda plots: getattr(plots, name)(found, units=plots.Units.of(case), title=title)

    draw_if(folder, "portrait", True, drawn("portrait"))
    draw_if(folder, "history", True, drawn("history"))


def _write_series(folder: OutFolder, case: Case, attractor: Attractor, answer: RunAnswer) -> None:
    """History and order spectrum as data (NetCDF)."""
    from gearlash.results.columns import dataset_of_table
    from gearlash.results.provenance import provenance

    from .command_tables import series_tables

    about = {"gearlash_format": FORMAT_VERSION, **provenance(case)}
    tables = series_tables(case, answer.parameters, attractor)
    dims = {"history": "sample", "spectrum": "line"}
    made = {name: dataset_of_table(table, dims[name], about) for name, table in tables.items()}
    write_together({folder.file(f"{name}.nc"): netcdf(data) for name, data in made.items()})


def draw_if(folder: OutFolder, name: str, complete: bool, figure: Callable[[Any], Figure]) -> None:
    """The figure of what was computed whole, as SVG and PDF, unless a signal comes before it is drawn."""

    def drawn() -> None:
        from gearlash import plots

        plots.save(figure(plots), folder.file(name))

    if complete:
        optional(drawn)


def draw_stopped(folder: OutFolder, name: str, figure: Callable[[Any], Figure]) -> None:
    """The figure of what was computed before the work was stopped, as SVG and PDF. All else is kept before: a
    second signal gives up the figure alone."""
    from gearlash import plots

    plots.save(figure(plots), folder.file(name))
