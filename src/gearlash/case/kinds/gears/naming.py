"""Which parameter of a gear pair is meant by a name and a value."""

from __future__ import annotations

from collections.abc import Mapping

from gearlash.case.errors import CaseError, Problem, shown
from gearlash.case.quantity import Quantity
from gearlash.case.stated import ValueRefusedError, read_stated
from gearlash.system import UnknownNameError

from . import play
from .drawn import SPEED_RANGE
from .entries import place_for, place_of
from .keys import REFERENCE
from .pair import GearPair
from .units import to_dimensionless


def resolve(pair: GearPair, label: str, name: str, value: object) -> tuple[str, float]:
    """Short name and dimensionless value of a parameter given by path or short name. Raises `CaseError` for
    a bad value and `UnknownNameError` for a name that is no parameter of the family."""
    place = place_for(pair.places, name, value, pair.scales.physical)
    if isinstance(place, Problem):
        raise CaseError(label, [place])
    known = pair.family().defaults
    cold = place.path == play.STATED and play.act_on(pair.entries) and place.path in known
    short = place.path
    if isinstance(place, Quantity) and place.key in known and not cold:
        short = place.key
    if short not in known or not isinstance(place, Quantity):
        raise UnknownNameError("parameter to vary", name, {*known, *_physical_names(pair, known)})
    try:
        stated = read_stated(value, place)
    except ValueRefusedError as error:
        raise CaseError(label, [Problem(name, shown(value), error.expected, error.nearest)]) from None
    if cold:
        return short, float(stated.value)
    more = pair.completed.play_added if place.path == play.STATED else 0.0
    return short, to_dimensionless(pair.scales, place.path, float(stated.value) + more)


def to_vary(pair: GearPair, name: str) -> str | None:
    """The path of a quantity of the case that is no parameter of its model; None for one that is. Raises
    `UnknownNameError` for what this case does not have, and `CaseError` for a name of several."""
    known = pair.family().defaults
    place = place_of(pair.places, name)
    if isinstance(place, Problem):
        raise CaseError(name, [place])
    cold = place.path == play.STATED and play.act_on(pair.entries)
    if place.path in known or (isinstance(place, Quantity) and place.key in known and not cold):
        return None
    entry = pair.entries.get(pair.places.keys(place)[0])
    varies = isinstance(place, Quantity) and place.path not in (
        REFERENCE,
        *SPEED_RANGE,
        f"dimensionless.{place.key}",
    )
    if varies and entry is not None and not entry.dimensionless and pair.scales.physical:
        return place.path
    stated = [e.path for e in pair.entries.values() if e.path in pair.places.quantities]
    raise UnknownNameError("quantity to vary", name, {*known, *stated})


def named(pair: GearPair, name: str, value: object) -> str:
    """The path of the physical quantity that a short name means with this value; else the name."""
    if name not in pair.places.two_way:
        return name
    place = place_for(pair.places, name, value, pair.scales.physical)
    moved = isinstance(place, Quantity) and not place.path.startswith("dimensionless.")
    return place.path if moved else name


def _physical_names(pair: GearPair, known: Mapping[str, float]) -> list[str]:
    ways = pair.places.two_way
    return [path.rpartition(".")[2] for short in known for path in ways.get(short, ())[:-1]]
