"""A family of systems: what everything above the flow sees."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import inf, isfinite

import numpy as np
from numpy.typing import NDArray

from .piecewise import System
from .status import GearlashError, UnknownNameError


@dataclass(frozen=True)
class Parameter:
    """A number that may be varied, with its default and the closed range it must lie in."""

    name: str
    default: float
    description: str = ""
    lower: float = -inf
    upper: float = inf


@dataclass(frozen=True)
class Family:
    """Parameter names and defaults, state names, and how to build one system from a complete mapping.

    ``build`` gets a value for every name and returns plain arrays in a `System`; ``initial`` returns the cold
    start, shape (n,). Nothing above reads a case file again for another point of the same family."""

    parameters: tuple[Parameter, ...]
    states: tuple[str, ...]
    build: Callable[[Mapping[str, float]], System]
    initial: Callable[[Mapping[str, float]], NDArray[np.float64]]

    @property
    def defaults(self) -> dict[str, float]:
        return {p.name: p.default for p in self.parameters}

    def complete(self, overrides: Mapping[str, float] | None = None) -> dict[str, float]:
        """Defaults with overrides. Raises `UnknownNameError`, or `GearlashError` for a value out of range."""
        values = self.defaults
        by_name = {p.name: p for p in self.parameters}
        for name, value in (overrides or {}).items():
            if name not in by_name:
                raise UnknownNameError("parameter", name, by_name)
            parameter = by_name[name]
            if not _is_number(value) or not parameter.lower <= value <= parameter.upper:
                limits = f"from {parameter.lower:g} to {parameter.upper:g}"
                raise GearlashError(f"{name} = {value!r}: expected a finite number {limits}")
            values[name] = float(value)
        return values

    def system(self, overrides: Mapping[str, float] | None = None) -> System:
        """The member of the family with these overrides."""
        return self.build(self.complete(overrides))

    def start(self, overrides: Mapping[str, float] | None = None) -> NDArray[np.float64]:
        """The cold start of that member, shape (n,)."""
        return self.initial(self.complete(overrides))


def _is_number(value: object) -> bool:
    """Whether it is one finite number."""
    try:
        return isfinite(value)  # pyright: ignore[reportArgumentType]
    except TypeError:
        return False
