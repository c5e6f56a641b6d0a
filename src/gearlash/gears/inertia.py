"""Rotary inertia of gear bodies, and the mass that resists relative motion along the mesh."""

from __future__ import annotations

from math import pi

STEEL_DENSITY = 7850.0
"""kg/m³, the usual value of design handbooks."""


def solid_disc(mass: float, radius: float) -> float:
    """Moment of inertia of a solid disc, J = m R²/2.

    Parameters
    ----------
    mass : float
        kg.
    radius : float
        Outer radius, m. For a gear without further data it is the *pitch* radius, whatever the projection: a
        body's inertia does not depend on how its rotation is written down.

    Returns
    -------
    float
        kg·m².

    Examples
    --------
    >>> from gearlash.gears import solid_disc
    >>> solid_disc(mass=8.0, radius=0.5)
    1.0
    """
    return 0.5 * mass * radius**2


def disc_face_width(mass: float, radius: float, density: float = STEEL_DENSITY) -> float:
    """Width of a solid disc of known mass.

    Parameters
    ----------
    mass : float
        kg.
    radius : float
        m.
    density : float
        kg/m³; that of steel where nothing is given.

    Returns
    -------
    float
        m.

    Examples
    --------
    >>> from gearlash.gears import disc_face_width
    >>> round(disc_face_width(mass=6.0, radius=0.1), 5)
    0.02433
    """
    return mass / (density * pi * radius**2)


def equivalent_mass(radii: tuple[float, float], inertias: tuple[float, float]) -> float:
    """The mass that resists relative motion u = R_p θ_p - R_g θ_g: 1/m_e = R_p²/J_p + R_g²/J_g.

    Parameters
    ----------
    radii : (float, float)
        R_p and R_g, m.
    inertias : (float, float)
        J_p and J_g, kg·m².

    Returns
    -------
    float
        m_e, kg.

    Examples
    --------
    >>> from gearlash.gears import equivalent_mass, solid_disc
    >>> round(equivalent_mass((0.1, 0.2), (solid_disc(6.0, 0.1), solid_disc(24.0, 0.2))), 12)  # m₁m₂/2(m₁+m₂)
    2.4
    """
    return 1.0 / sum(radius**2 / inertia for radius, inertia in zip(radii, inertias, strict=True))
