"""A case: a gear pair or any piecewise-linear system as its user described it, ready to become a family.

What a case means is known to its kind alone (`kinds/`)."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

from gearlash.system import Family, GearlashError, Record, given
from gearlash.system.short_text import cut

from .entries import Entry
from .errors import CaseError
from .kinds import Content, Draft, Excitation, kind_named
from .note import Note
from .scales import Scales
from .stated import Provenance
from .value import Value

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

FORMAT = 1


@dataclass(frozen=True, repr=False)
class Case(Record):
    """A complete, checked case, as `load_case` and `Case.from_json` make it.

    Attributes
    ----------
    name, description : str
    kind : str
        What the file says in its first line: ``helical-pair``, ``spur-1dof``, ``piecewise-linear``, or a kind
        that was registered.
    source : mapping
        Title, authors, DOI, address and note of where the case is from, as far as stated.
    entries : mapping of str to Entry
        Every stated value by key, in SI. The length D_c that everything is divided by is among them
        (``model.reference_length``): it was settled when the file was loaded, and nothing moves it
        afterwards.
    structure : mapping
        What a case has beside its values: equations, forcing and clearances of a piecewise-linear one; empty
        for a gear pair.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("article", {"pinion_speed": "3600 rpm"})
    >>> family, scales = case.family()
    >>> round(family.defaults["omega"], 4), round(float(scales.pinion_rpm(family.defaults["omega"])))
    (0.9424, 3600)
    """

    _printed: ClassVar = ("name", "kind", "description", "hash")

    name: str
    kind: str
    description: str
    source: Mapping[str, object]
    entries: Mapping[str, Entry]
    structure: Mapping[str, Any] = field(default_factory=dict)

    @cached_property
    def content(self) -> Content:
        """The entries and the structure as the kind of this case understands them. Raises
        `UnknownNameError` for a kind that is not known here."""
        return kind_named(self.kind).content(self.entries, self.structure)

    def family(self) -> tuple[Family, Scales]:
        """The case as a family of systems, and its scales.

        Returns
        -------
        family : Family
            Dimensionless systems, with the values of this case as defaults.
        scales : Scales
            Conversions between dimensionless and physical values.
        """
        return self.content.family(), self.scales

    @property
    def numbers(self) -> Any:
        """Parameters, fixed numbers, scales and body of a gear pair; None for a kind without such."""
        return self.content.numbers

    @property
    def scales(self) -> Scales:
        """Conversions between dimensionless and physical values."""
        return self.content.scales

    @property
    def excitation(self) -> Excitation:
        """What to say where nothing happens in a case of this kind."""
        return self.content.kind.excitation

    @property
    def between_teeth(self) -> bool:
        """Is the first clearance the one between two meshing gears?"""
        return self.content.kind.between_teeth

    def with_overrides(self, overrides: Mapping[str, object]) -> Case:
        """The case with values replaced.

        Parameters
        ----------
        overrides : mapping
            Path or short name to a text with its unit (``"120 um"``), or to a number for what has no unit.

        Returns
        -------
        Case

        Raises
        ------
        CaseError
            With every problem of the overrides, and of what the case is with them.

        Examples
        --------
        >>> import gearlash as gl
        >>> wider = gl.load_case("article").with_overrides({"backlash": "150 um"})
        >>> round(wider.family()[0].defaults["D"], 12)
        1.5
        """
        content, problems = self.content.override(given.mapping("overrides", overrides))
        content = checked(Draft(content, problems), self.name)
        found = replace(self, entries=content.entries, structure=content.structure)
        vars(found)["content"] = content  # with what is estimated in it, which was made for the check
        return found

    def resolve(self, name: str, value: str | float) -> tuple[str, float]:
        """The parameter of the family that a name and a value mean.

        Parameters
        ----------
        name : str
            Path or short name, dimensionless or physical.
        value : str or float
            A text with its unit, or a number for what has no unit.

        Returns
        -------
        name : str
            Short name of the parameter.
        value : float
            Its dimensionless value.

        Raises
        ------
        CaseError
            For a value that cannot be used.
        UnknownNameError
            For a name that is no parameter of the family.

        Examples
        --------
        >>> import gearlash as gl
        >>> name, value = gl.load_case("article").resolve("pinion_speed", "3600 rpm")
        >>> name, round(value, 6)
        ('omega', 0.942415)
        """
        return self.content.resolve(self.name, given.a_text("name of a parameter", name), value)

    def varying(self, name: str) -> Case:
        """The case with a family in which one more stated or estimated quantity varies.

        Speed, backlash, torque and whatever else the model itself knows vary anyway. Of anything else (mean
        stiffness, face width, profile shift, whole numbers of teeth) each member of the family is a case of
        its own with estimates of its own, in the units of this one: what is stated stays as it is stated.

        Parameters
        ----------
        name : str
            Path or short name.

        Returns
        -------
        Case
            In whose family the path is a parameter, in SI. This one, where it is a parameter already.

        Raises
        ------
        UnknownNameError
            For what the case does not have, or what cannot vary.

        Examples
        --------
        >>> import gearlash as gl
        >>> case = gl.load_case("article").varying("mesh.mean_stiffness")
        >>> stiffer = case.family()[0].system({"mesh.mean_stiffness": 4e8})
        >>> round(float(stiffer.clearances[0].stiffness_plus[0]), 3)  # over the 3.2e8 N/m of the case
        1.25
        """
        content = self.content.varying(given.a_text("name of a quantity", name))
        return self if content is self.content else replace(self, structure=content.structure)

    def named(self, name: str, value: object) -> str:
        """The quantity that a name and a value mean together.

        Parameters
        ----------
        name : str
            Path or short name.
        value : object
            A text with its unit, or a number.

        Returns
        -------
        str
            ``mesh.error`` for ``("error", "6 um")``, as the unit says; any other name stays as it is.
        """
        return self.content.named(name, value)

    def physical(self, short: str, value: ArrayLike) -> list[tuple[str, NDArray[np.float64], str]]:
        """What values of a parameter mean physically.

        Parameters
        ----------
        short : str
            Short name of the parameter.
        value : array_like
            Dimensionless, of any shape.

        Returns
        -------
        list of (str, ndarray, str)
            Path, values and unit for every physical way to name it. Empty for a case without scales, and for
            a number that is the same either way.

        Examples
        --------
        >>> import gearlash as gl
        >>> for path, values, unit in gl.load_case("article").physical("omega", [0.5, 1.0]):
        ...     print(path, values.round(1), unit)
        operation.pinion_speed [1910. 3820.] rpm
        operation.mesh_frequency [ 891.3 1782.7] Hz
        """
        return self.content.physical(short, value)

    def at_gear(self, short: str) -> tuple[str, float, str] | None:
        """What one of a parameter is at the gear in place of the pinion.

        Parameters
        ----------
        short : str
            Short name of the parameter.

        Returns
        -------
        (str, float, str) or None
            Path, value and unit; None for what is no speed or torque of a pair whose teeth are stated.

        Examples
        --------
        >>> import gearlash as gl
        >>> path, rpm, unit = gl.load_case("article").at_gear("omega")
        >>> print(path, round(rpm), unit)
        operation.gear_speed 1528 rpm
        """
        return self.content.at_gear(short)

    def held(self, name: str) -> str:
        """What is taken to be the same wherever a parameter varies, although it may not be.

        Parameters
        ----------
        name : str
            Path or short name of the parameter.

        Returns
        -------
        str
            A sentence; empty where there is nothing to say.

        Examples
        --------
        >>> import gearlash as gl
        >>> gl.load_case("article").held("torque")[:46]
        'stiffness and error are the same at every torq'
        """
        return self.content.held(name)

    def values(self) -> list[Value]:
        """Every value with unit, provenance and reason.

        Returns
        -------
        list of Value
            Stated ones, defaults that took effect, then derived numbers.
        """
        return self.content.values()

    def notes(self) -> list[Note]:
        """Remarks on single values, which are shown and never used.

        Returns
        -------
        list of Note
            Conflicts between stated values and what is known otherwise, and how sides without stiffness are
            read.
        """
        return self.content.notes()

    @property
    def hash(self) -> str:
        """SHA-256 of all that decides a result: kind, values and their limits, not names, texts, reasons or
        provenance."""
        content: list[object] = [self.kind, sorted((e.key, e.path, e.value) for e in self.entries.values())]
        limits = sorted((e.key, e.least, e.greatest) for e in self.entries.values() if e.limited)
        content += [limits] if limits else []
        if self.structure:
            content.append(dict(self.content.decisive))
        text = json.dumps(content, separators=(",", ":"), sort_keys=True)
        return hashlib.sha256(text.encode()).hexdigest()

    def __hash__(self) -> int:
        """Equal cases have equal ones, so that a case may be a key."""
        return hash(self.hash)

    def to_json(self) -> str:
        """The case as JSON text, for another process.

        Returns
        -------
        str
            Of which `from_json` makes an equal case with an identical family.
        """
        entries = [
            {
                "key": e.key,
                "path": e.path,
                "value": e.value,
                "text": e.text,
                "provenance": e.provenance,
                "reason": e.reason,
                **({"least": e.least, "greatest": e.greatest} if e.limited else {}),
            }
            for e in self.entries.values()
        ]
        head = {"format": FORMAT, "name": self.name, "kind": self.kind, "description": self.description}
        rest = {"structure": dict(self.structure)} if self.structure else {}
        return json.dumps(
            {**head, "source": dict(self.source), "entries": entries, **rest}, ensure_ascii=False
        )

    @classmethod
    def from_json(cls, text: str) -> Case:
        """The case that `to_json` wrote.

        Parameters
        ----------
        text : str

        Returns
        -------
        Case

        Raises
        ------
        GearlashError
            For any other text, or a kind of case that is not known in this process.
        """
        try:
            data = json.loads(text)
            if data["format"] != FORMAT:
                raise GearlashError(f"case JSON of format {data['format']}, this version reads {FORMAT}")
            entries = [
                Entry(
                    e["key"],
                    e["path"],
                    e["value"],
                    e["text"],
                    Provenance(e["provenance"]),
                    e["reason"],
                    e.get("least"),
                    e.get("greatest"),
                )
                for e in data["entries"]
            ]
            head = (data["name"], data["kind"], data["description"], data["source"])
            case = cls(*head, {e.key: e for e in entries}, data.get("structure", {}))
            _ = case.content  # whose kind may be unknown here, or refuse it
            return case
        except (ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError) as error:
            raise GearlashError(f"not the JSON of a case: {cut(repr(error), 300)}") from None


def checked(draft: Draft, label: str) -> Content:
    """The content of a complete case without contradictions. Raises `CaseError`."""
    content = draft.content
    problems = [*draft.problems, *content.missing(draft.present)] or content.contradictions()
    if problems:
        raise CaseError(label, problems)
    return content
