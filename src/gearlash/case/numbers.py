"""From entries to numbers: what is missing or contradictory, then family parameters, fixed numbers and
scales."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from math import pi, sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.gears import (
    HelicalPair,
    LineOfAction,
    Projection,
    ToothGeometry,
    YAxis,
    equivalent_mass,
    line_of_action,
    solid_disc,
)
from gearlash.gears.mesh import harmonic_count, series
from gearlash.system import ContactRule, evaluate

from .entries import Entries
from .errors import Problem
from .quantities import BEARINGS, HELICAL, REFERENCE, choices, quantities, two_way
from .scales import Scales
from .units import ANGLE, NUMBER

Pair = tuple[float, float]


@dataclass(frozen=True)
class Body:
    """The physical pair behind the numbers; what a case does not know is None."""

    geometry: ToothGeometry | None
    line: LineOfAction | None
    inertias: Pair | None
    face_width: float | None


@dataclass(frozen=True)
class Numbers:
    """Family parameters by short name, the fixed numbers of a helical pair, the contact rule, scales and
    body."""

    parameters: dict[str, float]
    pair: HelicalPair | None
    contact: ContactRule
    scales: Scales
    body: Body


def is_physical(kind: str, paths: Collection[str]) -> bool:
    """Do any of these paths name a physical quantity? Ratios and phases mean the same in either kind of
    case."""
    for path in paths:
        place = quantities(kind).get(path)
        if place is None or path.startswith("dimensionless."):
            continue
        if place.key not in two_way(kind) or place.dimension not in (NUMBER, ANGLE):
            return True
    return False


def _stated_paths(entries: Entries) -> list[str]:
    return [entry.path for entry in entries.values()]


def missing(kind: str, entries: Entries, present: Collection[str] = ()) -> list[Problem]:
    """Quantities that must be stated and are not; ``present`` are paths known to be stated, if wrongly.

    A file that states nothing at all is taken for a physical one.
    """
    places, paths = quantities(kind), [*_stated_paths(entries), *present]
    known = {*entries, *(places[path].key for path in present if path in places)}
    physical = is_physical(kind, paths) or not any(path.startswith("dimensionless.") for path in paths)
    problems = []
    for key in _required(kind, entries, physical, known):
        if key in known or (key == "bearing_damping" and all(f"{key}_{b}" in known for b in BEARINGS)):
            continue
        ways = two_way(kind).get(key, (key,))
        place = places[ways[0]]
        other = f" (or {', '.join(ways[1:])})" if len(ways) > 1 else ""
        why = "; there is no backlash to take half of" if key == REFERENCE else ""
        problems.append(Problem(place.path, None, f"{place.expected}{other}{why}", missing=True))
    return problems


def _required(kind: str, entries: Entries, physical: bool, known: Collection[str]) -> Iterator[str]:
    yield from ("omega", "D", "load", "mesh_damping")
    if physical:
        yield from ("mesh.mean_stiffness", "pinion.teeth")
        if "D" in entries:
            yield REFERENCE
    if kind == HELICAL:
        damped = any(f"bearing_damping_{b}" in known for b in BEARINGS)
        yield from (f"bearing_damping_{b}" for b in BEARINGS) if damped else ("bearing_damping",)
        yield from (f"bearing_frequency_{b}" for b in BEARINGS)
        if physical:
            yield from ("gear.teeth", "pinion.mass", "gear.mass")
            yield from (f"mesh.{name}" for name in ("normal_module", "pressure_angle", "helix_angle"))
        else:
            yield from ("rotation_factor", "y_factor", "z_factor", "mass_ratio_p", "mass_ratio_g")
    elif physical:
        yield from _required_of_spur_bodies(entries, known)


def _required_of_spur_bodies(entries: Entries, known: Collection[str]) -> Iterator[str]:
    """Inertias and radii, unless the equivalent mass is stated; a torque needs radii in any case."""
    lumped = "mesh.equivalent_mass" in known
    for gear in ("pinion", "gear"):
        if not lumped and f"{gear}.mass" not in known:
            yield f"{gear}.inertia"
    if lumped and ("load" not in entries or entries["load"].dimensionless):
        return
    if any(f"{gear}.base_radius" in known for gear in ("pinion", "gear")):
        yield from ("pinion.base_radius", "gear.base_radius")
    else:
        yield from ("gear.teeth", "mesh.module", "mesh.pressure_angle")


def contradictions(kind: str, entries: Entries) -> list[Problem]:
    """Quantities stated although others determine them, and values that no gear pair can have together."""
    problems = []
    if is_physical(kind, _stated_paths(entries)):
        for key, because in _redundant(kind, entries):
            entry = entries[key]
            problems.append(Problem(entry.path, repr(entry.text), f"nothing here: {because}"))
    ripples = {
        k: e.number for k, e in entries.items() if k.startswith("ripple") and isinstance(e.value, float)
    }
    if _least_stiffness(ripples) < 0.0:
        entry = entries[next(k for k in sorted(ripples) if "phase" not in k)]
        expected = "ripples that leave the mesh stiffness positive all round a mesh cycle"
        problems.append(Problem(entry.path, repr(entry.text), expected))
    return problems


def _redundant(kind: str, entries: Entries) -> Iterator[tuple[str, str]]:
    if kind == HELICAL:
        for key in ("y_factor", "z_factor", "mass_ratio_p", "mass_ratio_g"):
            if key in entries:
                yield key, "it follows from the angles and masses of this physical case"
        return
    base = [key for key in ("pinion.base_radius", "gear.base_radius") if key in entries]
    for key in base:
        if "mesh.module" in entries:
            yield key, "it follows from mesh.module, teeth and mesh.pressure_angle"
        elif _chosen(kind, entries, "model.projection") == Projection.PITCH:
            yield key, "model.projection = pitch needs mesh.module and mesh.pressure_angle instead"
    if "mesh.equivalent_mass" in entries and all(f"{gear}.inertia" in entries for gear in ("pinion", "gear")):
        yield "mesh.equivalent_mass", "it follows from both inertias and radii"


def _least_stiffness(ripples: dict[str, float]) -> float:
    count = harmonic_count(ripples, "ripple")
    stems = ("ripple", "ripple_phase")
    names = [f"{stem}_{n}" if n > 1 else stem for n in range(1, count + 1) for stem in stems]
    full = {name: ripples.get(name, 0.0) for name in names}
    return float(np.min(evaluate(series(full, "ripple", 1.0, count), np.linspace(0.0, 2.0 * pi, 721))))


def numbers(kind: str, entries: Entries) -> Numbers:
    """The numbers of a complete case (no `missing` and no `contradictions`)."""
    contact = ContactRule(_chosen(kind, entries, "model.contact"))
    nothing = Body(None, None, None, None), Scales()
    body, scales = _physical(kind, entries) if is_physical(kind, _stated_paths(entries)) else nothing
    pair = _helical_pair(entries, body, scales, contact) if kind == HELICAL else None
    parameters = {
        key: to_dimensionless(scales, entry.path, entry.number)
        for key, entry in entries.items()
        if key in two_way(kind) and not key.startswith(("bearing_frequency", "mass_ratio", "y_", "z_"))
    }
    if kind != HELICAL and body.line is not None:
        parameters.setdefault("rotation_factor", body.line.c_t**2)
    return Numbers(parameters, pair, contact, scales, body)


def to_dimensionless(scales: Scales, path: str, value: float) -> float:
    """The parameter value of a quantity in SI that stands at this path."""
    table, _, leaf = path.partition(".")
    if leaf == "pinion_speed":
        return float(scales.omega_from_pinion_speed(value))
    if leaf == "mesh_frequency":
        return float(scales.omega_from_hz(value))
    if leaf == "backlash":
        return float(scales.half_backlash_from_m(value))
    if leaf == "torque":
        return float(scales.load_from_torque(value))
    if table == "mesh" and leaf.startswith("error") and "phase" not in leaf:
        return float(scales.displacement_from_m(value))
    return value


def to_physical(scales: Scales, path: str, value: ArrayLike) -> NDArray[np.float64]:
    """The quantity in SI at this path of a parameter's value(s): the inverse of `to_dimensionless`."""
    table, _, leaf = path.partition(".")
    if leaf == "pinion_speed":
        return scales.pinion_speed(value)
    if leaf == "mesh_frequency":
        return scales.mesh_hz(value)
    if leaf == "backlash":
        return scales.backlash_m(value)
    if leaf == "torque":
        return scales.torque(value)
    if table == "mesh" and leaf.startswith("error") and "phase" not in leaf:
        return scales.length_m(value)
    return np.asarray(value, float)


def _chosen(kind: str, entries: Entries, path: str) -> str:
    return str(entries[path].value) if path in entries else choices(kind)[path].default


def _get(entries: Entries, key: str) -> float | None:
    return entries[key].number if key in entries else None


def _physical(kind: str, entries: Entries) -> tuple[Body, Scales]:
    geometry = _geometry(kind, entries)
    line = _line(kind, entries, geometry)
    inertias = _inertias(entries, geometry, line)
    mass = _get(entries, "mesh.equivalent_mass")
    if mass is None:
        assert line is not None  # `missing` saw to it
        assert inertias is not None
        mass = equivalent_mass(line.radii, inertias)
    stiffness, gear_teeth = entries["mesh.mean_stiffness"].number, _get(entries, "gear.teeth")
    widths = [w for gear in ("pinion", "gear") if (w := _get(entries, f"{gear}.face_width")) is not None]
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
    return Body(geometry, line, inertias, min(widths) if len(widths) == 2 else None), scales


def _geometry(kind: str, entries: Entries) -> ToothGeometry | None:
    module = "mesh.normal_module" if kind == HELICAL else "mesh.module"
    if not all(key in entries for key in ("pinion.teeth", "gear.teeth", module, "mesh.pressure_angle")):
        return None
    return ToothGeometry(
        teeth=(int(entries["pinion.teeth"].number), int(entries["gear.teeth"].number)),
        normal_module=entries[module].number,
        pressure_angle=entries["mesh.pressure_angle"].number,
        helix_angle=_get(entries, "mesh.helix_angle") or 0.0,
    )


def _line(kind: str, entries: Entries, geometry: ToothGeometry | None) -> LineOfAction | None:
    if geometry is not None:
        y_axis = YAxis(_chosen(kind, entries, "model.y_axis")) if kind == HELICAL else YAxis.LINE_OF_ACTION
        return line_of_action(geometry, Projection(_chosen(kind, entries, "model.projection")), y_axis)
    radii = _get(entries, "pinion.base_radius"), _get(entries, "gear.base_radius")
    if radii[0] is None or radii[1] is None:
        return None
    return LineOfAction((radii[0], radii[1]), c_t=1.0, c_y=1.0, c_z=0.0)


def _inertias(entries: Entries, geometry: ToothGeometry | None, line: LineOfAction | None) -> Pair | None:
    """Stated inertias, else solid discs of the stated masses at the pitch radius (at the base radius when
    that is all that is known)."""
    radii = geometry.pitch_radii if geometry else line.radii if line else None
    found = []
    for i, gear in enumerate(("pinion", "gear")):
        inertia, mass = _get(entries, f"{gear}.inertia"), _get(entries, f"{gear}.mass")
        if inertia is None and mass is not None and radii is not None:
            inertia = solid_disc(mass, radii[i])
        found.append(inertia)
    return (found[0], found[1]) if None not in found else None


def _helical_pair(entries: Entries, body: Body, scales: Scales, contact: ContactRule) -> HelicalPair:
    kappa = [entries[f"bearing_frequency_{b}"] for b in BEARINGS]
    if body.line is None or scales.equivalent_mass is None or scales.omega_n is None:
        c_t2, c_y, c_z = (entries[key].number for key in ("rotation_factor", "y_factor", "z_factor"))
        ratios = entries["mass_ratio_p"].number, entries["mass_ratio_g"].number
        frequencies = [entry.number for entry in kappa]
    else:
        c_t2, c_y, c_z = body.line.c_t**2, body.line.c_y, body.line.c_z
        m_p, m_g = entries["pinion.mass"].number, entries["gear.mass"].number
        ratios = scales.equivalent_mass / m_p, scales.equivalent_mass / m_g
        frequencies = [
            entry.number if entry.dimensionless else sqrt(entry.number / mass) / scales.omega_n
            for entry, mass in zip(kappa, (m_p, m_p, m_g, m_g), strict=True)
        ]
    yp, zp, yg, zg = frequencies
    return HelicalPair(c_t2, c_y, c_z, ratios, (yp, zp, yg, zg), contact)
