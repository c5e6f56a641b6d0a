"""Mean mesh stiffness by ISO 6336-1, Method B, from what a drawing has, with the range it may lie in.

ISO 6336-1:2019 (and 2006), clause 9, tooth stiffness parameters c′ and c_γ, for external gears:

    c′ = c′_th C_M C_R C_B cos β · E/E_st · (w/100)^¼ below w = 100 N/mm,   c′_th = 1/q′,
    c_γα = c′ (0.75 ε_α + 0.25),   c_γβ = 0.85 c_γα.

q′ is a regression in the virtual tooth numbers and profile shifts. All are per unit of face width and in the
transverse plane, here in N/m²: 1 N/(mm µm) = 10⁹ N/m². Nothing is refused: what the standard does not cover
widens the range and is told.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, degrees, exp, inf, log

from .cylindrical_gear import CylindricalGear
from .cylindrical_pair import CylindricalPair
from .materials import Material, named

REFERENCE = "ISO 6336-1:2019, clause 9, Method B"
STEEL_MODULUS = 206e9
"""E_st, Pa: the steel that the regression is for."""
_COMPLIANCE = (
    0.04723,
    0.15551,
    0.25791,
    -0.00635,
    -0.11654,
    -0.00193,
    -0.24188,
    0.00529,
    0.00182,
)  # C_1 to C_9
_TO_SI = 1e9
_MEASURED = 0.8  # C_M: measured over theoretical stiffness
_REGRESSION_RANGE = 0.92, 1.05  # told by the standard, for loads from 100 to 1600 N/mm
_MEASURED_RANGE = 0.9, 1.25  # of C_M: from an estimate to the theoretical stiffness itself
_RIM_RANGE = 0.99, 1.07  # of C_R, told by the standard
_LEAST_LOAD = 0.5  # of the factor of loads below 100 N/mm, as far as the range goes
_OUTSIDE_RANGE = 0.9, 1.1  # for each limit of the regression that is left: an estimate


@dataclass(frozen=True)
class Rim:
    """Rim and web of a gear body, as far as they make its teeth softer.

    Parameters
    ----------
    thickness : float
        s_R, m: of the rim below the teeth.
    web_width : float
        b_s, m.

    Examples
    --------
    >>> from gearlash.gears.mesh_stiffness import Rim
    >>> round(Rim(12e-3, 10e-3).factor(0.05, 4e-3), 3)
    0.823
    """

    thickness: float
    web_width: float

    def factor(self, face_width: float, normal_module: float) -> float:
        """C_R = 1 + ln(b_s/b) / (5 e^{s_R/(5 m_n)}), with b_s/b from 0.2 to 1.2 and s_R/m_n from 1."""
        web = min(max(self.web_width / face_width, 0.2), 1.2)
        depth = max(self.thickness / normal_module, 1.0)
        return 1.0 + log(web) / (5.0 * exp(depth / 5.0))


SOLID = Rim(inf, inf)
"""A body without a rim: a disc."""


@dataclass(frozen=True)
class MeshStiffness:
    """Stiffness of a mesh, mean over its cycle.

    Parameters
    ----------
    single : float
        c′, greatest stiffness of one pair of teeth, N/m².
    mean : float
        c_γα, N/m².
    base_helix_angle : float
        β_b, rad.
    least, greatest : float
        Lower and upper end of the range, over the value; below and above 1.
    beyond : tuple of str
        Limits of the method that this pair leaves, each a sentence.
    """

    single: float
    mean: float
    base_helix_angle: float
    least: float
    greatest: float
    beyond: tuple[str, ...] = ()

    @property
    def face_load(self) -> float:
        """c_γβ = 0.85 c_γα, N/m²: for the load along the face."""
        return 0.85 * self.mean

    def along_normal(self, face_width: float) -> float:
        """Stiffness along the line of action normal to the flanks, N/m: c_γα b / cos² β_b.

        Force and deflection normal to the flank are F_bt / cos β_b and δ_bt cos β_b of the transverse ones.
        """
        return self.mean * face_width / cos(self.base_helix_angle) ** 2

    def normal_range(self, face_width: float) -> tuple[float, float]:
        """Least and greatest of `along_normal`, N/m."""
        value = self.along_normal(face_width)
        return self.least * value, self.greatest * value


def theoretical_stiffness(pair: CylindricalPair) -> float:
    """Theoretical single stiffness of solid steel teeth of standard rack.

    Parameters
    ----------
    pair : CylindricalPair
        The gear with fewer teeth counts as the first.

    Returns
    -------
    float
        c′_th = 1/q′, N/m²; q′ = C_1 + C_2/z_n1 + C_3/z_n2 + C_4 x_1 + C_5 x_1/z_n1 + C_6 x_2 + C_7 x_2/z_n2 +
        C_8 x_1² + C_9 x_2².

    Examples
    --------
    >>> from math import radians
    >>> from gearlash.gears import CylindricalGear, CylindricalPair, mesh_stiffness
    >>> pinion = CylindricalGear(17, 8e-3, radians(15.8), 0.145)
    >>> gear = CylindricalGear(103, 8e-3, radians(15.8))
    >>> round(mesh_stiffness.theoretical_stiffness(CylindricalPair(pinion, gear)) / 1e9, 3)
    17.856
    """
    first, second = _in_order(pair)
    x1, x2 = first.profile_shift, second.profile_shift
    z1, z2 = first.virtual_teeth, second.virtual_teeth
    terms = (1.0, 1.0 / z1, 1.0 / z2, x1, x1 / z1, x2, x2 / z2, x1**2, x2**2)
    return _TO_SI / sum(factor * term for factor, term in zip(_COMPLIANCE, terms, strict=True))


def method_b(
    pair: CylindricalPair,
    materials: tuple[Material, Material] | None = None,
    rims: tuple[Rim | None, Rim | None] = (None, None),
    line_load: float | None = None,
) -> MeshStiffness:
    """Mesh stiffness by Method B.

    Parameters
    ----------
    pair : CylindricalPair
        With its face width, which a rim needs.
    materials : (Material, Material), optional
        Of pinion and gear; steel where nothing is given.
    rims : (Rim or None, Rim or None)
        Of pinion and gear. ``None``: not known; taken as solid, with a thin rim and web in the range. A solid
        body is `SOLID`.
    line_load : float, optional
        F_t K_A / b, N/m; where nothing is given it is taken as 100 N/mm or more.

    Returns
    -------
    MeshStiffness
        The range is the product of what the standard tells of regression and rim, of the materials' moduli,
        of the factor for loads below 100 N/mm (finite elements of perfect flanks hardly have it),
        and of estimates: C_M from 0.72 to 1, the theory itself (plane finite elements of solid gears lie
        between 0.8 and 1), and 10 % for each limit that is left.

    References
    ----------
    ISO 6336-1:2019, clause 9.

    Examples
    --------
    >>> from math import radians
    >>> from gearlash.gears import CylindricalGear, CylindricalPair, mesh_stiffness
    >>> from gearlash.gears.basic_rack import ISO53_D
    >>> pinion = CylindricalGear(17, 8e-3, radians(15.8), 0.145, ISO53_D)  # example 1 of ISO/TR 6336-30
    >>> wheel = CylindricalGear(103, 8e-3, radians(15.8), 0.0, ISO53_D)
    >>> pair = CylindricalPair(pinion, wheel, 0.5, face_width=0.1)
    >>> found = mesh_stiffness.method_b(pair, rims=(mesh_stiffness.SOLID, mesh_stiffness.SOLID))
    >>> round(found.single / 1e9, 2), round(found.mean / 1e9, 1)  # N/(mm µm)
    (12.37, 17.5)
    """
    bodies = (named("steel"), named("steel")) if materials is None else materials
    modulus = _harmonic(bodies[0].youngs_modulus, bodies[1].youngs_modulus)
    rim, rim_range = _rims(pair, rims)
    load = 1.0 if line_load is None else min(max(line_load, 0.0) / 1e5, 1.0) ** 0.25
    rack = 0.5 * sum(_rack_factor(one) for one in pair.gears)
    single = theoretical_stiffness(pair) * _MEASURED * rim * rack * cos(pair.pinion.helix_angle)
    single *= modulus / STEEL_MODULUS * load
    ratio = pair.transverse_contact_ratio
    beyond = _beyond(pair, bodies, line_load)
    moduli = tuple(
        _harmonic(bodies[0].youngs_range[end], bodies[1].youngs_range[end]) / modulus for end in (0, 1)
    )
    parts = [
        _REGRESSION_RANGE,
        _MEASURED_RANGE,
        rim_range,
        moduli,
        (1.0, 1.0 / max(load, _LEAST_LOAD)),  # perfect flanks lose little of their stiffness
        *[_OUTSIDE_RANGE] * len(beyond),
    ]
    if ratio < 1.2:
        parts.append((0.9, 1.0))  # the standard: up to 10 % less
    least = greatest = 1.0
    for low, high in parts:
        least, greatest = least * low, greatest * high
    return MeshStiffness(
        single, single * (0.75 * ratio + 0.25), pair.pinion.base_helix_angle, least, greatest, beyond
    )


def _in_order(pair: CylindricalPair) -> tuple[CylindricalGear, CylindricalGear]:
    """Fewer teeth first; of equal ones the larger shift, as the regression asks for."""
    first, second = pair.gears
    if (second.teeth, -second.profile_shift) < (first.teeth, -first.profile_shift):
        return second, first
    return first, second


def _harmonic(first: float, second: float) -> float:
    return 2.0 * first * second / (first + second)


def _rack_factor(gear: CylindricalGear) -> float:
    """C_B = (1 + 0.5 (1.2 − h_fP/m_n)) (1 − 0.02 (20° − α_n))."""
    depth = 1.0 + 0.5 * (1.2 - gear.rack.dedendum)
    return depth * (1.0 - 0.02 * (20.0 - degrees(gear.rack.pressure_angle)))


def _rims(pair: CylindricalPair, rims: tuple[Rim | None, Rim | None]) -> tuple[float, tuple[float, float]]:
    """C_R, the mean of both bodies, and its range."""
    module, width = pair.pinion.normal_module, pair.face_width
    thinnest = Rim(0.0, 0.0).factor(1.0, module) * _RIM_RANGE[0]
    value = least = greatest = 0.0
    for rim in rims:
        if rim is SOLID:
            factors = 1.0, 1.0, 1.0
        elif rim is None or width == 0.0:  # without a face width a web cannot be compared with it
            factors = 1.0, thinnest, 1.0
        else:
            known = rim.factor(width, module)
            factors = known, known * _RIM_RANGE[0], known * _RIM_RANGE[1]
        value, least, greatest = value + factors[0], least + factors[1], greatest + factors[2]
    return 0.5 * value, (least / value, greatest / value)


def _beyond(
    pair: CylindricalPair, bodies: tuple[Material, Material], line_load: float | None
) -> tuple[str, ...]:
    """Limits of the method that are left."""
    first, second = _in_order(pair)
    x1, x2 = first.profile_shift, second.profile_shift
    checks = (
        (x1 < x2, f"x_1 = {x1:g} is below x_2 = {x2:g}; the regression is for x_1 ≥ x_2"),
        (not -0.5 <= x1 + x2 <= 2.0, f"x_1 + x_2 = {x1 + x2:g}; the regression is for −0.5 to 2"),
        (
            line_load is not None and line_load > 1.6e6,
            f"F_t K_A / b = {(line_load or 0.0) / 1e3:.4g} N/mm; the regression is for 100 to 1600 N/mm",
        ),
        (
            min(one.youngs_modulus for one in bodies) < 50e9,
            "plastic teeth: the regression is for steel, scaled by the modulus",
        ),
        (abs(degrees(pair.pinion.helix_angle)) > 45.0, "the helix angle is above 45°"),
    )
    return tuple(text for left, text in checks if left)
