"""A family of systems: what everything above the flow sees."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import inf
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import given
from .piecewise import System
from .record import Record
from .status import BuildError, GearlashError
from .told import cut

LONGEST_VALUES = 300  # characters of parameter values in an error text


@dataclass(frozen=True)
class Parameter:
    """A number that may be varied, with its default and the closed range it must lie in."""

    name: str
    default: float
    description: str = ""
    lower: float = -inf
    upper: float = inf

    def __post_init__(self) -> None:
        name = given.word("name of a parameter", self.name)
        lower = given.limit(f"lower end of parameter {name}", self.lower)
        upper = given.limit(f"upper end of parameter {name}", self.upper)
        object.__setattr__(self, "name", name)
        object.__setattr__(self, "lower", lower)
        object.__setattr__(self, "upper", upper)
        description = given.a_text(f"description of parameter {name}", self.description)
        object.__setattr__(self, "description", description)
        if lower > upper:
            raise GearlashError(f"parameter {name}: the range from {lower:g} to {upper:g} is empty")
        object.__setattr__(self, "default", given.number(f"parameter {name}", self.default, lower, upper))


@dataclass(frozen=True, repr=False)
class Family(Record):
    """Parameter names and defaults, state names, and how to build one system from a complete mapping.

    ``build`` gets a value for every name and returns plain arrays in a `System`; ``cold_start`` gets the same
    and returns the state (n,) from which a motion starts where no other is given. Whatever they raise for
    some values becomes a `BuildError`, which fails that point of a study. Nothing above reads a case file
    again for another point of the same family."""

    parameters: tuple[Parameter, ...]
    states: tuple[str, ...]
    build: Callable[[Mapping[str, float]], System]
    cold_start: Callable[[Mapping[str, float]], NDArray[np.float64]]

    def __post_init__(self) -> None:
        expected = "parameters, such as (Parameter('omega', 0.9),)"
        parameters = given.instances("parameters of a family", self.parameters, Parameter, expected)
        given.unique("parameters of a family", tuple(p.name for p in parameters))
        object.__setattr__(self, "parameters", parameters)
        object.__setattr__(self, "states", given.words("states of a family", self.states))
        given.function("build of a family", self.build, "a function from parameter values to a System")
        expected = "a function from parameter values to a state"
        given.function("cold_start of a family", self.cold_start, expected)

    @property
    def defaults(self) -> dict[str, float]:
        return {p.name: p.default for p in self.parameters}

    def complete(self, overrides: Mapping[str, float] | None = None) -> dict[str, float]:
        """Defaults with overrides. Raises `UnknownNameError`, or `GearlashError` for a value out of range."""
        values = self.defaults
        by_name = {p.name: p for p in self.parameters}
        for name, value in given.mapping("parameter values", overrides).items():
            parameter = by_name[given.known("parameter", name, by_name)]
            values[name] = given.number(name, value, parameter.lower, parameter.upper)
        return values

    def system(self, overrides: Mapping[str, float] | None = None) -> System:
        """The member of the family with these overrides. Raises `BuildError` where it cannot be built."""
        values = self.complete(overrides)
        built = _called("build", self.build, values)
        if not isinstance(built, System):
            raise BuildError(f"build returned {given.kind_of(built)} instead of a System, at {_told(values)}")
        if built.size != len(self.states):
            raise BuildError(
                f"build returned a system of {built.size} states, but the family names {len(self.states)}: "
                f"{', '.join(self.states)}"
            )
        return built

    def start(self, overrides: Mapping[str, float] | None = None) -> NDArray[np.float64]:
        """The cold start of that member, shape (n,). Raises `BuildError` where there is none."""
        values = self.complete(overrides)
        return given.numbers("the start", _called("cold_start", self.cold_start, values), (len(self.states),))


def _called(name: str, function: Callable[[Mapping[str, float]], Any], values: dict[str, float]) -> Any:
    """What a user's function returns. Anything may go wrong in there, too little memory and a call of
    `sys.exit` among it, and is no defect of gearlash: the one place where everything but Ctrl-C is caught."""
    try:
        return function(values)
    except (GearlashError, KeyboardInterrupt):
        raise
    except BaseException as error:
        raise BuildError(f"{name} failed at {_told(values)}: {_what(error)}") from error


def _what(error: BaseException) -> str:
    """An exception in one line; its own text may fail, too."""
    try:
        text = " ".join(str(error).split())
    except Exception:  # noqa: BLE001  (whatever a user's class does)
        text = "its text cannot be had"
    return cut(f"{type(error).__name__}: {text}".removesuffix(": "), LONGEST_VALUES)


def _told(values: Mapping[str, float]) -> str:
    return cut(", ".join(f"{name} = {value:.10g}" for name, value in values.items()), LONGEST_VALUES)
