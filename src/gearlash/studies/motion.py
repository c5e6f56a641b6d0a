"""A motion as plain numbers: what a figure or a file needs of an attractor, without the kernels behind it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.branches import GrazingPoint
from gearlash.branches.continuation import SpecialPoint
from gearlash.flow import Trace
from gearlash.flow.events import gap_displacement, gap_velocity
from gearlash.orbits import Attractor, Orbit, orbit_at
from gearlash.orbits.grazing import motion_of
from gearlash.system import Family, GearlashError, Label, MotionKind, Record, Status, arguments, given, shown

Array = NDArray[np.float64]

PER_CYCLE = 400  # samples of one mesh cycle: a curve without visible corners at the width of a page
DRAWN_CYCLES = 60  # of an aperiodic motion; more only blackens the picture
TOUCH_WIDTH = (
    1e-3  # mesh cycles around a touch within which a contact is that touch, split in two by rounding
)


@dataclass(frozen=True, repr=False)
class Touch(Record):
    """Where a motion touches a boundary without crossing it.

    Attributes
    ----------
    phase : float
        In mesh cycles.
    displacement : float
        X there.
    velocity : float
        X' there.
    boundary : {1, -1}
        Σ1 or Σ2.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> orbit = gl.attractor(family.system({"omega": 0.8}), family.start())
    >>> gl.motion(orbit, touch=(0.785, 1)).touch.boundary  # nearly: there X comes closest to Σ1
    1
    """

    phase: float
    displacement: float
    velocity: float
    boundary: int


@dataclass(frozen=True, eq=False, repr=False)
class Motion(Record):
    """One period of an orbit, or a stretch of another motion, sampled in one of its gaps.

    All numbers are dimensionless.

    Attributes
    ----------
    omega : float
        Mesh frequency ω.
    gap_plus, gap_minus : float
        D⁺ and D⁻ of the gap.
    label : Signature or MotionKind
    status, message : str
        Of the attractor.
    period : int
        In mesh cycles; 0 where nothing periodic was proved.
    largest_exponent, exponent_error : float
        Lyapunov exponent per unit of τ, and the half-width of its 95 % interval.
    leading : complex
        Multiplier of largest modulus; NaN without an orbit.
    phase : ndarray of shape (N,)
        In mesh cycles from 0: 400 a cycle, and those of all contacts and extrema.
    displacement, velocity, force : ndarray of shape (N,)
        X, X' and Φ at these phases.
    region : ndarray of int, shape (N,)
        0 in contact on the drive side, 1 free, 2 in contact on the back side.
    hit_phase, hit_displacement, hit_velocity : ndarray of shape (m,)
        Contact events: phase in mesh cycles, X and X'.
    hit_boundary : ndarray of int, shape (m,)
        1: Σ1, -1: Σ2.
    hit_engaging : ndarray of bool, shape (m,)
        Whether contact begins.
    strobe_displacement, strobe_velocity : ndarray of shape (P,)
        X and X' at phase zero of every base period.
    value : float
        Of the parameter under study; NaN if there is none.
    touch : Touch, optional
        A grazing in it.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> found = gl.motion(gl.attractor(family.system({"omega": 0.9}), family.start()))
    >>> str(found.label), found.cycles, found.hit_boundary.tolist(), found.hit_engaging.tolist()
    ('1-1-0', 1.0, [1, 1], [True, False])
    """

    _printed: ClassVar = ("label", "status", "value", "period", "omega", "cycles")

    omega: float
    gap_plus: float
    gap_minus: float
    label: Label
    status: Status
    message: str
    period: int
    largest_exponent: float
    exponent_error: float
    leading: complex
    phase: Array
    displacement: Array
    velocity: Array
    force: Array
    region: NDArray[np.int64]
    hit_phase: Array
    hit_displacement: Array
    hit_velocity: Array
    hit_boundary: NDArray[np.int64]
    hit_engaging: NDArray[np.bool_]
    strobe_displacement: Array
    strobe_velocity: Array
    value: float = float("nan")
    touch: Touch | None = None

    @property
    def cycles(self) -> float:
        """Length of the stretch in mesh cycles."""
        return float(self.phase[-1] - self.phase[0])

    @property
    def periodic(self) -> bool:
        """Whether this is one whole period of a proved orbit."""
        return self.period > 0


@arguments
def motion(
    attractor: Attractor,
    *,
    value: float = float("nan"),
    touch: Any = None,
    label: Label | None = None,
    clearance: int = 0,
) -> Motion:
    """The motion of an attractor in one of its gaps, sampled.

    Parameters
    ----------
    attractor : Orbit, Aperiodic, Neutral or Unresolved
        What `attractor` returned: of an orbit one period is sampled, of another motion up to 60 mesh cycles.
    value : float
        Of the parameter under study; only kept.
    touch : (float, int), optional
        Phase in mesh cycles and boundary (1 or -1) of a grazing in it: contacts within a thousandth of a
        cycle there are that touch, split in two by rounding.
    label : Signature or MotionKind, optional
        In place of the attractor's own.
    clearance : int
        Index of the clearance.

    Returns
    -------
    Motion

    Raises
    ------
    GearlashError
        For arguments that do not fit.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> found = gl.motion(gl.attractor(family.system({"omega": 0.8}), family.start()))
    >>> round(float(found.displacement.max()), 4), found.periodic
    (1.1868, True)
    """
    trace = motion_of(attractor).trace
    clearance = trace.which(clearance)
    if touch is not None:
        touch = _pair(touch)
    system, gap = trace.propagators.system, trace.propagators.system.clearances[clearance]
    orbit = attractor if isinstance(attractor, Orbit) else None
    cycles = trace.cycles if orbit else min(trace.cycles, float(DRAWN_CYCLES))
    samples = trace.at(_phases(trace, cycles, clearance), clearance)
    events, strobes = trace.events.of(clearance), attractor.strobes
    hits = _hits(events.phase, trace, cycles, touch)
    at = np.arange(len(strobes), dtype=np.float64) * system.cycles
    return Motion(
        omega=system.omega,
        gap_plus=gap.gap_plus,
        gap_minus=gap.gap_minus,
        label=attractor.label if label is None else label,
        status=attractor.status,
        message=attractor.message,
        period=orbit.period if orbit else 0,
        largest_exponent=float(attractor.largest_exponent),
        exponent_error=float(attractor.exponent_error),
        leading=orbit.leading if orbit else complex("nan"),
        phase=samples.phase,
        displacement=samples.displacement,
        velocity=samples.velocity,
        force=samples.force,
        region=np.asarray(samples.region, dtype=np.int64),
        hit_phase=events.phase[hits],
        hit_displacement=gap_displacement(system, events.phase[hits], events.state[hits], clearance),
        hit_velocity=events.velocity[hits],
        hit_boundary=np.asarray(events.boundary[hits], dtype=np.int64),
        hit_engaging=np.asarray(events.engaging[hits], dtype=np.bool_),
        strobe_displacement=gap_displacement(system, at, strobes, clearance),
        strobe_velocity=gap_velocity(system, at, strobes, clearance),
        value=float(value),
        touch=None if touch is None else _touch(trace, clearance, *touch),
    )


def _pair(touch: Any) -> tuple[float, int]:
    """A phase and a boundary."""
    parts = given.items("touch", touch, "a phase in mesh cycles and a boundary, 1 or -1")
    if len(parts) != 2:
        raise GearlashError(
            f"touch = {shown(touch)}: expected a phase in mesh cycles and a boundary, 1 or -1"
        )
    return given.number("phase of the touch", parts[0]), given.whole("boundary of the touch", parts[1], -1, 1)


def touching(family: Family, point: SpecialPoint | GrazingPoint) -> Motion:
    """The motion at a grazing that was solved for."""
    props, at = flow.propagators(family.system(point.values)), point.touch
    state = point.state_zero if isinstance(point, GrazingPoint) else point.point.state
    orbit = orbit_at(props, state, point.period // props.system.cycles)
    if orbit is None:
        raise GearlashError(f"no orbit at {point.name} = {point.value:.10g}")
    phase = at.phase
    if at.surface == "gap":
        gap, extrema = props.system.clearances[at.clearance], orbit.trace.extrema_of(at.clearance)
        edge = gap.gap_plus if at.boundary > 0 else -gap.gap_minus
        phase = float(extrema.phase[np.argmin(np.abs(extrema.displacement - edge))])
    touch = phase, at.boundary
    found = motion(orbit, value=point.value, touch=touch, label=MotionKind.GRAZING, clearance=at.clearance)
    return replace(found, status=point.status, message=f"touches a boundary: {point.touch_kind}")


def _phases(trace: Trace, cycles: float, clearance: int) -> Array:
    """Equally spaced phases, and those of every contact and extremum: no touch may fall between two."""
    even = np.linspace(0.0, cycles, round(cycles * PER_CYCLE) + 1)
    special = np.concatenate([trace.events.phase, trace.extrema_of(clearance).phase])
    return np.unique(np.concatenate([even, special[(special >= 0.0) & (special <= cycles)]]))


def _hits(phase: Array, trace: Trace, cycles: float, touch: tuple[float, int] | None) -> NDArray[np.int64]:
    """Indices of the contact events of the stretch; a touch is none of them."""
    chosen = phase <= cycles
    if touch is not None:
        away = np.abs((phase - touch[0] + trace.cycles / 2.0) % trace.cycles - trace.cycles / 2.0)
        chosen &= away > TOUCH_WIDTH
    return np.flatnonzero(chosen)


def _touch(trace: Trace, clearance: int, phase: float, boundary: int) -> Touch:
    point = trace.at([phase % trace.cycles], clearance)
    return Touch(float(point.phase[0]), float(point.displacement[0]), float(point.velocity[0]), boundary)
