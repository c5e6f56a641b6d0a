"""Values that look like thousands with a point (4.200 rpm, 206.000 MPa): told as they are read."""

from __future__ import annotations

import re
from collections.abc import Iterator
from math import pi

from gearlash.case.note import Note
from gearlash.case.quantity import Quantity
from gearlash.case.units import (
    DENSITY,
    FREQUENCY,
    INERTIA,
    LENGTH,
    MASS,
    POWER,
    PRESSURE,
    SPEED,
    STIFFNESS,
    TORQUE,
)
from gearlash.gears.drawing import Drawing

from .keys import GEARS
from .own_material import DENSITIES, MODULI
from .places import Places
from .rules import EntriesByKey

_THOUSANDS = re.compile(r"[\s+øØ⌀]*([-−–]?\s*[1-9]\d{0,2}\.\d{3})(?!\d)", re.ASCII)
FASTEST = 2e4
"""rad/s."""
FASTEST_MESH = 1e5
"""Hz."""
MOST_LOAD = 2e6
"""N/m: line load that no gear of today bears for long."""
STIFFEST = 1e11
"""N/m per metre of face width, of meshes five times what steel has; bearings are no stiffer."""
MOST_PLAY = 0.15
"""Of the normal module: of lengths that drawings tell in µm."""
HEAVIEST = 10.0
"""Times a solid gear of steel, and likewise its inertia."""
STEEL = 7830.0


def looking_like_thousands(stated: EntriesByKey, places: Places, drawing: Drawing | None) -> Iterator[Note]:
    """Of all quantities of which a thousand times as much would be usual, too.

    Parameters
    ----------
    stated : mapping
    places : Places
    drawing : Drawing, optional
        Of which the sizes are usual; without one only speeds and frequencies are told.
    """
    for entry in stated.values():
        found, place = _THOUSANDS.match(entry.text), places.quantities.get(entry.path)
        if found is None or place is None:
            continue
        number = float(re.sub(r"[-−–]\s*", "-", found[1]))
        if _usual(place, 1e3 * abs(entry.number), drawing):
            yield Note(
                entry.path,
                f"{entry.text} is read with a decimal point, as {number:g}; thousands are written "
                f"without one, {found[1].replace('.', '')}",
            )


def _usual(place: Quantity, value: float, drawing: Drawing | None) -> bool:
    """Could the quantity be as large as that?"""
    if place.dimension in (SPEED, FREQUENCY):
        return value <= (FASTEST if place.dimension == SPEED else FASTEST_MESH)
    if place.dimension in (PRESSURE, DENSITY):
        least, greatest = MODULI if place.dimension == PRESSURE else DENSITIES
        return least <= value <= greatest
    return drawing is not None and place.accepts(value) and value <= _most(place, value, drawing)


def _most(place: Quantity, value: float, drawing: Drawing) -> float:
    pair = drawing.pair
    width, gear = pair.face_width, pair.gears[1 if place.path.startswith(GEARS[1]) else 0]
    if place.dimension == LENGTH:
        sizes = 1.5 * sum(one.tip_diameter for one in pair.gears)
        return MOST_PLAY * pair.pinion.normal_module if place.unit == "um" else sizes
    if place.dimension == STIFFNESS:
        return STIFFEST * width
    solid = HEAVIEST * STEEL * 0.25 * pi * gear.tip_diameter**2 * width
    if place.dimension in (MASS, INERTIA):
        return solid if place.dimension == MASS else 0.125 * solid * gear.tip_diameter**2
    if place.dimension == POWER:  # the torque of the drawing follows from it
        return value if 1e3 * (drawing.line_load or MOST_LOAD) <= MOST_LOAD else 0.0
    if place.dimension == TORQUE:
        ratio = pair.ratio if "gear" in place.path else 1.0
        return 0.5 * MOST_LOAD * width * pair.pinion.reference_diameter * ratio
    return 0.0
