"""Mass and rotary inertia of gear bodies: rim, web and hub with a bore, as rings.

The toothed rim counts as a full ring up to the mean tooth diameter d_m = (d_a + d_f)/2, as in ISO 6336-1.
Lengths in m, masses in kg.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

from gearlash.system import GearlashError

from .cylindrical_gear import CylindricalGear


@dataclass(frozen=True)
class Ring:
    """A ring of rectangular section about the axis of the shaft.

    Parameters
    ----------
    inner_diameter, outer_diameter : float
        m; the inner one at least 0, at most the outer one.
    width : float
        m; at least 0.

    Examples
    --------
    >>> from gearlash.gears.gear_body import Ring
    >>> ring = Ring(0.06, 0.1, 0.02)
    >>> round(ring.mass(7830.0), 4), round(ring.inertia(7830.0) * 1e3, 4)
    (0.7872, 1.3382)
    """

    inner_diameter: float
    outer_diameter: float
    width: float

    def __post_init__(self) -> None:
        """A ring turned inside out is refused."""
        if not 0.0 <= self.inner_diameter <= self.outer_diameter or not self.width >= 0.0:
            raise GearlashError(
                f"a ring from {self.inner_diameter * 1e3:.4g} to {self.outer_diameter * 1e3:.4g} mm, "
                f"{self.width * 1e3:.4g} mm wide: its inner diameter is the smaller one, no length is below 0"
            )

    def mass(self, density: float) -> float:
        """Mass for a density in kg/m³, kg."""
        area = 0.25 * pi * (self.outer_diameter**2 - self.inner_diameter**2)
        return density * area * self.width

    def inertia(self, density: float) -> float:
        """Moment of inertia about the axis, m (r_i² + r_o²)/2, kg·m²."""
        return self.mass(density) * 0.125 * (self.inner_diameter**2 + self.outer_diameter**2)


@dataclass(frozen=True)
class GearBody:
    """Body of a gear, from outside to inside: rim with teeth, web, hub, bore.

    Parameters
    ----------
    outer_diameter : float
        Of the full ring that the teeth count as, m: `mean_tooth_diameter`.
    face_width : float
        b, m.
    bore : float
        m; 0 for a gear in one piece with a shaft of the length of its face.
    rim_inner_diameter : float, optional
        m; where nothing is given the body is solid down to the bore.
    web_width : float, optional
        b_s, m; the face width where nothing is given.
    hub_diameter, hub_width : float, optional
        m; no hub where nothing is given.

    Examples
    --------
    >>> from gearlash.gears.gear_body import GearBody
    >>> solid = GearBody(0.28, 0.06, bore=0.05)
    >>> webbed = GearBody(0.28, 0.06, 0.05, rim_inner_diameter=0.25, web_width=0.015, hub_diameter=0.08)
    >>> round(solid.mass(7830.0), 2), round(webbed.mass(7830.0), 2)
    (28.01, 12.48)
    """

    outer_diameter: float
    face_width: float
    bore: float = 0.0
    rim_inner_diameter: float | None = None
    web_width: float | None = None
    hub_diameter: float | None = None
    hub_width: float | None = None

    @property
    def rings(self) -> tuple[Ring, ...]:
        """Rim, web and hub; of a solid body one ring."""
        if self.rim_inner_diameter is None:
            return (Ring(self.bore, self.outer_diameter, self.face_width),)
        hub = self.bore if self.hub_diameter is None else self.hub_diameter
        web = self.face_width if self.web_width is None else self.web_width
        hub_width = self.face_width if self.hub_width is None else self.hub_width
        return (
            Ring(self.rim_inner_diameter, self.outer_diameter, self.face_width),
            Ring(hub, self.rim_inner_diameter, web),
            Ring(self.bore, hub, hub_width),
        )

    def mass(self, density: float) -> float:
        """Mass for a density in kg/m³, kg."""
        return sum(ring.mass(density) for ring in self.rings)

    def inertia(self, density: float) -> float:
        """Moment of inertia about the axis, kg·m²."""
        return sum(ring.inertia(density) for ring in self.rings)


def mean_tooth_diameter(gear: CylindricalGear) -> float:
    """Outer diameter of the full ring that the teeth count as.

    Parameters
    ----------
    gear : CylindricalGear

    Returns
    -------
    float
        d_m = (d_a + d_f)/2, m.

    References
    ----------
    ISO 6336-1:2019, reduced gear pair mass per unit face width.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear
    >>> from gearlash.gears.gear_body import mean_tooth_diameter
    >>> mean_tooth_diameter(CylindricalGear(40, 2e-3))
    0.0795
    """
    return 0.5 * (gear.tip_diameter + gear.root_diameter)
