"""Maps: one attractor per pixel of a plane of two parameters."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import cast

import numpy as np
from numpy.typing import ArrayLike

from gearlash import flow
from gearlash.jobs import Chain, Execution, Outcome, run
from gearlash.orbits import Settings
from gearlash.results import Axis
from gearlash.results.plane import MOST_PIXELS, NO_LABEL, PlaneMap
from gearlash.system import Family, GearlashError, Label, MotionKind, Signature

from .arguments import checked_execution, checked_settings, checked_start, checked_values
from .model import Model, Source
from .named import plain_axis
from .pixels import (
    APERIODIC,
    NEUTRAL,
    NOTHING,
    PERIODIC,
    UNRESOLVED,
    Pixel,
    Stretch,
    clearances_of,
    failed_record,
    record_kind,
    work,
)

OTHER_GAPS = "its system has another number of clearances than the first of the map"
PIXELS_OF_A_TASK = 64  # about a second of work, of which a cancel has to wait for the rest
_NO_CLEARANCE = bytes(record_kind(1).itemsize)
NAMED = {
    APERIODIC: MotionKind.APERIODIC,
    UNRESOLVED: MotionKind.UNRESOLVED,
    NEUTRAL: MotionKind.NEUTRAL,
}


def map_plane(
    model: Model,
    x: Axis,
    y: Axis,
    *,
    values: Mapping[str, float | str] | None = None,
    start: ArrayLike | None = None,
    settings: Settings | None = None,
    execution: Execution | None = None,
) -> PlaneMap:
    """The attractor of every pixel of the plane of two parameters.

    Parameters
    ----------
    model : Case or Family
    x, y : Axis
        Two different parameters and their values, as for `sweep`; up to 1,000,000 pixels.
    values : mapping of str to float or str, optional
        Other parameters than those of the axes, over those of the model. A case takes every name and unit of
        its file: ``{"backlash": "90 um"}``.
    start : array_like of shape (n,), optional
        State at phase zero from which every pixel starts; the model's cold start without.
    settings : Settings, optional
        How every attractor is looked for.
    execution : Execution, optional
        Who does the work, who is told and who may stop it: results are the same bytes. A study that is
        stopped, by Ctrl-C or otherwise, returns what it has by then, marked as incomplete.
        Its chunk counts pixels on one line of the map. Threads wait for each other during about half of a
        pixel's time, which is spent outside the kernels; processes (`open_workers`) do not.

    Returns
    -------
    PlaneMap
        Arrays of shape (len(y), len(x)). A pixel that fails has a status, and a reason in ``reasons``.

    Raises
    ------
    GearlashError
        For names, values and starts that do not fit.

    Examples
    --------
    >>> import gearlash as gl
    >>> speeds, loads = gl.Axis.even("omega", 0.7, 0.9, 3), gl.Axis.even("load", 0.1, 0.3, 2)
    >>> gl.map_plane(gl.load_case("kahraman-singh"), speeds, loads).shares
    {1-0-0: 5, 1-1-0: 1}
    """
    source = Source.of(model)
    family = source.family()
    x, y = plain_axis(model, family, x), plain_axis(model, family, y)
    fixed = checked_values(model, family, values, [x, y])
    _check_size(x, y)
    state = checked_start(family, start)
    begin = None if state is None else tuple(map(float, state))
    execution = checked_execution(source, execution)
    chunk = PIXELS_OF_A_TASK if execution.chunk is None else execution.chunk
    grid = _Grid(x, y, _keeps(family, fixed, x, y))
    form = Stretch(source, tuple(fixed.items()), grid.inner.name, (), begin, checked_settings(settings))
    outcome = run(work, grid.chains(form, chunk), execution)
    return grid.gathered(outcome, fixed)


def _check_size(x: Axis, y: Axis) -> None:
    if len(x) * len(y) > MOST_PIXELS:
        raise GearlashError(f"{len(x)} × {len(y)} pixels: a map takes {MOST_PIXELS:,} at the most")
    if x.name == y.name:
        raise GearlashError(f"both axes of the map are {x.name}: expected two different parameters")


def _keeps(family: Family, fixed: dict[str, float], x: Axis, y: Axis) -> bool:
    """Whether propagators stay usable along y; lines of the map then run along y, else along x."""
    middle = len(y) // 2
    here = {**fixed, x.name: float(x.values[len(x) // 2])}
    try:
        one, other = (
            flow.propagators(family.system({**here, y.name: float(y.values[at])})).key
            for at in (middle, max(0, middle - 1))
        )
    except GearlashError:  # told by the pixels that fail
        return False
    return one == other


@dataclass(frozen=True, eq=False)
class _Grid:
    """The pixels of a map, in lines along y or x."""

    x: Axis
    y: Axis
    along_y: bool

    @property
    def inner(self) -> Axis:
        return self.y if self.along_y else self.x

    @property
    def outer(self) -> Axis:
        return self.x if self.along_y else self.y

    def chains(self, form: Stretch, size: int) -> list[Chain]:
        """A chain of one task for every stretch, named (line, first pixel)."""
        found = []
        for line, value in enumerate(map(float, self.outer.values)):
            fixed = (*form.fixed, (self.outer.name, value))
            for first in range(0, len(self.inner), size):
                values = tuple(map(float, self.inner.values[first : first + size]))
                task = replace(form, fixed=fixed, values=values)
                found.append(Chain((line, first), (task,), (len(values),)))
        return found

    def gathered(self, outcome: Outcome, fixed: dict[str, float]) -> PlaneMap:
        """The map of what was computed."""
        pixels = {(line, at): pixel for (line, at), pixel in _placed(outcome)}
        records = (pixel.record for pixel in pixels.values() if pixel.record)
        kind = record_kind(clearances_of(next(records, _NO_CLEARANCE)))
        table = np.zeros((len(self.outer), len(self.inner)), kind)
        table["kind"], table["exponent"] = NOTHING, np.nan
        failed = failed_record(kind)
        for place, pixel in pixels.items():
            if pixel.record and len(pixel.record) != kind.itemsize:
                pixel = pixels[place] = Pixel(b"", OTHER_GAPS)
            table[place] = np.frombuffer(pixel.record, kind)[0] if pixel.record else failed
        reasons = {
            place[::-1] if self.along_y else place: pixel.reason
            for place, pixel in pixels.items()
            if not pixel.record
        }
        complete = len(pixels) == table.size
        return _map(
            self.x, self.y, table.T if self.along_y else table,
            reasons=dict(sorted(reasons.items())), complete=complete,
            message="" if complete else outcome.reason or "stopped", fixed=fixed,
        )  # fmt: skip


def _placed(outcome: Outcome) -> Iterator[tuple[tuple[int, int], Pixel]]:
    """(line, place on it) and pixel of all that was computed."""
    for name, pixels in outcome.results.items():
        line, first = cast(tuple[int, int], name)
        for at, pixel in enumerate(pixels, first):
            yield (line, at), pixel


def _map(x: Axis, y: Axis, table: np.ndarray, **about) -> PlaneMap:
    labels, codes = _labelled(table)
    counts = table["counts"]
    arrays = {
        "period": table["period"],
        "drive": counts[..., 0, 0],
        "back": counts[..., 0, 1],
        "others": counts[..., 1:, :].sum(axis=(-2, -1), dtype=np.int32),
        **{name: table[name] for name in ("exponent", "periods", "status", "certificate")},
    }
    contiguous = {name: np.array(array, order="C") for name, array in arrays.items()}
    return PlaneMap(x=x, y=y, labels=labels, label=codes, **contiguous, **about)


def _labelled(table: np.ndarray) -> tuple[tuple[Label, ...], np.ndarray]:
    """The table of labels, orbits by period and counts, then the rest; and the code of every pixel."""
    counts = table["counts"].reshape(table.size, -1)
    rows = np.column_stack([table["kind"].ravel(), table["period"].ravel(), counts])
    there = rows[:, 0] != NOTHING  # all others, of a map that was stopped: whoever did so waits for this
    kinds, found = np.unique(rows[there], axis=0, return_inverse=True)
    labels = tuple(_label(*map(int, row)) for row in kinds)
    codes = np.full(table.size, NO_LABEL, np.int16 if len(labels) <= np.iinfo(np.int16).max else np.int32)
    codes[there] = found.ravel()
    return labels, codes.reshape(table.shape)


def _label(kind: int, period: int, *counts: int) -> Label:
    if kind != PERIODIC:
        return NAMED[kind]
    first, *others = zip(counts[::2], counts[1::2], strict=True)
    return Signature(period, *first, others=tuple(others))
