"""Every place of a spur pair: those of all pairs, base radii and the equivalent mass."""

from __future__ import annotations

from collections.abc import Iterator

from gearlash.case.kinds.gears import drawn, loaded, play, shared
from gearlash.case.kinds.gears.keys import EQUIVALENT_MASS, GEARS, PROJECTION
from gearlash.case.kinds.gears.places import Places
from gearlash.case.kinds.gears.shared import positive
from gearlash.case.quantity import Choice, Quantity
from gearlash.case.units import LENGTH, MASS
from gearlash.gears import Projection

MODULE, OTHER_MODULE = "mesh.module", "mesh.normal_module"
RADII = tuple(f"{gear}.base_radius" for gear in GEARS)


def _quantities() -> Iterator[Quantity]:
    for gear in GEARS:
        yield from shared.of_gear(gear)
        yield from drawn.of_gear(gear)
        yield from play.of_gear(gear)
        yield positive(f"{gear}.base_radius", LENGTH, "mm", "50 mm", f"base radius of the {gear}", 50)
    yield from shared.of_teeth(MODULE, OTHER_MODULE)
    yield positive(EQUIVALENT_MASS, MASS, "kg", "0.23 kg", "mass m_e of relative rotation", 1e6)
    yield from shared.of_mesh()
    yield from drawn.of_mesh()
    yield from play.of_mesh()
    yield from loaded.quantities()
    yield from shared.of_operation()
    yield from drawn.of_operation()
    yield from shared.of_numbers()


def _choices() -> Iterator[Choice]:
    yield from shared.options()
    yield from drawn.options()
    yield from play.options()
    both = (Projection.BASE.value, Projection.PITCH.value)
    yield Choice(PROJECTION, both, Projection.BASE, shared.PROJECTED)


SAME = {OTHER_MODULE: MODULE, play.AT_WORK: "D"}
PLACES = Places.of(_quantities(), _choices(), shared.ways(), drawn.BOTH_WIDTHS, SAME)
