"""Arithmetic of eight motions side by side: value i of motion l lies at place 8·i + l.

Nothing in such a product waits for its own result, its tables are read once for all eight, and what is done
to single numbers costs an eighth. Every motion's numbers are those of `_vector`, to the last bit: the same
operations in the same order. Kernels get all this in the compiler's own vector instructions
(`_lane_vectors_code`)."""

from __future__ import annotations

from typing import Any

from gearlash._kernel.jit import written_out

from ._blocks import LANES, MASKED
from ._series import jet, polynomial
from ._vector import linear, powers, weigh

_written_out = written_out(f"{__package__}._lane_vectors_code")


def lane(values: Any, at: int, motion: int, count: int) -> Any:
    """The values of one motion."""
    return values[at + motion : at + motion + LANES * count : LANES]


@_written_out
def linear_lanes(
    table: Any, at: int, stride: int, rows: int, count: int, x: Any, first: int, out: Any, to: int
) -> None:
    """out[to:to+rows] ← Σ_k table[at + k·stride:][:rows] · x[first + k], rows a multiple of `ROWS`, of each
    motion."""
    for motion in range(LANES):
        result = [0.0] * rows
        linear(table, at, stride, rows, count, lane(x, LANES * first, motion, count), 0, result, 0)
        lane(out, LANES * to, motion, rows)[:] = result


@_written_out
def weigh_lanes(weights: Any, at: int, count: int, x: Any, first: int, out: Any) -> None:
    """out[l] ← Σ weights[at + i] |x[first + i]|, i < count (a multiple of eight), of each motion l."""
    for motion in range(LANES):
        out[motion] = weigh(weights, at, count, lane(x, LANES * first, motion, count), 0)


@_written_out
def bounds_lanes(place: float, sign: float, near: Any, more: float, out: Any) -> None:
    """out[l] ← place + sign · (near[l] + more), sign ±1."""
    for motion in range(LANES):
        out[motion] = place + sign * (near[motion] + more)


@_written_out
def difference_lanes(table: Any, at: int, x: Any, first: int, out: Any, rows: int) -> None:
    """out[i] ← x[first + i] - table[at + i], i < rows, of each motion."""
    for i in range(rows):
        for motion in range(LANES):
            out[LANES * i + motion] = x[LANES * (first + i) + motion] - table[at + i]


@_written_out
def lead_back_lanes(
    factor: float, scale: Any, change: Any, centres: Any, before: int, after: int, u: Any, rows: int
) -> None:
    """change ← `_vector.lead_back` of the first rows of u, with a scale for each motion."""
    for i in range(rows):
        for motion in range(LANES):
            at = LANES * i + motion
            moved = u[at] + factor * (scale[motion] * change[at])
            change[at] = moved + centres[before + i] - centres[after + i]


@_written_out
def over_lanes(values: Any, at: int, limits: Any) -> int:
    """Mask of the motions l of which all values of the block from row ``at`` on are above limits[l]."""
    return sum(
        1 << motion
        for motion in range(LANES)
        if all(lane(values, LANES * at, motion, LANES) > limits[motion])
    )


@_written_out
def under_lanes(values: Any, at: int, limits: Any) -> int:
    """Mask of the motions of which all are below."""
    return sum(
        1 << motion
        for motion in range(LANES)
        if all(lane(values, LANES * at, motion, LANES) < limits[motion])
    )


@_written_out
def choose(mask: int, source: Any, target: Any, to: int, rows: int) -> None:
    """target[to:to+rows] ← source[:rows] for the motions of a mask."""
    for motion in range(LANES):
        if mask >> motion & 1:
            lane(target, LANES * to, motion, rows)[:] = lane(source, 0, motion, rows)


@_written_out
def apart(values: Any, at: int, rows: int, out: Any) -> None:
    """out[l·rows + i] ← value at + i of motion l, i < rows (a multiple of eight)."""
    for motion in range(LANES):
        out[motion * rows : (motion + 1) * rows] = lane(values, LANES * at, motion, rows)


@_written_out
def powers_lanes(s: Any, out: Any) -> None:
    """`_vector.powers` of each motion."""
    for motion in range(LANES):
        result = [0.0] * MASKED
        powers(float(s[motion]), result, 0)
        lane(out, 0, motion, MASKED)[:] = result


@_written_out
def values_lanes(c: Any, s: Any, out: Any) -> None:
    """out[l] ← value (`_series.polynomial`) at s[l] of the polynomial c of each motion l."""
    for motion in range(LANES):
        out[motion] = polynomial(lane(c, 0, motion, MASKED), 0, float(s[motion]))


@_written_out
def jets_lanes(c: Any, s: Any, out: Any) -> None:
    """out[l], out[8+l], out[16+l] ← value, slope and half the second derivative (`_series.jet`) of the
    polynomial c of each motion l."""
    for motion in range(LANES):
        out[motion::LANES] = jet(lane(c, 0, motion, MASKED), 0, float(s[motion]))
