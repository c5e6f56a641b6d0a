"""What a clearance may do next: the surfaces that bound its present mode, and the first one that is reached."""

from __future__ import annotations

from gearlash._kernel import inner

from ._cells import UNIT_ROUNDING
from ._exits import NONE, first_exit
from ._series import fourier_value, pressing
from ._tables import FREE, MINUS, NO_TENSION, ORDER, OVER_MINUS, OVER_PLUS, PLUS, TERMS, Shape
from ._vector import linear, weigh
from ._work import GAPS, SURFACE

ROUNDING = 24.0 * UNIT_ROUNDING  # of a boundary's place
DERIVED = 84.0  # a bound on the derivative of what is bounded by 1: at most this (remainder: see `_majorant`)
NO_STOP = 1e300  # the gap of a side that has nothing to hit


@inner
def gap_series(shape: Shape, memory, slot, cell, c, u, work):
    """GAPS ← Taylor coefficients of X - edge of clearance c over the cell that starts (virtually) at u."""
    place = slot + shape.gap + (cell * shape.clearances + c) * (1 + shape.n) * TERMS
    linear(memory, place, TERMS, TERMS, 1 + shape.n, u, 0, work, GAPS + c * TERMS)


@inner
def next_exit(shape: Shape, memory, slot, cell, c, mode, rule, u, start, end, on, held, work):
    """First exit of clearance c from its mode in [start, end] of the cell: (s or NONE, boundary ±1, the mode
    behind it, undecided). ``on``: the boundary that was crossed at ``start``; ``held``:
    one that is not crossed (0: none)."""
    gap_series(shape, memory, slot, cell, c, u, work)
    place = slot + shape.bound + (cell * shape.clearances + c) * shape.p
    bound = weigh(memory, place, shape.p, u, 0)
    x, gaps = GAPS + c * TERMS, shape.gaps + 4 * c
    best, through, behind, undecided = NONE, 0, mode, False
    for boundary in (1, -1):
        beyond = PLUS if boundary > 0 else MINUS
        over = OVER_PLUS if boundary > 0 else OVER_MINUS
        gap = memory[gaps + (0 if boundary > 0 else 1)]
        if boundary == held or gap >= NO_STOP or not (mode == FREE or mode == beyond or mode == over):
            continue
        edge = 0.0 if mode == beyond else boundary * gap  # where it is in X - (edge of the contact)
        near = bound + ROUNDING * memory[shape.reach + c]
        if mode != beyond or rule != NO_TENSION:  # the place of the boundary
            inward = -boundary if mode == FREE else boundary
            for j in range(ORDER + 1):
                work[SURFACE + j] = inward * work[x + j]
            work[SURFACE] -= inward * edge
            s, open_case = first_exit(shape, memory, work, start, end, near, DERIVED * near, on == boundary)
            undecided = undecided or open_case
            if s < best:
                best, through = s, boundary
                behind = beyond if mode == FREE else FREE
        if rule == NO_TENSION and mode != FREE:  # the force, which must press
            side = 0 if boundary > 0 else 1
            eta = shape.eta + ((cell * shape.clearances + c) * 2 + side) * TERMS
            rate = memory[gaps + 2 + side] / memory[shape.scalars + 1]
            pressing(memory, eta, work, x, work[x] - edge, rate, work, SURFACE)
            inward = boundary if mode == beyond else -boundary
            stiff = 0.0
            for j in range(ORDER + 1):
                stiff += abs(memory[eta + j])
                work[SURFACE + j] *= inward
            far = stiff * near + rate * DERIVED * near
            s, open_case = first_exit(shape, memory, work, start, end, far, DERIVED * far, on == boundary)
            undecided = undecided or open_case
            if s < best:
                best, through = s, boundary
                behind = over if mode == beyond else beyond
    return best, through, behind, undecided


@inner
def first_mode(shape: Shape, memory, c, rule, theta, u):
    """Mode of clearance c in a state at a phase. Within rounding of a boundary the direction decides: a
    crossing there belongs to the span that ends in it."""
    p, long = shape.p, 2 * shape.harmonics + 1
    x = -fourier_value(memory, shape.offset + c * long, shape.harmonics, theta)
    speed = fourier_value(memory, shape.drift + c * long, shape.harmonics, theta)
    size = abs(x)
    for i in range(1, 1 + shape.n):
        x += memory[shape.reads + c * p + i] * u[i]
        speed += memory[shape.speed + c * p + i] * u[i]
        size += abs(memory[shape.reads + c * p + i] * u[i])
    for boundary in (1, -1):
        side = 0 if boundary > 0 else 1
        gap = memory[shape.gaps + 4 * c + side]
        if gap >= NO_STOP:
            continue
        beyond, bound = boundary * x - gap, ROUNDING * (size + memory[shape.reach + c])
        moving = boundary * speed
        if beyond > bound or (abs(beyond) <= bound and moving > bound * memory[shape.scalars]):
            pressed = PLUS if boundary > 0 else MINUS
            if rule != NO_TENSION or beyond <= bound:
                return pressed
            place = shape.stiffness + (2 * c + side) * long
            stiffness = fourier_value(memory, place, shape.harmonics, theta)
            force = stiffness * beyond + memory[shape.gaps + 4 * c + 2 + side] * moving
            return pressed if force > 0.0 else (OVER_PLUS if boundary > 0 else OVER_MINUS)
    return FREE
