"""One place in a case file: a quantity with its dimension and range, or a named option."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from math import inf

from .units import DIMENSION_NAMES, Dimension, unit

_LEAST = 1e-15
LARGEST_VALUE = 1e9
"""Bound of dimensionless numbers without a bound of their own."""


class ValueRefusedError(ValueError):
    """A value that cannot be used; says what is expected and the nearest valid name if there is one."""

    def __init__(self, expected: str, nearest: str | None = None):
        self.expected, self.nearest = expected, nearest
        super().__init__(expected)


@dataclass(frozen=True)
class Quantity:
    """A place in a case file that takes a number.

    Parameters
    ----------
    path : str
        ``table.leaf``.
    dimension : Dimension
        Of `gearlash.case.units`, such as ``LENGTH`` or ``NUMBER``.
    unit : str
        That it is shown in.
    example : str
        A value as one would type it.
    description : str
    lower, upper : float
        The range, in SI, both ends included.
    above : bool
        ``lower`` itself is excluded: values must exceed it by at least 1e-15, so that nothing computed from
        them overflows.
    integer : bool
        Only whole numbers.
    bare : bool
        A number without a unit is taken too, in ``unit``: plain numbers, and angles of dimensionless cases in
        rad.
    key : str
        The quantity; the same for all places that name it. Empty: the path.
    below : str
        What is told beside the range of a value below it.
    reader : callable, optional
        From a text as drawings have it there to one that is a number with its unit. Raises
        `ValueRefusedError`.
    alone : str
        Why one value stands there, and no two limits of it; empty where limits may.
    """

    path: str
    dimension: Dimension
    unit: str
    example: str
    description: str
    lower: float = -inf
    upper: float = inf
    above: bool = False
    integer: bool = False
    bare: bool = False
    key: str = ""
    below: str = ""
    reader: Callable[[str], str] | None = None
    alone: str = ""

    def accepts(self, value: float) -> bool:
        """Is the value (SI) in range?"""
        return self.lower + (_LEAST if self.above else 0.0) <= value <= self.upper

    @property
    def expected(self) -> str:
        """What to write here, in words."""
        if self.integer:
            return f"a whole number from {self.lower:g} to {self.upper:g}, such as {self.example}"
        if self.bare:
            return f"{DIMENSION_NAMES[self.dimension]}, such as {self.example}"
        return f'{DIMENSION_NAMES[self.dimension]} with its unit, such as "{self.example}"'

    @property
    def expected_in_range(self) -> str:
        """The same with the range, for a value outside it."""
        if self.integer:
            return self.expected
        shown = unit(self.unit)
        parts = [DIMENSION_NAMES[self.dimension]]
        if self.lower != -inf:
            parts.append(f"{'above' if self.above else 'from'} {shown.express(self.lower):.6g} {self.unit}")
        if self.upper != inf:
            parts.append(f"up to {shown.express(self.upper):.6g} {self.unit}")
        return " ".join(part.strip() for part in parts)


@dataclass(frozen=True)
class Choice:
    """A place in a case file that takes one of a few names, ``default`` where nothing is stated."""

    path: str
    choices: tuple[str, ...]
    default: str
    description: str
    reader: Callable[[str], str] | None = field(default=None, kw_only=True)
    """From another text to the name that is kept. Raises `ValueRefusedError`."""

    def takes(self, name: str) -> bool:
        """Is it one of the names?"""
        return name in self.choices
