"""Maps of a pair over speed and one other parameter."""

from __future__ import annotations

from dataclasses import replace

import xarray as xr

from gearlash.jobs import Execution
from gearlash.orbits import Settings
from gearlash.results import Axis, plane_dataset
from gearlash.studies import map_plane
from gearlash.studies.assessment import Assessment, Tell
from gearlash.studies.grids import Grids

SPANS = {"load": (0.02, 2.0), "D": (0.2, 2.0)}
"""Of the present value: what a map goes over; that over torque reaches light load, where teeth rattle."""
STAGES = {"load": "map over torque", "D": "map over backlash"}


def plane_over(
    found: Assessment, name: str, settings: Settings, execution: Execution, tell: Tell
) -> xr.Dataset | None:
    """The map over speed and a parameter that is not zero, by short name; None where it was stopped."""
    here = found.values[name]
    tell(STAGES[name], None)
    execution = replace(execution, progress=lambda progress: tell(STAGES[name], progress))
    pixels = Grids.of(found.attractor.propagators).pixels
    x = Axis.even(found.axis.name, float(found.axis.values[0]), float(found.axis.values[-1]), pixels[0])
    low, high = SPANS[name]
    y = Axis.even(name, low * here, high * here, pixels[1])
    done = map_plane(found.case, x, y, settings=settings, execution=execution)
    return plane_dataset(found.case, done) if done.complete else None
