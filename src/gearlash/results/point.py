"""What a study keeps of one attractor."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from gearlash.system import Label, Record, Status, read_label

Array = NDArray[np.float64]

NAN = float("nan")


def _nothing() -> Array:
    return np.zeros(0)


@dataclass(frozen=True, eq=False, repr=False)
class Point(Record):
    """One attractor at one value of the parameter under study: plain numbers and small arrays, all
    dimensionless.

    ``label`` is the signature P-Q-R of a proved orbit, else aperiodic, neutral or unresolved; None where
    nothing was computed. A text is read as what it stands for. ``period`` (mesh
    cycles), ``drive`` and ``back`` (impacts on either side of the first clearance in it) are 0 where
    nothing periodic was proved, and ``others`` has the same pair of every further clearance; ``leading``
    is the multiplier of largest modulus. ``certificate`` is certified, uncertain or failed, or empty
    where nothing was computed, and ``certificate_reason`` says why. ``state`` (n,) at phase zero starts
    other computations.

    Of the first clearance, over one period, or over 200 base periods of another motion: ``strobes`` X on
    σ_t; contact force Φ (positive where the drive side is compressed) and phase (mesh cycles from zero) of
    the impacts on either side (S2 → S1, S2 → S3) and of the releases of the back side (S3 → S2); extremes
    of X, of Φ and its rms, share of time without contact (0 to 1). Stored columns of these forces hold −Φ
    (`results.forces`).
    """

    _printed: ClassVar = (
        "value",
        "label",
        "status",
        "certificate",
        "largest_exponent",
        "minimum",
        "maximum",
        "state",
        "message",
    )

    value: float
    status: Status
    message: str
    label: Label | None = None
    period: int = 0
    drive: int = 0
    back: int = 0
    largest_exponent: float = NAN
    exponent_error: float = NAN
    leading: complex = complex(NAN, NAN)
    residual: float = NAN
    periods_used: int = 0
    state: Array = field(default_factory=_nothing)
    strobes: Array = field(default_factory=_nothing)
    drive_force: Array = field(default_factory=_nothing)
    drive_phase: Array = field(default_factory=_nothing)
    back_force: Array = field(default_factory=_nothing)
    back_phase: Array = field(default_factory=_nothing)
    back_release_force: Array = field(default_factory=_nothing)
    back_release_phase: Array = field(default_factory=_nothing)
    minimum: float = NAN
    maximum: float = NAN
    force_min: float = NAN
    force_max: float = NAN
    force_rms: float = NAN
    share_without_contact: float = NAN
    others: tuple[tuple[int, int], ...] = ()
    certificate: str = ""
    certificate_reason: str = ""

    def __post_init__(self) -> None:
        if isinstance(self.label, str):
            object.__setattr__(self, "label", read_label(self.label))
        super().__post_init__()

    @property
    def periodic(self) -> bool:
        """A proved periodic orbit?"""
        return self.period > 0

    @property
    def computed(self) -> bool:
        """Is there a motion here at all, periodic or not?"""
        return self.status.computed

    @property
    def impact_free(self) -> bool:
        """A proved orbit without any impact, in any clearance?"""
        return self.periodic and self.drive == 0 and self.back == 0 and self.other_impacts == 0

    @property
    def other_impacts(self) -> int:
        """Impacts in all further clearances together, in one period."""
        return sum(drive + back for drive, back in self.others)

    @property
    def drive_side_only(self) -> bool:
        """A proved orbit without an impact on the back side of any clearance?"""
        return self.periodic and self.back == 0 and not any(back for _, back in self.others)

    def at(self, value: float) -> Point:
        """The same, with the value of the parameter."""
        return replace(self, value=float(value))


def blank(value: float, status: Status, message: str) -> Point:
    """A point of which nothing is known but why."""
    failed = status is Status.FAILED
    return Point(
        float(value), status, message,
        certificate="failed" if failed else "", certificate_reason=message if failed else "",
    )  # fmt: skip


def not_computed(values: Iterable[float], reason: str) -> Iterator[Point]:
    """Blank points of what was stopped before. They share all but the value: there may be a hundred thousand,
    and whoever stopped a study waits for them."""
    pattern = blank(0.0, Status.NOT_COMPUTED, reason)
    for value in values:
        point, parts = object.__new__(Point), pattern.__dict__.copy()
        parts["value"] = float(value)
        object.__setattr__(point, "__dict__", parts)
        yield point
