"""Dynamic factor K_v of ISO 6336-1, Method B: to hold a computed dynamic force beside, never used in a model.

ISO 6336-1:2019 (and 2006), clause 6.5. With the resonance ratio N, the line load w = F_t K_A / b and
effective errors:

    B_p = c′ f_pb,eff/w,   B_f = c′ f_fα,eff/w,   B_k = |1 − c′ C_a/w|,
    K_v = 1 + N (C_v1 B_p + C_v2 B_f + C_v3 B_k)      N ≤ N_S   subcritical
    K_v = 1 + C_v1 B_p + C_v2 B_f + C_v4 B_k          to 1.15   main resonance
    K_v = C_v5 B_p + C_v6 B_f + C_v7                  from 1.5  supercritical, between them a straight line,
    N_S = 0.5 + 0.35 √(w/100 N/mm), at most 0.85.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from math import cos, pi, sin, sqrt

from gearlash.system import GearlashError

from .cylindrical_pair import CylindricalPair
from .flank_tolerances import flank_tolerances
from .mesh_stiffness import MeshStiffness


class SpeedRange(StrEnum):
    """Where a speed lies against the main resonance."""

    SUBCRITICAL = "subcritical"
    RESONANCE = "main resonance"
    INTERMEDIATE = "intermediate"
    SUPERCRITICAL = "supercritical"


@dataclass(frozen=True)
class DynamicFactor:
    """K_v and what it rests on.

    Parameters
    ----------
    value : float
        K_v.
    resonance_ratio : float
        N, speed over that of the main resonance.
    range : SpeedRange
    """

    value: float
    resonance_ratio: float
    range: SpeedRange


@dataclass(frozen=True)
class EffectiveErrors:
    """Errors after running in, m.

    Parameters
    ----------
    pitch : float
        f_pb,eff = f_pb − y_p.
    form : float
        f_fα,eff = f_fα − y_f.
    """

    pitch: float
    form: float

    @classmethod
    def of_grades(cls, pair: CylindricalPair, grades: tuple[int, int]) -> EffectiveErrors:
        """From the tolerances of the worse gear, of case-hardened or nitrided steel.

        f_pb = f_pT cos α_t; running in takes 7.5 % of each, at most 3 µm.
        """
        along = cos(pair.pinion.transverse_pressure_angle)
        found = [
            flank_tolerances(gear, grade, pair.face_width)
            for gear, grade in zip(pair.gears, grades, strict=True)
        ]
        pitch = along * max(one.single_pitch for one in found)
        form = max(one.profile_form for one in found)
        return cls(pitch - min(0.075 * pitch, 3e-6), form - min(0.075 * form, 3e-6))


def dynamic_factor(
    pair: CylindricalPair,
    mesh: MeshStiffness,
    reduced_mass: float,
    speed: float,
    line_load: float,
    errors: EffectiveErrors,
    tip_relief: float = 0.0,
) -> DynamicFactor:
    """Dynamic factor of a pair by Method B.

    Parameters
    ----------
    pair : CylindricalPair
    mesh : MeshStiffness
        c′ and c_γα.
    reduced_mass : float
        m_red per face width, in the transverse plane, kg/m: `equivalent_mass` of the base radii over the face
        width.
    speed : float
        Of the pinion, rad/s; at least 0.
    line_load : float
        F_t K_A / b, N/m; above 0.
    errors : EffectiveErrors
    tip_relief : float
        C_a, m: the smaller one of both ends of contact, root relief of the other gear counted with it. For
        grades 6 to 12 the standard takes B_k = 1, as for 0 here.

    Returns
    -------
    DynamicFactor

    Raises
    ------
    GearlashError
        For a contact ratio ε_γ of 1 or less, or no load.

    References
    ----------
    ISO 6336-1:2019, clause 6.5.

    Examples
    --------
    >>> from math import pi
    >>> from gearlash.gears import CylindricalGear, CylindricalPair, mesh_stiffness
    >>> from gearlash.gears.dynamic_factor import EffectiveErrors, dynamic_factor
    >>> pair = CylindricalPair(CylindricalGear(25, 2e-3), CylindricalGear(57, 2e-3), face_width=0.02)
    >>> mesh, errors = mesh_stiffness.method_b(pair), EffectiveErrors.of_grades(pair, (6, 6))
    >>> found = dynamic_factor(pair, mesh, 9.0, 4200 * pi / 30, 300e3, errors)
    >>> round(found.value, 2), round(found.resonance_ratio, 2), found.range.value
    (1.11, 0.23, 'subcritical')
    """
    ratio = pair.total_contact_ratio
    if not ratio > 1.0 or not line_load > 0.0:
        raise GearlashError(
            f"ε_γ = {ratio:.3g}, w = {1e-3 * line_load:.4g} N/mm: K_v is for ε_γ above 1 under load"
        )
    n = pair.pinion.teeth * speed / sqrt(mesh.mean / reduced_mass)
    pitch, form = mesh.single * errors.pitch / line_load, mesh.single * errors.form / line_load
    relief = abs(1.0 - mesh.single * tip_relief / line_load)
    c2, c3, c4, c6, c7 = _factors(ratio)
    steady = 0.32 * pitch + c2 * form
    resonance = 1.0 + steady + c4 * relief
    above = 0.47 * pitch + c6 * form + c7
    if n <= min(0.5 + 0.35 * sqrt(line_load / 1e5), 0.85):
        return DynamicFactor(1.0 + n * (steady + c3 * relief), n, SpeedRange.SUBCRITICAL)
    if n <= 1.15:
        return DynamicFactor(resonance, n, SpeedRange.RESONANCE)
    if n < 1.5:
        between = above + (resonance - above) * (1.5 - n) / 0.35
        return DynamicFactor(between, n, SpeedRange.INTERMEDIATE)
    return DynamicFactor(above, n, SpeedRange.SUPERCRITICAL)


def _factors(ratio: float) -> tuple[float, float, float, float, float]:
    """C_v2, C_v3, C_v4, C_v6 and C_v7 for ε_γ."""
    if ratio <= 2.0:
        c2, c3, c4, c6 = 0.34, 0.23, 0.90, 0.47
    else:
        c2, c3 = 0.57 / (ratio - 0.3), 0.096 / (ratio - 1.56)
        c4, c6 = (0.57 - 0.05 * ratio) / (ratio - 1.44), 0.12 / (ratio - 1.74)
    if ratio <= 1.5:
        return c2, c3, c4, c6, 0.75
    return c2, c3, c4, c6, 0.125 * sin(pi * (min(ratio, 2.5) - 2.0)) + 0.875
