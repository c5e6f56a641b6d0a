"""Gear pairs assembled a second time, from the equations of motion alone, and random members of them.

The helical pair is written in the coordinates of its bodies (Y_p, Z_p, Y_g, Z_g, U) with their masses, then
in those of the gap by a linear change of coordinates. `gearlash.gears` writes that form directly.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from gearlash.system import Clearance, System


def series(mean: float, amplitudes, phases) -> np.ndarray:
    """Fourier array of mean + Σ a_n cos(nθ + φ_n)."""
    out = np.zeros(2 * len(amplitudes) + 1)
    out[0] = mean
    out[1::2] = np.multiply(amplitudes, np.cos(phases))
    out[2::2] = -np.multiply(amplitudes, np.sin(phases))
    return out


@dataclass(frozen=True)
class Mesh:
    """What the two kinds of pair share: speed, gap, load, stiffness, error. Lengths over D_c, times ω_n."""

    omega: float = 0.78
    gap_plus: float = 1.0
    gap_minus: float = 1.0
    load: float = 0.09
    damping: float = 0.14
    ripple: tuple[float, ...] = (0.299,)
    ripple_phase: tuple[float, ...] = (0.0,)
    back_stiffness: float = 1.0
    error: tuple[float, ...] = (0.27018,)
    error_phase: tuple[float, ...] = (0.0,)

    @property
    def stiffness_plus(self) -> np.ndarray:
        return series(1.0, self.ripple, self.ripple_phase)

    @property
    def stiffness_minus(self) -> np.ndarray:
        return self.back_stiffness * self.stiffness_plus

    @property
    def error_series(self) -> np.ndarray:
        return series(0.0, self.error, self.error_phase)

    @property
    def load_series(self) -> np.ndarray:
        """f_m − E″ as a Fourier array."""
        order = np.arange(1, len(self.error) + 1)
        return series(self.load, (order * self.omega) ** 2 * np.array(self.error), self.error_phase)

    def clearance(self, h, g, offset=None) -> Clearance:
        return Clearance(
            h=np.array(h, dtype=float),
            g=np.array(g, dtype=float),
            gap_plus=self.gap_plus,
            gap_minus=self.gap_minus,
            stiffness_plus=self.stiffness_plus,
            stiffness_minus=self.stiffness_minus,
            damping=self.damping,
            offset=np.zeros(1) if offset is None else offset,
        )


@dataclass(frozen=True)
class Bodies:
    """Masses over m_e (pinion, gear), κ and ξ of the bearings (Y_p, Z_p, Y_g, Z_g), and the projections."""

    mass: tuple[float, float] = (5.98 / 2.5507, 34.72 / 2.5507)
    kappa: tuple[float, float, float, float] = (1.03262, 0.95203, 0.30303, 0.27104)
    xi: tuple[float, float, float, float] = (0.025, 0.025, 0.025, 0.025)
    c_t: float = np.cos(np.radians(20)) * np.cos(np.radians(18))
    c_y: float = np.cos(np.radians(20)) * np.cos(np.radians(18))
    c_z: float = np.cos(np.radians(20)) * np.sin(np.radians(18))

    @property
    def masses(self) -> np.ndarray:
        """Of (Y_p, Z_p, Y_g, Z_g, U), over m_e."""
        return np.array([self.mass[0], self.mass[0], self.mass[1], self.mass[1], 1.0])

    @property
    def projection(self) -> np.ndarray:
        """X = projection · (Y_p, Z_p, Y_g, Z_g, U) − E."""
        return np.array([self.c_y, self.c_z, -self.c_y, -self.c_z, self.c_t])


def spur(mesh: Mesh) -> System:
    """X″ = f_m − E″ − Φ, state (X, X′)."""
    forcing = np.zeros((2, 2 * len(mesh.error) + 1))
    forcing[1] = mesh.load_series
    return System(mesh.omega, np.array([[0.0, 1.0], [0.0, 0.0]]), forcing, (mesh.clearance([1, 0], [0, -1]),))


def helical_bodies(mesh: Mesh, bodies: Bodies) -> System:
    """The pair in (Y_p, Y_p′, Z_p, Z_p′, Y_g, Y_g′, Z_g, Z_g′, U, U′); the error is an offset of the gap."""
    mass, projection = bodies.masses, bodies.projection
    matrix, h, g = np.zeros((10, 10)), np.zeros(10), np.zeros(10)
    for i in range(5):
        matrix[2 * i, 2 * i + 1] = 1.0
        h[2 * i], g[2 * i + 1] = projection[i], -projection[i] / mass[i]
        if i < 4:
            matrix[2 * i + 1, 2 * i] = -(bodies.kappa[i] ** 2)
            matrix[2 * i + 1, 2 * i + 1] = -2 * bodies.xi[i] * bodies.kappa[i]
    forcing = np.zeros((10, 1))
    forcing[9, 0] = mesh.load / bodies.c_t
    return System(mesh.omega, matrix, forcing, (mesh.clearance(h, g, offset=mesh.error_series),))


def gap_coordinates(bodies: Bodies) -> np.ndarray:
    """T with (…, X + E, (X + E)′) = T (…, U, U′)."""
    transform = np.eye(10)
    transform[8, 0::2] = bodies.projection
    transform[9, 1::2] = bodies.projection
    return transform


def helical(mesh: Mesh, bodies: Bodies) -> System:
    """The pair in (Y_p, Y_p′, Z_p, Z_p′, Y_g, Y_g′, Z_g, Z_g′, X, X′), as the article has it."""
    free = helical_bodies(mesh, bodies)
    transform = gap_coordinates(bodies)
    matrix = transform @ free.matrix @ np.linalg.inv(transform)
    g = transform @ free.clearances[0].g
    forcing = np.zeros((10, 2 * len(mesh.error) + 1))
    forcing[9] = mesh.load_series
    h = np.eye(10)[8]
    matrix[:8, 8:] = 0.0  # exact zeros that the inverse leaves as rounding
    matrix[9, 8:] = 0.0
    matrix[8] = np.eye(10)[9]
    return System(mesh.omega, matrix, forcing, (mesh.clearance(h, g),))


def random_mesh(rng: np.random.Generator, kind: str) -> Mesh:
    """A random mesh of one of the `KINDS`."""
    harmonics = 3 if kind == "slow" else int(rng.integers(1, 4))
    error = rng.uniform(0.0, 0.5, harmonics) / np.arange(1, harmonics + 1) ** 2
    ripple = rng.uniform(0.0, 0.3, harmonics) / np.arange(1, harmonics + 1)
    gap = 10 ** rng.uniform(-1.0, 0.3)
    mesh = Mesh(
        omega=float(rng.uniform(0.3, 1.8)),
        gap_plus=gap,
        gap_minus=gap,
        load=float(rng.uniform(0.01, 0.3)),
        damping=2 * float(rng.uniform(0.005, 0.1)),
        ripple=tuple(ripple),
        ripple_phase=tuple(rng.uniform(0, 2 * np.pi, harmonics)),
        error=tuple(error),
        error_phase=tuple(rng.uniform(0, 2 * np.pi, harmonics)),
    )
    changes = {
        "plain": {},
        "negative-load": {"load": -mesh.load},
        "unequal": {
            "gap_minus": gap * float(rng.uniform(0.1, 3.0)),
            "back_stiffness": float(rng.uniform(0.2, 3.0)),
        },
        "one-sided": {"back_stiffness": 0.0, "load": mesh.load + 0.1},
        "tiny-gap": {"gap_plus": 1e-4, "gap_minus": float(rng.choice([0.0, 1e-4, 3e-3]))},
        "large-ripple": {
            "ripple": (0.9, 0.25),
            "ripple_phase": (float(rng.uniform(0, 6)), float(rng.uniform(0, 6))),
        },
        "slow": {"omega": float(rng.uniform(0.02, 0.1))},
        "overdamped": {"damping": float(rng.uniform(2.2, 4.0))},
    }
    return replace(mesh, **changes[kind])


KINDS = ("plain", "negative-load", "unequal", "one-sided", "tiny-gap", "large-ripple", "slow", "overdamped")


def random_bodies(rng: np.random.Generator) -> Bodies:
    """Random masses, bearings and angles around those of real pairs."""
    pressure, helix = np.radians(rng.uniform(14.5, 25)), np.radians(rng.uniform(5, 35))
    across = np.cos(pressure) * np.cos(helix)
    return Bodies(
        mass=(float(rng.uniform(0.5, 5)), float(rng.uniform(2, 20))),
        kappa=tuple(rng.uniform(0.2, 1.5, 4)),
        xi=tuple(rng.uniform(0.005, 0.1, 4)),
        c_t=across,
        c_y=across,
        c_z=np.cos(pressure) * np.sin(helix),
    )


def random_system(rng: np.random.Generator, pair: str, kind: str) -> tuple[System, np.ndarray]:
    """A random member of ``pair`` ("helical" or "spur") and a random state."""
    mesh = random_mesh(rng, kind)
    system = spur(mesh) if pair == "spur" else helical(mesh, random_bodies(rng))
    return system, random_state(rng, system)


def random_state(rng: np.random.Generator, system: System) -> np.ndarray:
    """Velocities and deflections around 0.3, X in any of the three regions."""
    clearance = system.clearances[0]
    reach = 0.5 + 0.2 * (clearance.gap_plus + clearance.gap_minus)
    state = rng.normal(0.0, 0.3, system.size)
    state[-2] = rng.uniform(-clearance.gap_minus - reach, clearance.gap_plus + reach)
    return state
