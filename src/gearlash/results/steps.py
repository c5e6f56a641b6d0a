"""From one value of a sweep to the next: whether both motions can be one that goes on, or it jumped between.

A line drawn from point to point says that the motion went along it. So where it changed over to another one,
no line may be drawn. What the points themselves tell of that is here; `gearlash.studies.joined` follows the
motions of doubtful steps, and so knows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from gearlash.system import Label, Signature, read_label

from .sweep import Sweep

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]
FIGURES = "minimum", "maximum", "force_max", "force_rms", "share_without_contact"
"""What is compared of two motions beside their points on σ_t."""
SAME = 1e-6  # of the span of a figure: nearer to each other, two ways found one motion
SMALL = 0.03  # of the span: a smaller step is that of a motion that goes on
LARGE = 0.4  # of the span: a larger one is none, as long as nobody has looked
STEEPER = 2.0  # times the steps beside it: a flank climbs in several, a peak comes back, a jump does neither
NOTHING = 1e-9  # of the size of a figure: a span that is rounding


@dataclass(frozen=True, eq=False)
class Rows:
    """Motions along one axis, found on several ways: labels (w, m); values (m,); and figures (w, m, k), each
    over its span of all ways, NaN where there is none."""

    labels: tuple[tuple[Label | None, ...], ...]
    values: Array
    figures: Array

    @staticmethod
    def of_sweeps(sweeps: Sequence[Sweep]) -> Rows:
        """Of sweeps over one axis."""
        labels = tuple(tuple(point.label for point in sweep.points) for sweep in sweeps)
        single = [[[getattr(p, name) for name in FIGURES] for p in sweep.points] for sweep in sweeps]
        longest = max((len(point.strobes) for sweep in sweeps for point in sweep.points), default=0)
        strobes = np.full((len(sweeps), len(sweeps[0].axis), longest), np.nan)
        for i, sweep in enumerate(sweeps):
            for j, point in enumerate(sweep.points):
                strobes[i, j, : len(point.strobes)] = point.strobes
        return _rows(labels, sweeps[0].axis.values, np.array(single, dtype=np.float64), strobes)

    @staticmethod
    def of_dataset(dataset: xr.Dataset, axis: str) -> Rows:
        """Of `sweep_dataset`; ``axis``: the dimension of the swept parameter."""
        texts = dataset["label"].transpose("direction", axis).values
        known = {text: read_label(text) for text in set(map(str, texts.flat))}
        labels = tuple(tuple(known[str(text)] for text in row) for row in texts)
        tables = [dataset[name].transpose("direction", axis).values for name in FIGURES]
        strobes = dataset["strobes"].transpose("direction", axis, ...).values
        return _rows(labels, dataset[axis].values, np.stack(tables, axis=-1), strobes)

    def steps(self) -> Array:
        """The largest change of any figure from each value to the next, (w, m-1); NaN beside none."""
        change = np.abs(np.diff(self.figures, axis=1))
        missing = np.isnan(self.figures[..., 0])
        return np.where(missing[:, 1:] | missing[:, :-1], np.nan, np.nan_to_num(change).max(axis=-1))

    def relabelled(self) -> Flags:
        """Steps (w, m-1) between two labels."""
        return np.array([[a != b for a, b in pairwise(row)] for row in self.labels], dtype=bool).reshape(
            len(self.labels), -1
        )

    def periodic(self) -> Flags:
        """Steps (w, m-1) between two periodic motions."""
        found = np.array([[isinstance(label, Signature) for label in row] for row in self.labels], dtype=bool)
        return found[:, 1:] & found[:, :-1]


def doubtful(rows: Rows) -> Flags:
    """Steps (w, m-1) from one periodic motion to another that may be a jump: all that are not small, those
    between two labels, and those at which two ways part or meet."""
    large = np.nan_to_num(rows.steps()) > SMALL
    return rows.periodic() & (large | rows.relabelled() | _parting(rows))


def apart(rows: Rows) -> Flags:
    """Steps (w, m-1) over which no line may be drawn, as far as the points alone tell.

    Where two ways part or meet, at least one of them changed over: that with the larger step. Elsewhere a
    step is taken for a jump that stands out from both beside it. Of one motion that climbs steeply on a
    coarse axis this says too much, of two motions never that they are one where ways differ."""
    step, width = rows.steps(), np.diff(rows.values)
    slope = np.nan_to_num(step) / np.abs(width)
    beside = np.zeros_like(slope)
    beside[:, 1:] = slope[:, :-1]
    beside[:, :-1] = np.maximum(beside[:, :-1], slope[:, 1:])
    stands_out = (step > SMALL) & (slope > STEEPER * beside)
    jumps = stands_out | (step > LARGE) | _parting(rows)
    return rows.relabelled() | np.isnan(step) | (rows.periodic() & jumps)


def _parting(rows: Rows) -> Flags:
    """Steps of the way that changed over, where it is with another one at one end of the step only."""
    step, found = np.nan_to_num(rows.steps()), np.zeros(rows.relabelled().shape, dtype=bool)
    for i in range(len(rows.labels)):
        for k in range(i):
            same = one_motion(rows, i, k)
            parting = same[1:] != same[:-1]
            found[i] |= parting & (step[i] >= step[k])
            found[k] |= parting & (step[k] >= step[i])
    return found


def one_motion(rows: Rows, i: int, k: int) -> Flags:
    """Values (m,) at which ways i and k found one motion; two of one label without a period count as one."""
    alike = np.array([a == b for a, b in zip(rows.labels[i], rows.labels[k], strict=True)], dtype=bool)
    off = np.nan_to_num(np.abs(rows.figures[i] - rows.figures[k])).max(axis=-1, initial=0.0)
    plain = np.array([not isinstance(label, Signature) for label in rows.labels[i]], dtype=bool)
    return alike & (plain | (off <= SAME))


def _rows(labels: tuple[tuple[Label | None, ...], ...], values: Array, single: Array, strobes: Array) -> Rows:
    """With every figure over its span; points on σ_t are one figure, in the order of their size."""
    columns = [_over_span(single[..., i : i + 1]) for i in range(single.shape[-1])]
    columns.append(_over_span(np.sort(strobes, axis=-1)))
    return Rows(labels, np.asarray(values, dtype=np.float64), np.concatenate(columns, axis=-1))


def _over_span(table: Array) -> Array:
    if not np.isfinite(table).any():
        return np.full_like(table, np.nan)
    low, high = float(np.nanmin(table)), float(np.nanmax(table))
    span = high - low
    return (
        (table - low) / span
        if span > NOTHING * max(abs(low), abs(high))
        else np.where(np.isnan(table), np.nan, 0.0)
    )
