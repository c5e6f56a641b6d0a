"""Branches of periodic orbits, stable or not, by pseudo-arclength continuation, with their special points."""

from .points import Branch, BranchEnd, BranchPoint, Ending, Kind, SpecialPoint
from .settings import ContinuationSettings
from .switching import Switched, switched
from .whole import continue_orbit

__all__ = [
    "Branch",
    "BranchEnd",
    "BranchPoint",
    "ContinuationSettings",
    "Ending",
    "Kind",
    "SpecialPoint",
    "Switched",
    "continue_orbit",
    "switched",
]
