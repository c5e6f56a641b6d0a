"""A map: one attractor per pixel of a plane of two parameters, in arrays."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from types import MappingProxyType
from typing import Any, ClassVar, TypeVar

import numpy as np
from numpy.typing import NDArray

from gearlash.system import GearlashError, Label, Record, Status, read_label

from .axis import Axis

Array = NDArray[Any]
Named = TypeVar("Named")

STATUSES = (
    Status.NOT_COMPUTED,
    Status.FAILED,
    *(one for one in Status if one not in (Status.NOT_COMPUTED, Status.FAILED)),
)
"""What the codes of `PlaneMap.status` mean."""
CERTIFICATES = ("", "certified", "uncertain", "failed")
"""What the codes of `PlaneMap.certificate` mean; the first: nothing was computed."""
NO_LABEL = -1
"""Code of a pixel without a motion."""
MOST_PIXELS = 1_000_000
"""Of a map: it is held in memory, and so many stay below a gibibyte."""


@dataclass(frozen=True, eq=False, repr=False)
class PlaneMap(Record):
    """Attractors from cold starts over ``x`` and ``y``; every array has the shape (len(y), len(x)).

    ``label`` (int16; int32 beyond 32,767 labels): index into ``labels`` (P-Q-R of proved orbits,
    aperiodic, neutral, unresolved), `NO_LABEL` where there is no motion. ``period`` (mesh cycles),
    ``drive``, ``back`` (impacts of the first clearance in it) and ``others`` (of all further ones),
    int32: 0 where nothing periodic was proved. ``exponent``: the largest Lyapunov exponent per unit of τ,
    float64, NaN where unknown. ``periods``: base periods marched, int32. ``status`` and ``certificate``,
    uint8: index into `STATUSES` and `CERTIFICATES`.

    ``reasons``: (row, column) of every failed pixel → why. Where the map was stopped early ``complete`` is
    False, ``message`` says why, and what is missing has the status `not-computed`. ``fixed`` are the
    parameters that were set beside the case's own.
    """

    _printed: ClassVar = ("x", "y", "shares", "statuses", "complete", "message", "fixed")

    x: Axis
    y: Axis
    labels: tuple[Label, ...]
    label: Array
    period: Array
    drive: Array
    back: Array
    others: Array
    exponent: Array
    periods: Array
    status: Array
    certificate: Array
    reasons: Mapping[tuple[int, int], str] = field(default_factory=dict)
    complete: bool = True
    message: str = ""
    fixed: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "labels", tuple(map(read_label, self.labels)))
        for name, array in self.arrays.items():
            if array.shape != self.shape:
                raise GearlashError(f"{name} of a map has shape {array.shape}, expected {self.shape}")
            array.setflags(write=False)
        object.__setattr__(self, "reasons", MappingProxyType(dict(self.reasons)))
        object.__setattr__(self, "fixed", MappingProxyType(dict(self.fixed)))

    @property
    def arrays(self) -> dict[str, Array]:
        """Every array of the map by name."""
        found = {each.name: getattr(self, each.name) for each in fields(self)}
        return {name: value for name, value in found.items() if isinstance(value, np.ndarray)}

    @property
    def shape(self) -> tuple[int, int]:
        """(len(y), len(x))."""
        return len(self.y), len(self.x)

    @property
    def nbytes(self) -> int:
        """Memory of all arrays, in bytes."""
        return sum(array.nbytes for array in self.arrays.values())

    @property
    def computed(self) -> int:
        """How many pixels were computed."""
        return int(np.count_nonzero(self.status != STATUSES.index(Status.NOT_COMPUTED)))

    @property
    def impact_free(self) -> NDArray[np.bool_]:
        """Pixels with a proved orbit without any impact, in any clearance."""
        return (self.period > 0) & (self.drive == 0) & (self.back == 0) & (self.others == 0)

    @property
    def statuses(self) -> dict[Status, int]:
        """How many pixels have which status."""
        return _counted(self.status, STATUSES)

    @property
    def certificates(self) -> dict[str, int]:
        """How many of the computed pixels are certified, uncertain, failed."""
        found = _counted(self.certificate, CERTIFICATES)
        return {name: count for name, count in found.items() if name}

    @property
    def shares(self) -> dict[Label, int]:
        """How many pixels have which label, the most frequent first."""
        found = _counted(self.label[self.label != NO_LABEL], self.labels)
        return dict(sorted(found.items(), key=lambda item: (-item[1], str(item[0]))))

    def label_at(self, row: int, column: int) -> Label | None:
        """The label of a pixel; None where there is no motion."""
        code = int(self.label[row, column])
        return None if code == NO_LABEL else self.labels[code]


def _counted(codes: Array, table: tuple[Named, ...]) -> dict[Named, int]:
    counts = np.bincount(codes.ravel(), minlength=len(table))
    return {name: int(count) for name, count in zip(table, counts, strict=True) if count}
