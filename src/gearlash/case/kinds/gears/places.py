"""Every place of a kind of gear pair, and what its names mean.

A quantity that may be named in several ways (a backlash or D; a shaft speed, a mesh frequency or omega) has
one *key*, its short name; the paths are the ways. Whatever has one way only is its own key.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field, replace

from gearlash.case.entries import Entry
from gearlash.case.quantity import Choice, Quantity
from gearlash.case.units import ANGLE, NUMBER


@dataclass(frozen=True)
class Places:
    """Quantities and named options by path.

    ``two_way``: short name → every path that names this quantity, the physical ones first,
    ``dimensionless.…`` last. ``together``: a key of which one statement is one of several others."""

    quantities: Mapping[str, Quantity]
    choices: Mapping[str, Choice]
    two_way: Mapping[str, tuple[str, ...]]
    together: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    @staticmethod
    def of(
        quantities: Iterable[Quantity],
        choices: Iterable[Choice],
        ways: Mapping[str, tuple[str, ...]],
        together: Mapping[str, tuple[str, ...]] | None = None,
        same: Mapping[str, str] | None = None,
    ) -> Places:
        """From the lists of a kind; ``ways`` are the physical ones, ``same`` has a path for which another one
        stands as well."""
        two_way = {name: (*paths, f"dimensionless.{name}") for name, paths in ways.items()}
        keys = {path: key for key, paths in two_way.items() for path in paths} | dict(same or {})
        return Places(
            {q.path: replace(q, key=keys.get(q.path, q.path)) for q in quantities},
            {c.path: c for c in choices},
            two_way,
            together or {},
        )

    @property
    def all(self) -> dict[str, Quantity | Choice]:
        """Quantities, then options."""
        return {**self.quantities, **self.choices}

    def keys(self, place: Quantity | Choice) -> tuple[str, ...]:
        """The keys of the entries that a value at this place makes: one, or several."""
        key = place.key if isinstance(place, Quantity) else place.path
        return self.together.get(key, (key,))

    def chosen(self, entries: Mapping[str, Entry], path: str) -> str:
        """The name of an option: the stated one or the default."""
        return str(entries[path].value) if path in entries else self.choices[path].default

    def physical(self, paths: Collection[str]) -> bool:
        """Do any of these paths name a physical quantity? Ratios and phases mean the same in either kind of
        case."""
        for path in paths:
            place = self.quantities.get(path)
            if place is None or path.startswith("dimensionless."):
                continue
            if place.key not in self.two_way or place.dimension not in (NUMBER, ANGLE):
                return True
        return False


def stated_paths(entries: Mapping[str, Entry]) -> list[str]:
    """Paths by which the entries were named."""
    return [entry.path for entry in entries.values()]
