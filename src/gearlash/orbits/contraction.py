"""Whether all motions of a system come together: a test that proves that there is one attractor only.

Between any two motions z and w the difference obeys (z - w)′ = A (z - w), with A somewhere between the
matrices of the regions, as the field is continuous and piecewise linear. If one quadratic form falls along
all of these, every two motions come together, whatever they started from: the motion of the forcing's own
period is then the only one. With one clearance these matrices lie on a segment, and differ by a matrix of
rank one: a common quadratic form exists if and only if both ends are stable and their product has no real
negative eigenvalue.

Source: C. King and M. Nathanson, On the existence of a common quadratic Lyapunov function for a rank one
difference, Linear Algebra and its Applications 419 (2006) 400, doi:10.1016/j.laa.2006.05.010."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from gearlash.system import Clearance, ContactRule, System

Array = NDArray[np.float64]

MARGIN = 1e-9  # relative: an eigenvalue nearer than that to what decides is not on the safe side of it


def contracts(system: System) -> bool:
    """Whether the test proves that all motions of a system come together. False proves nothing.

    It is asked of systems with one clearance, whose damping acts everywhere or is zero: elsewhere the field
    jumps at a boundary."""
    if len(system.clearances) != 1:
        return False
    (clearance,) = system.clearances
    everywhere = clearance.contact is ContactRule.ALWAYS
    if not everywhere and any(clearance.dampings):
        return False
    low, high = _stiffness(clearance)
    damped = np.eye(system.size)
    if everywhere:
        damped = damped + clearance.dampings[0] * np.outer(clearance.g, clearance.h)
    base = damped @ system.matrix
    soft, stiff = (base + k * np.outer(clearance.g, clearance.h) for k in (low, high))
    return _stable(soft) and _stable(stiff) and _no_negative(soft @ stiff)


def _stiffness(clearance: Clearance) -> tuple[float, float]:
    """Bounds of the slope of the contact force over X and the period."""
    sides = [clearance.stiffness_plus, clearance.stiffness_minus]
    swings = [float(np.abs(side[1:]).sum()) for side in sides]
    means = [float(side[0]) for side in sides]
    bounds = [(mean - swing, mean + swing) for mean, swing in zip(means, swings, strict=True)]
    lows, highs = zip(*bounds, strict=True)
    gap = clearance.gap_plus + clearance.gap_minus > 0.0
    return min(*lows, 0.0) if gap else min(lows), max(*highs, 0.0) if gap else max(highs)


def _stable(matrix: Array) -> bool:
    values = np.linalg.eigvals(matrix)
    return bool(values.real.max() < -MARGIN * np.abs(values).max())


def _no_negative(product: Array) -> bool:
    """No real negative eigenvalue, nor a pair that rounding may have moved off the axis."""
    values = np.linalg.eigvals(product)
    near = np.abs(values.imag) <= np.sqrt(MARGIN) * np.abs(values)
    return not bool((near & (values.real <= 0.0)).any())
