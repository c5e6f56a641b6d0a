"""What carries a gear: bearings, and shaft and housing in series with them; and the mass that they carry."""

from __future__ import annotations

import re
from collections.abc import Iterator

from gearlash.case.quantity import Quantity
from gearlash.case.units import MASS, STIFFNESS

from .keys import GEARS
from .places import Places
from .records import Derived
from .rules import EntriesByKey
from .shared import positive

WAYS = {"y": "lateral", "z": "axial"}
IN_SERIES = ("shaft", "housing")
FORMULA = "1/k = 1/k_bearing + 1/k_shaft + 1/k_housing, of those stated"
_OF_BEARINGS = re.compile(
    r"((pinion|gear)\.)?((bearing|shaft|housing)_(stiffness|damping)_[yz]|added_mass)|bearings(\..*)?|"
    r"(dimensionless\.)?bearing_(damping|frequency)(_[yz][pg])?"
)


def of_gear(gear: str, axis: str) -> Iterator[Quantity]:
    """Shaft and housing of one gear in one direction."""
    for part in IN_SERIES:
        what = f"{WAYS[axis]} stiffness of the {part} of the {gear}, in series with its bearing"
        yield positive(f"{gear}.{part}_stiffness_{axis}", STIFFNESS, "N/m", "5e8 N/m", what, 1e13)


def added_mass(gear: str) -> Quantity:
    """What else moves with a gear on its bearings."""
    what = f"mass beside that of the {gear} itself, of what its bearings carry with it: shaft, rotor, pulley"
    return Quantity(f"{gear}.added_mass", MASS, "kg", "2 kg", what, 0.0, 1e6)


def mass(entries: EntriesByKey, gear: str) -> float:
    """On the bearings of a gear: its own and what is added, kg."""
    keys = f"{gear}.mass", f"{gear}.added_mass"
    return sum(entries[key].number for key in keys if key in entries)


def stiffness(entries: EntriesByKey, gear: str, axis: str) -> float:
    """Of the bearing with what is in series, N/m."""
    own = [entries[_bearing(gear, axis)], *(entries[key] for key in _stated(entries, gear, axis))]
    return own[0].number if len(own) == 1 else 1.0 / sum(1.0 / one.number for one in own)


def derived(entries: EntriesByKey) -> Iterator[Derived]:
    """Stiffnesses that shaft or housing are part of."""
    for gear in GEARS:
        for axis, way in WAYS.items():
            parts = _stated(entries, gear, axis)
            if parts:
                inputs = (_bearing(gear, axis), *parts)
                text = f"{way} stiffness of bearing, shaft and housing of the {gear}"
                path, value = f"derived.support_stiffness_{gear}_{axis}", stiffness(entries, gear, axis)
                yield Derived(path, value, "N/m", FORMULA, inputs, text)


def inputs(entries: EntriesByKey) -> list[str]:
    """Keys of shafts and housings that are stated."""
    return [key for gear in GEARS for axis in WAYS for key in _stated(entries, gear, axis)]


def redundant(entries: EntriesByKey) -> Iterator[tuple[str, str]]:
    """Shafts and housings beside a bearing whose frequency is stated, each with the reason."""
    for gear in GEARS:
        for axis in WAYS:
            bearing = entries.get(_bearing(gear, axis))
            if bearing is not None and bearing.dimensionless:
                for key in _stated(entries, gear, axis):
                    yield (
                        key,
                        f"{bearing.path} is that of all in series; state {gear}.bearing_stiffness_{axis}",
                    )


def no_bearings(places: Places, path: str) -> str | None:
    """What is expected instead of a word of bearings where the kind has none."""
    if "bearing_damping" in places.two_way or not _OF_BEARINGS.fullmatch(path):
        return None
    return 'nothing here: this kind of pair has no bearings; kind = "helical-pair" has them'


def _bearing(gear: str, axis: str) -> str:
    return f"bearing_frequency_{axis}{gear[0]}"


def _stated(entries: EntriesByKey, gear: str, axis: str) -> list[str]:
    keys = (f"{gear}.{part}_stiffness_{axis}" for part in IN_SERIES)
    return [key for key in keys if key in entries]
