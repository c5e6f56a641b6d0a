"""What a result says about itself, and what to do about it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from enum import EnumType, StrEnum
from typing import TYPE_CHECKING, Any

from .nearest import nearest
from .short_text import shown


class GearlashError(Exception):
    """Any error that gearlash raises on purpose; its text says what to change.

    It pickles, whatever arguments a subclass is made from: workers send errors to the process that started
    them.
    """

    def __reduce__(self) -> tuple[Callable[..., Any], tuple[Any, ...]]:
        return _made, (type(self), self.args, dict(self.__dict__))


def _made(kind: type[GearlashError], args: tuple[Any, ...], attributes: dict[str, Any]) -> GearlashError:
    error = kind.__new__(kind, *args)
    error.__dict__.update(attributes)
    return error


class UnknownNameError(GearlashError):
    """A name that does not exist here; the text offers the nearest that does, and may say what to do."""

    def __init__(self, what: str, name: object, valid: Iterable[str], instead: str = ""):
        self.name, self.valid = name if isinstance(name, str) else shown(name), sorted(valid)
        near = nearest(name, self.valid)
        hint = f"; did you mean {near!r}?" if near else ""
        super().__init__(f"unknown {what} {shown(name)}{hint} (valid: {', '.join(self.valid)}){instead}")


class BuildError(GearlashError):
    """What a family's own `build` or `cold_start` raised, or returned in place of a system or a state."""


class _ByName(EnumType):
    def __call__(cls, value: object, *more: Any, **others: Any) -> Any:
        if not isinstance(value, str) or value not in cls._value2member_map_:
            raise UnknownNameError(cls.__name__, value, [str(each) for each in cls._value2member_map_])
        return super().__call__(value, *more, **others)


if TYPE_CHECKING:  # which know the values of a plain StrEnum only
    from enum import StrEnum as Named
else:

    class Named(StrEnum, metaclass=_ByName):
        """A choice out of a few names; another one is refused in words."""


class Status(Named):
    """Outcome of a computation; only ``OK`` is a result to rely on without reading on."""

    OK = "ok"
    UNCERTAIN = "uncertain"
    UNRESOLVED = "unresolved"
    NEUTRAL = "neutral"
    INEXACT = "inexact"
    NOT_CONVERGED = "not-converged"
    TOO_MANY_EVENTS = "too-many-events"
    DIVERGED = "diverged"
    NOT_ADMISSIBLE = "not-admissible"
    NOT_FOUND = "not-found"
    FAILED = "failed"
    NOT_COMPUTED = "not-computed"

    @property
    def advice(self) -> str:
        """What a person can do about this status."""
        return _ADVICE[self]

    @property
    def ok(self) -> bool:
        """Whether it is ``OK``."""
        return self is Status.OK

    @property
    def computed(self) -> bool:
        """Whether there is a result at all: nothing failed, and no study was stopped before it."""
        return self not in (Status.FAILED, Status.NOT_COMPUTED)


CARRIED = (Status.OK, Status.UNCERTAIN)
"""What is said of a motion that was carried to its end: without doubt, or with a contact in doubt."""

_ADVICE = {
    Status.OK: "nothing to do",
    Status.UNCERTAIN: "a contact lies within rounding of touching: move a parameter by 1e-9 of itself, "
    "or locate the grazing point itself (gearlash graze)",
    Status.UNRESOLVED: "no periodic motion was proved within the budget and the exponent does not settle it: "
    "allow more periods (--periods) or a larger period (--max-period)",
    Status.NEUTRAL: "neighbouring motions neither come closer nor leave: this one is one of a continuum, and "
    "the start decides which. State what takes up the freedom (damping, a load, a support), or start from "
    "the state that is meant (--initial)",
    Status.INEXACT: "rounding has spoilt the numbers, as their sum shows: ask for fewer exponents, or scale "
    "the system so that its rates lie nearer to each other",
    Status.NOT_CONVERGED: "Newton's method did not converge: start nearer to the solution",
    Status.TOO_MANY_EVENTS: "more contacts in one cell than the buffers hold: check gap and stiffness "
    "for extreme values",
    Status.DIVERGED: "the state grew beyond every bound or became NaN: check damping and stiffness signs",
    Status.NOT_ADMISSIBLE: "the point solves the equations, but the orbit crosses a boundary elsewhere "
    "than assumed: start from an orbit nearer to the grazing point",
    Status.NOT_FOUND: "nothing was found in the interval: widen it or change the starting orbit",
    Status.FAILED: "change what the message names",
    Status.NOT_COMPUTED: "call it again for the rest",
}
