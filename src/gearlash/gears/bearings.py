"""Bearings of a shaft whose bearings are not known, two deep groove ball bearings: how stiff, how far apart.

Elastic approach of a ball bearing's rings under a radial load F (Palmgren), with the load of the ball that is
loaded most, Q = 5 F/Z:

    δ_r = 4.36·10⁻⁴ mm (Q²/D)^⅓,   k_r = dF/dδ = 3F/(2 δ_r)   (Q in N, D in mm).

The bearing is taken from the shaft: outer diameter 1.6 d + 14 mm, balls of 0.3 (outer diameter − d), nine of
them, as of series 62.
"""

from __future__ import annotations

from math import inf, pi

BALLS = 9
PER_SHAFT = 2
AXIAL = 0.4
"""Axial over radial stiffness: one bearing is fixed, its contact angle small; an estimate."""
SPREAD = 4.0
"""Rollers instead of balls make it stiffer, shafts and housings softer: an estimate."""
LEAST_LOAD = 0.01
"""N for each mm² of d²: the preload that a bearing has at least; an estimate."""
STEEL = 206e9
"""Young's modulus of shafts, Pa."""
GAP = 4e-3
"""m: from the inner wall of a housing to a bearing that oil reaches; practice, an estimate."""
LEAST_WALL = 8e-3
"""m: thickness of a cast wall at least, 0.025 a + 1 mm in larger housings; a gear stays as far from it."""
SPAN_FACTOR = 2.0
"""Half to twice as far apart: close beside the gear, or on a shaft that carries more than it; an estimate."""


def ball_bearing_stiffness(shaft_diameter: float, radial_load: float) -> float:
    """Radial stiffness of one deep groove ball bearing.

    Parameters
    ----------
    shaft_diameter : float
        d, m; above 0.
    radial_load : float
        F on it, N; at least the preload `LEAST_LOAD`.

    Returns
    -------
    float
        N/m.

    References
    ----------
    A. Palmgren, Grundlagen der Wälzlagertechnik, 3rd ed., Franckh, Stuttgart 1964, elastic deformation.

    Examples
    --------
    >>> from gearlash.gears.bearings import ball_bearing_stiffness
    >>> round(ball_bearing_stiffness(0.03, 2000.0) / 1e6)  # like a 6206
    136
    """
    d = shaft_diameter * 1e3
    ball = 0.3 * (0.6 * d + 14.0)
    force = max(abs(radial_load), LEAST_LOAD * d**2)
    approach = 4.36e-4 * ((5.0 * force / BALLS) ** 2 / ball) ** (1.0 / 3.0)
    return 1.5 * force / approach * 1e3


def shaft_bearings(shaft_diameter: float, radial_load: float) -> tuple[float, float]:
    """Radial and axial stiffness of the two bearings of a shaft with its gear in the middle.

    Parameters
    ----------
    shaft_diameter : float
        m; above 0.
    radial_load : float
        On the gear, N.

    Returns
    -------
    (float, float)
        N/m.

    Examples
    --------
    >>> from gearlash.gears.bearings import shaft_bearings
    >>> [round(k / 1e6) for k in shaft_bearings(0.03, 4000.0)]
    [273, 109]
    """
    radial = PER_SHAFT * ball_bearing_stiffness(shaft_diameter, radial_load / PER_SHAFT)
    return radial, AXIAL * radial


def bearing_span(face_width: float, centre_distance: float, shaft_diameter: float) -> float:
    """Distance of the two bearings of a shaft, from middle to middle, in the walls on both sides of a pair.

    The walls stand beside the teeth, at their own thickness from it, max(8 mm, 0.025 a + 1 mm), as the
    practice of gear units has it; the bearings 4 mm further, 0.27 d + 7 mm wide, as of series 62 (within a
    seventh of its widths from d = 10 to 200 mm).

    Parameters
    ----------
    face_width : float
        In common, m.
    centre_distance, shaft_diameter : float
        m.

    Returns
    -------
    float
        m.

    Examples
    --------
    >>> from gearlash.gears.bearings import bearing_span
    >>> round(bearing_span(0.04, 0.127, 0.03) * 1e3, 1)
    79.1
    """
    wall = max(LEAST_WALL, 0.025 * centre_distance + 1e-3)
    return face_width + 2.0 * (wall + GAP) + 0.27 * shaft_diameter + 7e-3


def shaft_stiffness(shaft_diameter: float, free_length: float) -> float:
    """Lateral stiffness of a steel shaft with a stiff gear body in its middle, at that body.

    Parameters
    ----------
    shaft_diameter : float
        m; above 0.
    free_length : float
        On either side, from the body to the middle of the bearing, m; 0 or less: nothing bends.

    Returns
    -------
    float
        N/m, 6 E I/l³: either side is a cantilever with half of the force at its end.

    Examples
    --------
    >>> from gearlash.gears.bearings import shaft_stiffness
    >>> round(shaft_stiffness(0.012, 0.03) / 1e6, 1)
    46.6
    """
    if free_length <= 0.0:
        return inf
    return 6.0 * STEEL * pi * shaft_diameter**4 / 64.0 / free_length**3
