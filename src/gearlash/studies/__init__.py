"""Studies ask for many attractors at once: points, sweeps, maps, stable zones.

Continuation is imported when it is first used: most studies do without.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from gearlash.orbits import Settings
from gearlash.results import Axis, Direction, PlaneMap, Point, Sweep, coexisting, same_motion

from .first_grazing import first_grazing
from .impact_free import impact_free_speeds
from .model import Model, open_workers, prepare
from .plane import map_plane
from .point import point, summary
from .sweep import sweep, sweeps
from .zone import Zone, ZoneMotion, Zones
from .zone_end import Interval, Quiet, ZoneEnd
from .zones import zones

if TYPE_CHECKING:
    from .continuation import continue_branch, grazing_law, switch_branch
    from .curve import continue_curve

__all__ = [
    "Axis",
    "Direction",
    "Interval",
    "Model",
    "PlaneMap",
    "Point",
    "Quiet",
    "Settings",
    "Sweep",
    "Zone",
    "ZoneEnd",
    "ZoneMotion",
    "Zones",
    "coexisting",
    "continue_branch",
    "continue_curve",
    "first_grazing",
    "grazing_law",
    "impact_free_speeds",
    "map_plane",
    "open_workers",
    "point",
    "prepare",
    "same_motion",
    "summary",
    "sweep",
    "sweeps",
    "switch_branch",
    "zones",
]


def __getattr__(name: str) -> Any:
    if name in ("continue_branch", "grazing_law", "switch_branch"):
        from . import continuation

        return getattr(continuation, name)
    if name == "continue_curve":
        from . import curve

        return curve.continue_curve
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
