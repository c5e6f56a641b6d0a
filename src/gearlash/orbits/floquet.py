"""Floquet multipliers, small ones included."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Propagators

Complex = NDArray[np.complex128]
PLAIN = 4  # periods up to which the eigenvalues of the plain product keep enough digits
MOST = 800  # size of the lifted matrix up to which it is used


def multipliers(props: Propagators, state: NDArray[np.float64], period: int) -> NDArray[np.complex128]:
    """All multipliers (n,) of a periodic orbit through ``state``, by modulus, descending.

    A long orbit's small multipliers drown in the rounding of the product of its maps. The block-cyclic matrix
    of the single maps has their period-th roots as eigenvalues and is of norm one: see D. Watkins, "Product
    eigenvalue problems", SIAM Rev. 47 (2005), doi:10.1137/S0036144504443110."""
    factors, z = [], state
    for _ in range(period):
        step = flow.variational(props, z, float(props.system.cycles))
        assert step.jacobian is not None
        factors.append(step.jacobian)
        z = step.state
    if period <= PLAIN or period * len(state) > MOST:
        product = np.eye(len(state))
        for factor in factors:
            product = factor @ product
        return ordered(np.linalg.eigvals(product))
    return _lifted(factors)


def ordered(values: NDArray[Any]) -> Complex:
    """By modulus descending, then by imaginary part, so that pairs print in one order."""
    found: Complex = np.asarray(values, dtype=np.complex128)
    return found[np.lexsort((-found.imag, -np.round(np.abs(found), 13)))]


def _lifted(factors: list[NDArray[np.float64]]) -> NDArray[np.complex128]:
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
