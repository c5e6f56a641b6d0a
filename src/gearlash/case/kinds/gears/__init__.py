"""What all kinds of gear pair share: the table of their quantities, and what follows from them."""

from .kind import GearKind
from .places import Places
from .records import Numbers
from .rules import PairRules

__all__ = ["GearKind", "Numbers", "PairRules", "Places"]
