"""The parameter that a study goes along."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.system import GearlashError, Record, given, shown

MOST_VALUES = 100_000_000


@dataclass(frozen=True, eq=False, repr=False)
class Axis(Record):
    """``name`` is a short name (omega, D, load …), ``values`` (m,) are dimensionless and ascend strictly.

    Raises `GearlashError` for anything else.
    """

    name: str
    values: NDArray[np.float64]

    def __post_init__(self) -> None:
        name = given.word("name of an axis", self.name)
        values = given.row(f"axis {name}: values", self.values)
        if not len(values):
            raise GearlashError(f"axis {name}: expected at least one value")
        if not (np.diff(values) > 0.0).all():
            raise GearlashError(f"axis {self.name}: values must ascend, each once")
        object.__setattr__(self, "name", name)
        object.__setattr__(self, "values", given.kept(values))

    @classmethod
    def even(cls, name: str, ends: ArrayLike, count: int) -> Axis:
        """``count`` values at equal distances from the lower to the upper of two ``ends``, both included."""
        low, high = sorted(given.numbers(f"axis {shown(name)}: ends", ends, (2,)).tolist())
        count = given.whole(f"axis {shown(name)}: count", count, 1, MOST_VALUES)
        if (count == 1) != (low == high):
            raise GearlashError(
                f"axis {shown(name)}: expected two different ends and at least two values between them"
            )
        return cls(name, np.linspace(low, high, count))

    @property
    def step(self) -> float:
        """The widest distance between neighbours: what is narrower may lie between two values, unseen."""
        return float(np.diff(self.values).max()) if len(self) > 1 else 0.0

    def __len__(self) -> int:
        return len(self.values)
