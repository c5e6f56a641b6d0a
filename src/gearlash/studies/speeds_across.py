"""Where teeth part over the range of speed that a case states, with an estimate at an end of its range."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import ceil, inf, isnan, log

import numpy as np

from gearlash.case import Case
from gearlash.results.tolerance import Band
from gearlash.system import GearlashError

from .impact_free import ClosedMesh
from .tolerances.bands import outside, positive_bands

STEP = 1.08
"""From one speed to the next; where the margin is least of three a closer look finds what lies between."""
NEAR = 0.8
"""Of the static compression: closer looks are had below it. A resonance with a damping ratio of 0.01 that
takes all of it half-way between two speeds takes a quarter of it at both."""


@dataclass(frozen=True)
class SpeedsAcross:
    """Values of ranges, all others as the case has them, and speeds at which contact does not last with them.

    Parameters
    ----------
    values : mapping of str to str
        By path, with the unit.
    parting : tuple of (float, float)
        Intervals of ω of the case, within the stated range, in which no stable motion exists whose teeth
        never part. The whole range where no pair can have these values.
    least : float
        The least compression over the static one at the speeds that were looked at.
    """

    values: Mapping[str, str]
    parting: tuple[Band, ...]
    least: float


def speeds_across(case: Case, values: Mapping[str, str], reach: tuple[float, float]) -> SpeedsAcross:
    """Speeds of the case within ``reach`` (ω) at which the motion of teeth that never part ends."""
    low, high = reach
    try:
        member = case.with_overrides(values) if values else case
        family = member.family()[0]
    except GearlashError:  # no pair can have these values
        return SpeedsAcross(values, (reach,), -inf)
    parameters = family.complete({})
    unit = case.family()[0].defaults["omega"] / parameters["omega"]  # what an ω of the member is of the case
    static = parameters["load"] / parameters["rotation_factor"]
    closed = ClosedMesh(family, parameters, 1 if static > 0.0 else -1)
    looked: dict[float, float] = {}

    def margin(at: float) -> float:
        if at not in looked:
            looked[at] = closed.margin(at / unit) / abs(static)
        return looked[at]

    speeds = np.geomspace(low, high, max(ceil(log(high / low) / log(STEP)), 1) + 1)
    free = positive_bands(margin, speeds.tolist(), NEAR)
    known = [found for found in looked.values() if not isnan(found)]
    return SpeedsAcross(values, outside([free], low, high), min(known, default=-inf))
