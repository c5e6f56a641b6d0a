"""Stated values that can be, but do not fit to each other or to usual gears: told, and used as stated."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import pi

from gearlash.case.note import Note
from gearlash.gears import backlash, bearings
from gearlash.gears.cylindrical_pair import shift_sum
from gearlash.gears.drawing import Drawing
from gearlash.gears.estimates import estimates

from .drawn import CENTRE, MEASURES, PLAY, SPEED_RANGE
from .keys import GEARS
from .own_material import about_materials
from .rules import EntriesByKey

MOST_PLAY = 0.15
"""Of the normal module: more backlash than that is that of no usual fit."""
MOST_WIDTH = 3.0
"""Of the reference diameter of the pinion."""
ROUNDED = 1e-3
"""Of the normal module: so much overlap a rounded shift may leave."""
MOST_SHEAR = 500e6
"""Pa: at about that quenched and tempered steel yields under torsion."""
LEAST_SHAFT = 0.05
"""Of the root diameter of the gear on it."""
DIFFERENT = 0.1
"""Relative, of two backlashes that should be one."""
MOST_ADDED = 1.0
"""Of a gear's own inertia: where more turns with it, its mass is not that of the gear alone either."""


def odd(stated: EntriesByKey, entries: EntriesByKey, drawing: Drawing) -> Iterator[Note]:
    """Every such value of a drawn pair.

    Parameters
    ----------
    stated, entries : mapping
        As the case states them, and with what follows.
    drawing : Drawing
    """
    yield from about_materials(stated, drawing)
    yield from _overlap(stated, entries, drawing)
    yield from _measured(stated, entries, drawing)
    yield from _play(stated, entries, drawing)
    yield from _widths(stated, drawing)
    yield from _shafts(stated, drawing)
    yield from _bending(stated, entries, drawing)
    yield from _speeds(stated, entries)
    yield from _added(stated, entries)
    yield from _weighed(stated, entries, drawing)


def _play_of(stated: EntriesByKey) -> str | None:
    return next((key for key in ("D", PLAY) if key in stated and not stated[key].dimensionless), None)


def _overlap(stated: EntriesByKey, entries: EntriesByKey, drawing: Drawing) -> Iterator[Note]:
    """Shifts whose teeth are too thick for the stated centre distance before anything is taken off them."""
    words = ("profile_shift", "transverse_profile_shift")
    shifts = [stated[f"{g}.{word}"] for g in GEARS for word in words if f"{g}.{word}" in stated]
    if len(shifts) < len(GEARS) or CENTRE not in stated:
        return
    bare = replace(
        drawing.pair,
        pinion=replace(drawing.pair.pinion, thickness_allowance=0.0),
        gear=replace(drawing.pair.gear, thickness_allowance=0.0),
    )
    left, total = backlash.of_pair(bare).normal, sum(one.profile_shift for one in bare.gears)
    if left >= -ROUNDED * bare.pinion.normal_module:
        return
    own = entries["D"].number if "D" in entries and not entries["D"].dimensionless else None
    told = "" if own is None else f", and {1e6 * own:.4g} µm of backlash need {1e6 * (own - left):.4g} µm"
    same = shifts[0].text == shifts[1].text  # one text that stands for both
    one = f"; a shift of one gear alone is written {shifts[0].text}/" if same else ""
    yield Note(
        shifts[0].path,
        f"teeth overlap by {-1e6 * left:.4g} µm along the normal before anything is taken off them: the "
        f"shifts sum to {total:.4g}, and a centre distance of {1e3 * bare.centre_distance:.6g} mm has room "
        f"for {shift_sum(bare):.4g}. Allowances of the tooth thickness must take that off{told}{one}",
    )


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


def _shafts(stated: EntriesByKey, drawing: Drawing) -> Iterator[Note]:
    """Shafts thicker than the gear on them, and those that the torque would twist off."""
    for i, (gear, one) in enumerate(zip(GEARS, drawing.pair.gears, strict=True)):
        paths = f"{gear}.shaft_diameter", f"{gear}.bore"
        entry = next((stated[path] for path in paths if path in stated), None)
        if entry is None:
            continue
        size, root = entry.number, one.root_diameter
        torque = abs(drawing.torque or 0.0) * (drawing.pair.ratio if i else 1.0)
        shear = 16.0 * torque / (pi * size**3)
        if size >= root:
            yield Note(
                entry.path,
                f"{1e3 * size:.4g} mm, not below the root diameter of the {gear}, {1e3 * root:.4g} mm; "
                "bearings are estimated from it",
            )
        elif shear > MOST_SHEAR or size < LEAST_SHAFT * root:
            twisted = f", in which its torque makes {1e-6 * shear:.3g} MPa of shear" if torque else ""
            yield Note(
                entry.path,
                f"a shaft of {1e3 * size:.4g} mm for a root diameter of {1e3 * root:.4g} mm{twisted}; "
                f"hardened steel bears about {1e-6 * MOST_SHEAR:g} MPa, and bearings are estimated from it",
            )


def _bending(stated: EntriesByKey, entries: EntriesByKey, drawing: Drawing) -> Iterator[Note]:
    """Shafts that would bend far more than the bearings estimated on them, which alone are taken."""
    for gear in GEARS:
        span = stated.get(f"{gear}.bearing_span")
        shaft = stated.get(f"{gear}.shaft_diameter") or stated.get(f"{gear}.bore")
        bearing = entries.get(f"bearing_frequency_y{gear[0]}")
        if span is None or shaft is None or bearing is None or not bearing.estimated:
            continue
        bends = bearings.shaft_stiffness(shaft.number, 0.5 * (span.number - drawing.pair.face_width))
        if f"{gear}.shaft_stiffness_y" not in stated and bends < bearing.number / bearings.SPREAD:
            yield Note(
                span.path,
                f"a shaft of {1e3 * shaft.number:.4g} mm all along between bearings "
                f"{1e3 * span.number:.4g} mm apart bends with {bends:.3g} N/m; run and report take the "
                f"bearings, {bearing.number:.3g} N/m, without it: state {gear}.shaft_stiffness_y where it is "
                "so thin all along",
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


def _added(stated: EntriesByKey, entries: EntriesByKey) -> Iterator[Note]:
    """What turns with a gear and is heavier than it, beside bearings that carry the gear alone."""
    for gear in GEARS:
        added, own = stated.get(f"{gear}.added_inertia"), entries.get(f"{gear}.inertia")
        if added is None or own is None or added.number <= MOST_ADDED * own.number:
            continue
        known = any(f"{gear}.{leaf}" in stated for leaf in ("mass", "added_mass"))
        if f"bearing_frequency_y{gear[0]}" in entries and not known:
            mass = entries[f"{gear}.mass"].number
            yield Note(
                added.path,
                f"{added.number / own.number:.3g} times the inertia of the {gear} itself turns with it, but "
                f"the mass on its bearings is that of the {gear} alone, {mass:.3g} kg: state as added_mass "
                "what else they carry; without it their natural frequencies are too high",
            )


def _weighed(stated: EntriesByKey, entries: EntriesByKey, drawing: Drawing) -> Iterator[Note]:
    """A mass that the drawn body cannot have, beside an inertia that is that of this body."""
    for gear in GEARS:
        mass, inertia = stated.get(f"{gear}.mass"), entries.get(f"{gear}.inertia")
        if mass is None or inertia is None or not inertia.estimated:
            continue
        body = estimates(drawing, names=("bodies",))[f"{gear}_mass"]
        if body.least <= mass.number <= body.greatest:
            continue
        yield Note(
            mass.path,
            f"{mass.number:.4g} kg, where the body as drawn has {body.value:.4g} kg ({body.least:.4g} to "
            f"{body.greatest:.4g}); its inertia stays that of the drawn body, {inertia.number:.4g} kg·m²: "
            "state bore, rim and web as they are, or inertia",
        )
