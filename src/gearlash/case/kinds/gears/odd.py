"""Stated values that can be, but do not fit to each other or to usual gears: told, and used as stated."""

from __future__ import annotations

from collections.abc import Iterator

from gearlash.case.note import Note
from gearlash.gears import backlash
from gearlash.gears.drawing import Drawing

from .drawn import MEASURES, PLAY, SPEED_RANGE
from .keys import GEARS
from .rules import EntriesByKey

MOST_PLAY = 0.15
"""Of the normal module: more backlash than that is that of no usual fit."""
MOST_WIDTH = 3.0
"""Of the reference diameter of the pinion."""
DIFFERENT = 0.1
"""Relative, of two backlashes that should be one."""


def odd(stated: EntriesByKey, entries: EntriesByKey, drawing: Drawing) -> Iterator[Note]:
    """Every such value of a drawn pair.

    Parameters
    ----------
    stated, entries : mapping
        As the case states them, and with what follows.
    drawing : Drawing
    """
    yield from _measured(stated, entries, drawing)
    yield from _play(stated, entries, drawing)
    yield from _widths(stated, drawing)
    yield from _speeds(stated, entries)


def _play_of(stated: EntriesByKey) -> str | None:
    return next((key for key in ("D", PLAY) if key in stated and not stated[key].dimensionless), None)


def _measured(stated: EntriesByKey, entries: EntriesByKey, drawing: Drawing) -> Iterator[Note]:
    """Backlash that is stated, and another one that measured teeth leave."""
    key, words = _play_of(stated), (*MEASURES, "thickness_allowance")
    measured = [next((f"{gear}.{w}" for w in words if f"{gear}.{w}" in stated), None) for gear in GEARS]
    if key is None or None in measured:
        return
    own, left = entries["D"].number, backlash.of_pair(drawing.pair).normal
    if abs(left - own) > DIFFERENT * max(abs(left), abs(own)):
        yield Note(
            stated[key].path,
            f"stated {1e6 * own:.4g} µm along the normal; {measured[0]} and {measured[1]} leave "
            f"{1e6 * left:.4g} µm at a centre distance of {1e3 * drawing.pair.centre_distance:.6g} mm. "
            "The stated one is used",
        )


def _play(stated: EntriesByKey, entries: EntriesByKey, drawing: Drawing) -> Iterator[Note]:
    key, module = _play_of(stated), drawing.pair.pinion.normal_module
    if key is not None and entries["D"].number > MOST_PLAY * module:
        part = entries["D"].number / module
        yield Note(
            stated[key].path,
            f"{part:.2g} m_n of backlash, of teeth that are π/2 m_n thick; usual fits leave less than "
            f"{MOST_PLAY:g} m_n, {1e6 * MOST_PLAY * module:.3g} µm",
        )


def _widths(stated: EntriesByKey, drawing: Drawing) -> Iterator[Note]:
    diameter = drawing.pair.pinion.reference_diameter
    for gear in GEARS:
        entry = stated.get(f"{gear}.face_width")
        if entry is not None and entry.number > MOST_WIDTH * diameter:
            yield Note(
                entry.path,
                f"{entry.number / diameter:.2g} times the reference diameter of the pinion: so wide a face "
                "bears evenly only where it is corrected for bending and torsion",
            )


def _speeds(stated: EntriesByKey, entries: EntriesByKey) -> Iterator[Note]:
    """A nominal speed outside of the range of speed."""
    speed = entries.get("omega")
    if speed is None or speed.path != "operation.pinion_speed":
        return
    least, greatest = (stated.get(path) for path in SPEED_RANGE)
    below = least is not None and speed.number < least.number * (1.0 - 1e-9)
    above = greatest is not None and speed.number > greatest.number * (1.0 + 1e-9)
    if below or above:
        path = SPEED_RANGE[0] if below else SPEED_RANGE[1]
        yield Note(path, "the pinion's speed lies outside of the range of speed that is stated")
