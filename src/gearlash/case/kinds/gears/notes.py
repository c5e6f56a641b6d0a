"""What stated values of a gear pair conflict with, and how sides without stiffness are read."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

import numpy as np

from gearlash.case.kinds.sides import notes_on_sides
from gearlash.case.note import Note
from gearlash.gears import mesh_stiffness
from gearlash.gears.drawing import Drawing
from gearlash.gears.loaded_mesh import LoadedMesh
from gearlash.gears.materials import named
from gearlash.system import evaluate

from . import relief
from .at_torque import loaded_of
from .curves import LOADED, TABLE
from .estimated import is_drawn
from .loaded import is_loaded
from .meshing import normal_force, unusual
from .odd import odd
from .pair import GearPair
from .shared import HIGHEST_HARMONIC
from .thousands import looking_like_thousands
from .written import hand_of

HELIX_ANGLE = "mesh.helix_angle"
TOLERATED = 1.5  # times what the standard gives
RELIEVED = 1.5  # times what one pair of teeth gives way by: more relief than that is for another torque


def notes(pair: GearPair) -> Iterator[Note]:
    """Every remark on a pair."""
    yield from _stiffness(pair)
    yield from _cycles(pair)
    yield from _relief(pair)
    yield from _hand(pair)
    yield from _teeth(pair)
    yield from _jamming(pair)
    for clearance in pair.family().system().clearances:
        yield from notes_on_sides(clearance, "mesh.back_stiffness")


def _cycles(pair: GearPair) -> Iterator[Note]:
    """What a base period of many mesh cycles costs."""
    cycles = pair.numbers.excitation.cycles
    if cycles == 1:
        return
    excitation = pair.numbers.excitation
    turns = [f"{shaft}.runout" for shaft in excitation.runout or {}]
    turns += [f"{TABLE}.{name}" for name, curve in pair.reconstructed.items() if curve.cycles > 1]
    yield Note(
        turns[0],
        f"all repeats after {cycles} mesh cycles only ({', '.join(turns)}): tables, memory and time of "
        f"one motion are about {cycles} times those of one mesh cycle, and P counts {cycles}, {2 * cycles} …",
    )


def _teeth(pair: GearPair) -> Iterator[Note]:
    drawing = pair.completed.drawing if is_drawn(pair.stated) else None
    yield from looking_like_thousands(pair.stated, pair.rules.places, drawing)
    if drawing is not None:
        torque = float(pair.scales.torque(pair.numbers.parameters["load"]))
        yield from unusual(pair.entries, drawing, normal_force(drawing.pair, torque))
        yield from odd(pair.stated, pair.entries, drawing)


def _hand(pair: GearPair) -> Iterator[Note]:
    """Whose helix the hand beside the angle is, and what it is taken for."""
    entry = pair.stated.get(HELIX_ANGLE)
    hand = None if entry is None else hand_of(entry.text)
    if entry is not None and hand is not None:
        other = "right" if hand == "left" else "left"
        yield Note(
            entry.path,
            f"{entry.text} is read as {degrees(entry.number):.6g}°: a {hand}-hand helix of the pinion, and a "
            f"{other}-hand one of the gear",
        )


def _jamming(pair: GearPair) -> Iterator[Note]:
    """A backlash of which tolerances or stated limits leave none at their tight end."""
    gap, more = pair.ranged.get("D"), pair.completed.play_added
    if gap is None or gap.dimensionless:
        return
    least_more = pair.least_play_added
    least = (gap.number if gap.least is None else gap.least) + least_more
    if least >= 0.0 or gap.number + more < 0.0:
        return
    at_work = " at work" if more or least_more else ""
    where, end = " in the middle of the tolerances", "their tight end"
    if not gap.estimated:
        where, end = "", "the tight end of the stated limits"
    yield Note(
        gap.path,
        f"{1e6 * (gap.number + more):.4g} µm of backlash{at_work}{where}; at {end} "
        f"teeth overlap by {-1e6 * least:.4g} µm, and the pair jams",
    )


def _beside(pair: GearPair) -> str:
    """What else makes an error, in the words of the case, and what that is of."""
    curve = pair.curves.get("error", {})
    if is_loaded(pair.stated) or curve.get("state") == LOADED:
        return (
            "beside what is left of the stated one under load, of which stiffness and flanks made their part "
            "at its torque"
        )
    stated = f"[{TABLE}.error]" if curve else "mesh.error"
    return f"beside {stated}, which is that of deviations from the modified flanks"


def _relief(pair: GearPair) -> Iterator[Note]:
    """What is counted of modified flanks, and what is not."""
    drawing = pair.completed.drawing
    mesh = loaded_of(drawing, pair.entries)
    if mesh is None or drawing is None or not drawing.modification.modified:
        return
    path = max(key for key in relief.KEYS & pair.entries.keys() if pair.entries[key].text)
    of_flanks, series = np.ptp(mesh.deflection), mesh.error_series(HIGHEST_HARMONIC)
    size = np.ptp(evaluate(series, np.linspace(0.0, 2.0 * np.pi, 720)))
    yield Note(
        path,
        f"modified flanks at this torque: {1e6 * of_flanks:.3g} µm of static error under load, peak to "
        f"peak, made of the varying stiffness and of {1e6 * size:.3g} µm of error {_beside(pair)}. Left out: "
        "contact lines that change while the force swings about that of this torque",
    )
    yield from _too_much(drawing, mesh, path)
    ripples = [key for key, e in pair.entries.items() if key.startswith("ripple") and not e.estimated]
    stated = [key for key in ripples if "phase" not in key]
    if stated or "stiffness" in pair.curves:
        where = f"{TABLE}.stiffness" if not stated else pair.entries[stated[0]].path
        yield Note(
            where,
            "the stated variation of the stiffness is kept at every torque; with the error of the relief, "
            "which is that of the calculated contact lines, it need not make the loaded error",
        )


def _too_much(drawing: Drawing, mesh: LoadedMesh, path: str) -> Iterator[Note]:
    """Flanks that lack far more at the ends of contact than one pair of teeth gives way by."""
    teeth = drawing.meshing
    gap = float(np.max(drawing.modification.gap(teeth, teeth.path_of_contact)))
    rated = mesh_stiffness.method_b(teeth, drawing.chosen_materials, drawing.rims, drawing.line_load)
    one_pair = rated.single / rated.mean * rated.along_normal(teeth.face_width)
    bent = mesh.force / one_pair
    if drawing.torque is None or not 0.0 < RELIEVED * bent < gap:
        return
    yield Note(
        path,
        f"flanks lack up to {1e6 * gap:.3g} µm where contact begins or ends (along the normal), "
        f"{gap / bent:.2g} times what one pair of teeth gives way by under this torque ({1e6 * bent:.3g} µm, "
        f"{mesh_stiffness.REFERENCE}): {mesh.contact_ratio:.3g} pairs of teeth bear in the mean, of "
        f"ε_α = {teeth.transverse_contact_ratio:.3g}. One pair gives way by as much as they lack at about "
        f"{float(f'{abs(drawing.torque) * gap / bent:.3g}'):g} N·m of the pinion",
    )


def _stiffness(pair: GearPair) -> Iterator[Note]:
    body, stated = pair.numbers.body, pair.scales.mean_stiffness
    teeth = body.drawn
    if teeth is None or body.face_width is None or stated is None:
        return
    entry, drawing = pair.entries.get("mesh.mean_stiffness"), pair.completed.drawing
    if entry is None or entry.estimated:
        return  # an estimate needs no comparison with itself
    materials = named("steel"), named("steel")
    if drawing is not None:
        materials = drawing.chosen_materials
    solid = mesh_stiffness.SOLID, mesh_stiffness.SOLID
    estimate = mesh_stiffness.method_b(teeth, materials, solid).along_normal(body.face_width)
    names = " and ".join(dict.fromkeys(each.name for each in materials))
    ratio = estimate / stated
    if 1.0 / TOLERATED <= ratio <= TOLERATED:
        return
    more, factor = ("stiffer", ratio) if ratio > 1.0 else ("softer", 1.0 / ratio)
    yield Note(
        "mesh.mean_stiffness",
        f"stated {stated:.3g} N/m; {mesh_stiffness.REFERENCE}, gives {estimate:.3g} N/m for solid gears "
        f"of {names} with {1e3 * body.face_width:g} mm of common face width, {factor:.1f} times {more}. "
        "The stated value is used.",
    )
