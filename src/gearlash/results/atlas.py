"""An atlas: curves in a plane of two parameters, the points where they meet, and a map that checks them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import ClassVar

from gearlash.branches.continuation import SpecialKind
from gearlash.branches.curves import CodimTwoKind, CodimTwoPoint, Curve
from gearlash.system import Label, Record
from gearlash.system.status import Named

from .plane import PlaneMap


class LabelChangeKind(Named):
    """Why two neighbouring pixels of the map behind an atlas show different motions."""

    CURVE = "curve"
    """Curves of these motions lie between them."""
    COEXIST = "coexistence"
    """Both attract at one of the two pixels, each certified: the starts differ."""
    POINT = "special point without a curve"
    """Special points were solved for between them, whose curves were not drawn."""
    APERIODIC = "aperiodic"
    """On one side or both nothing periodic was proved."""
    NONE = "unexplained"
    """Nothing that was found says why."""
    UNSEEN = "not looked at"
    """The atlas was stopped before it was looked why."""


STAGES = ("the map", "motions along lines", "curves from them", "the check of the map")
"""What is done for an atlas, in order."""


@dataclass(frozen=True, repr=False)
class LabelChange(Record):
    """Two neighbouring pixels with different labels.

    Attributes
    ----------
    pixels : tuple of (int, int)
        Row and column of both.
    values : tuple of (float, float)
        Of the two parameters at both.
    labels : tuple of Signature or MotionKind or None
        Of both.
    kind : LabelChangeKind
    curves : tuple of int
        Numbers, from 0, of the curves of the atlas between them.
    note : str
        What else is known, in words.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.LabelChangeKind("coexistence") is gl.LabelChangeKind.COEXIST
    True
    """

    _printed: ClassVar = ("values", "labels", "kind", "curves", "note")

    pixels: tuple[tuple[int, int], tuple[int, int]]
    values: tuple[tuple[float, float], tuple[float, float]]
    labels: tuple[Label | None, Label | None]
    kind: LabelChangeKind
    curves: tuple[int, ...] = ()
    note: str = ""


@dataclass(frozen=True, repr=False)
class StraightPiece(Record):
    """A piece of a curve along which one parameter stays where it is.

    Attributes
    ----------
    name : str
        Of the parameter that the special orbits do not depend on.
    lower, upper : float
        Of that parameter.
    value : float
        Of the other one, which stays.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.StraightPiece("D", 0.3, 1.2, 0.708)
    StraightPiece(name='D', lower=0.3, upper=1.2, value=0.708)
    """

    name: str
    lower: float
    upper: float
    value: float


@dataclass(frozen=True, eq=False, repr=False)
class AtlasCurve(Record):
    """A curve of an atlas.

    Attributes
    ----------
    curve : Curve
    way : str
        How its first orbit was found.
    straight : tuple of StraightPiece
        Pieces along which one of the parameters does not change, within rounding: its orbits do not depend on
        the other one.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.AtlasCurve.__name__
    'AtlasCurve'
    """

    _printed: ClassVar = ("curve", "way", "straight")

    curve: Curve
    way: str
    straight: tuple[StraightPiece, ...] = ()

    @property
    def kind(self) -> SpecialKind:
        """Grazing, fold, doubling or Neimark-Sacker."""
        return self.curve.kind

    @property
    def bounds_attractors(self) -> bool:
        """Whether some of its orbits have no multiplier outside the unit circle, so that it bounds motions
        that attract."""
        return any(point.unstable == 0 and point.admissible for point in self.curve.points)


@dataclass(frozen=True, eq=False, repr=False)
class AtlasPoint(Record):
    """A point at which two things happen at once.

    Attributes
    ----------
    special : CodimTwoPoint
    curves : tuple of int
        Numbers, from 0, of the curves of the atlas on which it was found.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.AtlasPoint.__name__
    'AtlasPoint'
    """

    _printed: ClassVar = ("special", "curves")

    special: CodimTwoPoint
    curves: tuple[int, ...]

    @property
    def kind(self) -> CodimTwoKind:
        """What two things happen."""
        return self.special.kind

    @property
    def values(self) -> tuple[float, float]:
        """Of the two parameters."""
        return self.special.values


@dataclass(frozen=True, repr=False)
class Undone(Record):
    """What an atlas leaves undone.

    Attributes
    ----------
    what : str
        Such as "curve of a fold" or "end of a curve of grazings".
    label : Signature or MotionKind or None
        Of the motion.
    values : tuple of float
        Of the two parameters.
    why : str

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.Undone("curve of folds", None, (0.7, 0.3), "the budget of 5 curves was spent").why
    'the budget of 5 curves was spent'
    """

    what: str
    label: Label | None
    values: tuple[float, float]
    why: str


@dataclass(frozen=True, eq=False, repr=False)
class Atlas(Record):
    """The curves of special orbits in a rectangle of two parameters, where they meet, and their check.

    Attributes
    ----------
    plane : PlaneMap
        The coarse map behind it: one attractor a pixel, from one start.
    curves : tuple of AtlasCurve
        Each drawn once.
    points : tuple of AtlasPoint
        Where two things happen at once, each told once.
    changes : tuple of LabelChange
        Every pair of neighbouring pixels of the map whose labels differ, and why they do.
    undone : tuple of Undone
        What was left undone, and why.
    tried : int
        Curves that were followed, those that were found twice or could not be begun among them.
    complete : bool
        False where it was stopped early.
    message : str
        Why it is not complete.
    values : mapping of str to float
        All parameters but the two, dimensionless.
    done : tuple of str
        The stages that were done, in order: of one that was stopped perhaps not all.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> x, y = gl.Axis.even("omega", 0.81, 0.83, 2), gl.Axis.even("D", 0.9, 1.1, 2)
    >>> found = gl.atlas(case, x, y, lines=1)
    >>> [str(each.kind) for each in found.curves], found.counts[gl.LabelChangeKind.NONE]
    (['grazing', 'fold'], 0)
    """

    _printed: ClassVar = ("names", "curves", "points", "counts", "tried", "complete", "message")

    plane: PlaneMap
    curves: tuple[AtlasCurve, ...]
    points: tuple[AtlasPoint, ...]
    changes: tuple[LabelChange, ...]
    undone: tuple[Undone, ...]
    tried: int
    complete: bool
    message: str
    values: Mapping[str, float]
    done: tuple[str, ...] = STAGES

    @property
    def names(self) -> tuple[str, str]:
        """Of the two parameters, short."""
        return self.plane.x.name, self.plane.y.name

    @property
    def counts(self) -> dict[LabelChangeKind, int]:
        """How many changes of label between neighbouring pixels have which reason."""
        found = Counter(change.kind for change in self.changes)
        return {kind: found[kind] for kind in LabelChangeKind}

    def of_kind(self, kind: SpecialKind | str) -> tuple[AtlasCurve, ...]:
        """The curves of one kind.

        Parameters
        ----------
        kind : SpecialKind or str

        Returns
        -------
        tuple of AtlasCurve
        """
        return tuple(each for each in self.curves if each.kind is SpecialKind(kind))
