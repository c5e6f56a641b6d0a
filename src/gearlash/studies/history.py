"""A motion as a history of what is measured on it, with equal steps: for figures, spectra and files."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.case import Case
from gearlash.flow import Trace
from gearlash.orbits.signals import Signals, read, signals
from gearlash.results import Point
from gearlash.system import Label, MotionKind
from gearlash.system.readout import Readout

from .measured import readouts_of, trace_of
from .motion import Motion
from .order_lines import order_lines

Array = NDArray[np.float64]

PER_CYCLE = 256  # samples of a mesh cycle: orders up to 128
MOST, LEAST = 65_536, 32  # samples in all, of a long period fewer a mesh cycle, but not below the second
IN_GAP = 400  # samples of a mesh cycle of a phase portrait
CYCLES = 64  # mesh cycles of a motion that is not periodic
FORCE = Readout("mesh_force", "mesh force", "force", np.zeros(0))
GAP = Readout("gap", "relative displacement of the flanks X", "length", np.zeros(0))


@dataclass(frozen=True, eq=False)
class History:
    """One period of an orbit, or 64 mesh cycles of another motion, in 256 equal steps a mesh cycle; in fewer
    where a period is longer than 256 mesh cycles.

    Parameters
    ----------
    omega : float
    label : Signature or MotionKind
    period : int
        In mesh cycles; 0 where none was proved.
    cycles : int
        How long it is, in mesh cycles.
    phase : ndarray of shape (m,)
        In mesh cycles, from 0, without the end.
    what : tuple of Readout
        What the rows are: mesh force, X, then what is read of the pair.
    values : ndarray of shape (k, m)
        Dimensionless.
    signals : Signals
        Exact figures of the whole motion.
    motion : Motion
        The same in the gap, for a phase portrait.
    """

    omega: float
    label: Label | None
    period: int
    cycles: int
    phase: Array
    what: tuple[Readout, ...]
    values: Array
    signals: Signals
    motion: Motion

    def row(self, name: str) -> Array:
        """One of the quantities by name, shape (m,)."""
        return self.values[next(i for i, one in enumerate(self.what) if one.name == name)]


def history(case: Case, fixed: Mapping[str, float], point: Point) -> History:
    """The history of a motion that a sweep over speed found."""
    family = case.family()[0]
    values = family.complete({**fixed, "omega": point.value})
    trace = trace_of(family, values, point, None)
    readouts = readouts_of(case, values)
    cycles = point.period or CYCLES
    phase, rows = _sampled(trace, readouts, cycles)
    figures = signals(trace, readouts)
    shown = _in_gap(trace, point)
    return History(
        point.value, point.label, point.period, cycles, phase, (FORCE, GAP, *readouts), rows, figures, shown
    )


def _sampled(trace: Trace, readouts: tuple[Readout, ...], cycles: int) -> tuple[Array, Array]:
    per_cycle = max(LEAST, min(PER_CYCLE, MOST // cycles))
    phase = np.arange(cycles * per_cycle) / per_cycle
    return phase, read(trace, readouts, 0, phase)


def _in_gap(trace: Trace, point: Point) -> Motion:
    """The motion in its gap as far as its history goes, with its contacts."""
    system, cycles = trace.propagators.system, float(point.period or CYCLES)
    even = np.linspace(0.0, cycles, min(round(cycles) * IN_GAP, MOST) + 1)
    special = np.concatenate([trace.events.phase, trace.extrema.phase])
    samples = trace.at(np.unique(np.concatenate([even, special[special <= cycles]])))
    hits = np.flatnonzero(trace.events.phase <= cycles)
    at, strobes = trace.at(trace.events.phase[hits]), trace.at(np.arange(0.0, cycles, system.cycles))
    gap = system.clearances[0]
    return Motion(
        omega=system.omega, gap_plus=gap.gap_plus, gap_minus=gap.gap_minus,
        label=point.label or MotionKind.UNRESOLVED, status=point.status, message=point.message,
        period=point.period, largest_exponent=point.largest_exponent, exponent_error=point.exponent_error,
        leading=point.leading, phase=samples.phase, displacement=samples.displacement,
        velocity=samples.velocity, force=samples.force, region=np.asarray(samples.region, dtype=np.int64),
        hit_phase=at.phase, hit_displacement=at.displacement, hit_velocity=at.velocity,
        hit_boundary=np.asarray(trace.events.boundary[hits], dtype=np.int64),
        hit_engaging=np.asarray(trace.events.engaging[hits], dtype=np.bool_),
        strobe_displacement=strobes.displacement, strobe_velocity=strobes.velocity, value=point.value,
    )  # fmt: skip


@dataclass(frozen=True, eq=False)
class Spectrum:
    """Lines of a history by order of mesh frequency.

    Parameters
    ----------
    order : ndarray of shape (n,)
        From 0 (the mean) upwards.
    rms : ndarray of shape (k, n)
        Of every line of every quantity; of order 0 the modulus of the mean.
    phase : ndarray of shape (k, n)
        Of the cosine of a line, rad.
    window : str
        Empty where whole periods were taken and the lines are those of the Fourier series.
    """

    order: Array
    rms: Array
    phase: Array
    window: str


def spectrum(found: History) -> Spectrum:
    """The order spectrum of a history: of an orbit its Fourier series; of another motion with a Hann window,
    whose lines are right for single tones and lie 1.5 lines wide."""
    rms, phase = order_lines(found.values, bool(found.period))
    order = np.arange(rms.shape[-1]) / found.cycles
    return Spectrum(order, rms, phase, "" if found.period else "Hann")
