"""Special points of families of orbits, and the way from one to the next. Continuation in arclength and
two-parameter curves have their place here too."""

from .bifurcation import BifurcationPoint, locate_multiplier
from .ending import Outcome, SolvedPoint
from .follow import Passage, PathEnd, follow, joins
from .grazing import GrazingPoint, locate_grazing
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
