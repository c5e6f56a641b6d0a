"""Two gear bodies in bearings: what moves, what carries it, what drives it.

Right-handed frame: z along the axes, x from the axis of the pinion to that of the gear, z = 0 in the middle
of the face. A body has six coordinates: the displacement x, y, z of its centre of mass from where it lies at
rest, and rotations about x, y, z in the order A = R_x R_y R_z: two small tilts about axes that stand still
and, innermost, the rotation of the shaft, which has no bound. Lengths in m, masses in kg, angles in rad.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import cos

import numpy as np
from numpy.typing import NDArray

from gearlash.system import GearlashError

Array = NDArray[np.float64]
SPIN = 5
"""Place of the rotation of the shaft among the six coordinates of a body."""
COORDINATES = ("x", "y", "z", "tilt_x", "tilt_y", "rotation")


@dataclass(frozen=True)
class RigidBody:
    """A gear body as mass and inertia about its centre of mass, equal about all axes across the shaft.

    Parameters
    ----------
    mass : float
        kg, above 0.
    axial_inertia : float
        About the axis of the shaft, kg·m², above 0.
    transverse_inertia : float
        About any axis across it, kg·m², above 0.

    Raises
    ------
    GearlashError
        For a number that is not above 0.

    Examples
    --------
    >>> from gearlash.multibody import RigidBody
    >>> RigidBody(6.0, 0.0104, 0.0076).mass
    6.0
    """

    mass: float
    axial_inertia: float
    transverse_inertia: float

    def __post_init__(self) -> None:
        """A body without inertia is refused."""
        for name in ("mass", "axial_inertia", "transverse_inertia"):
            if not getattr(self, name) > 0.0:
                raise GearlashError(f"{name} = {getattr(self, name):g}: a body needs one above 0")

    @classmethod
    def solid_disc(cls, mass: float, radius: float, width: float) -> RigidBody:
        """A solid disc: J_z = m r²/2, J_x = m (3 r² + b²)/12.

        Parameters
        ----------
        mass : float
            kg.
        radius, width : float
            m.

        Returns
        -------
        RigidBody

        Examples
        --------
        >>> from gearlash.multibody import RigidBody
        >>> RigidBody.solid_disc(6.0, 0.06, 0.07).axial_inertia
        0.0108
        """
        across = mass * (3.0 * radius**2 + width**2) / 12.0
        return cls(mass, 0.5 * mass * radius**2, across)

    def kinetic_energy(self, q: Array, v: Array) -> float:
        """Kinetic energy of the body.

        Parameters
        ----------
        q, v : ndarray, shape (6,)
            Coordinates and their rates.

        Returns
        -------
        float
            J.

        Examples
        --------
        >>> import numpy as np
        >>> from gearlash.multibody import RigidBody
        >>> RigidBody(2.0, 1.0, 1.0).kinetic_energy(np.zeros(6), np.array([1.0, 0, 0, 0, 0, 2.0]))
        3.0
        """
        moved = self.mass * float(v[:3] @ v[:3])
        across = (cos(q[4]) * v[3]) ** 2 + v[4] ** 2
        about = (v[5] + np.sin(q[4]) * v[3]) ** 2
        return 0.5 * float(moved + self.transverse_inertia * across + self.axial_inertia * about)


@dataclass(frozen=True)
class Bearings:
    """All bearings of one shaft together: springs and dashpots that do not feel how fast it rotates.

    Parameters
    ----------
    stiffness : tuple of 5 float
        Along x, y, z in N/m, about x and y in N·m/rad.
    damping : tuple of 5 float
        Likewise, N·s/m and N·m·s/rad.

    Examples
    --------
    >>> from gearlash.multibody import Bearings, RigidBody
    >>> disc = RigidBody.solid_disc(6.0, 0.06, 0.07)
    >>> bearings = Bearings.from_ratio((8e8, 8e8, 6.8e8, 1e6, 1e6), disc, 0.04)
    >>> round(bearings.damping[0])  # 2 ξ √(k m)
    5543
    """

    stiffness: tuple[float, float, float, float, float]
    damping: tuple[float, float, float, float, float]

    @classmethod
    def from_ratio(
        cls, stiffness: tuple[float, float, float, float, float], body: RigidBody, ratio: float
    ) -> Bearings:
        """Dashpots of one damping ratio: c = 2 ξ √(k m) along an axis, 2 ξ √(k J) about one.

        Parameters
        ----------
        stiffness : tuple of 5 float
            As that of the bearings.
        body : RigidBody
            What they carry.
        ratio : float
            ξ, at least 0: of each direction alone, with all else held.

        Returns
        -------
        Bearings

        Examples
        --------
        >>> from gearlash.multibody import Bearings, RigidBody
        >>> Bearings.from_ratio((4.0, 4.0, 4.0, 1.0, 1.0), RigidBody(1.0, 1.0, 1.0), 0.5).damping
        (2.0, 2.0, 2.0, 1.0, 1.0)
        """
        inertias = (body.mass, body.mass, body.mass, body.transverse_inertia, body.transverse_inertia)
        x, y, z, tilt_x, tilt_y = (
            2.0 * ratio * float(np.sqrt(k * m)) for k, m in zip(stiffness, inertias, strict=True)
        )
        return cls(stiffness, (x, y, z, tilt_x, tilt_y))


@dataclass(frozen=True)
class Modes:
    """Elastic modes of the bodies beside their motion as a whole, orthogonal to it and of modal mass 1 kg.

    Parameters
    ----------
    frequencies : tuple of float
        Undamped, rad/s, above 0.
    damping_ratio : float
        Of each of them.
    hub : tuple of 6 float, one for each mode, optional
        Motion of the hub in the mode, which the bearings feel: along x, y, z and about them. At rest where
        nothing is given. The body rotates and its bearings do not: in a mode that rotates with the body only
        what is the same all around (along z and about it) is other than 0; a mode of one wave has more where
        its coordinate is that along directions that stand still, as both modes of such a pair then have.
    bodies : tuple of int, one for each mode, optional
        0 for the pinion, 1 for the gear; the gear where nothing is given.

    Examples
    --------
    >>> from gearlash.multibody import Modes
    >>> len(Modes((2.1e4, 2.1e4), 0.01).frequencies)
    2
    """

    frequencies: tuple[float, ...] = ()
    damping_ratio: float = 0.0
    hub: tuple[tuple[float, float, float, float, float, float], ...] = ()
    bodies: tuple[int, ...] = ()

    def and_(self, others: Modes) -> Modes:
        """These modes and others behind them, of the same damping.

        Parameters
        ----------
        others : Modes
            Each of both says the hub and the body of all of its modes.

        Returns
        -------
        Modes

        Examples
        --------
        >>> from gearlash.multibody import Modes
        >>> pinion = Modes((9e4,), 0.01, ((0.0,) * 6,), (0,))
        >>> gear = Modes((2e4,), 0.01, ((0.0,) * 6,), (1,))
        >>> gear.and_(pinion).bodies
        (1, 0)
        """
        frequencies, hub = self.frequencies + others.frequencies, self.hub + others.hub
        return Modes(frequencies, self.damping_ratio, hub, self.bodies + others.bodies)


@dataclass(frozen=True)
class Machine:
    """Two gears in bearings between a drive and a load.

    The pinion is driven with ``torque`` about +z and rotates that way; the gear carries the load
    torque·z_2/z_1 about +z. A governor holds the mean speed against what damping takes: it acts on the common
    rotation of both shafts alone, and gives their relative rotation, so the mesh, no force.

    Parameters
    ----------
    bodies : (RigidBody, RigidBody)
        Pinion and gear.
    bearings : (Bearings, Bearings)
    teeth : (int, int)
    torque : float
        On the pinion, N·m.
    speed : float
        Of the pinion, rad/s: what the governor holds; 0 leaves shafts that oscillate about rest.
    governor_time : float
        Time constant of the governor, s; infinite without one.
    modes : Modes
        Of both bodies.

    Examples
    --------
    >>> from gearlash.multibody import Bearings, Machine, RigidBody
    >>> disc = RigidBody.solid_disc(6.0, 0.06, 0.07)
    >>> bearings = Bearings.from_ratio((8e8, 8e8, 6.8e8, 1e6, 1e6), disc, 0.04)
    >>> machine = Machine((disc, disc), (bearings, bearings), (28, 28), 100.0)
    >>> machine.size, machine.constant_load()[[5, 11]].tolist()
    (12, [100.0, 100.0])
    """

    bodies: tuple[RigidBody, RigidBody]
    bearings: tuple[Bearings, Bearings]
    teeth: tuple[int, int]
    torque: float
    speed: float = 0.0
    governor_time: float = float("inf")
    modes: Modes = field(default_factory=Modes)

    @property
    def size(self) -> int:
        """Number of coordinates: six of the pinion, six of the gear, the modes."""
        return 12 + len(self.modes.frequencies)

    def stiffness(self) -> Array:
        """Of bearings and modes, shape (size, size)."""
        return self._of_supports("stiffness") + np.diag([0.0] * 12 + [f**2 for f in self.modes.frequencies])

    def damping(self) -> Array:
        """Of bearings and modes, shape (size, size)."""
        ratio = 2.0 * self.modes.damping_ratio
        return self._of_supports("damping") + np.diag(
            [0.0] * 12 + [ratio * f for f in self.modes.frequencies]
        )

    def _of_supports(self, what: str) -> Array:
        """Of the bearings, which feel the hub: it moves with the body, and in its modes."""
        hubs = np.eye(12, self.size)
        for i, moved in enumerate(self.modes.hub):
            first = 6 * (self.modes.bodies[i] if self.modes.bodies else 1)
            hubs[first : first + 6, 12 + i] = moved
        both = [np.append(getattr(bearings, what), 0.0) for bearings in self.bearings]
        return hubs.T @ np.diag(np.concatenate(both)) @ hubs

    def inertia(self) -> Array:
        """Mass matrix at rest without tilt, shape (size, size)."""
        both = [
            (body.mass,) * 3 + (body.transverse_inertia,) * 2 + (body.axial_inertia,) for body in self.bodies
        ]
        return np.diag(np.concatenate([*both, np.ones(len(self.modes.frequencies))]))

    def constant_load(self) -> Array:
        """Drive and load as generalised forces, shape (size,)."""
        forces = np.zeros(self.size)
        forces[SPIN], forces[6 + SPIN] = self.torque, self.torque * self.teeth[1] / self.teeth[0]
        return forces

    def governor(self) -> tuple[Array, float]:
        """Direction of its force, shape (size,), and the mean speed it aims at along that direction.

        Q = −d (d·v − aim) with d = M u/√(τ uᵀM u), u the common rotation: it accelerates along u alone, so no
        relative rotation, and takes a deviation of the mean speed away with the time constant τ.
        """
        common = np.zeros(self.size)
        common[SPIN], common[6 + SPIN] = self.teeth[1], -self.teeth[0]
        weighted = self.inertia() @ common
        direction = weighted / np.sqrt(self.governor_time * float(common @ weighted))
        return direction, float(direction @ common) * self.speed / self.teeth[1]

    def rolling(self) -> Array:
        """Rates of both shafts that roll at `speed`, all else at rest, shape (size,)."""
        rates = np.zeros(self.size)
        rates[SPIN], rates[6 + SPIN] = self.speed, -self.speed * self.teeth[0] / self.teeth[1]
        return rates

    def energy(self, q: Array, v: Array) -> float:
        """Kinetic energy, and that of bearings and modes, J; without the contact."""
        kinetic = sum(
            body.kinetic_energy(q[6 * i : 6 * i + 6], v[6 * i : 6 * i + 6])
            for i, body in enumerate(self.bodies)
        )
        elastic = float(q @ self.stiffness() @ q)
        return float(kinetic) + 0.5 * (elastic + float(v[12:] @ v[12:]))
