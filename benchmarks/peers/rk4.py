"""What everybody writes: fixed-step Runge–Kutta of order four, jitted, that looks at the region in each stage
and never at the instant of a crossing. As fast as that can be had: written out for the pair, with its numbers
in the code; stiffness and forcing are tabulated once for all half steps."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numba
import numpy as np

from .plain import Array, Pair, series

STEPS = 256  # a base period
HOW = (
    f"{STEPS} steps a period, numba, written out for the pair, the region read from X in every stage, "
    "crossings not located"
)


class RungeKutta:
    """One trajectory."""

    crossings = None

    def __init__(self, pair: Pair):
        self.pair, self.march = pair, _compiled(pair)

    def carry(self, z: Array, periods: int) -> Array:
        """The state (n,) after that many base periods from phase zero."""
        state = np.array(z)
        self.march(state, periods)
        return state


def _compiled(pair: Pair) -> Callable:
    """The march of this pair as straight-line code: every number that never changes a literal in it, none
    that is zero in it at all, the state in variables of their own."""
    half = np.arange(2 * STEPS + 1) * np.pi / STEPS  # of the base period
    numbers = pair.numbers
    space: dict[str, Any] = {
        "eta": np.array([series(numbers.stiffness, phase) for phase in half]),
        "push": np.array([series(numbers.forcing, phase) for phase in half]),
    }
    exec(_source(pair), space)
    return numba.njit(error_model="numpy", fastmath=True, nogil=True)(space["march"])


def _source(pair: Pair) -> str:
    n, h = pair.system.size, pair.system.period / STEPS
    lines = ["def march(z, periods):"]
    lines += [f"    z{i} = z[{i}]" for i in range(n)]
    lines += [f"    for step in range({STEPS} * periods):", f"        at = 2 * (step % {STEPS})"]
    inside = [f"y{i} = z{i}" for i in range(n)]
    for stage, (at, ahead) in enumerate((("at", 0.5), ("at + 1", 0.5), ("at + 1", 1.0), ("at + 2", 0.0))):
        inside += _stage(pair, stage, at)
        if ahead:
            inside += [f"y{i} = z{i} + {ahead * h!r} * k{stage}_{i}" for i in range(n)]
    inside += [f"z{i} += {h / 6.0!r} * (k0_{i} + 2.0 * (k1_{i} + k2_{i}) + k3_{i})" for i in range(n)]
    lines += [f"        {line}" for line in inside]
    return "\n".join([*lines, *(f"    z[{i}] = z{i}" for i in range(n))])


def _stage(pair: Pair, stage: int, at: str) -> list[str]:
    """Rates ``k{stage}_i`` of the state ``y_i``."""
    p, n, edge = pair.numbers, pair.system.size, float(pair.edge)
    x, v = f"y{n - 2}", f"y{n - 1}"
    lines = [
        f"beyond = {x} - {edge!r} if {x} > {edge!r} else {x} + {edge!r} if {x} < {-edge!r} else 0.0",
        f"force = eta[{at}] * beyond + {float(p.damping)!r} * {v}",
    ]
    for i in range(n // 2):
        lines.append(f"k{stage}_{2 * i} = y{2 * i + 1}")
        own = enumerate(p.last) if 2 * i + 2 == n else ((2 * i + k, c) for k, c in enumerate(p.own[i]))
        terms = [f"{float(c)!r} * y{k}" for k, c in own if c] + [f"{float(p.g[i])!r} * force"]
        terms += [f"push[{at}]"] if 2 * i + 2 == n else []
        lines.append(f"k{stage}_{2 * i + 1} = {' + '.join(terms)}")
    return lines
