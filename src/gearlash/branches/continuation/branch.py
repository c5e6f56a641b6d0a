"""A whole branch: all that was met along it, in order."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from math import nan
from typing import ClassVar

import numpy as np

from gearlash.system import Record, given

from .derivative import DerivativeKind
from .equations import Array
from .points import BranchPoint, EndOfBranch, SpecialKind, SpecialPoint


@dataclass(frozen=True, eq=False, repr=False)
class Branch(Record):
    """Periodic orbits along one parameter, stable or not.

    Attributes
    ----------
    name : str
        Of the parameter, short.
    values : mapping of str to float
        All parameters, dimensionless; that of `name` is where the branch was begun.
    lower, upper : float
        Limits of the parameter.
    points : tuple of BranchPoint
        In the order of their arclength.
    special : tuple of SpecialPoint
        In the same order.
    ends : tuple of EndOfBranch
        The first and the last.
    scale : ndarray
        Of the unknowns (states, then the parameter), in which arclength is measured.
    unexplained : tuple of str
        Steps on which something changed that no special point was found for, and what else is not decided,
        in words.
    derivative : DerivativeKind or None
        How the derivatives along the parameter were had; None where a file of before does not say.
    derivative_error : float
        Estimate of their error, relative; 0 where they are exact, NaN where it is not known. It makes
        Newton's method slower, and no orbit less exact.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("article").family()
    >>> branch = gl.continue_branch(family, "omega", lower=1.0, upper=1.12)
    >>> [round(special.value, 6) for special in branch.of_kind("grazing")]
    [1.112]
    """

    _printed: ClassVar = ("name", "lower", "upper", "points", "special", "ends")

    name: str
    values: Mapping[str, float]
    lower: float
    upper: float
    points: tuple[BranchPoint, ...]
    special: tuple[SpecialPoint, ...]
    ends: tuple[EndOfBranch, ...]
    scale: Array
    unexplained: tuple[str, ...] = ()
    derivative: DerivativeKind | None = None
    derivative_error: float = nan

    @property
    def parameter(self) -> Array:
        """Values of the parameter, of shape (m,)."""
        return np.array([point.value for point in self.points])

    def of_kind(self, kind: SpecialKind | str) -> tuple[SpecialPoint, ...]:
        """The special points of one kind.

        Parameters
        ----------
        kind : SpecialKind or str

        Returns
        -------
        tuple of SpecialPoint
        """
        return tuple(special for special in self.special if special.kind is SpecialKind(kind))

    def at(self, value: float) -> tuple[tuple[BranchPoint, BranchPoint], ...]:
        """Where the branch passes a value.

        Parameters
        ----------
        value : float
            Of the parameter.

        Returns
        -------
        tuple of pairs of BranchPoint
            Neighbours with the value between theirs, one pair for every passage.
        """
        value, pairs = given.number("value", value), pairwise(self.points)
        return tuple(p for p in pairs if min(p[0].value, p[1].value) <= value <= max(p[0].value, p[1].value))
