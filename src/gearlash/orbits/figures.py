"""One figure of one quantity over a motion: peak, peak-to-peak, rms, mean, or the line of an order."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from numpy.typing import NDArray

from gearlash.flow import Trace
from gearlash.system import GearlashError, given
from gearlash.system.readout import Readout

from .signals import nodes, read, signal_of

Array = NDArray[np.float64]
FORCE, GAP = "mesh_force", "gap"
ACCELERATION = "acceleration_"
BEARING = "bearing_force_"
WHOLE = 1e-9  # relative: so near to a whole number a number of periods is one


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
    trace: Trace,
    readouts: tuple[Readout, ...],
    quantity: Quantity,
    figure: Figure,
    order: float = 1.0,
    *,
    repeats: bool = False,
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
    repeats : bool
        Whether the motion repeats after this length, as an orbit does: then it has no other lines, and their
        rms is 0.

    Returns
    -------
    float
        By Gauss quadrature on every exact piece, good to rounding; extremes as `signals` has them.

    Raises
    ------
    GearlashError
        For an order whose period the motion does not hold a whole number of.
    """

    def reading(at: Array) -> Array:
        return quantity.weights @ read(trace, readouts, 0, at)

    phase, weight = nodes(trace)
    values = reading(phase)
    if figure is Figure.ORDER:
        whole = given.number("order", order) * trace.cycles
        between = abs(whole - round(whole)) > WHOLE * max(1.0, whole)
        if repeats and between and whole > 0.0:
            return 0.0
        if between or whole <= 0.0:
            raise GearlashError(f"order {order:g}: the motion of {trace.cycles:g} cycles has no such line")
        return float(np.sqrt(2.0) * abs(np.sum(weight * values * np.exp(-2j * np.pi * order * phase))))
    found = signal_of(reading, phase, weight, values)
    return {
        Figure.PEAK: found.peak,
        Figure.PEAK_TO_PEAK: found.peak_to_peak,
        Figure.RMS: found.rms,
        Figure.MEAN: found.mean,
    }[figure]
