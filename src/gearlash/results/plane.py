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
    """One attractor for each pixel of a plane of two parameters, in arrays of shape (len(y), len(x)).

    Attributes
    ----------
    x, y : Axis
        The parameters by short name, and their dimensionless values.
    labels : tuple of Signature or MotionKind
        All labels of the map.
    label : ndarray of int16 (int32 beyond 32,767 labels)
        Index into ``labels``; -1 where there is no motion.
    period : ndarray of int32
        In mesh cycles; 0 where nothing periodic was proved.
    drive, back : ndarray of int32
        Impacts on either side of the first clearance in one period.
    others : ndarray of int32
        Impacts in all further clearances.
    exponent : ndarray of float64
        Largest Lyapunov exponent per unit of τ; NaN where unknown.
    periods : ndarray of int32
        Base periods that the motion was followed.
    status : ndarray of uint8
        Index into `results.STATUSES`.
    certificate : ndarray of uint8
        Index into `results.CERTIFICATES`.
    reasons : mapping of (int, int) to str
        Row and column of every failed pixel, and why it failed.
    complete : bool
        False where the map was stopped early; what is missing has the status `not-computed`.
    message : str
        Why it is not complete.
    fixed : mapping of str to float
        Other parameters that were set, over those of the model.

    Examples
    --------
    >>> import gearlash as gl
    >>> speeds, loads = gl.Axis.even("omega", 0.7, 0.9, 3), gl.Axis.even("load", 0.1, 0.3, 2)
    >>> found = gl.map_plane(gl.load_case("kahraman-singh"), speeds, loads)
    >>> found.shape, str(found.label_at(0, 2)), found.impact_free.tolist()
    ((2, 3), '1-1-0', [[True, True, False], [True, True, True]])
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
        """The label of a pixel.

        Parameters
        ----------
        row, column : int
            Index of the value of ``y``, and of that of ``x``.

        Returns
        -------
        Signature or MotionKind or None
            None where there is no motion.
        """
        code = int(self.label[row, column])
        return None if code == NO_LABEL else self.labels[code]


def _counted(codes: Array, table: tuple[Named, ...]) -> dict[Named, int]:
    counts = np.bincount(codes.ravel(), minlength=len(table))
    return {name: int(count) for name, count in zip(table, counts, strict=True) if count}
