"""Special points of families of orbits. Continuation in arclength and two-parameter curves have their place
here too."""

from .bifurcation import BifurcationPoint, locate_multiplier
from .grazing import GrazingPoint, locate_grazing
from .kinds import CODIMENSION_TWO, SMOOTH, STANDARD, table2_type

__all__ = [
    "CODIMENSION_TWO",
    "SMOOTH",
    "STANDARD",
    "BifurcationPoint",
    "GrazingPoint",
    "locate_grazing",
    "locate_multiplier",
    "table2_type",
]
