"""The linear motion in one region: the system as it would be if the boundaries of its gaps were not there."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from gearlash.flow import Trace
from gearlash.flow.regions import Sides
from gearlash.system import Clearance, ContactRule, System, constant

PLUS, FREE, MINUS = 0, 1, 2  # sides of a clearance, as a trace tells them


def stays_in(trace: Trace) -> Sides | None:
    """The region in which a motion stays all along, a side for every clearance; None where it meets a
    boundary."""
    if len(trace.events):
        return None
    return tuple(int(trace.regions_of(j)[0]) for j in range(len(trace.propagators.system.clearances)))


def linear_system(system: System, sides: Sides) -> System:
    """Linear, and the same as ``system`` wherever a motion stays in the region of these sides."""
    clearances = tuple(_everywhere(c, side) for c, side in zip(system.clearances, sides, strict=True))
    return replace(system, clearances=clearances)


def homogeneous(system: System) -> System:
    """The same without forcing, offsets and gaps: what is left of it for very large motions."""
    clearances = tuple(
        replace(c, gap_plus=0.0, gap_minus=0.0, offset=constant(0.0)) for c in system.clearances
    )
    return replace(system, forcing=np.zeros_like(system.forcing), clearances=clearances)


def _everywhere(clearance: Clearance, side: int) -> Clearance:
    """A gap of no width whose two sides are alike: its force is linear."""
    stiffness, place = constant(0.0), 0.0
    if side == PLUS:
        stiffness, place = clearance.stiffness_plus, clearance.gap_plus
    elif side == MINUS:
        stiffness, place = clearance.stiffness_minus, -clearance.gap_minus
    acts = clearance.contact is ContactRule.ALWAYS or side != FREE
    damping = clearance.dampings[1 if side == MINUS else 0] if acts else 0.0
    offset = clearance.offset.copy()
    offset[0] += place
    return replace(
        clearance, gap_plus=0.0, gap_minus=0.0, stiffness_plus=stiffness, stiffness_minus=stiffness,
        damping=damping, damping_minus=None, offset=offset, contact=ContactRule.ALWAYS,
    )  # fmt: skip
