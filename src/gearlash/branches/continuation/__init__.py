"""Branches of periodic orbits, stable or not, by pseudo-arclength continuation, with their special points."""

from .branch import Branch
from .derivative import DerivativeKind
from .extrema import Extremum
from .local_law import GrazingLaw, law_at
from .node import Node
from .points import BranchPoint, EndKind, EndOfBranch, SpecialKind, SpecialPoint
from .settings import ContinuationSettings
from .switching import Switched, switched
from .walk import Item, walk
from .whole import continue_orbit

__all__ = [
    "Branch",
    "BranchPoint",
    "ContinuationSettings",
    "DerivativeKind",
    "EndKind",
    "EndOfBranch",
    "Extremum",
    "GrazingLaw",
    "Item",
    "Node",
    "SpecialKind",
    "SpecialPoint",
    "Switched",
    "continue_orbit",
    "law_at",
    "switched",
    "walk",
]
