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
from gearlash.flow import Propagators
from gearlash.flow.march import LONGEST, start_state
from gearlash.system import ContactRule, Record, Status, given

BATCHES = 20
STUDENT = 2.093  # 95 % two-sided, 19 degrees of freedom


@dataclass(frozen=True, eq=False, repr=False)
class Exponents(Record):
    """Exponents (k,) per unit of τ, descending, with the half-width (k,) of their 95 % intervals from batch
    means, over ``periods`` base periods, and the state (n,) at the end. For k = n, `trace_defect` is the sum
    of the exponents minus the mean trace of the field over the same motion (exactly zero in theory); it is
    NaN otherwise. Status `uncertain`: a contact lay within rounding of touching somewhere on the way."""

    values: NDArray[np.float64]
    errors: NDArray[np.float64]
    periods: int
    trace_defect: float
    final_state: NDArray[np.float64]
    status: Status


def lyapunov(
    props: Propagators, state: ArrayLike, periods: int, count: int | None = None, settle: int = 20
) -> Exponents:
    """The ``count`` largest exponents (default all) from ``periods`` base periods after ``settle`` for the
    frame."""
    z = start_state(props, state)
    n = len(z)
    count = n if count is None else given.whole("count", count, 1, n)
    periods, settle = given.whole("periods", periods, 1, LONGEST), given.whole("settle", settle, 0, LONGEST)
    frame = (
        np.eye(n)[:count]
        if count == n
        else np.linalg.qr(np.ones((n, count)) + np.eye(n)[:, :count])[0].T.copy()
    )
    status, _ = flow.orthonormal_growth(props, z, frame, settle)
    each = max(1, periods // BATCHES)
    sums, traces = [], []
    for _ in range(BATCHES):
        if status not in (Status.OK, Status.UNCERTAIN):
            break
        if count == n:
            traces.append(_mean_trace(props, z, each))
        later, batch = flow.orthonormal_growth(props, z, frame, each)
        status = status if later.ok else later  # a doubt stays
        sums.append(batch / (each * props.system.period))
    table = np.array(sums)
    values = table.mean(axis=0)
    errors = (
        STUDENT * table.std(axis=0, ddof=1) / np.sqrt(len(table))
        if len(table) > 1
        else np.full(count, np.inf)
    )
    order = np.argsort(-values, kind="stable")
    defect = float(values.sum() - np.mean(traces)) if count == n else np.nan
    return Exponents(values[order], errors[order], each * BATCHES, defect, z, status)


def _mean_trace(props: Propagators, z: NDArray[np.float64], periods: int) -> float:
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
