"""A grazing, doubling or fold, solved for from an orbit near it.

Orbits are followed in `branches.continuation`. What solves is imported when it is first used: whoever
follows orbits does without.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .bifurcation import BifurcationPoint, locate_multiplier
    from .grazing import locate_grazing
    from .grazing_point import GrazingPoint

__all__ = [
    "BifurcationPoint",
    "GrazingPoint",
    "locate_grazing",
    "locate_multiplier",
]


def __getattr__(name: str) -> Any:
    if name in ("BifurcationPoint", "locate_multiplier"):
        from . import bifurcation

        return getattr(bifurcation, name)
    if name == "locate_grazing":
        from . import grazing

        return grazing.locate_grazing
    if name == "GrazingPoint":
        from . import grazing_point

        return grazing_point.GrazingPoint
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
