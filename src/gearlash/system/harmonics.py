"""Finite Fourier series of the mesh phase, stored as plain arrays.

A series is a float64 array ``[mean, c1, s1, c2, s2, ...]`` (odd length) with
``value(θ) = mean + Σ c_n cos nθ + s_n sin nθ``.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import given
from .status import GearlashError

Fourier = NDArray[np.float64]


def constant(value: float) -> Fourier:
    """The series of a constant."""
    return np.array([given.number("the constant", value)])


def cosines(mean: float, amplitudes: ArrayLike, phases: ArrayLike | None = None) -> Fourier:
    """The Fourier series of ``mean + Σ amplitude_n cos(nθ + phase_n)``.

    Parameters
    ----------
    mean : float
    amplitudes : array_like of shape (H,)
        Of the first H harmonics; one number alone is that of the first.
    phases : array_like of shape (H,), optional
        In rad; 0 without.

    Returns
    -------
    ndarray of shape (2H+1,)
        ``[mean, c1, s1, c2, s2, ...]``, as `Clearance` and `System` take it.

    Raises
    ------
    GearlashError
        For other than finite numbers, and for phases that are not as many as amplitudes.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.cosines(1.0, [0.5]).tolist()
    [1.0, 0.5, -0.0]
    """
    heights = given.row("amplitudes", amplitudes)
    angles = np.zeros(len(heights)) if phases is None else given.row("phases", phases)
    if len(angles) != len(heights):
        raise GearlashError(f"{len(heights)} amplitudes but {len(angles)} phases: expected one for each")
    series = [given.number("mean", mean)]
    for amplitude, phase in zip(heights, angles, strict=True):
        series += [amplitude * np.cos(phase), -amplitude * np.sin(phase)]
    return np.array(series, dtype=np.float64)


def evaluate(series: Fourier, theta: ArrayLike) -> NDArray[np.float64]:
    """Values of a series (last axis: coefficients) at phases ``theta`` in rad.

    Harmonics are powers of e^iθ: one sine and one cosine a phase, however many there are."""
    angle = np.asarray(theta, dtype=np.float64)
    if harmonics(series) == 0:
        return np.ones(angle.shape + (1,) * (series.ndim - 1)) * series[..., 0]
    turn: NDArray[np.complex128] = np.exp(1j * angle)[..., None]
    turns = np.repeat(turn, harmonics(series), axis=-1)
    np.multiply.accumulate(turns, axis=-1, out=turns)
    if series.ndim > 1:
        return series[..., 0] + turns.real @ series[..., 1::2].T + turns.imag @ series[..., 2::2].T
    # einsum and not a matrix product: a fixed order of summation, whatever the number of threads
    return (
        series[0]
        + np.einsum("...k,k->...", turns.real, series[1::2])
        + np.einsum("...k,k->...", turns.imag, series[2::2])
    )


def derivative(series: Fourier) -> Fourier:
    """d/dθ of a series (last axis: coefficients)."""
    out = np.zeros_like(series)
    order = np.arange(1, harmonics(series) + 1)
    out[..., 1::2] = order * series[..., 2::2]
    out[..., 2::2] = -order * series[..., 1::2]
    return out


def padded(series: Fourier, count: int) -> Fourier:
    """The same series with room for ``count`` harmonics (last axis)."""
    out = np.zeros((*series.shape[:-1], 2 * count + 1))
    out[..., : series.shape[-1]] = series
    return out


def harmonics(series: Fourier) -> int:
    """Number of harmonics a series has room for."""
    return (series.shape[-1] - 1) // 2
