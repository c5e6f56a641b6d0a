"""Lyapunov exponents of a motion that is not periodic: QR average with its error bar.

Source: G. Benettin et al., Meccanica 15 (1980) 9-30, doi:10.1007/BF02128236. With the rule `always` the field
is continuous and the tangent flow needs no jump at contacts; with the others it jumps by I ± ζ g hᵀ, which
changes no volume, because h·g = 0. So the sum of all exponents is the mean trace of the field under every
rule."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash import flow
from gearlash.flow import Propagators, propagators_of
from gearlash.flow.march import LONGEST_STRETCH, start_state
from gearlash.system import CARRIED, Record, Status, System, given

from .floquet import cut, mean_trace
from .transient import GROWTH_ROUNDING

BATCHES = 20
STUDENT = 2.093  # 95 % two-sided, 19 degrees of freedom
EPSILON = float(np.finfo(np.float64).eps)
TRACE_AGREES = 1e-6  # of the exponents' size: a larger defect of their sum is no rounding


@dataclass(frozen=True, eq=False, repr=False)
class Exponents(Record):
    """Lyapunov exponents of a motion, with their error bars.

    Attributes
    ----------
    values : ndarray of shape (k,)
        Exponents per unit of τ, descending.
    errors : ndarray of shape (k,)
        Half-widths of their 95 % intervals from batch means; at least what rounding may do.
    periods : int
        Base periods that they were averaged over.
    trace_defect : float
        For k = n the sum of the exponents minus the mean trace of the field over the same motion, which is
        zero in theory; NaN otherwise.
    final_state : ndarray of shape (n,)
        The state at the end.
    status : Status
        Uncertain: a contact lay within rounding of touching somewhere on the way. Inexact: the defect is more
        than rounding, or an exponent is no number; the values are not to be relied on.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> found = gl.lyapunov(family.system({"omega": 0.8}), family.start(), 100)
    >>> found.values.round(3).tolist(), abs(found.trace_defect) < 1e-12
    ([-0.05, -0.05], True)
    """

    values: NDArray[np.float64]
    errors: NDArray[np.float64]
    periods: int
    trace_defect: float
    final_state: NDArray[np.float64]
    status: Status


def lyapunov(
    system: System | Propagators,
    start: ArrayLike,
    periods: int,
    *,
    count: int | None = None,
    settle: int = 20,
) -> Exponents:
    """The largest Lyapunov exponents of a motion, by QR averages with error bars.

    The frame is made orthogonal once in a base period, or as much more often as the tangent flow needs it:
    where that spreads lengths by more than e^10 in between, small directions would be lost to rounding. At
    contacts the tangent flow is the exact one, with its jumps.

    Parameters
    ----------
    system : System or Propagators
    start : array_like of shape (n,)
        State at phase zero, on the motion.
    periods : int
        Base periods to average over, 1 or more: twenty batches of equal length.
    count : int, optional
        How many exponents, 1 to n; all without.
    settle : int
        Base periods before, in which the frame turns into its directions; 0 or more.

    Returns
    -------
    Exponents

    Raises
    ------
    GearlashError
        For arguments that do not fit.

    References
    ----------
    G. Benettin et al., Meccanica 15 (1980) 9-30, doi:10.1007/BF02128236.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("shaw-holmes").family()
    >>> values = {"omega": 0.88}
    >>> found = gl.lyapunov(family.system(values), family.start(values), 400, count=1, settle=200)
    >>> bool(found.values[0] > found.errors[0])  # chaos
    True
    """
    props = propagators_of(system)
    z = start_state(props, start)
    n = len(z)
    count = n if count is None else given.whole("count", count, 1, n)
    periods, settle = (
        given.whole("periods", periods, 1, LONGEST_STRETCH),
        given.whole("settle", settle, 0, LONGEST_STRETCH),
    )
    parts = cut(props, z)
    frame = (
        np.eye(n)[:count]
        if count == n
        else np.linalg.qr(np.ones((n, count)) + np.eye(n)[:, :count])[0].T.copy()
    )
    status, _ = flow.orthonormal_growth(props, z, frame, settle, parts)
    each = max(1, periods // BATCHES)
    sums, traces = [], []
    for _ in range(BATCHES):
        if status not in CARRIED:
            break
        if count == n:
            traces.append(mean_trace(props, z, each))
        later, batch = flow.orthonormal_growth(props, z, frame, each, parts)
        status = status if later.ok else later  # a doubt stays
        sums.append(batch / (each * props.system.period))
    table = np.array(sums).reshape(-1, count)
    values = table.mean(axis=0) if len(table) else np.full(count, np.nan)
    errors = _errors(table) + GROWTH_ROUNDING / props.system.period
    order = np.argsort(-values, kind="stable")
    defect = float(values.sum() - np.mean(traces)) if count == n and traces else np.nan
    if traces:  # what the sum lacks, each of them may lack; and none has more digits than a float
        errors = errors + abs(defect) + 4.0 * EPSILON * np.abs(values)
    if status in CARRIED and not _agree(values, defect, count == n):
        status = Status.INEXACT
    return Exponents(values[order], errors[order], each * BATCHES, defect, z, status)


def _errors(table: NDArray[np.float64]) -> NDArray[np.float64]:
    """Half-widths from batches (batches, k)."""
    if len(table) < 2:
        return np.full(table.shape[1], np.inf)
    return STUDENT * table.std(axis=0, ddof=1) / np.sqrt(len(table))


def _agree(values: NDArray[np.float64], defect: float, whole: bool) -> bool:
    """Whether all are numbers, and their sum is the trace where that is known."""
    if not np.isfinite(values).all():
        return False
    return not whole or abs(defect) <= TRACE_AGREES * max(float(np.abs(values).max()), 1e-9)
