"""Forces and displacement of a motion."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.flow import Trace
from gearlash.system import GearlashError, Record

from .extrema import gap_extrema
from .grazing import motion_of
from .peaks import top
from .results import Attractor

FREE = 1  # region of a trace
PIECES = 500  # of a trace, read at once
NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)


@dataclass(frozen=True, repr=False)
class ForceStatistics(Record):
    """Extremes and means of the contact force Φ over a motion, dimensionless.

    Attributes
    ----------
    minimum : float
    maximum : float
    mean : float
        Over time.
    rms : float
        Root of the mean square.
    alternating_rms : float
        The same of the force less its mean.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> force = gl.motion_statistics(gl.attractor(family.system({"omega": 0.8}), family.start())).force
    >>> round(force.mean, 4), round(force.dynamic_factor, 3)
    (0.1, 1.87)
    """

    minimum: float
    maximum: float
    mean: float
    rms: float
    alternating_rms: float

    @property
    def dynamic_factor(self) -> float:
        """Peak in the direction of the load over the mean force (the static load); NaN without load."""
        if abs(self.mean) <= 1e-9 * self.rms:
            return np.nan
        peak = self.maximum if self.mean > 0.0 else -self.minimum
        return peak / abs(self.mean)


@dataclass(frozen=True, repr=False)
class MotionStatistics(Record):
    """Contact force, displacement along the line of action and share of time without contact of a motion.

    Attributes
    ----------
    force : ForceStatistics
    error_rms : float
        Of the displacement X about its mean.
    error_peak_to_peak : float
    minimum : float
        Least X.
    maximum : float
        Largest X.
    share_without_contact : float
        Of the time, 0 to 1.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("blankenship-kahraman").family()
    >>> found = gl.motion_statistics(gl.attractor(family.system(), family.start()))
    >>> found.minimum < found.maximum, 0.0 < found.share_without_contact < 1.0
    (True, True)
    """

    force: ForceStatistics
    error_rms: float
    error_peak_to_peak: float
    minimum: float
    maximum: float
    share_without_contact: float


def motion_statistics(attractor: Attractor, clearance: int = 0) -> MotionStatistics:
    """Statistics of force and displacement of a motion, in one clearance.

    By Gauss quadrature on every exact piece, with extremes of X from its exact extrema; extremes of the force
    are those of the parabolas through the extreme ones of 96 points a piece.

    Parameters
    ----------
    attractor : Orbit, Aperiodic, Neutral or Unresolved
        What `attractor` returned: of an orbit one period is taken, of another motion the 200 base periods
        that are kept of it.
    clearance : int
        Index of the clearance.

    Returns
    -------
    MotionStatistics

    Raises
    ------
    GearlashError
        For arguments that do not fit, and for a motion that runs away at once.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> found = gl.motion_statistics(gl.attractor(family.system({"omega": 0.8}), family.start()))
    >>> round(found.error_peak_to_peak, 4), found.share_without_contact
    (0.1735, 0.0)
    """
    trace = motion_of(attractor).trace
    clearance = trace.which(clearance)
    if not len(trace.lengths):
        raise GearlashError("the motion runs away at once: there is nothing to take statistics of")
    weight = (trace.lengths[:, None] * WEIGHTS[None, :] / 2.0).ravel()
    samples = trace.at(_phases(trace, (NODES + 1.0) / 2.0), clearance)
    weight = weight / weight.sum()
    mean = float(weight @ samples.force)
    least, most = _force_extremes(trace, clearance)
    rms, alternating = (_rms(weight, samples.force - level) for level in (0.0, mean))
    force = ForceStatistics(least, most, mean, rms, alternating)
    x = samples.displacement
    average = float(weight @ x)
    extremes = gap_extrema(trace, clearance).displacement
    low, high = (extremes.min(), extremes.max()) if len(extremes) else (x.min(), x.max())
    free = float(trace.lengths[trace.regions_of(clearance) == FREE].sum() / trace.lengths.sum())
    return MotionStatistics(
        force, _rms(weight, x - average), float(high - low), float(low), float(high), free
    )


def _rms(weight: NDArray[np.float64], values: NDArray[np.float64]) -> float:
    """With weights whose sum is 1. Of what varies, the mean is taken off before: the difference of two mean
    squares loses half of all digits. Squares of values over the largest one do not overflow."""
    largest = float(np.abs(values).max())
    return largest * float(np.sqrt(weight @ (values / largest) ** 2)) if largest > 0.0 else 0.0


def _force_extremes(trace: Trace, clearance: int) -> tuple[float, float]:
    """Least and largest force; so many pieces at once that a period of very many takes little memory."""
    least, most = np.inf, -np.inf
    for first in range(0, len(trace.lengths), PIECES):
        phases = _phases(trace, np.linspace(1e-12, 1.0 - 1e-12, 96), slice(first, first + PIECES))
        rows = trace.at(phases, clearance).force.reshape(-1, 96)
        least, most = min(least, -max(map(top, -rows))), max(most, *map(top, rows))
    return least, most


def _phases(trace: Trace, local: NDArray[np.float64], pieces: slice = slice(None)) -> NDArray[np.float64]:
    cells = trace.positions[pieces, None] + trace.lengths[pieces, None] * local[None, :]
    return trace.base + cells.ravel() / trace.propagators.cells_per_cycle
