"""A flexible gear body in few coordinates: Craig and Bampton's, with its hub or the seats of bearings rigid.

The coordinates are those of the interface and the lowest modes of the body with it held. From them come the
modes of the free body: without strain energy between them, and without inertia between them and the motion of
the body as a whole, which then is that of a rigid body. The teeth count as a full ring. Lengths in m, masses
in kg; modal masses are 1 kg.

R. R. Craig, M. C. C. Bampton, Coupling of substructures for dynamic analyses, AIAA J. 6 (1968) 1313-1319,
https://doi.org/10.2514/3.4741
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh

from gearlash.gears import CylindricalGear
from gearlash.gears.gear_body import GearBody
from gearlash.gears.materials import Material, named
from gearlash.system import GearlashError

from .interface import Interface, craig_bampton, hub_interface, seat_interface
from .revolution import Meridian, meridian, wave_model

Reals = NDArray[np.float64]
Integers = NDArray[np.int64]


@dataclass(frozen=True)
class FlexibleBody:
    """The modes of a free gear body.

    Parameters
    ----------
    mass : float
        kg.
    axial_inertia, transverse_inertia : float
        About the axis and across it, kg·m².
    waves : ndarray of int, shape (M,)
        n, waves around the circumference.
    quarter : ndarray of bool, shape (M,)
        Whether the mode is the one turned by a quarter of a wave: u_r = U sin nφ, u_φ = −V cos nφ,
        u_z = W sin nφ; otherwise U cos nφ, V sin nφ, W cos nφ.
    frequency : ndarray, shape (M,)
        Rad/s, rising.
    hub : ndarray, shape (M, 6)
        Motion of the hub in each mode: along x, y, z (m) and about them (rad).
    heights : ndarray, shape (S,)
        z on the rim, rising, m.
    rim : ndarray, shape (M, S, 3)
        U, V, W on the outer face.
    """

    mass: float
    axial_inertia: float
    transverse_inertia: float
    waves: Integers
    quarter: NDArray[np.bool_]
    frequency: Reals
    hub: Reals
    heights: Reals
    rim: Reals

    def first(self, count: int) -> FlexibleBody:
        """The body with its lowest modes only.

        Parameters
        ----------
        count : int
            How many, at least; a mode and its twin stay together.

        Returns
        -------
        FlexibleBody
        """
        kept = self.frequency <= (self.frequency[count - 1] * (1.0 + 1e-9) if count else 0.0)
        return FlexibleBody(
            self.mass,
            self.axial_inertia,
            self.transverse_inertia,
            self.waves[kept],
            self.quarter[kept],
            self.frequency[kept],
            self.hub[kept],
            self.heights,
            self.rim[kept],
        )

    def at_flanks(self, gear: CylindricalGear, pressure_angle: float, heights: Reals) -> Reals:
        """How the modes move the flanks: displacement out of the tooth, normal to the flank.

        Parameters
        ----------
        gear : CylindricalGear
            With its own hand.
        pressure_angle : float
            α_t where the teeth touch, rad: the working one.
        heights : ndarray, shape (S,)
            z of places on the flanks of side 0, which face larger angles; those of side 1 are at −z.

        Returns
        -------
        ndarray, shape (2, M, S, 2)
            a and b of a cos nφ + b sin nφ, with φ the angle of the place on the body.
        """
        across, along = cos(gear.base_helix_angle), sin(gear.base_helix_angle) * np.sign(gear.helix_angle)
        shapes = np.empty((2, len(self.waves), len(heights), 2))
        for side, sign in ((0, 1.0), (1, -1.0)):
            moved = self._on_rim(sign * heights)
            outward = across * sin(pressure_angle) * moved[..., 0] - sign * along * moved[..., 2]
            around = sign * across * cos(pressure_angle) * moved[..., 1]
            turned = self.quarter[:, None]
            shapes[side, :, :, 0] = np.where(turned, -around, outward)
            shapes[side, :, :, 1] = np.where(turned, outward, around)
        return shapes

    def _on_rim(self, heights: Reals) -> Reals:
        """U, V, W at other heights, shape (M, S, 3)."""
        moved = np.empty((len(self.waves), len(heights), 3))
        for mode in range(len(self.waves)):
            for k in range(3):
                moved[mode, :, k] = np.interp(heights, self.heights, self.rim[mode, :, k])
        return moved


def flexible_body(
    body: GearBody,
    material: Material | None = None,
    hub_radius: float | None = None,
    greatest_waves: int = 4,
    interface_modes: int = 8,
    size: float | None = None,
) -> FlexibleBody:
    """Modes of a free gear body.

    Parameters
    ----------
    body : GearBody
        The teeth count as a full ring.
    material : Material, optional
        Steel where nothing is given.
    hub_radius : float, optional
        Up to which radius the body is the rigid hub, m; where nothing is given that of the bore. 0 for a disc
        without one: then its axis stays straight, and no more.
    greatest_waves : int
        Modes of 0 to so many waves around.
    interface_modes : int
        With the hub held, of each number of waves; at least 1.
    size : float, optional
        Of an element, m; an eighth of the outer radius or of the face width, whichever is less, where nothing
        is given.

    Returns
    -------
    FlexibleBody
        With modes of all frequencies that came out, of which the upper half is not converged.

    Raises
    ------
    GearlashError
        For a hub that is the whole body, or a section that no elements fit into.
    MissingExtraError
        Without the extra `multibody`.

    References
    ----------
    R. R. Craig, M. C. C. Bampton, AIAA J. 6 (1968) 1313-1319, https://doi.org/10.2514/3.4741

    Examples
    --------
    >>> from math import pi
    >>> from gearlash.gears.gear_body import GearBody
    >>> from gearlash.multibody.reduced import flexible_body
    >>> disc = flexible_body(GearBody(0.2944, 0.065), greatest_waves=2)
    >>> int(disc.waves[0]), round(float(disc.frequency[0] / (2 * pi)), -2)  # Hz
    (2, 3400.0)
    """
    steel = named("steel") if material is None else material
    hub = 0.5 * body.bore if hub_radius is None else hub_radius
    outer = 0.5 * body.outer_diameter
    if not hub < outer:
        raise GearlashError(f"a hub of {hub * 1e3:.4g} mm radius is the whole body")
    section = meridian(body, min(outer, body.face_width) / 8.0 if size is None else size)
    return _body_of(body, section, steel, hub_interface(hub), greatest_waves, interface_modes)


def flexible_shaft(
    diameter: float,
    face_width: float,
    shaft_diameter: float,
    shaft_length: float,
    material: Material | None = None,
    greatest_waves: int = 4,
    interface_modes: int = 8,
    size: float | None = None,
) -> FlexibleBody:
    """Modes of a gear in one piece with its shaft, which bearings hold at its two ends.

    Craig and Bampton's interface is the two end faces of the shaft, each rigid: there the seats of the
    bearings are.

    Parameters
    ----------
    diameter, face_width : float
        Of the toothed part, which counts as a full cylinder, m.
    shaft_diameter, shaft_length : float
        m; the shaft is thinner than the toothed part, and at least as long.
    material : Material, optional
        Steel where nothing is given.
    greatest_waves, interface_modes : int
        As of `flexible_body`.
    size : float, optional
        Of an element, m; a quarter of the shaft's diameter where nothing is given.

    Returns
    -------
    FlexibleBody
        ``hub`` is the motion of both seats together: the mean of their displacements, and the tilt of the
        line through them. Two equal bearings feel no more of a mode.

    Raises
    ------
    GearlashError
        For a shaft as thick as the toothed part, or shorter.
    MissingExtraError
        Without the extra `multibody`.

    Examples
    --------
    >>> from math import pi
    >>> from gearlash.multibody.reduced import flexible_shaft
    >>> pinion = flexible_shaft(0.118, 0.07, 0.06, 0.15, greatest_waves=1, interface_modes=4)
    >>> int(pinion.waves[0]), round(float(pinion.frequency[0] / (2 * pi)), -3)  # Hz
    (1, 10000.0)
    """
    if not 0.0 < shaft_diameter < diameter or not shaft_length >= face_width:
        raise GearlashError(
            f"a shaft of {shaft_diameter * 1e3:.4g} mm, {shaft_length * 1e3:.4g} mm long, for a gear of "
            f"{diameter * 1e3:.4g} mm, {face_width * 1e3:.4g} mm wide: it is thinner and no shorter"
        )
    steel = named("steel") if material is None else material
    body = GearBody(
        diameter,
        face_width,
        rim_inner_diameter=shaft_diameter,
        hub_diameter=shaft_diameter,
        hub_width=shaft_length,
    )
    section = meridian(body, 0.25 * shaft_diameter if size is None else size)
    ends = seat_interface(0.5 * shaft_diameter, shaft_length)
    return _body_of(body, section, steel, ends, greatest_waves, interface_modes)


def _body_of(
    body: GearBody,
    section: Meridian,
    steel: Material,
    interface: Interface,
    greatest_waves: int,
    interface_modes: int,
) -> FlexibleBody:
    """Modes of all numbers of waves, by frequency."""
    found = [
        _free_modes(section, steel, interface, waves, interface_modes) for waves in range(greatest_waves + 1)
    ]
    modes = sorted((mode for several in found for mode in several), key=lambda mode: mode.frequency)
    return FlexibleBody(
        body.mass(steel.density),
        body.inertia(steel.density),
        _transverse_inertia(body, steel.density),
        np.array([mode.waves for mode in modes], dtype=np.int64),
        np.array([mode.quarter for mode in modes], dtype=bool),
        np.array([mode.frequency for mode in modes]),
        np.array([mode.hub for mode in modes]).reshape(-1, 6),
        *_rim(modes, section),
    )


def _sign(moved: Reals) -> float:
    """So that the greatest displacement is above 0."""
    return 1.0 if moved[np.argmax(np.abs(moved))] > 0.0 else -1.0


@dataclass(frozen=True)
class _Mode:
    waves: int
    quarter: bool
    frequency: float
    hub: Reals
    rim: Reals


def _free_modes(
    section: Meridian, material: Material, interface: Interface, waves: int, interface_modes: int
) -> list[_Mode]:
    """Modes of the free body in n waves, from the motion of its interface and its modes with that held."""
    model = wave_model(section, material, waves)
    basis, hub_of = craig_bampton(model, interface, interface_modes)
    rigid = model.rigid.shape[1]
    stiffness, mass = basis.T @ (model.stiffness @ basis), basis.T @ (model.mass @ basis)
    squares, shares = eigh(stiffness, mass)
    outer = model.nodes[:, 0].max()
    rim = np.flatnonzero(model.nodes[:, 0] > outer * (1.0 - 1e-9))
    rim = rim[np.argsort(model.nodes[rim, 1])]
    modes = []
    for square, shares_of_mode in zip(squares[rigid:], shares.T[rigid:], strict=True):
        share = shares_of_mode * _sign(basis @ shares_of_mode)
        moved = (basis @ share).reshape(-1, 3)[rim]
        for quarter in _twins(waves, moved):
            hub = _hub_motion(waves, quarter, hub_of @ share[: hub_of.shape[1]])
            modes.append(_Mode(waves, quarter, float(np.sqrt(square)), hub, moved))
    return modes


def _twins(waves: int, moved: Reals) -> tuple[bool, ...]:
    """A mode with waves has a twin; one without either turns (V) or moves outward and along (U, W)."""
    if waves:
        return False, True
    return (bool(np.abs(moved[:, 1]).max() > np.abs(moved[:, [0, 2]]).max()),)


def _hub_motion(waves: int, quarter: bool, rigid: Reals) -> Reals:
    """x, y, z and rotations of the hub, from the amounts of the rigid motions."""
    hub = np.zeros(6)
    if waves == 0:
        hub[2], hub[5] = (0.0, -rigid[1]) if quarter else (rigid[0], 0.0)
    elif waves == 1 and quarter:
        hub[1], hub[3] = rigid[0], -rigid[1]
    elif waves == 1:
        hub[0], hub[4] = rigid
    return hub


def _rim(modes: list[_Mode], section: Meridian) -> tuple[Reals, Reals]:
    """Heights of the nodes on the rim, and U, V, W there."""
    outer = section.points[:, 0].max()
    corners = np.sort(section.points[section.points[:, 0] > outer * (1.0 - 1e-9), 1])
    heights = np.sort(np.append(corners, 0.5 * (corners[1:] + corners[:-1])))
    return heights, np.array([mode.rim for mode in modes])


def _transverse_inertia(body: GearBody, density: float) -> float:
    """About an axis across the middle of the body, kg·m²: of each ring half of the axial one + m b²/12."""
    return sum(0.5 * ring.inertia(density) + ring.mass(density) * ring.width**2 / 12.0 for ring in body.rings)
