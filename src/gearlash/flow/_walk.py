"""The march through cells: whole cells by their maps where no contact is possible, Taylor pieces where it is.

A position is counted in cells from phase zero of the base period: an integer cell and a local time s in [0,
1]."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from gearlash._kernel import fma, inner

from ._blocks import bernstein_range, map_cell, map_tangent
from ._roots import DEPTH, NONE, first_exit
from ._series import advance_tangents, copy, expand_state, horner
from ._tables import CHECK, FREE, MINUS, ORDER, PLUS, Array, Tables

OK, TOO_MANY, DIVERGED, WRONG_SIDE = 0, 1, 2, 3
ENGAGE_PLUS, ENGAGE_MINUS, RELEASE_PLUS, RELEASE_MINUS, UNDECIDED = 0, 1, 2, 3, 4
EVENTS_PER_CELL = 4096
HUGE = 1e200
ROUNDING = 32.0 * 2.0**-53


class Scratch(NamedTuple):
    """Work space of one walk; every array is written before it is read."""

    zc: Array  # (ORDER+1, p) Taylor coefficients of the state
    xc: Array  # (ORDER+1) of X - edge
    eta: Array  # (ORDER+1) of the stiffness
    series: Array  # (1 + rows, ORDER+1) of offset and forcing
    distance: Array  # (ORDER+1) of the distance to a boundary
    stack: Array  # (DEPTH+2, ORDER+1)
    limits: Array  # (DEPTH+2, 2)
    vc: Array  # (ORDER+1, p) of a tangent
    z: Array  # (p)


class Record(NamedTuple):
    """What a trace keeps: every piece as a polynomial, every contact event."""

    used: np.ndarray  # (2) int: pieces, events
    piece: Array  # (pieces, 3): position of its start, length in cells, region
    poly: Array  # (pieces, ORDER+1, n)
    event: Array  # (events, 3): position, boundary ±1, engaging 1 or 0
    state: Array  # (events, n)


@inner
def scratch(t: Tables):
    """Work space for one walk."""
    p = len(t.gain)
    return Scratch(
        np.zeros((ORDER + 1, p)),
        np.empty(ORDER + 1),
        np.empty(ORDER + 1),
        np.empty((1 + len(t.rows), ORDER + 1)),
        np.empty(ORDER + 1),
        np.empty((DEPTH + 2, ORDER + 1)),
        np.empty((DEPTH + 2, 2)),
        np.zeros((ORDER + 1, p)),
        np.empty(p),
    )


@inner
def region_of(t: Tables, w: Scratch, z, cell, s):
    """Region of a state, and the boundary ±1 it starts on (0: none).

    Within rounding of a boundary the direction decides; a crossing there belongs to the span that ends in it
    (`arrives`). At rest on a boundary exactly, the curvature decides."""
    theta = (cell + s) * t.scalars[2]
    expand_state(t, FREE, theta, t.scalars[1], z, w.zc, w.xc, w.eta, w.series)
    bound = ROUNDING * (abs(w.xc[0]) + abs(w.xc[1]) + t.gaps[0] + t.gaps[1])
    plus, minus = w.xc[0] - t.gaps[0], -w.xc[0] - t.gaps[1]
    speed = w.xc[1]
    if abs(plus) <= bound and abs(speed) > bound:
        return (PLUS if speed > 0.0 else FREE), 1
    if abs(minus) <= bound and abs(speed) > bound:
        return (MINUS if speed < 0.0 else FREE), -1
    heading = speed if speed != 0.0 else w.xc[2]
    if plus > 0.0 or (plus == 0.0 and heading > 0.0):
        return PLUS, 0
    if minus > 0.0 or (minus == 0.0 and heading < 0.0):
        return MINUS, 0
    return FREE, 0


@inner
def arrives(t: Tables, w: Scratch, region, z, cell, s):
    """The boundary ±1 of `region` that a state is on, within rounding, and moving out through (0: none)."""
    n = t.maps.shape[2]
    x, size = 0.0, 0.0
    for i in range(len(t.reads)):
        x += t.read[i] * z[t.reads[i]]
    for i in range(n):
        size += abs(z[i])
    near = 1e-9 * (size + t.gaps[0] + t.gaps[1])
    if len(t.offset) == 1:  # most states are nowhere near; with a moving gap the polynomials tell
        x -= t.offset[0]
        if abs(x - t.gaps[0]) > near and abs(x + t.gaps[1]) > near:
            return 0
    theta = (cell + s) * t.scalars[2]
    expand_state(t, region, theta, t.scalars[1], z, w.zc, w.xc, w.eta, w.series)
    x = w.xc[0] + t.edge[region]
    bound = ROUNDING * (abs(w.xc[0]) + abs(w.xc[1]) + t.gaps[0] + t.gaps[1])
    if region != MINUS and abs(x - t.gaps[0]) <= bound:
        outward = w.xc[1] if region == FREE else -w.xc[1]
        if outward > bound:
            return 1
    if region != PLUS and abs(x + t.gaps[1]) <= bound:
        outward = -w.xc[1] if region == FREE else w.xc[1]
        if outward > bound:
            return -1
    return 0


@inner
def cell_is_clear(check, slack, bend, region, cell, z, n, lower, upper):
    """Proves that X stays strictly between `lower` and `upper` in the whole cell that starts at z; False
    means "not proved". First by the chord and a bound on the bend, then by Bernstein coefficients.

    Arrays are passed one by one: a tuple of them costs more than the work (each is counted in and out).
    """
    bow, rest = bend[region, cell, n], slack[region, cell, n]
    x0, x1 = check[region, cell, n, 0], check[region, cell, n, CHECK]
    for i in range(n):
        zi = z[i]
        size = abs(zi)
        bow = fma(bend[region, cell, i], size, bow)
        rest = fma(slack[region, cell, i], size, rest)
        x0 = fma(check[region, cell, i, 0], zi, x0)
        x1 = fma(check[region, cell, i, CHECK], zi, x1)
    if min(x0, x1) - bow - rest > lower and max(x0, x1) + bow + rest < upper:
        return True
    lowest, highest = bernstein_range(check, region, cell, z, n)
    return lowest - rest > lower and highest + rest < upper


@inner
def next_exit(t: Tables, region, on, held, z, w: Scratch):
    """First exit of the expanded piece: (s or NONE, boundary ±1, undecided).

    `on` is the boundary just crossed (0: none), `held` a boundary that is not to be crossed (0: none).
    """
    n = t.maps.shape[2]
    size, tail = 0.0, t.tail[region, n]
    for j in range(ORDER + 1):
        size += abs(w.xc[j])
    for i in range(n):
        tail += t.tail[region, i] * abs(z[i])
    bound = ROUNDING * (size + t.gaps[0] + t.gaps[1]) + tail
    best, through, undecided = NONE, 0, False
    for boundary in (1, -1):
        if boundary == held or (region == PLUS and boundary < 0) or (region == MINUS and boundary > 0):
            continue
        inward = 1.0 if (region == PLUS or (region == FREE and boundary < 0)) else -1.0
        for j in range(ORDER + 1):
            w.distance[j] = inward * w.xc[j]
        if region == FREE:
            w.distance[0] += t.gaps[0] if boundary > 0 else t.gaps[1]
        s, open_case = first_exit(w.distance, on == boundary, bound, t.to_bernstein, w.stack, w.limits)
        undecided = undecided or open_case
        if s < best:
            best, through = s, boundary
    return best, through, undecided


@inner
def _keep_event(record: Record, position, boundary, engaging, z):
    i = record.used[1]
    if i >= len(record.event):
        return False
    record.event[i, 0] = position
    record.event[i, 1] = boundary
    record.event[i, 2] = 1.0 if engaging else 0.0
    for v in range(record.state.shape[1]):
        record.state[i, v] = z[v]
    record.used[1] = i + 1
    return True


@inner
def cross(region, boundary, position, z, counts, record):
    """Counts and records one crossing; returns whether there was room, and the region behind it."""
    engaging = region == FREE
    counts[(0 if engaging else 2) + (0 if boundary > 0 else 1)] += 1
    behind = FREE
    if engaging:
        behind = PLUS if boundary > 0 else MINUS
    if record.used[0] >= 0:
        return _keep_event(record, position, boundary, engaging, z), behind
    return True, behind


@inner
def walk(t: Tables, w: Scratch, z, tangents, region, on, cell, s, stop_cell, stop_s, hold, counts, record):
    """Carries z (and tangents (m, n)) in place from (cell, s) to (stop_cell, stop_s); returns (outcome,
    region).

    `on` is the boundary ±1 it starts on (0: none). `hold` (3): a boundary that is not crossed between two
    positions (0: none). `counts` (5) int is added to. `record` with used[0] < 0 keeps nothing."""
    cells = t.maps.shape[1]
    n, m = t.maps.shape[2], tangents.shape[0]
    keep = record.used[0] >= 0
    maps, shift, check, slack, bend = t.maps, t.shift, t.check, t.slack, t.bend
    moved = w.z
    plus, minus = t.gaps[0], -t.gaps[1]
    while cell < stop_cell or (cell == stop_cell and s < stop_s):
        k = cell % cells
        end = 1.0 if cell < stop_cell else stop_s
        holding = hold[0] != 0.0 and hold[1] < cell + 1.0 and hold[2] > cell
        if s == 0.0 and end == 1.0 and on == 0 and not keep and not holding:
            lower = plus if region == PLUS else (minus if region == FREE else -np.inf)
            upper = minus if region == MINUS else (plus if region == FREE else np.inf)
            if cell_is_clear(check, slack, bend, region, k, z, n, lower, upper):
                map_cell(maps, shift, region, k, z, n, moved)
                copy(moved, z)
                for v in range(m):
                    map_tangent(maps, region, k, tangents, v, n, moved)
                    copy(moved, tangents[v])
                cell += 1
                continue
        if not _bounded(z, n):  # no polynomial of infinities can be subdivided to an end
            return DIVERGED, region
        outcome, region = _cell_by_pieces(t, w, z, tangents, region, on, cell, s, end, hold, counts, record)
        if outcome != OK:
            return outcome, region
        on = 0
        s = 0.0
        cell += 1
    return (OK if _bounded(z, n) else DIVERGED), region


@inner
def _bounded(z, n):
    size = 0.0
    for i in range(n):
        size += abs(z[i])
    return size < HUGE


@inner
def _cell_by_pieces(t: Tables, w: Scratch, z, tangents, region, on, cell, s, end, hold, counts, record):
    """One cell, or the part of it from s to `end`, event by event."""
    events = 0
    width, duration = t.scalars[2], t.scalars[1]
    while s < end:
        held, stop = 0, end
        if hold[0] != 0.0:
            if cell + s >= hold[1] and cell + s < hold[2]:
                held = int(hold[0])
                if hold[2] < cell + stop:
                    stop = hold[2] - cell
            elif hold[1] > cell + s and hold[1] < cell + stop:
                stop = hold[1] - cell
        length = stop - s
        theta = (cell % t.maps.shape[1] + s) * width
        expand_state(t, region, theta, length * duration, z, w.zc, w.xc, w.eta, w.series)
        at, boundary, undecided = next_exit(t, region, on, held, z, w)
        if undecided:
            counts[UNDECIDED] += 1
        part = 1.0 if at == NONE else at
        keep = record.used[0] >= 0
        if keep and not _keep_piece(record, cell + s, length * part, region, w.zc, part):
            return TOO_MANY, region
        horner(w.zc, part, z)
        if tangents.shape[0] > 0 and part > 0.0:
            advance_tangents(t, region, theta, length * part * duration, tangents, w.eta, w.vc, w.xc)
        if at == NONE:
            s = stop
            on = 0
            continue
        s = s + length * part
        on = boundary
        kept, region = cross(region, boundary, cell + s, z, counts, record)
        if not kept:
            return TOO_MANY, region
        events += 1
        if events > EVENTS_PER_CELL:
            return TOO_MANY, region
    return OK, region


@inner
def _keep_piece(record: Record, position, length, region, zc, part):
    """Stores a piece with its polynomial in local time of its own (0 to 1 over the piece)."""
    i = record.used[0]
    if i >= len(record.piece):
        return False
    if length <= 0.0:
        return True
    record.piece[i, 0], record.piece[i, 1], record.piece[i, 2] = position, length, region
    power = 1.0
    for j in range(zc.shape[0]):
        for v in range(record.poly.shape[2]):
            record.poly[i, j, v] = zc[j, v] * power
        power *= part
    record.used[0] = i + 1
    return True
