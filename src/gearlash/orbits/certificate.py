"""What the program vouches for: the certificate of an attractor.

An orbit is certified where everything that is said of it holds for every motion within the error of its
state: it closes, its period is the least, no contact was undecided, no extremum lies within the error of a
boundary that it could touch (so its signature is right), and its leading multiplier lies on its side of the
unit circle. The error of the state is that of the shot (residual and rounding, through the inverse of DP - I)
times the growth of the variational flow, sampled along the orbit, times a margin for what happens between the
samples and for terms of second order."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.system import Clearance, ContactRule, Record, Status

from .grazing import gap_extrema
from .pressing import least_force
from .shooting import TOLERANCE

if TYPE_CHECKING:
    from .results import Aperiodic, Orbit

Array = NDArray[Any]
MARGIN = 10.0  # on the error of the state
SAMPLES = 8  # of the variational flow, a base period at most and half of one at least apart
ROUNDING = 1e-14  # of the monodromy, relative to 1 + its norm
MOVING = (Status.OK, Status.UNCERTAIN)


class Verdict(StrEnum):
    """Of a certificate."""

    CERTIFIED = "certified"
    UNCERTAIN = "uncertain"
    FAILED = "failed"


@dataclass(frozen=True, repr=False)
class Certificate(Record):
    """``verdict``, and ``reasons`` with their numbers why it is not `certified`."""

    verdict: Verdict
    reasons: tuple[str, ...] = ()

    @property
    def certified(self) -> bool:
        return self.verdict is Verdict.CERTIFIED

    @property
    def reason(self) -> str:
        """All reasons as one text; empty where it is certified."""
        return "; ".join(self.reasons)

    def __str__(self) -> str:
        return f"{self.verdict}: {self.reason}" if self.reasons else str(self.verdict)

    @staticmethod
    def of(reasons: Iterator[str]) -> Certificate:
        """Certified where there is no reason against it."""
        found = tuple(reasons)
        return Certificate(Verdict.UNCERTAIN if found else Verdict.CERTIFIED, found)


def certify_orbit(orbit: Orbit) -> Certificate:
    """The certificate of a periodic orbit. `failed` where it does not close or could not be followed."""
    if not orbit.residual <= TOLERANCE:
        return Certificate(
            Verdict.FAILED,
            (f"the orbit does not close: residual {orbit.residual:.0e} is above {TOLERANCE:.0e}",),
        )
    if orbit.trace.status not in MOVING:
        return Certificate(Verdict.FAILED, (f"the orbit could not be followed: {orbit.trace.status}",))
    return Certificate.of(_Examined(orbit).doubts())


def certify_motion(motion: Aperiodic, resolved: bool) -> Certificate:
    """The certificate of a motion that is not proved periodic; ``resolved``: its exponent settled it."""
    if motion.status not in (*MOVING, Status.UNRESOLVED, Status.NEUTRAL):
        return Certificate(Verdict.FAILED, (motion.message,))
    if not resolved:
        return Certificate(Verdict.UNCERTAIN, (motion.message,))
    return Certificate.of(_doubts_of_motion(motion))


def _doubts_of_motion(motion: Aperiodic) -> Iterator[str]:
    undecided = motion.undecided + motion.trace.undecided
    if undecided or motion.status is Status.UNCERTAIN:
        yield f"{undecided or 'some'} of the contacts examined lie within rounding of touching"
    value, error = motion.largest_exponent, motion.exponent_error
    if not abs(value) > error:
        yield f"largest exponent {value:.1e} is zero within its error {error:.0e}"


@dataclass(frozen=True, eq=False)
class _Examined:
    """A closed orbit under examination: each method yields reasons against it."""

    orbit: Orbit

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
    def products(self) -> tuple[Array, Array]:
        """Norms (samples+1,) of the variational flow from the start to places along the orbit, and from there
        to its end."""
        period, system = self.orbit.shot.period, self.orbit.propagators.system
        parts = max(1, min(2, SAMPLES // period))
        z, length, factors = self.orbit.state, system.cycles / parts, []
        for part in range(period * parts):
            step = flow.variational(self.orbit.propagators, z, length, part % parts * length)
            assert step.jacobian is not None
            factors.append(step.jacobian)
            z = step.state
        ahead, behind = [np.eye(len(z))], [np.eye(len(z))]
        for first, last in zip(factors, reversed(factors), strict=True):
            ahead.append(first @ ahead[-1])
            behind.append(behind[-1] @ last)
        return _norms(ahead), _norms(behind[::-1])

    @cached_property
    def error(self) -> float:
        """Bound on the error of the state (∞-norm) anywhere along the orbit."""
        return MARGIN * float(self.products[0].max()) * self.orbit.shot.error

    def of_period(self) -> Iterator[str]:
        period, strobes = self.orbit.shot.period, self.orbit.strobes
        for divisor in (d for d in range(1, period) if period % d == 0):
            apart = float(np.abs(strobes[divisor] - strobes[0]).max())
            if apart <= 2.0 * self.error:
                yield (
                    f"after {divisor} of {period} base periods it returns to {apart:.0e}, within the error "
                    f"{2.0 * self.error:.0e}"
                )

    def of_contacts(self) -> Iterator[str]:
        undecided = self.orbit.trace.undecided
        if undecided or self.orbit.shot.status is Status.UNCERTAIN:
            yield f"{undecided or 'some'} of its contacts lie within rounding of touching"

    def of_boundaries(self, index: int, clearance: Clearance) -> Iterator[str]:
        extrema = gap_extrema(self.orbit.trace, index)
        allowed = float(np.abs(clearance.h).sum()) * self.error
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
        least, allowed = least_force(self.orbit.trace, index), self.strength(clearance) * self.error
        if least <= allowed:
            yield (
                f"the force{self.named(clearance)} comes to {least:.0e} of zero, within the error "
                f"{allowed:.0e}"
            )

    def of_events(self, index: int, clearance: Clearance) -> Iterator[str]:
        speed = self.speeds(index).min(initial=np.inf)
        allowed = float(np.abs(clearance.h @ self.orbit.propagators.system.matrix).sum()) * self.error
        if speed <= allowed:
            yield (
                f"a boundary{self.named(clearance)} is crossed with X' = {speed:.0e}, within the error "
                f"{allowed:.0e}"
            )

    def of_stability(self) -> Iterator[str]:
        norm = 1.0 + float(_norms([self.orbit.shot.monodromy])[0])
        change = ROUNDING * norm + self.shift()
        # a double multiplier moves with the root of what changes the matrix
        double, away = 2.0 * float(np.sqrt(norm * change)), abs(abs(self.orbit.leading) - 1.0)
        if away > double:
            return
        allowed = min(_condition(self.orbit.shot.monodromy) * change, double)
        if not away > allowed:
            yield f"leading multiplier is {away:.0e} from modulus 1, within its error {allowed:.0e}"

    def shift(self) -> float:
        """Change of the monodromy by the error of the state: every contact comes earlier or later, and with
        it the change of the field that it makes."""
        ahead, behind = self.products
        total = 0.0
        for index, clearance in enumerate(self.orbit.propagators.system.clearances):
            speeds = self.speeds(index)
            if len(speeds):
                late = float(np.abs(clearance.h).sum() * np.sum(1.0 / np.maximum(speeds, 1e-300)))
                total += float(np.abs(clearance.g).max()) * self.strength(clearance) * late
        return float((ahead * behind).max()) * total * self.error

    def speeds(self, index: int) -> Array:
        """|X'| at the contact events of a clearance."""
        events = self.orbit.events
        return np.abs(events.velocity[events.clearance == index])

    def strength(self, clearance: Clearance) -> float:
        """Bound on |∂Φ/∂z|: peak stiffness and damping."""
        peak = max(float(np.abs(s).sum()) for s in (clearance.stiffness_plus, clearance.stiffness_minus))
        matrix = self.orbit.propagators.system.matrix
        damping = max(map(abs, clearance.dampings)) * float(np.abs(clearance.h @ matrix).sum())
        return peak * float(np.abs(clearance.h).sum()) + damping

    def named(self, clearance: Clearance) -> str:
        return f" ({clearance.name})" if len(self.orbit.propagators.system.clearances) > 1 else ""


def _norms(matrices: list[Array]) -> Array:
    """∞-norms."""
    return np.abs(np.array(matrices)).sum(axis=2).max(axis=1)


def _condition(matrix: Array) -> float:
    """Condition number 1/|yᴴx| of the eigenvalue of largest modulus: G. Golub and C. Van Loan, Matrix
    Computations, 4th ed. (2013), sect. 7.2.2."""
    values, right = np.linalg.eig(matrix)
    i = int(np.argmax(np.abs(values)))
    try:
        left = np.linalg.inv(right)[i]  # right[:, i] has length 1
    except np.linalg.LinAlgError:
        return np.inf
    return float(np.linalg.norm(left))
