"""What stated values of a gear pair conflict with, and how sides without stiffness are read."""

from __future__ import annotations

from collections.abc import Iterator

from gearlash.case.kinds.sides import notes_on_sides
from gearlash.case.note import Note
from gearlash.gears import mesh_stiffness
from gearlash.gears.materials import named

from .curves import TABLE
from .pair import GearPair

TOLERATED = 1.5  # times what the standard gives


def notes(pair: GearPair) -> Iterator[Note]:
    """Every remark on a pair."""
    yield from _stiffness(pair)
    yield from _cycles(pair)
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


def _stiffness(pair: GearPair) -> Iterator[Note]:
    body, stated = pair.numbers.body, pair.scales.mean_stiffness
    teeth = body.drawn
    if teeth is None or body.face_width is None or stated is None:
        return
    entry, drawing = pair.entries.get("mesh.mean_stiffness"), pair.completed.drawing
    if entry is None or entry.least is not None:
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
