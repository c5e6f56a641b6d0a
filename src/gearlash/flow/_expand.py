"""The state itself as a polynomial: for traces, and where a motion starts or stops inside a cell."""

from __future__ import annotations

from gearlash._kernel.jit import fma, inner

from ._series import fourier_taylor
from ._tables import FREE, ORDER, TERMS, Shape
from ._vector import add, linear, move, multiple


@inner
def expand(shape: Shape, memory, slot, sides, theta, duration, u, zc, series, factors):
    """Fills zc (ORDER+1, p) with the Taylor coefficients of (1, z - c) over ``duration`` (it may be
    negative) from phase ``theta``, in the region of the slot.

    sides (clearances): its `PLUS`, `FREE`, `MINUS`; u (p): the state there; series (4·clearances + n, TERMS)
    and factors (n + clearances): work. One step of the recurrence is
    z_{j+1} = duration/(j+1) · (M z_j + Σ g Σ_i η_i x_{j-i} + b_j)."""
    n, p, count = shape.n, shape.p, shape.clearances
    width, long = memory[shape.scalars] * duration, 2 * shape.harmonics + 1
    for c in range(count):
        fourier_taylor(
            memory, shape.offset + c * long, shape.harmonics, theta, width, series, (count + c) * TERMS
        )
        series[(count + c) * TERMS] -= memory[shape.offset + c * long] + memory[slot + shape.lag + c]
    for i in range(n):
        if _any(memory, slot + shape.forcing + i * long, long):
            place = slot + shape.forcing + i * long
            fourier_taylor(memory, place, shape.harmonics, theta, width, series, (2 * count + i) * TERMS)
        else:
            for j in range(TERMS):
                series[(2 * count + i) * TERMS + j] = 0.0
    gaps = (2 * count + n) * TERMS  # X of each clearance, behind the rest
    eta = gaps + count * TERMS
    for c in range(count):
        if sides[c] != FREE:
            place = shape.stiffness + (2 * c + (0 if sides[c] == 0 else 1)) * long
            fourier_taylor(memory, place, shape.harmonics, theta, width, series, eta + c * TERMS)
    for i in range(p):
        zc[i] = u[i]
    for j in range(ORDER):
        for i in range(n):
            factors[i] = zc[j * p + 1 + i]
        for c in range(count):
            x = -series[(count + c) * TERMS + j]
            for i in range(n):
                x = fma(memory[shape.reads + c * p + 1 + i], factors[i], x)
            series[gaps + c * TERMS + j] = x
            push = 0.0
            if sides[c] != FREE:
                for i in range(j + 1):
                    push = fma(series[eta + c * TERMS + i], series[gaps + c * TERMS + j - i], push)
            factors[n + c] = push
        linear(memory, slot + shape.matrix, p, p, n + count, factors, 0, zc, (j + 1) * p)
        scale = duration / (j + 1)
        for i in range(n):
            zc[(j + 1) * p + 1 + i] = (zc[(j + 1) * p + 1 + i] + series[(2 * count + i) * TERMS + j]) * scale


@inner
def _any(values, at, count):
    for i in range(at, at + count):  # noqa: SIM110 - kernels know no generators
        if values[i] != 0.0:
            return True
    return False


@inner
def horner(zc, p, s, out):
    """out (p) ← values at s of the polynomials in zc (ORDER+1, p)."""
    move(zc, ORDER * p, out, 0, p)
    for j in range(ORDER - 1, -1, -1):
        multiple(s, out, 0, out, 0, p)
        add(1.0, zc, j * p, out, 0, p)


@inner
def carry_inside(shape: Shape, memory, slot, sides, cell, start, end, u, zc, series, factors, out):
    """out (p) ← the state at local time ``end`` of a cell, from the one at ``start`` (either may be
    later)."""
    width, duration = memory[shape.scalars + 2], memory[shape.scalars + 1]
    if start == end:
        for i in range(shape.p):
            out[i] = u[i]
        return
    theta = (cell + start) * width
    expand(shape, memory, slot, sides, theta, (end - start) * duration, u, zc, series, factors)
    horner(zc, shape.p, 1.0, out)
