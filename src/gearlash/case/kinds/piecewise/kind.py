"""The kind ``piecewise-linear``: any system of the class, in plain arrays with named parameters."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

from gearlash.case.entries import Entry
from gearlash.case.errors import Problem
from gearlash.case.kinds.kind import Content, Draft, Excitation, Kind, Structure
from gearlash.case.kinds.sides import notes_on_sides
from gearlash.case.note import Note
from gearlash.case.quantity import Choice, Quantity
from gearlash.case.value import Value
from gearlash.system import Family, GearlashError

from .checks import contradictions
from .file import read
from .model import family
from .places import places
from .values import values


class PiecewiseContent(Content):
    """Equations, forcing and clearances (`structure`); parameters and contact rules are its entries."""

    @property
    def places(self) -> Mapping[str, Quantity | Choice]:
        return places(self.structure)

    @property
    def decisive(self) -> Structure:
        """Without descriptions and ranges of the parameters, whose values are entries."""
        return {key: value for key, value in self.structure.items() if key != "parameters"}

    def family(self) -> Family:
        return family(self.structure, self.entries)

    def missing(self, present: Collection[str] = ()) -> list[Problem]:
        """Nothing: reading the file found it."""
        return []

    def contradictions(self) -> list[Problem]:
        return contradictions(self.structure, self.entries)

    def values(self) -> list[Value]:
        return values(self.structure, self.entries)

    def notes(self) -> list[Note]:
        return [
            note
            for clearance in self.family().system().clearances
            for note in notes_on_sides(clearance, f"clearance.{clearance.name}.stiffness_{{side}}")
        ]


class PiecewiseLinear(Kind):
    """Places depend on the file: its own parameters, and a contact rule a clearance."""

    name = "piecewise-linear"
    excitation = Excitation(give="give a forcing, an offset or a stiffness with cos or sin")

    def content(self, entries: Mapping[str, Entry], structure: Structure) -> PiecewiseContent:
        if not structure:
            raise GearlashError(f"not the JSON of a case: a {self.name} one without its structure")
        return PiecewiseContent(self, entries, structure)

    def read(self, tables: Mapping[str, object]) -> Draft:
        structure, entries, problems = read(tables)
        return Draft(self.content(entries, structure), problems)

    def schema(self, source: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
        from .fileschema import definitions, piecewise_schema

        return {self.name: piecewise_schema(dict(source)), **definitions()}


KIND = PiecewiseLinear()
