"""One operating point of the multibody model: settled, read, and what its solver did said."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import ceil, cos, pi, sin, sqrt

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh

from gearlash.multibody import (
    Bearings,
    Contact,
    Machine,
    Modes,
    Reading,
    RigidBody,
    Trajectory,
    energy_balance,
    read_motion,
    simulate,
)

from .frames import Frames, frames_of
from .inputs import Inputs
from .settings import CLOSES, Setting

Array = NDArray[np.float64]
GOVERNED = 20.0
"""Mesh cycles in which the governor takes a deviation of the mean speed away."""
TURN = 1.5
"""By how much the fastest vibration may turn in a step, rad: Runge-Kutta of order 4 is stable up to 2.8, so
that stiffnesses may be 3.4 times those of the estimate."""
FADED = 4.0
"""Nepers by which the slowest vibration of the supports has faded in a motion that is said not to repeat."""
AXES = {
    "": (),
    "centre distance": (0, 6),
    "tilts": (3, 4, 9, 10),
    "centre-line": (0, 3, 4, 6, 9, 10),
    "lumped": (0, 1, 2, 3, 4, 6, 7, 8, 9, 10),
}
"""Coordinates that are held."""


@dataclass(frozen=True)
class Held:
    """A contact whose forces along some coordinates are taken up by supports that do not give.

    Attributes
    ----------
    contact : Contact
    held : tuple of int
        Coordinates.
    """

    contact: Contact
    held: tuple[int, ...]

    def forces(self, t: float, q: Array, v: Array) -> Array:
        """Generalised forces with none along what is held."""
        found = self.contact.forces(t, q, v)
        found[list(self.held)] = 0.0
        return found

    def record(self, t: float, q: Array, v: Array) -> Array:
        """As of the contact itself."""
        return self.contact.record(t, q, v)


@dataclass(frozen=True)
class PointFound:
    """A point of the multibody model.

    Attributes
    ----------
    omega : float
        Mesh frequency over √(k/m_e) of the multibody mesh.
    rpm : float
        Speed of the pinion that was asked for.
    setting : str
        Name of the setting.
    reading : Reading
    energy_residual : float
        Of the energy balance over the cycles read.
    settle_steps, read_steps : int
        Of the integrator before those and there, a mesh cycle.
    settled : int
        Mesh cycles before those that were read.
    centre_change : (float, float)
        Least and greatest change of the centre distance at mid face over the cycles read, m.
    frames : Frames
        Poses over the last mesh cycle.
    q, v : ndarray
        State at the end: what a neighbour begins from.
    """

    omega: float
    rpm: float
    setting: str
    reading: Reading
    energy_residual: float
    settle_steps: int
    read_steps: int
    settled: int
    centre_change: tuple[float, float]
    frames: Frames
    q: Array
    v: Array


def machine_of(
    inputs: Inputs,
    setting: Setting,
    torque: float,
    speed: float,
    period: float,
    modes: Modes,
    stiffer: float = 1.0,
) -> Machine:
    """Bodies, bearings, drive and load.

    Parameters
    ----------
    inputs : Inputs
    setting : Setting
    torque : float
        On the pinion, N·m.
    speed : float
        Of the pinion, rad/s.
    period : float
        Of a mesh cycle, s.
    modes : Modes
        Of the bodies.
    stiffer : float
        Bearings over those of the case.

    Returns
    -------
    Machine
    """
    bodies, bearings = [], []
    scale = 1.0 if setting.bearings_as_stated else stiffer
    sides = zip(inputs.masses, inputs.axial_inertias, inputs.radii, inputs.body_widths, strict=True)
    for i, (mass, inertia, radius, width) in enumerate(sides):
        across = mass * (3.0 * radius**2 + width**2) / 12.0
        body = RigidBody(mass, inertia, across)
        bodies.append(body)
        lateral = 0.0 if inputs.bearing_y is None else scale * inputs.bearing_y[i]
        axial = 0.0 if inputs.bearing_z is None else scale * inputs.bearing_z[i]
        tilt = 0.25 * setting.tilt * lateral * inputs.bearing_spans[i] ** 2
        stiffness = (setting.bearing_x * lateral, lateral, axial, tilt, tilt)
        bearings.append(_bearings(stiffness, body, setting.bearing_damping, inputs.bearing_damping[i]))
    return Machine(
        (bodies[0], bodies[1]),
        (bearings[0], bearings[1]),
        (inputs.pair.pinion.teeth, inputs.pair.gear.teeth),
        torque,
        speed,
        GOVERNED * period,
        modes,
    )


def _bearings(
    stiffness: tuple[float, float, float, float, float],
    body: RigidBody,
    factor: float,
    ratios: tuple[float, float],
) -> Bearings:
    """Of one ratio ξ along the axis, of another one in all other directions."""
    across, along = (Bearings.from_ratio(stiffness, body, factor * ratio) for ratio in ratios)
    x, y, _, tilt_x, tilt_y = across.damping
    return Bearings(stiffness, (x, y, along.damping[2], tilt_x, tilt_y))


def run_point(
    inputs: Inputs,
    contact: Contact,
    setting: Setting,
    *,
    omega: float,
    stiffness: float,
    torque: float,
    start: tuple[Array, Array] | None = None,
    modes: Modes | None = None,
    stiffer: float = 1.0,
) -> PointFound:
    """Settle at one speed and read the motion.

    Parameters
    ----------
    inputs : Inputs
    contact : Contact
        Of the teeth.
    setting : Setting
    omega : float
        Mesh frequency over √(stiffness/m_e).
    stiffness : float
        Of the multibody mesh, N/m.
    torque : float
        On the pinion, N·m.
    start : (ndarray, ndarray), optional
        State of a neighbour; pressed together on the drive side without one.
    modes : Modes, optional
        Of the bodies that bend.
    stiffer : float
        Bearings over those of the case.

    Returns
    -------
    PointFound
    """
    teeth = inputs.pair.pinion.teeth
    speed = omega * inputs.natural_frequency(stiffness) / teeth
    period = 2.0 * pi / (teeth * speed)
    machine = machine_of(inputs, setting, torque, speed, period, modes or Modes(), stiffer)
    held = AXES["lumped" if inputs.bearing_y is None else setting.held]
    carried = Held(contact, held) if held else contact
    q, v = _start(inputs, machine, stiffness, torque, start)
    setting = _fine_enough(setting, period * fastest(inputs, machine, stiffness))
    step = period / setting.steps
    cycles, found = setting.settle, _settled_and_read(machine, carried, setting, (q, v), step)
    more = _to_fade(machine, setting, period)
    label = read_motion(found[1], teeth).label
    if more and (label is None or label.period > 1):  # what rings is no part of the motion
        cycles += setting.read + 1 + more
        state = found[1].q[-1], found[1].v[-1]
        found = _settled_and_read(machine, carried, replace(setting, settle=more), state, step)
    finer, motion, residual = found
    apart = motion.q[:, 6] - motion.q[:, 0]
    return PointFound(
        omega=omega,
        rpm=speed * 30.0 / pi,
        setting=setting.name,
        reading=read_motion(motion, teeth),
        energy_residual=residual,
        settle_steps=setting.steps,
        read_steps=finer * setting.steps,
        settled=cycles,
        centre_change=(float(apart.min()), float(apart.max())),
        frames=frames_of(motion, machine.teeth),
        q=motion.q[-1],
        v=motion.v[-1],
    )


def fastest(inputs: Inputs, machine: Machine, stiffness: float) -> float:
    """About so fast do bodies vibrate in their bearings, in their modes and on the teeth, rad/s.

    Parameters
    ----------
    inputs : Inputs
    machine : Machine
    stiffness : float
        Of the teeth, N/m.

    Returns
    -------
    float
        Root of the sum of the largest squares of the supports and of rigid bodies on the teeth, each alone.
        No bound: teeth move modes, too, and a stiffness that is a mean is exceeded in a part of the cycle.
        `TURN` leaves room for both.
    """
    supports = float(eigh(machine.stiffness(), machine.inertia(), eigvals_only=True)[-1])
    lean = sin(inputs.pair.pinion.base_helix_angle)
    moved = 0.0
    for body, gear in zip(machine.bodies, inputs.pair.gears, strict=True):
        radius = 0.5 * gear.base_diameter
        across = radius * lean + 0.5 * inputs.pair.face_width
        moved += 1.0 / body.mass + radius**2 / body.axial_inertia + across**2 / body.transverse_inertia
    return sqrt(max(supports, 0.0) + stiffness * moved)


def _fine_enough(setting: Setting, turns: float) -> Setting:
    """With several times the steps, where the fastest vibration, which turns by so many rad in a mesh cycle,
    would make the integration unstable; the cycles that are read have about the steps that they had. Then
    steps are divided, so that half of a step is half of the one beside which it stands."""
    times = max(1, ceil(turns / (TURN * setting.steps)))
    finer = ceil(setting.finer / times)
    return replace(
        setting,
        steps=times * setting.steps * setting.divided,
        divided=1,
        finer=finer,
        finest=max(finer, setting.finest // times),
    )


def _to_fade(machine: Machine, setting: Setting, period: float) -> int:
    """Mesh cycles more than those of the setting in which the slowest vibration of bodies in their bearings
    and modes fades; the teeth, which damp it further, are left out."""
    inverse, size = np.linalg.inv(machine.inertia()), machine.size
    rates = np.block(
        [
            [np.zeros((size, size)), np.eye(size)],
            [-inverse @ machine.stiffness(), -inverse @ machine.damping()],
        ]
    )
    found = np.linalg.eigvals(rates)
    fading = -found.real[np.abs(found) > 1e-9 * np.abs(found).max()]  # the shafts turn freely
    slowest = float(fading.min(initial=np.inf))
    most = setting.longest * setting.settle
    if not slowest > FADED / (most * period):
        return most - setting.settle
    return max(0, ceil(FADED / (slowest * period)) - setting.settle)


def _settled_and_read(
    machine: Machine, contact: Contact, setting: Setting, state: tuple[Array, Array], step: float
) -> tuple[int, Trajectory, float]:
    """The cycles that are read, after those in which the motion settles."""
    steps = setting.settle * setting.steps
    settled = simulate(machine, contact, *state, step=step, steps=steps, every=steps, solver=setting.solver)
    return _read(machine, contact, setting, (settled.q[-1], settled.v[-1]), step)


def _read(
    machine: Machine, contact: Contact, setting: Setting, state: tuple[Array, Array], step: float
) -> tuple[int, Trajectory, float]:
    """The cycles that are read, with as many times the steps as it takes for the balance of energy to close,
    and what is missing in it."""
    cycles = setting.read + 1  # one more: whole mesh cycles lie within
    finer = setting.finer
    while True:
        fine, steps = step / finer, cycles * setting.steps * finer
        motion = simulate(machine, contact, *state, step=fine, steps=steps, solver=setting.solver)
        residual = energy_balance(machine, motion, contact).residual
        if residual < CLOSES or 2 * finer > setting.finest:
            return finer, motion, residual
        finer *= 2


def _start(
    inputs: Inputs,
    machine: Machine,
    stiffness: float,
    torque: float,
    start: tuple[Array, Array] | None,
) -> tuple[Array, Array]:
    """Rolling at the speed: as the neighbour moved about its own, or pressed together."""
    radii = [0.5 * gear.base_diameter for gear in inputs.pair.gears]
    if start is not None:
        q, v = start[0].copy(), start[1].copy()
        v += machine.rolling() * (1.0 - v[5] / machine.speed)
        return q, v
    q, v = np.zeros(machine.size), machine.rolling()
    over = cos(inputs.pair.pinion.base_helix_angle)
    force = torque / (radii[0] * over)
    q[5] = (0.5 * inputs.backlash + force / stiffness) / (radii[0] * over)
    return q, v
