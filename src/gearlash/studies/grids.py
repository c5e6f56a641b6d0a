"""How closely a report looks: fewer values where each of them takes long.

The slower a pair runs beside its natural frequencies, the more cells a mesh cycle is cut into, and the longer
every motion takes. Counted, not timed: so a report is the same on every machine."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt

from gearlash.case import Case
from gearlash.flow import Propagators, propagators
from gearlash.results import Axis

from .model import Source

SPEEDS, FINE, PIXELS = 61, 201, (40, 20)
LEAST_SPEEDS, LEAST_FINE, LEAST_PIXELS = 21, 41, (12, 6)
USUAL = 2_500
"""Cells of a mesh cycle times states: a motion takes some ten milliseconds then."""


@dataclass(frozen=True)
class Grids:
    """Values that a report looks at.

    Parameters
    ----------
    cells : int
        Into which a mesh cycle is cut at the present speed.
    speeds, fine : int
        From which bands are found, and at which quantities are measured.
    pixels : (int, int)
        Of a map.
    """

    cells: int
    speeds: int = SPEEDS
    fine: int = FINE
    pixels: tuple[int, int] = PIXELS

    @staticmethod
    def of(props: Propagators) -> Grids:
        """What is affordable for a system."""
        share = min(1.0, USUAL / (props.cells_per_cycle * props.system.size))
        side = sqrt(share)
        return Grids(
            round(props.cells_per_cycle),
            _part(share, SPEEDS, LEAST_SPEEDS),
            _part(share, FINE, LEAST_FINE),
            (_part(side, PIXELS[0], LEAST_PIXELS[0]), _part(side, PIXELS[1], LEAST_PIXELS[1])),
        )

    @staticmethod
    def of_case(case: Case) -> Grids:
        """The same of a case as it is."""
        return Grids.of(propagators(Source.of(case).family().system()))

    def fewer(self, axis: Axis) -> Axis:
        """An axis with no more values than `fine`."""
        if len(axis) <= self.fine:
            return axis
        return Axis.even(axis.name, float(axis.values[0]), float(axis.values[-1]), self.fine)

    @property
    def told(self) -> str:
        """What was looked at less closely, or nothing."""
        if self.pixels == PIXELS and self.fine == FINE:
            return ""
        return (
            f"This pair is slow beside its natural frequencies: a mesh cycle is computed in {self.cells} "
            "parts, and every motion takes long. So, where nothing else was asked for, bands were found from "
            f"{self.speeds} speeds in place of {SPEEDS}, curves have {self.fine} in place of {FINE}, and "
            f"maps {self.pixels[0]} by {self.pixels[1]} values in place of {PIXELS[0]} by {PIXELS[1]}; what "
            "lies between was not looked at."
        )


def _part(share: float, usual: int, least: int) -> int:
    return max(min(usual, least), round(share * usual))
