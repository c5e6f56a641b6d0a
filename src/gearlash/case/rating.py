"""K_v of ISO 6336-1, method B, for teeth that a case describes: to stand beside the computed one."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from gearlash.gears import CylindricalGear, CylindricalPair, equivalent_mass, mesh_stiffness
from gearlash.gears.basic_rack import ISO53_A, BasicRack
from gearlash.gears.drawing import COARSEST, GRADE_SPREAD
from gearlash.gears.dynamic_factor import DynamicFactor, EffectiveErrors, dynamic_factor
from gearlash.gears.materials import OF_DATA_SHEETS, Material, named, with_own
from gearlash.system import GearlashError

from .case import Case
from .stated import Provenance
from .units import unit

GEARS = ("pinion", "gear")
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
    grades = grades_of(case)
    try:
        own, first, last = (
            method_b(case, omega, each) for each in (grades.own, grades.finest, grades.coarsest)
        )
    except GearlashError as error:
        return f"K_v of ISO 6336-1 does not stand beside it: {error}."
    ends = f"{first.value:.2f} for {_told(grades.finest)} and {last.value:.2f} for {_told(grades.coarsest)}"
    value = f"{own.value:.2f} for {_told(grades.own)} of ISO 1328-1"
    if grades.assumed:
        whose = "both gears" if len(grades.assumed) == 2 else f"the {grades.assumed[0]}"
        value += f", assumed for {whose}; {ends}"
    elif grades.finest != grades.coarsest:
        value = f"{ends} of ISO 1328-1; the case states no grade"
    return (
        f"ISO 6336-1:2019, method B, gives K_v = {value} (K_A = 1, {own.range} with N = "
        f"{own.resonance_ratio:.2f}): a factor for rating, from tolerances, a line load and the "
        "stiffness of the standard, not from this model's error and bearings."
    )


def values_of_grades(case: Case, omega: float) -> str:
    """``1.09``, or ``1.04 to 1.31`` over grades where the case does not state both; nothing where there is no
    K_v."""
    grades = grades_of(case)
    try:
        first, last = (method_b(case, omega, each).value for each in (grades.finest, grades.coarsest))
    except GearlashError:
        return ""
    return f"{first:.2f}" if grades.finest == grades.coarsest else f"{first:.2f} to {last:.2f}"


def _told(grades: tuple[int, int]) -> str:
    return f"grade {grades[0]}" if grades[0] == grades[1] else f"grades {grades[0]} and {grades[1]}"


def materials_of(case: Case) -> tuple[Material, Material]:
    """Of pinion and gear; steel where the case states none."""
    found = {value.path: value for value in case.values()}

    def own(gear: str, leaf: str) -> float | None:
        value = found.get(f"{gear}.{leaf}")
        return None if value is None else unit(value.unit).convert(Fraction(float(value.value)))

    def chosen(gear: str) -> Material:
        stated = found.get(f"{gear}.material")
        listed = named("steel" if stated is None else str(stated.value))
        return with_own(listed, *(own(gear, leaf) for leaf in OF_DATA_SHEETS))

    return chosen("pinion"), chosen("gear")


def relief_of(case: Case, grades: tuple[int, int]) -> float:
    """C_a, m, of the smaller end of contact: tip relief and the root relief that meets it. An end without any
    has what running in takes, C_ay. From grade 6 relief does not count: 0, with which B_k is 1."""
    if max(grades) > COARSEST_WITH_RELIEF:
        return 0.0
    found = {value.path: value.value for value in case.values()}

    def stated(gear: str, leaf: str) -> float:
        return 1e-6 * float(found.get(f"{gear}.{leaf}_relief", 0.0))

    ends = stated("pinion", "tip") + stated("gear", "root"), stated("gear", "tip") + stated("pinion", "root")
    return min(end or RUNNING_IN_RELIEF for end in ends)


@dataclass(frozen=True)
class Grades:
    """Accuracy grades of pinion and gear: those of the case, the finest and the coarsest they may be, and of
    which gears one is assumed."""

    own: tuple[int, int]
    finest: tuple[int, int]
    coarsest: tuple[int, int]
    assumed: tuple[str, ...] = ()


def grades_of(case: Case) -> Grades:
    """As the case states or assumes them; a case that is no drawing has none, and is told over `GRADES`."""
    found = {value.path: value for value in case.values()}
    known = [value for gear in GEARS if (value := found.get(f"{gear}.quality")) is not None]
    if len(known) < len(GEARS):
        fine, coarse = GRADES
        return Grades((fine, fine), (fine, fine), (coarse, coarse))
    free = [value.provenance == Provenance.ASSUMED and not value.text for value in known]

    def moved(by: int) -> tuple[int, int]:
        first, second = (
            min(max(int(value.value) + by * open_, 1), COARSEST)
            for value, open_ in zip(known, free, strict=True)
        )
        return first, second

    assumed = tuple(gear for gear, open_ in zip(GEARS, free, strict=True) if open_)
    return Grades(moved(0), moved(-GRADE_SPREAD), moved(GRADE_SPREAD), assumed)
