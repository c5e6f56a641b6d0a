"""One external cylindrical involute gear as its drawing states it, spur or helical.

ISO 21771-1, Cylindrical involute gears and gear pairs: concepts and geometry (the geometry of ISO 21771:2007,
DIN ISO 21771:2014 with its corrections); numbers in brackets are those of ISO 21771:2007. Lengths in m,
angles in rad.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import acos, asin, atan, cos, hypot, isfinite, pi, sin, sqrt, tan

from gearlash.system import GearlashError

from .basic_rack import ISO53_A, BasicRack
from .involute import inv
from .root_fillet import RootFillet


@dataclass(frozen=True)
class CylindricalGear:
    """An external cylindrical gear, cut by a rack.

    Parameters
    ----------
    teeth : int
        z, from 4.
    normal_module : float
        m_n, m; above 0.
    helix_angle : float
        β on the reference cylinder, rad; the sign is the hand, and no result but that of `mirrored` depends
        on it.
    profile_shift : float
        x, over m_n: the nominal one, for teeth without backlash.
    rack : BasicRack
    stated_tip_diameter : float, optional
        d_a of the drawing, m; from the rack and x where nothing is given.
    tip_chamfer : float
        h_K, radial height of the broken tip edge, m; at least 0.
    thickness_allowance : float
        E_sn (A_sn of DIN 3967), normal tooth thickness over the nominal one, m; below 0 for backlash.

    References
    ----------
    ISO 21771-1; ISO 21771:2007.

    Examples
    --------
    >>> from math import degrees, radians
    >>> from gearlash.gears import CylindricalGear
    >>> gear = CylindricalGear(17, 8e-3, radians(15.8), 0.145)  # the pinion of example 1 of ISO/TR 6336-30
    >>> round(gear.reference_diameter * 1e3, 2), round(gear.tip_diameter * 1e3, 2)
    (141.34, 159.66)
    >>> round(degrees(gear.transverse_pressure_angle), 3)
    20.72
    """

    teeth: int
    normal_module: float
    helix_angle: float = 0.0
    profile_shift: float = 0.0
    rack: BasicRack = ISO53_A
    stated_tip_diameter: float | None = None
    tip_chamfer: float = 0.0
    thickness_allowance: float = 0.0

    def __post_init__(self) -> None:
        """What no gear can have is refused; what is unusual is left to whoever asks."""
        if self.teeth < 4:
            raise GearlashError(f"{self.teeth} teeth: an external gear has 4 or more")
        if not (self.normal_module > 0.0 and isfinite(self.normal_module)):
            raise GearlashError(f"normal module {self.normal_module:g} m: it is above 0")
        if not abs(self.helix_angle) < pi / 2:
            raise GearlashError(f"helix angle {self.helix_angle:g} rad: it is below π/2")
        if self.tip_diameter <= self.base_diameter:
            raise GearlashError(
                f"tip diameter {self.tip_diameter * 1e3:.4g} mm: the base circle has "
                f"{self.base_diameter * 1e3:.4g} mm, so there is no flank"
            )

    def nominal(self) -> CylindricalGear:
        """The same gear without allowance: nominal tooth thickness.

        Returns
        -------
        CylindricalGear
        """
        return replace(self, thickness_allowance=0.0)

    def mirrored(self) -> CylindricalGear:
        """The same gear with the other hand of helix, as its mate has.

        Returns
        -------
        CylindricalGear
        """
        return replace(self, helix_angle=-self.helix_angle)

    @property
    def transverse_module(self) -> float:
        """m_t = m_n / cos β, m (5)."""
        return self.normal_module / cos(self.helix_angle)

    @property
    def transverse_pressure_angle(self) -> float:
        """α_t, rad; tan α_t = tan α_n / cos β."""
        return atan(tan(self.rack.pressure_angle) / cos(self.helix_angle))

    @property
    def base_helix_angle(self) -> float:
        """|β_b|, rad; sin β_b = sin β cos α_n."""
        return asin(abs(sin(self.helix_angle)) * cos(self.rack.pressure_angle))

    @property
    def reference_diameter(self) -> float:
        """d = z m_t, m (1)."""
        return self.teeth * self.transverse_module

    @property
    def base_diameter(self) -> float:
        """d_b = d cos α_t, m."""
        return self.reference_diameter * cos(self.transverse_pressure_angle)

    @property
    def transverse_base_pitch(self) -> float:
        """p_bt = π d_b / z, m (28); on the line of action it is the pitch p_et of the contacts."""
        return pi * self.base_diameter / self.teeth

    @property
    def virtual_teeth(self) -> float:
        """z_n = z / (cos² β_b cos β) (46)."""
        return self.teeth / (cos(self.base_helix_angle) ** 2 * cos(self.helix_angle))

    @property
    def generating_profile_shift(self) -> float:
        """x_E = x + E_sn / (2 m_n tan α_n): where the tool stands when it cuts the allowance too (123)."""
        return self.profile_shift + self.thickness_allowance / (
            2.0 * self.normal_module * tan(self.rack.pressure_angle)
        )

    @property
    def tip_diameter(self) -> float:
        """d_a, m: as stated, or d + 2 m_n (h_aP* + x) (33)."""
        if self.stated_tip_diameter is not None:
            return self.stated_tip_diameter
        return self.reference_diameter + 2.0 * self.normal_module * (self.rack.addendum + self.profile_shift)

    @property
    def tip_form_diameter(self) -> float:
        """d_Fa = d_a − 2 h_K, m: where the usable flank ends (127)."""
        return self.tip_diameter - 2.0 * self.tip_chamfer

    @property
    def root_diameter(self) -> float:
        """d_fE = d − 2 m_n (h_fP* − x_E), m (125)."""
        return self.reference_diameter - 2.0 * self.normal_module * (
            self.rack.dedendum - self.generating_profile_shift
        )

    @property
    def undercut_limit(self) -> float:
        """x_Emin: with a smaller generating shift the tool cuts into the involute (135).

        x_Emin = h_FfP* − z sin² α_t / (2 cos β).
        """
        return self.rack.straight_dedendum - self.teeth * sin(self.transverse_pressure_angle) ** 2 / (
            2.0 * cos(self.helix_angle)
        )

    @property
    def undercut(self) -> bool:
        """Whether the generating shift is below `undercut_limit`."""
        return self.generating_profile_shift < self.undercut_limit

    @property
    def root_form_diameter(self) -> float:
        """d_Ff, m: where the involute starts, cut by a rack whose straight flank is h_FfP deep (128).

        d_Ff² = d_b² + (d sin α_t − 2 m_n (h_FfP* − x_E) / sin α_t)². Of an undercut gear: where the fillet
        crosses the involute, for a helical one in its virtual spur gear, as high over the reference circle.
        """
        if self.undercut:
            fillet = self.root_fillet
            return self.reference_diameter + 2.0 * (fillet.involute_radius - fillet.pitch_radius)
        sine = sin(self.transverse_pressure_angle)
        depth = 2.0 * self.normal_module * (self.rack.straight_dedendum - self.generating_profile_shift)
        return hypot(self.base_diameter, self.reference_diameter * sine - depth / sine)

    @property
    def root_fillet(self) -> RootFillet:
        """Fillet of the virtual spur gear."""
        return RootFillet(self.virtual_teeth, self.normal_module, self.rack, self.generating_profile_shift)

    def roll_length(self, diameter: float) -> float:
        """Radius of curvature of the flank at a diameter, m: √(d_y² − d_b²) / 2.

        It is also the distance from the base tangent point, measured along the line of action; 0 at and below
        the base circle.

        Parameters
        ----------
        diameter : float
            d_y, m; above 0.

        Returns
        -------
        float
        """
        return 0.5 * sqrt(max(diameter**2 - self.base_diameter**2, 0.0))

    def pressure_angle_at(self, diameter: float) -> float:
        """α_yt, rad: cos α_yt = d_b / d_y; 0 at and below the base circle.

        Parameters
        ----------
        diameter : float
            d_y, m; above 0.

        Returns
        -------
        float
        """
        return acos(min(self.base_diameter / diameter, 1.0))

    def helix_angle_at(self, diameter: float) -> float:
        """β_y, rad: tan β_y = tan β d_y / d.

        Parameters
        ----------
        diameter : float
            d_y, m; above 0.

        Returns
        -------
        float
        """
        return atan(tan(self.helix_angle) * diameter / self.reference_diameter)

    def normal_thickness(self) -> float:
        """s_n on the reference cylinder, m: m_n (π/2 + 2 x_E tan α_n) (49).

        Returns
        -------
        float
        """
        return self.normal_module * (
            pi / 2 + 2.0 * self.generating_profile_shift * tan(self.rack.pressure_angle)
        )

    def transverse_thickness(self, diameter: float | None = None) -> float:
        """Transverse tooth thickness s_yt at a diameter, m.

        s_yt = d_y (s_t/d + inv α_t − inv α_yt) (38). Above the point where the flanks meet it is below 0.

        Parameters
        ----------
        diameter : float, optional
            d_y, m; above 0. The reference diameter where nothing is given.

        Returns
        -------
        float
        """
        reference = self.reference_diameter
        at = reference if diameter is None else diameter
        half = self.normal_thickness() / cos(self.helix_angle) / reference
        return at * (half + inv(self.transverse_pressure_angle) - inv(self.pressure_angle_at(at)))

    def tip_thickness(self) -> float:
        """Normal tooth thickness s_an at the tip, m; below about 0.2 m_n a hardened tip may break (48).

        Returns
        -------
        float
        """
        tip = self.tip_diameter
        return self.transverse_thickness(tip) * cos(self.helix_angle_at(tip))
