"""Cases of kind ``helical-pair``: rotation, lateral and axial motion of two gears in bearings."""

from gearlash.case.kinds.gears import GearKind

from .rules import HelicalRules

KIND = GearKind(HelicalRules())

__all__ = ["KIND"]
