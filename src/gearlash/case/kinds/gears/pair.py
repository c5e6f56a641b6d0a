"""One gear pair with its numbers."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.case.scales import Scales
from gearlash.case.units import NUMBER, TORQUE, unit
from gearlash.gears.estimates import Drawing
from gearlash.system import Family

from .excitation import Curves, Reconstructed, reconstructed
from .numbers import numbers
from .places import Places
from .records import Numbers
from .rules import EntriesByKey, PairRules
from .units import to_physical


@dataclass(frozen=True)
class GearPair:
    """Values by key, stated and estimated, the rules of their kind, the drawing where one is known, and
    curves by name."""

    rules: PairRules
    entries: EntriesByKey
    drawing: Drawing | None = None
    curves: Curves = field(default_factory=dict)

    @cached_property
    def numbers(self) -> Numbers:
        """Parameters, fixed numbers, scales and body."""
        teeth = None if self.drawing is None else self.drawing.pair
        return numbers(self.rules, self.entries, teeth, self.curves)

    @property
    def places(self) -> Places:
        return self.rules.places

    @property
    def scales(self) -> Scales:
        return self.numbers.scales

    @property
    def reconstructed(self) -> dict[str, Reconstructed]:
        """Stated curves with the series that stand for them."""
        return reconstructed(self.curves, self.entries, self.scales)

    def family(self) -> Family:
        return self.rules.family(self.numbers)

    def physical(self, short: str, value: ArrayLike) -> list[tuple[str, NDArray[np.float64], str]]:
        """(path, values, unit) for every physical way to name a parameter with these values."""
        if not self.scales.physical:
            return []
        ways = [path for path in self.places.two_way.get(short, ()) if not path.startswith("dimensionless.")]
        found = []
        for path in ways:
            place = self.places.quantities[path]
            if place.dimension != NUMBER and (place.dimension != TORQUE or self.scales.radii is not None):
                si = to_physical(self.scales, path, value)
                found.append((path, np.asarray(si) * float(unit(place.unit).express(1.0)), place.unit))
        return found
