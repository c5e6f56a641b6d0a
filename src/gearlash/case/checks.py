"""What a case lacks, and what in it contradicts what else it states."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from math import pi

import numpy as np

from gearlash.gears import Projection
from gearlash.gears.mesh import harmonic_count, series
from gearlash.system import evaluate

from .entries import Entries
from .errors import Problem
from .quantities import BEARINGS, HELICAL, REFERENCE, choices, quantities, two_way
from .units import ANGLE, NUMBER


def chosen(kind: str, entries: Entries, path: str) -> str:
    """The name of an option: the stated one or the default."""
    return str(entries[path].value) if path in entries else choices(kind)[path].default


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


def stated_paths(entries: Entries) -> list[str]:
    """Paths by which the entries were named."""
    return [entry.path for entry in entries.values()]


def missing(kind: str, entries: Entries, present: Collection[str] = ()) -> list[Problem]:
    """Quantities that must be stated and are not; ``present`` are paths known to be stated, if wrongly.

    A file that states nothing at all is taken for a physical one.
    """
    places, paths = quantities(kind), [*stated_paths(entries), *present]
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
    base = any(f"{gear}.base_radius" in known for gear in ("pinion", "gear"))
    for gear in ("pinion", "gear"):
        # A solid disc has the pitch radius, which a base radius alone does not give.
        if not lumped and (base or f"{gear}.mass" not in known):
            yield f"{gear}.inertia"
    if lumped and ("load" not in entries or entries["load"].dimensionless):
        return
    if base:
        yield from ("pinion.base_radius", "gear.base_radius")
    else:
        yield from ("gear.teeth", "mesh.module", "mesh.pressure_angle")


def contradictions(kind: str, entries: Entries) -> list[Problem]:
    """Quantities stated although others determine them, and values that no gear pair can have together."""
    problems = []
    if is_physical(kind, stated_paths(entries)):
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
        elif chosen(kind, entries, "model.projection") == Projection.PITCH:
            yield key, "model.projection = pitch needs mesh.module and mesh.pressure_angle instead"
    if "mesh.equivalent_mass" in entries and all(f"{gear}.inertia" in entries for gear in ("pinion", "gear")):
        yield "mesh.equivalent_mass", "it follows from both inertias and radii"


def _least_stiffness(ripples: dict[str, float]) -> float:
    count = harmonic_count(ripples, "ripple")
    stems = ("ripple", "ripple_phase")
    names = [f"{stem}_{n}" if n > 1 else stem for n in range(1, count + 1) for stem in stems]
    full = {name: ripples.get(name, 0.0) for name in names}
    return float(np.min(evaluate(series(full, "ripple", 1.0, count), np.linspace(0.0, 2.0 * pi, 721))))
