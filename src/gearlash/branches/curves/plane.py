"""The plane of two parameters in which a curve lies; with one, the line on which a point is solved for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.system import Family, GearlashError, System

Array = NDArray[np.float64]
UNBUILT = (GearlashError, np.linalg.LinAlgError)
"""What a system that cannot be built or carried raises."""
KEPT_SYSTEMS = 3  # systems that are kept, the last ones asked for


@dataclass(frozen=True, eq=False)
class Plane:
    """Parameters ``names`` of a family between limits (as many), all other ``values`` fixed."""

    family: Family
    values: Mapping[str, float]
    names: tuple[str, ...]
    lower: tuple[float, ...]
    upper: tuple[float, ...]
    _built: dict[tuple[float, ...], Propagators] = field(default_factory=dict)

    @property
    def unit(self) -> Array:
        """(names,): how wide the limits are apart."""
        return np.array(self.upper) - np.array(self.lower)

    def at(self, place: Array) -> Mapping[str, float]:
        """All values at a place (names,) of the plane."""
        return {**self.values, **dict(zip(self.names, place.tolist(), strict=True))}

    def system_at(self, place: Array) -> Propagators:
        """Raises what `UNBUILT` names."""
        key = tuple(place.tolist())
        found = self._built.pop(key, None)
        if found is None:
            reuse = next(reversed(self._built.values()), None)
            found = flow.propagators(self.build(place), reuse)
        self._built[key] = found
        while len(self._built) > KEPT_SYSTEMS:
            del self._built[next(iter(self._built))]
        return found

    def begin(self, place: Array, like: Propagators) -> Propagators:
        """The system at a place, for the first time: from one that may be the same. Raises what `UNBUILT`
        names."""
        self._built[tuple(place.tolist())] = found = flow.propagators(self.build(place), like)
        return found

    def build(self, place: Array) -> System:
        """Raises what `UNBUILT` names."""
        return self.family.system(self.at(place))

    def inside(self, place: Array) -> bool:
        """Whether a place lies within the limits."""
        return bool((place >= np.array(self.lower)).all() and (place <= np.array(self.upper)).all())

    def outer(self, axis: int) -> float:
        """The largest value of a parameter that the family takes."""
        return self.ranges[axis][1]

    @cached_property
    def ranges(self) -> tuple[tuple[float, float], ...]:
        """Of every parameter, the values that the family takes."""
        known = {p.name: (p.lower, p.upper) for p in self.family.parameters}
        return tuple(known[name] for name in self.names)

    def part_within(self, place: Array, step: Array) -> float:
        """The part (0 to 1) of a step of the parameters that stays in their ranges: where all of it would
        leave one, half of the way to its end, so that a solution at the end itself is come to as near as
        rounding."""
        part = 1.0
        for value, change, (low, high) in zip(place.tolist(), step.tolist(), self.ranges, strict=True):
            if not low <= value + change <= high:
                end = high if change > 0.0 else low
                part = min(part, max(0.0, 0.5 * (end - value) / change))
        return part
