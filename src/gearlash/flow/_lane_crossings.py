"""Crossings of several motions, which were gathered in one block (`_lanes`), at the same time."""

from __future__ import annotations

from gearlash._kernel.jit import inlined

from ._blocks import LANES
from ._lane_vectors import (
    bounds_lanes,
    choose,
    jets_lanes,
    lead_back_lanes,
    linear_lanes,
    powers_lanes,
    values_lanes,
)
from ._lanes import (
    AT_START,
    GATHER_BLOCK,
    IN_MID_CELL,
    ON_MINUS,
    ON_PLUS,
    PROVED,
    inside,
    slot_of_mode,
    used_rows,
)
from ._root_isolation import MOST_HALLEY_STEPS, halley
from ._sign_test import EXIT_AND_RETURN, LATER_EXIT, ONE_EXIT, farthest, leaving
from ._surfaces import PLACE_ROUNDING, inward_of
from ._tables import FREE, MINUS, ORDER, PLUS, TERMS, Shape
from ._vector import move, multiple, ones_in, times

FEWEST_LANES = 2  # so many crossings alone cost as much as eight at once


@inlined
def _polish(lanes, mask, place, sign):
    """`at` ← where each crosses, from `lo`, `hi` and the guess in `at`: `_root_isolation.polish`, eight at
    a time."""
    for lane in range(LANES):
        guess, lo, hi = lanes.at[lane], lanes.lo[lane], lanes.hi[lane]
        lanes.at[lane] = guess if lo < guess < hi else 0.5 * (lo + hi)
    for _ in range(MOST_HALLEY_STEPS):
        jets_lanes(lanes.gap, lanes.at, lanes.jet)
        for lane in range(LANES):
            if (mask >> lane) & 1 != 0:
                done, lanes.at[lane], lanes.lo[lane], lanes.hi[lane] = halley(
                    lanes.jet[lane] - place, lanes.jet[LANES + lane], lanes.jet[2 * LANES + lane], sign,
                    lanes.lo[lane], lanes.hi[lane], lanes.at[lane],
                )  # fmt: skip
                if done:
                    mask &= ~(1 << lane)
        if mask == 0:
            break


@inlined
def _switch(shape: Shape, memory, source, target, k, side, sign, edge, mask, lanes):
    """u ← the virtual starts behind crossings at `at`: `_switch.switch_state`, eight at a time."""
    used = used_rows(shape)
    powers_lanes(lanes.at, lanes.powers)
    move(lanes.gap, 0, lanes.push, 0, LANES * TERMS)
    bounds_lanes(-edge, 1.0, lanes.push, 0.0, lanes.push)
    times(lanes.powers, 0, lanes.push, 0, LANES * TERMS)
    linear_lanes(memory, shape.hilbert, TERMS, TERMS, ORDER + 1, lanes.push, 0, lanes.moments, 0)
    times(lanes.powers, 0, lanes.moments, 0, LANES * TERMS)
    push = target + shape.push + (2 * k + side) * (ORDER + 1) * shape.p
    linear_lanes(memory, push, shape.p, used, ORDER + 1, lanes.moments, 0, lanes.out, 0)
    multiple(memory[shape.scalars + 1], lanes.at, 0, lanes.limit, 0, LANES)
    lead_back_lanes(
        -sign, lanes.limit, lanes.out, memory, source + shape.centre, target + shape.centre, lanes.u, used
    )
    choose(mask, lanes.out, lanes.u, 0, used)


@inlined
def _place(shape: Shape, memory, mode, boundary):
    """Of a boundary, told from the edge that X is told from in a mode."""
    return boundary * memory[shape.gaps + (0 if boundary > 0 else 1)] if mode == FREE else 0.0


@inlined
def _bracket(shape: Shape, memory, mode, mask, lanes):
    """Fills `lo`, `hi` and the guess in `at` of the crossings of a mask; returns those of which there is one
    for sure: the first part of `_surfaces.one_crossing`."""
    for lane in range(LANES):  # a place that is to be inside or beyond
        inward = inward_of(mode, lanes.boundary[lane])
        side = -inward if lanes.verdict[lane] == EXIT_AND_RETURN else inward
        if (mask >> lane) & 1 == 0:
            continue
        if lanes.verdict[lane] == ONE_EXIT:
            lanes.at[lane] = inside(lanes, GATHER_BLOCK, lane)
        else:
            lanes.at[lane] = farthest(lanes.seen, lane * TERMS, side)
    values_lanes(lanes.gap, lanes.at, lanes.limit)
    for lane in range(LANES):
        if (mask >> lane) & 1 == 0:
            continue
        verdict, boundary = lanes.verdict[lane], lanes.boundary[lane]
        inward, place = inward_of(mode, boundary), _place(shape, memory, mode, boundary)
        lanes.lo[lane], lanes.hi[lane] = inside(lanes, GATHER_BLOCK, lane), 1.0
        if verdict != ONE_EXIT or lanes.lo[lane] > 0.0:
            side, between = (-inward if verdict == EXIT_AND_RETURN else inward), lanes.at[lane]
            near = lanes.near[lane] + PLACE_ROUNDING * memory[shape.reach]
            late = verdict == ONE_EXIT or between > lanes.lo[lane]
            if not (late and side * (lanes.limit[lane] - place) > near):
                mask &= ~(1 << lane)
                continue
            if verdict == EXIT_AND_RETURN:
                lanes.hi[lane] = between
            else:
                lanes.lo[lane] = between
        lanes.at[lane] = leaving(lanes.seen, lane * TERMS, inward, place, verdict == LATER_EXIT)
    return mask


@inlined
def _cross_lanes(shape: Shape, memory, slot_of, slot, k, mode, boundary, mask, lanes, counts, stretch):
    """Carries the motions of a mask over their crossings of the same boundary in cell k."""
    side = 0 if boundary > 0 else 1
    behind = FREE if mode != FREE else (PLUS if boundary > 0 else MINUS)
    sign, target = (1.0 if behind != FREE else -1.0), slot_of_mode(shape, slot_of, behind)
    _polish(lanes, mask, _place(shape, memory, mode, boundary), inward_of(mode, boundary))
    edge = boundary * memory[shape.gaps + side] if sign > 0.0 else 0.0
    _switch(shape, memory, slot, target, k, side, sign, edge, mask, lanes)
    for which in (mode, ON_PLUS, ON_MINUS, AT_START, PROVED):
        lanes.masks[which] &= ~mask
    for which in (behind, IN_MID_CELL, ON_PLUS if boundary > 0 else ON_MINUS):
        lanes.masks[which] |= mask
    for lane in range(LANES):
        if (mask >> lane) & 1 != 0:
            counts[lanes.motions[lane], stretch, (0 if sign > 0.0 else 2) + side] += 1
            lanes.s[lane] = lanes.at[lane]


@inlined
def cross_in_lanes(shape: Shape, memory, slot_of, slot, k, mode, mask, lanes, counts, stretch):
    """Carries those of a mask over their next crossing, boundary by boundary, unless they are few or it is
    not certain. Returns those that it left."""
    if ones_in(mask) < FEWEST_LANES:
        return mask
    series = slot + shape.gap + k * (1 + shape.n) * TERMS
    linear_lanes(memory, series, TERMS, TERMS, 1 + shape.n, lanes.u, 0, lanes.gap, 0)
    sure = _bracket(shape, memory, mode, mask, lanes)
    left, upward = mask & ~sure, 0
    for lane in range(LANES):
        if (sure >> lane) & 1 != 0 and lanes.boundary[lane] > 0:
            upward |= 1 << lane
    for boundary in (1, -1):
        group = upward if boundary > 0 else sure & ~upward
        if ones_in(group) < FEWEST_LANES:
            left |= group
        else:
            _cross_lanes(shape, memory, slot_of, slot, k, mode, boundary, group, lanes, counts, stretch)
    return left
