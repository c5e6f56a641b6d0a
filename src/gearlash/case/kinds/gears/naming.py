"""Which parameter of a gear pair is meant by a name and a value."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from gearlash.case.errors import CaseError, Problem, shown
from gearlash.case.quantity import Quantity
from gearlash.case.stated import ValueRefusedError, read_one
from gearlash.case.units import unit
from gearlash.gears.backlash import Backlash
from gearlash.system import UnknownNameError

from . import play
from .drawn import GEAR_RANGE, GEAR_SPEED, GEAR_TORQUE, PLAY, POWERED, SPEED_RANGE
from .entries import place_for, place_of
from .keys import GEARS, REFERENCE
from .pair import GearPair
from .units import to_dimensionless, to_physical


@dataclass(frozen=True)
class InOtherWords:
    """A quantity that says a parameter in other words: the path that is another word for it, and what one of
    the quantity (SI) is there, which may not be known of a pair."""

    short: str
    base: str
    factor: Callable[[GearPair], float | None]


def _ratio(pair: GearPair) -> float | None:
    return (
        pair.entries["gear.teeth"].number / pair.entries["pinion.teeth"].number if has_teeth(pair) else None
    )


def _one_over_ratio(pair: GearPair) -> float | None:
    ratio = _ratio(pair)
    return None if ratio is None else 1.0 / ratio


def _one_over_speed(pair: GearPair) -> float | None:
    """Torque over power at the speed of the case, as `converted` has it of a stated power."""
    if not has_teeth(pair):
        return None
    return 1.0 / float(to_physical(pair.scales, "operation.pinion_speed", pair.numbers.parameters["omega"]))


def _along_normal(pair: GearPair) -> float | None:
    """Normal backlash over that on the working circle; not where it is another one at work."""
    drawing = pair.completed.drawing
    if drawing is None or play.act_on(pair.entries):
        return None
    return Backlash.from_circumferential(drawing.pair, 1.0).normal


AT_GEAR = {
    GEAR_SPEED: InOtherWords("omega", "operation.pinion_speed", _ratio),
    GEAR_TORQUE: InOtherWords("load", "operation.torque", _one_over_ratio),
}
OTHER_WORDS = {
    **AT_GEAR,
    POWERED: InOtherWords("load", "operation.torque", _one_over_speed),
    PLAY: InOtherWords("D", play.STATED, _along_normal),
}


def resolve(pair: GearPair, label: str, name: str, value: object) -> tuple[str, float]:
    """Short name and dimensionless value of a parameter given by path or short name. Raises `CaseError` for
    a bad value and `UnknownNameError` for a name that is no parameter of the family."""
    place = place_for(pair.places, name, value, pair.scales.physical)
    if isinstance(place, Problem):
        raise CaseError(label, [place])
    known = pair.family().defaults
    word = OTHER_WORDS.get(place.path)
    factor = None if word is None else word.factor(pair)
    if word is not None and factor is not None and isinstance(place, Quantity) and word.short in known:
        there = _stated(label, name, value, place) * factor
        return word.short, to_dimensionless(pair.scales, word.base, there)
    cold = place.path == play.STATED and play.act_on(pair.entries) and place.path in known
    short = place.path
    if isinstance(place, Quantity) and place.key in known and not cold:
        short = place.key
    if short not in known and isinstance(place, Quantity) and _has_no_value(pair, place):
        expected = f"a quantity that the case has a value of, and it has none: state {place.path} in its file"
        raise CaseError(label, [Problem(name, None, expected)])
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


def _has_no_value(pair: GearPair, place: Quantity) -> bool:
    """Might it vary if it were stated?"""
    never = place.path in (REFERENCE, *SPEED_RANGE, *GEAR_RANGE) or place.path.startswith("dimensionless.")
    there = any(key in pair.entries for key in pair.places.keys(place))
    return pair.scales.physical and not never and not there


def has_teeth(pair: GearPair) -> bool:
    """Whether the numbers of teeth are known, and what is of the gear can be told for the pinion."""
    return pair.scales.physical and all(f"{gear}.teeth" in pair.entries for gear in GEARS)


def at_gear(pair: GearPair, short: str) -> tuple[str, float, str] | None:
    """Path, value and unit at the gear of a parameter of 1; None of what is no speed or torque."""
    for path, word in AT_GEAR.items():
        factor = word.factor(pair)
        if word.short == short and path in pair.places.quantities and factor is not None:
            place = pair.places.quantities[path]
            si = float(to_physical(pair.scales, word.base, 1.0)) / factor
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
    word = OTHER_WORDS.get(place.path)
    if word is not None and word.factor(pair) is not None:
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
