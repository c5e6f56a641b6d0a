"""Datasets of what lower rooms computed: with case, scales, units and provenance.

dataset = sweep_dataset(case, [cold, up, down])
save(dataset, "sweep.nc");  load("sweep.nc")
"""

from .axis import Axis
from .compare import coexisting, same_motion
from .dataset import sweep_dataset
from .digest import content_hash
from .plane import CERTIFICATES, NO_LABEL, STATUSES, PlaneMap
from .plane_dataset import plane_dataset
from .point import Point, blank, not_computed
from .provenance import provenance
from .store import load, save
from .sweep import Direction, Sweep
from .table import table

__all__ = [
    "CERTIFICATES",
    "NO_LABEL",
    "STATUSES",
    "Axis",
    "Direction",
    "PlaneMap",
    "Point",
    "Sweep",
    "blank",
    "coexisting",
    "content_hash",
    "load",
    "not_computed",
    "plane_dataset",
    "provenance",
    "same_motion",
    "save",
    "sweep_dataset",
    "table",
]
