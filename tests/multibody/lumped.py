"""The article's pair for both models: bodies in space with contact along one line, and the lumped family."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

import gearlash as gl
from gearlash.multibody import Bearings, LineContact, Machine, RigidBody
from gearlash.system import ContactRule

Array = NDArray[np.float64]
MASSES, WIDTHS = (5.98, 34.72), (0.07, 0.065)
STIFFNESS = ((8.0e8, 8.0e8, 6.8e8, 1e7, 1e7), (4.0e8, 4.0e8, 3.2e8, 1e7, 1e7))
C_Y, C_Z = 0.893701, 0.290380  # cos α_n cos β, cos α_n sin β of 20° and 18°
HELD = (1, 2, 5, 7, 8, 11)
"""Coordinates that the lumped model has: y, z and rotation of both bodies."""


@dataclass(frozen=True)
class Both:
    """One pair in both models, and how states go from one to the other."""

    machine: Machine
    contact: LineContact
    system: gl.System
    scales: gl.Scales
    omega: float

    @property
    def period(self) -> float:
        """Of a mesh cycle, s."""
        return 2.0 * np.pi / self.contact.rate

    @property
    def units(self) -> tuple[float, float]:
        """Of lengths, m, and of rates, m/s."""
        return float(self.scales.velocity(1.0)) / float(
            self.scales.acceleration(1.0) / self.scales.velocity(1.0)
        ), float(self.scales.velocity(1.0))

    def lumped_state(self, q: Array, v: Array, t: float) -> Array:
        """The ten states of the lumped model."""
        length, speed = self.units
        error, rate = self.contact._at(self.contact.error, t)
        line = self.contact.direction
        state = np.empty(10)
        state[0:8:2], state[1:8:2] = q[[1, 2, 7, 8]] / length, v[[1, 2, 7, 8]] / speed
        state[8], state[9] = (line @ q - error) / length, (line @ v - rate) / speed
        return state

    def start(self, state: Array) -> tuple[Array, Array]:
        """Coordinates and rates at t = 0 of a state of the lumped model, all rotation in the pinion."""
        length, speed = self.units
        error, rate = self.contact._at(self.contact.error, 0.0)
        q, v = np.zeros(12), np.zeros(12)
        q[[1, 2, 7, 8]], v[[1, 2, 7, 8]] = state[0:8:2] * length, state[1:8:2] * speed
        line = self.contact.direction
        q[5] = (state[8] * length + error - line @ q) / line[5]
        v[5] = (state[9] * speed + rate - line @ v) / line[5]
        return q, v


def both(omega: float, contact: ContactRule = ContactRule.ALWAYS) -> Both:
    """The article's pair at a mesh frequency."""
    case = gl.load_case("article", {"omega": omega, "contact": str(contact)})
    family, scales = case.family()
    values = family.complete()
    assert scales.radii is not None
    assert scales.length is not None
    assert scales.omega_n is not None
    k, length = 3.2e8, scales.length
    bodies = tuple(
        RigidBody.solid_disc(m, r, b) for m, r, b in zip(MASSES, scales.radii, WIDTHS, strict=True)
    )
    bearings = tuple(
        Bearings.from_ratio(k, body, values["bearing_damping"])
        for k, body in zip(STIFFNESS, bodies, strict=True)
    )
    torque = float(scales.torque(values["load"]))
    machine = Machine((bodies[0], bodies[1]), (bearings[0], bearings[1]), (28, 70), torque)
    c_y, c_z, c_t = family_factors(case)
    line = np.zeros(12)
    line[[1, 2, 7, 8]] = c_y, c_z, -c_y, -c_z
    line[[5, 11]] = c_t * scales.radii[0], c_t * scales.radii[1]
    mass = 1.0 / (sum(r**2 / b.axial_inertia for r, b in zip(scales.radii, bodies, strict=True)))
    error, phase = values["error"] * length, values["error_phase"]
    line_contact = LineContact(
        line,
        stiffness=(k, 0.0, 0.0, k * values["ripple_2"], 0.0),
        error=(0.0, error * np.cos(phase), -error * np.sin(phase)),
        gap=length * values["D"],
        damping=2.0 * values["mesh_damping"] * float(np.sqrt(k * mass)),
        rate=omega * scales.omega_n,
        contact=contact,
    )
    return Both(machine, line_contact, family.system(), scales, omega)


def family_factors(case: gl.Case) -> tuple[float, float, float]:
    """c_y, c_z and c_t that the lumped model uses, read from its matrices."""
    clearance = case.family()[0].system().clearances[0]
    matrix = case.family()[0].system().matrix
    # X″ holds c_y Y_p″: row 9 over row 1 in the column of Y_p.
    c_y, c_z = matrix[9, 0] / matrix[1, 0], matrix[9, 2] / matrix[3, 2]
    gains = clearance.g
    c_t = np.sqrt(-(gains[9] - c_y * gains[1] - c_z * gains[3] + c_y * gains[5] + c_z * gains[7]))
    return float(c_y), float(c_z), float(c_t)
