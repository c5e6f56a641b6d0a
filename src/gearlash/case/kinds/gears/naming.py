"""Which parameter of a gear pair is meant by a name and a value."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gearlash.case.errors import CaseError, Problem, shown
from gearlash.case.quantity import Quantity
from gearlash.case.stated import ValueRefusedError, read_one
from gearlash.case.units import unit
from gearlash.system import UnknownNameError

from . import play
from .drawn import GEAR_SPEED, GEAR_TORQUE, SPEED_RANGE
from .entries import place_for, place_of
from .keys import GEARS, REFERENCE
from .pair import GearPair
from .units import to_dimensionless, to_physical


@dataclass(frozen=True)
class OfGear:
    """A quantity of the gear that is one of the pinion times the ratio to a power: the parameter it means."""

    short: str
    pinion: str
    power: int


AT_GEAR = {
    GEAR_SPEED: OfGear("omega", "operation.pinion_speed", 1),
    GEAR_TORQUE: OfGear("load", "operation.torque", -1),
}


def resolve(pair: GearPair, label: str, name: str, value: object) -> tuple[str, float]:
    """Short name and dimensionless value of a parameter given by path or short name. Raises `CaseError` for
    a bad value and `UnknownNameError` for a name that is no parameter of the family."""
    place = place_for(pair.places, name, value, pair.scales.physical)
    if isinstance(place, Problem):
        raise CaseError(label, [place])
    known = pair.family().defaults
    of_gear = AT_GEAR.get(place.path)
    if of_gear is not None and isinstance(place, Quantity) and of_gear.short in known and has_teeth(pair):
        at_pinion = _stated(label, name, value, place) * _ratio(pair) ** of_gear.power
        return of_gear.short, to_dimensionless(pair.scales, of_gear.pinion, at_pinion)
    cold = place.path == play.STATED and play.act_on(pair.entries) and place.path in known
    short = place.path
    if isinstance(place, Quantity) and place.key in known and not cold:
        short = place.key
    if short not in known or not isinstance(place, Quantity):
        raise UnknownNameError("parameter to vary", name, {*known, *_physical_names(pair, known)})
    number = _stated(label, name, value, place)
    if cold:
        return short, number
    more = pair.completed.play_added if place.path == play.STATED else 0.0
    return short, to_dimensionless(pair.scales, place.path, number + more)


def _stated(label: str, name: str, value: object, place: Quantity) -> float:
    """A value in SI."""
    try:
        return float(read_one(value, place).value)
    except ValueRefusedError as error:
        raise CaseError(label, [Problem(name, shown(value), error.expected, error.nearest)]) from None


def _ratio(pair: GearPair) -> float:
    return pair.entries["gear.teeth"].number / pair.entries["pinion.teeth"].number


def has_teeth(pair: GearPair) -> bool:
    """Whether the numbers of teeth are known, and what is of the gear can be told for the pinion."""
    return pair.scales.physical and all(f"{gear}.teeth" in pair.entries for gear in GEARS)


def at_gear(pair: GearPair, short: str) -> tuple[str, float, str] | None:
    """Path, value and unit at the gear of a parameter of 1; None of what is no speed or torque."""
    for path, of_gear in AT_GEAR.items():
        if of_gear.short == short and path in pair.places.quantities and has_teeth(pair):
            place = pair.places.quantities[path]
            si = float(to_physical(pair.scales, of_gear.pinion, 1.0)) / _ratio(pair) ** of_gear.power
            return path, si * float(unit(place.unit).express(1.0)), place.unit
    return None


def to_vary(pair: GearPair, name: str) -> str | None:
    """The path of a quantity of the case that is no parameter of its model; None for one that is. Raises
    `UnknownNameError` for what this case does not have, and `CaseError` for a name of several."""
    known = pair.family().defaults
    place = place_of(pair.places, name)
    if isinstance(place, Problem):
        raise CaseError(name, [place])
    cold = place.path == play.STATED and play.act_on(pair.entries)
    if place.path in AT_GEAR and has_teeth(pair):
        return None
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
