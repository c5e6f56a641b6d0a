"""Special points of families of orbits, and the way of a stable orbit from one to the next.

Whole branches, stable or not, are followed in `branches.continuation`."""

from .bifurcation import BifurcationPoint, locate_multiplier
from .grazing import locate_grazing
from .grazing_point import GrazingPoint

__all__ = [
    "BifurcationPoint",
    "GrazingPoint",
    "locate_grazing",
    "locate_multiplier",
]
