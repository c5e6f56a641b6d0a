"""From entries to numbers: family parameters, the fixed numbers of the pair, scales."""

from __future__ import annotations

from dataclasses import replace
from math import cos, sqrt

from gearlash.case.scales import Scales
from gearlash.gears import (
    CylindricalPair,
    LineOfAction,
    Projection,
    ToothGeometry,
    YAxis,
    equivalent_mass,
    line_of_action,
    solid_disc,
)
from gearlash.gears.drawing import Drawing
from gearlash.system import ContactRule

from .excitation import Curves, excitation
from .keys import CONTACT, EQUIVALENT_MASS, GEARS, PROJECTION, REFERENCE
from .places import stated_paths
from .play import STATED
from .records import Body, Both, Numbers
from .rules import EntriesByKey, PairRules
from .units import to_dimensionless


def numbers(
    rules: PairRules,
    entries: EntriesByKey,
    drawing: Drawing | None = None,
    curves: Curves | None = None,
    play_added: float = 0.0,
) -> Numbers:
    """The numbers of a complete case (no `missing` and no `contradictions`); its ``drawing``, where known,
    its curves, and what its backlash has more at work (m)."""
    places = rules.places
    contact = ContactRule(places.chosen(entries, CONTACT))
    nothing = Body(None, None, None, None), Scales()
    body, scales = _physical(rules, entries, drawing) if places.physical(stated_paths(entries)) else nothing
    more = {STATED: play_added}
    parameters = {
        key: to_dimensionless(scales, entry.path, entry.number + more.get(entry.path, 0.0))
        for key, entry in entries.items()
        if key in places.two_way and key not in rules.fixed
    }
    pair = rules.pair(entries, body, scales, contact)
    excited = excitation(curves or {}, entries, scales, _runout_factor(body.geometry), drawing)
    return Numbers(parameters, pair, contact, scales, body, excited, play_added)


def _runout_factor(geometry: ToothGeometry | None) -> float:
    """Amplitude of the error along the normal to the teeth over radial run-out."""
    return 0.5 if geometry is None else 0.5 * cos(geometry.base_helix_angle)


def _get(entries: EntriesByKey, key: str) -> float | None:
    return entries[key].number if key in entries else None


def _physical(rules: PairRules, entries: EntriesByKey, drawing: Drawing | None) -> tuple[Body, Scales]:
    geometry = geometry_of(rules, entries)
    teeth, meshing = (None, None) if drawing is None else (drawing.pair, drawing.meshing)
    line = _at_work(line_of(rules, entries, geometry), meshing, rules.y_axis(entries))
    inertias = _inertias(entries, geometry)
    mass = _get(entries, EQUIVALENT_MASS)
    if mass is None:
        assert line is not None  # `missing` saw to it
        assert inertias is not None
        mass = equivalent_mass(line.radii, inertias)
    stiffness, gear_teeth = entries["mesh.mean_stiffness"].number, _get(entries, "gear.teeth")
    widths = [w for gear in GEARS if (w := _get(entries, f"{gear}.face_width")) is not None]
    scales = Scales(
        omega_n=sqrt(stiffness / mass),
        mean_stiffness=stiffness,
        equivalent_mass=mass,
        length=entries[REFERENCE].number,
        c_t=line.c_t if line else 1.0,
        radii=line.radii if line else None,
        teeth=(int(entries["pinion.teeth"].number), None if gear_teeth is None else int(gear_teeth)),
        back_gap=entries["back_gap"].number if "back_gap" in entries else 1.0,
    )
    width = min(widths) if len(widths) == 2 else None
    rims = (None, None) if drawing is None else drawing.rims
    return Body(geometry, line, inertias, width, teeth, meshing, rims), scales


def geometry_of(rules: PairRules, entries: EntriesByKey) -> ToothGeometry | None:
    """The teeth as far as a model needs them; None where they are not stated."""
    if not all(key in entries for key in ("pinion.teeth", "gear.teeth", rules.module, "mesh.pressure_angle")):
        return None
    return ToothGeometry(
        teeth=(int(entries["pinion.teeth"].number), int(entries["gear.teeth"].number)),
        normal_module=entries[rules.module].number,
        pressure_angle=entries["mesh.pressure_angle"].number,
        helix_angle=_get(entries, "mesh.helix_angle") or 0.0,
    )


def line_of(rules: PairRules, entries: EntriesByKey, geometry: ToothGeometry | None) -> LineOfAction | None:
    """Radii and direction factors; None where neither teeth nor base radii are stated."""
    if geometry is not None:
        projection = Projection(rules.places.chosen(entries, PROJECTION))
        return line_of_action(geometry, projection, rules.y_axis(entries))
    radii = _get(entries, "pinion.base_radius"), _get(entries, "gear.base_radius")
    if radii[0] is None or radii[1] is None:
        return None
    return LineOfAction((radii[0], radii[1]), c_t=1.0, c_y=1.0, c_z=0.0)


def _at_work(line: LineOfAction | None, teeth: CylindricalPair | None, axis: YAxis) -> LineOfAction | None:
    """With the working pressure angle of shifted teeth: how far the tangent of the pitch circles and the line
    of action lie apart."""
    if line is None or teeth is None or axis is YAxis.LINE_OF_ACTION:
        return line
    along = cos(teeth.working_pressure_angle) * cos(teeth.pinion.base_helix_angle)
    return replace(line, c_y=along)


def _inertias(entries: EntriesByKey, geometry: ToothGeometry | None) -> Both | None:
    """Stated inertias and those of drawn bodies, else solid discs of the masses at the pitch radius; and what
    turns with them."""
    radii = geometry.pitch_radii if geometry else None
    found = []
    for i, gear in enumerate(GEARS):
        inertia, mass = _get(entries, f"{gear}.inertia"), _get(entries, f"{gear}.mass")
        if inertia is None and mass is not None and radii is not None:
            inertia = solid_disc(mass, radii[i])
        if inertia is not None:
            inertia += _get(entries, f"{gear}.added_inertia") or 0.0
        found.append(inertia)
    return (found[0], found[1]) if None not in found else None
