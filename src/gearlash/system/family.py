"""A family of systems: what everything above the flow sees."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from math import inf
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import given
from .piecewise import System
from .record import Record
from .short_text import cut
from .status import BuildError, GearlashError, UnknownNameError

LONGEST_VALUES = 300  # characters of parameter values in an error text


@dataclass(frozen=True)
class Parameter:
    """A number of a family that may be varied.

    Parameters
    ----------
    name : str
        One line of text.
    default : float
        Within the range.
    description : str
    lower : float
        Least value, which may be -inf.
    upper : float
        Largest value, which may be inf.

    Raises
    ------
    GearlashError
        For an empty range, or a default outside it.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.Parameter("gap", 0.5, "half of the clearance", lower=0.0).default
    0.5
    """

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
    """Systems that differ in parameters: names, defaults, and how to build one of them.

    Studies take a family where they take a case. Where worker processes are to build it, ``build`` and
    ``cold_start`` must be functions of a module; see `open_workers`.

    Parameters
    ----------
    parameters : sequence of Parameter
    states : sequence of str
        Names of the n states, each once.
    build : callable
        Gets a mapping with a value for every parameter and returns a `System` of n states. What it raises for
        some values becomes a `BuildError`, which fails that point of a study.
    cold_start : callable
        Gets the same mapping and returns the state (n,) at phase zero from which a motion starts where no
        other is given.

    Raises
    ------
    GearlashError
        For what is none of these.

    Examples
    --------
    >>> import gearlash as gl
    >>> def build(p):
    ...     stop = gl.Clearance([1.0, 0.0], [0.0, -1.0], p["gap"], 100.0, 8.0, 0.0, name="stop")
    ...     forcing = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
    ...     return gl.System(p["omega"], [[0.0, 1.0], [-1.0, -0.1]], forcing, (stop,))
    >>> parameters = gl.Parameter("omega", 0.8), gl.Parameter("gap", 0.5)
    >>> family = gl.Family(parameters, ("x", "v"), build, cold_start=lambda p: [0.0, 0.0])
    >>> gl.attractor(family.system({"gap": 0.2}), family.start()).label
    1-1-0
    """

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
        """The default of every parameter, by name."""
        return {p.name: p.default for p in self.parameters}

    def complete(self, values: Mapping[str, float] | None = None) -> dict[str, float]:
        """A value for every parameter: the given ones, and defaults for the others.

        Parameters
        ----------
        values : mapping of str to float, optional

        Returns
        -------
        dict of str to float

        Raises
        ------
        GearlashError
            For a name that is no parameter, and for a value out of its range.
        """
        found, by_name = self.defaults, self._by_name
        for name, value in given.mapping("parameter values", values).items():
            parameter = by_name.get(name) or by_name[_known(name, by_name)]
            if value is not parameter.default:  # that one was looked at when the family was made
                found[name] = given.number(name, value, parameter.lower, parameter.upper)
        return found

    @cached_property
    def _by_name(self) -> dict[str, Parameter]:
        return {p.name: p for p in self.parameters}

    def system(self, values: Mapping[str, float] | None = None) -> System:
        """The member of the family with these values.

        Parameters
        ----------
        values : mapping of str to float, optional
            Defaults stand for those that are left out.

        Returns
        -------
        System

        Raises
        ------
        BuildError
            Where it cannot be built.
        GearlashError
            For names and values that do not fit.
        """
        complete = self.complete(values)
        built = _called("build", self.build, complete)
        if not isinstance(built, System):
            raise BuildError(
                f"build returned {given.kind_of(built)} instead of a System, at {_told(complete)}"
            )
        if built.size != len(self.states):
            raise BuildError(
                f"build returned a system of {built.size} states, but the family names {len(self.states)}: "
                f"{', '.join(self.states)}"
            )
        return built

    def start(self, values: Mapping[str, float] | None = None) -> NDArray[np.float64]:
        """The cold start of the member with these values.

        Parameters
        ----------
        values : mapping of str to float, optional
            Defaults stand for those that are left out.

        Returns
        -------
        ndarray of shape (n,)
            The state at phase zero.

        Raises
        ------
        BuildError
            Where there is none.
        GearlashError
            For names and values that do not fit.
        """
        found = _called("cold_start", self.cold_start, self.complete(values))
        return given.numbers("the start", found, (len(self.states),))


def _known(name: object, valid: Mapping[str, Parameter]) -> str:
    """The name of a parameter. One that a case file may have, with a unit, is told where to turn to."""
    if isinstance(name, str) and name in valid:
        return name
    instead = (
        "; a name of a case file, with its unit, is for the case: case.resolve(name, value) has both here"
    )
    raise UnknownNameError("parameter", name, valid, instead)


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
