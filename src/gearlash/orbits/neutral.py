"""Motion that nothing attracts: neighbours neither come closer nor leave.

A gear that floats in its gap, an oscillator without damping: each such motion is one of a continuum, and the
start decides which. No length of a search changes that, so it is an answer of its own.

Three signs are looked for, each with the maps of the motion itself:

- it repeats, or moves on by the same step, after a few base periods (a drift, or growth in proportion to
  time at a resonance without damping), and the leading multiplier over them has modulus 1;
- it meets no boundary, so that the map over a base period is affine, and its leading multiplier has modulus
  1: the motion is a sum of oscillations that neither die out nor grow, or of such and a drift;
- nothing takes energy out: the mean trace of the field along the motion is zero, so that volumes are kept and
  no attractor exists, and its largest exponent is zero too."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.system import CARRIED

from .floquet import fastest_shrinking, mean_trace, ordered

Array = NDArray[np.float64]
SIMPLE_MULTIPLIER = 1e-9  # distance of a multiplier from modulus 1 that is called none
DOUBLE_MULTIPLIER = 1e-7  # the same of two at +1: a double root moves by the root of rounding
TRACE_PERIODS = 64  # base periods over which the mean trace is taken
KNOWN_CONTRACTION = 1e-2  # of the mean contraction: what is called none must be known to
EQUAL_STEPS = 4  # that a motion must make alike
STEADY_STEP = 1e-8  # of the motion's size: change from step to step that is called none
AFFINE_PERIODS = 1_000  # base periods without a contact event after which the map counts as affine
SLOWEST_GROWTH = 0.05  # powers of e a base period: a tangent that grows in proportion to time stays below
LOSSLESS_RATE = 1e-12  # of a rate per unit of τ: a mean trace below it is rounding


def is_neutral(monodromy: Array) -> bool:
    """Whether the leading multiplier lies on the unit circle, as far as rounding tells."""
    if not np.isfinite(monodromy).all():
        return False
    values = ordered(np.linalg.eigvals(monodromy))
    if abs(abs(values[0]) - 1.0) <= SIMPLE_MULTIPLIER:
        return True
    pair = values[:2]  # a double root's product has its digits
    return len(pair) == 2 and bool(
        (np.abs(pair - 1.0) <= DOUBLE_MULTIPLIER).all() and abs(np.prod(pair) - 1.0) <= SIMPLE_MULTIPLIER
    )


def repeated(props: Propagators, states: Array, longest: int, drifts: bool) -> str:
    """Whether a motion (states at phase zero, the last ones of it) repeats after up to ``longest`` base
    periods or, with ``drifts``, moves on by the same step, while its neighbours keep their distance: what to
    say of it, or nothing."""
    scale = max(1.0, float(np.abs(states[-1]).max()))
    size = max(float(np.ptp(states, axis=0).max()), 1e-3 * scale)
    for period in range(1, min(longest, (len(states) - 1) // EQUAL_STEPS) + 1):
        steps = np.diff(states[-1::-period], axis=0)
        if np.abs(np.diff(steps, axis=0)).max() > STEADY_STEP * size:
            continue
        step = float(np.abs(steps[0]).max())
        moves = step > STEADY_STEP * size
        if (moves and not drifts) or not _keeps_distance(props, states[-1], period):
            return ""
        if moves:
            seen = period * len(steps)
            return f"which moved on by the same step, {step:.1e}, in {_periods(period)} over the last {seen}"
        return f"which repeats after {_periods(period)}"
    return ""


def affine(props: Propagators, state: Array) -> str:
    """Whether the motion from ``state`` meets no boundary and its neighbours keep their distance: what to say
    of it, or nothing."""
    ahead = flow.march(props, state, AFFINE_PERIODS)
    if ahead.status not in CARRIED or ahead.contacts.any() or not _keeps_distance(props, state, 1):
        return ""
    return f"which meets no boundary in {AFFINE_PERIODS} base periods, where nothing takes up a disturbance"


def lossless(props: Propagators, state: Array) -> bool:
    """Whether no volume shrinks or grows along the motion."""
    return abs(mean_trace(props, state, TRACE_PERIODS)) <= LOSSLESS_RATE


def _keeps_distance(props: Propagators, state: Array, period: int) -> bool:
    """Whether neighbours do, and this takes long enough to tell it from the mean contraction of the field."""
    contraction = fastest_shrinking(props) / props.system.size
    lasted = period * props.system.period
    if contraction > 0.0 and KNOWN_CONTRACTION * contraction * lasted < DOUBLE_MULTIPLIER:
        return False
    end = flow.variational(props, state, float(period * props.system.cycles))
    return end.jacobian is not None and is_neutral(end.jacobian)


def _periods(count: int) -> str:
    return "one base period" if count == 1 else f"{count} base periods"
