"""Special points of families of orbits, and the way from one to the next. Continuation in arclength and
two-parameter curves have their place here too."""

from .bifurcation import BifurcationPoint, locate_multiplier
from .grazing import GrazingPoint, locate_grazing
from .kinds import CODIMENSION_TWO, SMOOTH, STANDARD, table2_type
from .node import Node
from .sides import NONE
from .walk import End, Met, Outcome, joins, walk

__all__ = [
    "CODIMENSION_TWO",
    "NONE",
    "SMOOTH",
    "STANDARD",
    "BifurcationPoint",
    "End",
    "GrazingPoint",
    "Met",
    "Node",
    "Outcome",
    "joins",
    "locate_grazing",
    "locate_multiplier",
    "table2_type",
    "walk",
]
