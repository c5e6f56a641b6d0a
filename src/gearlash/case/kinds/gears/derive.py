"""Numbers that follow from the stated ones of a gear pair, each with its formula and what it was computed
from."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from . import play, relief
from .at_torque import loaded_of
from .derive_teeth import of_teeth, stiffness_per_width, under_torque
from .keys import BODY, EQUIVALENT_MASS, GEARS, REFERENCE
from .pair import GearPair
from .records import Derived
from .rules import EntriesByKey

FREQUENCY_INPUTS = (
    "derived.equivalent_mass", "pinion.mass", "gear.mass", "pinion.added_mass", "gear.added_mass",
    "mesh.mean_stiffness", "derived.c_t",
)  # fmt: skip


def disc_gears(pair: GearPair) -> list[str]:
    """Gears whose inertia is taken from the default body."""
    if not pair.scales.physical or pair.numbers.body.inertias is None or EQUIVALENT_MASS in pair.entries:
        return []
    return [gear for gear in GEARS if f"{gear}.inertia" not in pair.entries]


def derived(pair: GearPair) -> Iterator[Derived]:
    """Every derived number of a case, inputs before what is computed from them."""
    if pair.scales.physical:
        yield from _derived_geometry(pair)
        yield from _derived_inertia(pair)
        yield from _counterparts(pair)
        yield from pair.rules.support_stiffnesses(pair.entries)
    yield from _derived_frequencies(pair)


def _derived_geometry(pair: GearPair) -> Iterator[Derived]:
    body = pair.numbers.body
    geometry, line, width, teeth = body.geometry, body.line, body.face_width, body.meshing
    if line is None or geometry is None:
        return
    angles = ("mesh.pressure_angle", "mesh.helix_angle")
    radius = (pair.rules.module, *angles, "pinion.teeth", "gear.teeth")
    for i, gear in enumerate(GEARS):
        text = f"radius of the {gear} that turns rotation into displacement"
        yield Derived(f"derived.radius_{gear}", 1e3 * line.radii[i], "mm", "model.projection", radius, text)
    yield Derived(
        "derived.c_t", line.c_t, "", "model.projection", angles, "factor of rotation along the mesh"
    )
    yield from pair.rules.directions(line, angles)
    ratio, how = geometry.transverse_contact_ratio, "standard addendum and centre distance"
    if teeth is not None:
        ratio, how = teeth.transverse_contact_ratio, "path of contact over transverse base pitch"
    yield Derived("derived.transverse_contact_ratio", ratio, "", how, radius, "ε_α")
    if width is not None:
        inputs = (*radius, "pinion.face_width", "gear.face_width")
        yield from pair.rules.overlap(geometry.overlap_ratio(width), ratio, inputs)
    yield from of_teeth(pair)
    yield from _under_load(pair)
    yield from stiffness_per_width(pair)


def _under_load(pair: GearPair) -> Iterator[Derived]:
    """What bears of the flanks under the torque of the case."""
    mesh = loaded_of(pair.completed.drawing, pair.entries)
    if mesh is None:
        return
    stated = tuple(sorted(relief.KEYS & pair.entries.keys()))
    inputs = ("load", "mesh.mean_stiffness", *stated)
    how = "contact lines that bear at this torque"
    text = "ε_α under this torque: pairs of teeth that bear, in the mean"
    yield Derived("derived.loaded_contact_ratio", mesh.contact_ratio, "", how, inputs, text)
    text = "static transmission error under this torque, peak to peak, without deviations of the flanks"
    size = 1e6 * float(np.ptp(mesh.deflection))
    yield Derived("derived.loaded_error", size, "um", how, inputs, text)


def _derived_inertia(pair: GearPair) -> Iterator[Derived]:
    own, scales = pair.numbers, pair.scales
    discs = disc_gears(pair)
    if own.body.inertias is not None:
        for gear, inertia in zip(GEARS, own.body.inertias, strict=True):
            if gear in discs:
                inputs = (f"{gear}.mass", f"derived.radius_{gear}", BODY)
                text = f"rotary inertia of the {gear}"
                added = pair.entries.get(f"{gear}.added_inertia")
                own_part = inertia if added is None else inertia - added.number
                yield Derived(f"derived.inertia_{gear}", own_part, "kg*m^2", "m r²/2", inputs, text)
    bodies = [name for gear in GEARS for name in _rotation_inputs(gear, gear in discs)]
    mass_inputs = (EQUIVALENT_MASS,) if EQUIVALENT_MASS in pair.entries else tuple(bodies)
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
    return f"derived.radius_{gear}", f"{gear}.base_radius", inertia, f"{gear}.added_inertia"


def _counterparts(pair: GearPair) -> Iterator[Derived]:
    """The dimensionless number of what is stated physically, and the physical one of what is stated as a
    number."""
    parameters = pair.family().defaults
    torque = ("mesh.mean_stiffness", REFERENCE, "derived.c_t", "derived.radius_pinion", "pinion.base_radius")
    inputs = {
        "omega": ("omega", "derived.omega_n", "pinion.teeth"),
        "D": ()
        if not play.stated(pair.entries) and _half_of_own_backlash(pair.entries)
        else ("D", REFERENCE),
        "load": ("load", *torque),
    }
    for short, value in parameters.items():
        entry = pair.entries.get(short)
        if entry is None or not (short in inputs or (short.startswith("error") and "phase" not in short)):
            continue
        needs = inputs.get(short, (short, REFERENCE))
        place = pair.places.quantities[f"dimensionless.{short}"]
        if not entry.dimensionless:
            origin = play.AT_WORK if short == "D" and play.act_on(pair.entries) else entry.path
            yield Derived(place.path, value, "", f"from {origin}", needs, place.description, short)
        for path, number, unit in pair.physical(short, value):
            if path != entry.path:
                text, formula = pair.places.quantities[path].description, f"from {entry.path}"
                if path == play.AT_WORK:
                    formula, needs = play.FORMULA, play.inputs(pair.entries)
                yield Derived(path, float(number), unit, formula, needs, text, short)
    if pair.scales.radii is not None:
        force = float(pair.scales.torque(parameters["load"])) / pair.scales.radii[0]
        yield Derived(
            "derived.transmitted_force", force, "N", "W = T_p/R_p", ("load", *torque), "mean force W"
        )
        yield from under_torque(pair)


def _half_of_own_backlash(entries: EntriesByKey) -> bool:
    """Is D_c half of the very backlash that D is computed from, so that D = 1 whatever the backlash?"""
    gap, reference = entries.get("D"), entries.get(REFERENCE)
    if gap is None or reference is None or gap.dimensionless:
        return False
    return reference.number == gap.number / 2.0 and reference.reason.startswith("half the backlash")


def _derived_frequencies(pair: GearPair) -> Iterator[Derived]:
    own, factor = pair.numbers, pair.family().defaults["rotation_factor"]
    fixed = (*FREQUENCY_INPUTS, *pair.rules.frequency_inputs(pair.entries))
    frequencies = pair.rules.natural_frequencies(own, factor)
    for i, frequency in enumerate(frequencies, start=1):
        path = f"derived.natural_frequency_{i}"
        text = f"undamped natural frequency {i}, mesh closed at mean stiffness, over ω_n"
        yield Derived(path, float(frequency), "", "undamped, closed mesh", fixed, text)
        if pair.scales.physical:
            hz, rpm = float(pair.scales.mesh_hz(frequency)), float(pair.scales.pinion_rpm(frequency))
            needs = (path, "derived.omega_n", "pinion.teeth")
            yield Derived(f"{path}_hz", hz, "Hz", "ω ω_n/2π", needs, f"natural frequency {i}")
            text = f"pinion speed at which the mesh frequency meets natural frequency {i}"
            yield Derived(f"derived.critical_speed_{i}", rpm, "rpm", "60 f/z_p", needs, text)
