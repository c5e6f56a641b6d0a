"""The one arithmetic primitive of the engine: out ← Σ_k x[k] · column k, eight rows at a time.

Tables lie in one flat array, columns padded to whole blocks of eight rows, so that a product is a loop over
columns with one, two or three vector accumulators. Kernels get it written in the compiler's own vector
instructions (`_vector_code`): its bytes then depend neither on addresses nor on what a vectoriser makes of a
loop. Here it says what it means, and runs where kernels are plain Python."""

from __future__ import annotations

from typing import Any

from gearlash._kernel.jit import written_out

from ._blocks import LANES, MASKED

_written_out = written_out(f"{__package__}._vector_code")


@_written_out
def linear(
    table: Any, at: int, stride: int, rows: int, count: int, x: Any, first: int, out: Any, to: int
) -> None:
    """out[to:to+rows] ← Σ_k x[first+k] · table[at + k·stride:][:rows], rows a multiple of eight."""
    factors = [float(x[first + k]) for k in range(count)]
    for i in range(rows):
        value = 0.0
        for k in range(count):
            value += table[at + k * stride + i] * factors[k]
        out[to + i] = value


@_written_out
def peak(values: Any, at: int, count: int) -> float:
    """Largest |values[at + i]|, i < count (a multiple of eight)."""
    return float(max(abs(values[at + i]) for i in range(count)))


@_written_out
def move(source: Any, at: int, target: Any, to: int, count: int) -> None:
    """target[to + i] ← source[at + i], i < count (a multiple of eight)."""
    target[to : to + count] = source[at : at + count]


@_written_out
def times(factors: Any, at: int, values: Any, to: int, count: int) -> None:
    """values[to + i] ← values[to + i] · factors[at + i]."""
    for i in range(count):
        values[to + i] *= factors[at + i]


@_written_out
def multiple(factor: float, source: Any, at: int, target: Any, to: int, count: int) -> None:
    """target[to + i] ← factor · source[at + i]."""
    for i in range(count):
        target[to + i] = factor * source[at + i]


@_written_out
def add(factor: float, source: Any, at: int, target: Any, to: int, count: int) -> None:
    """target[to + i] ← target[to + i] + factor · source[at + i], rounded once."""
    for i in range(count):
        target[to + i] += factor * source[at + i]


@_written_out
def least(values: Any, at: int) -> float:
    """Least of the `MASKED` values from a place on."""
    return float(min(values[at : at + MASKED]))


@_written_out
def greatest(values: Any, at: int) -> float:
    """Largest of the `MASKED` values from a place on."""
    return float(max(values[at : at + MASKED]))


@_written_out
def weigh(weights: Any, at: int, count: int, x: Any, first: int) -> float:
    """Σ weights[at + i] |x[first + i]|, i < count (a multiple of eight)."""
    return float(sum(weights[at + i] * abs(x[first + i]) for i in range(count)))


@_written_out
def powers(s: float, out: Any, to: int) -> None:
    """out[to:to+MASKED] ← 1, s, s², …: in kernels a block at a time, not one after the other."""
    power = 1.0
    for k in range(MASKED):
        out[to + k] = power
        power *= s


@_written_out
def powered(s: float, values: Any, at: int, less: float, out: Any, powers_to: int, to: int) -> None:
    """out[powers_to:] ← `powers` of s; out[to:] ← the `MASKED` values, ``less`` so much in the first, times
    those."""
    powers(s, out, powers_to)
    for k in range(MASKED):
        out[to + k] = (values[at + k] - (less if k == 0 else 0.0)) * out[powers_to + k]


@_written_out
def lead_back(
    factor: float, scale: float, change: Any, centres: Any, before: int, after: int, u: Any, count: int
) -> None:
    """u[i] ← u[i] + factor · (scale · change[i]) + centres[before + i] - centres[after + i], i < count."""
    for i in range(count):
        u[i] = u[i] + factor * (scale * change[i]) + centres[before + i] - centres[after + i]


@_written_out
def over(values: Any, at: int, limit: float) -> int:
    """Mask of the values from a place on that are above the limit: bit i for value i."""
    return sum(1 << i for i in range(MASKED) if values[at + i] > limit)


@_written_out
def under(values: Any, at: int, limit: float) -> int:
    """Mask of the values from a place on that are below the limit."""
    return sum(1 << i for i in range(MASKED) if values[at + i] < limit)


@_written_out
def all_over(values: Any, at: int, limit: float) -> bool:
    """Whether all values of the block from a place on are above the limit."""
    return bool(min(values[at : at + LANES]) > limit)


@_written_out
def all_under(values: Any, at: int, limit: float) -> bool:
    """Whether all are below."""
    return bool(max(values[at : at + LANES]) < limit)


@_written_out
def ones_in(mask: int) -> int:
    """Number of ones of a mask."""
    return int(mask).bit_count()
