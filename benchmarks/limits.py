"""The limit: what a period needs at the least by this method, in these cells, and what this core can do."""

from __future__ import annotations

import numba
import numpy as np

from gearlash.flow import ROUGH, TERMS

from .peers.plain import Array
from .results import Limit
from .timing import seconds as seconds_of
from .works import Work

CHAIN = 32  # multiply-adds on each number between reading and writing it: memory does not count
VECTOR = 512
SMALLEST = 16_384  # bytes of a table that reading is measured on: of a smaller one, the loop is


def limits(found: list[Work], seconds: dict[str, float], together: dict[str, float]) -> tuple[Limit, ...]:
    """For each piece of work, beside its measured seconds per period, of one trajectory and of many.

    A period is at the least one affine map a cell, to the state behind it and to the `ROUGH` coefficients
    that prove it clear: (n + ROUGH)(n + 1) multiply-adds, and as many numbers read; one map of the state for
    all of it where nothing is ever touched. A crossing is, in its cell, `TERMS` coefficients before it and
    behind it, the gap as a series, its moments and what they do to the state:
    TERMS (3(n + 1) + TERMS + n)."""
    peak = peak_multiply_adds()
    return tuple(_limit(work, peak, seconds[work.name], together[work.name]) for work in found)


def _limit(work: Work, peak: float, seconds: float, together: float) -> Limit:
    n, cells = work.system.size, work.props.cells
    maps = float(cells * (n + ROUGH) * (n + 1) if work.crossings else (n + 1) ** 2)
    expansions = work.crossings * TERMS * (3 * (n + 1) + TERMS + n)
    table = int(8 * (maps + expansions))
    arithmetic, bandwidth = (maps + expansions) / peak, reading(max(table, SMALLEST))
    return Limit(
        work.name, n, cells, work.crossings, maps, expansions, table, peak, bandwidth, seconds,
        together,
        least=max(arithmetic, table / bandwidth),
        share=arithmetic / seconds,
        share_together=arithmetic / together,
    )  # fmt: skip


@numba.njit(fastmath=True, nogil=True)
def _multiply_adds(a, factor, summand, rounds):
    for _ in range(rounds):
        for i in range(len(a)):
            x = a[i]
            for _step in range(CHAIN):
                x = x * factor + summand
            a[i] = x


@numba.njit(fastmath=True)
def _sum(a, rounds):
    total = 0.0
    for i in range(rounds):
        a[i % len(a)] = i  # so that every round has something new to read
        for k in range(len(a)):
            total += a[k]
    return total


def peak_multiply_adds() -> float:
    """Fused multiply-adds per second of one core, from a loop of nothing else."""
    multiply_adds(1)
    rounds = 4_000
    spent = min(seconds_of(lambda: multiply_adds(rounds)) for _ in range(7))
    return VECTOR * CHAIN * rounds / spent


def multiply_adds(rounds: int) -> None:
    """That loop, without the interpreter's lock."""
    _multiply_adds(np.ones(VECTOR), 0.5, 0.5, rounds)


def reading(size: int) -> float:
    """Bytes per second that one core reads, again and again, from a table of that many bytes."""
    a: Array = np.ones(max(64, size // 8))
    rounds = max(1, int(3e8 // a.nbytes))
    _sum(a, 1)
    spent = min(seconds_of(lambda: _sum(a, rounds)) for _ in range(7))
    return a.nbytes * rounds / spent
