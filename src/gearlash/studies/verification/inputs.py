"""What a verification is computed from: fixed, in one record, before anything is computed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from math import cos, pi, sqrt

from gearlash.case import Case
from gearlash.case.kinds.gears.kind import GearContent
from gearlash.case.kinds.gears.teeth import Teeth
from gearlash.case.units import unit
from gearlash.gears import CylindricalPair, backlash
from gearlash.gears.drawing import Drawing
from gearlash.gears.flank_modification import PairModification
from gearlash.gears.gear_body import GearBody
from gearlash.gears.materials import Material, named
from gearlash.system import GearlashError

ORDERS = (1, 2, 3)
"""Mesh orders of the stiffness and of the error that go from one model to the other."""


class NotVerifiableError(GearlashError):
    """A case that says too little for a model with real teeth; the text says what is missing."""


@dataclass(frozen=True)
class Inputs:
    """The pair as both models take it: from the case, and what the case leaves open.

    Attributes
    ----------
    case : str
        Name of the case.
    pair : CylindricalPair
        Teeth with the stated backlash in their thickness; face width in common.
    masses, axial_inertias, radii : (float, float)
        As the lumped model has them: kg, kg·m², m.
    body_widths : (float, float)
        Of the bodies, m: they decide the inertia about axes across the shaft.
    bodies : (GearBody, GearBody)
        How they are made, for their modes: as stated, or solid discs of the pitch diameter.
    materials : (Material, Material)
        Steel where nothing is stated.
    modification : PairModification
        Relief and crowning that the case states.
    bearing_y, bearing_z : (float, float) or None
        As stated, N/m; None where the model has no bearings, and nothing moves but the shafts' rotations.
    mean_stiffness, mesh_damping, bearing_damping : float
        k_m of the case, N/m, ξ_m and ξ_b.
    torque : float
        On the pinion, N·m.
    backlash : float
        Normal, m.
    error, error_phase : float
        Zero to peak, m, and rad, once a mesh cycle.
    ripple_phase : float
        Phase in rad of the mesh order of the case's stiffness that is its largest.
    ripple_order : int
        That order.
    speeds : tuple of float
        Mesh frequency over that of the mesh, ω.
    """

    case: str
    pair: CylindricalPair
    masses: tuple[float, float]
    axial_inertias: tuple[float, float]
    radii: tuple[float, float]
    body_widths: tuple[float, float]
    bodies: tuple[GearBody, GearBody]
    materials: tuple[Material, Material]
    modification: PairModification
    bearing_y: tuple[float, float] | None
    bearing_z: tuple[float, float] | None
    mean_stiffness: float
    mesh_damping: float
    bearing_damping: float
    torque: float
    backlash: float
    error: float
    error_phase: float
    ripple_phase: float
    ripple_order: int
    speeds: tuple[float, ...]

    @property
    def mesh_mass(self) -> float:
        """m_e, kg: 1/m_e = R_p²/J_p + R_g²/J_g."""
        return 1.0 / sum(r**2 / j for r, j in zip(self.radii, self.axial_inertias, strict=True))

    @property
    def mean_force(self) -> float:
        """Mean normal force, N: T/(r_b cos β_b)."""
        pinion = self.pair.pinion
        return self.torque / (0.5 * pinion.base_diameter * cos(pinion.base_helix_angle))

    def natural_frequency(self, stiffness: float) -> float:
        """√(k/m_e), rad/s."""
        return sqrt(stiffness / self.mesh_mass)

    def rpm(self, omega: float, stiffness: float) -> float:
        """Speed of the pinion at which the mesh frequency is ω √(k/m_e), rpm."""
        return omega * self.natural_frequency(stiffness) / self.pair.pinion.teeth * 30.0 / pi


def inputs_of(case: Case, speeds: tuple[float, ...]) -> Inputs:
    """The inputs that a case gives.

    Parameters
    ----------
    case : Case
        Of a helical or spur pair.
    speeds : tuple of float
        ω at which both models are compared.

    Returns
    -------
    Inputs

    Raises
    ------
    NotVerifiableError
        If the case is no gear pair, or says too little for real teeth.

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash.studies.verification import inputs_of
    >>> inputs = inputs_of(gl.load_case("article"), (0.942, 1.047))
    >>> round(inputs.mean_force), round(inputs.rpm(1.0, inputs.mean_stiffness))
    (1842, 3820)
    """
    content = case.content
    if not isinstance(content, GearContent):
        raise NotVerifiableError(f"{case.name} is no pair of gears: there are no teeth to verify with")
    stated = {v.path: _in_si(v.value, v.unit) for v in case.values() if isinstance(v.value, int | float)}
    for gear in ("pinion", "gear"):  # stated, or that of the default body
        if f"derived.inertia_{gear}" in stated:
            stated[f"{gear}.inertia"] = stated[f"derived.inertia_{gear}"]
    missing = [path for path in _needed() if path not in stated]
    if missing:
        raise NotVerifiableError(
            f"{case.name} says too little for a model with real teeth; missing: {', '.join(missing)}"
        )
    parameters, scales = content.family().complete(), case.scales
    drawing = content.completed.drawing
    teeth = Teeth(content.rules, content.completed.entries).pair() if drawing is None else drawing.meshing
    pair = _with_backlash(teeth, stated["mesh.backlash"])
    radii = scales.radii
    assert radii is not None
    ripples = {n: parameters.get("ripple" if n == 1 else f"ripple_{n}", 0.0) for n in ORDERS}
    largest = max(ripples, key=lambda n: abs(ripples[n]))
    phase = parameters.get("ripple_phase" if largest == 1 else f"ripple_phase_{largest}", 0.0)
    return Inputs(
        case=case.name,
        pair=pair,
        masses=(stated["pinion.mass"], stated["gear.mass"]),
        axial_inertias=(_turning(stated, "pinion"), _turning(stated, "gear")),
        radii=radii,
        body_widths=(stated["pinion.face_width"], stated["gear.face_width"]),
        bodies=_bodies(drawing, pair, stated),
        materials=(named("steel"), named("steel")) if drawing is None else drawing.chosen_materials,
        modification=PairModification() if drawing is None else drawing.modification,
        bearing_y=_of_both(stated, "bearing_stiffness_y"),
        bearing_z=_of_both(stated, "bearing_stiffness_z"),
        mean_stiffness=stated["mesh.mean_stiffness"],
        mesh_damping=parameters["mesh_damping"],
        bearing_damping=parameters.get("bearing_damping", 0.0),
        torque=float(scales.torque(parameters["load"])),
        backlash=stated["mesh.backlash"],
        error=parameters["error"] * float(scales.backlash_um(1.0)) * 0.5e-6,
        error_phase=parameters["error_phase"],
        ripple_phase=phase,
        ripple_order=largest,
        speeds=speeds,
    )


def _bodies(
    drawing: Drawing | None, pair: CylindricalPair, stated: Mapping[str, float]
) -> tuple[GearBody, GearBody]:
    """As stated; a solid disc of the pitch diameter, which has the mass of the case, where nothing is."""
    known = (None, None) if drawing is None else drawing.bodies
    first, second = (
        GearBody(gear.reference_diameter, stated[f"{name}.face_width"]) if body is None else body
        for name, gear, body in zip(("pinion", "gear"), pair.gears, known, strict=True)
    )
    return first, second


def _needed() -> tuple[str, ...]:
    return (
        *(
            f"{gear}.{name}"
            for gear in ("pinion", "gear")
            for name in ("teeth", "mass", "face_width", "inertia")
        ),
        "mesh.mean_stiffness",
        "mesh.backlash",
    )


def _in_si(value: float, written: str) -> float:
    return unit(written).convert(Fraction(value)) if written else float(value)


def _of_both(stated: Mapping[str, float], name: str) -> tuple[float, float] | None:
    """A number of pinion and gear, None where one of them has none."""
    found = stated.get(f"pinion.{name}"), stated.get(f"gear.{name}")
    return None if found[0] is None or found[1] is None else (found[0], found[1])


def _with_backlash(pair: CylindricalPair, wanted: float) -> CylindricalPair:
    """The pair whose tooth thickness leaves this normal backlash, the same share from either gear."""
    present = backlash.of_pair(pair).normal
    gears = [
        replace(
            gear,
            thickness_allowance=gear.thickness_allowance
            - 0.5 * (wanted - present) / cos(gear.rack.pressure_angle),
        )
        for gear in pair.gears
    ]
    return replace(pair, pinion=gears[0], gear=gears[1], stated_centre_distance=pair.centre_distance)


def with_width(inputs: Inputs, width: float) -> Inputs:
    """The same inputs with teeth of another face width; the bodies stay as they are."""
    return replace(inputs, pair=replace(inputs.pair, face_width=width))


def _turning(stated: Mapping[str, float], gear: str) -> float:
    """Inertia of a gear with what turns rigidly with it."""
    return stated[f"{gear}.inertia"] + stated.get(f"{gear}.added_inertia", 0.0)
