"""What a report of a pair is made from."""

from __future__ import annotations

from dataclasses import dataclass, field

import xarray as xr

from gearlash.results.pair_units import PairUnits
from gearlash.studies.assessment import Assessment
from gearlash.studies.history import History
from gearlash.studies.speed_run import SpeedRun


@dataclass(frozen=True, eq=False)
class Contents:
    """A report as far as it came.

    Parameters
    ----------
    found : Assessment
    run : SpeedRun or None
        None where the report was stopped before.
    histories : tuple of History
        At the present speed, and of the hardest motion over speed where that is another one.
    maps : dict of str to xarray.Dataset
        By the parameter that is mapped over speed.
    missing : tuple of str
        What was not computed, as the report was stopped.
    """

    found: Assessment
    run: SpeedRun | None
    histories: tuple[History, ...]
    maps: dict[str, xr.Dataset] = field(default_factory=dict)
    missing: tuple[str, ...] = ()

    @property
    def units(self) -> PairUnits:
        """The units of the case."""
        return PairUnits.of(self.found.case)
