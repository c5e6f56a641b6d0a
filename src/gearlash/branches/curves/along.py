"""How a special orbit moves along a parameter, from the traces of the motion: the maps of no other system are
built."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from gearlash.flow import Propagators, Trace
from gearlash.flow.sensitivity import SystemChange, sensitivity
from gearlash.system import GearlashError, System

from .plane import UNBUILT, Array, Plane
from .touch import Leg, Window, carried, gap_values, traced

STEP = 1e-7  # of the parameter, or of the width of the limits: for how systems change, to as many digits


@dataclass(frozen=True, eq=False)
class Beside:
    """A system, and another member of its family whose parameter is larger by ``step``, or less."""

    system: System
    step: float
    other: System

    @staticmethod
    def of(plane: Plane, place: Array, axis: int, system: System) -> Beside:
        """Above the system's value, or below it where there is none. Raises `GearlashError` where there is
        none on both sides."""
        value, step = float(place[axis]), STEP * max(abs(float(place[axis])), float(plane.unit[axis]))
        low, high = plane.ranges[axis]
        for there in (value + step, value - step):
            moved = place.copy()
            moved[axis] = there
            try:
                if low <= there <= high:
                    return Beside(system, there - value, plane.build(moved))
            except UNBUILT:
                continue
        raise GearlashError("no system can be built beside that of an orbit")

    @cached_property
    def change(self) -> SystemChange:
        return SystemChange.between(self.system, self.other, self.step)


def moved_states(props: Propagators, states: list[Array], legs: list[Leg], beside: Beside) -> list[Array]:
    """How the states (n,) at the beginning of every leg and at the end move with the parameter, the first one
    held. Raises what `UNBUILT` names."""
    moved = [np.zeros(len(states[0]))]
    for state, leg in zip(states[:-1], legs, strict=True):
        jacobian = carried(props, state, leg)[1] if moved[-1].any() else np.eye(len(state))
        moved.append(moved_end(traced(props, state, leg), jacobian, moved[-1], beside))
    return moved


def moved_end(trace: Trace, jacobian: Array, moved: Array, beside: Beside) -> Array:
    """The same at the end of a trace, whose start moves so; ``jacobian`` (n, n): of its end by its start."""
    found: Array = sensitivity(trace, beside.change)[0] + jacobian @ moved
    return found


def moved_gap(state: Array, moved: Array, phase: float, window: Window, beside: Beside) -> Array:
    """How (X ∓ D, X') move at a phase, where the state moves so."""
    after = gap_values(beside.other, window, state + beside.step * moved, phase)
    return (after - gap_values(beside.system, window, state, phase)) / beside.step
