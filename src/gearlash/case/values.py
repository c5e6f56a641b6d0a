"""Every value of a case, stated and derived, with where it is from and which assumption it rests on."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from .derived import derived, disc_gears
from .quantities import BODY, choices, quantities, two_way
from .quantity import Quantity
from .stated import Provenance
from .units import unit as unit_of
from .value import DERIVED, Value

if TYPE_CHECKING:
    from .case import Case


def values(case: Case) -> list[Value]:
    """Stated values, defaults that took effect, then derived numbers."""
    stated = [*_stated(case), *_defaults(case)]
    assumed = {v.path for v in stated if v.provenance == Provenance.ASSUMED}
    roots: dict[str, tuple[str, ...]] = {v.path: (v.path,) for v in stated if v.path in assumed}
    roots |= {e.key: (e.path,) for e in case.entries.values() if e.path in assumed}
    found = list(stated)
    for d in derived(case):
        rests_on = tuple(dict.fromkeys(root for name in d.inputs for root in roots.get(name, ())))
        roots[d.path] = rests_on
        found.append(Value(d.path, d.value, d.unit, DERIVED, d.formula, d.short, d.description, rests_on))
    return found


def _stated(case: Case) -> Iterator[Value]:
    seen = set()
    for entry in case.entries.values():
        if entry.path in seen:
            continue  # one stated damping ratio of all bearings makes four entries
        seen.add(entry.path)
        place = quantities(case.kind).get(entry.path)
        if place is None:
            what, shown, unit, short = choices(case.kind)[entry.path].description, entry.value, "", None
        else:
            what, shown, unit = place.description, _displayed(entry.number, place), place.unit
            short = place.key if place.key in two_way(case.kind) else None
        yield Value(entry.path, shown, unit, entry.provenance, entry.reason, short, what, text=entry.text)


def _displayed(value: float, place: Quantity) -> float:
    """A value in SI in its display unit, to the 15 digits that survive going there and back."""
    return int(value) if place.integer else float(f"{unit_of(place.unit).express(value):.15g}")


def _defaults(case: Case) -> Iterator[Value]:
    assumed = Provenance.ASSUMED
    for path, choice in choices(case.kind).items():
        takes_effect = path != BODY or disc_gears(case)
        if path not in case.entries and takes_effect and (case.scales.physical or path == "model.contact"):
            yield Value(path, choice.default, "", assumed, "default", None, choice.description)
    for short, value in (("ripple", 0.0), ("error", 0.0), ("back_stiffness", 1.0), ("back_gap", 1.0)):
        if short not in case.entries:
            place = quantities(case.kind)[f"dimensionless.{short}"]
            yield Value(place.path, value, "", assumed, "default: not stated", short, place.description)
