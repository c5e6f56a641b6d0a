"""Floquet multipliers, small ones included."""

from __future__ import annotations

from math import ceil, inf

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash import flow
from gearlash.flow import Propagators, propagators_of
from gearlash.flow.march import LONGEST_STRETCH, start_state
from gearlash.system import CARRIED, ContactRule, GearlashError, System, given

from .subspaces import by_subspaces, ordered

Complex = NDArray[np.complex128]
Matrix = NDArray[np.float64]
FACTOR_CONTRACTION = 5.0  # powers of e by which one factor may shrink volumes and keep its digits
PRODUCT_CONTRACTION = 2 * FACTOR_CONTRACTION  # the same for the product of all factors
LARGEST_LIFTED = 800  # rows of the lifted matrix up to which it is used
TRACE_AGREES = 1e-9  # relative difference allowed between the sum of all logarithms and the trace
LARGEST_SPREAD = 10.0  # powers of e between the largest and the least stretch of a part of a period
LARGEST_STRETCH = 200.0  # powers of e by which lengths may grow or shrink in it


def multipliers(system: System | Propagators, start: ArrayLike, period: int) -> NDArray[np.complex128]:
    """All Floquet multipliers of a periodic orbit, the small ones to full relative accuracy.

    An `Orbit` has its own in ``multipliers``.

    Parameters
    ----------
    system : System or Propagators
    start : array_like of shape (n,)
        State of the orbit at phase zero.
    period : int
        Base periods after which it closes; 1 or more.

    Returns
    -------
    ndarray of complex, shape (n,)
        By modulus, descending. One smaller than the least float is zero.

    Raises
    ------
    GearlashError
        For arguments that do not fit.

    References
    ----------
    D. Watkins, "Product eigenvalue problems", SIAM Rev. 47 (2005), doi:10.1137/S0036144504443110.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> orbit = gl.attractor(family.system({"omega": 0.8}), family.start())
    >>> abs(gl.multipliers(orbit.propagators, orbit.state, 1)).round(4).tolist()
    [0.6752, 0.6752]
    """
    props = propagators_of(system)
    return spectrum(props, start_state(props, start), period)[0]


def spectrum(
    props: Propagators, state: NDArray[np.float64], period: int
) -> tuple[NDArray[np.complex128], NDArray[np.float64]]:
    """All multipliers (n,) of a periodic orbit through ``state``, by modulus, descending, and the logarithms
    (n,) of their moduli.

    A long or strongly damped orbit's small multipliers drown in the rounding of the product of its maps. The
    block-cyclic matrix of single maps has their roots as eigenvalues and is of norm one: see D. Watkins,
    "Product eigenvalue problems", SIAM Rev. 47 (2005), doi:10.1137/S0036144504443110. Where the sum of the
    logarithms is not the trace, digits were lost all the same; then, and where there are too many maps, each
    group of multipliers of like size is computed in its own subspace (`subspaces`)."""
    state, period = start_state(props, state), given.whole("period", period, 1, LONGEST_STRETCH)
    shrinking = fastest_shrinking(props) * props.system.period
    parts = max(1, ceil(shrinking / FACTOR_CONTRACTION))
    factors = _factors(props, state, period, parts)
    if period * shrinking <= PRODUCT_CONTRACTION:
        found = ordered(np.linalg.eigvals(_product(factors)))
    elif len(factors) * len(state) <= LARGEST_LIFTED:
        found = _lifted(factors)
    else:
        return by_subspaces(_factors(props, state, period, cut(props, state)))
    with np.errstate(divide="ignore"):
        logarithms = np.log(np.abs(found))
    trace = mean_trace(props, state, period) * period * props.system.period
    if abs(float(logarithms.sum()) - trace) <= TRACE_AGREES * max(1.0, abs(trace)):  # not so for NaN and -inf
        return found, logarithms
    return by_subspaces(_factors(props, state, period, cut(props, state)))


def cut(props: Propagators, state: NDArray[np.float64]) -> int:
    """The number of equal parts of a base period (a power of two) in each of which the tangent flow from
    ``state`` (n,) spreads lengths by less than e^`LARGEST_SPREAD`."""
    parts, cycles = 1, float(props.system.cycles)
    while parts < props.cells:
        z, part, tame = state, 0, True
        while tame and part < parts:
            step = flow.variational(props, z, cycles / parts, part * cycles / parts)
            if step.status not in CARRIED:
                return parts  # no cut helps where the motion cannot be carried on
            z, part, tame = step.state, part + 1, _tame(step.jacobian)
        if tame:
            break
        parts *= 2
    return parts


def _tame(jacobian: NDArray[np.float64] | None) -> bool:
    assert jacobian is not None
    if not np.isfinite(jacobian).all():
        return False
    stretches = np.linalg.svd(jacobian, compute_uv=False)
    if stretches[-1] < np.exp(-LARGEST_STRETCH):
        return False
    logarithms = np.log(stretches)
    return bool(logarithms[0] < LARGEST_STRETCH and logarithms[0] - logarithms[-1] < LARGEST_SPREAD)


def mean_trace(props: Propagators, z: NDArray[np.float64], periods: int) -> float:
    """Mean over time of the trace of the field along the motion from z: contact damping counts while it
    acts."""
    if props.trace is not None:
        return props.trace
    system = props.system
    motion = flow.trace(props, z, float(periods * system.cycles))
    share, mean = motion.lengths / motion.lengths.sum(), float(np.trace(system.matrix))
    for j, c in enumerate(system.clearances):
        acting = np.array([c.dampings[0], 0.0, c.dampings[1]])[motion.regions_of(j)]
        if c.contact is ContactRule.ALWAYS:
            acting = np.full(len(share), c.damping)
        mean += float(share @ acting) * float(c.h @ system.matrix @ c.g)
    return mean


def rate(multiplier: complex, duration: float) -> float:
    """ln|μ| per unit of τ: -inf of a multiplier that is zero within double precision."""
    return float(np.log(abs(multiplier)) / duration) if multiplier != 0.0 else -inf


def fastest_shrinking(props: Propagators) -> float:
    """A bound on |trace| of the field in any region; where contact damping comes and goes, with all of it."""
    if props.trace is not None:
        return abs(props.trace)
    matrix = props.system.matrix
    return abs(float(np.trace(matrix))) + sum(
        max(map(abs, c.dampings)) * abs(float(c.h @ matrix @ c.g)) for c in props.system.clearances
    )


def _factors(props: Propagators, state: NDArray[np.float64], period: int, parts: int) -> list[Matrix]:
    """Jacobians of the flow along the orbit, ``parts`` to a base period."""
    factors, z, cycles = [], state, float(props.system.cycles)
    for part in range(period * parts):
        step = flow.variational(props, z, cycles / parts, part % parts * cycles / parts)
        assert step.jacobian is not None
        if not np.isfinite(step.jacobian).all():
            raise GearlashError("the motion runs beyond every number: it has no multipliers")
        factors.append(step.jacobian)
        z = step.state
    return factors


def _product(factors: list[Matrix]) -> Matrix:
    product = np.eye(len(factors[0]))
    for factor in factors:
        product = factor @ product
    return product


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
