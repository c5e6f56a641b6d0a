"""What a clearance may do next: the surfaces that bound its present mode, and the first one that is
reached."""

from __future__ import annotations

from gearlash._kernel.jit import inlined, inner

from ._assemble import UNIT_ROUNDING
from ._root_isolation import NO_ROOT, first_root, polish
from ._series import contact_force, cut_off, fourier_value, polynomial
from ._sign_test import CLEAR, EXIT_AND_RETURN, LATER_EXIT, ONE_EXIT, UNSURE, farthest, leaving, sign_test
from ._tables import FREE, MINUS, NO_TENSION, OVER_MINUS, OVER_PLUS, PLUS, ROUGH, TERMS, Shape
from ._vector import all_over, all_under, linear, multiple, weigh
from ._workspace import BUFFER, GAPS, ONES, SURFACE

PLACE_ROUNDING = 32.0 * UNIT_ROUNDING  # of a boundary's place
DERIVATIVE_BOUND = 94.0  # a bound on the derivative of what is bounded by 1: at most this (`_remainder`)
NO_STOP = 1e300  # the gap of a side that has nothing to hit


@inlined
def gap_series(shape: Shape, memory, slot, cell, c, u, work):
    """GAPS ← Taylor coefficients of X - edge of clearance c over the cell that starts (virtually) at u."""
    place = slot + shape.gap + (cell * shape.clearances + c) * (1 + shape.n) * TERMS
    linear(memory, place, TERMS, TERMS, 1 + shape.n, u, 0, work, GAPS + c * TERMS)


@inlined
def inward_of(mode, boundary):
    """The sign of X - place on the side of a boundary on which a mode is."""
    return float(-boundary if mode == FREE else boundary)


@inlined
def stays(shape: Shape, memory, slot, cell, c, mode, u, moved):
    """Whether clearance c is proved by rough coefficients to keep its mode through a whole cell; moved
    (rows): what the table `step` makes of u."""
    near = weigh(memory, slot + shape.near + (cell * shape.clearances + c) * shape.p, shape.p, u, 0)
    first = shape.p + ROUGH * c
    if mode == FREE:
        near += PLACE_ROUNDING * memory[shape.reach + c]
        plus, minus = memory[shape.gaps + 4 * c], memory[shape.gaps + 4 * c + 1]
        return all_under(moved, first, plus - near) and all_over(moved, first, near - minus)
    if mode == PLUS:
        return all_over(moved, first, near)
    return mode == MINUS and all_under(moved, first, -near)


@inlined
def cell_verdict(shape: Shape, memory, slot, cell, c, mode, rule, on, begun, u, moved):
    """What the sign test proves of clearance c in a whole cell: (a verdict of `sign_test`, the boundary ±1
    that it is about). ``on``: the boundary that was crossed just before in this cell, or 0; ``begun``: it is
    not at the beginning of the cell; moved holds the `fine_coefficients` behind the rows of `step`."""
    near = weigh(memory, slot + shape.rest + (cell * shape.clearances + c) * shape.p, shape.p, u, 0)
    return verdict_of(shape, memory, c, mode, rule, on, begun, near, moved, shape.rows + TERMS * c)


@inlined
def verdict_of(shape: Shape, memory, c, mode, rule, on, begun, near, moved, first):
    """The same from coefficients that lie in moved from ``first`` on, and the bound ``near`` on them."""
    if mode in (PLUS, MINUS):
        boundary = 1 if mode == PLUS else -1
        by_force = rule == NO_TENSION  # then it is the force that is watched, and it may jump
        found = sign_test(moved, first, float(boundary), 0.0, near, on == boundary and not by_force, begun)
        return (UNSURE if by_force and found != CLEAR else found), boundary
    if mode != FREE:
        return UNSURE, 0
    near += PLACE_ROUNDING * memory[shape.reach + c]
    verdict, through = CLEAR, 0
    for boundary in (1, -1):
        gap = memory[shape.gaps + 4 * c + (0 if boundary > 0 else 1)]
        if gap >= NO_STOP:
            continue
        found = sign_test(moved, first, -float(boundary), boundary * gap, near, on == boundary, begun)
        if found != CLEAR:
            if verdict != CLEAR or rule == NO_TENSION:
                return UNSURE, 0
            verdict, through = found, boundary
    return verdict, through


@inlined
def one_crossing(shape: Shape, memory, slot, cell, c, mode, boundary, verdict, s, u, moved, first, work):
    """Where X crosses the boundary of which ``verdict`` (not `CLEAR`, not `UNSURE`) speaks for the first time
    behind s, or `NO_ROOT` where that is not proved; fills GAPS on the way. Its coefficients lie in moved from
    ``first`` on."""
    inward = inward_of(mode, boundary)
    place = boundary * memory[shape.gaps + 4 * c + (0 if boundary > 0 else 1)] if mode == FREE else 0.0
    x = GAPS + c * TERMS
    gap_series(shape, memory, slot, cell, c, u, work)
    lo, hi = s, 1.0
    if verdict != ONE_EXIT or s > 0.0:
        # two crossings or none: two, where a point between them is found; one, if it is inside before
        side = -inward if verdict == EXIT_AND_RETURN else inward
        between = s if verdict == ONE_EXIT else farthest(moved, first, side)
        near = weigh(memory, slot + shape.rest + (cell * shape.clearances + c) * shape.p, shape.p, u, 0)
        near += PLACE_ROUNDING * memory[shape.reach + c]
        if (verdict != ONE_EXIT and between <= s) or not side * (polynomial(work, x, between) - place) > near:
            return NO_ROOT
        lo, hi = (s, between) if verdict == EXIT_AND_RETURN else (between, 1.0)
    start = leaving(moved, first, inward, place, verdict == LATER_EXIT)
    return polish(work, x, place, lo, hi, start, inward)


@inlined
def next_exit(shape: Shape, memory, slot, cell, c, mode, rule, u, start, end, on, held, work):
    """First exit of clearance c from its mode in [start, end] of the cell: (s or NO_ROOT, boundary ±1, the
    mode behind it, undecided). ``on``: the boundary that was crossed at ``start``; ``held``:
    one that is not crossed (0: none)."""
    gap_series(shape, memory, slot, cell, c, u, work)
    place = slot + shape.bound + (cell * shape.clearances + c) * shape.p
    bound = weigh(memory, place, shape.p, u, 0)
    x, gaps = GAPS + c * TERMS, shape.gaps + 4 * c
    swing = weigh(work, ONES, TERMS, work, x) - abs(work[x])
    best, through, behind, undecided = NO_ROOT, 0, mode, False
    for k in range(4):
        boundary, forced = 1 - 2 * (k // 2), k % 2 == 1
        beyond = PLUS if boundary > 0 else MINUS
        over = OVER_PLUS if boundary > 0 else OVER_MINUS
        side = 0 if boundary > 0 else 1
        gap, damping = memory[gaps + side], memory[gaps + 2 + side]
        if boundary == held or gap >= NO_STOP or mode not in (FREE, beyond, over):
            continue
        edge = 0.0 if mode == beyond else boundary * gap  # where it is in X - (edge of the contact)
        near = bound + PLACE_ROUNDING * memory[shape.reach + c]
        eta = shape.eta + ((cell * shape.clearances + c) * 2 + side) * TERMS
        if forced:  # the force, which must press
            if rule != NO_TENSION or mode == FREE:
                continue
            near = _force_surface(
                shape, memory, x, eta, memory[shape.lost + 2 * c + side], edge, damping, near, boundary,
                mode == beyond, work,
            )  # fmt: skip
        else:  # the place of the boundary
            inward = inward_of(mode, boundary)
            if mode == beyond and rule == NO_TENSION and damping != 0.0:
                continue  # the force is zero before
            if inward * (work[x] - edge) - swing > near:
                continue  # out of reach
            multiple(inward, work, x, work, SURFACE, TERMS)
            work[SURFACE] -= inward * edge
        s, open_case = first_root(
            shape, memory, work, start, end, near, DERIVATIVE_BOUND * near, on == boundary
        )
        undecided = undecided or open_case
        if s < best:
            best, through = s, boundary
            if forced:
                behind = over if mode == beyond else beyond
            else:
                behind = beyond if mode == FREE else FREE
                if mode == FREE and rule == NO_TENSION and damping == 0.0:  # Φ = η δ presses where η does
                    behind = beyond if polynomial(memory, eta, s) >= 0.0 else over
    return best, through, behind, undecided


@inner
def _force_surface(shape: Shape, memory, x, eta, lost, edge, damping, near, boundary, pressed, work):
    """SURFACE ← the contact force (or minus it, where it does not press yet) of the rule `no-tension`;
    returns the bound on its error. ``lost`` bounds what the series of η leaves out. Without damping Φ = η δ
    presses where η does."""
    rate, sign = damping / memory[shape.scalars + 1], 1.0 if pressed else -1.0
    stiff = weigh(work, ONES, TERMS, memory, eta) + lost
    if damping == 0.0:
        multiple(sign, memory, eta, work, SURFACE, TERMS)
        return PLACE_ROUNDING * stiff + lost
    contact_force(memory, eta, work, x, work[x] - edge, rate, work, BUFFER, SURFACE)
    multiple(sign * boundary, work, SURFACE, work, SURFACE, TERMS)
    size = weigh(work, ONES, TERMS, work, x) + abs(edge)
    return stiff * near + rate * DERIVATIVE_BOUND * near + lost * size + cut_off(memory, eta, work, x)


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
        beyond, bound = boundary * x - gap, PLACE_ROUNDING * (size + memory[shape.reach + c])
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
