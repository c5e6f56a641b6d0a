"""Geometry of a cylindrical involute pair, and how its displacements add up along the line of action.

Standard relations of parallel-axis involute gears (ISO 21771-1): α_n, β are the normal pressure angle and
the helix angle on the pitch cylinder, α_t the transverse pressure angle, β_b the helix angle on the base
cylinder;

    tan α_t = tan α_n / cos β,   sin β_b = sin β cos α_n,   cos α_n cos β = cos α_t cos β_b.

Zero profile shift and the standard centre distance are assumed throughout. Lengths in m, angles in rad.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from math import asin, atan, cos, pi, sin, sqrt, tan


class Projection(StrEnum):
    """Which radius turns rotation into displacement, and with which factor it enters the line of action.

    ``PITCH`` (r, cos α_n cos β) and ``BASE`` (r_b, cos β_b) are the same physics, as r cos α_n cos β =
    r_b cos β_b, with another equivalent mass and so another frequency scale. ``MIXED`` (r_b,
    cos α_n cos β) takes the radius of one and the factor of the other, as some publications print it; it is a
    different model. Case files call it ``article-literal``.
    """

    PITCH = "pitch"
    BASE = "base"
    MIXED = "article-literal"


class YAxis(StrEnum):
    """Direction of the lateral coordinate y: tangent to the pitch circles, or along the line of action."""

    PITCH_TANGENT = "pitch-tangent"
    LINE_OF_ACTION = "line-of-action"


@dataclass(frozen=True)
class ToothGeometry:
    """The teeth of a cylindrical pair.

    Parameters
    ----------
    teeth : (int, int)
        Of pinion and gear.
    normal_module : float
        m_n, m.
    pressure_angle : float
        Normal pressure angle α_n, rad.
    helix_angle : float
        β on the pitch cylinder, rad; 0 for spur gears.
    addendum : float
        Tip height over the normal module; 1 for the standard basic rack of ISO 53.

    References
    ----------
    ISO 21771-1, Cylindrical involute gears and gear pairs: concepts and geometry.

    Examples
    --------
    >>> from math import radians
    >>> from gearlash.gears import ToothGeometry
    >>> spur = ToothGeometry((20, 40), 2e-3, radians(20))
    >>> round(spur.centre_distance, 6), round(spur.transverse_contact_ratio, 3)
    (0.06, 1.635)
    """

    teeth: tuple[int, int]
    normal_module: float
    pressure_angle: float
    helix_angle: float = 0.0
    addendum: float = 1.0

    @property
    def pitch_radii(self) -> tuple[float, float]:
        """r = m_n z / (2 cos β) of pinion and gear, m."""
        scale = self.normal_module / (2.0 * cos(self.helix_angle))
        return self.teeth[0] * scale, self.teeth[1] * scale

    @property
    def base_radii(self) -> tuple[float, float]:
        """r_b = r cos α_t of pinion and gear, m."""
        factor = cos(self.transverse_pressure_angle)
        return self.pitch_radii[0] * factor, self.pitch_radii[1] * factor

    @property
    def transverse_pressure_angle(self) -> float:
        """α_t, rad."""
        return atan(tan(self.pressure_angle) / cos(self.helix_angle))

    @property
    def base_helix_angle(self) -> float:
        """β_b, rad."""
        return asin(sin(self.helix_angle) * cos(self.pressure_angle))

    @property
    def centre_distance(self) -> float:
        """Standard centre distance, m."""
        return sum(self.pitch_radii)

    @property
    def transverse_contact_ratio(self) -> float:
        """ε_α: length of the path of contact over the transverse base pitch."""
        alpha = self.transverse_pressure_angle
        tip = self.addendum * self.normal_module
        path = -self.centre_distance * sin(alpha)
        for pitch, base in zip(self.pitch_radii, self.base_radii, strict=True):
            path += sqrt((pitch + tip) ** 2 - base**2)
        base_pitch = pi * self.normal_module / cos(self.helix_angle) * cos(alpha)
        return path / base_pitch

    def overlap_ratio(self, face_width: float) -> float:
        """Overlap ratio ε_β.

        Parameters
        ----------
        face_width : float
            Common face width, m.

        Returns
        -------
        float
        """
        return face_width * abs(sin(self.helix_angle)) / (pi * self.normal_module)

    def total_contact_ratio(self, face_width: float) -> float:
        """Total contact ratio ε_γ = ε_α + ε_β.

        Parameters
        ----------
        face_width : float
            Common face width, m.

        Returns
        -------
        float
        """
        return self.transverse_contact_ratio + self.overlap_ratio(face_width)


@dataclass(frozen=True)
class LineOfAction:
    """How motion adds up along the line of action.

    x = c_t u + c_y (y_p - y_g) + c_z (z_p - z_g) - e,   u = R_p θ_p - R_g θ_g

    Parameters
    ----------
    radii : (float, float)
        R_p and R_g, m.
    c_t, c_y, c_z : float
        Factors of rotation, lateral and axial motion, from 0 to 1 (c_z may be negative).

    Examples
    --------
    >>> from gearlash.gears import LineOfAction
    >>> LineOfAction((0.05, 0.1), c_t=1.0, c_y=1.0, c_z=0.0).radii  # spur gears, by their base radii
    (0.05, 0.1)
    """

    radii: tuple[float, float]
    c_t: float
    c_y: float
    c_z: float


def line_of_action(
    geometry: ToothGeometry,
    projection: Projection = Projection.PITCH,
    y_axis: YAxis = YAxis.PITCH_TANGENT,
) -> LineOfAction:
    """Radii and direction factors of a pair.

    Parameters
    ----------
    geometry : ToothGeometry
    projection : Projection
        Which radius turns rotation into displacement.
    y_axis : YAxis
        Direction of the lateral coordinate.

    Returns
    -------
    LineOfAction
        With c_z = cos α_n sin β = sin β_b for every projection.

    Examples
    --------
    >>> from math import radians
    >>> from gearlash.gears import Projection, ToothGeometry, line_of_action
    >>> teeth = ToothGeometry((28, 70), 4e-3, radians(20), radians(18))
    >>> pitch, base = line_of_action(teeth), line_of_action(teeth, Projection.BASE)
    >>> round(pitch.c_t, 4), round(base.c_t, 4)
    (0.8937, 0.9569)
    >>> round(pitch.radii[0] * pitch.c_t - base.radii[0] * base.c_t, 12)  # the same displacement
    0.0
    """
    tangent = cos(geometry.pressure_angle) * cos(geometry.helix_angle)
    along = cos(geometry.base_helix_angle)
    return LineOfAction(
        radii=geometry.pitch_radii if projection is Projection.PITCH else geometry.base_radii,
        c_t=along if projection is Projection.BASE else tangent,
        c_y=tangent if y_axis is YAxis.PITCH_TANGENT else along,
        c_z=sin(geometry.base_helix_angle),
    )
