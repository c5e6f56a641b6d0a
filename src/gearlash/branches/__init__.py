"""A grazing, doubling or fold, solved for from an orbit near it.

Orbits are followed in `branches.continuation`."""

from .bifurcation import BifurcationPoint, locate_multiplier
from .grazing import locate_grazing
from .grazing_point import GrazingPoint

__all__ = [
    "BifurcationPoint",
    "GrazingPoint",
    "locate_grazing",
    "locate_multiplier",
]
