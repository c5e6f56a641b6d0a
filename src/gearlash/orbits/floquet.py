"""Floquet multipliers, small ones included."""

from __future__ import annotations

from math import ceil
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.flow.march import LONGEST, start_state
from gearlash.system import given

Complex = NDArray[np.complex128]
Matrix = NDArray[np.float64]
DEPTH = 5.0  # by how many powers of e one factor may shrink volumes: its eigenvalues keep their digits
PLAIN = 2 * DEPTH  # the same for the plain product of all factors
MOST = 800  # size of the lifted matrix up to which it is used


def multipliers(props: Propagators, state: NDArray[np.float64], period: int) -> NDArray[np.complex128]:
    """All multipliers (n,) of a periodic orbit through ``state``, by modulus, descending.

    A long or strongly damped orbit's small multipliers drown in the rounding of the product of its maps. The
    block-cyclic matrix of single maps has their roots as eigenvalues and is of norm one: see D. Watkins,
    "Product eigenvalue problems", SIAM Rev. 47 (2005), doi:10.1137/S0036144504443110."""
    state, period = start_state(props, state), given.whole("period", period, 1, LONGEST)
    shrinking = fastest_shrinking(props) * props.system.period
    parts = max(1, ceil(shrinking / DEPTH))
    factors = _factors(props, state, period, parts)
    if period * shrinking <= PLAIN:
        return ordered(np.linalg.eigvals(_product(factors)))
    return _lifted(_merged(factors, MOST // len(state)))


def fastest_shrinking(props: Propagators) -> float:
    """A bound on |trace| of the field in any region; where contact damping comes and goes, with all of it."""
    if props.trace is not None:
        return abs(props.trace)
    matrix = props.system.matrix
    return abs(float(np.trace(matrix))) + sum(
        max(map(abs, c.dampings)) * abs(float(c.h @ matrix @ c.g)) for c in props.system.clearances
    )


def ordered(values: NDArray[Any]) -> Complex:
    """By modulus descending, then by imaginary part, so that pairs print in one order."""
    found: Complex = np.asarray(values, dtype=np.complex128)
    with np.errstate(divide="ignore"):
        size = np.round(np.log(np.abs(found)), 12)
    return found[np.lexsort((-found.imag, -size))]


def _factors(props: Propagators, state: NDArray[np.float64], period: int, parts: int) -> list[Matrix]:
    """Jacobians of the flow along the orbit, ``parts`` to a base period."""
    factors, z, cycles = [], state, float(props.system.cycles)
    for part in range(period * parts):
        step = flow.variational(props, z, cycles / parts, part % parts * cycles / parts)
        assert step.jacobian is not None
        factors.append(step.jacobian)
        z = step.state
    return factors


def _product(factors: list[Matrix]) -> Matrix:
    product = np.eye(len(factors[0]))
    for factor in factors:
        product = factor @ product
    return product


def _merged(factors: list[Matrix], most: int) -> list[Matrix]:
    """At most ``most`` factors with the same product."""
    each = ceil(len(factors) / most)
    return [_product(factors[i : i + each]) for i in range(0, len(factors), each)]


def _lifted(factors: list[Matrix]) -> NDArray[np.complex128]:
    n, period = len(factors[0]), len(factors)
    cyclic = np.zeros((n * period, n * period))
    for k, factor in enumerate(factors):
        row = (k + 1) % period
        cyclic[row * n : (row + 1) * n, k * n : (k + 1) * n] = factor
    roots = np.linalg.eigvals(cyclic)
    powers = ordered(np.exp(period * np.log(roots.astype(np.complex128) + 0.0)))
    return _grouped(powers, n, period)


def _grouped(powers: NDArray[np.complex128], n: int, period: int) -> NDArray[np.complex128]:
    """Every multiplier occurs `period` times: takes the nearest `period` values together, and their mean."""
    left, found = list(powers), []
    for _ in range(n):
        first = left[0]
        left.sort(key=lambda value: abs(value - first))
        found.append(np.mean(left[:period]))
        left = sorted(left[period:], key=lambda value: (-abs(value), -value.imag))
    values: Complex = np.array(found, dtype=np.complex128)
    real = np.abs(values.imag) < 1e-12 * np.abs(values)
    values[real] = values[real].real
    return ordered(values)
