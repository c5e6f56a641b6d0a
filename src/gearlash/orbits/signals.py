"""What is measured on a running pair: contact force, deflection and whatever else is read of a motion."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.flow import Trace
from gearlash.system import evaluate
from gearlash.system.readout import Readout

from .peaks import CLOSER, Places, largest

Array = NDArray[np.float64]

NODES, WEIGHTS = np.polynomial.legendre.leggauss(10)
LOCAL = np.concatenate([[1e-12], (NODES + 1.0) / 2.0, [1.0 - 1e-12]])
"""Local times of a piece; its ends a little inside, as the force may jump between two pieces."""


@dataclass(frozen=True)
class Signal:
    """Figures of one quantity over a motion.

    Parameters
    ----------
    mean : float
    rms : float
        About the mean.
    least, most : float
    """

    mean: float
    rms: float
    least: float
    most: float

    @property
    def peak_to_peak(self) -> float:
        """From the least value to the largest."""
        return self.most - self.least

    @property
    def peak(self) -> float:
        """The largest modulus."""
        return max(abs(self.least), abs(self.most))


@dataclass(frozen=True)
class Signals:
    """What is measured on a motion in one clearance; all numbers dimensionless.

    Parameters
    ----------
    force : Signal
        Contact force Φ.
    gap : Signal
        X.
    read : tuple of Signal
        Of what was asked to be read, in that order.
    impact_velocity : float
        Largest \\|X'\\| at which a contact begins on the drive side; 0 where none does.
    back_velocity : float
        The same of the back side.
    share_without_contact : float
        Of the time, 0 to 1.
    """

    force: Signal
    gap: Signal
    read: tuple[Signal, ...]
    impact_velocity: float
    back_velocity: float
    share_without_contact: float


def signals(trace: Trace, readouts: Sequence[Readout] = (), clearance: int = 0) -> Signals:
    """Figures of a motion.

    Means and rms are those of Gauss quadrature on every exact piece, good to rounding; extremes are read
    once more, closely, around the extreme ones of 12 readings a piece, up to where contact begins or ends,
    and a parabola makes them good to about 1e-7 of their span. Impact velocities are exact.

    Parameters
    ----------
    trace : Trace
        One period of an orbit, or a stretch of another motion.
    readouts : sequence of Readout
        What to read beside Φ and X.
    clearance : int
        Index of the clearance.

    Returns
    -------
    Signals
    """
    phase, weight = nodes(trace)
    figures = tuple(
        signal_of(lambda at, row=row: read(trace, readouts, clearance, at)[row], phase, weight, values)
        for row, values in enumerate(read(trace, readouts, clearance, phase))
    )
    events = trace.events.of(clearance)
    engaging = np.asarray(events.engaging, dtype=np.bool_)
    hits = [np.abs(events.velocity[engaging & (events.boundary == side)]) for side in (1, -1)]
    free = float(trace.lengths[trace.regions_of(clearance) == 1].sum() / trace.lengths.sum())
    return Signals(
        figures[0], figures[1], figures[2:], float(hits[0].max(initial=0.0)), float(hits[1].max(initial=0.0)),
        free,
    )  # fmt: skip


def read(trace: Trace, readouts: Sequence[Readout], clearance: int, phase: Array) -> Array:
    """Φ, X and every readout at phases (m,) in mesh cycles, shape (2 + readouts, m)."""
    system = trace.propagators.system
    state = trace.at(phase, clearance)
    theta = 2.0 * np.pi * phase / system.cycles
    rows = [state.force, state.displacement]
    rows += [state.state @ one.row + evaluate(one.offset, theta) for one in readouts]
    return np.array(rows)


def nodes(trace: Trace) -> tuple[Array, Array]:
    """Phases (m,) of readings on every piece of a motion, and what each weighs in a mean."""
    cells = trace.positions[:, None] + trace.lengths[:, None] * LOCAL[None, :]
    weight = (trace.lengths[:, None] * np.pad(WEIGHTS / 2.0, 1)[None, :]).ravel() / trace.lengths.sum()
    return trace.base + cells.ravel() / trace.propagators.cells_per_cycle, weight


def signal_of(reading: Callable[[Array], Array], phase: Array, weight: Array, values: Array) -> Signal:
    """Figures of one quantity; ``reading`` gives it at any phases, ``values`` are those at ``phase``."""
    mean = float(np.sum(weight * values))
    rms = float(np.sqrt(np.sum(weight * (values - mean) ** 2)))
    rows = values.reshape(-1, len(LOCAL))

    def closer(first: Places, last: Places) -> Array:
        at = phase[first] + (phase[last] - phase[first]) * CLOSER
        return reading(at.ravel()).reshape(at.shape)

    least = -largest(-rows, lambda first, last: -closer(first, last))
    return Signal(mean, rms, least, largest(rows, closer))
