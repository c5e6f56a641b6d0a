"""Kinds of gear pair as kinds of case."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

from gearlash.case.entries import Entry
from gearlash.case.errors import Problem
from gearlash.case.kinds.kind import Content, Draft, Excitation, Kind, Structure
from gearlash.case.note import Note
from gearlash.case.scales import Scales
from gearlash.case.value import Value
from gearlash.system import Family

from .curves import TABLE, read_curves
from .curves_schema import curves_schema
from .entries import collect, freeze_reference, override
from .estimated import Completed, complete, estimated_beside
from .excitation import Curves, teeth_of
from .held import held
from .mean_stiffness import KEY as MEAN_STIFFNESS
from .mean_stiffness import with_mean_stiffness
from .naming import at_gear, named, resolve, to_vary
from .notes import notes
from .pair import GearPair
from .records import Numbers
from .rules import PairRules
from .supports import no_bearings
from .values import values

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

VARIED = "varied"
KEPT = "estimated_beside"
"""Stems of harmonics of which an override states some: the others stay as they are estimated."""
"""Where the structure of a case lists the paths of what varies beside the parameters of its model."""


@dataclass(frozen=True)
class GearContent(Content):
    """A gear pair: all of it is in the entries, which are those that were stated, but for what varies."""

    rules: PairRules

    @property
    def curves(self) -> Curves:
        """Stated curves by name."""
        return self.structure.get(TABLE, {})

    @cached_property
    def pair(self) -> GearPair:
        varied, kept = (tuple(self.structure.get(name, ())) for name in (VARIED, KEPT))
        return GearPair(self.rules, self.entries, self.curves, varied, kept)

    @property
    def completed(self) -> Completed:
        """Stated values with what is estimated."""
        return self.pair.completed

    def family(self) -> Family:
        return self.pair.family()

    @property
    def scales(self) -> Scales:
        return self.pair.scales

    @property
    def numbers(self) -> Numbers:
        return self.pair.numbers

    def missing(self, present: Collection[str] = ()) -> list[Problem]:
        return self.pair.lacks(present)

    def contradictions(self) -> list[Problem]:
        return self.pair.contradicted()

    def override(self, overrides: Mapping[str, object]) -> tuple[Content, list[Problem]]:
        entries, problems = override(self.rules.places, self.entries, overrides)
        kept = sorted({*self.structure.get(KEPT, ()), *estimated_beside(self.pair.entries, entries)})
        structure = {**self.structure, KEPT: kept} if kept else self.structure
        return replace(self, entries=entries, structure=structure), problems

    def resolve(self, label: str, name: str, value: object) -> tuple[str, float]:
        return resolve(self.pair, label, name, value)

    def varying(self, name: str) -> Content:
        path = to_vary(self.pair, name)
        varied = self.structure.get(VARIED, ())
        if path is None or path in varied:
            return self
        return replace(self, structure={**self.structure, VARIED: [*varied, path]})

    def named(self, name: str, value: object) -> str:
        return named(self.pair, name, value)

    def physical(self, short: str, value: ArrayLike) -> list[tuple[str, NDArray[np.float64], str]]:
        return self.pair.physical(short, value)

    def at_gear(self, short: str) -> tuple[str, float, str] | None:
        return at_gear(self.pair, short)

    def held(self, name: str) -> str:
        return held(self.pair, name)

    def rebuilt(self, short: str) -> bool:
        return "." in short or (short == "load" and self.pair.completed.follows_torque)

    def values(self) -> list[Value]:
        return values(self.pair)

    def notes(self) -> list[Note]:
        return list(notes(self.pair))


class GearKind(Kind):
    """The kind of pairs with these rules."""

    between_teeth = True
    excitation = Excitation(
        "nothing excites this pair: no ripple, no error", "give ripple or error", "give a load, or an error"
    )

    def __init__(self, rules: PairRules):
        self.rules, self.name, self.places = rules, rules.name, rules.places.all

    def content(self, entries: Mapping[str, Entry], structure: Structure) -> GearContent:
        return GearContent(self, entries, structure, self.rules)

    def read(self, tables: Mapping[str, object]) -> Draft:
        found = self.tables.read({key: value for key, value in tables.items() if key != TABLE})
        entries, clashes = collect(self.rules.places, found.stated)
        curves, wrong = read_curves(tables.get(TABLE, {}), teeth_of(entries))
        entries, twice = with_mean_stiffness(self.rules.places, entries, curves)
        completed = complete(self.rules, entries, curves).entries
        content = self.content(freeze_reference(entries, completed), {TABLE: curves} if curves else {})
        lost = {MEAN_STIFFNESS} if any(p.path.startswith(f"{TABLE}.stiffness") for p in wrong) else set()
        told = [self._told(problem) for problem in found.problems]
        return Draft(content, [*told, *clashes, *twice, *wrong], found.present | lost)

    def _told(self, problem: Problem) -> Problem:
        """With the reason why a word of bearings has no place in this kind."""
        why = None if problem.path in self.places else no_bearings(self.rules.places, problem.path)
        return problem if why is None else Problem(problem.path, problem.value, why)

    def schema(self, source: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
        found = self.tables.schema(source)
        found[self.name]["properties"][TABLE] = curves_schema()
        return found
