"""A family whose members have estimates of their own: at their torque, and for what varies of the drawing.

Members are systems in the units of the case. One with another mean stiffness k and another frequency ω_n than
the case, built in units of its own, is turned into those: with r = ω_n/ω_n,case and q = k/k_case, velocities
are r times as large, Φ is q times as large, and rates of the state are r times those of its own time.

Parameters of the model keep their meaning: what a value is above that of the case, in physical units, it is
above the one that the member has for itself.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from gearlash.case.errors import Problem
from gearlash.case.quantity import Quantity
from gearlash.case.scales import Scales
from gearlash.case.stated import Stated
from gearlash.system import Family, GearlashError, Parameter, System

from .entries import replaced
from .estimated import Completed
from .places import Places
from .records import Numbers
from .rules import EntriesByKey, PairRules
from .units import to_dimensionless, to_physical

TORQUE = "operation.torque"


class Pair(Protocol):
    """A gear pair with its numbers, as `pair.GearPair` is one."""

    @property
    def rules(self) -> PairRules: ...
    @property
    def stated(self) -> EntriesByKey: ...
    @property
    def varied(self) -> tuple[str, ...]: ...
    @property
    def completed(self) -> Completed: ...
    @property
    def entries(self) -> EntriesByKey: ...
    @property
    def numbers(self) -> Numbers: ...
    @property
    def places(self) -> Places: ...
    @property
    def scales(self) -> Scales: ...

    def with_stated(self, stated: EntriesByKey) -> Pair:
        """The pair with these stated values, of which none varies."""
        ...

    def lacks(self) -> list[Problem]:
        """What is missing."""
        ...

    def contradicted(self) -> list[Problem]:
        """What contradicts itself."""
        ...


def recomputed(pair: Pair, own: Family) -> Family:
    """The family ``own`` of a pair with members estimated for themselves, and what varies as parameters."""
    extra = tuple(_parameter(pair, path) for path in pair.varied)
    members = _Members(pair, own, tuple(p.name for p in extra))

    def build(values: Mapping[str, float]) -> System:
        return members.build(values)

    def cold_start(values: Mapping[str, float]) -> NDArray[np.float64]:
        return members.cold_start(values)

    return Family((*own.parameters, *extra), own.states, build, cold_start)


def _parameter(pair: Pair, path: str) -> Parameter:
    place = pair.places.quantities[path]
    value = _number(pair, path)
    lower = np.nextafter(place.lower, 1.0) if place.above else place.lower
    return Parameter(path, value, f"{place.description} (SI)", float(lower), place.upper)


class _Members:
    """Members of the family of a pair, each found once."""

    def __init__(self, pair: Pair, own: Family, extra: tuple[str, ...]):
        self.pair, self.own, self.extra = pair, own, extra
        self._defaults = {name: _number(pair, name) for name in extra}
        self._torque = _torque(pair)
        self._found = lru_cache(maxsize=64)(self._other)

    def build(self, values: Mapping[str, float]) -> System:
        own, moved = self._apart(values)
        if not moved:
            return self.own.build(own)
        other, family = self._found(moved)
        return rescaled(family.build(self._values(own, other, family)), self.pair.scales, other.scales)

    def cold_start(self, values: Mapping[str, float]) -> NDArray[np.float64]:
        own, moved = self._apart(values)
        if not moved:
            return self.own.cold_start(own)
        other, family = self._found(moved)
        start = np.asarray(family.cold_start(self._values(own, other, family)), dtype=float)
        return start * _stretch(len(start), self.pair.scales, other.scales)

    def _apart(self, values: Mapping[str, float]) -> tuple[dict[str, float], tuple[tuple[str, float], ...]]:
        """Parameters of the model, and what of the rest (and of the torque) is not as in the case."""
        own = {p.name: values[p.name] for p in self.own.parameters}
        moved = [(name, values[name]) for name in self.extra if values[name] != self._defaults[name]]
        if self.pair.completed.follows_torque and own["load"] != self.own.defaults["load"]:
            moved.append((TORQUE, float(self.pair.scales.torque(own["load"]))))
        return own, tuple(moved)

    def _other(self, moved: tuple[tuple[str, float], ...]) -> tuple[Pair, Family]:
        """The pair with these quantities (SI), and its own family."""
        stated = {
            path: Stated(_whole(self.pair.places.quantities[path], value), f"{value!r}")
            for path, value in moved
        }
        torque = stated.pop(TORQUE, None)
        other = self.pair.with_stated(replaced(self.pair.places, self.pair.stated, stated))
        _check(other)
        if torque is not None:  # as far from that of the case, whatever moved that of this one
            value = _torque(other) + float(torque.value) - self._torque
            at = {TORQUE: Stated(value, f"{value!r}")}
            other = other.with_stated(replaced(other.places, other.stated, at))
            _check(other)
        return other, other.rules.family(other.numbers)

    def _values(self, own: Mapping[str, float], other: Pair, family: Family) -> dict[str, float]:
        """Its parameters: those of its own, and beside them what these values are beside the case."""
        found = dict(family.defaults)
        for name, value in own.items():
            default = self.own.defaults[name]
            if (
                name not in found
                or value == default
                or (name == "load" and self.pair.completed.follows_torque)
            ):
                continue
            path = _path(self.pair, name)
            here, there = (float(to_physical(self.pair.scales, path, v)) for v in (value, default))
            base = float(to_physical(other.scales, path, found[name]))
            found[name] = to_dimensionless(other.scales, path, base + here - there)
        return found


def _path(pair: Pair, name: str) -> str:
    """Where a parameter stands physically."""
    entry = pair.entries.get(name)
    if entry is not None and not entry.dimensionless:
        return entry.path
    return pair.places.two_way.get(name, (name,))[0] if name != "omega" else "operation.mesh_frequency"


def _number(pair: Pair, path: str) -> float:
    return pair.entries[pair.places.keys(pair.places.quantities[path])[0]].number


def _torque(pair: Pair) -> float:
    """Of the pinion, N·m."""
    return float(pair.scales.torque(pair.numbers.parameters["load"]))


def _whole(place: Quantity, value: float) -> float:
    if place.integer and value != round(value):
        raise GearlashError(f"{place.path} = {value:g}: whole numbers only")
    return value


def _check(pair: Pair) -> None:
    """Raises `GearlashError` where no such pair can be."""
    problems = pair.lacks() or pair.contradicted()
    if problems:
        raise GearlashError("; ".join(str(problem) for problem in problems))


def _stretch(size: int, case: Scales, own: Scales) -> NDArray[np.float64]:
    """States in the units of the case over those in a member's own: velocities, every second one, r times."""
    assert case.omega_n is not None  # a physical case has all scales
    assert own.omega_n is not None
    stretch = np.ones(size)
    stretch[1::2] = own.omega_n / case.omega_n
    return stretch


def rescaled(system: System, case: Scales, own: Scales) -> System:
    """A system in a member's own units (time 1/ω_n, force k D_c) in those of the case."""
    assert case.omega_n is not None
    assert own.omega_n is not None
    assert case.mean_stiffness is not None
    assert own.mean_stiffness is not None
    r, q = own.omega_n / case.omega_n, own.mean_stiffness / case.mean_stiffness
    stretch = _stretch(system.size, case, own)
    clearances = tuple(
        replace(
            one,
            h=one.h / stretch,
            g=stretch * one.g * (r / q),
            stiffness_plus=one.stiffness_plus * q,
            stiffness_minus=one.stiffness_minus * q,
            damping=one.damping * q / r,
        )
        for one in system.clearances
    )
    matrix = r * stretch[:, None] * system.matrix / stretch[None, :]
    forcing = r * stretch[:, None] * system.forcing
    return System(system.omega * r, matrix, forcing, clearances, system.cycles)
