"""Polynomials in local time, as coefficients in padded arrays, and Taylor series of Fourier series."""

from __future__ import annotations

import numpy as np

from gearlash._kernel import fma, inner

from ._tables import ORDER, TERMS
from ._vector import linear, move, multiple, times

NEAR_ZERO = 1e-9


@inner
def fill(target, value):
    for i in range(len(target)):
        target[i] = value


@inner
def fourier_taylor(series, at, harmonics, theta, width, out, to):
    """Coefficients in s of ``series(theta + width·s)``; series from place ``at``, written from place
    ``to``."""
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
def powers(s, out, to):
    """out[to:to+TERMS] ← 1, s, s², …: by blocks, not one after the other."""
    s2 = s * s
    s4 = s2 * s2
    out[to], out[to + 1], out[to + 2], out[to + 3] = 1.0, s, s2, s2 * s
    out[to + 4], out[to + 5], out[to + 6], out[to + 7] = s4, s4 * s, s4 * s2, s4 * s2 * s
    s8 = s4 * s4
    multiple(s8, out, to, out, to + 8, 8)
    multiple(s8 * s8, out, to, out, to + 16, 8)


@inner
def recentre(pascal, table, c, at, start, powers_at, scaled, out, to):
    """out[to:to+TERMS] ← coefficients of the polynomial c about ``start``; ``powers_at``, ``scaled`` are
    places in out for work."""
    move(c, at, out, to, TERMS)
    if start == 0.0:
        return
    if start < NEAR_ZERO:  # powers of the start would vanish, and so would terms of second order
        for j in range(ORDER):
            out[to + j] += (j + 1) * start * c[at + j + 1]
        return
    powers(start, out, powers_at)
    move(c, at, out, scaled, TERMS)
    times(out, powers_at, out, scaled, TERMS)
    # Σ_m C(m, i) start^(m-i) c_m
    linear(pascal, table, TERMS, TERMS, ORDER + 1, out, scaled, out, to)
    powers(1.0 / start, out, powers_at)
    times(out, powers_at, out, to, TERMS)


@inner
def pressing(eta, eta_at, x, x_at, first, rate, out, buffer, to):
    """out[to:to+TERMS] ← η·(X - edge) + rate·dX/ds, cut off behind ORDER; ``first`` is X - edge at s = 0.

    ``buffer``: a place for (2, TERMS) in out, the first half of which is zero: the product is a sum of X
    moved along by 0, 1, 2, … places."""
    move(x, x_at, out, buffer + TERMS, TERMS)
    out[buffer + TERMS] = first
    linear(out, buffer + TERMS, -1, TERMS, ORDER + 1, eta, eta_at, out, to)
    if rate != 0.0:
        for j in range(ORDER):
            out[to + j] += rate * (j + 1) * x[x_at + j + 1]
    for j in range(ORDER + 1, TERMS):
        out[to + j] = 0.0


@inner
def cut_off(eta, eta_at, x, x_at):
    """Bound on what `pressing` cuts off of the product η·(X - edge) behind ORDER."""
    total, beyond = 0.0, 0.0
    for i in range(1, ORDER + 1):
        beyond += abs(x[x_at + ORDER + 1 - i])
        total += abs(eta[eta_at + i]) * beyond
    return total
