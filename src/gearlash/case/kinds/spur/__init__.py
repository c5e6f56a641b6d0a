"""Cases of kind ``spur-1dof``: rotation of two gears along the line of action, and nothing else."""

from gearlash.case.kinds.gears import GearKind

from .rules import SpurRules

KIND = GearKind(SpurRules())

__all__ = ["KIND"]
