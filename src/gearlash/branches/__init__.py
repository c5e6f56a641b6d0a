"""Special points of families of orbits, and the way from one to the next. Continuation in arclength and
two-parameter curves have their place here too."""

from .bifurcation import BifurcationPoint, locate_multiplier
from .ending import Outcome, SpecialPoint
from .follow import BranchEnd, Passage, follow, joins
from .grazing import GrazingPoint, locate_grazing
from .node import Node

__all__ = [
    "BifurcationPoint",
    "BranchEnd",
    "GrazingPoint",
    "Node",
    "Outcome",
    "Passage",
    "SpecialPoint",
    "follow",
    "joins",
    "locate_grazing",
    "locate_multiplier",
]
