"""Taylor coefficients, in local time, of Fourier series and of the state."""

from __future__ import annotations

import numpy as np

from gearlash._kernel import fma, inner

from ._blocks import next_coefficient
from ._tables import ORDER, Tables


@inner
def copy(source, target):
    """target ← source, element by element (array slices would drag numpy's error texts through the
    compiler)."""
    for i in range(len(source)):
        target[i] = source[i]


@inner
def copy_first(source, n, target):
    for i in range(n):
        target[i] = source[i]


@inner
def fill(target, value):
    for i in range(len(target)):
        target[i] = value


@inner
def fourier_taylor(series, theta, width, out):
    """Coefficients in s of ``series(theta + width·s)``; writes out[0..ORDER]."""
    fill(out, 0.0)
    out[0] = series[0]
    c1, s1 = np.cos(theta), np.sin(theta)
    c, s = 1.0, 0.0
    for n in range(1, (len(series) + 1) // 2):
        c, s = c * c1 - s * s1, s * c1 + c * s1
        # value and first derivative alternate through all higher ones
        even = series[2 * n - 1] * c + series[2 * n] * s
        odd = series[2 * n] * c - series[2 * n - 1] * s
        factor = 1.0
        for j in range(0, ORDER + 1, 2):
            out[j] += even * factor
            factor *= n * width / (j + 1)
            if j + 1 <= ORDER:
                out[j + 1] += odd * factor
            factor *= -n * width / (j + 2)


@inner
def product(a, b, j):
    """Coefficient j of the product of two series, in four independent sums."""
    s0 = s1 = s2 = s3 = 0.0
    i = 0
    while i + 3 <= j:
        s0 = fma(a[i], b[j - i], s0)
        s1 = fma(a[i + 1], b[j - i - 1], s1)
        s2 = fma(a[i + 2], b[j - i - 2], s2)
        s3 = fma(a[i + 3], b[j - i - 3], s3)
        i += 4
    while i <= j:
        s0 = fma(a[i], b[j - i], s0)
        i += 1
    return (s0 + s1) + (s2 + s3)


@inner
def expand_state(t: Tables, region, theta, duration, z, zc, xc, eta, work):
    """Taylor coefficients zc (ORDER+1, p) of the state and xc (ORDER+1) of X - edge, over `duration` from
    `theta`.

    `work` (2 + rows, ORDER+1) receives offset and forcing series. One step of the recurrence is
    z_{j+1} = duration/(j+1) · (M z_j + g Σ η_i x_{j-i} + b_j).
    """
    n = t.maps.shape[2]
    width = t.scalars[0] * duration
    fourier_taylor(t.stiffness[region], theta, width, eta)
    fourier_taylor(t.offset, theta, width, work[0])
    for f in range(len(t.rows)):
        fourier_taylor(t.forcing[f], theta, width, work[1 + f])
    matrix, gain, reads, read = t.matrix, t.gain, t.reads, t.read
    copy(z, zc[0])
    for j in range(ORDER + 1):
        x = -work[0, j]
        for m in range(len(reads)):
            x += read[m] * zc[j, reads[m]]
        if j == 0:
            x -= t.edge[region]
        xc[j] = x
        if j == ORDER:
            break
        scale = duration / (j + 1)
        next_coefficient(matrix, region, gain, product(eta, xc, j), scale, zc, j, n)
        for f in range(len(t.rows)):
            zc[j + 1, t.rows[f]] += work[1 + f, j] * scale


@inner
def advance_tangents(t: Tables, region, theta, duration, tangents, eta, vc, wc):
    """Carries tangent vectors (m, n) over `duration` from `theta` in one region, in place."""
    n = t.maps.shape[2]
    fourier_taylor(t.stiffness[region], theta, t.scalars[0] * duration, eta)
    matrix, gain = t.matrix, t.gain
    for m in range(tangents.shape[0]):
        copy(tangents[m], vc[0])
        for j in range(ORDER):
            w = 0.0
            for i in range(len(t.reads)):
                w += t.read[i] * vc[j, t.reads[i]]
            wc[j] = w
            next_coefficient(matrix, region, gain, product(eta, wc, j), duration / (j + 1), vc, j, n)
        horner(vc, 1.0, tangents[m])


@inner
def horner(coefficients, s, out):
    """Values at s of the polynomials in the columns of `coefficients` (degree+1, n)."""
    degree = coefficients.shape[0] - 1
    copy(coefficients[degree], out)
    for j in range(degree - 1, -1, -1):
        for i in range(len(out)):
            out[i] = fma(out[i], s, coefficients[j, i])


@inner
def polynomial(coefficients, s):
    """Value at s of one polynomial."""
    value = 0.0
    for j in range(len(coefficients) - 1, -1, -1):
        value = fma(value, s, coefficients[j])
    return value
