"""Every value of a case, stated and derived, with where it is from and which assumption it rests on."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gearlash.gears import helical, spur

from .entries import Entry
from .quantities import BODY, HELICAL, REFERENCE, choices, quantities, two_way
from .quantity import Quantity
from .stated import Provenance
from .units import unit as unit_of

if TYPE_CHECKING:
    from .case import Case

DERIVED = "derived"


@dataclass(frozen=True)
class Value:
    """One value as shown to a person.

    ``value`` is in ``unit``; ``provenance`` is a `Provenance` or ``derived`` (``reason`` is then the
    formula); ``rests_on`` names the assumed values that a derived number was computed from; ``text`` is
    what was written.
    """

    path: str
    value: float | str
    unit: str
    provenance: str
    reason: str
    short: str | None = None
    description: str = ""
    rests_on: tuple[str, ...] = ()
    text: str = ""

    @property
    def uncertain(self) -> bool:
        """Is it assumed, or computed from something assumed?"""
        return self.provenance == Provenance.ASSUMED or bool(self.rests_on)


@dataclass(frozen=True)
class _Derived:
    path: str
    value: float
    unit: str
    formula: str
    inputs: tuple[str, ...]
    description: str = ""
    short: str | None = None


def values(case: Case) -> list[Value]:
    """Stated values, defaults that took effect, then derived numbers."""
    stated = [*_stated(case), *_defaults(case)]
    assumed = {v.path for v in stated if v.provenance == Provenance.ASSUMED}
    roots: dict[str, tuple[str, ...]] = {v.path: (v.path,) for v in stated if v.path in assumed}
    roots |= {e.key: (e.path,) for e in case.entries.values() if e.path in assumed}
    found = list(stated)
    for d in _derived(case):
        rests_on = tuple(dict.fromkeys(root for name in d.inputs for root in roots.get(name, ())))
        roots[d.path] = rests_on
        found.append(Value(d.path, d.value, d.unit, DERIVED, d.formula, d.short, d.description, rests_on))
    return found


def _stated(case: Case) -> Iterator[Value]:
    seen = set()
    for entry in case.entries.values():
        if entry.path in seen:
            continue  # one stated damping ratio of all bearings makes four entries
        seen.add(entry.path)
        place = quantities(case.kind).get(entry.path)
        if place is None:
            what, shown, unit, short = choices(case.kind)[entry.path].description, entry.value, "", None
        else:
            what, shown, unit = place.description, _displayed(entry.number, place), place.unit
            short = place.key if place.key in two_way(case.kind) else None
        yield Value(entry.path, shown, unit, entry.provenance, entry.reason, short, what, text=entry.text)


def _displayed(value: float, place: Quantity) -> float:
    """A value in SI in its display unit, to the 15 digits that survive going there and back."""
    return int(value) if place.integer else float(f"{unit_of(place.unit).express(value):.15g}")


def _defaults(case: Case) -> Iterator[Value]:
    assumed = Provenance.ASSUMED
    for path, choice in choices(case.kind).items():
        takes_effect = path != BODY or _disc_gears(case)
        if path not in case.entries and takes_effect and (case.scales.physical or path == "model.contact"):
            yield Value(path, choice.default, "", assumed, "default", None, choice.description)
    for short, value in (("ripple", 0.0), ("error", 0.0), ("back_stiffness", 1.0), ("back_gap", 1.0)):
        if short not in case.entries:
            place = quantities(case.kind)[f"dimensionless.{short}"]
            yield Value(place.path, value, "", assumed, "default: not stated", short, place.description)


def _disc_gears(case: Case) -> list[str]:
    """Gears whose inertia is taken from the default body."""
    if (
        not case.scales.physical
        or case.numbers.body.inertias is None
        or "mesh.equivalent_mass" in case.entries
    ):
        return []
    return [gear for gear in ("pinion", "gear") if f"{gear}.inertia" not in case.entries]


def _derived(case: Case) -> Iterator[_Derived]:
    if case.scales.physical:
        yield from _derived_geometry(case)
        yield from _derived_inertia(case)
        yield from _counterparts(case)
    yield from _derived_frequencies(case)


def _derived_geometry(case: Case) -> Iterator[_Derived]:
    body = case.numbers.body
    geometry, line, width = body.geometry, body.line, body.face_width
    if line is None or geometry is None:
        return
    module = "mesh.normal_module" if case.kind == HELICAL else "mesh.module"
    angles = ("mesh.pressure_angle", "mesh.helix_angle")
    radius = (module, *angles, "pinion.teeth", "gear.teeth")
    for i, gear in enumerate(("pinion", "gear")):
        text = f"radius of the {gear} that turns rotation into displacement"
        yield _Derived(f"derived.radius_{gear}", 1e3 * line.radii[i], "mm", "model.projection", radius, text)
    yield _Derived(
        "derived.c_t", line.c_t, "", "model.projection", angles, "factor of rotation along the mesh"
    )
    if case.kind == HELICAL:
        yield _Derived("derived.c_y", line.c_y, "", "model.y_axis", angles, "factor of lateral displacement")
        yield _Derived("derived.c_z", line.c_z, "", "sin β_b", angles, "factor of axial displacement")
    ratio = geometry.transverse_contact_ratio
    yield _Derived(
        "derived.transverse_contact_ratio", ratio, "", "standard addendum and centre distance", radius, "ε_α"
    )
    if width is not None and case.kind == HELICAL:
        widths = (*radius, "pinion.face_width", "gear.face_width")
        overlap, total = geometry.overlap_ratio(width), geometry.total_contact_ratio(width)
        yield _Derived("derived.overlap_ratio", overlap, "", "b sin β/(π m_n)", widths, "ε_β")
        yield _Derived("derived.total_contact_ratio", total, "", "ε_α + ε_β", widths, "ε_γ")


def _derived_inertia(case: Case) -> Iterator[_Derived]:
    own, scales = case.numbers, case.scales
    discs = _disc_gears(case)
    if own.body.inertias is not None:
        for gear, inertia in zip(("pinion", "gear"), own.body.inertias, strict=True):
            if gear in discs:
                inputs = (f"{gear}.mass", f"derived.radius_{gear}", BODY)
                text = f"rotary inertia of the {gear}"
                yield _Derived(f"derived.inertia_{gear}", inertia, "kg*m^2", "m r²/2", inputs, text)
    bodies = [name for gear in ("pinion", "gear") for name in _rotation_inputs(gear, gear in discs)]
    mass_inputs = ("mesh.equivalent_mass",) if "mesh.equivalent_mass" in case.entries else tuple(bodies)
    assert scales.equivalent_mass is not None  # a physical case has all scales
    assert scales.omega_n is not None
    yield _Derived(
        "derived.equivalent_mass",
        scales.equivalent_mass,
        "kg",
        "1/m_e = R_p²/J_p + R_g²/J_g",
        mass_inputs,
        "m_e",
    )
    inputs = ("mesh.mean_stiffness", "derived.equivalent_mass")
    yield _Derived("derived.omega_n", scales.omega_n, "rad/s", "√(k_m/m_e)", inputs, "unit of frequency")
    force = float(scales.force_N(1.0))
    inputs = ("mesh.mean_stiffness", REFERENCE)
    yield _Derived("derived.force_unit", force, "N", "k_m D_c", inputs, "force of Φ = 1")


def _rotation_inputs(gear: str, disc: bool) -> tuple[str, ...]:
    inertia = f"derived.inertia_{gear}" if disc else f"{gear}.inertia"
    return f"derived.radius_{gear}", f"{gear}.base_radius", inertia


def _counterparts(case: Case) -> Iterator[_Derived]:
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
            yield _Derived(place.path, value, "", "from " + entry.path, needs, place.description, short)
        for path, number, unit in case.physical(short, value):
            if path != entry.path:
                text = quantities(case.kind)[path].description
                yield _Derived(path, float(number), unit, "from " + entry.path, needs, text, short)
    if case.scales.radii is not None:
        force = float(case.scales.torque(parameters["load"])) / case.scales.radii[0]
        yield _Derived(
            "derived.transmitted_force", force, "N", "W = T_p/R_p", ("load", *torque), "mean force W"
        )


def _half_of_own_backlash(entries: Mapping[str, Entry]) -> bool:
    """Is D_c half of the very backlash that D is computed from, so that D = 1 whatever the backlash?"""
    gap, reference = entries.get("D"), entries.get(REFERENCE)
    if gap is None or reference is None or gap.dimensionless:
        return False
    return reference.number == gap.number / 2.0 and reference.reason.startswith("half the backlash")


def _derived_frequencies(case: Case) -> Iterator[_Derived]:
    own, factor = case.numbers, case.family()[0].defaults["rotation_factor"]
    fixed = _frequency_inputs(case.entries)
    if own.pair is None:
        frequencies: Iterable[float] = spur.natural_frequencies(factor)
    else:
        frequencies = helical.natural_frequencies(own.pair, factor)
    for i, frequency in enumerate(frequencies, start=1):
        path = f"derived.natural_frequency_{i}"
        text = f"undamped natural frequency {i}, mesh closed at mean stiffness, over ω_n"
        yield _Derived(path, float(frequency), "", "undamped, closed mesh", fixed, text)
        if case.scales.physical:
            hz, rpm = float(case.scales.mesh_hz(frequency)), float(case.scales.pinion_rpm(frequency))
            needs = (path, "derived.omega_n", "pinion.teeth")
            yield _Derived(f"{path}_hz", hz, "Hz", "ω ω_n/2π", needs, f"natural frequency {i}")
            text = f"pinion speed at which the mesh frequency meets natural frequency {i}"
            yield _Derived(f"derived.critical_speed_{i}", rpm, "rpm", "60 f/z_p", needs, text)


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
