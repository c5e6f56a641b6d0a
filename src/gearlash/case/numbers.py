"""From entries to numbers: family parameters, the fixed numbers of the pair, scales."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

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
from gearlash.system import ContactRule

from .checks import chosen, is_physical, stated_paths
from .entries import Entries
from .quantities import BEARINGS, HELICAL, REFERENCE, two_way
from .scales import Scales

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
    """Family parameters by short name, the fixed numbers of a helical pair, contact rule, scales, body."""

    parameters: dict[str, float]
    pair: HelicalPair | None
    contact: ContactRule
    scales: Scales
    body: Body


def numbers(kind: str, entries: Entries) -> Numbers:
    """The numbers of a complete case (no `missing` and no `contradictions`)."""
    contact = ContactRule(chosen(kind, entries, "model.contact"))
    nothing = Body(None, None, None, None), Scales()
    body, scales = _physical(kind, entries) if is_physical(kind, stated_paths(entries)) else nothing
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


def _get(entries: Entries, key: str) -> float | None:
    return entries[key].number if key in entries else None


def _physical(kind: str, entries: Entries) -> tuple[Body, Scales]:
    geometry = _geometry(kind, entries)
    line = _line(kind, entries, geometry)
    inertias = _inertias(entries, geometry)
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
        y_axis = YAxis(chosen(kind, entries, "model.y_axis")) if kind == HELICAL else YAxis.LINE_OF_ACTION
        return line_of_action(geometry, Projection(chosen(kind, entries, "model.projection")), y_axis)
    radii = _get(entries, "pinion.base_radius"), _get(entries, "gear.base_radius")
    if radii[0] is None or radii[1] is None:
        return None
    return LineOfAction((radii[0], radii[1]), c_t=1.0, c_y=1.0, c_z=0.0)


def _inertias(entries: Entries, geometry: ToothGeometry | None) -> Pair | None:
    """Stated inertias, else solid discs of the stated masses at the pitch radius."""
    radii = geometry.pitch_radii if geometry else None
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
