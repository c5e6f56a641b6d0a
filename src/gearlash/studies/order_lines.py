"""Lines of an order spectrum from even samples over whole mesh cycles."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def order_lines(values: Array, periodic: bool) -> tuple[Array, Array]:
    """rms and phase of the cosine of every line along the last axis, from order 0 upwards.

    Where samples are of whole periods the lines are those of the Fourier series: the sum of
    ``√2 rms cos(2π order t + phase)``, and of ``rms cos(phase)`` for order 0, is the signal again. Of another
    motion a Hann window is taken, whose lines are right for single tones and lie 1.5 lines wide.

    The mean is taken away before the transform, so that the window does not smear it into the first lines,
    and is put back as line 0: its modulus, with the phase 0 or π as it is above or below 0.
    """
    m = values.shape[-1]
    weight = np.ones(m) if periodic else 2.0 * np.sin(np.pi * np.arange(m) / m) ** 2
    mean = values.mean(axis=-1, keepdims=True)
    lines = np.fft.rfft((values - mean) * weight, axis=-1)[..., : m // 2] / m
    rms, phase = np.sqrt(2.0) * np.abs(lines), np.angle(lines)
    rms[..., 0], phase[..., 0] = np.abs(mean[..., 0]), np.where(mean[..., 0] < 0.0, np.pi, 0.0)
    return rms, phase
