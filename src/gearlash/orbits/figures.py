"""One figure of one quantity over a motion: peak, peak-to-peak, rms, mean, or the line of an order."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from gearlash.flow import Trace
from gearlash.system import GearlashError, given
from gearlash.system.readout import Readout

from .signals import CLOSER, LOCAL, WEIGHTS, read
from .statistics import top

Array = NDArray[np.float64]
FORCE, GAP = "mesh_force", "gap"
ACCELERATION = "acceleration_"
BEARING = "bearing_force_"


class Figure(StrEnum):
    """What is taken of a quantity over a motion."""

    PEAK = "peak"
    PEAK_TO_PEAK = "peak-to-peak"
    RMS = "rms"
    MEAN = "mean"
    ORDER = "order"


@dataclass(frozen=True)
class Quantity:
    """A quantity as a sum of what is read: ``weights`` of Φ, X and every readout.

    Parameters
    ----------
    name : str
    quantity : str
        What its unit is: ``force``, ``length`` or ``acceleration``.
    weights : ndarray of shape (2 + readouts,)
    """

    name: str
    quantity: str
    weights: Array


def quantities(readouts: tuple[Readout, ...], gains: Array, masses: Array) -> dict[str, Quantity]:
    """Everything that can be measured of a pair: mesh force, gap, what is read, and the accelerations of
    bearings, y'' = gain Φ - (bearing force)/mass."""
    size = 2 + len(readouts)

    def only(*pairs: tuple[int, float]) -> Array:
        weights = np.zeros(size)
        for at, weight in pairs:
            weights[at] = weight
        return weights

    found = {FORCE: Quantity(FORCE, "force", only((0, 1.0))), GAP: Quantity(GAP, "length", only((1, 1.0)))}
    for at, one in enumerate(readouts, start=2):
        found[one.name] = Quantity(one.name, one.quantity, only((at, 1.0)))
    for at, (gain, mass) in enumerate(zip(gains, masses, strict=True)):
        name = ACCELERATION + readouts[at].name.removeprefix(BEARING)
        found[name] = Quantity(name, "acceleration", only((0, gain), (2 + at, -1.0 / mass)))
    return found


def figure_of(
    trace: Trace, readouts: tuple[Readout, ...], quantity: Quantity, figure: Figure, order: float = 1.0
) -> float:
    """A figure of a motion.

    Parameters
    ----------
    trace : Trace
        One period of an orbit, or a stretch of another motion.
    readouts : tuple of Readout
    quantity : Quantity
    figure : Figure
        ``rms`` is about the mean; ``order`` the rms of the line of ``order`` times the mesh frequency.
    order : float
        A multiple of one over the length of the motion, where it is asked for.

    Returns
    -------
    float
        By Gauss quadrature on every exact piece, good to rounding; extremes as `signals` has them.

    Raises
    ------
    GearlashError
        For an order whose period the motion does not hold a whole number of.
    """
    cycles = trace.propagators.cells_per_cycle
    phase = trace.base + (trace.positions[:, None] + trace.lengths[:, None] * LOCAL[None, :]).ravel() / cycles
    values = quantity.weights @ read(trace, readouts, 0, phase)
    if figure in (Figure.PEAK, Figure.PEAK_TO_PEAK):
        least, most = (_extreme(trace, readouts, quantity, phase, values, sign) for sign in (-1.0, 1.0))
        return max(abs(least), abs(most)) if figure is Figure.PEAK else most - least
    weight = (trace.lengths[:, None] * np.pad(WEIGHTS / 2.0, 1)[None, :]).ravel() / trace.lengths.sum()
    mean = float(np.sum(weight * values))
    if figure is Figure.MEAN:
        return mean
    if figure is Figure.RMS:
        return float(np.sqrt(np.sum(weight * (values - mean) ** 2)))
    whole = given.number("order", order) * trace.cycles
    if abs(whole - round(whole)) > 1e-9 * max(1.0, whole) or whole <= 0.0:
        raise GearlashError(f"order {order:g}: the motion of {trace.cycles:g} mesh cycles has no such line")
    return float(np.sqrt(2.0) * abs(np.sum(weight * (values - mean) * np.exp(-2j * np.pi * order * phase))))


def _extreme(
    trace: Trace, readouts: tuple[Readout, ...], quantity: Quantity, phase: Array, values: Array, sign: float
) -> float:
    """The largest value (of the other sign: the least), read once more around the extreme reading."""
    at = int(np.argmax(sign * values))
    start, stop = phase[max(0, at - 3)], phase[min(len(phase) - 1, at + 3)]
    closer = sign * (quantity.weights @ read(trace, readouts, 0, start + (stop - start) * CLOSER))
    return sign * max(top(closer), float(sign * values[at]))
