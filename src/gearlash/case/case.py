"""A case: a gear pair or any piecewise-linear system as its user described it, ready to become a family."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from gearlash.gears import helical, spur
from gearlash.system import Family, GearlashError, Record, UnknownNameError, given
from gearlash.system.told import cut

from . import piecewise
from .checks import contradictions, missing
from .entries import Entries, Entry, collect, freeze_reference, override, place_for
from .errors import CaseError, Problem, shown
from .notes import Note, notes
from .numbers import Numbers, numbers, to_dimensionless, to_physical
from .quantities import PIECEWISE, Quantity, quantities, two_way
from .read import parse, source_text
from .scales import Scales
from .stated import Provenance, ValueRefusedError, read_stated
from .texts import name_of_file
from .units import NUMBER, TORQUE, unit
from .value import Value
from .values import values

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

FORMAT = 1


@dataclass(frozen=True, repr=False)
class Case(Record):
    """A complete, checked case. Made by `load`, `loads` or `Case.from_json`.

    ``entries`` hold every stated value by key in SI, D_c among them (``model.reference_length``): it was
    settled when the file was loaded and nothing moves it afterwards. ``structure`` is what a piecewise-linear
    case has beside its parameters: equations, forcing and clearances; empty for a gear pair.
    """

    _told: ClassVar = ("name", "kind", "description", "hash")

    name: str
    kind: str
    description: str
    source: Mapping[str, object]
    entries: Mapping[str, Entry]
    structure: Mapping[str, Any] = field(default_factory=dict)

    def family(self) -> tuple[Family, Scales]:
        """The pair as a family of dimensionless systems with this case as default, and its scales."""
        if self.kind == PIECEWISE:
            return piecewise.family(self.structure, self.entries), Scales()
        own = self.numbers
        if own.pair is None:
            return spur.family(own.parameters, own.contact), own.scales
        return helical.family(own.pair, own.parameters), own.scales

    @cached_property
    def numbers(self) -> Numbers:
        """Parameters, fixed numbers, scales and body of a gear pair."""
        return numbers(self.kind, dict(self.entries))

    @property
    def scales(self) -> Scales:
        """Conversions between dimensionless and physical values."""
        return Scales() if self.kind == PIECEWISE else self.numbers.scales

    def with_overrides(self, overrides: Mapping[str, object]) -> Case:
        """The case with values replaced, by path or short name, as text or number. Raises `CaseError`."""
        overrides = given.mapping("overrides", overrides)
        if self.kind == PIECEWISE:
            return _finished_piecewise(self, *piecewise.override(self.structure, self.entries, overrides))
        return _finished(self, *override(self.kind, dict(self.entries), overrides))

    def resolve(self, name: str, value: str | float) -> tuple[str, float]:
        """Short name and dimensionless value of a parameter given by path or short name: ``("pinion_speed",
        "3600 rpm")`` → ``("omega", 0.942…)``. Raises `CaseError` for a bad value and `UnknownNameError` for
        a name that is no parameter of the family."""
        name = given.a_text("name of a parameter", name)
        if self.kind == PIECEWISE:
            return piecewise.resolve(self.structure, self.name, name, value)
        place = place_for(self.kind, name, value, self.scales.physical)
        if isinstance(place, Problem):
            raise CaseError(self.name, [place])
        short = place.key if isinstance(place, Quantity) else place.path
        known = self.family()[0].defaults
        if short not in known or not isinstance(place, Quantity):
            raise UnknownNameError("parameter to vary", name, {*known, *self._physical_names(known)})
        try:
            stated = read_stated(value, place)
        except ValueRefusedError as error:
            raise CaseError(self.name, [Problem(name, shown(value), error.expected, error.nearest)]) from None
        return short, to_dimensionless(self.scales, place.path, float(stated.value))

    def named(self, name: str, value: object) -> str:
        """The name of the quantity that a name and a value mean together: ``("error", "6 um")`` is
        mesh.error; any other name stays as it is."""
        if self.kind == PIECEWISE or name not in two_way(self.kind):
            return name
        place = place_for(self.kind, name, value, self.scales.physical)
        moved = isinstance(place, Quantity) and not place.path.startswith("dimensionless.")
        return place.path if moved else name

    def _physical_names(self, known: Mapping[str, float]) -> list[str]:
        ways = two_way(self.kind)
        return [path.rpartition(".")[2] for short in known for path in ways.get(short, ())[:-1]]

    def physical(self, short: str, value: ArrayLike) -> list[tuple[str, NDArray[np.float64], str]]:
        """What a parameter's value(s) mean physically: (path, values, unit) for every physical way to name
        it.

        Empty for a case without scales, and for a number that is the same either way.
        """
        if not self.scales.physical:
            return []
        ways = [path for path in two_way(self.kind).get(short, ()) if not path.startswith("dimensionless.")]
        found = []
        for path in ways:
            place = quantities(self.kind)[path]
            if place.dimension != NUMBER and (place.dimension != TORQUE or self.scales.radii is not None):
                si = to_physical(self.scales, path, value)
                found.append((path, np.asarray(si) * float(unit(place.unit).express(1.0)), place.unit))
        return found

    def values(self) -> list[Value]:
        """Every value with unit, provenance and reason: stated ones, defaults, then derived numbers."""
        if self.kind == PIECEWISE:
            return piecewise.values(self.structure, self.entries)
        return values(self)

    def notes(self) -> list[Note]:
        """Conflicts between stated values and what is known otherwise, and how sides without stiffness are
        read; shown, never used."""
        return notes(self)

    @property
    def hash(self) -> str:
        """SHA-256 of all that decides a result: kind and values, not names, texts, reasons or provenance."""
        content: list[object] = [self.kind, sorted((e.key, e.path, e.value) for e in self.entries.values())]
        if self.structure:
            content.append({k: v for k, v in self.structure.items() if k != "parameters"})
        text = json.dumps(content, separators=(",", ":"), sort_keys=True)
        return hashlib.sha256(text.encode()).hexdigest()

    def __hash__(self) -> int:
        """Equal cases have equal ones, so that a case may be a key."""
        return hash(self.hash)

    def to_json(self) -> str:
        """The case as JSON text for another process; `from_json` gives an equal case with an identical
        family."""
        entries = [
            {
                "key": e.key,
                "path": e.path,
                "value": e.value,
                "text": e.text,
                "provenance": e.provenance,
                "reason": e.reason,
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
        """The case that `to_json` wrote. Raises `GearlashError` for anything else."""
        try:
            data = json.loads(text)
            if data["format"] != FORMAT:
                raise GearlashError(f"case JSON of format {data['format']}, this version reads {FORMAT}")
            entries = [
                Entry(e["key"], e["path"], e["value"], e["text"], Provenance(e["provenance"]), e["reason"])
                for e in data["entries"]
            ]
            head = (data["name"], data["kind"], data["description"], data["source"])
            structure = data["structure"] if data["kind"] == PIECEWISE else {}
            return cls(*head, {e.key: e for e in entries}, structure)
        except (ValueError, KeyError, TypeError, AttributeError, OverflowError, RecursionError) as error:
            raise GearlashError(f"not the JSON of a case: {cut(repr(error), 300)}") from None


def load(path_or_name: str | Path, overrides: Mapping[str, object] | None = None) -> Case:
    """The case in a file, or the bundled case of that name, with overrides by path or short name.

    Override values are texts (``"120 um"``) or plain numbers for what has no unit. Raises `CaseError` with
    every problem of the file and of the overrides at once.
    """
    label, text = source_text(path_or_name)
    return loads(text, overrides, label=label)


def loads(text: str, overrides: Mapping[str, object] | None = None, label: str = "case") -> Case:
    """The case in a TOML text; see `load`."""
    text, label = given.a_text("text of a case", text), given.a_text("label", label)
    return from_tables(parse(label, text), overrides, label)


def from_tables(
    raw: Mapping[str, object], overrides: Mapping[str, object] | None = None, label: str = "case"
) -> Case:
    """The case in the tables of a parsed file; see `load`."""
    from .fileschema import check, kind_of  # late: a worker that reads case JSON never needs pydantic

    overrides = given.mapping("overrides", overrides)
    if kind_of(raw)[0] == PIECEWISE:
        return _piecewise_of_tables(raw, overrides, label)
    kind, stated, rest, wrong, problems = check(raw)
    if not kind:
        raise CaseError(label, problems)
    entries, clashes = collect(kind, stated)
    entries, wrong_overrides = override(kind, freeze_reference(entries), overrides)
    draft = _draft(kind, rest, label, entries)
    return _finished(draft, entries, [*problems, *clashes, *wrong_overrides], wrong, label)


def _piecewise_of_tables(raw: Mapping[str, object], overrides: Mapping[str, object], label: str) -> Case:
    from .fileschema import check_head, kind_of

    rest, problems = check_head(PIECEWISE, raw)
    structure, entries, found = piecewise.read(raw)
    entries, wrong = piecewise.override(structure, entries, overrides)
    draft = _draft(PIECEWISE, rest, label, entries, structure)
    return _finished_piecewise(draft, entries, [*kind_of(raw)[1], *problems, *found, *wrong], label)


def _draft(
    kind: str,
    rest: Mapping[str, object],
    label: str,
    entries: Entries,
    structure: piecewise.Structure | None = None,
) -> Case:
    name, source = str(rest.get("name") or name_of_file(Path(label).stem)), rest.get("source")
    about = source if isinstance(source, Mapping) else {}
    return Case(name, kind, str(rest.get("description", "")), about, entries, structure or {})


def _finished(
    draft: Case,
    entries: Entries,
    problems: list[Problem],
    wrong: frozenset[str] = frozenset(),
    label: str = "",
) -> Case:
    """The case with these entries in a fixed order, or a `CaseError`; ``wrong`` are paths stated unusably."""
    problems = [*problems, *missing(draft.kind, entries, wrong)]
    if not problems:
        problems = contradictions(draft.kind, entries)
    if problems:
        raise CaseError(label or draft.name, problems)
    order = {place.key: i for i, place in enumerate(quantities(draft.kind).values())}
    ordered = sorted(entries.items(), key=lambda item: (order.get(item[0], len(order)), item[0]))
    return Case(draft.name, draft.kind, draft.description, draft.source, dict(ordered))


def _finished_piecewise(draft: Case, entries: Entries, problems: list[Problem], label: str = "") -> Case:
    """The piecewise-linear case with these entries in the order of its file, or a `CaseError`."""
    problems = problems or piecewise.contradictions(draft.structure, entries)
    if problems:
        raise CaseError(label or draft.name, problems)
    return replace(draft, entries=piecewise.ordered(draft.structure, entries))
