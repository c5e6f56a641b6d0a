"""What the drawing of a case's teeth is made from."""

from __future__ import annotations

from typing import TypeAlias

from gearlash.case import Case
from gearlash.gears import CylindricalPair

TeethOfCase: TypeAlias = tuple[CylindricalPair, str, float, tuple[float, float] | None, tuple[str, ...]]


def teeth_of_case(case: Case) -> TeethOfCase | None:
    """Arguments of `mesh_drawing`: the pair at 20 °C and nominal centre distance, a title, its backlash and
    face widths in m, and what rests on assumed values; None where the teeth are not known."""
    numbers = case.numbers
    if numbers is None or (pair := numbers.body.drawn) is None:
        return None
    play = float(case.scales.backlash_m(case.family()[0].defaults["D"])) - numbers.play_added
    title = f"{case.name}: {pair.pinion.teeth}/{pair.gear.teeth} teeth in the transverse section"
    if numbers.body.meshing is not numbers.body.teeth:  # as it is drawn, and not as it is at work
        title += ", at 20 °C and nominal centre distance"
    assumed = {value.path for value in case.values() if value.provenance == "assumed" or value.rests_on}
    return pair, title, play, _widths(case), tuple(sorted(assumed))


def _widths(case: Case) -> tuple[float, float] | None:
    """Face widths of both gears, m."""
    found = {value.path: value.value for value in case.values()}
    first, second = (found.get(f"{gear}.face_width") for gear in ("pinion", "gear"))
    return None if first is None or second is None else (1e-3 * float(first), 1e-3 * float(second))
