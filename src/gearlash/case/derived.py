"""Numbers that follow from the stated ones, each with its formula and what it was computed from."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gearlash.gears import helical, spur

from .entries import Entry
from .quantities import BODY, HELICAL, REFERENCE, quantities

if TYPE_CHECKING:
    from .case import Case


@dataclass(frozen=True)
class Derived:
    """A number computed from others: ``inputs`` are keys or paths of what went into it."""

    path: str
    value: float
    unit: str
    formula: str
    inputs: tuple[str, ...]
    description: str = ""
    short: str | None = None


def disc_gears(case: Case) -> list[str]:
    """Gears whose inertia is taken from the default body."""
    if (
        not case.scales.physical
        or case.numbers.body.inertias is None
        or "mesh.equivalent_mass" in case.entries
    ):
        return []
    return [gear for gear in ("pinion", "gear") if f"{gear}.inertia" not in case.entries]


def derived(case: Case) -> Iterator[Derived]:
    """Every derived number of a case, inputs before what is computed from them."""
    if case.scales.physical:
        yield from _derived_geometry(case)
        yield from _derived_inertia(case)
        yield from _counterparts(case)
    yield from _derived_frequencies(case)


def _derived_geometry(case: Case) -> Iterator[Derived]:
    body = case.numbers.body
    geometry, line, width = body.geometry, body.line, body.face_width
    if line is None or geometry is None:
        return
    module = "mesh.normal_module" if case.kind == HELICAL else "mesh.module"
    angles = ("mesh.pressure_angle", "mesh.helix_angle")
    radius = (module, *angles, "pinion.teeth", "gear.teeth")
    for i, gear in enumerate(("pinion", "gear")):
        text = f"radius of the {gear} that turns rotation into displacement"
        yield Derived(f"derived.radius_{gear}", 1e3 * line.radii[i], "mm", "model.projection", radius, text)
    yield Derived(
        "derived.c_t", line.c_t, "", "model.projection", angles, "factor of rotation along the mesh"
    )
    if case.kind == HELICAL:
        yield Derived("derived.c_y", line.c_y, "", "model.y_axis", angles, "factor of lateral displacement")
        yield Derived("derived.c_z", line.c_z, "", "sin β_b", angles, "factor of axial displacement")
    ratio = geometry.transverse_contact_ratio
    yield Derived(
        "derived.transverse_contact_ratio", ratio, "", "standard addendum and centre distance", radius, "ε_α"
    )
    if width is not None and case.kind == HELICAL:
        widths = (*radius, "pinion.face_width", "gear.face_width")
        overlap, total = geometry.overlap_ratio(width), geometry.total_contact_ratio(width)
        yield Derived("derived.overlap_ratio", overlap, "", "b sin β/(π m_n)", widths, "ε_β")
        yield Derived("derived.total_contact_ratio", total, "", "ε_α + ε_β", widths, "ε_γ")


def _derived_inertia(case: Case) -> Iterator[Derived]:
    own, scales = case.numbers, case.scales
    discs = disc_gears(case)
    if own.body.inertias is not None:
        for gear, inertia in zip(("pinion", "gear"), own.body.inertias, strict=True):
            if gear in discs:
                inputs = (f"{gear}.mass", f"derived.radius_{gear}", BODY)
                text = f"rotary inertia of the {gear}"
                yield Derived(f"derived.inertia_{gear}", inertia, "kg*m^2", "m r²/2", inputs, text)
    bodies = [name for gear in ("pinion", "gear") for name in _rotation_inputs(gear, gear in discs)]
    mass_inputs = ("mesh.equivalent_mass",) if "mesh.equivalent_mass" in case.entries else tuple(bodies)
    assert scales.equivalent_mass is not None  # a physical case has all scales
    assert scales.omega_n is not None
    yield Derived(
        "derived.equivalent_mass",
        scales.equivalent_mass,
        "kg",
        "1/m_e = R_p²/J_p + R_g²/J_g",
        mass_inputs,
        "m_e",
    )
    inputs = ("mesh.mean_stiffness", "derived.equivalent_mass")
    yield Derived("derived.omega_n", scales.omega_n, "rad/s", "√(k_m/m_e)", inputs, "unit of frequency")
    force = float(scales.force_N(1.0))
    inputs = ("mesh.mean_stiffness", REFERENCE)
    yield Derived("derived.force_unit", force, "N", "k_m D_c", inputs, "force of Φ = 1")


def _rotation_inputs(gear: str, disc: bool) -> tuple[str, ...]:
    inertia = f"derived.inertia_{gear}" if disc else f"{gear}.inertia"
    return f"derived.radius_{gear}", f"{gear}.base_radius", inertia


def _counterparts(case: Case) -> Iterator[Derived]:
    """The dimensionless number of what is stated physically, and the physical one of what is stated as a
    number."""
    parameters = case.family()[0].defaults
    torque = ("mesh.mean_stiffness", REFERENCE, "derived.c_t", "derived.radius_pinion", "pinion.base_radius")
    inputs = {
        "omega": ("omega", "derived.omega_n", "pinion.teeth"),
        "D": () if _half_of_own_backlash(case.entries) else ("D", REFERENCE),
        "load": ("load", *torque),
    }
    for short, value in parameters.items():
        entry = case.entries.get(short)
        if entry is None or not (short in inputs or (short.startswith("error") and "phase" not in short)):
            continue
        needs = inputs.get(short, (short, REFERENCE))
        place = quantities(case.kind)[f"dimensionless.{short}"]
        if not entry.dimensionless:
            yield Derived(place.path, value, "", "from " + entry.path, needs, place.description, short)
        for path, number, unit in case.physical(short, value):
            if path != entry.path:
                text = quantities(case.kind)[path].description
                yield Derived(path, float(number), unit, "from " + entry.path, needs, text, short)
    if case.scales.radii is not None:
        force = float(case.scales.torque(parameters["load"])) / case.scales.radii[0]
        yield Derived(
            "derived.transmitted_force", force, "N", "W = T_p/R_p", ("load", *torque), "mean force W"
        )


def _half_of_own_backlash(entries: Mapping[str, Entry]) -> bool:
    """Is D_c half of the very backlash that D is computed from, so that D = 1 whatever the backlash?"""
    gap, reference = entries.get("D"), entries.get(REFERENCE)
    if gap is None or reference is None or gap.dimensionless:
        return False
    return reference.number == gap.number / 2.0 and reference.reason.startswith("half the backlash")


def _derived_frequencies(case: Case) -> Iterator[Derived]:
    own, factor = case.numbers, case.family()[0].defaults["rotation_factor"]
    fixed = _frequency_inputs(case.entries)
    if own.pair is None:
        frequencies: Iterable[float] = spur.natural_frequencies(factor)
    else:
        frequencies = helical.natural_frequencies(own.pair, factor)
    for i, frequency in enumerate(frequencies, start=1):
        path = f"derived.natural_frequency_{i}"
        text = f"undamped natural frequency {i}, mesh closed at mean stiffness, over ω_n"
        yield Derived(path, float(frequency), "", "undamped, closed mesh", fixed, text)
        if case.scales.physical:
            hz, rpm = float(case.scales.mesh_hz(frequency)), float(case.scales.pinion_rpm(frequency))
            needs = (path, "derived.omega_n", "pinion.teeth")
            yield Derived(f"{path}_hz", hz, "Hz", "ω ω_n/2π", needs, f"natural frequency {i}")
            text = f"pinion speed at which the mesh frequency meets natural frequency {i}"
            yield Derived(f"derived.critical_speed_{i}", rpm, "rpm", "60 f/z_p", needs, text)


def _frequency_inputs(entries: Mapping[str, Entry]) -> tuple[str, ...]:
    stiffness = [key for key in entries if key.startswith(("bearing_frequency", "mass_ratio"))]
    bodies = ("derived.equivalent_mass", "pinion.mass", "gear.mass", "mesh.mean_stiffness")
    return (
        *bodies,
        "derived.c_t",
        "derived.c_y",
        "derived.c_z",
        "rotation_factor",
        "y_factor",
        "z_factor",
        *stiffness,
    )
