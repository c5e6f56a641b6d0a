"""Says beforehand what will take long: a system whose period is many cells."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product
from typing import TYPE_CHECKING

from gearlash.system import Family, GearlashError

from .terminal import tell

if TYPE_CHECKING:
    from .inputs import Over

MANY = 100e6  # bytes of tables, which take about 0.1 s to build: a hundred times what is usual


def tell_if_slow(family: Family, *members: Mapping[str, float]) -> None:
    """One line on standard error about the slowest of these members of the family, where it is slow. What
    cannot be computed at all is no matter here: it is refused where it is computed."""
    from gearlash.flow.budget import cause, load, size_text

    slowest = 0.0, ""
    for values in members:
        try:
            system = family.system(values)
            cells, size = load(system)
            if size > max(slowest[0], MANY):
                words = f"slow: {cells:,} cells a period, {size_text(size)} of tables"
                slowest = size, f"{words} ({cause(system, cells)})"
        except GearlashError:
            continue
    if slowest[0]:
        tell(slowest[1])


def ends(*axes: Over) -> list[dict[str, float]]:
    """The corners of the interval or plane that these parameters are varied in."""
    pairs = [[(axis.short, float(axis.values[i])) for i in (0, -1)] for axis in axes]
    return [dict(corner) for corner in product(*pairs)]
