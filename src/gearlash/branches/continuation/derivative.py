"""How the systems of a family change along a parameter: exactly where that can be known, or by a difference.

Where only loads, errors and gaps depend on the parameter, and those are affine in it, two systems tell the
change of all of them. That is found out from systems across the interval, and held against every other one
that is built. Elsewhere the numbers of the system are differenced, not its motion: over the whole interval
where they are polynomials of low degree in the parameter, which is found out and held in the same way; else
beside each orbit. The motion's derivative is as good as that of the numbers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from gearlash.flow.sensitivity import SystemChange, most_harmonics, numbers_of, of_numbers
from gearlash.system import GearlashError, Named, System

Array = NDArray[np.float64]
DEGREE = 3  # of polynomials that are tried
FITTED = (0.0, 0.25, 0.75, 1.0)  # parts of the interval through which they go
CHECKED = (0.1276, 0.6180)  # where they must be right, too
LEAST_WIDTH = 1e-2  # of the parameter: what is fitted over less is rounding
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


@dataclass(frozen=True, eq=False)
class Polynomial:
    """All numbers of the systems as polynomials in the part of the interval: ``coefficients`` (degree + 1,
    numbers), lowest first; ``like``: one of the systems; ``count``: harmonics of every series; ``sizes``:
    what rounding acts on; ``affine``: whether these are load, error and gap alone, and of degree one."""

    like: System
    count: int
    coefficients: Array
    sizes: Array
    affine: bool

    def right(self, part: float, system: System) -> bool:
        """Whether a system is what is predicted, to rounding."""
        if _plain(system) != _plain(self.like) or most_harmonics(system) > self.count:
            return False
        here = numbers_of(system, self.count)
        if self.affine and not (here == self.coefficients[0])[~_movable(self.like, self.count)].all():
            return False
        away = np.abs(part ** np.arange(len(self.coefficients)) @ self.coefficients - here)
        return bool((away <= ROUNDINGS * (self.sizes + np.abs(here))).all())

    def slope(self, part: float) -> Array:
        """Derivative of all numbers by the part."""
        powers = np.arange(1, len(self.coefficients))
        return powers * part ** (powers - 1) @ self.coefficients[1:]

    @cached_property
    def error(self) -> float:
        """Of the derivatives, relative: rounding against how far the numbers of a kind move."""
        moved = np.abs(self.coefficients[1:]).sum(axis=0)
        moving = moved > ROUNDINGS * self.sizes
        return float((ROUNDINGS * self.sizes[moving] / moved[moving]).max(initial=0.0))


@dataclass(eq=False)
class Along:
    """The systems that ``build`` makes of values of a parameter from ``lower`` to ``upper``; the
    largest estimate of the relative ``error`` of the differences that were taken."""

    build: Callable[[float], System]
    lower: float
    upper: float
    error: float = 0.0
    _refuted: bool = False
    _estimated: list[float] = field(default_factory=list)

    @staticmethod
    def over(
        build: Callable[[float], System], limits: tuple[float, float], range_: tuple[float, float]
    ) -> Along:
        """Over an interval that is widened, within the range of the parameter, where it is narrow."""
        lower, upper = limits
        least = LEAST_WIDTH * (max(abs(lower), abs(upper)) or 1.0)
        beyond = max(0.0, 0.5 * (least - (upper - lower)))
        return Along(build, max(range_[0], lower - beyond), min(range_[1], upper + beyond))

    @property
    def kind(self) -> DerivativeKind:
        known = self._known
        return DerivativeKind.EXACT if known is not None and known.affine else DerivativeKind.DIFFERENCE

    def hold(self, value: float, system: System) -> None:
        """Tells of a system that was built: whether what was found out is true of it."""
        if self._known is not None and not self._known.right(self._part(value), system):
            self._refuted = True

    def at(self, value: float, system: System) -> SystemChange:
        """How ``system``, that of this value, changes. Raises `GearlashError` where none can be built on
        either side."""
        known, width = self._known, self.upper - self.lower
        if known is not None:
            self.error = max(self.error, 0.0 if known.affine else known.error)
            return of_numbers(known.like, known.slope(self._part(value)) / width, known.count)
        step = STEP * (max(abs(value), LEAST_SCALE * width) or 1.0)
        below, above = self._built(value - step), self._built(value + step)
        if below is None or above is None:
            return self._one_sided(value, system, step)
        if all(abs(value - other) > AGAIN * width for other in self._estimated):
            self._estimated.append(value)
            wide = self._built(value - 2.0 * step), self._built(value + 2.0 * step)
            if wide[0] is not None and wide[1] is not None:
                self.error = max(self.error, _apart((wide[0], below, above, wide[1]), step))
        return SystemChange.between(below, above, 2.0 * step)

    def _one_sided(self, value: float, system: System, step: float) -> SystemChange:
        """To first order only, beside a value at which the family ends."""
        for sign in (1.0, -1.0):
            there = value + sign * ONE_SIDED * step
            beside = self._built(there)
            if beside is not None:
                self.error = max(self.error, ONE_SIDED * STEP)
                return SystemChange.between(system, beside, there - value)
        raise GearlashError("no system can be built beside that of an orbit")

    def _part(self, value: float) -> float:
        return (value - self.lower) / (self.upper - self.lower)

    def _built(self, value: float) -> System | None:
        try:
            return self.build(value)
        except GearlashError:
            return None

    @property
    def _known(self) -> Polynomial | None:
        return None if self._refuted else self._found

    @cached_property
    def _found(self) -> Polynomial | None:
        """What the systems across the interval have in common, if they have."""
        if not self.upper > self.lower:
            return None
        values = {part: self.lower + part * (self.upper - self.lower) for part in (*FITTED, *CHECKED)}
        values[1.0] = self.upper
        systems = {part: self._built(value) for part, value in values.items()}
        all_built = [system for system in systems.values() if system is not None]
        if len(all_built) < len(systems):
            return None
        count = max(map(most_harmonics, all_built))
        numbers = np.array([numbers_of(system, count) for system in all_built])
        sizes = 2.0 * np.abs(numbers).max(axis=0)
        first = np.vstack([numbers[0], numbers[len(FITTED) - 1] - numbers[0]])
        fixed = ~_movable(all_built[0], count)
        affine = bool((first[1][fixed] == 0.0).all())
        cubic = np.linalg.solve(np.vander(FITTED, DEGREE + 1, increasing=True), numbers[: len(FITTED)])
        cubic[0] = numbers[0]
        cubic[1:, (numbers == numbers[0]).all(axis=0)] = 0.0
        for coefficients, plain in ((first, True), (cubic, False)):
            if plain and not affine:
                continue
            tried = Polynomial(all_built[0], count, coefficients, sizes, plain)
            if all(tried.right(part, system) for part, system in zip(systems, all_built, strict=True)):
                return tried
        return None


def _plain(system: System) -> tuple[object, ...]:
    """All that is no number."""
    each = [(c.contact, c.name, c.stops(1), c.stops(-1)) for c in system.clearances]
    return (system.size, system.cycles, *each)


def _movable(system: System, count: int) -> NDArray[np.bool_]:
    """Which of the numbers are loads, errors and gaps."""
    n, width = system.size, 2 * count + 1
    own = [False] * (1 + n * n) + [True] * (n * width)
    each = [False] * (2 * n + 2 * width) + [True] * (width + 2) + [False] * 2
    return np.array(own + each * len(system.clearances))


def _apart(systems: tuple[System, System, System, System], step: float) -> float:
    """Estimate of the relative error of a central difference from that with twice the step: what both
    disagree by, a third of which is the narrow one's to second order, and rounding. The systems lie at -2,
    -1, 1 and 2 steps."""
    count = max(map(most_harmonics, systems))
    far_low, low, high, far_high = (numbers_of(system, count) for system in systems)
    near, far = (high - low) / (2.0 * step), (far_high - far_low) / (4.0 * step)
    moving = np.abs(near) * step > ROUNDINGS * np.abs(high)
    rounding = 2.0**-52 * np.abs(high) / step
    return float(((np.abs(far - near) / 3.0 + rounding)[moving] / np.abs(near[moving])).max(initial=0.0))
