"""The parameter that a study goes along."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.system import GearlashError, Record


@dataclass(frozen=True, eq=False, repr=False)
class Axis(Record):
    """``name`` is a short name (omega, D, load …), ``values`` (m,) are dimensionless and ascend strictly.

    Raises `GearlashError` for anything else.
    """

    name: str
    values: NDArray[np.float64]

    def __post_init__(self) -> None:
        values = np.array(self.values, dtype=np.float64)
        if values.ndim != 1 or not len(values):
            raise GearlashError(
                f"axis {self.name}: values have shape {values.shape}, expected (m,) with m ≥ 1"
            )
        if not np.isfinite(values).all():
            raise GearlashError(f"axis {self.name}: values hold NaN or infinity")
        if not (np.diff(values) > 0.0).all():
            raise GearlashError(f"axis {self.name}: values must ascend, each once")
        values.setflags(write=False)
        object.__setattr__(self, "values", values)

    @classmethod
    def even(cls, name: str, ends: ArrayLike, count: int) -> Axis:
        """``count`` values at equal distances from the lower to the upper of two ``ends``, both included."""
        ends = np.asarray(ends, dtype=np.float64)
        if ends.shape != (2,) or count < 1 or (count == 1) != (ends[0] == ends[1]):
            raise GearlashError(
                f"axis {name}: expected two different ends and at least two values between them"
            )
        return cls(name, np.linspace(ends.min(), ends.max(), count))

    @property
    def step(self) -> float:
        """The widest distance between neighbours: what is narrower may lie between two values, unseen."""
        return float(np.diff(self.values).max()) if len(self) > 1 else 0.0

    def __len__(self) -> int:
        return len(self.values)
