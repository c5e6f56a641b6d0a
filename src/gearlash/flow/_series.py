"""Polynomials in local time, as coefficients in padded arrays, and Taylor series of Fourier series."""

from __future__ import annotations

import numpy as np

from gearlash._kernel import fma, inner

from ._tables import ORDER, TERMS
from ._vector import linear

NEAR_ZERO = 1e-9


@inner
def copy(source, target):
    """target ← source, element by element (array slices would drag numpy's error texts through the
    compiler)."""
    for i in range(len(source)):
        target[i] = source[i]


@inner
def fill(target, value):
    for i in range(len(target)):
        target[i] = value


@inner
def fourier_taylor(series, at, harmonics, theta, width, out, to):
    """Coefficients in s of ``series(theta + width·s)``; series from place ``at``, written from place ``to``."""
    for j in range(TERMS):
        out[to + j] = 0.0
    out[to] = series[at]
    c1, s1 = np.cos(theta), np.sin(theta)
    c, s = 1.0, 0.0
    for n in range(1, harmonics + 1):
        c, s = c * c1 - s * s1, s * c1 + c * s1
        # value and first derivative alternate through all higher ones
        even = series[at + 2 * n - 1] * c + series[at + 2 * n] * s
        odd = series[at + 2 * n] * c - series[at + 2 * n - 1] * s
        factor = 1.0
        for j in range(0, ORDER + 1, 2):
            out[to + j] += even * factor
            factor *= n * width / (j + 1)
            if j + 1 <= ORDER:
                out[to + j + 1] += odd * factor
            factor *= -n * width / (j + 2)


@inner
def polynomial(c, at, s):
    """Value at s."""
    value = c[at + ORDER]
    for j in range(ORDER - 1, -1, -1):
        value = fma(value, s, c[at + j])
    return value


@inner
def slope(c, at, s):
    """First derivative at s."""
    value = ORDER * c[at + ORDER]
    for j in range(ORDER - 1, 0, -1):
        value = fma(value, s, j * c[at + j])
    return value


@inner
def fourier_value(series, at, harmonics, theta):
    """Value of a Fourier series at a phase."""
    value = series[at]
    c1, s1 = np.cos(theta), np.sin(theta)
    c, s = 1.0, 0.0
    for n in range(1, harmonics + 1):
        c, s = c * c1 - s * s1, s * c1 + c * s1
        value += series[at + 2 * n - 1] * c + series[at + 2 * n] * s
    return value


@inner
def recentre(pascal, table, c, at, start, powers, out, to):
    """out[to:to+TERMS] ← coefficients of the polynomial c about ``start``; ``powers`` is a place in out."""
    if start == 0.0:
        for j in range(TERMS):
            out[to + j] = c[at + j]
    elif start < NEAR_ZERO:  # powers of the start would vanish, and so would terms of second order
        for j in range(TERMS):
            out[to + j] = c[at + j]
        for j in range(ORDER):
            out[to + j] += (j + 1) * start * c[at + j + 1]
    else:
        power, step = 1.0, 1.0 / start
        for j in range(ORDER + 1):
            out[powers + j] = c[at + j] * power
            power *= start
        # Σ_m C(m, i) start^(m-i) c_m
        linear(pascal, table, TERMS, TERMS, ORDER + 1, out, powers, out, to)
        power = 1.0
        for j in range(ORDER + 1):
            out[to + j] *= power
            power *= step


@inner
def pressing(eta, eta_at, x, x_at, first, rate, out, to):
    """out[to:to+TERMS] ← η·(X - edge) + rate·dX/ds, cut off behind ORDER; ``first`` is X - edge at s = 0."""
    for j in range(TERMS):
        out[to + j] = 0.0
    for i in range(ORDER + 1):
        factor = eta[eta_at + i]
        if factor != 0.0:
            out[to + i] = fma(factor, first, out[to + i])
            for j in range(1, ORDER + 1 - i):
                out[to + i + j] = fma(factor, x[x_at + j], out[to + i + j])
    if rate != 0.0:
        for j in range(ORDER):
            out[to + j] += rate * (j + 1) * x[x_at + j + 1]
