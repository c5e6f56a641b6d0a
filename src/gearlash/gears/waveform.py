"""Stiffness or error as it comes, points over a cycle, as a Fourier series whose error is told.

Points are joined by straight lines, a place given twice is a step, and the last point is joined to the first
one cycle later. The Fourier coefficients of that curve are exact:

    c_n = Σ_j s_j (e_j − e_{j+1})/a² + Σ_j J_j e_j/a,   a = 2πi n,  e_j = exp(−a ψ_j),

with the slopes s_j and the steps J_j. Phases are parts of the cycle, from 0 to 1.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.system import Fourier, GearlashError, evaluate

Reals = NDArray[np.float64]


@dataclass(frozen=True)
class Waveform:
    """A periodic curve through points, and its first harmonics.

    Parameters
    ----------
    phases, values : ndarray, shape (n,)
        The points; phases from 0 to 1 in order.
    series : ndarray, shape (2H + 1,)
        ``[mean, c1, s1, c2, s2, ...]`` of θ = 2πψ, as a `System` takes it.
    rms_error : float
        Root mean square of curve less series over the cycle, exact.
    """

    phases: Reals
    values: Reals
    series: Fourier
    rms_error: float

    @property
    def amplitudes(self) -> Reals:
        """Of the harmonics 1, 2 …, shape (H,)."""
        return np.hypot(self.series[1::2], self.series[2::2])

    @property
    def angles(self) -> Reals:
        """φ_n of amplitude_n cos(nθ + φ_n), rad, shape (H,)."""
        return np.arctan2(-self.series[2::2], self.series[1::2])

    def reconstructed(self) -> Reals:
        """The series at the points, shape (n,): to be drawn over them."""
        return evaluate(self.series, 2.0 * pi * self.phases)


def waveform(phases: ArrayLike, values: ArrayLike, count: int) -> Waveform:
    """First harmonics of the curve through points.

    Parameters
    ----------
    phases : array_like, shape (n,)
        From 0 to 1, not decreasing; twice the same for a step. 1 is the next cycle's 0.
    values : array_like, shape (n,)
    count : int
        How many harmonics, from 0.

    Returns
    -------
    Waveform

    Raises
    ------
    GearlashError
        For fewer than two points, phases out of order or range, or other than finite numbers.

    Examples
    --------
    >>> from gearlash.gears.waveform import waveform
    >>> triangle = waveform([0.0, 0.5], [1.0, -1.0], 3)
    >>> triangle.amplitudes.round(4).tolist()  # 8/π², 0, 8/(9π²)
    [0.8106, 0.0, 0.0901]
    """
    psi, v = np.asarray(phases, dtype=float), np.asarray(values, dtype=float)
    if psi.ndim != 1 or psi.shape != v.shape or len(psi) < 2:
        raise GearlashError("a waveform has a phase and a value for each of at least two points")
    if not (np.isfinite(psi).all() and np.isfinite(v).all()):
        raise GearlashError("a waveform has finite numbers only")
    if psi[0] < 0.0 or psi[-1] > 1.0 or np.any(np.diff(psi) < 0.0):
        raise GearlashError("phases of a waveform go from 0 to 1, never back")
    start, end = np.append(psi, psi[0] + 1.0)[:-1], np.append(psi, psi[0] + 1.0)[1:]
    low, high = v, np.append(v[1:], v[0])
    wide = end - start
    straight = wide > 1e-12  # nearer than that is a step
    slopes = np.divide(high - low, wide, out=np.zeros_like(wide), where=straight)
    steps = np.where(straight, 0.0, high - low)
    mean = float(np.sum(wide * (low + high)) / 2.0)
    orders = np.arange(1, count + 1)
    a = 2j * pi * orders[:, None]
    first, last = np.exp(-a * start), np.exp(-a * end)
    c = np.sum(slopes * (first - last) / a**2 + steps * first / a, axis=1)
    series = np.empty(2 * count + 1)
    series[0], series[1::2], series[2::2] = mean, 2.0 * c.real, -2.0 * c.imag
    square = float(np.sum(wide * (low**2 + low * high + high**2)) / 3.0)
    rest = square - mean**2 - 0.5 * float(np.sum(np.square(series[1:])))
    return Waveform(psi, v, series, sqrt(max(rest, 0.0)))


def rectangle(low: float, high: float, contact_ratio: float, count: int) -> Waveform:
    """First harmonics of a curve that steps between two values, as many pairs of teeth as ε_α says.

    Parameters
    ----------
    low, high : float
        With the smaller and the larger number of pairs in contact.
    contact_ratio : float
        ε_α; above 1. The larger number holds for its part after the point.
    count : int
        How many harmonics, from 0.

    Returns
    -------
    Waveform
        High from phase 0 on.

    Raises
    ------
    GearlashError
        For a contact ratio up to 1: a pair would leave before the next one comes.

    Examples
    --------
    >>> from gearlash.gears.waveform import rectangle
    >>> curve = rectangle(1.0, 2.0, 1.6, 8)
    >>> round(float(curve.series[0]), 6), round(curve.rms_error, 3)
    (1.6, 0.111)
    """
    if not contact_ratio > 1.0:
        raise GearlashError(f"ε_α = {contact_ratio:g}: above 1 one pair of teeth at least is in contact")
    part = contact_ratio % 1.0
    return waveform([0.0, part, part, 1.0], [high, high, low, low], count)


def loaded_error(unloaded: ArrayLike, stiffness: ArrayLike, force: float) -> Reals:
    """Static transmission error under load, all in contact: what is measured when the gears turn slowly.

    Parameters
    ----------
    unloaded : array_like, shape (n,)
        e over the cycle, m.
    stiffness : array_like, shape (n,)
        K over the same cycle, N/m; above 0.
    force : float
        Normal force, N.

    Returns
    -------
    ndarray, shape (n,)
        F/K + e, m. It already has the varying stiffness in it: used as an error beside it, that counts twice.

    Examples
    --------
    >>> from gearlash.gears.waveform import loaded_error, unloaded_error_of
    >>> measured = loaded_error([1e-6, -1e-6], [2e8, 3e8], 6000.0)
    >>> (unloaded_error_of(measured, [2e8, 3e8], 6000.0) * 1e6).round(9).tolist()
    [1.0, -1.0]
    """
    return np.asarray(unloaded, dtype=float) + force / np.asarray(stiffness, dtype=float)


def unloaded_error_of(loaded: ArrayLike, stiffness: ArrayLike, force: float) -> Reals:
    """The unloaded error that is left of a loaded one, e = δ − F/K, m: shape (n,) of both."""
    return np.asarray(loaded, dtype=float) - force / np.asarray(stiffness, dtype=float)
