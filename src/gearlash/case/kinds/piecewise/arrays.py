"""Arrays with expressions in them: what is constant is filled once, the rest for each set of values."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from math import cos, sin
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash.system import GearlashError

from .expressions import Expression, ExpressionError, Values

Array = NDArray[np.float64]


class NoValueError(GearlashError):
    """A number of a case that has no value at these parameters; says where, what and why."""

    def __init__(self, path: str, text: str, expected: str):
        self.path, self.text, self.expected = path, text, expected
        super().__init__(f"{path} = {text!r}: expected {expected}")


@dataclass(frozen=True)
class Scalar:
    """A number of a case at its path: a float, or an expression."""

    path: str
    stated: float | Expression

    @staticmethod
    def of(path: str, raw: float | str, known: Collection[str]) -> Scalar:
        return Scalar(path, Expression.read(raw, known) if isinstance(raw, str) else raw)

    @property
    def names(self) -> frozenset[str]:
        return self.stated.names if isinstance(self.stated, Expression) else frozenset()

    def at(self, values: Values) -> float:
        """Its value. Raises `NoValueError`."""
        if not isinstance(self.stated, Expression):
            return self.stated
        try:
            return self.stated(values)
        except ExpressionError as error:
            here = ", ".join(f"{name} = {values[name]:g}" for name in sorted(self.names))
            raise NoValueError(
                self.path, self.stated.text, f"{error.expected}{f' at {here}' if here else ''}"
            ) from None


@dataclass(frozen=True)
class Filled:
    """An array with scalars at some places, zeros elsewhere; ``polar`` are cosines A cos(nθ + φ) of the last
    axis: (index of their c_n, A, φ)."""

    constant: Array
    scalars: tuple[tuple[tuple[int, ...], Scalar], ...]
    polar: tuple[tuple[tuple[int, ...], Scalar, Scalar], ...] = ()

    @staticmethod
    def of(
        shape: tuple[int, ...],
        scalars: Iterator[tuple[tuple[int, ...], Scalar]],
        polar: Iterator[tuple[tuple[int, ...], Scalar, Scalar]] | tuple[()] = (),
    ) -> Filled:
        constant, variable = np.zeros(shape), []
        for index, scalar in scalars:
            if isinstance(scalar.stated, float):
                constant[index] = scalar.stated
            else:
                variable.append((index, scalar))
        return Filled(constant, tuple(variable), tuple(polar))

    def at(self, values: Values) -> Array:
        """The array at these values, a new one each time. Raises `NoValueError`."""
        filled = self.constant.copy()
        for index, scalar in self.scalars:
            filled[index] = scalar.at(values)
        for (*rest, c), amplitude, phase in self.polar:
            size, angle = amplitude.at(values), phase.at(values)
            filled[(*rest, c)] = size * cos(angle)
            filled[(*rest, c + 1)] = -size * sin(angle)
        return filled

    @property
    def parts(self) -> Iterator[Scalar]:
        """Every scalar that is no plain number."""
        yield from (scalar for _, scalar in self.scalars)
        for _, amplitude, phase in self.polar:
            yield from (amplitude, phase)


def vector(content: Mapping[str, Any], states: list[str], path: str, known: Collection[str]) -> Filled:
    """A number a state, shape (n,)."""
    return Filled.of(
        (len(states),),
        (((states.index(s),), Scalar.of(f"{path}.{s}", raw, known)) for s, raw in content.items()),
    )


def matrix(content: Mapping[str, Any], states: list[str], known: Collection[str]) -> Filled:
    """M, shape (n, n)."""
    scalars = (
        ((states.index(row), states.index(column)), Scalar.of(f"matrix.{row}.{column}", raw, known))
        for row, entries in content.items()
        for column, raw in entries.items()
    )
    return Filled.of((len(states), len(states)), scalars)


def series(content: Mapping[str, Any], path: str, known: Collection[str]) -> Filled:
    """A Fourier series, shape (2H+1,)."""
    rows = rows_of_series({"": content}, [""], path, known)
    return Filled(
        rows.constant[0],
        tuple(((i,), s) for (_, i), s in rows.scalars),
        tuple(((i,), a, p) for (_, i), a, p in rows.polar),
    )


def rows_of_series(
    content: Mapping[str, Any], states: list[str], path: str, known: Collection[str]
) -> Filled:
    """A Fourier series a state, shape (n, 2H+1)."""
    highest = max((max(one.get("orders", [0])) for one in content.values()), default=0)
    scalars: list[tuple[tuple[int, ...], Scalar]] = []
    polar: list[tuple[tuple[int, ...], Scalar, Scalar]] = []
    for state, one in content.items():
        row, here = states.index(state), f"{path}.{state}" if state else path
        scalars.append(((row, 0), Scalar.of(f"{here}.mean", one["mean"], known)))
        for i, order in enumerate(one.get("orders", ())):
            if "amplitudes" in one:
                size = Scalar.of(f"{here}.amplitudes[{i}]", one["amplitudes"][i], known)
                phase = Scalar.of(f"{here}.phases[{i}]", one["phases"][i], known)
                polar.append(((row, 2 * order - 1), size, phase))
            else:
                for key, slot in (("cos", 2 * order - 1), ("sin", 2 * order)):
                    scalars.append(((row, slot), Scalar.of(f"{here}.{key}[{i}]", one[key][i], known)))
    return Filled.of((len(states), 2 * highest + 1), iter(scalars), iter(polar))
