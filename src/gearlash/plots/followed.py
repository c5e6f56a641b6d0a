"""One branch as lines to draw: computed orbits and special points in their order, cut into pieces within
which neither stability nor contacts change."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import prod

import numpy as np
import xarray as xr
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator

from gearlash.results.between_points import Here, Passing, between
from gearlash.results.branch_dataset import TAKEN
from gearlash.results.variables import dimension
from gearlash.system import GearlashError, given

Array = NDArray[np.float64]
BETWEEN = 8  # values drawn between two computed orbits

MEASURES: dict[str, tuple[str, str]] = {
    "extremes": (r"least and largest $X_n$", "length"),
    "minimum": (r"least $X_n$", "length"),
    "maximum": (r"largest $X_n$", "length"),
    "amplitude": (r"half the span of $X_n$", "length"),
    "strobes": (r"$X_n$  on  $\sigma_t$", "length"),
    "force_max": (r"largest $\Phi$", "force"),
    "force_min": (r"least $\Phi$", "force"),
    "force_rms": (r"rms of $\Phi$", "force"),
}
"""What can stand on the y axis: words, and the quantity that it is."""


def read(dataset: xr.Dataset, measure: str, of: str = "") -> Array:
    """(m, k): the numbers of a measure at every point, or at every special point (``of``: "special_")."""
    names = {"extremes": ("minimum", "maximum"), "amplitude": ("minimum", "maximum")}.get(measure, (measure,))
    if f"{of}{names[0]}" not in dataset:
        raise GearlashError(f"the dataset has no {names[0]}: make it with extremes=True")
    columns = [dataset[f"{of}{name}"].values for name in names]
    flat = [c.reshape(len(c), prod(c.shape[1:])) for c in columns]  # a branch may have no special point
    table = np.concatenate(flat, axis=1).astype(np.float64)
    return 0.5 * (table[:, 1:] - table[:, :1]) if measure == "amplitude" else table


@dataclass(frozen=True, eq=False)
class Piece:
    """A stretch of a branch: values (m,) and y (m, k), its label, and whether it is stable."""

    values: Array
    y: Array
    label: str
    stable: bool

    @property
    def length(self) -> float:
        """Of the way over the parameter."""
        return float(np.abs(np.diff(self.values)).sum())

    def within(self, left: float, right: float) -> Piece:
        """The part of it that lies between two values."""
        shown = (self.values >= left) & (self.values <= right)
        return Piece(self.values[shown], self.y[shown], self.label, self.stable)


@dataclass(frozen=True, eq=False)
class Followed:
    """A branch in order of its arclength s (m,), special points among its orbits: values (m,), y (m, k), and
    between every two neighbours the label and whether the orbits are stable."""

    s: Array
    values: Array
    y: Array
    labels: tuple[str, ...]
    stable: tuple[bool, ...]

    @staticmethod
    def of(dataset: xr.Dataset, y: Array, special_y: Array) -> Followed:
        """From a dataset of a branch, with y of its points and special points."""
        width = max(y.shape[1], special_y.shape[1])
        s = np.concatenate([dataset["arclength"].values, dataset["special_arclength"].values])
        order = np.argsort(s, kind="stable")
        table = np.concatenate([_wide(y, width), _wide(special_y, width)])
        values = np.concatenate([dataset[parameter(dataset)].values, dataset["special_value"].values])
        nodes = [*_orbits(dataset), *_special(dataset)]
        looks = between([nodes[i] for i in order.tolist()])
        labels, stable = tuple(look.label for look in looks), tuple(look.unstable == 0 for look in looks)
        return Followed(s[order], values[order], table[order], labels, stable)

    def pieces(self) -> Iterator[Piece]:
        """Maximal stretches of one label and one stability, drawn smoothly through what was computed."""
        looks = list(zip(self.labels, self.stable, strict=True))
        begin = 0
        for i in range(1, len(looks) + 1):
            if i == len(looks) or looks[i] != looks[begin]:
                label, stable = looks[begin]
                yield Piece(*self._smooth(begin, i), label, stable)
                begin = i

    def _smooth(self, first: int, last: int) -> tuple[Array, Array]:
        """From node ``first`` to node ``last``: monotone cubics along the arclength, which pass through every
        node and add no extremum."""
        part = slice(first, last + 1)
        s, table = self.s[part], np.column_stack([self.values[part], self.y[part]])
        kept = np.concatenate([[True], np.diff(s) > 0.0])
        s, table = s[kept], table[kept]
        if len(s) < 3:
            return table[:, 0], table[:, 1:]
        fine = np.concatenate([np.linspace(a, b, BETWEEN, endpoint=False) for a, b in pairwise(s)])
        fine = np.append(fine, s[-1])
        drawn = np.full((len(fine), table.shape[1]), np.nan)
        for j in range(table.shape[1]):
            if np.isfinite(table[:, j]).all():
                drawn[:, j] = PchipInterpolator(s, table[:, j])(fine)
        return drawn[:, 0], drawn[:, 1:]


def _orbits(dataset: xr.Dataset) -> list[Here[str]]:
    columns = dataset["label"].values, dataset["unstable"].values
    return [Here(str(label), int(unstable)) for label, unstable in zip(*columns, strict=True)]


def _special(dataset: xr.Dataset) -> list[Passing[str]]:
    sides = []
    for side in ("before", "after"):
        columns = (dataset[f"special_{name}_{side}"].values for name in ("label", "unstable"))
        sides.append([Here(str(label), int(unstable)) for label, unstable in zip(*columns, strict=True)])
    kinds = map(str, dataset["special_kind"].values)
    return [Passing(*each) for each in zip(kinds, *sides, strict=True)]


def parameter(dataset: xr.Dataset) -> str:
    """The coordinate of the parameter. Raises `GearlashError` for what is no dataset of a branch."""
    given.instance("dataset", dataset, xr.Dataset, "a dataset, as from gearlash.branch_dataset")
    name = dimension(str(dataset.attrs.get("axis", "")), TAKEN)
    if name not in dataset.coords or "special_kind" not in dataset:
        raise GearlashError("not a dataset of a branch: make it with gearlash.branch_dataset(model, branch)")
    return name


def _wide(table: Array, width: int) -> Array:
    return np.pad(table, ((0, 0), (0, width - table.shape[1])), constant_values=np.nan)
