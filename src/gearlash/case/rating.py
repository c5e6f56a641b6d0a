"""K_v of ISO 6336-1, method B, for teeth that a case describes: to stand beside the computed one."""

from __future__ import annotations

from gearlash.gears import CylindricalGear, CylindricalPair, equivalent_mass, mesh_stiffness
from gearlash.gears.basic_rack import ISO53_A, BasicRack
from gearlash.gears.dynamic_factor import DynamicFactor, EffectiveErrors, dynamic_factor
from gearlash.gears.materials import Material, named
from gearlash.system import GearlashError

from .case import Case

GRADES = (5, 8)
"""Of ISO 1328-1, between which K_v is told, as a case states none."""


COARSEST_WITH_RELIEF = 5
"""Grade up to which the standard counts tip relief: for 6 to 12 its B_k is 1."""

RUNNING_IN_RELIEF = 1e-6 * ((1500 / 97 - 18.45) ** 2 / 18 + 1.5)
"""C_ay, m, of case-hardened gears (σ_Hlim = 1500 N/mm²) whose flanks are not modified."""

LEAST_MODULUS = 40e9
"""Pa, Young's modulus: metals that gears are made of have more, plastics less."""


def pair_of(case: Case) -> CylindricalPair:
    """The teeth of a case at work, without profile shift where it is no drawing. Raises `GearlashError` where
    it does not state them, or the face width."""
    body = case.numbers.body
    if body.meshing is not None:
        return body.meshing
    geometry, width = body.geometry, body.face_width
    if geometry is None or width is None:
        raise GearlashError("the case does not state teeth, module, angles and both face widths")
    rack = BasicRack(pressure_angle=geometry.pressure_angle) if geometry.pressure_angle else ISO53_A
    gears = [
        CylindricalGear(teeth, geometry.normal_module, geometry.helix_angle, rack=rack)
        for teeth in geometry.teeth
    ]
    return CylindricalPair(gears[0], gears[1], face_width=width)


def method_b(case: Case, omega: float, grades: tuple[int, int]) -> DynamicFactor:
    """K_v at a speed ω for grades of both gears, K_A = 1. Raises `GearlashError` where the case does not
    say enough, or the method does not hold."""
    pair, body, scales = pair_of(case), case.numbers.body, case.scales
    materials = materials_of(case)
    for each in materials:
        if each.youngs_modulus < LEAST_MODULUS:
            raise GearlashError(f"the standard is for metals, and a gear is of {each.name}")
    if body.inertias is None:
        raise GearlashError("the case does not state inertias")
    base = body.geometry.base_radii
    reduced = equivalent_mass(base, body.inertias) / pair.face_width
    torque = abs(float(scales.torque(case.family()[0].defaults["load"])))
    load = torque / body.geometry.pitch_radii[0] / pair.face_width
    speed = float(scales.pinion_speed(omega))
    errors = EffectiveErrors.of_grades(pair, grades)
    mesh = mesh_stiffness.method_b(pair, materials, body.rims, load)
    return dynamic_factor(pair, mesh, reduced, speed, load, errors, relief_of(case, grades))


def band_of_grades(case: Case, omega: float) -> str:
    """A sentence with K_v of the standard at a speed, or why there is none."""
    own = stated_grades(case)
    try:
        first, last = (method_b(case, omega, own or (grade, grade)) for grade in GRADES)
    except GearlashError as error:
        return f"K_v of ISO 6336-1 does not stand beside it: {error}."
    value = (
        f"{first.value:.2f} for grade {GRADES[0]} of ISO 1328-1 and {last.value:.2f} for grade {GRADES[1]}"
    )
    stated = "; the case states no grade"
    if own is not None:
        value, stated = f"{first.value:.2f} for grades {own[0]} and {own[1]} of ISO 1328-1", ""
    return (
        f"ISO 6336-1:2019, method B, gives K_v = {value} (K_A = 1, {first.range} with N = "
        f"{first.resonance_ratio:.2f}{stated}): a factor for rating, from tolerances, a line load and the "
        "stiffness of the standard, not from this model's error and bearings."
    )


def values_of_grades(case: Case, omega: float) -> str:
    """``1.09``, or ``1.04 to 1.31`` over grades where the case states none; nothing where there is no K_v."""
    own = stated_grades(case)
    try:
        found = [method_b(case, omega, own or (grade, grade)).value for grade in GRADES]
    except GearlashError:
        return ""
    return f"{found[0]:.2f}" if own is not None else f"{found[0]:.2f} to {found[1]:.2f}"


def materials_of(case: Case) -> tuple[Material, Material]:
    """Of pinion and gear; steel where the case states none."""
    found = {value.path: value.value for value in case.values()}
    first, second = (named(str(found.get(f"{gear}.material", "steel"))) for gear in ("pinion", "gear"))
    return first, second


def relief_of(case: Case, grades: tuple[int, int]) -> float:
    """C_a, m, of the smaller end of contact: tip relief and the root relief that meets it. Teeth without any
    have what running in takes, C_ay. From grade 6 relief does not count: 0, with which B_k is 1."""
    if max(grades) >= COARSEST_WITH_RELIEF + 1:
        return 0.0
    found = {value.path: value.value for value in case.values()}

    def stated(gear: str, leaf: str) -> float:
        return 1e-6 * float(found.get(f"{gear}.{leaf}_relief", 0.0))

    ends = stated("pinion", "tip") + stated("gear", "root"), stated("gear", "tip") + stated("pinion", "root")
    return min(ends) if any(ends) else RUNNING_IN_RELIEF


def stated_grades(case: Case) -> tuple[int, int] | None:
    """Accuracy grades of pinion and gear; where one is stated alone, both have it."""
    found = {value.path: value.value for value in case.values()}
    grades = [found.get(f"{gear}.quality") for gear in ("pinion", "gear")]
    known = [int(grade) for grade in grades if isinstance(grade, int | float)]
    return (known[0], known[-1]) if known else None
