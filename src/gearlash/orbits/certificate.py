"""What the program vouches for: the certificate of an attractor.

An orbit is certified where everything that is said of it holds for every motion within the error of its
state: it closes, its period is the least, no contact was undecided, no extremum lies within the error of a
boundary that it could touch (so its signature is right), and its leading multiplier lies on its side of the
unit circle. The error of the state is what residual and rounding become through the variational flow and all
its returns, component by component, at places that the motion names (so it is the same wherever phase zero
lies), times a margin for what happens between them and for terms of second order."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from gearlash.flow import Events, Propagators, Trace
from gearlash.system import CARRIED, Clearance, ContactRule, Named, Record, Status

from .contact_force import least_force
from .extrema import gap_extrema
from .shooting import TOLERANCE, Shot
from .tangents import Tangents, norms, round_orbit

Array = NDArray[Any]
MARGIN = 10.0  # on the error of the state
OWN_ROUNDING = 1e-14  # of a whole period's map, relative to 1 + its norm


class Verdict(Named):
    """What a certificate comes to."""

    CERTIFIED = "certified"
    """Everything that is said of the motion holds within its error."""
    UNCERTAIN = "uncertain"
    """Something is within the error: the reasons say what, with numbers."""
    FAILED = "failed"
    """There is no motion to speak of: it does not close, or could not be followed."""


@dataclass(frozen=True, repr=False)
class Certificate(Record):
    """What the program vouches for, of one motion.

    A certified orbit closes, with this signature and this stability: what it says of contacts holds with
    Taylor remainder and rounding bounded, and the error of the state that it is held against is a first-order
    estimate with a margin of ten, not an enclosure. It does not say that there is no other motion.

    Attributes
    ----------
    verdict : Verdict
    reasons : tuple of str
        Why it is not certified, with numbers; empty where it is.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> print(gl.attractor(family.system(), family.start()).certificate)
    certified
    """

    verdict: Verdict
    reasons: tuple[str, ...] = ()

    @property
    def certified(self) -> bool:
        """Whether the verdict is `Verdict.CERTIFIED`."""
        return self.verdict is Verdict.CERTIFIED

    @property
    def reason(self) -> str:
        """All reasons as one text; empty where it is certified."""
        return "; ".join(self.reasons)

    def __str__(self) -> str:
        return f"{self.verdict}: {self.reason}" if self.reasons else str(self.verdict)

    @staticmethod
    def of(reasons: Iterator[str]) -> Certificate:
        """The certificate of a motion against which there are these reasons, or none.

        Parameters
        ----------
        reasons : iterable of str

        Returns
        -------
        Certificate
            Certified without any reason, else uncertain.
        """
        found = tuple(reasons)
        return Certificate(Verdict.UNCERTAIN if found else Verdict.CERTIFIED, found)


@dataclass(frozen=True, eq=False)
class Closed:
    """What of a periodic orbit is examined."""

    propagators: Propagators
    shot: Shot
    trace: Trace
    strobes: Array
    leading: complex

    @property
    def state(self) -> Array:
        return self.shot.state

    @property
    def events(self) -> Events:
        return self.trace.events

    @property
    def period(self) -> int:
        """In mesh cycles."""
        return self.shot.period * self.propagators.system.cycles


def certify_orbit(residual: float, orbit: Callable[[], Closed]) -> Certificate:
    """The certificate of a periodic orbit, which is asked for only where it closes. `failed` where it does
    not, or could not be followed."""
    if not residual <= TOLERANCE:
        return Certificate(
            Verdict.FAILED, (f"the orbit does not close: residual {residual:.0e} is above {TOLERANCE:.0e}",)
        )
    examined = _Examined(orbit())
    status = examined.orbit.trace.status
    if status not in CARRIED:
        return Certificate(Verdict.FAILED, (f"the orbit could not be followed: {status}",))
    return Certificate.of(examined.doubts())


def certify_unsettled(status: Status, message: str) -> Certificate:
    """The certificate of a motion of which nothing was settled: `failed`, or `uncertain` at best."""
    if status not in (*CARRIED, Status.UNRESOLVED, Status.NEUTRAL):
        return Certificate(Verdict.FAILED, (message,))
    return Certificate(Verdict.UNCERTAIN, (message,))


def certify_aperiodic(
    status: Status, message: str, undecided: Callable[[], int], exponent: float, error: float
) -> Certificate:
    """The certificate of a motion whose exponent settled that it is not periodic; ``undecided`` counts its
    contacts within rounding of touching."""
    unsettled = certify_unsettled(status, message)
    if unsettled.verdict is Verdict.FAILED:
        return unsettled
    return Certificate.of(_doubts_of_motion(undecided(), status, exponent, error))


def _doubts_of_motion(undecided: int, status: Status, exponent: float, error: float) -> Iterator[str]:
    if undecided or status is Status.UNCERTAIN:
        yield f"{undecided or 'some'} of the contacts examined lie within rounding of touching"
    if not abs(exponent) > error:
        yield f"largest exponent {exponent:.1e} is zero within its error {error:.0e}"


class Late(NamedTuple):
    """Of every contact event: the place just after it; column (m, n) and rows (m, 2, n), in units of the size
    of each component, of the change of the field that acts for the error of its time."""

    after: NDArray[np.int64]
    columns: Array
    rows: Array


@dataclass(frozen=True, eq=False)
class _Examined:
    """A closed orbit under examination: each method yields reasons against it."""

    orbit: Closed

    def doubts(self) -> Iterator[str]:
        if not np.isfinite(self.error):
            yield "the error of the orbit is not bounded: a multiplier lies at 1 within rounding"
            return
        yield from self.of_period()
        yield from self.of_contacts()
        for index, clearance in enumerate(self.orbit.propagators.system.clearances):
            yield from self.of_boundaries(index, clearance)
            yield from self.of_forces(index, clearance)
            yield from self.of_events(index, clearance)
        yield from self.of_stability()

    @cached_property
    def tangents(self) -> Tangents:
        return round_orbit(self.orbit.trace, self.orbit.state)

    @cached_property
    def errors(self) -> Array:
        """Error (m, n) of each component of the state at the places of `tangents`."""
        try:
            return MARGIN * self.tangents.deviations * self.tangents.size
        except np.linalg.LinAlgError:
            return np.full((len(self.tangents.places), len(self.orbit.state)), np.inf)

    @cached_property
    def reach(self) -> Array:
        """Error (n,) of each component anywhere along the orbit."""
        return self.errors.max(axis=0)

    @property
    def error(self) -> float:
        """The largest of `reach`."""
        return float(self.reach.max())

    def of_period(self) -> Iterator[str]:
        period, strobes = self.orbit.shot.period, self.orbit.strobes
        for divisor in (d for d in range(1, period) if period % d == 0):
            apart, allowed = (
                np.abs(np.roll(strobes, -divisor, axis=0) - strobes).max(axis=0),
                2.0 * self.reach,
            )
            if np.all(apart <= allowed):
                i = int(np.argmax(apart))
                yield (
                    f"after {divisor} of {period} base periods it returns to {apart[i]:.0e}, within the "
                    f"error {allowed[i]:.0e}"
                )

    def of_contacts(self) -> Iterator[str]:
        undecided = self.orbit.trace.undecided
        if undecided or self.orbit.shot.status is Status.UNCERTAIN:
            yield f"{undecided or 'some'} of its contacts lie within rounding of touching"

    def of_boundaries(self, index: int, clearance: Clearance) -> Iterator[str]:
        extrema = gap_extrema(self.orbit.trace, index)
        allowed = float(np.abs(clearance.h) @ self.reach)
        for boundary, edge in ((1, clearance.gap_plus), (-1, -clearance.gap_minus)):
            if not clearance.stops(boundary):
                continue
            away = np.abs(extrema.displacement - edge)
            for i in np.flatnonzero(away <= allowed):
                what = "minimum" if extrema.curvature[i] > 0.0 else "maximum"
                sign = "+D" if boundary > 0 else "-D"
                yield (
                    f"{what} of X{self.named(clearance)} is {away[i]:.0e} from {sign}, within the error "
                    f"{allowed:.0e}"
                )

    def of_forces(self, index: int, clearance: Clearance) -> Iterator[str]:
        """With the rule `no-tension`: the force where contact could be lost, or come back."""
        if clearance.contact is not ContactRule.NO_TENSION:
            return
        least, allowed = least_force(self.orbit.trace, index), float(self.strength(clearance) @ self.reach)
        if least <= allowed:
            yield (
                f"the force{self.named(clearance)} comes to {least:.0e} of zero, within the error "
                f"{allowed:.0e}"
            )

    def of_events(self, index: int, clearance: Clearance) -> Iterator[str]:
        chosen = self.orbit.events.clearance == index
        if not chosen.any():
            return
        speeds = np.abs(self.orbit.events.velocity[chosen])
        moving = np.abs(clearance.h @ self.orbit.propagators.system.matrix)
        allowed = self.errors[self.late.after[chosen]] @ moving
        i = int(np.argmin(speeds - allowed))
        if speeds[i] <= allowed[i]:
            yield (
                f"a boundary{self.named(clearance)} is crossed with X' = {speeds[i]:.0e}, within the error "
                f"{allowed[i]:.0e}"
            )

    def of_stability(self) -> Iterator[str]:
        """A simple multiplier moves by what the change of the maps does to its own direction, a double one
        with the root of the change of the matrix; the multipliers are those of every place."""
        first, away = self.tangents.calmest, abs(abs(self.orbit.leading) - 1.0)
        matrix, late = self.tangents.returns[first], self.late
        ahead, behind = self.tangents.from_place(first)
        k = (late.after - first) % len(self.tangents.places)
        norm = 1.0 + float(norms(matrix[None])[0])
        columns = np.abs(behind[k] @ late.columns[:, :, None]).max(axis=(1, 2))
        change = float(columns @ np.abs(late.rows @ ahead[k]).sum(axis=(1, 2)))
        double = 2.0 * float(np.sqrt(norm * (OWN_ROUNDING * norm + change)))
        if away > double:
            return
        allowed = min(self.of_direction(matrix, ahead, behind, first), double)
        if not away > allowed:
            yield f"leading multiplier is {away:.0e} from modulus 1, within its error {allowed:.0e}"

    def of_direction(self, matrix: Array, ahead: Array, behind: Array, first: int) -> float:
        """Change of the leading multiplier to first order, by its left and right eigenvectors: G. Golub and
        C. Van Loan, Matrix Computations, 4th ed. (2013), sect. 7.2.2."""
        values, right = np.linalg.eig(matrix)
        i = int(np.argmax(np.abs(values)))
        try:
            left = np.linalg.inv(right)[i]  # left · right[:, i] = 1
        except np.linalg.LinAlgError:
            return np.inf
        x, y, late = ahead @ right[:, i], left @ behind, self.late
        k = (late.after - first) % len(self.tangents.places)
        factors = np.abs(np.roll(self.tangents.factors, -first, axis=0))
        size = np.einsum("ki,kij,kj->k", np.abs(y[1:]), factors, np.abs(x[:-1]))
        size += (np.abs(y[1:]) * np.abs(x[1:])).sum(axis=1)
        shifts = np.abs((y[k] * late.columns).sum(axis=1)) * np.abs(late.rows @ x[k][:, :, None]).sum(
            axis=(1, 2)
        )
        return MARGIN * float(np.roll(self.tangents.rounding, -first) @ size) + float(shifts.sum())

    @cached_property
    def late(self) -> Late:
        """Of every contact (m,), by how much it comes earlier or later within the error."""
        orbit, events, size = self.orbit, self.orbit.events, self.tangents.size
        places, clearances = self.tangents.places, orbit.propagators.system.clearances
        after = np.searchsorted(places, events.phase % orbit.period, side="right") % len(places)
        rows = np.array(
            [_strengths(c)[:, None] * [c.h, c.h @ orbit.propagators.system.matrix] for c in clearances]
        )
        time = np.array([np.abs(c.h) for c in clearances])[events.clearance] * self.errors[after]
        late = time.sum(axis=1) / np.maximum(np.abs(events.velocity), 1e-300)
        columns = np.array([c.g for c in clearances])[events.clearance] * late[:, None]
        return Late(after, columns / size, rows[events.clearance] * size)

    def strength(self, clearance: Clearance) -> Array:
        """Bound (n,) on |∂Φ/∂z|."""
        rows = np.array([clearance.h, clearance.h @ self.orbit.propagators.system.matrix])
        return _strengths(clearance) @ np.abs(rows)

    def named(self, clearance: Clearance) -> str:
        return f" ({clearance.name})" if len(self.orbit.propagators.system.clearances) > 1 else ""


def _strengths(clearance: Clearance) -> Array:
    """Peak stiffness and damping (2,)."""
    peak = max(float(np.abs(s).sum()) for s in (clearance.stiffness_plus, clearance.stiffness_minus))
    return np.array([peak, max(map(abs, clearance.dampings))])
