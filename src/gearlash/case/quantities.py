"""Every quantity that a case may state: its place, what it measures, its range and its short name.

A quantity that may be named in several ways (a backlash or D; a shaft speed, a mesh frequency or omega) has
one *key*, its short name; the paths are the ways. Whatever has one way only is its own key.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cache
from math import pi
from typing import Any

from gearlash.gears import Projection, YAxis
from gearlash.system import ContactRule

from .quantity import Choice, Quantity
from .units import ANGLE, FREQUENCY, INERTIA, LENGTH, MASS, NUMBER, SPEED, STIFFNESS, TORQUE, Dimension

HELICAL, SPUR, PIECEWISE = "helical-pair", "spur-1dof", "piecewise-linear"
GEAR_KINDS = (HELICAL, SPUR)
"""Kinds whose places are listed here; those of a piecewise-linear case are its own parameters."""
KINDS = (*GEAR_KINDS, PIECEWISE)
HIGHEST_HARMONIC = 8
BODY = "model.body"
REFERENCE = "model.reference_length"
BEARINGS = ("yp", "zp", "yg", "zg")
RIGHT_ANGLE = 0.999 * pi / 2.0
LARGEST = 1e9
"""Bound of dimensionless numbers without a bound of their own."""


@cache
def quantities(kind: str) -> Mapping[str, Quantity]:
    """Every quantity of a kind of case, by path."""
    found = [
        *_gear_tables(kind),
        *_mesh_table(kind),
        *_operation_table(),
        *_dimensionless_table(kind),
    ]
    ways = {path: key for key, paths in two_way(kind).items() for path in paths}
    return {q.path: replace(q, key=ways.get(q.path, q.path)) for q in found}


@cache
def choices(kind: str) -> Mapping[str, Choice]:
    """Every named option of a kind of case, by path."""
    found = [
        Choice("model.contact", tuple(ContactRule), ContactRule.ALWAYS, "when the mesh damping acts"),
        Choice(
            BODY, ("solid-disc",), "solid-disc", "gears without stated inertia: m r²/2, r the pitch radius"
        ),
    ]
    what = "radius and factor that turn rotation into displacement"
    if kind == SPUR:
        both = (Projection.BASE.value, Projection.PITCH.value)
        return {c.path: c for c in (*found, Choice("model.projection", both, Projection.BASE, what))}
    found += [
        Choice("model.projection", tuple(Projection), Projection.PITCH, what),
        Choice("model.y_axis", tuple(YAxis), YAxis.PITCH_TANGENT, "direction of the lateral coordinate"),
    ]
    return {c.path: c for c in found}


@cache
def two_way(kind: str) -> Mapping[str, tuple[str, ...]]:
    """Short name → every path that names this quantity, the physical ones first, ``dimensionless.…`` last."""
    ways: dict[str, tuple[str, ...]] = {
        "omega": ("operation.pinion_speed", "operation.mesh_frequency"),
        "D": ("mesh.backlash",),
        "load": ("operation.torque",),
        "mesh_damping": ("mesh.damping_ratio",),
        "back_stiffness": ("mesh.back_stiffness",),
        "back_gap": ("mesh.back_gap",),
        "rotation_factor": (),
    }
    ways |= {name: (f"mesh.{name}",) for name in harmonic_names()}
    if kind == HELICAL:
        ways["bearing_damping"] = ("bearings.damping_ratio",)
        for bearing in BEARINGS:
            axis, gear = bearing[0], "pinion" if bearing[1] == "p" else "gear"
            ways[f"bearing_damping_{bearing}"] = (f"{gear}.bearing_damping_{axis}",)
            ways[f"bearing_frequency_{bearing}"] = (f"{gear}.bearing_stiffness_{axis}",)
        ways |= dict.fromkeys(("y_factor", "z_factor", "mass_ratio_p", "mass_ratio_g"), ())
    return {name: (*paths, f"dimensionless.{name}") for name, paths in ways.items()}


def harmonic_names() -> Iterator[str]:
    """``ripple``, ``ripple_2`` … ``error_phase_8``."""
    for stem in ("ripple", "ripple_phase", "error", "error_phase"):
        yield stem
        yield from (f"{stem}_{order}" for order in range(2, HIGHEST_HARMONIC + 1))


def _gear_tables(kind: str) -> Iterator[Quantity]:
    for gear in ("pinion", "gear"):
        yield _number(f"{gear}.teeth", "28", f"teeth of the {gear}", 5, 2000, integer=True)
        yield _positive(f"{gear}.mass", MASS, "kg", "5.98 kg", f"mass of the {gear}", 1e6)
        yield _positive(f"{gear}.inertia", INERTIA, "kg*m^2", "0.01 kg·m²", f"inertia of the {gear}", 1e9)
        yield _positive(
            f"{gear}.face_width", LENGTH, "mm", "65 mm", f"face width of the {gear}, for notes", 5
        )
        if kind == SPUR:
            yield _positive(f"{gear}.base_radius", LENGTH, "mm", "50 mm", f"base radius of the {gear}", 50)
            continue
        for axis, way in (("y", "lateral"), ("z", "axial")):
            what = f"{way} bearing stiffness of the {gear}"
            yield _positive(f"{gear}.bearing_stiffness_{axis}", STIFFNESS, "N/m", "8e8 N/m", what, 1e13)
            yield _ratio(f"{gear}.bearing_damping_{axis}", f"{way} bearing damping ratio ξ of the {gear}")


def _mesh_table(kind: str) -> Iterator[Quantity]:
    module = "normal_module" if kind == HELICAL else "module"
    yield _positive(f"mesh.{module}", LENGTH, "mm", "4 mm", "normal module m_n", 0.2)
    yield _positive("mesh.pressure_angle", ANGLE, "deg", "20 deg", "normal pressure angle α_n", RIGHT_ANGLE)
    if kind == HELICAL:
        what, right = "helix angle β at the pitch cylinder", RIGHT_ANGLE
        yield Quantity("mesh.helix_angle", ANGLE, "deg", "18 deg", what, -right, right)
        yield _ratio("bearings.damping_ratio", "damping ratio ξ of all four bearing directions")
    else:
        yield _positive("mesh.equivalent_mass", MASS, "kg", "0.23 kg", "mass m_e of relative rotation", 1e6)
    what = "mean mesh stiffness k_m along the line of action"
    yield _positive("mesh.mean_stiffness", STIFFNESS, "N/m", "3.2e8 N/m", what, 1e13)
    yield _ratio("mesh.damping_ratio", "mesh damping ratio ξ_m")
    what = "whole normal backlash b along the line of action"
    yield Quantity("mesh.backlash", LENGTH, "um", "100 um", what, 0.0, 0.02)
    yield from _shared("mesh")
    for name in harmonic_names():
        what = _harmonic(name)
        if "phase" in name:
            yield Quantity(f"mesh.{name}", ANGLE, "deg", "90 deg", what, -100.0, 100.0)
        elif name.startswith("error"):
            yield Quantity(f"mesh.{name}", LENGTH, "um", "5 um", what, -0.01, 0.01)
        else:
            yield _number(f"mesh.{name}", "0.3", what, -2.0, 2.0)


def _operation_table() -> Iterator[Quantity]:
    yield _positive("operation.pinion_speed", SPEED, "rpm", "3600 rpm", "speed of the pinion", 1e6)
    yield _positive("operation.mesh_frequency", FREQUENCY, "Hz", "1680 Hz", "mesh cycles per second", 1e7)
    what = "mean pinion torque; negative loads the back side"
    yield Quantity("operation.torque", TORQUE, "N*m", "450 N·m", what, -1e9, 1e9)
    yield _positive(
        REFERENCE, LENGTH, "um", "50 um", "D_c, the unit of length (default half the backlash)", 1
    )


def _dimensionless_table(kind: str) -> Iterator[Quantity]:
    table = "dimensionless"
    yield _number(f"{table}.omega", "1.047", "mesh frequency over ω_n", 0.0, above=True)
    yield _number(f"{table}.D", "1.0", "half the backlash over D_c", 0.0)
    yield _number(f"{table}.load", "0.09", "mean load f_m = c_t W/(k_m D_c)")
    yield _ratio(f"{table}.mesh_damping", "mesh damping ratio ξ_m")
    yield _number(f"{table}.rotation_factor", "0.8", "c_t², how the mesh force acts on rotation", 1e-6, 4.0)
    yield from _shared(table)
    for name in harmonic_names():
        what = _harmonic(name)
        if "phase" in name:
            yield Quantity(f"{table}.{name}", ANGLE, "rad", "1.57", what, -100.0, 100.0, bare=True)
        elif name.startswith("error"):
            yield _number(f"{table}.{name}", "0.27", f"{what}, over D_c")
        else:
            yield _number(f"{table}.{name}", "0.3", what, -2.0, 2.0)
    if kind != HELICAL:
        return
    yield _ratio(f"{table}.bearing_damping", "damping ratio ξ of all four bearing directions")
    yield _number(f"{table}.y_factor", "0.89", "c_y, how lateral motion enters the mesh", -1.0, 1.0)
    yield _number(f"{table}.z_factor", "0.29", "c_z, how axial motion enters the mesh", -1.0, 1.0)
    for gear in "pg":
        yield _number(f"{table}.mass_ratio_{gear}", "0.43", f"m_e/m_{gear}", 0.0, above=True)
    for bearing in BEARINGS:
        yield _ratio(f"{table}.bearing_damping_{bearing}", f"damping ratio ξ of direction {bearing}")
        what = f"κ of direction {bearing}: its frequency over ω_n"
        yield _number(f"{table}.bearing_frequency_{bearing}", "1.03", what, 0.0, above=True)


def _shared(table: str) -> Iterator[Quantity]:
    yield _number(f"{table}.back_stiffness", "1.0", "stiffness of the back side over the drive side", 0.0)
    yield _number(f"{table}.back_gap", "1.0", "gap of the back side over the drive side", 0.0)


def _harmonic(name: str) -> str:
    last = name.rpartition("_")[2]
    order = last if last.isdigit() else "1"
    what = "stiffness ripple ε" if name.startswith("ripple") else "zero-to-peak transmission error E"
    return f"{'phase of the cosine of the ' if 'phase' in name else ''}{what}, mesh harmonic {order}"


def _number(
    path: str, example: str, what: str, lower: float = -LARGEST, upper: float = LARGEST, **flags: Any
) -> Quantity:
    return Quantity(path, NUMBER, "", example, what, lower, upper, bare=True, **flags)


def _ratio(path: str, what: str) -> Quantity:
    return _number(path, "0.05", what, 0.0, 10.0)


def _positive(path: str, dimension: Dimension, unit: str, example: str, what: str, upper: float) -> Quantity:
    return Quantity(path, dimension, unit, example, what, 0.0, upper, above=True)
