"""Every sign change of a polynomial on [0, 1], in 80-bit arithmetic.

Between neighbouring zeros of p′ the polynomial is monotone: one sign comparison decides whether it has a zero
there. So zeros are found from those of p′, these from those of p″, and so on down to a derivative that
cannot vanish. No sampling, no tolerance, no Bernstein form.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np

Real = np.longdouble
ZERO, ONE = Real(0), Real(1)


def value(p, u):
    """p[0] + p[1] u + … by Horner."""
    out = p[-1]
    for c in p[-2::-1]:
        out = out * u + c
    return out


def derivative(p: np.ndarray) -> np.ndarray:
    return p[1:] * np.arange(1, len(p))


def sign_changes(p: np.ndarray) -> list:
    """Where p changes its sign in (0, 1), ascending; p[0] ≠ 0 (divide out a known zero at 0 first)."""
    size = np.abs(p)
    if len(p) == 1 or size[0] > size[1:].sum():
        return []
    terms = [Real(c) for c in p]
    ends = [ZERO, *sign_changes(derivative(p)), ONE]
    heights = [value(terms, u) for u in ends]
    return [
        _between(terms, a, b, fa)
        for (a, b), (fa, fb) in zip(pairwise(ends), pairwise(heights), strict=True)
        if (fa > 0) != (fb > 0) and fa != 0
    ]


def _between(p: list, a, b, fa):
    """The zero of a monotone p in [a, b]: Newton, by bisection where it leaves the bracket."""
    slope = [k * c for k, c in enumerate(p)][1:]
    u = (a + b) / 2
    for _ in range(200):
        f = value(p, u)
        if f == 0:
            return u
        if (f > 0) == (fa > 0):
            a = u
        else:
            b = u
        rate = value(slope, u)
        new = u - f / rate if rate != 0 else (a + b) / 2
        if not a < new < b:
            new = (a + b) / 2
        if abs(new - u) <= 1e-19 * abs(u) or new in (a, b):
            return new
        u = new
    return u
