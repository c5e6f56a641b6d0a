"""One direction of a sweep as plain arrays, and where two directions reach the same attractor."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from gearlash.results.forces import from_stored
from gearlash.results.steps import Rows
from gearlash.results.steps import apart as apart_by_points
from gearlash.system import GearlashError, Label, Signature, UnknownNameError, read_label

Array = NDArray[np.float64]
SAME_STROBES = 1e-6  # strobes of one attractor found twice agree to this, relative to their size


@dataclass(frozen=True, eq=False)
class Swept:
    """Attractors along an axis: values (m,) ascending, labels (m,), exponents with error bars (m,), and
    padded with nan: X on σ_t (m, k), contact force Φ at impacts on σ_d, at impacts and at releases on σ_b.
    ``apart`` (m-1,): steps over which the motion changed over to another one, so that no line joins them."""

    direction: str
    values: Array
    labels: tuple[Label | None, ...]
    exponent: Array
    exponent_error: Array
    strobes: Array
    drive_force: Array
    back_force: Array
    back_release_force: Array
    apart: NDArray[np.bool_]

    def points(self, name: str, keep: NDArray[np.bool_] | None = None) -> tuple[Array, Array]:
        """All finite points (value, y) of one of the padded arrays, of the kept axis values."""
        table = getattr(self, name)
        chosen = np.isfinite(table) if keep is None else np.isfinite(table) & keep[:, None]
        return np.broadcast_to(self.values[:, None], table.shape)[chosen], table[chosen]

    def runs(self) -> list[tuple[int, int, Label | None]]:
        """Maximal stretches of one label: first index, index after the last, label."""
        edges = [0, *(i for i in range(1, len(self.labels)) if self.labels[i] != self.labels[i - 1])]
        stops = [*edges[1:], len(self.labels)]
        return [(a, b, self.labels[a]) for a, b in zip(edges, stops, strict=True) if b > a]

    def edges(self) -> Array:
        """Limits (m+1,) of the cells around the values."""
        middle = (self.values[1:] + self.values[:-1]) / 2.0
        return np.concatenate([self.values[:1], middle, self.values[-1:]])


def swept(dataset: xr.Dataset, apart: Sequence[NDArray[np.bool_]] = ()) -> list[Swept]:
    """Every direction of a sweep dataset, in its order; ``apart``: of each, as from `studies.joined`, else
    what its points tell. Raises `UnknownNameError` for one without directions, `GearlashError` for one
    without any motion, and for another number of steps.
    """
    if "direction" not in dataset.dims:
        raise UnknownNameError("dimension", "direction", [str(d) for d in dataset.dims])
    ways, steps = [str(each) for each in dataset["direction"].values], dataset.sizes[axis_name(dataset)] - 1
    if not len(apart):
        apart = list(apart_by_points(Rows.of_dataset(dataset, axis_name(dataset))))
    elif [np.shape(each) for each in apart] != [(steps,)] * len(ways):
        raise GearlashError(f"apart: expected {steps} flags for each of {len(ways)} directions")
    found = [_swept(dataset, way, flags) for way, flags in zip(ways, apart, strict=True)]
    if not any(len(way.values) for way in found):
        raise GearlashError("nothing to draw: no point of these sweeps has a motion")
    return found


def axis_name(dataset: xr.Dataset) -> str:
    """Short name of the swept parameter."""
    return next(str(d) for d in dataset["label"].dims if d != "direction")


def _swept(dataset: xr.Dataset, direction: str, apart: NDArray[np.bool_]) -> Swept:
    axis = axis_name(dataset)
    one = dataset.sel(direction=direction)
    computed = np.array([bool(str(label)) for label in one["label"].values], dtype=bool)
    kept = np.flatnonzero(computed)
    one = one.isel({axis: kept})

    def padded(name: str) -> Array:
        if name not in one or not one[name].size:
            return np.full((len(one[axis]), 1), np.nan)
        table = one[name]
        return np.asarray(table.transpose(axis, ...).values, dtype=np.float64).reshape(len(one[axis]), -1)

    return Swept(
        direction=direction,
        values=np.asarray(one[axis].values, dtype=np.float64),
        labels=_labels(one["label"].values),
        exponent=np.asarray(one["largest_exponent"].values, dtype=np.float64),
        exponent_error=np.asarray(one["exponent_error"].values, dtype=np.float64),
        strobes=padded("strobes"),
        drive_force=from_stored(padded("drive_force")),
        back_force=from_stored(padded("back_force")),
        back_release_force=from_stored(padded("back_release_force")),
        apart=np.array([apart[low:high].any() for low, high in pairwise(kept)], dtype=bool),
    )


def _labels(texts: NDArray[np.str_]) -> tuple[Label | None, ...]:
    """What the texts of a dataset stand for, each read once."""
    known = {text: read_label(text) for text in set(map(str, texts))}
    return tuple(known[str(text)] for text in texts)


def differs(way: Swept, other: Swept) -> NDArray[np.bool_]:
    """(m,) where ``way`` reaches another attractor than ``other`` at the same value, or the other has
    no such value.

    Two aperiodic motions count as the same: points of one never repeat, so they cannot be compared one by
    one.
    """
    index = {value: i for i, value in enumerate(other.values)}
    return np.array([_other(way, i, other, index.get(v)) for i, v in enumerate(way.values)], dtype=bool)


def _other(way: Swept, i: int, other: Swept, j: int | None) -> bool:
    if j is None or way.labels[i] != other.labels[j]:
        return True
    if not isinstance(way.labels[i], Signature):
        return False
    mine, theirs = (np.sort(row[np.isfinite(row)]) for row in (way.strobes[i], other.strobes[j]))
    return len(mine) != len(theirs) or bool(
        np.abs(mine - theirs).max(initial=0.0) > SAME_STROBES * max(1.0, float(np.abs(mine).max(initial=0.0)))
    )
