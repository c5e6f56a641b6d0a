"""A change of the motion between two neighbouring points of a sweep, and what each kind of it is called."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

from gearlash.branches.continuation import SpecialKind, SpecialPoint
from gearlash.system import Label, MotionKind, Record

GRAZING, DOUBLING, FOLD = str(SpecialKind.GRAZING), str(SpecialKind.DOUBLING), str(SpecialKind.FOLD)
JUMP, APERIODIC = "jump", "onset of aperiodic motion"
UNPROVED = "no periodic motion proved beyond"
"""One side is neither a proved orbit nor aperiodic: unresolved, neutral or not computed."""
UNDECIDED = "not decided"
"""The orbits of two neighbouring points could not be followed to each other, and no motion between them was
found: they may be one branch, or there may be a jump."""


class Sampled(Protocol):
    """What is needed of a point of a sweep, to be compared with its neighbour."""

    @property
    def value(self) -> float:
        """Of the parameter, dimensionless."""
        ...

    @property
    def label(self) -> Label | None:
        """Of the motion there, if any was found."""
        ...

    @property
    def period(self) -> int:
        """In mesh cycles; 0 where no periodic motion was proved."""
        ...

    @property
    def state(self) -> NDArray[np.float64]:
        """The state (n,) at phase zero."""
        ...


SAMPLED = "value", "label", "period", "state"


@dataclass(frozen=True, eq=False, repr=False)
class Transition(Record):
    """A change of the motion between two values of a parameter.

    A ``change of basin`` is no end of a motion: the orbit of one side exists at the other too, where the
    sweep found another one, so all that is known is that it changed over between the two points.

    Parameters
    ----------
    name : str
        Short name of the parameter.
    kind : str
        Grazing, doubling, fold, Neimark-Sacker, branch point, jump, change of basin, onset of aperiodic
        motion, no periodic motion proved beyond, or not decided.
    lower, upper : float
        Values between which it happens, dimensionless.
    label_below, label_above : Signature or MotionKind, optional
        Of the motion on both sides: one label twice, where a fold or a jump leads from one orbit to another
        of the same label.
    point : SpecialPoint, optional
        What was solved for; None where only the interval is known.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> up = gl.sweep(case, gl.Axis.even("omega", 0.8, 0.825, 3), direction="up")
    >>> (change,) = gl.transitions(case, "omega", up.points)
    >>> change.kind, str(change.label_below)
    ('grazing', '1-0-0')
    """

    _printed: ClassVar = ("name", "kind", "value", "label_below", "label_above")

    name: str
    kind: str
    lower: float
    upper: float
    label_below: Label | None
    label_above: Label | None
    point: SpecialPoint | None

    @property
    def value(self) -> float:
        """That of the point, or the middle of the interval."""
        return self.point.value if self.point is not None else 0.5 * (self.lower + self.upper)


def unlocated(one: Sampled, two: Sampled) -> str:
    """What to call a change between two motions of a sweep that no point was solved for."""
    if one.period and two.period:
        return JUMP
    other = two if one.period else one
    return APERIODIC if (one.period or two.period) and other.label == MotionKind.APERIODIC else UNPROVED


def kind_of(point: SpecialPoint) -> str:
    """What a point is called as a change of the motion: where an orbit joins that of half its period, this
    one doubles; where it joins a symmetric one, that is a branch point of this one."""
    joins = {SpecialKind.JOINS: SpecialKind.DOUBLING, SpecialKind.SYMMETRIC: SpecialKind.BRANCH_POINT}
    return str(joins.get(point.kind, point.kind))
