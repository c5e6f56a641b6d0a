"""What a kind of case is: how its files are read, and what a case of it says.

A kind lies in a folder of its own beside this file, or in anybody's module (`registry.register`). `Case`, the
commands and the studies ask a kind through these two classes only, and none of them by its name.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, NamedTuple

from gearlash.case.entries import Entry
from gearlash.case.errors import Problem
from gearlash.case.note import Note
from gearlash.case.quantity import Choice, Quantity
from gearlash.case.scales import Scales
from gearlash.case.value import Value
from gearlash.system import Family

from . import listed

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from .tables import Tables

Structure = Mapping[str, Any]


class Excitation(NamedTuple):
    """Words for a case in which nothing happens: what is the cause, what to give so that something varies
    with time, and what to do where something varies and moves nothing."""

    cause: str = "nothing excites this system, as nothing in it varies with time"
    give: str = "give something that varies with time"
    moving: str = "change what it acts on"


@dataclass(frozen=True)
class Content(ABC):
    """What one case of a kind holds: its stated values by key, and whatever its file has beside them (plain
    data that JSON knows; empty for most kinds).

    A kind has to say what `family` its case is. Everything else has an answer already that fits a kind whose
    places are listed (`Kind.places`), are all to be stated, and whose parameters are the values in SI by key.
    """

    kind: Kind
    entries: Mapping[str, Entry]
    structure: Structure

    @abstractmethod
    def family(self) -> Family:
        """The case as a family of systems with its own values as defaults."""

    @property
    def places(self) -> Mapping[str, Quantity | Choice]:
        """Every place of this case by path."""
        return self.kind.places

    @property
    def scales(self) -> Scales:
        """Conversions between dimensionless and physical values; those of nothing where there are none."""
        return Scales()

    @property
    def numbers(self) -> Any:
        """What the kind computed beside the family, in a record of its own; None where there is nothing."""
        return None

    @property
    def decisive(self) -> Structure:
        """What of the structure decides a result, for the hash of the case."""
        return self.structure

    def missing(self, present: Collection[str] = ()) -> list[Problem]:
        """What must be stated and is not; ``present`` are paths that the file states in an unusable way."""
        return listed.missing(self.places, self.entries, present)

    def contradictions(self) -> list[Problem]:
        """What in it contradicts what else it states; asked only where nothing is missing or wrong."""
        return []

    def override(self, overrides: Mapping[str, object]) -> tuple[Content, list[Problem]]:
        """With values replaced, by path or short name, and what is wrong with the replacements."""
        entries, problems = listed.override(self.places, self.entries, overrides)
        return replace(self, entries=entries), problems

    def resolve(self, label: str, name: str, value: object) -> tuple[str, float]:
        """Name and value of the family's parameter that is named here by path or short name. Raises
        `CaseError` (of the case called ``label``) for a bad value and `UnknownNameError` for any other name.
        """
        return listed.resolve(self.places, self.family().defaults, label, name, value)

    def named(self, name: str, value: object) -> str:
        """The path of the quantity that a name and a value mean together; any other name stays as it is."""
        return name

    def physical(self, short: str, value: ArrayLike) -> list[tuple[str, NDArray[np.float64], str]]:
        """(path, values, unit) for every physical way to name a parameter with these values."""
        return []

    def values(self) -> list[Value]:
        """Every value with unit, provenance and reason: stated ones, defaults, then what follows."""
        return listed.values(self.places, self.entries)

    def notes(self) -> list[Note]:
        """Remarks on single values; shown, never used."""
        return []


class Draft(NamedTuple):
    """What a file says, right or wrong: ``present`` are paths whose value is there and cannot be used."""

    content: Content
    problems: list[Problem]
    present: frozenset[str] = frozenset()


class Kind(ABC):
    """A kind of case, called ``name`` in the first line of a file.

    ``places`` lists what its files may state, by path (``table.leaf``); a kind whose places depend on the
    file reads and describes it itself (`read`, `schema`).
    """

    name: str
    places: Mapping[str, Quantity | Choice] = {}
    between_teeth: bool = False
    """Is the first clearance that between two meshing gears? Sentences speak of teeth then."""
    excitation: Excitation = Excitation()

    @abstractmethod
    def content(self, entries: Mapping[str, Entry], structure: Structure) -> Content:
        """The content of a case of this kind, from a file or from the JSON of another process. Raises
        `GearlashError` for a structure that cannot be one."""

    def read(self, tables: Mapping[str, object]) -> Draft:
        """The tables of a file, its head (kind, name, description, source) aside."""
        found = self.tables.read(tables)
        entries = listed.entries(self.places, found.stated)
        return Draft(self.content(entries, {}), found.problems, found.present)

    def schema(self, source: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
        """JSON Schemas by name: of a whole file by the name of the kind, then of the parts it points to;
        ``source`` is that of the table [source]."""
        return self.tables.schema(source)

    @property
    def tables(self) -> Tables:
        """How a file made of the listed places is read."""
        from .tables import tables_of  # late: needs pydantic

        return tables_of(self.name, self.places)
