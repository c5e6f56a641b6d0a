"""Places that every gear pair has, in parts that a kind puts into its own order."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import pi
from typing import Any

from gearlash.case.quantity import LARGEST_VALUE, Choice, Quantity
from gearlash.case.units import (
    ANGLE,
    EXPANSION,
    FREQUENCY,
    INERTIA,
    LENGTH,
    MASS,
    NUMBER,
    SPEED,
    STIFFNESS,
    TORQUE,
    Dimension,
)
from gearlash.system import ContactRule

from .keys import BODY, CONTACT, GEARS, REFERENCE

HIGHEST_HARMONIC = 8
RIGHT_ANGLE = 0.999 * pi / 2.0
PROJECTED = "radius and factor that turn rotation into displacement"


def options() -> Iterator[Choice]:
    """Named options; a kind adds its projections."""
    yield Choice(CONTACT, tuple(ContactRule), ContactRule.ALWAYS, "when the mesh damping acts")
    what = "gears without an inertia, stated or of a drawn body: m r²/2, r the pitch radius"
    yield Choice(BODY, ("solid-disc",), "solid-disc", what)


def ways() -> dict[str, tuple[str, ...]]:
    """Short name → its physical paths."""
    found: dict[str, tuple[str, ...]] = {
        "omega": ("operation.pinion_speed", "operation.mesh_frequency"),
        "D": ("mesh.backlash",),
        "load": ("operation.torque",),
        "mesh_damping": ("mesh.damping_ratio",),
        "back_stiffness": ("mesh.back_stiffness",),
        "back_gap": ("mesh.back_gap",),
        "rotation_factor": (),
        **{f"{gear}_{name}": (f"{gear}.{name}",) for gear in GEARS for name in ("runout", "runout_phase")},
        "ripple_scale": (),
        "error_scale": (),
    }
    return found | {name: (f"mesh.{name}",) for name in harmonic_names()}


def harmonic_names() -> Iterator[str]:
    """``ripple``, ``ripple_2`` … ``error_phase_8``."""
    for stem in ("ripple", "ripple_phase", "error", "error_phase"):
        yield stem
        yield from (f"{stem}_{order}" for order in range(2, HIGHEST_HARMONIC + 1))


NO_RING = 'of which there is no model here; kind = "piecewise-linear" takes stiffness, backlash and masses'


OF_SPEEDS = "the range of speed to run in stands at operation.least_speed and operation.greatest_speed"
"""Why a speed has no limits beside it."""
NOMINAL = "it is nominal, and what is made otherwise is told by tooth thickness, span or error"
"""Why a module or an angle of the rack has none."""
OF_OMEGA = "a range of speed is what studies go over with --over"


def of_gear(gear: str) -> Iterator[Quantity]:
    """The table [pinion] or [gear]."""
    inner = f"1 to 4 are mostly those of a worm, below 0 those of an internal gear, {NO_RING}"
    yield number(f"{gear}.teeth", "28", f"teeth of the {gear}", 5, 2000, integer=True, below=inner)
    yield positive(f"{gear}.mass", MASS, "kg", "5.98 kg", f"mass of the {gear}", 1e6)
    yield positive(f"{gear}.inertia", INERTIA, "kg*m^2", "0.01 kg·m²", f"inertia of the {gear}", 1e9)
    what = f"inertia beside that of the {gear} itself, of what turns rigidly with it: shaft, rotor, pulley"
    yield Quantity(f"{gear}.added_inertia", INERTIA, "kg*m^2", "0.002 kg·m²", what, 0.0, 1e9)
    yield positive(f"{gear}.face_width", LENGTH, "mm", "65 mm", f"face width b of the {gear}", 5)
    what = f"radial run-out F_r of the {gear}, twice its eccentricity: an error once a turn"
    yield Quantity(f"{gear}.runout", LENGTH, "um", "20 um", what, 0.0, 0.01)
    what = f"phase of the cosine of the run-out of the {gear}, of its own turn"
    yield Quantity(f"{gear}.runout_phase", ANGLE, "deg", "90 deg", what, -100.0, 100.0)


def of_teeth(module: str, other: str) -> Iterator[Quantity]:
    """The first of the table [mesh]. The module has two names in either kind."""
    for path in (other, module):
        yield nominal(positive(path, LENGTH, "mm", "4 mm", "normal module m_n", 0.2))
    angle = "normal pressure angle α_n"
    yield nominal(positive("mesh.pressure_angle", ANGLE, "deg", "20 deg", angle, RIGHT_ANGLE))


def of_mesh() -> Iterator[Quantity]:
    """The rest of the table [mesh]."""
    what = "mean mesh stiffness k_m along the line of action"
    yield positive("mesh.mean_stiffness", STIFFNESS, "N/m", "3.2e8 N/m", what, 1e13)
    yield ratio("mesh.damping_ratio", "mesh damping ratio ξ_m")
    what = "whole normal backlash j_n along the line of action"
    yield Quantity("mesh.backlash", LENGTH, "um", "100 um", what, 0.0, 0.02)
    yield from _shared("mesh")
    for name in harmonic_names():
        what = _harmonic(name)
        if "phase" in name:
            yield Quantity(f"mesh.{name}", ANGLE, "deg", "90 deg", what, -100.0, 100.0)
        elif name.startswith("error"):
            yield Quantity(f"mesh.{name}", LENGTH, "um", "5 um", what, -0.01, 0.01)
        else:
            yield number(f"mesh.{name}", "0.3", what, -2.0, 2.0)


def of_operation() -> Iterator[Quantity]:
    """The table [operation], and the unit of length."""
    yield speed("operation.pinion_speed", "3600 rpm", "speed of the pinion")
    meshes = positive("operation.mesh_frequency", FREQUENCY, "Hz", "1680 Hz", "mesh cycles per second", 1e7)
    yield replace(meshes, alone=OF_SPEEDS)
    what = "mean pinion torque; negative loads the back side"
    yield Quantity("operation.torque", TORQUE, "N*m", "450 N·m", what, -1e9, 1e9)
    what = "D_c, the unit of length (default half the backlash)"
    alone = "all lengths are told in it"
    yield replace(positive(REFERENCE, LENGTH, "um", "50 um", what, 1), alone=alone)


def of_numbers() -> Iterator[Quantity]:
    """The table [dimensionless]."""
    table = "dimensionless"
    yield number(f"{table}.omega", "1.047", "mesh frequency over ω_n", 0.0, above=True, alone=OF_OMEGA)
    yield number(f"{table}.D", "1.0", "half the backlash over D_c", 0.0)
    yield number(f"{table}.load", "0.09", "mean load f_m = c_t W/(k_m D_c)")
    yield ratio(f"{table}.mesh_damping", "mesh damping ratio ξ_m")
    yield number(f"{table}.rotation_factor", "0.8", "c_t², how the mesh force acts on rotation", 1e-6, 4.0)
    yield from _shared(table)
    for gear in GEARS:
        yield number(f"{table}.{gear}_runout", "0.2", f"radial run-out of the {gear} over D_c", 0.0)
        what = f"phase of the run-out of the {gear}"
        yield Quantity(f"{table}.{gear}_runout_phase", ANGLE, "rad", "1.57", what, -100.0, 100.0, bare=True)
    for name in ("ripple", "error"):
        curve = "stiffness" if name == "ripple" else name
        what = f"factor of what varies of curves.{curve}"
        yield number(f"{table}.{name}_scale", "1.0", what, -100.0, 100.0)
    for name in harmonic_names():
        what = _harmonic(name)
        if "phase" in name:
            yield Quantity(f"{table}.{name}", ANGLE, "rad", "1.57", what, -100.0, 100.0, bare=True)
        elif name.startswith("error"):
            yield number(f"{table}.{name}", "0.27", f"{what}, over D_c")
        else:
            yield number(f"{table}.{name}", "0.3", what, -2.0, 2.0)


def _shared(table: str) -> Iterator[Quantity]:
    yield number(f"{table}.back_stiffness", "1.0", "stiffness of the back side over the drive side", 0.0)
    yield number(f"{table}.back_gap", "1.0", "gap of the back side over the drive side", 0.0)


def _harmonic(name: str) -> str:
    last = name.rpartition("_")[2]
    order = last if last.isdigit() else "1"
    what = "stiffness ripple ε" if name.startswith("ripple") else "zero-to-peak transmission error E"
    return f"{'phase of the cosine of the ' if 'phase' in name else ''}{what}, mesh harmonic {order}"


def number(
    path: str,
    example: str,
    what: str,
    lower: float = -LARGEST_VALUE,
    upper: float = LARGEST_VALUE,
    **flags: Any,
) -> Quantity:
    """A number without unit."""
    return Quantity(path, NUMBER, "", example, what, lower, upper, bare=True, **flags)


def ratio(path: str, what: str) -> Quantity:
    """A damping ratio."""
    return number(path, "0.05", what, 0.0, 10.0)


def speed(path: str, example: str, what: str) -> Quantity:
    """A speed of a shaft."""
    turn = "no sense of rotation is stated here, only the amount"
    return Quantity(path, SPEED, "rpm", example, what, 0.0, 1e6, above=True, below=turn, alone=OF_SPEEDS)


def nominal(place: Quantity) -> Quantity:
    """A quantity of which one value stands there, as it is nominal."""
    return replace(place, alone=NOMINAL)


def expansion(path: str, what: str) -> Quantity:
    """A coefficient of linear thermal expansion; of carbon fibres it is below 0."""
    return Quantity(path, EXPANSION, "um/(m*K)", "11.5 um/(m*K)", what, -1e-4, 1e-3)


def positive(path: str, dimension: Dimension, unit: str, example: str, what: str, upper: float) -> Quantity:
    """A physical quantity above 0."""
    return Quantity(path, dimension, unit, example, what, 0.0, upper, above=True)
