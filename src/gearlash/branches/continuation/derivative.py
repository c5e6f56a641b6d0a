"""How the systems of a family change along a parameter: exactly where that can be known, or by a difference.

Where only loads, errors and gaps depend on the parameter, and those are affine in it, two systems tell the
change of all of them. That is found out from systems across the interval, and held against every other one
that is built. Elsewhere the numbers of the system are differenced, not its motion: the motion's derivative is
as good as that of the numbers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from gearlash.flow.sensitivity import SystemChange
from gearlash.system import GearlashError, Named, System

Array = NDArray[np.float64]
PROBES = (0.0, 0.1276, 0.3819, 0.6180, 0.8724, 1.0)  # of the interval: systems that tell whether it is affine
ROUNDINGS = 64.0 * 2.0**-53  # of a number that a family computes from its parameter
STEP = 1e-5  # of the parameter: of the central difference
LEAST_SCALE = 1e-3  # of the interval: for the step beside the value zero
ONE_SIDED = 1e-2  # of that step, where the family has values on one side only
AGAIN = 0.125  # of the interval: so far apart the error of the difference is estimated


class DerivativeKind(Named):
    """How the derivatives along the parameter of a branch were had."""

    EXACT = "exact"
    """Nothing but load, error and gap depends on the parameter, and these are affine in it: so it is at
    values across the interval and at every orbit."""
    DIFFERENCE = "difference"
    """A difference of the numbers of the system, put into the exact derivative of the motion by them."""


@dataclass(eq=False)
class Along:
    """The systems that ``build`` makes of values of a parameter from ``lower`` to ``upper``; the largest
    estimate of the relative ``error`` of the differences that were taken."""

    build: Callable[[float], System]
    lower: float
    upper: float
    error: float = 0.0
    _refuted: bool = False
    _estimated: list[float] = field(default_factory=list)

    @property
    def kind(self) -> DerivativeKind:
        return DerivativeKind.EXACT if self._affine is not None else DerivativeKind.DIFFERENCE

    def hold(self, value: float, system: System) -> None:
        """Tells of a system that was built: whether what was found out is true of it."""
        if self._affine is not None and not self._predicts(self._affine, value, system):
            self._refuted = True

    def at(self, value: float, system: System) -> SystemChange:
        """How ``system``, that of this value, changes. Raises `GearlashError` where none can be built on
        either side."""
        affine = self._affine
        if affine is not None:
            return affine
        step = STEP * max(abs(value), LEAST_SCALE * (self.upper - self.lower))
        low, high = value - step, value + step
        below, above = self._built(low), self._built(high)
        if below is None or above is None:
            return self._one_sided(value, system, step)
        change = SystemChange(below, above, high - low)
        if all(abs(value - other) > AGAIN * (self.upper - self.lower) for other in self._estimated):
            self._estimated.append(value)
            wide = self._built(value - 2.0 * step), self._built(value + 2.0 * step)
            if wide[0] is not None and wide[1] is not None:
                self.error = max(
                    self.error, _apart(change, SystemChange(wide[0], wide[1], 4.0 * step), system)
                )
        return change

    def _one_sided(self, value: float, system: System, step: float) -> SystemChange:
        """To first order only, beside a value at which the family ends."""
        for sign in (1.0, -1.0):
            there = value + sign * ONE_SIDED * step
            beside = self._built(there)
            if beside is not None:
                self.error = max(self.error, ONE_SIDED * STEP)
                return SystemChange(system, beside, there - value)
        raise GearlashError("no system can be built beside that of an orbit")

    def _built(self, value: float) -> System | None:
        try:
            return self.build(value)
        except GearlashError:
            return None

    @property
    def _affine(self) -> SystemChange | None:
        return None if self._refuted else self._found

    @cached_property
    def _found(self) -> SystemChange | None:
        """The change of an affine family, from both ends of the interval."""
        values = [self.lower + part * (self.upper - self.lower) for part in PROBES[:-1]] + [self.upper]
        systems = [self._built(value) for value in values]
        first, last = systems[0], systems[-1]
        if first is None or last is None:
            return None
        change = SystemChange(first, last, self.upper - self.lower)
        inside = zip(values, systems, strict=True)
        return change if all(s is not None and self._predicts(change, v, s) for v, s in inside) else None

    def _predicts(self, change: SystemChange, value: float, system: System) -> bool:
        first, last = change.lower, change.upper
        if not (_fixed(first) == _fixed(last) == _fixed(system)):
            return False
        low, high, here = (_moving(each) for each in (first, last, system))
        part = (value - self.lower) / (self.upper - self.lower)
        sizes = np.abs(low) + np.abs(high) + np.abs(here)
        return bool((np.abs(low + part * (high - low) - here) <= ROUNDINGS * sizes).all())


def _fixed(system: System) -> tuple:
    """All that may not change where a family is to be affine, and how many numbers may."""
    parts: list[object] = [system.omega, system.cycles, system.matrix.tobytes(), system.forcing.shape]
    for c in system.clearances:
        parts += [c.dampings, c.contact, c.name, c.stops(1), c.stops(-1), len(c.offset)]
        parts += [a.tobytes() for a in (c.h, c.g, c.stiffness_plus, c.stiffness_minus)]
    return tuple(parts)


def _moving(system: System) -> Array:
    """Load, errors and gaps."""
    parts = [np.append(c.offset, (c.gap_plus, c.gap_minus)) for c in system.clearances]
    return np.concatenate([system.forcing.ravel(), *parts])


def _apart(change: SystemChange, wide: SystemChange, system: System) -> float:
    """Estimate of the relative error of a central difference from that with twice the step, of the numbers of
    every kind: what both disagree by, a third of which is the narrow one's to second order, and rounding."""
    worst = 0.0
    for low, high, far_low, far_high, here in zip(
        *(_numbers(s) for s in (change.lower, change.upper, wide.lower, wide.upper, system)), strict=True
    ):
        near, far = (high - low) / change.width, (far_high - far_low) / wide.width
        size = float(np.abs(near).max(initial=0.0))
        if size == 0.0:
            continue
        rounding = 2.0**-52 * float(np.abs(here).max(initial=0.0)) / change.width
        worst = max(worst, (float(np.abs(far - near).max()) / 3.0 + rounding) / size)
    return worst


def _numbers(system: System) -> list[Array]:
    found = [np.array([system.omega]), system.matrix, system.forcing]
    for c in system.clearances:
        found += [c.h, c.g, c.stiffness_plus, c.stiffness_minus, c.offset]
        found += [np.array([c.gap_plus, c.gap_minus]), np.array(c.dampings)]
    return found
