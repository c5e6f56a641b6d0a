"""Polynomials in local time, as coefficients in padded arrays, and Taylor series of Fourier series."""

from __future__ import annotations

import numpy as np

from gearlash._kernel.jit import fma, inlined, inner

from ._tables import ORDER, TERMS
from ._vector import linear, move, powers, times

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


@inlined
def jet(c, at, s):
    """Value, slope and half the second derivative at s: block by block of eight side by side, as one long
    chain of products would take three times as long."""
    v0, d0, b0 = c[at + 7], 0.0, 0.0
    v1, d1, b1 = c[at + 15], 0.0, 0.0
    v2, d2, b2 = c[at + 23], 0.0, 0.0
    for j in range(6, -1, -1):
        b0, b1, b2 = fma(b0, s, d0), fma(b1, s, d1), fma(b2, s, d2)
        d0, d1, d2 = fma(d0, s, v0), fma(d1, s, v1), fma(d2, s, v2)
        v0, v1, v2 = fma(v0, s, c[at + j]), fma(v1, s, c[at + 8 + j]), fma(v2, s, c[at + 16 + j])
    s2 = s * s
    s6 = s2 * s2 * s2
    power, rise, curl = s6 * s2, 8.0 * (s6 * s), 28.0 * s6  # of s^8
    b1 += fma(b2, power, fma(d2, rise, v2 * curl))
    d1 += fma(d2, power, v2 * rise)
    v1 = fma(v2, power, v1)
    b0 += fma(b1, power, fma(d1, rise, v1 * curl))
    d0 += fma(d1, power, v1 * rise)
    return fma(v1, power, v0), d0, b0


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
def derivative(x, at, factor, out, to):
    """out[to:to+TERMS] ← factor · dX/ds of the polynomial at a place."""
    for j in range(ORDER):
        out[to + j] = factor * (j + 1) * x[at + j + 1]
    out[to + ORDER] = 0.0


@inner
def contact_force(eta, eta_at, x, x_at, first, rate, out, buffer, to):
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
    """Bound on what `contact_force` cuts off of the product η·(X - edge) behind ORDER."""
    total, beyond = 0.0, 0.0
    for i in range(1, ORDER + 1):
        beyond += abs(x[x_at + ORDER + 1 - i])
        total += abs(eta[eta_at + i]) * beyond
    return total
