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

LEAST = 1e-200  # a leading multiplier below it has lost digits in the product of its maps
FASTER = 0.999  # a multiplier below it is far from the unit circle
SAMPLE = 200  # base periods of an aperiodic motion that are kept as its picture


@dataclass(frozen=True, eq=False, repr=False)
class Orbit(Record):
    """A periodic orbit, ``state`` (n,) at phase zero. One that `attractor` returns has a residual of at most
    1e-11 and its least period, and is stable; one made by hand is what it is made from: ask `residual` and
    `status`.
    """

    _printed: ClassVar = ("label", "status", "period", "residual", "leading", "state", "message")

    propagators: Propagators
    shot: Shot
    periods_used: int
    status: Status
    message: str

    @property
    def state(self) -> NDArray[np.float64]:
        return self.shot.state

    @property
    def final_state(self) -> NDArray[np.float64]:
        return self.shot.state

    @property
    def period(self) -> int:
        """Least period in mesh cycles."""
        return self.shot.period * self.propagators.system.cycles

    @property
    def residual(self) -> float:
        return self.shot.residual

    @cached_property
    def trace(self) -> Trace:
        """The whole orbit as exact pieces."""
        return flow.trace(self.propagators, self.state, float(self.period))

    @property
    def events(self) -> Events:
        return self.trace.events

    @property
    def extrema(self) -> Extrema:
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
        return abs(self.leading) < 1.0

    @property
    def attracts(self) -> bool:
        """Whether it is stable by more than rounding: neighbours come closer."""
        return self.stable and (abs(self.leading) < FASTER or not is_neutral(self.shot.monodromy))

    @cached_property
    def exponents(self) -> NDArray[np.float64]:
        """Lyapunov exponents (n,) per unit of τ: ln|μ|/(P T), exact on a periodic orbit, also where a
        multiplier is less than the least float."""
        return self._spectrum[1] / self.duration

    @property
    def largest_exponent(self) -> float:
        size = abs(self.leading)
        return float(np.log(size) / self.duration if size > LEAST else self.exponents[0])

    @property
    def exponent_error(self) -> float:
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
    """A motion that does not repeat, so that it has no P. Either its largest exponent is above zero by more
    than its error bar (chaos), or it is zero within it (quasi-periodic motion); either way the motion was
    seen to persist. A chaotic transient longer than ``periods_used`` looks the same. ``undecided`` counts the
    contacts of the search that lay within rounding of touching."""

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
        return self.trace.events

    @property
    def extrema(self) -> Extrema:
        return self.trace.extrema

    @cached_property
    def strobes(self) -> NDArray[np.float64]:
        """σ_t: states (m, n) of the stretch."""
        return flow.march(self.propagators, self.final_state, SAMPLE).states[:-1]


@dataclass(frozen=True, eq=False)
class Unresolved(Aperiodic):
    """Neither proved periodic nor shown aperiodic within the budget; `message` says what is known."""

    @property
    def label(self) -> Label:
        return MotionKind.UNRESOLVED

    @cached_property
    def certificate(self) -> Certificate:
        """Never `certified`: says why."""
        return certify_unsettled(self.status, self.message)


@dataclass(frozen=True, eq=False, repr=False)
class Neutral(Aperiodic):
    """A motion whose neighbours neither come closer nor leave: one of a continuum, which the start decides.
    `message` says by which sign it was told."""

    @property
    def label(self) -> Label:
        return MotionKind.NEUTRAL

    @cached_property
    def certificate(self) -> Certificate:
        """Never `certified`: says why."""
        return certify_unsettled(self.status, self.message)


Attractor = Orbit | Aperiodic | Neutral | Unresolved
