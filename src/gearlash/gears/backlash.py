"""Backlash: one play, said in five ways; what tooth thickness, centre distance and temperature make of it.

ISO 21771-1; numbers in brackets are those of ISO 21771:2007. The play j_n between the flanks, along their
common normal, is what all others are turned from and into:

    j_n = j_bt cos β_b = j_wt cos α_wt cos β_b,   j_r = j_wt / (2 tan α_wt),   j_φ = j_wt / r_w.

Lengths in m, angles in rad. Below 0 the teeth are jammed.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import acos, cos, tan

from gearlash.system import GearlashError

from .cylindrical_pair import CylindricalPair
from .involute import inv


@dataclass(frozen=True)
class Backlash:
    """The play of a pair of teeth, for one position of the axes.

    Parameters
    ----------
    normal : float
        j_n (j_bn), m: the shortest way between the flanks that do not touch.
    working_pressure_angle : float
        α_wt, rad.
    base_helix_angle : float
        β_b, rad.
    working_diameters : (float, float)
        d_w1 and d_w2, m.
    reference_diameter : float
        d_1, m.

    References
    ----------
    ISO 21771-1; ISO 21771:2007, equations (99) to (104).

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> from gearlash.gears.backlash import Backlash
    >>> pair = CylindricalPair(CylindricalGear(25, 2e-3), CylindricalGear(57, 2e-3))
    >>> play = Backlash.from_circumferential(pair, 80e-6)
    >>> round(play.normal * 1e6, 2), round(play.radial * 1e6, 1)
    (75.18, 109.9)
    """

    normal: float
    working_pressure_angle: float
    base_helix_angle: float
    working_diameters: tuple[float, float]
    reference_diameter: float

    @classmethod
    def from_normal(cls, pair: CylindricalPair, normal: float) -> Backlash:
        """From j_n, m: as a feeler gauge between the flanks finds it."""
        return cls(
            normal,
            pair.working_pressure_angle,
            pair.pinion.base_helix_angle,
            pair.working_diameters,
            pair.pinion.reference_diameter,
        )

    @classmethod
    def from_circumferential(cls, pair: CylindricalPair, circumferential: float) -> Backlash:
        """From j_wt, m: the arc on the working circle, in the transverse section."""
        unit = cls.from_normal(pair, 1.0)
        return replace(unit, normal=circumferential / unit.circumferential)

    @classmethod
    def from_reference_arc(cls, pair: CylindricalPair, arc: float) -> Backlash:
        """From j_t, m: the arc on the reference circle, in the transverse section."""
        unit = cls.from_normal(pair, 1.0)
        return replace(unit, normal=arc / unit.reference_arc)

    @classmethod
    def from_radial(cls, pair: CylindricalPair, radial: float) -> Backlash:
        """From j_r, m: how much nearer the axes could come, for a small play."""
        unit = cls.from_normal(pair, 1.0)
        return replace(unit, normal=radial / unit.radial)

    @classmethod
    def from_angle(cls, pair: CylindricalPair, angle: float, index: int = 0) -> Backlash:
        """From j_φ, rad: how far pinion (0) or gear (1) turns while the other stands still."""
        unit = cls.from_normal(pair, 1.0)
        return replace(unit, normal=angle / unit.angles[index])

    @property
    def transverse(self) -> float:
        """j_bt, m: along the line of action in the transverse section."""
        return self.normal / cos(self.base_helix_angle)

    @property
    def circumferential(self) -> float:
        """j_wt, m: on the working circles (102)."""
        return self.transverse / cos(self.working_pressure_angle)

    @property
    def reference_arc(self) -> float:
        """j_t, m: on the reference circles, j_wt d/d_w."""
        return self.circumferential * self.reference_diameter / self.working_diameters[0]

    @property
    def radial(self) -> float:
        """j_r, m (104)."""
        return self.circumferential / (2.0 * tan(self.working_pressure_angle))

    @property
    def angles(self) -> tuple[float, float]:
        """j_φ1 and j_φ2, rad: of pinion and gear while the other stands still."""
        first, second = self.working_diameters
        return 2.0 * self.circumferential / first, 2.0 * self.circumferential / second


@dataclass(frozen=True)
class Growth:
    """How much longer than on the drawing: relative linear growth of pinion, gear and housing.

    Expansion by temperature, α ΔT, and swelling by water or oil add up.

    Parameters
    ----------
    pinion, gear, housing : float
        Δl/l; 0 at the temperature of the drawing, 20 °C.

    Examples
    --------
    >>> from gearlash.gears.backlash import Growth
    >>> round(Growth.thermal((11.5e-6, 11.5e-6, 23e-6), (60.0, 60.0, 40.0)).housing, 6)  # steel in aluminium
    0.00092
    """

    pinion: float = 0.0
    gear: float = 0.0
    housing: float = 0.0

    @classmethod
    def thermal(cls, expansions: tuple[float, float, float], rises: tuple[float, float, float]) -> Growth:
        """From coefficients of expansion, 1/K, and temperature rises, K, of pinion, gear and housing."""
        return cls(*(expansion * rise for expansion, rise in zip(expansions, rises, strict=True)))


def of_pair(pair: CylindricalPair, growth: Growth | None = None) -> Backlash:
    """Backlash of gears with their tooth thicknesses at their centre distance, without approximation.

    Parameters
    ----------
    pair : CylindricalPair
        The allowances of tooth thickness are those of its gears.
    growth : Growth, optional
        What temperature and swelling add; each body grows evenly.

    Returns
    -------
    Backlash
        j_bt = p_bt + (d_b1 + d_b2) inv α_wt − s_bt1 − s_bt2, with the base circle's transverse tooth
        thicknesses s_bt. Where gears of two materials have different base pitches, the smaller one counts.

    Raises
    ------
    GearlashError
        Where the base circles have grown into each other.

    Notes
    -----
    From the widths that tooth and space have on the working circles, r_w (s_bt/d_b − inv α_wt) each side.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair, backlash
    >>> pinion = CylindricalGear(25, 2e-3, thickness_allowance=-40e-6)
    >>> pair = CylindricalPair(pinion, CylindricalGear(57, 2e-3, thickness_allowance=-40e-6), 82e-3)
    >>> round(backlash.of_pair(pair).circumferential * 1e6, 6)
    80.0
    """
    grown = Growth() if growth is None else growth
    scales = 1.0 + grown.pinion, 1.0 + grown.gear
    bases = [scale * one.base_diameter for scale, one in zip(scales, pair.gears, strict=True)]
    distance = (1.0 + grown.housing) * pair.centre_distance
    if distance <= 0.5 * sum(bases):
        raise GearlashError("the base circles have grown into each other: no line of action is left")
    angle = acos(0.5 * sum(bases) / distance)
    teeth = sum(
        scale * one.transverse_thickness(one.base_diameter)
        for scale, one in zip(scales, pair.gears, strict=True)
    )
    play = min(scales) * pair.pinion.transverse_base_pitch + sum(bases) * inv(angle) - teeth
    return Backlash(
        play * cos(pair.pinion.base_helix_angle),
        angle,
        pair.pinion.base_helix_angle,
        (bases[0] / cos(angle), bases[1] / cos(angle)),
        scales[0] * pair.pinion.reference_diameter,
    )


def limits(
    pair: CylindricalPair,
    allowances: tuple[tuple[float, float], tuple[float, float]],
    distance_deviations: tuple[float, float] = (0.0, 0.0),
) -> tuple[Backlash, Backlash]:
    """Least and greatest backlash that a drawing's tolerances allow.

    Parameters
    ----------
    pair : CylindricalPair
        Allowances of its gears are replaced.
    allowances : ((float, float), (float, float))
        Upper and lower allowance of the normal tooth thickness, E_sns and E_sni, of pinion and gear, m.
    distance_deviations : (float, float)
        Lower and upper deviation of the centre distance, A_ai and A_ae, m.

    Returns
    -------
    (Backlash, Backlash)
        Thickest teeth at the least distance, thinnest at the greatest.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair, backlash
    >>> pair = CylindricalPair(CylindricalGear(25, 2e-3), CylindricalGear(57, 2e-3), 82e-3)
    >>> least, most = backlash.limits(pair, ((-54e-6, -84e-6), (-70e-6, -110e-6)), (-17.5e-6, 17.5e-6))
    >>> round(least.circumferential * 1e6, 1), round(most.circumferential * 1e6, 1)
    (111.2, 206.8)
    """
    found = []
    for i in (0, 1):
        pinion, gear = (
            replace(one, thickness_allowance=allowance[i])
            for one, allowance in zip(pair.gears, allowances, strict=True)
        )
        distance = pair.centre_distance + distance_deviations[i]
        found.append(of_pair(replace(pair, pinion=pinion, gear=gear, stated_centre_distance=distance)))
    return found[0], found[1]


def recommended_minimum(pair: CylindricalPair) -> float:
    """Recommended least normal backlash of industrial drives with housings and gears of ferrous metals.

    Parameters
    ----------
    pair : CylindricalPair

    Returns
    -------
    float
        j_bn,min = ⅔ (0.06 mm + 0.0005 a + 0.03 m_n), m. The recommendation is made for modules from 1.5 to 18
        mm and pitch line speeds below 15 m/s; for finer modules its constant term is large.

    References
    ----------
    ISO/TR 10064-2:1996, Annex A, equation (A.1).

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair, backlash
    >>> pair = CylindricalPair(CylindricalGear(20, 5e-3), CylindricalGear(40, 5e-3), 0.15)
    >>> round(backlash.recommended_minimum(pair) * 1e3, 2)
    0.19
    """
    return 2.0 / 3.0 * (60e-6 + 0.0005 * pair.centre_distance + 0.03 * pair.pinion.normal_module)
