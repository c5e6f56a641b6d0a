"""Rotary inertia of gear bodies, and the mass that resists relative motion along the mesh."""

from __future__ import annotations

from math import pi

STEEL_DENSITY = 7850.0
"""kg/m³, the usual value of design handbooks."""


def solid_disc(mass: float, radius: float) -> float:
    """J = m R²/2 in kg·m² of a solid disc of that mass (kg) and outer radius (m).

    For a gear without further data the outer radius is the *pitch* radius, whatever the projection: a body's
    inertia does not depend on how its rotation is written down.
    """
    return 0.5 * mass * radius**2


def disc_face_width(mass: float, radius: float, density: float = STEEL_DENSITY) -> float:
    """Width in m of the solid disc of that mass (kg), radius (m) and density (kg/m³)."""
    return mass / (density * pi * radius**2)


def equivalent_mass(radii: tuple[float, float], inertias: tuple[float, float]) -> float:
    """m_e in kg of u = R_p θ_p - R_g θ_g: 1/m_e = R_p²/J_p + R_g²/J_g (radii in m, inertias in kg·m²)."""
    return 1.0 / sum(radius**2 / inertia for radius, inertia in zip(radii, inertias, strict=True))
