"""Contact events, and the gap and the force of a clearance."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from gearlash.system import ContactRule, GearlashError, Record, System, derivative, evaluate, given

from ._tables import MINUS, PLUS, Array


@dataclass(frozen=True, eq=False, repr=False)
class Events(Record):
    """Contact events in order.

    Attributes
    ----------
    phase : array (m,)
        In mesh cycles, θ/2π.
    state : array (m, n)
        The state there.
    velocity : array (m,)
        X', the velocity of the gap.
    force : array (m,)
        Φ of the contact that begins or ends.
    clearance : array (m,) of int
        Number of the clearance.
    boundary : array (m,) of int
        +1: Σ1 at +D; -1: Σ2 at -D.
    engaging : array (m,) of bool
        Whether contact begins.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> events = gl.trace(family.system({"omega": 0.9}), [1.1, -0.5], 1.0).events
    >>> print(len(events), events.boundary, events.engaging)
    1 [1] [False]
    """

    _printed: ClassVar = ("phase", "clearance", "boundary", "engaging")

    phase: Array
    state: Array
    velocity: Array
    force: Array
    clearance: Array
    boundary: Array
    engaging: Array

    @staticmethod
    def build(system: System, phase: Array, state: Array, kind: Array) -> Events:
        """Events with velocities and forces.

        Parameters
        ----------
        system : System
            Whose they are.
        phase : array (m,)
            In mesh cycles.
        state : array (m, n)
            The states there.
        kind : array (m, 3)
            Clearance, boundary, and 1 where contact begins.

        Returns
        -------
        Events
            All of it.
        """
        clearance, boundary = kind[:, 0].astype(np.int64), kind[:, 1].astype(np.int64)
        engaging = kind[:, 2] == 1.0
        velocity, force = np.empty(len(phase)), np.empty(len(phase))
        for j in sorted(set(clearance.tolist())):  # np.unique would import masked arrays, 30 ms
            chosen = clearance == j
            velocity[chosen] = gap_velocity(system, phase[chosen], state[chosen], j)
            force[chosen] = _event_force(
                system, j, phase[chosen], state[chosen], velocity[chosen], boundary[chosen],
                engaging[chosen],
            )  # fmt: skip
        return Events(phase, state, velocity, force, clearance, boundary, engaging)

    def where(self, mask: Array) -> Events:
        """Select some events.

        Parameters
        ----------
        mask : array (m,) of bool, or array of int
            Which: a truth value for each, or their numbers.

        Returns
        -------
        Events
            Those.

        Raises
        ------
        GearlashError
            For a mask of another length, and numbers that are out of range.
        """
        try:
            mask = np.asarray(mask)
        except (TypeError, ValueError):
            mask = np.asarray("")
        if mask.dtype.kind not in "biu" or (mask.dtype.kind == "b" and mask.shape != self.phase.shape):
            raise GearlashError(f"mask of events: expected {len(self)} truth values, or indices")
        if mask.dtype.kind != "b" and mask.size and not -len(self) <= mask.min() <= mask.max() < len(self):
            raise GearlashError(f"mask of events: expected indices from 0 to {len(self) - 1}")
        parts = (
            self.phase, self.state, self.velocity, self.force, self.clearance, self.boundary, self.engaging
        )  # fmt: skip
        return Events(*(part[mask] for part in parts))

    def of(self, clearance: int) -> Events:
        """Select the events of one clearance.

        Parameters
        ----------
        clearance : int
            Its number, from 0.

        Returns
        -------
        Events
            Those.
        """
        return self.where(self.clearance == given.whole("clearance", clearance, 0))

    def __len__(self) -> int:
        return len(self.phase)


def gap_displacement(system: System, phase: ArrayLike, state: Array, clearance: int = 0) -> Array:
    """X = h·z - e of a clearance at phases (mesh cycles) and states (m, n)."""
    c = system.clearances[clearance]
    return state @ c.h - evaluate(c.offset, _base_phase(system, phase))


def gap_velocity(system: System, phase: ArrayLike, state: Array, clearance: int = 0) -> Array:
    """X' = h·(M z + b) - e' (contact forces do not enter, because h·g = 0)."""
    c, theta = system.clearances[clearance], _base_phase(system, phase)
    drift = state @ (c.h @ system.matrix) + evaluate(c.h @ system.forcing, theta)
    return drift - system.omega / system.cycles * evaluate(derivative(c.offset), theta)


def contact_force(
    system: System, phase: ArrayLike, x: Array, velocity: Array, region: Array, clearance: int = 0
) -> Array:
    """Φ of a clearance at given displacements, velocities and regions (0: side +, 1: free, 2: side -). With
    the rule `no-tension` it never pulls, not by rounding either where contact ends with its force."""
    force = force_of_side(system, phase, x, velocity, region, clearance)
    if system.clearances[clearance].contact is ContactRule.NO_TENSION:
        force = np.where(region == PLUS, np.maximum(force, 0.0), force)
        force = np.where(region == MINUS, np.minimum(force, 0.0), force)
    return force


def force_of_side(
    system: System, phase: ArrayLike, x: Array, velocity: Array, region: Array, clearance: int = 0
) -> Array:
    """The same of either sign, whatever the rule: zero of it is where contact ends with `no-tension`."""
    c, theta = system.clearances[clearance], _base_phase(system, phase)
    elastic = np.zeros(np.shape(x))
    for side, series, beyond in (
        (PLUS, c.stiffness_plus, x - c.gap_plus),
        (MINUS, c.stiffness_minus, x + c.gap_minus),
    ):
        there = region == side
        if np.any(there):
            elastic[there] = evaluate(series, theta[there]) * beyond[there]
    plus, minus = c.dampings
    damping = np.where(region == PLUS, plus, np.where(region == MINUS, minus, 0.0))
    if c.contact is ContactRule.ALWAYS:
        damping = plus
    return elastic + damping * velocity


def _event_force(
    system: System, j: int, phase: Array, state: Array, velocity: Array, boundary: Array, engaging: Array
) -> Array:
    """Φ where contact begins (just after) or ends (just before): on a boundary the elastic part is zero, so
    that of damping alone, exactly. With the rule `no-tension` contact ends where Φ = 0, and begins there too
    if the gap is still closed."""
    c = system.clearances[j]
    plus, minus = c.dampings
    force = np.where(boundary > 0, plus, minus) * velocity
    if c.contact is ContactRule.NO_TENSION:
        x = gap_displacement(system, phase, state, j)
        beyond = np.where(boundary > 0, x - c.gap_plus, -x - c.gap_minus)
        size = np.abs(state) @ np.abs(c.h) + np.where(boundary > 0, c.gap_plus, c.gap_minus)
        force = np.where(~engaging | (beyond > 1e-13 * size) & (boundary * velocity < 0.0), 0.0, force)
    return force


def _base_phase(system: System, phase: ArrayLike) -> Array:
    return 2.0 * np.pi / system.cycles * np.asarray(phase, dtype=np.float64)
