"""Tooth thickness as a drawing states it: span measurement W_k, dimension over balls or pins M_d.

DIN 21773:2014 (and DIN 3960:1987), inspection dimensions; numbers in brackets are those of DIN 21773. Each
measure is a function of the generating profile shift x_E alone, so each is turned back into x_E, and an
allowance of the tooth thickness goes through x_E too. Lengths in m, angles in rad.
"""

from __future__ import annotations

from dataclasses import replace
from math import acos, atan, cos, hypot, pi, sin, tan

from gearlash.system import GearlashError

from .cylindrical_gear import CylindricalGear
from .involute import inv, inverse_involute


def span_teeth(gear: CylindricalGear) -> int:
    """Number of teeth k to measure over, so that the anvils touch near the diameter d + 2 x m_n.

    Parameters
    ----------
    gear : CylindricalGear

    Returns
    -------
    int
        k, from 1: the integer nearest to z (tan α_yt / cos² β_b − inv α_t)/π − 2 x tan α_n/π + ½ of DIN 3960.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, inspection
    >>> inspection.span_teeth(CylindricalGear(24, 3e-3, profile_shift=0.4))
    4
    """
    at = gear.reference_diameter + 2.0 * gear.profile_shift * gear.normal_module
    alpha_n = gear.rack.pressure_angle
    roll = tan(gear.pressure_angle_at(at)) / cos(gear.base_helix_angle) ** 2
    pitches = gear.teeth * (roll - inv(gear.transverse_pressure_angle))
    return max(1, round((pitches - 2.0 * gear.profile_shift * tan(alpha_n)) / pi + 0.5))


def span_measurement(gear: CylindricalGear, teeth: int | None = None) -> float:
    """Span measurement (base tangent length) over k teeth.

    Parameters
    ----------
    gear : CylindricalGear
    teeth : int, optional
        k; `span_teeth` where nothing is given.

    Returns
    -------
    float
        W_k = m_n cos α_n ((k − ½) π + z inv α_t) + 2 x_E m_n sin α_n, m (14).

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, inspection
    >>> round(inspection.span_measurement(CylindricalGear(24, 3e-3, profile_shift=0.4)) * 1e3, 4)
    32.8266
    """
    k = span_teeth(gear) if teeth is None else teeth
    alpha_n = gear.rack.pressure_angle
    pitches = (k - 0.5) * pi + gear.teeth * inv(gear.transverse_pressure_angle)
    shift = 2.0 * gear.generating_profile_shift * sin(alpha_n)
    return gear.normal_module * (cos(alpha_n) * pitches + shift)


def with_span(gear: CylindricalGear, span: float, teeth: int) -> CylindricalGear:
    """The gear whose nominal teeth have this span: W_k turned back into the profile shift.

    Parameters
    ----------
    gear : CylindricalGear
        Its profile shift and allowance are replaced.
    span : float
        W_k, m.
    teeth : int
        k.

    Returns
    -------
    CylindricalGear
        Without allowance.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, inspection
    >>> gear = inspection.with_span(CylindricalGear(24, 3e-3), 32.8266e-3, 4)
    >>> round(gear.profile_shift, 4)
    0.4
    """
    plain = replace(gear, profile_shift=0.0, thickness_allowance=0.0)
    difference = span - span_measurement(plain, teeth)
    return replace(
        plain, profile_shift=difference / (2.0 * gear.normal_module * sin(gear.rack.pressure_angle))
    )


def span_contact_diameter(gear: CylindricalGear, teeth: int | None = None) -> float:
    """Diameter at which the anvils touch, m: √(d_b² + (W_k cos β_b)²) (17).

    It must lie on the usable flank.
    """
    span = span_measurement(gear, teeth)
    return hypot(gear.base_diameter, span * cos(gear.base_helix_angle))


def span_face_width(gear: CylindricalGear, teeth: int | None = None) -> float:
    """Face width that a helical gear needs at least to be measured over k teeth, m: W_k sin |β_b| (15)."""
    return span_measurement(gear, teeth) * sin(gear.base_helix_angle)


def _half_space(gear: CylindricalGear) -> float:
    """Half the angle of the tooth space on the base cylinder, rad: (π/2 − 2 x_E tan α_n)/z − inv α_t."""
    at_reference = (pi / 2 - 2.0 * gear.generating_profile_shift * tan(gear.rack.pressure_angle)) / gear.teeth
    return at_reference - inv(gear.transverse_pressure_angle)


def ball_centre_diameter(gear: CylindricalGear, ball_diameter: float) -> float:
    """Diameter d_K on which the centre of a ball in a tooth space lies.

    Parameters
    ----------
    gear : CylindricalGear
    ball_diameter : float
        D_M, m.

    Returns
    -------
    float
        d_K = d_b / cos α_Kt, m; inv α_Kt = D_M/(z m_n cos α_n) − (π/2 − 2 x_E tan α_n)/z + inv α_t.

    Raises
    ------
    GearlashError
        For a ball so small that it does not rest on the flanks.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, inspection
    >>> round(inspection.ball_centre_diameter(CylindricalGear(20, 3e-3), 5e-3) * 1e3, 3)
    61.535
    """
    reach = gear.teeth * gear.normal_module * cos(gear.rack.pressure_angle)
    value = ball_diameter / reach - _half_space(gear)
    if value < 0.0:
        raise GearlashError(
            f"a ball of {ball_diameter * 1e3:.4g} mm falls through to the root; "
            f"{ideal_ball_diameter(gear) * 1e3:.4g} mm touches the middle of the flanks"
        )
    return gear.base_diameter / cos(inverse_involute(value))


def dimension_over_balls(gear: CylindricalGear, ball_diameter: float) -> float:
    """Dimension over two balls.

    Parameters
    ----------
    gear : CylindricalGear
    ball_diameter : float
        D_M, m.

    Returns
    -------
    float
        M_dK, m (35), (36): d_K + D_M for an even number of teeth, d_K cos(π/2z) + D_M for an odd one.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, inspection
    >>> round(inspection.dimension_over_balls(CylindricalGear(25, 2e-3, 0.3491), 3.5e-3) * 1e3, 2)
    58.08
    """
    return ball_centre_diameter(gear, ball_diameter) * _opposite(gear, pins=False) + ball_diameter


def dimension_over_pins(gear: CylindricalGear, pin_diameter: float) -> float:
    """Dimension M_dR over two pins, m (37).

    As over balls, but pins in a helical gear with an odd number of teeth come to lie opposite each other:
    there d_K + D_M.
    """
    return ball_centre_diameter(gear, pin_diameter) * _opposite(gear, pins=True) + pin_diameter


def with_dimension_over_balls(
    gear: CylindricalGear, dimension: float, ball_diameter: float, pins: bool = False
) -> CylindricalGear:
    """The gear whose nominal teeth have this dimension: M_d turned back into the profile shift.

    Parameters
    ----------
    gear : CylindricalGear
        Its profile shift and allowance are replaced.
    dimension : float
        M_dK, or M_dR with ``pins``, m.
    ball_diameter : float
        D_M, m.
    pins : bool
        Whether pins were laid in, not balls.

    Returns
    -------
    CylindricalGear
        Without allowance.

    Raises
    ------
    GearlashError
        For a dimension that the base circle does not reach.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, inspection
    >>> gear = CylindricalGear(20, 3e-3, profile_shift=0.3)
    >>> over = inspection.dimension_over_balls(gear, 5.25e-3)
    >>> back = inspection.with_dimension_over_balls(CylindricalGear(20, 3e-3), over, 5.25e-3)
    >>> round(back.profile_shift, 12)
    0.3
    """
    centre = (dimension - ball_diameter) / _opposite(gear, pins)
    if centre < gear.base_diameter:
        raise GearlashError(
            f"dimension over balls {dimension * 1e3:.6g} mm with a ball of {ball_diameter * 1e3:.4g} mm: "
            f"the centre would lie inside the base circle of {gear.base_diameter * 1e3:.6g} mm"
        )
    plain = replace(gear, profile_shift=0.0, thickness_allowance=0.0)
    reach = gear.teeth * gear.normal_module * cos(gear.rack.pressure_angle)
    space = ball_diameter / reach - inv(acos(gear.base_diameter / centre))
    shift = (_half_space(plain) - space) * gear.teeth / (2.0 * tan(gear.rack.pressure_angle))
    return replace(plain, profile_shift=shift)


def _opposite(gear: CylindricalGear, pins: bool) -> float:
    """The dimension between centres over d_K."""
    if gear.teeth % 2 == 0 or (pins and gear.helix_angle != 0.0):
        return 1.0
    return cos(pi / (2.0 * gear.teeth))


def ball_contact_diameter(gear: CylindricalGear, ball_diameter: float) -> float:
    """Diameter at which a ball touches the flanks, m (33): tan α_Mt = tan α_Kt − D_M cos β_b / d_b."""
    base = gear.base_diameter
    centre = acos(base / ball_centre_diameter(gear, ball_diameter))
    roll = tan(centre) - ball_diameter * cos(gear.base_helix_angle) / base
    return base * hypot(1.0, roll)


def ideal_ball_diameter(gear: CylindricalGear, contact_diameter: float | None = None) -> float:
    """Ball that touches the flanks at a diameter.

    Parameters
    ----------
    gear : CylindricalGear
    contact_diameter : float, optional
        m, above the base diameter; d + 2 x m_n where nothing is given.

    Returns
    -------
    float
        D_M, m: to be rounded to a ball that is at hand.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, inspection
    >>> gear = CylindricalGear(30, 4e-3, 0.3)
    >>> ball = inspection.ideal_ball_diameter(gear)
    >>> round(ball * 1e3, 3), round(inspection.ball_contact_diameter(gear, ball) * 1e3, 3)
    (6.804, 125.61)
    """
    at = contact_diameter
    if at is None:
        at = gear.reference_diameter + 2.0 * gear.profile_shift * gear.normal_module
    contact = tan(gear.pressure_angle_at(at))
    space, square = _half_space(gear), cos(gear.base_helix_angle) ** 2
    angle = atan(contact + max(space, 0.0))
    for _ in range(50):  # tan α_K − tan α_M = cos² β_b (inv α_K + space): increasing in α_K
        value = tan(angle) - contact - square * (inv(angle) + space)
        step = value / (1.0 + (1.0 - square) * tan(angle) ** 2)
        angle = min(max(angle - step, 0.5 * angle), 0.5 * (angle + pi / 2))
        if abs(step) < 1e-15:
            break
    return (tan(angle) - contact) * gear.base_diameter / cos(gear.base_helix_angle)
