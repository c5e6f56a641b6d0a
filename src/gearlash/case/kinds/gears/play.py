"""The pair at work: what temperatures and the deviation of the centre distance make of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from gearlash.case.errors import Problem
from gearlash.case.quantity import Choice, Quantity
from gearlash.case.units import LENGTH, TEMPERATURE
from gearlash.gears import CylindricalPair
from gearlash.gears.backlash import Growth, of_pair
from gearlash.gears.materials import MATERIALS, named

from .keys import GEARS
from .places import Places
from .rules import EntriesByKey
from .shared import expansion
from .written import material

OF_DRAWINGS = 20.0
"""°C."""
ALL, HOUSING, HOUSING_MATERIAL = "mesh.temperature", "mesh.housing_temperature", "mesh.housing_material"
OWN_EXPANSIONS = "pinion.thermal_expansion", "gear.thermal_expansion", "mesh.housing_thermal_expansion"
STATED, AT_WORK = "mesh.backlash", "mesh.backlash_at_work"
FORMULA = "mesh.backlash, and what expansion and centre distance add (ISO 21771-1)"
DEVIATION = "mesh.centre_distance_deviation"
KEYS = (*(f"{gear}.temperature" for gear in GEARS), ALL, HOUSING, DEVIATION)


def of_gear(gear: str) -> Iterator[Quantity]:
    """What the table [pinion] or [gear] may hold."""
    yield _temperature(f"{gear}.temperature", f"temperature of the {gear} at work")


def of_mesh() -> Iterator[Quantity]:
    """What the table [mesh] may hold."""
    yield _temperature(ALL, "temperature at work of gears and housing, where none of their own is stated")
    yield _temperature(HOUSING, "temperature of the housing at work")
    what = "coefficient of linear thermal expansion of the housing, in place of that of its material"
    yield expansion(OWN_EXPANSIONS[2], what)
    what = "whole normal backlash at work, in place of the stated one at 20 °C"
    yield Quantity(AT_WORK, LENGTH, "um", "100 um", what, 0.0, 0.02)
    what = "how much the centre distance is above its nominal value, at 20 °C"
    yield Quantity(DEVIATION, LENGTH, "um", "20 um", what, -0.002, 0.002)


def options() -> Iterator[Choice]:
    """Named options."""
    yield Choice(
        HOUSING_MATERIAL, tuple(MATERIALS), "grey-cast-iron", "material of the housing", reader=material
    )


def _temperature(path: str, what: str) -> Quantity:
    return Quantity(path, TEMPERATURE, "degC", "60 degC", what, -60.0, 300.0)


def stated(entries: EntriesByKey) -> list[str]:
    """Keys that change the backlash."""
    return [key for key in KEYS if key in entries]


def added(places: Places, entries: EntriesByKey, pair: CylindricalPair) -> float:
    """What the normal backlash at work has more than the stated one, m. Raises `GearlashError` for teeth that
    do not mesh."""
    if not stated(entries):
        return 0.0
    return of_pair(_moved(entries, pair), _growth(places, entries)).normal - of_pair(pair).normal


def at_work(places: Places, entries: EntriesByKey, pair: CylindricalPair) -> CylindricalPair | None:
    """The pair at the centre distance that its gears, grown themselves, have at work; None where it is the
    nominal one. All is told in lengths of the gears at 20 °C: what grows with them changes no angle and no
    contact ratio."""
    if not stated(entries):
        return None
    growth, moved = _growth(places, entries), _moved(entries, pair)
    bases = [one.base_diameter for one in pair.gears]
    grown = (growth.pinion * bases[0] + growth.gear * bases[1]) / sum(bases)
    distance = moved.centre_distance * (1.0 + growth.housing) / (1.0 + grown)
    return replace(pair, stated_centre_distance=distance)


def _growth(places: Places, entries: EntriesByKey) -> Growth:
    rises = [_rise(entries, key) for key in (*(f"{gear}.temperature" for gear in GEARS), HOUSING)]
    materials = (*(f"{gear}.material" for gear in GEARS), HOUSING_MATERIAL)
    expansions = [
        entries[own].number if own in entries else named(places.chosen(entries, key)).expansion
        for own, key in zip(OWN_EXPANSIONS, materials, strict=True)
    ]
    return Growth(*(a * rise for a, rise in zip(expansions, rises, strict=True)))


def _moved(entries: EntriesByKey, pair: CylindricalPair) -> CylindricalPair:
    """With the deviation of the centre distance, at 20 °C."""
    deviation = entries[DEVIATION].number if DEVIATION in entries else 0.0
    return replace(pair, stated_centre_distance=pair.centre_distance + deviation)


def _rise(entries: EntriesByKey, key: str) -> float:
    entry = entries.get(key, entries.get(ALL))
    return 0.0 if entry is None else entry.number - OF_DRAWINGS


def temperatures(entries: EntriesByKey) -> dict[str, float]:
    """Of pinion and gear at work, °C."""
    return {gear: OF_DRAWINGS + _rise(entries, f"{gear}.temperature") for gear in GEARS}


def unusable(entries: EntriesByKey) -> tuple[Problem, ...]:
    """Words of this page where no teeth are known that they could act on."""
    expected = "teeth, module and helix angle beside it, which tell how the backlash follows it"
    return tuple(Problem(entries[key].path, repr(entries[key].text), expected) for key in stated(entries)[:1])


def jammed(entries: EntriesByKey, more: float) -> Iterator[Problem]:
    """A backlash of which none is left at work."""
    play = entries.get("D")
    if stated(entries) and play is not None and play.path == STATED and play.number + more < 0.0:
        taken = f"{-1e6 * more:.4g} µm"
        expected = (
            f"more than {taken}, as of {1e6 * play.number:.4g} µm of backlash temperatures and centre "
            f"distance take {taken}"
        )
        yield Problem(STATED, repr(play.text) if play.text else None, expected)


def act_on(entries: EntriesByKey) -> bool:
    """Whether the backlash at work is another one than the stated one."""
    gap = entries.get("D")
    return gap is not None and gap.path == STATED and bool(stated(entries))


def inputs(entries: EntriesByKey) -> tuple[str, ...]:
    """What the backlash at work follows from."""
    own = (key for key in OWN_EXPANSIONS if key in entries)
    return "D", *stated(entries), *(f"{gear}.material" for gear in GEARS), HOUSING_MATERIAL, *own
