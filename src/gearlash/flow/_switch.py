"""Crossings: from the motion in one region to the motion in the next, without leaving the cell.

A cell's tables start from the state at its beginning. After a crossing at s* the motion belongs to another
region B, and what is sought is the state at the beginning of the cell from which B's flow would have come to
the crossing. Both flows differ by one force only, q(s) = Φ_B - Φ_A along the motion in A, so that

    z_B(0) = z_A(0) - ∫_0^s* [flow of B from s to 0] g q(s) ds,

an integral of polynomials. The product of that flow and the stiffness is in the table `push`, so that it is
`push` times the moments of X - edge; a damping that sets in too adds `pull` times those of dX/ds. No series
of the state is needed. Where the field jumps, the derivative of s* with respect to the start adds ± ζ g hᵀ
at the crossing (never as a quotient, which would be 0/0 at grazing; M. di Bernardo et al., Piecewise-smooth
Dynamical Systems, 2008, ch. 2, doi:10.1007/978-1-84628-708-4)."""

from __future__ import annotations

from gearlash._kernel.jit import inlined, inner

from ._series import derivative, polynomial
from ._tables import ALWAYS, FREE, IN_CONTACT, MINUS, NO_TENSION, ORDER, TERMS, Shape
from ._vector import add, lead_back, linear, multiple, powered, times
from ._workspace import GAPS, MOMENTS, OTHER, POWERS, PUSH


@inlined
def side_of(mode):
    """The side in contact: `PLUS`, `MINUS` or `FREE`."""
    return mode if mode <= MINUS else FREE


@inlined
def region_code(modes):
    """Number of the region in which these modes are."""
    code, digit = 0, 1
    for c in range(len(modes)):
        code += side_of(modes[c]) * digit
        digit *= 3
    return code


@inlined
def switch_state(shape: Shape, memory, source, target, cell, c, boundary, sign, rule, s, u, work, change):
    """u (p) ← the virtual start in the region of the slot ``target``, behind a crossing at s; sign is +1
    where the force sets in, -1 where it ceases. GAPS holds X - edge of clearance c along u."""
    side = 0 if boundary > 0 else 1
    edge = boundary * memory[shape.gaps + 4 * c + side] if sign > 0.0 else 0.0
    rate = 0.0 if rule == ALWAYS else memory[shape.gaps + 4 * c + 2 + side] / memory[shape.scalars + 1]
    _change(shape, memory, target, cell, c, side, s, GAPS + c * TERMS, edge, rate, work, change)
    duration, before, after = memory[shape.scalars + 1] * s, source + shape.centre, target + shape.centre
    lead_back(-sign, duration, change, memory, before, after, u, shape.p)


@inner
def switch_tangent(
    shape: Shape, memory, source, target, cell, c, boundary, sign, rule, overlapping, s, v, work, change
):
    """The same for a tangent v (p), in place; ``overlapping``: rule `no-tension`, crossing where Φ = 0."""
    side = 0 if boundary > 0 else 1
    place = source + shape.gap + (cell * shape.clearances + c) * (1 + shape.n) * TERMS
    linear(memory, place, TERMS, TERMS, 1 + shape.n, v, 0, work, OTHER)
    damping = 0.0 if rule == ALWAYS else memory[shape.gaps + 4 * c + 2 + side]
    rate = damping / memory[shape.scalars + 1]
    _change(shape, memory, target, cell, c, side, s, OTHER, 0.0, rate, work, change)
    multiple(memory[shape.scalars + 1] * s, change, 0, change, 0, shape.p)
    add(-sign, change, 0, v, 0, shape.p)
    if rule == IN_CONTACT or (rule == NO_TENSION and not overlapping):
        jump = sign * damping * polynomial(work, OTHER, s)
        place = target + shape.pull + (cell * shape.clearances + c) * (ORDER + 1) * shape.p
        linear(memory, place, shape.p, shape.p, ORDER + 1, work, POWERS, change, 0)
        add(jump, change, 0, v, 0, shape.p)


@inlined
def _change(shape: Shape, memory, target, cell, c, side, s, x, edge, rate, work, change):
    """change (p) ← what the force η·(X - edge) + rate·dX/ds would do from 0 to s, led back to 0, per
    duration of that stretch; X from place ``x``."""
    p, row = shape.p, cell * shape.clearances + c
    powered(s, work, x, edge, work, POWERS, PUSH)
    _moments(shape, memory, work)
    place = target + shape.push + (2 * row + side) * (ORDER + 1) * p
    linear(memory, place, p, p, ORDER + 1, work, MOMENTS, change, 0)
    if rate != 0.0:
        derivative(work, x, rate, work, PUSH)
        times(work, POWERS, work, PUSH, TERMS)
        _moments(shape, memory, work)
        place, more = target + shape.pull + row * (ORDER + 1) * p, GAPS + shape.clearances * TERMS
        linear(memory, place, p, p, ORDER + 1, work, MOMENTS, work, more)
        add(1.0, work, more, change, 0, p)


@inlined
def _moments(shape: Shape, memory, work):
    """MOMENTS ← ∫_0^s σ^i P(σ) dσ / s, for the s whose powers are in POWERS; PUSH holds the coefficients of P
    times those."""
    linear(memory, shape.hilbert, TERMS, TERMS, ORDER + 1, work, PUSH, work, MOMENTS)
    times(work, POWERS, work, MOMENTS, TERMS)
