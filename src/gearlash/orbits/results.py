"""What an attractor turns out to be."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Events, Extrema, Propagators, Trace
from gearlash.system import Label, MotionKind, Record, Signature, Status

from . import floquet
from .certificate import Certificate, Closed, certify_aperiodic, certify_orbit, certify_unsettled
from .neutral import is_neutral
from .shooting import Shot

LEAST_MULTIPLIER = 1e-200  # a leading multiplier below it has lost digits in the product of its maps
FAR_INSIDE = 0.999  # a multiplier below it is far from the unit circle
SAMPLE = 200  # base periods of an aperiodic motion that are kept as its picture


@dataclass(frozen=True, eq=False, repr=False)
class Orbit(Record):
    """A periodic orbit, stable or not.

    One that `attractor` returns has a residual of at most 1e-11 and its least period, and is stable. One made
    by hand is what it is made from: ask `residual` and `status`.

    Attributes
    ----------
    propagators : Propagators
        Of its system.
    shot : Shot
        State, period, residual and monodromy.
    periods_used : int
        Base periods that the motion was followed until it was found; 0 where none was.
    status : Status
        Uncertain where a contact lies within rounding of touching.
    message : str
        How it was found.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> orbit = gl.attractor(family.system({"omega": 0.9}), family.start())
    >>> orbit.signature.short, orbit.period, orbit.stable, len(orbit.events)
    ('1-1', 1, True, 2)
    >>> abs(orbit.multipliers).round(4).tolist()
    [0.7053, 0.7053]
    """

    _printed: ClassVar = ("label", "status", "period", "residual", "leading", "state", "message")

    propagators: Propagators
    shot: Shot
    periods_used: int
    status: Status
    message: str

    @property
    def state(self) -> NDArray[np.float64]:
        """State (n,) at phase zero."""
        return self.shot.state

    @property
    def final_state(self) -> NDArray[np.float64]:
        """The same state, by the name that it has for other motions."""
        return self.shot.state

    @property
    def period(self) -> int:
        """Least period in mesh cycles."""
        return self.shot.period * self.propagators.system.cycles

    @property
    def residual(self) -> float:
        """By how much it misses to close; see `Shot`."""
        return self.shot.residual

    @cached_property
    def trace(self) -> Trace:
        """The whole orbit as exact pieces."""
        return flow.trace(self.propagators, self.state, float(self.period))

    @property
    def events(self) -> Events:
        """Contact events of one period."""
        return self.trace.events

    @property
    def extrema(self) -> Extrema:
        """Extrema of the first gap over one period."""
        return self.trace.extrema

    @cached_property
    def signature(self) -> Signature:
        """P-Q-R, and Q-R of every further clearance."""
        contacts = self.shot.contacts
        if contacts is None:
            contacts = flow.carry(self.propagators, self.state, float(self.period)).contacts
        counts = [(int(drive), int(back)) for drive, back, *_ in contacts.reshape(-1, 4)]
        (drive, back), *others = counts
        return Signature(self.period, drive, back, tuple(others))

    @property
    def label(self) -> Label:
        """Its signature."""
        return self.signature

    @cached_property
    def strobes(self) -> NDArray[np.float64]:
        """σ_t: the states (P, n) at phase zero of every base period."""
        if self.shot.strobes is not None:
            return self.shot.strobes
        if self.shot.period == 1:
            return self.state[None]
        return flow.march(self.propagators, self.state, self.shot.period).states[:-1]

    @cached_property
    def multipliers(self) -> NDArray[np.complex128]:
        """All Floquet multipliers (n,), by modulus, descending."""
        return self._spectrum[0]

    @cached_property
    def _spectrum(self) -> tuple[NDArray[np.complex128], NDArray[np.float64]]:
        return floquet.spectrum(self.propagators, self.state, self.shot.period)

    @cached_property
    def leading(self) -> complex:
        """The multiplier of largest modulus, from the monodromy of the shot."""
        return complex(floquet.ordered(np.linalg.eigvals(self.shot.monodromy))[0])

    @property
    def stable(self) -> bool:
        """Whether all multipliers lie inside the unit circle."""
        return abs(self.leading) < 1.0

    @property
    def attracts(self) -> bool:
        """Whether it is stable by more than rounding: neighbours come closer."""
        return self.stable and (abs(self.leading) < FAR_INSIDE or not is_neutral(self.shot.monodromy))

    @cached_property
    def exponents(self) -> NDArray[np.float64]:
        """Lyapunov exponents (n,) per unit of τ: ln|μ|/(P T), exact on a periodic orbit, also where a
        multiplier is less than the least float."""
        return self._spectrum[1] / self.duration

    @property
    def largest_exponent(self) -> float:
        """The largest of `exponents`."""
        size = abs(self.leading)
        return float(np.log(size) / self.duration if size > LEAST_MULTIPLIER else self.exponents[0])

    @property
    def exponent_error(self) -> float:
        """Zero: the exponents of an orbit come from its multipliers."""
        return 0.0

    @cached_property
    def certificate(self) -> Certificate:
        """Whether all that is said of the orbit holds within its error; see `certificate`."""
        return certify_orbit(self.residual, self._closed)

    def _closed(self) -> Closed:
        """What a certificate examines."""
        return Closed(self.propagators, self.shot, self.trace, self.strobes, self.leading)

    @property
    def duration(self) -> float:
        """Of the whole orbit, in τ."""
        return self.shot.period * self.propagators.system.period


@dataclass(frozen=True, eq=False, repr=False)
class Aperiodic(Record):
    """A motion that does not repeat, so that it has no P.

    Either its largest exponent is above zero by more than its error bar (chaos), or it is zero within it
    (quasi-periodic motion); either way the motion was seen to persist. A chaotic transient longer than
    ``periods_used`` looks the same.

    Attributes
    ----------
    propagators : Propagators
        Of its system.
    final_state : ndarray of shape (n,)
        State at phase zero to which it was followed.
    largest_exponent : float
        Lyapunov exponent per unit of τ; NaN where it was not averaged.
    exponent_error : float
        Half-width of its 95 % interval from batch means.
    periods_used : int
        Base periods that the motion was followed.
    status : Status
        Uncertain where a contact lay within rounding of touching while growth was recorded.
    message : str
        What was found, with numbers.
    undecided : int
        Contacts of the search that lay within rounding of touching.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("shaw-holmes").family()
    >>> found = gl.attractor(family.system({"omega": 0.88}), family.start())
    >>> str(found.label), found.largest_exponent > found.exponent_error
    ('aperiodic', True)
    """

    _printed: ClassVar = ("label", "status", "largest_exponent", "exponent_error", "periods_used", "message")

    propagators: Propagators
    final_state: NDArray[np.float64]
    largest_exponent: float
    exponent_error: float
    periods_used: int
    status: Status
    message: str
    undecided: int = 0

    @property
    def label(self) -> Label:
        """What the motion is called: aperiodic."""
        return MotionKind.APERIODIC

    @cached_property
    def certificate(self) -> Certificate:
        """Whether no contact was in doubt and the exponent stands beyond its error bar."""
        return certify_aperiodic(
            self.status,
            self.message,
            lambda: self.undecided + self.trace.undecided,
            self.largest_exponent,
            self.exponent_error,
        )

    @cached_property
    def trace(self) -> Trace:
        """A stretch of the motion."""
        return flow.trace(self.propagators, self.final_state, float(SAMPLE * self.propagators.system.cycles))

    @property
    def events(self) -> Events:
        """Contact events of the stretch."""
        return self.trace.events

    @property
    def extrema(self) -> Extrema:
        """Extrema of the first gap over the stretch."""
        return self.trace.extrema

    @cached_property
    def strobes(self) -> NDArray[np.float64]:
        """σ_t: states (m, n) of the stretch."""
        return flow.march(self.propagators, self.final_state, SAMPLE).states[:-1]


@dataclass(frozen=True, eq=False)
class Unresolved(Aperiodic):
    """A motion that was neither proved periodic nor shown aperiodic within the budget.

    Attributes
    ----------
    propagators : Propagators
        Of its system.
    final_state : ndarray of shape (n,)
        State at phase zero to which it was followed.
    largest_exponent : float
        Lyapunov exponent per unit of τ; NaN where it was not averaged.
    exponent_error : float
        Half-width of its 95 % interval from batch means.
    periods_used : int
        Base periods that the motion was followed.
    status : Status
        Unresolved, or why the motion could not be carried on.
    message : str
        What is known, and what to do about it.
    undecided : int
        Contacts of the search that lay within rounding of touching.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("shaw-holmes").family()
    >>> found = gl.attractor(family.system({"omega": 0.88}), family.start(), gl.Settings(budget=100))
    >>> str(found.label), str(found.certificate.verdict)
    ('unresolved', 'uncertain')
    """

    @property
    def label(self) -> Label:
        """What the motion is called: unresolved."""
        return MotionKind.UNRESOLVED

    @cached_property
    def certificate(self) -> Certificate:
        """Never `certified`: says why."""
        return certify_unsettled(self.status, self.message)


@dataclass(frozen=True, eq=False, repr=False)
class Neutral(Aperiodic):
    """A motion whose neighbours neither come closer nor leave: one of a continuum, which the start decides.

    Attributes
    ----------
    propagators : Propagators
        Of its system.
    final_state : ndarray of shape (n,)
        State at phase zero to which it was followed.
    largest_exponent : float
        Zero, or its average where that was taken, per unit of τ.
    exponent_error : float
        Half-width of its 95 % interval, or what rounding makes.
    periods_used : int
        Base periods that the motion was followed.
    status : Status
        Neutral.
    message : str
        By which sign it was recognized, and what to do about it.
    undecided : int
        Contacts of the search that lay within rounding of touching.

    Examples
    --------
    >>> import gearlash as gl
    >>> forcing = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
    >>> stop = gl.Clearance([1.0, 0.0], [0.0, -1.0], 50.0, 50.0, 8.0, 8.0)
    >>> undamped = gl.System(1.7, [[0.0, 1.0], [-1.0, 0.0]], forcing, (stop,))
    >>> str(gl.attractor(undamped, [1.0, 0.0]).label)
    'neutral'
    """

    @property
    def label(self) -> Label:
        """What the motion is called: neutral."""
        return MotionKind.NEUTRAL

    @cached_property
    def certificate(self) -> Certificate:
        """Never `certified`: says why."""
        return certify_unsettled(self.status, self.message)


Attractor = Orbit | Aperiodic | Neutral | Unresolved
