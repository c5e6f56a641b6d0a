"""The plane of two parameters in which a curve lies."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.system import Family, GearlashError

Array = NDArray[np.float64]
UNBUILT = (GearlashError, np.linalg.LinAlgError)
"""What a system that cannot be built or carried raises."""
KEPT_SYSTEMS = 3  # systems that are kept, the last ones asked for


@dataclass(frozen=True, eq=False)
class Plane:
    """Parameters ``names`` of a family between limits (2,), all other ``values`` fixed."""

    family: Family
    values: Mapping[str, float]
    names: tuple[str, str]
    lower: tuple[float, float]
    upper: tuple[float, float]
    _built: dict[tuple[float, float], Propagators] = field(default_factory=dict)

    @property
    def unit(self) -> Array:
        """(2,): how wide the limits are apart."""
        return np.array(self.upper) - np.array(self.lower)

    def at(self, place: Array) -> Mapping[str, float]:
        """All values at a place (2,) of the plane."""
        return {**self.values, **dict(zip(self.names, place.tolist(), strict=True))}

    def system_at(self, place: Array) -> Propagators:
        """Raises what `UNBUILT` names."""
        key = float(place[0]), float(place[1])
        found = self._built.pop(key, None)
        if found is None:
            reuse = next(reversed(self._built.values()), None)
            found = flow.propagators(self.family.system(self.at(place)), reuse)
        self._built[key] = found
        while len(self._built) > KEPT_SYSTEMS:
            del self._built[next(iter(self._built))]
        return found

    def inside(self, place: Array) -> bool:
        """Whether a place lies within the limits."""
        return bool((place >= np.array(self.lower)).all() and (place <= np.array(self.upper)).all())

    def outer(self, axis: int) -> float:
        """The largest value of a parameter that the family takes."""
        return next(p.upper for p in self.family.parameters if p.name == self.names[axis])
