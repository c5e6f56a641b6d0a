"""Whether two points show the same attractor."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from gearlash.system import GearlashError, MotionKind, arguments

from .point import Point
from .sweep import Sweep

CLOSE = (
    1e-6  # of the size of the motion: far above the error of a proved orbit, far below two orbits' distance
)


@arguments
def same_motion(one: Point, other: Point) -> bool:
    """Whether two points show the same attractor, as far as labels and σ_t tell.

    Orbits are compared as sets, so that a shift by base periods is no difference. Two aperiodic motions count
    as one. A point without a motion differs from no other.

    Parameters
    ----------
    one, other : Point

    Returns
    -------
    bool

    Raises
    ------
    GearlashError
        For what is no point.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> cold, other = (gl.point(case, {"omega": 0.8}, start=start) for start in (None, [0.0, -1.0]))
    >>> str(cold.label), str(other.label), gl.same_motion(cold, other)
    ('1-0-0', '1-1-0', False)
    """
    return _same(one, other)


def _same(one: Point, other: Point) -> bool:
    """The same without a look at the arguments, which for a hundred thousand points takes seconds."""
    if not (one.computed and other.computed):
        return True
    if one.label != other.label:
        return False
    if not one.periodic:
        return True
    size = max(one.maximum - one.minimum, other.maximum - other.minimum, 1e-3)
    a, b = one.strobes, other.strobes
    if len(a) == len(b) == 1:  # most are so, and numpy takes its time for one number
        return abs(float(a[0]) - float(b[0])) <= CLOSE * size
    return len(a) == len(b) and bool(np.abs(np.sort(a) - np.sort(b)).max(initial=0.0) <= CLOSE * size)


def _settled(point: Point) -> bool:
    return point.periodic or point.label is MotionKind.APERIODIC


@arguments
def coexisting(sweeps: Sequence[Sweep]) -> NDArray[np.bool_]:
    """Where sweeps of one axis found different attractors.

    What is unresolved may be on its way to any of them, and neutral motion is no attractor: neither counts.

    Parameters
    ----------
    sweeps : sequence of Sweep
        Of one axis, such as one up and one down.

    Returns
    -------
    ndarray of bool, shape (m,)
        For every value of the axis.

    Raises
    ------
    GearlashError
        For no sweep, and for sweeps with different numbers of points.

    Examples
    --------
    >>> import gearlash as gl
    >>> ways = gl.sweeps(gl.load_case("kahraman-singh"), gl.Axis.even("omega", 0.7, 0.9, 3), ["up", "down"])
    >>> gl.coexisting(ways).tolist()
    [False, True, False]
    """
    if len({len(sweep.points) for sweep in sweeps}) > 1:
        raise GearlashError("sweeps of one axis: these have different numbers of points")
    settled = np.array([[_settled(point) for point in sweep.points] for sweep in sweeps], dtype=bool)
    found = np.zeros(settled.shape[1], dtype=bool)
    for at in np.flatnonzero(settled.sum(axis=0) > 1).tolist():
        row = [sweep.points[at] for sweep, here in zip(sweeps, settled[:, at], strict=True) if here]
        found[at] = any(not _same(a, b) for i, a in enumerate(row) for b in row[:i])
    return found
