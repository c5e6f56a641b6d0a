"""The second scale along an axis of a figure: in the unit in which its parameter was asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING

from gearlash.case.units import pretty

if TYPE_CHECKING:
    from gearlash.plots import Twin

    from .answers.asked import Asked
    from .answers.branch_parts import LimitsUsed
    from .answers.sweep import AxisUsed


def second_scale(asked: Asked, rests: bool = False) -> Twin | None:
    """None where there is no unit; ``rests``: on assumed values, which it says."""
    from gearlash.plots import Twin

    return Twin(asked.factor, asked.title, pretty(asked.unit), rests) if asked.unit else None


def scale_of(axis: AxisUsed | LimitsUsed) -> Twin | None:
    """Of an axis or of limits as an answer has them."""
    rests = any(each.rests_on for each in axis.physical_lower if each.name == axis.asked.name)
    return second_scale(axis.asked, rests)
