"""The worst combination of values between limits, from a bad one on.

A compass search: each value is moved to both its limits and by a step either way, the moves that make it
worse are put together one after the other, and where none does the step is halved. So at the end no single
value at one of its limits, nor a last step away, is worse, unless the search ended at `MOST` combinations.
What the height does not depend on ends at its upper limit, so that rounding does not decide it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import accumulate
from math import isclose
from typing import TypeAlias

from gearlash.results.tolerance import ToleranceInput

Row: TypeAlias = tuple[float, ...]

STEP, LAST_STEP = 0.25, 0.05  # of the distance between the limits
MOST = 400  # combinations
ROUNDING = 1e-9  # of the heights that are compared


def worst_from(
    begin: Row, height: float, inputs: Sequence[ToleranceInput], heights: Callable[[list[Row]], list[float]]
) -> Row:
    """The combination of least height that is found, from ``begin`` whose height is given. ``heights`` of
    combinations; none where it was stopped."""
    best, height = _at_upper_limits(begin, height, inputs, heights)
    step, looked = STEP, len(inputs)
    while step >= LAST_STEP and looked < MOST:
        moves = [(i, to) for i, one in enumerate(inputs) for to in _places(best[i], one, step)]
        singly = heights([_moved(best, move) for move in moves])
        if not singly:
            break
        worse = sorted((h, k) for k, h in enumerate(singly) if _below(h, height))
        looked += len(moves)
        if not worse:
            step /= 2.0
            continue
        chosen: dict[int, tuple[int, float]] = {}
        for _, k in worse:
            chosen.setdefault(moves[k][0], moves[k])
        rows = list(accumulate(chosen.values(), _moved, initial=best))[1:]
        jointly = heights(rows)
        if not jointly:
            break
        looked += len(rows)
        found = min(zip(jointly, rows, strict=True))
        if not _below(found[0], height):
            break
        height, best = found
    return best


def _at_upper_limits(
    row: Row, height: float, inputs: Sequence[ToleranceInput], heights: Callable[[list[Row]], list[float]]
) -> tuple[Row, float]:
    """The combination with each value at its upper limit that, moved there alone, does not change the
    height; and its height. The same combination where all of them together change it."""
    moves = [(i, one.upper) for i, one in enumerate(inputs)]
    alone = heights([_moved(row, move) for move in moves])
    idle = [
        move for move, h in zip(moves, alone, strict=False) if not _below(h, height) and not _below(height, h)
    ]
    if not idle:
        return row, height
    moved = list(accumulate(idle, _moved, initial=row))[-1]
    found = heights([moved])
    if not found or _below(height, found[0]):
        return row, height
    return moved, found[0]


def _below(one: float, other: float) -> bool:
    """By more than rounding."""
    return one < other and not isclose(one, other, rel_tol=ROUNDING)


def _places(at: float, one: ToleranceInput, step: float) -> list[float]:
    """Other values of an input that are tried."""
    size = one.upper - one.lower
    tried = (one.lower, one.upper, max(one.lower, at - step * size), min(one.upper, at + step * size))
    return sorted({value for value in tried if value != at})


def _moved(row: Row, move: tuple[int, float]) -> Row:
    i, to = move
    return (*row[:i], to, *row[i + 1 :])
