"""The branches of periodic orbits behind a sweep, and what they say of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from gearlash.system import Label, Record, Signature

if TYPE_CHECKING:
    from gearlash import Branch, EndOfBranch, SpecialPoint

SAME = 1e-9  # relative distance of two values that are one point


@dataclass(frozen=True, eq=False, repr=False)
class Stretch(Record):
    """A stable part of a branch with one label: nothing special lies inside it.

    Attributes
    ----------
    branch : int
        Of which of the branches.
    label : Signature
    lower, upper : float
        Of the parameter.
    lower_end, upper_end : SpecialPoint or EndOfBranch
        What it ends at.
    """

    _printed: ClassVar = ("branch", "label", "lower", "upper")

    branch: int
    label: Signature
    lower: float
    upper: float
    lower_end: SpecialPoint | EndOfBranch
    upper_end: SpecialPoint | EndOfBranch


@dataclass(frozen=True, eq=False, repr=False)
class Together(Record):
    """An interval in which several stable stretches lie side by side.

    Attributes
    ----------
    lower, upper : float
        Of the parameter.
    stretches : tuple of int
        Which of the stretches; the same throughout.
    """

    lower: float
    upper: float
    stretches: tuple[int, ...]


@dataclass(frozen=True, eq=False, repr=False)
class Explained(Record):
    """A change that was located along the sweeps, and the special point of a branch that it is.

    Attributes
    ----------
    value : float
        As located along the sweeps.
    kind : str
        As there.
    before, after : label or None
        For a rising parameter.
    directions : tuple of str
        Sweeps that met it.
    branch : int
        On which of the branches; -1 where none has it.
    special : SpecialPoint or None
        The point; None where none of the branches has one of this kind within 1e-9 of the value.
    swept : SpecialPoint
        As it was solved for along the sweeps.
    """

    _printed: ClassVar = ("value", "kind", "before", "after", "branch", "special")

    value: float
    kind: str
    before: Label | None
    after: Label | None
    directions: tuple[str, ...]
    branch: int
    special: SpecialPoint | None
    swept: SpecialPoint

    @property
    def point(self) -> SpecialPoint:
        """That of the branch; without one that of the sweeps."""
        return self.swept if self.special is None else self.special

    @property
    def apart(self) -> float:
        """Of the two values; NaN where there is no point."""
        return float("nan") if self.special is None else abs(self.special.value - self.value)


@dataclass(frozen=True, eq=False, repr=False)
class Scan(Record):
    """One swept parameter as branches of periodic orbits, stable and unstable.

    Attributes
    ----------
    parameter : str
    fixed : mapping of str to float
        Values of the other parameters.
    lower, upper : float
        Limits of the parameter.
    branches : tuple of Branch
        By period and value.
    switched : tuple of int
        Which of them were found by switching at a doubling, without an attractor of a sweep on them.
    events : tuple of Explained
        Every change that was located along the sweeps, by rising value.
    stretches : tuple of Stretch
        Stable ones, by rising value.
    together : tuple of Together
        Where more than one of them lies.
    attractors, on_branches : int
        How many points of the sweeps are periodic, and how many of those lie on one of the branches.
    left : tuple of str
        What was not followed, and why.
    """

    _printed: ClassVar = ("parameter", "lower", "upper", "attractors", "on_branches")

    parameter: str
    fixed: Mapping[str, float]
    lower: float
    upper: float
    branches: tuple[Branch, ...]
    switched: tuple[int, ...]
    events: tuple[Explained, ...]
    stretches: tuple[Stretch, ...]
    together: tuple[Together, ...]
    attractors: int
    on_branches: int
    left: tuple[str, ...] = ()

    def special_at(self, value: float) -> tuple[int, SpecialPoint] | None:
        """The number of a branch and its special point at a value, within a relative 1e-9; None where none of
        them has one."""
        near = [
            (abs(special.value - value), number, special)
            for number, branch in enumerate(self.branches)
            for special in branch.special
            if abs(special.value - value) <= SAME * abs(value)
        ]
        return min(near, key=lambda each: each[:2])[1:] if near else None
