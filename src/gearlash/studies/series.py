"""A motion as a table of samples, and its order spectrum: time histories for spreadsheets and scripts."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.case import Case
from gearlash.flow import Samples, Trace
from gearlash.orbits import Attractor, Orbit
from gearlash.orbits.signals import read
from gearlash.results.columns import Column
from gearlash.results.pair_units import PairUnits, Unit
from gearlash.system.readout import Readout

from .history import CYCLES, LEAST, MOST, PER_CYCLE
from .measured import readouts_of
from .order_lines import order_lines

Array = NDArray[np.float64]
REFERENCES = {"N": (1e-6, "1 uN"), "µm": (1e-6, "1 pm"), "mm/s": (1e-6, "1 nm/s")}
"""That levels refer to, as in ISO 1683; of other numbers to 1."""
TIMES = ("time", "mesh_cycle", "tau")
"""Columns of a history that say when."""


def series_of(case: Case, values: Mapping[str, float], found: Attractor) -> list[Column]:
    """One period of an orbit, or 64 mesh cycles of another motion, in 256 equal steps a mesh cycle (fewer of
    a long period): time, states, gap, its velocity and contact force of every clearance, dimensionless, and
    what is measured on a pair in its units."""
    trace = _trace(found)
    cycles = found.period if isinstance(found, Orbit) else CYCLES
    each = max(LEAST, min(PER_CYCLE, MOST // cycles))
    phase = np.arange(cycles * each) / each
    system = trace.propagators.system
    tau = 2.0 * np.pi * phase / system.omega
    columns = [Column("mesh_cycle", phase, "", "phase"), Column("tau", tau, "", "dimensionless time")]
    units = PairUnits.of(case)
    if units.time.name:
        columns.insert(0, Column("time", units.time.factor * tau, units.time.name, "time"))
    samples = [trace.at(phase, i) for i in range(len(system.clearances))]
    names = case.family()[0].states
    columns += [
        Column(plain_name(name), samples[0].state[:, i], "", f"state {name}") for i, name in enumerate(names)
    ]
    for i, one in enumerate(samples):
        end = "" if i == 0 else f"_{plain_name(system.clearances[i].name) or i + 1}"
        columns += _others(columns, _clearance(one, end, units))
    if case.between_teeth:
        readouts = readouts_of(case, values)
        rows = read(trace, readouts, 0, phase)[2:]
        columns += [_read(what, row, units) for what, row in zip(readouts, rows, strict=True)]
    return sorted(columns, key=_order)


def _order(column: Column) -> int:
    """Time in every form, then what has a physical unit, then what is dimensionless."""
    return 0 if column.name in TIMES else 1 if column.unit else 2


def spectrum_of(series: list[Column], periodic: bool) -> list[Column]:
    """The order spectrum of a table of samples: by order of the mesh frequency the rms, the phase of the
    cosine and the level of every quantity. Of an orbit the lines are its Fourier series; of another motion a
    Hann window is taken, whose lines are right for single tones."""
    phase = np.asarray(next(each.values for each in series if each.name == "mesh_cycle"))
    m, cycles = len(phase), len(phase) * (phase[1] - phase[0])
    columns = [Column("order", np.arange(m // 2) / cycles, "", "of the mesh frequency")]
    for column in series:
        if column.name in TIMES:
            continue
        rms, angle = order_lines(np.asarray(column.values), periodic)
        told = column.description
        columns.append(Column(f"{column.name}_rms", rms, column.unit, f"{told}, rms; of order 0 its mean"))
        columns.append(Column(f"{column.name}_phase", angle, "rad", f"{told}, phase of the cosine"))
        size, reference = REFERENCES.get(column.unit, (1.0, "1"))
        level = np.full_like(rms, np.nan)
        np.log10(rms / size, where=rms > 0.0, out=level)
        columns.append(Column(f"{column.name}_level", 20.0 * level, f"dB re {reference}", f"{told}, level"))
    return columns


def plain_name(name: str) -> str:
    """A name of letters, digits and underscores: ``x'`` is ``x_rate``."""
    return re.sub(r"\W+", "_", name.replace("'", "_rate").replace("′", "_rate"), flags=re.ASCII).strip("_")


def _trace(found: Attractor) -> Trace:
    """The motion from phase zero on."""
    if isinstance(found, Orbit):
        return flow.trace(found.propagators, found.state, float(found.period))
    cycles = found.propagators.system.cycles
    return flow.trace(found.propagators, found.final_state, float(-(-CYCLES // cycles) * cycles))


def _clearance(one: Samples, end: str, units: PairUnits) -> list[Column]:
    found = [
        Column(f"X{end}", one.displacement, "", "gap"),
        Column(f"X_rate{end}", one.velocity, "", "velocity of the gap"),
        Column(f"Phi{end}", one.force, "", "contact force, positive in drive-side compression"),
    ]
    if units.force.name:
        found += [
            Column(f"gap{end}", units.length.factor * one.displacement, units.length.name, "gap"),
            Column(f"gap_velocity{end}", units.velocity.factor * one.velocity, units.velocity.name,
                   "velocity of the gap"),
            Column(f"mesh_force{end}", units.force.factor * one.force, units.force.name, "contact force"),
        ]  # fmt: skip
    return found


def _others(known: list[Column], more: list[Column]) -> list[Column]:
    """Those that are not among the states already; what only shares the name of one is named otherwise."""
    values = {column.name: np.asarray(column.values) for column in known}
    return [
        replace(each, name=f"{each.name}_gap") if each.name in values else each
        for each in more
        if each.name not in values or not np.allclose(values[each.name], each.values, rtol=1e-12, atol=1e-12)
    ]


def _read(what: Readout, row: Array, units: PairUnits) -> Column:
    unit: Unit = units.force if what.quantity == "force" else units.length
    return Column(what.name, unit.factor * row, unit.name, what.words)
