"""What a verification is computed from: fixed, in one record, before anything is computed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import cos, pi, sqrt

import numpy as np
from numpy.typing import NDArray

from gearlash.case import Case
from gearlash.case.kinds.gears import supports
from gearlash.case.kinds.gears.keys import GEARS
from gearlash.case.kinds.gears.kind import GearContent
from gearlash.case.kinds.gears.teeth import Teeth
from gearlash.gears import CylindricalPair, backlash
from gearlash.gears.drawing import Drawing
from gearlash.gears.estimates import estimates
from gearlash.gears.flank_modification import PairModification
from gearlash.gears.gear_body import GearBody
from gearlash.gears.materials import Material, named
from gearlash.gears.mesh import harmonic_count, series
from gearlash.system import Fourier

from .refused import gears_of, meshing

ORDERS = (1, 2, 3)
"""Mesh orders of the stiffness, and of the error that the teeth make, that go from one model to the other."""
SAMPLES = 2880
"""Of a mesh cycle, where the peaks of an error of several harmonics are looked for."""


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
        Of bearings with what is in series, N/m; None where the model has none, and nothing moves but the
        shafts' rotations.
    bearing_spans : (float, float)
        Distance of the two bearings of a shaft, m: tilt stiffness = k_y span²/4.
    bearing_damping : ((float, float), (float, float))
        ξ of pinion and of gear, along y and along z.
    mean_stiffness, mesh_damping : float
        k_m of the case, N/m, and ξ_m.
    torque : float
        On the pinion, N·m.
    backlash : float
        Normal, m.
    errors : tuple of (float, float)
        Amplitude, m, and phase, rad, of the mesh orders 1, 2, …: those that are named and of a curve.
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
    bearing_spans: tuple[float, float]
    bearing_damping: tuple[tuple[float, float], tuple[float, float]]
    mean_stiffness: float
    mesh_damping: float
    torque: float
    backlash: float
    errors: tuple[tuple[float, float], ...]
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

    @property
    def error(self) -> float:
        """Half the peak to peak of the error over a mesh cycle, m: the amplitude of a single harmonic."""
        present = [amplitude for amplitude, _ in self.errors if amplitude]
        if len(present) < 2:
            return sum(present)
        theta = 2.0 * pi * np.arange(SAMPLES) / SAMPLES
        waves = [a * np.cos(n * theta + phase) for n, (a, phase) in enumerate(self.errors, start=1)]
        return 0.5 * float(np.ptp(sum(waves)))

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
        If the case is no gear pair, says too little for real teeth, or has what these cannot have; every
        problem with its field, value and what is expected.

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash.studies.verification import inputs_of
    >>> inputs = inputs_of(gl.load_case("article"), (0.942, 1.047))
    >>> round(inputs.mean_force), round(inputs.rpm(1.0, inputs.mean_stiffness))
    (1842, 3820)
    """
    content = gears_of(case)
    entries, numbers, drawing = content.completed.entries, content.numbers, content.completed.drawing
    scales, values = numbers.scales, content.family().complete()
    inertias, radii = numbers.body.inertias, scales.radii
    assert inertias is not None  # `gears_of` saw to it, here and below
    assert radii is not None
    assert scales.mean_stiffness is not None
    play = _play(content, values["D"])
    teeth = Teeth(content.rules, entries).pair() if drawing is None else drawing.meshing
    pair = meshing(case, _with_backlash(teeth, play))
    widths = entries["pinion.face_width"].number, entries["gear.face_width"].number
    masses = _masses(content, inertias, radii)
    bearing_y, bearing_z = _bearings(content, masses)
    stiffness, errors = _excitation(content, values)
    order = max(ORDERS, key=lambda n: abs(stiffness[n - 1]) if n <= len(stiffness) else 0.0)
    return Inputs(
        case=case.name,
        pair=pair,
        masses=masses,
        axial_inertias=inertias,
        radii=radii,
        body_widths=widths,
        bodies=_bodies(drawing, pair, widths),
        materials=(named("steel"), named("steel")) if drawing is None else drawing.chosen_materials,
        modification=PairModification() if drawing is None else drawing.modification,
        bearing_y=bearing_y,
        bearing_z=bearing_z,
        bearing_spans=_spans(content, pair),
        bearing_damping=_bearing_damping(values),
        mean_stiffness=scales.mean_stiffness,
        mesh_damping=values["mesh_damping"],
        torque=float(scales.torque(values["load"])),
        backlash=play,
        errors=errors,
        ripple_phase=float(np.angle(stiffness[order - 1])) if order <= len(stiffness) else 0.0,
        ripple_order=order,
        speeds=speeds,
    )


def _play(content: GearContent, half: float) -> float:
    """Normal backlash, m: as stated, or at work."""
    done, scales = content.completed, content.numbers.scales
    if not done.play_added and not done.entries["D"].dimensionless:
        return done.entries["D"].number
    return float(scales.backlash_um(half)) * 1e-6


def _masses(
    content: GearContent, inertias: tuple[float, float], radii: tuple[float, float]
) -> tuple[float, float]:
    """As stated; where nothing but rotation moves, that of a disc if nothing is, which plays no part."""
    entries = content.completed.entries
    first, second = (
        supports.mass(entries, gear) if f"{gear}.mass" in entries else 2.0 * inertia / radius**2
        for gear, inertia, radius in zip(GEARS, inertias, radii, strict=True)
    )
    return first, second


def _bearings(
    content: GearContent, masses: tuple[float, float]
) -> tuple[tuple[float, float], tuple[float, float]] | tuple[None, None]:
    """Lateral and axial stiffness of what carries pinion and gear: stated, in series, or κ² ω_n² m; None
    without bearings."""
    entries, omega_n = content.completed.entries, content.numbers.scales.omega_n
    if not content.rules.bearings:
        return None, None
    assert omega_n is not None  # of every physical case

    def stiffness(gear: str, axis: str) -> float:
        kappa = entries[f"bearing_frequency_{axis}{gear[0]}"]
        if kappa.dimensionless:
            return (kappa.number * omega_n) ** 2 * masses[GEARS.index(gear)]
        return supports.stiffness(entries, gear, axis)

    lateral, axial = ((stiffness("pinion", axis), stiffness("gear", axis)) for axis in "yz")
    return lateral, axial


def _spans(content: GearContent, pair: CylindricalPair) -> tuple[float, float]:
    """As stated, or estimated from the size of the pair, m."""
    entries, drawing = content.completed.entries, content.completed.drawing or Drawing(pair)
    keys = [f"{gear}.bearing_span" for gear in GEARS]
    stated = [entries[key].number if key in entries else None for key in keys]
    found = estimates(replace(drawing, spans=(stated[0], stated[1])), names=("bearing_span",))
    return found["pinion_bearing_span"].value, found["gear_bearing_span"].value


def _bearing_damping(values: Mapping[str, float]) -> tuple[tuple[float, float], tuple[float, float]]:
    """Of each direction alone, or one for all; 0 without bearings."""
    common = values.get("bearing_damping", 0.0)
    yp, zp, yg, zg = (values.get(f"bearing_damping_{one}", common) for one in ("yp", "zp", "yg", "zg"))
    return (yp, zp), (yg, zg)


def _excitation(
    content: GearContent, values: Mapping[str, float]
) -> tuple[NDArray[np.complex128], tuple[tuple[float, float], ...]]:
    """Harmonics of the stiffness over its mean; amplitudes (m) and phases of those of the error, without what
    relief and contact beyond the path of contact make: real teeth have these themselves."""
    numbers = content.numbers
    excited = replace(numbers.excitation, runout=None, relief=None)
    ripple, error = (
        series(values, stem, mean, harmonic_count(values, stem))
        for stem, mean in (("ripple", 1.0), ("error", 0.0))
    )
    stiffness = _harmonics(excited.stiffness_series(values, ripple))
    assert numbers.scales.length is not None
    found = numbers.scales.length * _harmonics(excited.error_series(values, error))
    return stiffness, tuple((float(abs(each)), float(np.angle(each))) for each in found)


def _harmonics(fourier: Fourier) -> NDArray[np.complex128]:
    """c_n of Re Σ c_n exp(i n θ), from [mean, c1, s1, …]."""
    return fourier[1::2] - 1j * fourier[2::2]


def _bodies(
    drawing: Drawing | None, pair: CylindricalPair, widths: tuple[float, float]
) -> tuple[GearBody, GearBody]:
    """As stated; a solid disc of the pitch diameter, which has the mass of the case, where nothing is."""
    known = (None, None) if drawing is None else drawing.bodies
    first, second = (
        GearBody(gear.reference_diameter, width) if body is None else body
        for width, gear, body in zip(widths, pair.gears, known, strict=True)
    )
    return first, second


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
