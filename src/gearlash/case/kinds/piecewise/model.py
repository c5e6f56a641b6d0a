"""From the plain form of a file to systems: expressions are compiled once, systems built for any values."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash.case.entries import Entry
from gearlash.gears.mesh import SMALLEST_OMEGA
from gearlash.system import Clearance, ContactRule, Family, Parameter, System

from .arrays import Filled, Scalar, matrix, rows_of_series, series, vector
from .file import Structure


@dataclass(frozen=True)
class Gap:
    """One clearance: arrays and numbers by the names of `Clearance`'s fields."""

    name: str
    contact: ContactRule
    arrays: Mapping[str, Filled]
    numbers: Mapping[str, Scalar]

    def at(self, values: Mapping[str, float]) -> Clearance:
        """The clearance at these values, definitions among them."""
        arrays: dict[str, Any] = {key: array.at(values) for key, array in self.arrays.items()}
        numbers: dict[str, Any] = {key: number.at(values) for key, number in self.numbers.items()}
        return Clearance(name=self.name, contact=self.contact, **arrays, **numbers)


@dataclass(frozen=True)
class Model:
    """Everything of a case but the values of its parameters. Made of plain data: it travels to processes."""

    states: tuple[str, ...]
    cycles: int
    definitions: tuple[tuple[str, Scalar], ...]
    matrix: Filled
    forcing: Filled
    cold: Filled
    gaps: tuple[Gap, ...]

    @staticmethod
    def of(structure: Structure, contacts: Mapping[str, ContactRule]) -> Model:
        """The model of a plain form without problems; ``contacts`` by the names of clearances."""
        states, known = structure["states"], set(structure["parameters"])
        definitions = []
        for name, raw in structure["definitions"].items():
            definitions.append((name, Scalar.of(f"definitions.{name}", raw, known)))
            known = {*known, name}
        return Model(
            states=tuple(states),
            cycles=structure["cycles"],
            definitions=tuple(definitions),
            matrix=matrix(structure["matrix"], states, known),
            forcing=rows_of_series(structure["forcing"], states, "forcing", known),
            cold=vector(structure["initial"], states, "initial", known),
            gaps=tuple(_gap(c, states, known, contacts[c["name"]]) for c in structure["clearance"]),
        )

    def complete(self, parameters: Mapping[str, float]) -> dict[str, float]:
        """Parameters and definitions. Raises `NoValueError`, as the others do."""
        values = dict(parameters)
        for name, scalar in self.definitions:
            values[name] = scalar.at(values)
        return values

    def system(self, parameters: Mapping[str, float]) -> System:
        """The system at these values of all parameters."""
        values = self.complete(parameters)
        clearances = tuple(gap.at(values) for gap in self.gaps)
        matrix, forcing = self.matrix.at(values), self.forcing.at(values)
        return System(values["omega"], matrix, forcing, clearances, self.cycles)

    def start(self, parameters: Mapping[str, float]) -> NDArray[np.float64]:
        """The cold start, shape (n,)."""
        return self.cold.at(self.complete(parameters))

    def scalars(self) -> Iterator[Scalar]:
        """Every number that may be an expression, definitions apart."""
        for array in (self.matrix, self.forcing, self.cold):
            yield from array.parts
        for gap in self.gaps:
            for array in gap.arrays.values():
                yield from array.parts
            yield from gap.numbers.values()


def family(structure: Structure, entries: Mapping[str, Entry]) -> Family:
    """The family of a case of this kind."""
    model = model_of(structure, entries)
    parameters = tuple(
        Parameter(
            name,
            entries[name].number,
            about.get("description", ""),
            max(about.get("lower", -np.inf), SMALLEST_OMEGA if name == "omega" else -np.inf),
            about.get("upper", np.inf),
        )
        for name, about in structure["parameters"].items()
    )
    return Family(parameters, model.states, model.system, model.start)


def model_of(structure: Structure, entries: Mapping[str, Entry]) -> Model:
    """The model of a case with its contact rules."""
    return Model.of(structure, {c["name"]: contact_of(c["name"], entries) for c in structure["clearance"]})


def contact_of(name: str, entries: Mapping[str, Entry]) -> ContactRule:
    """The stated contact rule of a clearance, else `ContactRule.ALWAYS`."""
    entry = entries.get(f"clearance.{name}.contact")
    return ContactRule.ALWAYS if entry is None else ContactRule(str(entry.value))


def _gap(content: Structure, states: list[str], known: Collection[str], contact: ContactRule) -> Gap:
    path = f"clearance.{content['name']}"
    arrays = {key: vector(content[key], states, f"{path}.{key}", known) for key in ("h", "g")}
    for key in ("stiffness_plus", "stiffness_minus", "offset"):
        arrays[key] = series(content[key], f"{path}.{key}", known)
    numbers = {
        key: Scalar.of(f"{path}.{key}", content[key], known)
        for key in ("gap_plus", "gap_minus", "damping", "damping_minus")
        if key in content
    }
    return Gap(content["name"], contact, arrays, numbers)
