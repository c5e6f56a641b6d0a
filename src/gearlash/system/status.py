"""What a result says about itself, and what to do about it."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from enum import StrEnum


class GearlashError(Exception):
    """Any error that gearlash raises on purpose; its text says what to change."""


class UnknownNameError(GearlashError):
    """A name that does not exist here; the text offers the nearest that does."""

    def __init__(self, what: str, name: str, valid: Iterable[str]):
        self.name, self.valid = name, sorted(valid)
        near = difflib.get_close_matches(name, self.valid, n=1, cutoff=0.4)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        super().__init__(f"unknown {what} {name!r}{hint} (valid: {', '.join(self.valid)})")


class Status(StrEnum):
    """Outcome of a computation. Only ``OK`` is a result to rely on without reading on."""

    OK = "ok"
    UNCERTAIN = "uncertain"
    UNRESOLVED = "unresolved"
    NOT_CONVERGED = "not-converged"
    TOO_MANY_EVENTS = "too-many-events"
    DIVERGED = "diverged"
    NOT_ADMISSIBLE = "not-admissible"
    NOT_FOUND = "not-found"

    @property
    def advice(self) -> str:
        """What a person can do about this status."""
        return _ADVICE[self]

    @property
    def ok(self) -> bool:
        return self is Status.OK


_ADVICE = {
    Status.OK: "nothing to do",
    Status.UNCERTAIN: "a contact lies within rounding of touching: move a parameter by 1e-9 of itself, "
    "or locate the grazing point itself (gearlash graze)",
    Status.UNRESOLVED: "no periodic motion was proved within the budget and the exponent does not settle it: "
    "allow more periods (--periods) or a larger period (--max-period)",
    Status.NOT_CONVERGED: "Newton's method did not converge: start nearer to the solution",
    Status.TOO_MANY_EVENTS: "more contacts in one cell than the buffers hold: check gap and stiffness "
    "for extreme values",
    Status.DIVERGED: "the state grew beyond every bound or became NaN: check damping and stiffness signs",
    Status.NOT_ADMISSIBLE: "the point solves the equations, but the orbit crosses a boundary elsewhere "
    "than assumed: start from an orbit nearer to the grazing point",
    Status.NOT_FOUND: "nothing was found in the interval: widen it or change the starting orbit",
}
