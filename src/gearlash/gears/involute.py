"""The involute function and its inverse.

inv α = tan α − α (ISO 21771-1, involute function); the inverse by Newton's method for t = tan α, where t −
arctan t is convex, so that the iteration cannot run away.
"""

from __future__ import annotations

from math import atan, inf, pi, tan

from gearlash.system import GearlashError


def inv(angle: float) -> float:
    """Involute function, inv α = tan α − α.

    Parameters
    ----------
    angle : float
        α, rad; above −π/2 and below π/2.

    Returns
    -------
    float
        rad.

    References
    ----------
    ISO 21771-1, involute function.

    Examples
    --------
    >>> from math import radians
    >>> from gearlash.gears.involute import inv
    >>> round(inv(radians(20)), 6)
    0.014904
    """
    if abs(angle) > 0.02:
        return tan(angle) - angle
    square = angle * angle  # the difference of two nearly equal numbers: by its series
    return angle * square * (1 / 3 + square * (2 / 15 + square * (17 / 315 + square * 62 / 2835)))


def inverse_involute(value: float) -> float:
    """The angle whose involute function is this value.

    Parameters
    ----------
    value : float
        inv α, rad; at least 0.

    Returns
    -------
    float
        α, rad; from 0, below π/2.

    Raises
    ------
    GearlashError
        For a value below 0: no point of an involute has it.

    Examples
    --------
    >>> from math import degrees
    >>> from gearlash.gears.involute import inverse_involute
    >>> round(degrees(inverse_involute(0.0343165)), 3)
    26.089
    """
    if not 0.0 <= value < inf:
        raise GearlashError(f"inv α = {value:g}: the involute function of a point on a flank is 0 or more")
    root = (3.0 * value) ** (1.0 / 3.0)  # of the leading term, t³/3
    tangent = min(root + root**3 / 5.0, value + pi / 2)
    for _ in range(60):
        if tangent == 0.0:
            break
        square = tangent * tangent
        step = (inv(atan(tangent)) - value) * (1.0 + square) / square
        tangent -= step
        if abs(step) <= 4e-16 * tangent:
            break
    return atan(tangent)
