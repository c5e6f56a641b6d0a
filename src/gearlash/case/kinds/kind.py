"""What a kind of case is: how its files are read, and what a case of it says.

A kind lies in a folder of its own beside this file, or in a user's module (`registry.register`). `Case`, the
commands and the studies use a kind through `Kind` and `Content` only; none of them asks for a kind by name.
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
from gearlash.system import Family, UnknownNameError

from . import listed

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

    from .tables import Tables

Structure = Mapping[str, Any]


class Excitation(NamedTuple):
    """Words for a case in which nothing happens.

    Attributes
    ----------
    cause : str
        Why nothing happens, where nothing varies with time.
    give : str
        What to give, so that something varies with time.
    moving : str
        What to do where something varies with time and moves nothing.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.load_case("article").excitation.give
    'give ripple or error'
    """

    cause: str = "nothing excites this system, as nothing in it varies with time"
    give: str = "give something that varies with time"
    moving: str = "change what it acts on"


@dataclass(frozen=True)
class Content(ABC):
    """What one case of a kind holds, and what it means.

    A kind has to define `family`. All other methods have an answer already, which fits a kind whose places
    are listed in `Kind.places`, must all be stated, and whose parameters are the values in SI by key.

    Attributes
    ----------
    kind : Kind
    entries : mapping of str to Entry
        The stated values by key.
    structure : mapping
        What a file has beside its values, as plain data that JSON knows; empty for most kinds.

    Examples
    --------
    The example of `Kind` defines one. That of a case is its `Case.content`:

    >>> import gearlash as gl
    >>> content = gl.load_case("article").content
    >>> content.kind.name, content.missing(), content.contradictions()
    ('helical-pair', [], [])
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
        """What must be stated and is not.

        Parameters
        ----------
        present : collection of str
            Paths that the file states in an unusable way: they are not missing as well.

        Returns
        -------
        list of Problem
        """
        return listed.missing(self.places, self.entries, present)

    def contradictions(self) -> list[Problem]:
        """Stated values that contradict each other; asked only where nothing is missing or wrong.

        Returns
        -------
        list of Problem
        """
        return []

    def override(self, overrides: Mapping[str, object]) -> tuple[Content, list[Problem]]:
        """The content with values replaced.

        Parameters
        ----------
        overrides : mapping
            Path or short name to a text with its unit or a number.

        Returns
        -------
        content : Content
        problems : list of Problem
            What is wrong with the replacements.
        """
        entries, problems = listed.override(self.places, self.entries, overrides)
        return replace(self, entries=entries), problems

    def resolve(self, label: str, name: str, value: object) -> tuple[str, float]:
        """The parameter of the family that a name and a value mean; see `Case.resolve`.

        Parameters
        ----------
        label : str
            What the case is called in problems.
        name : str
            Path or short name.
        value : object
            A text with its unit, or a number.

        Returns
        -------
        name : str
            Short name.
        value : float
            As the family takes it.

        Raises
        ------
        CaseError
            For a value that cannot be used.
        UnknownNameError
            For a name that is no parameter of the family.
        """
        return listed.resolve(self.places, self.family().defaults, label, name, value)

    def varying(self, name: str) -> Content:
        """The content with one more parameter in its family; see `Case.varying`.

        Parameters
        ----------
        name : str
            Path or short name.

        Returns
        -------
        Content
            This one, where the name is that of a parameter.

        Raises
        ------
        UnknownNameError
            For what cannot vary.
        """
        known = self.family().defaults
        place = listed.find(self.places, name)
        if name not in known and (place is None or listed.key_of(place) not in known):
            raise UnknownNameError("parameter to vary", name, known)
        return self

    def named(self, name: str, value: object) -> str:
        """The quantity that a name and a value mean together; see `Case.named`.

        Parameters
        ----------
        name : str
            Path or short name.
        value : object
            A text with its unit, or a number.

        Returns
        -------
        str
            A path, or the name as it is.
        """
        return name

    def physical(self, short: str, value: ArrayLike) -> list[tuple[str, NDArray[np.float64], str]]:
        """What values of a parameter mean physically; see `Case.physical`.

        Parameters
        ----------
        short : str
            Short name.
        value : array_like
            As the family takes it.

        Returns
        -------
        list of (str, ndarray, str)
            Path, values and unit for every physical way to name it.
        """
        return []

    def at_gear(self, short: str) -> tuple[str, float, str] | None:
        """What one of a parameter is at the gear in place of the pinion; see `Case.at_gear`.

        Parameters
        ----------
        short : str
            Short name.

        Returns
        -------
        (str, float, str) or None
            Path, value and unit; None where the kind has no gear, and for what is no speed or torque.
        """
        return None

    def rebuilt(self, short: str) -> bool:
        """Whether every value of a parameter makes another pair from its drawing, which takes long.

        Parameters
        ----------
        short : str
            Name of the parameter in the family.

        Returns
        -------
        bool
        """
        return False

    def held(self, name: str) -> str:
        """What is taken to be the same wherever a parameter varies; see `Case.held`.

        Parameters
        ----------
        name : str
            Path or short name.

        Returns
        -------
        str
        """
        return ""

    def values(self) -> list[Value]:
        """Every value with unit, provenance and reason.

        Returns
        -------
        list of Value
            Stated ones, defaults, then what follows from them.
        """
        return listed.values(self.places, self.entries)

    def notes(self) -> list[Note]:
        """Remarks on single values, which are shown and never used.

        Returns
        -------
        list of Note
        """
        return []


class Draft(NamedTuple):
    """What a file says, right or wrong.

    Attributes
    ----------
    content : Content
        Of what could be read.
    problems : list of Problem
    present : frozenset of str
        Paths whose value is there and cannot be used: they are not missing as well.
    """

    content: Content
    problems: list[Problem]
    present: frozenset[str] = frozenset()


class Kind(ABC):
    """A kind of case.

    A kind whose places depend on the file defines `read` and `schema` as well.

    Attributes
    ----------
    name : str
        What the first line of a file says: ``kind = "..."``.
    places : mapping of str to Quantity or Choice
        What its files may state, by path (``table.leaf``).
    between_teeth : bool
        Whether the first clearance is the one between two meshing gears: sentences then speak of teeth.
    excitation : Excitation
        Words for a case in which nothing happens.

    Examples
    --------
    >>> from gearlash.case import loads
    >>> from gearlash.case.kinds import Content, Kind, Quantity, forget, register
    >>> from gearlash.case.units import NUMBER
    >>> from gearlash.gears import spur
    >>> class Rattle(Content):
    ...     def family(self):
    ...         values = {key: entry.number for key, entry in self.entries.items()}
    ...         return spur.family({"D": 1.0, "load": 0.2, **values})
    >>> class RattleKind(Kind):
    ...     name = "rattle"
    ...     places = {
    ...         path: Quantity(path, NUMBER, "", "0.7", "", lower=1e-3, upper=9.0, bare=True, key=key)
    ...         for path, key in (("pair.omega", "omega"), ("pair.error", "error"))
    ...     }
    ...     def content(self, entries, structure):
    ...         return Rattle(self, entries, structure)
    >>> register(RattleKind())
    >>> loads('kind = "rattle"\\n[pair]\\nomega = 0.7\\nerror = 0.1').family()[0].system().omega
    0.7
    >>> forget("rattle")
    """

    name: str
    places: Mapping[str, Quantity | Choice] = {}
    between_teeth: bool = False
    excitation: Excitation = Excitation()

    @abstractmethod
    def content(self, entries: Mapping[str, Entry], structure: Structure) -> Content:
        """The content of a case of this kind, from a file or from the JSON of another process.

        Parameters
        ----------
        entries : mapping of str to Entry
            The stated values by key.
        structure : mapping
            What the file has beside its values.

        Returns
        -------
        Content

        Raises
        ------
        GearlashError
            For a structure that no case of this kind has.
        """

    def read(self, tables: Mapping[str, object]) -> Draft:
        """What a file of this kind says.

        Parameters
        ----------
        tables : mapping
            Of the parsed file, without its head (kind, name, description, source).

        Returns
        -------
        Draft
        """
        found = self.tables.read(tables)
        entries = listed.entries(self.places, found.stated)
        return Draft(self.content(entries, {}), found.problems, found.present)

    def schema(self, source: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
        """JSON Schemas of files of this kind.

        Parameters
        ----------
        source : mapping
            The schema of the table ``[source]``.

        Returns
        -------
        dict of str to dict
            That of a whole file by the name of the kind, then those of the parts it points to.
        """
        return self.tables.schema(source)

    @property
    def tables(self) -> Tables:
        """How a file made of the listed places is read."""
        from .tables import tables_of  # late: needs pydantic

        return tables_of(self.name, self.places)
