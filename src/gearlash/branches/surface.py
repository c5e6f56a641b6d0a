"""The surface that a motion grazes: X = ±D of a clearance, or Φ = 0 where contact ends with its force."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Carried, Hold, Propagators
from gearlash.flow.events import gap_displacement, gap_velocity
from gearlash.orbits.contact_force import force_series
from gearlash.orbits.grazing import Surface, force_gradient

Array = NDArray[np.float64]
TIME_STEP = 1e-5  # mesh cycles: for derivatives in time


@dataclass(frozen=True)
class Touching:
    """H and H' of one surface along a motion that starts at phase ``origin`` (mesh cycles) and is held at
    ``hold``."""

    kind: Surface
    origin: float
    hold: Hold

    @property
    def clearance(self) -> int:
        return self.hold.clearance

    def carried(self, props: Propagators, z0: Array, phase: float, jacobian: bool = False) -> Carried:
        return flow.carry(props, z0, phase - self.origin, self.origin, jacobian=jacobian, hold=self.hold)

    def values(self, props: Propagators, z0: Array, phase: float) -> Array:
        """(H, H') at a phase."""
        if self.kind == "force":
            return self._force(props, z0, phase)[:2]
        state, system = self.carried(props, z0, phase).state, props.system
        c = system.clearances[self.clearance]
        edge = c.gap_plus if self.hold.boundary > 0 else -c.gap_minus
        x = gap_displacement(system, [phase], state[None], self.clearance)[0]
        return np.array([x - edge, gap_velocity(system, [phase], state[None], self.clearance)[0]])

    def curvature(self, props: Propagators, z0: Array, phase: float) -> float:
        """H'' in τ: of X from X' on both sides, which for every rule is the same on both sides of a boundary,
        as with X = ±D and X' = 0 the contact force is zero."""
        if self.kind == "force":
            return float(self._force(props, z0, phase)[2])
        before, after = (self.values(props, z0, phase + d)[1] for d in (-TIME_STEP, TIME_STEP))
        return float((after - before) / (2 * TIME_STEP * 2 * np.pi / props.system.omega))

    def rows(self, props: Propagators, z0: Array, phase: float) -> Array:
        """∂(H, H')/∂z0 (2, n)."""
        system = props.system
        if self.kind == "gap":
            h = system.clearances[self.clearance].h
            return np.stack([h, h @ system.matrix]) @ self._flow(props, z0, phase)
        below, here, above = (self._force_row(props, z0, phase + d) for d in (-TIME_STEP, 0.0, TIME_STEP))
        return np.stack([here, (above - below) / (2 * TIME_STEP * 2 * np.pi / system.omega)])

    def _force_row(self, props: Propagators, z0: Array, phase: float) -> Array:
        gradient = force_gradient(props.system, self.clearance, phase, self.hold.boundary)
        return gradient @ self._flow(props, z0, phase)

    def _flow(self, props: Propagators, z0: Array, phase: float) -> Array:
        jacobian = self.carried(props, z0, phase, jacobian=True).jacobian
        assert jacobian is not None
        return jacobian

    def _force(self, props: Propagators, z0: Array, phase: float) -> Array:
        """Φ, Φ', Φ'' at the end of the held motion, from its last piece."""
        trace = flow.trace(props, z0, phase - self.origin, self.origin, hold=self.hold)
        last = np.array([len(trace.positions) - 1])
        boundary = np.array([self.hold.boundary])
        return np.concatenate(force_series(trace, self.clearance, last, np.ones(1), boundary))
