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
    """One attractor at one value of the parameter under study.

    Plain numbers and small arrays, all dimensionless. Sections, forces and phases are those of the first
    clearance, over one period of an orbit or over 200 base periods of another motion. Files hold −Φ in the
    columns of the forces of sections (`results.forces`).

    Attributes
    ----------
    value : float
        Of the parameter; NaN where none was named.
    status : Status
        To be read first.
    message : str
        How the attractor was found, or why it was not.
    label : Signature or MotionKind, optional
        P-Q-R of a proved orbit, else aperiodic, neutral or unresolved; None where nothing was computed. A
        text is read as what it stands for.
    period : int
        In mesh cycles; 0 where nothing periodic was proved.
    drive, back : int
        Impacts on either side in one period; 0 where nothing periodic was proved.
    largest_exponent, exponent_error : float
        Lyapunov exponent per unit of τ, and the half-width of its 95 % interval.
    leading : complex
        Multiplier of largest modulus; NaN without an orbit.
    residual : float
        By how much the orbit misses to close; see `Shot`.
    periods_used : int
        Base periods that the motion was followed.
    state : ndarray of shape (n,)
        At phase zero; starts other computations.
    strobes : ndarray of shape (P,)
        X on σ_t.
    drive_force, drive_phase : ndarray of shape (m,)
        Contact force Φ, positive where the drive side is compressed, and phase in mesh cycles of the impacts
        on the drive side (S2 → S1).
    back_force, back_phase : ndarray of shape (m,)
        The same of impacts on the back side (S2 → S3).
    back_release_force, back_release_phase : ndarray of shape (m,)
        The same of releases of the back side (S3 → S2).
    minimum, maximum : float
        Extremes of X.
    force_min, force_max, force_rms : float
        Extremes of Φ, and the root of its mean square.
    share_without_contact : float
        Of the time, 0 to 1.
    others : tuple of (int, int)
        Impacts on either side of every further clearance.
    certificate : str
        Certified, uncertain or failed; empty where nothing was computed.
    certificate_reason : str
        Why it is not certified.

    Examples
    --------
    >>> import gearlash as gl
    >>> found = gl.point(gl.load_case("kahraman-singh"), {"omega": 0.9}, name="omega")
    >>> found.value, str(found.status), str(found.label), found.impact_free
    (0.9, 'ok', '1-1-0', False)
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
        """Whether it is a proved periodic orbit."""
        return self.period > 0

    @property
    def computed(self) -> bool:
        """Whether there is a motion here at all, periodic or not."""
        return self.status.computed

    @property
    def impact_free(self) -> bool:
        """Whether it is a proved orbit without any impact, in any clearance."""
        return self.periodic and self.drive == 0 and self.back == 0 and self.other_impacts == 0

    @property
    def other_impacts(self) -> int:
        """Impacts in all further clearances together, in one period."""
        return sum(drive + back for drive, back in self.others)

    @property
    def drive_side_only(self) -> bool:
        """Whether it is a proved orbit without an impact on the back side of any clearance."""
        return self.periodic and self.back == 0 and not any(back for _, back in self.others)

    def at(self, value: float) -> Point:
        """The same point with another value of the parameter.

        Parameters
        ----------
        value : float

        Returns
        -------
        Point
        """
        return replace(self, value=float(value))


def blank(value: float, status: Status, message: str) -> Point:
    """A point of which only the reason is known why there is no motion."""
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
