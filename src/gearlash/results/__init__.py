"""Datasets of what lower rooms computed: with case, scales, units and provenance.

dataset = sweep_dataset(case, [cold, up, down])
save(dataset, "sweep.nc");  load("sweep.nc")
"""

from .axis import Axis
from .compare import coexisting, same_motion
from .dataset import sweep_dataset
from .digest import content_hash
from .point import FAILED, NOT_COMPUTED, Point, blank
from .provenance import provenance
from .store import load, save
from .sweep import Direction, Sweep

__all__ = [
    "FAILED",
    "NOT_COMPUTED",
    "Axis",
    "Direction",
    "Point",
    "Sweep",
    "blank",
    "coexisting",
    "content_hash",
    "load",
    "provenance",
    "same_motion",
    "save",
    "sweep_dataset",
]
