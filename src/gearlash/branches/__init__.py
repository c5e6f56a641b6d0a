"""Special points of families of orbits, and the way of a stable orbit from one to the next.

Whole branches, stable or not, are followed in `branches.continuation`."""

from .bifurcation import BifurcationPoint, locate_multiplier
from .ending import Outcome, SolvedPoint
from .follow import Passage, PathEnd, follow, joins
from .grazing import locate_grazing
from .grazing_point import GrazingPoint
from .node import Node

__all__ = [
    "BifurcationPoint",
    "GrazingPoint",
    "Node",
    "Outcome",
    "Passage",
    "PathEnd",
    "SolvedPoint",
    "follow",
    "joins",
    "locate_grazing",
    "locate_multiplier",
]
