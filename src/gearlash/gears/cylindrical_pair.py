"""A pair of external cylindrical gears on parallel axes: how its teeth mesh.

ISO 21771-1; numbers in brackets are those of ISO 21771:2007. Places on the line of action are distances from
the base tangent point T1 of the first gear; the second gear has its own T2 at `tangent_length`. Lengths in m,
angles in rad.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import acos, cos, isclose, pi, sin, sqrt, tan

from gearlash.system import GearlashError

from .cylindrical_gear import CylindricalGear
from .involute import inv, inverse_involute


@dataclass(frozen=True)
class CylindricalPair:
    """Two gears at a centre distance.

    Parameters
    ----------
    pinion, gear : CylindricalGear
        With the same normal module, normal pressure angle and helix angle; the hands are taken to fit.
    stated_centre_distance : float, optional
        a_w, m; that of the pair without backlash where nothing is given.
    face_width : float
        b, of both gears in common, m; at least 0.

    Raises
    ------
    GearlashError
        For gears that do not mesh, or a centre distance that the base circles do not allow.

    Examples
    --------
    >>> from math import radians
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> pinion = CylindricalGear(17, 8e-3, radians(15.8), 0.145, stated_tip_diameter=159.66e-3)
    >>> wheel = CylindricalGear(103, 8e-3, radians(15.8), 0.0, stated_tip_diameter=872.35e-3)
    >>> pair = CylindricalPair(pinion, wheel, 0.5, face_width=0.1)  # example 1 of ISO/TR 6336-30
    >>> round(pair.transverse_contact_ratio, 3), round(pair.overlap_ratio, 3)
    (1.549, 1.083)
    """

    pinion: CylindricalGear
    gear: CylindricalGear
    stated_centre_distance: float | None = None
    face_width: float = 0.0

    def __post_init__(self) -> None:
        """Gears that cannot mesh are refused."""
        first, second = self.pinion, self.gear
        common = (
            ("normal module", first.normal_module, second.normal_module),
            ("pressure angle", first.rack.pressure_angle, second.rack.pressure_angle),
            ("helix angle", abs(first.helix_angle), abs(second.helix_angle)),
        )
        for name, one, other in common:
            if not isclose(one, other, rel_tol=1e-9, abs_tol=1e-12):
                raise GearlashError(f"{name} {one:g} and {other:g}: gears that mesh have the same")
        if self.centre_distance <= self.base_radii_sum:
            raise GearlashError(
                f"centre distance {self.centre_distance * 1e3:.6g} mm: the base circles touch at "
                f"{self.base_radii_sum * 1e3:.6g} mm, and no line of action is left"
            )

    @property
    def gears(self) -> tuple[CylindricalGear, CylindricalGear]:
        """Pinion and gear."""
        return self.pinion, self.gear

    @property
    def ratio(self) -> float:
        """u = z_2/z_1."""
        return self.gear.teeth / self.pinion.teeth

    @property
    def base_radii_sum(self) -> float:
        """r_b1 + r_b2, m."""
        return 0.5 * (self.pinion.base_diameter + self.gear.base_diameter)

    @property
    def reference_centre_distance(self) -> float:
        """a_d = (d_1 + d_2)/2, m."""
        return 0.5 * (self.pinion.reference_diameter + self.gear.reference_diameter)

    @cached_property
    def tight_pressure_angle(self) -> float:
        """α_wt without backlash, rad: inv α_wt = inv α_t + 2 (x_1 + x_2) tan α_n / (z_1 + z_2) (55)."""
        shifts = self.pinion.profile_shift + self.gear.profile_shift
        teeth = self.pinion.teeth + self.gear.teeth
        value = inv(self.pinion.transverse_pressure_angle)
        return inverse_involute(value + 2.0 * shifts * tan(self.pinion.rack.pressure_angle) / teeth)

    @property
    def tight_centre_distance(self) -> float:
        """Centre distance of the nominal teeth without backlash, m: (r_b1 + r_b2) / cos α_wt."""
        return self.base_radii_sum / cos(self.tight_pressure_angle)

    @property
    def centre_distance(self) -> float:
        """a_w, m: as stated, or the one without backlash."""
        if self.stated_centre_distance is not None:
            return self.stated_centre_distance
        return self.tight_centre_distance

    @property
    def working_pressure_angle(self) -> float:
        """α_wt, rad: cos α_wt = (r_b1 + r_b2) / a_w (54)."""
        return acos(self.base_radii_sum / self.centre_distance)

    @property
    def working_diameters(self) -> tuple[float, float]:
        """d_w1 and d_w2, m: 2 a_w z_i / (z_1 + z_2) (56), (57)."""
        unit = 2.0 * self.centre_distance / (self.pinion.teeth + self.gear.teeth)
        return self.pinion.teeth * unit, self.gear.teeth * unit

    @property
    def tangent_length(self) -> float:
        """T1T2 = a_w sin α_wt, m (87)."""
        return self.centre_distance * sin(self.working_pressure_angle)

    @property
    def tip_clearances(self) -> tuple[float, float]:
        """c_1 and c_2, m: from the tip of that gear to the root of its mate (60); below 0 they collide."""
        first, second = self.gears
        return (
            self.centre_distance - 0.5 * (second.root_diameter + first.tip_diameter),
            self.centre_distance - 0.5 * (first.root_diameter + second.tip_diameter),
        )

    @property
    def path_of_contact(self) -> tuple[float, float]:
        """Where contact starts and ends, as distances from T1, m; the first gear drives.

        It starts where the tip of the second gear reaches (SAP) and ends at the tip of the first (EAP),
        unless the involute of the mate starts later (d_Ff) or the base tangent point is nearer: then there.
        For gears whose tips do not reach each other both are the same place.
        """
        first, second = self.gears
        whole = self.tangent_length
        start = max(
            whole - second.roll_length(second.tip_form_diameter),
            first.roll_length(first.root_form_diameter),
        )
        end = min(
            first.roll_length(first.tip_form_diameter),
            whole - second.roll_length(second.root_form_diameter),
        )
        return start, max(start, end)

    @property
    def active_root_diameters(self) -> tuple[float, float]:
        """d_Nf1 and d_Nf2, m: the lowest diameters that touch (64), (65)."""
        start, end = self.path_of_contact
        first, second = self.gears
        return _diameter(first, start), _diameter(second, self.tangent_length - end)

    @property
    def interference(self) -> tuple[bool, bool]:
        """Whether the tip of the mate reaches below the involute of pinion and gear.

        Compared with d_Ff of a root that a rack has cut; what contact is left is in `path_of_contact`.
        """
        first, second = self.gears
        whole = self.tangent_length
        slack = 1e-12 * whole
        return (
            whole - second.roll_length(second.tip_form_diameter)
            < first.roll_length(first.root_form_diameter) - slack,
            whole - first.roll_length(first.tip_form_diameter)
            < second.roll_length(second.root_form_diameter) - slack,
        )

    @property
    def transverse_contact_ratio(self) -> float:
        """ε_α: path of contact over p_et (90); 0 where nothing touches."""
        start, end = self.path_of_contact
        return (end - start) / self.pinion.transverse_base_pitch

    @property
    def overlap_ratio(self) -> float:
        """ε_β = b sin |β| / (π m_n) (93)."""
        return self.face_width * abs(sin(self.pinion.helix_angle)) / (pi * self.pinion.normal_module)

    @property
    def total_contact_ratio(self) -> float:
        """ε_γ = ε_α + ε_β (97)."""
        return self.transverse_contact_ratio + self.overlap_ratio


def shift_sum(pair: CylindricalPair) -> float:
    """Sum of the profile shifts for teeth without backlash at the pair's centre distance.

    Parameters
    ----------
    pair : CylindricalPair
        Its own shifts do not matter.

    Returns
    -------
    float
        x_1 + x_2 = (z_1 + z_2)(inv α_wt − inv α_t) / (2 tan α_n) (62).

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> from gearlash.gears.cylindrical_pair import shift_sum
    >>> pair = CylindricalPair(CylindricalGear(12, 3e-3), CylindricalGear(24, 3e-3), 56.5e-3)
    >>> round(shift_sum(pair), 3)
    0.96
    """
    difference = inv(pair.working_pressure_angle) - inv(pair.pinion.transverse_pressure_angle)
    teeth = pair.pinion.teeth + pair.gear.teeth
    return teeth * difference / (2.0 * tan(pair.pinion.rack.pressure_angle))


def tip_shortening(pair: CylindricalPair) -> float:
    """Change of the tip radii that keeps the clearance of the rack at the pair's centre distance.

    Parameters
    ----------
    pair : CylindricalPair

    Returns
    -------
    float
        k m_n = a_w − a_d − m_n (x_1 + x_2), m; usually below 0: that much comes off both tips.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> from gearlash.gears.cylindrical_pair import tip_shortening
    >>> pinion, gear = CylindricalGear(12, 3e-3, 0.0, 0.6), CylindricalGear(24, 3e-3, 0.0, 0.36)
    >>> pair = CylindricalPair(pinion, gear, 56.5e-3)
    >>> round(tip_shortening(pair) * 1e3, 2)
    -0.38
    """
    shifts = pair.pinion.profile_shift + pair.gear.profile_shift
    return pair.centre_distance - pair.reference_centre_distance - shifts * pair.pinion.normal_module


def _diameter(gear: CylindricalGear, roll: float) -> float:
    """Diameter of the point whose radius of curvature this is, m."""
    return 2.0 * sqrt(roll**2 + 0.25 * gear.base_diameter**2)
