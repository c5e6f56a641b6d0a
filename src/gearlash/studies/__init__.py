"""Studies ask for many attractors at once: points, sweeps, stable zones."""

from gearlash.orbits import Settings
from gearlash.results import Axis, Direction, Point, Sweep, coexisting, same_motion

from .model import Model, prepare
from .point import point, summary
from .sweep import open_workers, sweep, sweeps
from .zone import End, Interval, Quiet, Tenant, Zone, Zones
from .zones import zones

__all__ = [
    "Axis",
    "Direction",
    "End",
    "Interval",
    "Model",
    "Point",
    "Quiet",
    "Settings",
    "Sweep",
    "Tenant",
    "Zone",
    "Zones",
    "coexisting",
    "open_workers",
    "point",
    "prepare",
    "same_motion",
    "summary",
    "sweep",
    "sweeps",
    "zones",
]
