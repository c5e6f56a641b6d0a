"""What a curve is told by: its points, those where two things happen at once, and why it ends."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from gearlash.branches.continuation.extrema import Extremum
from gearlash.branches.continuation.points import SpecialKind
from gearlash.system import Record, Signature, Status
from gearlash.system.status import Named

Array = NDArray[np.float64]


class CodimTwoKind(Named):
    """What two things happen at once."""

    GRAZING_DOUBLING = "grazing with a multiplier -1"
    """A doubling curve meets a grazing curve."""
    GRAZING_FOLD = "grazing with a multiplier 1"
    """A fold curve meets the grazing curve of an orbit with impacts."""
    GRAZING_TORUS = "grazing with a pair of multipliers on the unit circle"
    """A Neimark-Sacker curve meets a grazing curve."""
    CORNER = "grazing with a multiplier 1 of an orbit without impacts"
    """Its system is linear: the forcing is orthogonal there, and two grazing curves cross."""
    TWO_GRAZINGS = "two extrema graze"
    """Of one boundary, of both, or of two clearances."""
    DEGENERATE = "degenerate grazing: X″ = 0"
    """An extremum merges with a crossing: the grazing curve has a cusp."""
    FLAT = "flat degenerate grazing: X″ = X‴ = 0"
    """The extremum is flat to third order."""
    NO_ROOT = "c = 0: the local law has no root"
    """The touch does not move the leading multiplier to first order."""
    CUSP = "cusp"
    """Two folds meet."""
    GENERALISED_DOUBLING = "generalised doubling"
    """The doubled orbit changes sides."""
    FOLD_FLIP = "fold-flip"
    """Multipliers 1 and -1 at once."""
    ONE_ONE = "1:1 resonance"
    """A double multiplier 1."""
    ONE_TWO = "1:2 resonance"
    """A double multiplier -1."""
    ONE_THREE = "1:3 resonance"
    """The pair turns by a third."""
    ONE_FOUR = "1:4 resonance"
    """The pair turns by a quarter."""


OF_GRAZING = {
    SpecialKind.FOLD: CodimTwoKind.GRAZING_FOLD,
    SpecialKind.DOUBLING: CodimTwoKind.GRAZING_DOUBLING,
    SpecialKind.TORUS: CodimTwoKind.GRAZING_TORUS,
}
ALIKE = 1e-9  # of multipliers, and of distances in units of the states: what is less is rounding


class CurveEndKind(Named):
    """Why a curve is not followed farther."""

    LIMIT = "limit of a parameter"
    CLOSED = "closed loop: the curve comes back to where it began"
    TOUCH = "touch beyond which no continuation was found"
    HALF_PERIOD = "joins the curve of the orbit of half its period"
    RESONANCE = "resonance: the multipliers are real beyond it"
    SHORT = "no step is short enough"
    FAR = "the motion grows without bound"
    UNBUILT = "beyond it no system can be built"
    POINTS = "as many points as were allowed"
    CANCELLED = "cancelled"


@dataclass(frozen=True, eq=False, repr=False)
class CurvePoint(Record):
    """One orbit of a curve.

    Attributes
    ----------
    values : tuple of float
        Of the two parameters.
    arclength : float
        From the first orbit, in scaled unknowns; negative towards the first end.
    state : ndarray of shape (n,)
        At phase zero.
    period : int
        In mesh cycles.
    signature : Signature
        Its contacts; what touches is not counted.
    multipliers : ndarray of complex, of shape (n,)
        All Floquet multipliers, by modulus, descending; of what touches, those of the side without contact
        change.
    touches : tuple of Extremum
        The extrema that touch.
    extrema : tuple of Extremum
        All of them, with their distances from their boundaries.
    residual : float
        Of all equations of the curve, relative to the sizes of the motion; where they change fast, to that.
    admissible : bool
        Whether it is an orbit of the real system: no boundary is crossed that is taken as not crossed.
    status : Status

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> branch = gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5})
    >>> fold = branch.of_kind("fold")[0]
    >>> curve = gl.continue_curve(case, ("omega", "load"), fold, lower=(0.7, 0.09), upper=(0.9, 0.11))
    >>> curve.points[0].admissible
    True
    """

    _printed: ClassVar = ("values", "signature", "arclength", "admissible", "status")

    values: tuple[float, float]
    arclength: float
    state: Array
    period: int
    signature: Signature
    multipliers: NDArray[np.complex128]
    touches: tuple[Extremum, ...]
    extrema: tuple[Extremum, ...]
    residual: float
    admissible: bool
    status: Status

    @property
    def unstable(self) -> int:
        """Multipliers outside the unit circle by more than rounding."""
        return int((np.abs(self.multipliers) > 1.0 + 1e-9).sum())


@dataclass(frozen=True, eq=False, repr=False)
class CodimTwoPoint(Record):
    """Where two things happen at once, on a curve.

    Attributes
    ----------
    kind : CodimTwoKind
    values, errors : tuple of float
        Of the two parameters, and an estimate of their errors.
    point : CurvePoint
        The orbit there: with it curves are begun.
    label_before, label_after : Signature
        Contacts of the orbits of the curve on both sides; where a touch ends the curve, of the side from
        which it is come to, and with the contact that is born.
    solved : bool
        Whether both conditions were solved for together; else it is a zero of a function along the curve.
    note : str
    status : Status

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.CodimTwoKind("cusp") is gl.CodimTwoKind.CUSP
    True
    """

    _printed: ClassVar = ("kind", "values", "label_before", "label_after", "note", "status")

    kind: CodimTwoKind
    values: tuple[float, float]
    errors: tuple[float, float]
    point: CurvePoint
    label_before: Signature
    label_after: Signature
    solved: bool
    note: str
    status: Status

    @property
    def arclength(self) -> float:
        """Of the point itself."""
        return self.point.arclength


@dataclass(frozen=True, repr=False)
class EndOfCurve(Record):
    """Why a curve is not followed farther.

    Attributes
    ----------
    kind : CurveEndKind
    values : tuple of float
        Of the two parameters.
    note : str
        The evidence in words, where there is more to tell.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.EndOfCurve(gl.CurveEndKind.LIMIT, (0.8, 0.1)).note
    ''
    """

    kind: CurveEndKind
    values: tuple[float, float]
    note: str = ""


@dataclass(frozen=True, eq=False, repr=False)
class Curve(Record):
    """Special orbits along a curve in a plane of two parameters.

    Attributes
    ----------
    kind : SpecialKind
        Grazing, fold, doubling or Neimark-Sacker.
    names : tuple of str
        Of the two parameters, short.
    values : mapping of str to float
        All parameters, dimensionless; those of `names` are where the curve was begun.
    lower, upper : tuple of float
        Limits of the parameters.
    points : tuple of CurvePoint
        In the order of their arclength.
    special : tuple of CodimTwoPoint
        In the same order.
    ends : tuple of EndOfCurve
        The first and the last.
    scale : ndarray of shape (n + 2,)
        Of states and parameters, in which arclength is measured.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> branch = gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5})
    >>> fold = branch.of_kind("fold")[0]
    >>> curve = gl.continue_curve(case, ("omega", "load"), fold, lower=(0.7, 0.09), upper=(0.9, 0.11))
    >>> curve.kind.value, curve.names
    ('fold', ('omega', 'load'))
    """

    _printed: ClassVar = ("kind", "names", "points", "special", "ends")

    kind: SpecialKind
    names: tuple[str, str]
    values: Mapping[str, float]
    lower: tuple[float, float]
    upper: tuple[float, float]
    points: tuple[CurvePoint, ...]
    special: tuple[CodimTwoPoint, ...]
    ends: tuple[EndOfCurve, ...]
    scale: Array

    @property
    def parameters(self) -> Array:
        """Values of the two parameters, of shape (m, 2)."""
        return np.array([point.values for point in self.points])

    @property
    def throughout(self) -> tuple[CodimTwoKind, ...]:
        """What happens at once on all of its orbits. It does where the motions of the plane are multiples of
        each other, or by a symmetry: two curves are one there, and no point of it is told."""
        on_every = [set(_at_once(point, self.kind)) for point in self.points]
        return tuple(kind for kind in CodimTwoKind if on_every and all(kind in each for each in on_every))

    @property
    def admissible(self) -> tuple[tuple[float, float], ...]:
        """Intervals of arclength whose points are orbits of the real system."""
        found: list[tuple[float, float]] = []
        begun: float | None = None
        last = 0.0
        for point in self.points:
            if point.admissible:
                begun, last = (point.arclength if begun is None else begun), point.arclength
            elif begun is not None:
                found.append((begun, last))
                begun = None
        return tuple(found) if begun is None else (*found, (begun, last))

    def of_kind(self, kind: CodimTwoKind | str) -> tuple[CodimTwoPoint, ...]:
        """The special points of one kind.

        Parameters
        ----------
        kind : CodimTwoKind or str

        Returns
        -------
        tuple of CodimTwoPoint
        """
        return tuple(special for special in self.special if special.kind is CodimTwoKind(kind))


def _at_once(point: CurvePoint, kind: SpecialKind) -> Iterator[CodimTwoKind]:
    """What an orbit of a curve has beside what the curve is made of, within rounding."""
    size = max(float(np.abs(point.state).max()), 1e-300)
    near = sum(abs(extremum.distance) <= ALIKE * size for extremum in point.extrema)
    if kind is not SpecialKind.GRAZING:
        if near and kind in OF_GRAZING:
            yield OF_GRAZING[kind]
        return
    if near > 1:
        yield CodimTwoKind.TWO_GRAZINGS
    if np.abs(point.multipliers - 1.0).min() <= ALIKE:
        impacts = any(map(any, point.signature.counts))
        yield CodimTwoKind.GRAZING_FOLD if impacts else CodimTwoKind.CORNER
    if np.abs(point.multipliers + 1.0).min() <= ALIKE:
        yield CodimTwoKind.GRAZING_DOUBLING
