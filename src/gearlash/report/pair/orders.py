"""Orders of the mesh frequency that excite a pair, and speeds at which they meet its natural frequencies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from gearlash.case import Case
from gearlash.studies.bands import Band

from .words import Words

LEAST = 3
"""Orders that are shown whether they excite or not."""
MOST = 8
"""Orders beyond are not looked for."""
SMALL = 1e-3
"""Of the mean stiffness, or of the static force: a harmonic below it does not count."""
NAMED = 3
"""Meetings within a band that a sentence names."""


@dataclass(frozen=True)
class Meeting:
    """A speed ω at which ``order`` times the mesh frequency is natural frequency ``mode``, from 1."""

    mode: int
    order: int
    omega: float

    @property
    def text(self) -> str:
        """``f1``, ``f1/4``: order 4 meets f1."""
        return f"f{self.mode}" if self.order == 1 else f"f{self.mode}/{self.order}"


def natural_frequencies(case: Case) -> list[float]:
    """Of the closed mesh, over ω_n."""
    stem = "derived.natural_frequency_"
    return [
        float(value.value)
        for value in case.values()
        if value.path.startswith(stem) and value.path.removeprefix(stem).isdigit()
    ]


def exciting(case: Case) -> tuple[int, ...]:
    """Orders of one mesh cycle of which the stiffness, the forcing or the error of the case has a part."""
    system = case.family()[0].system()
    clearance, cycles = system.clearances[0], system.cycles
    series = [clearance.stiffness_plus, clearance.stiffness_minus, *system.forcing, clearance.offset]
    found: set[int] = set()
    for row in series:
        heights = np.hypot(row[1::2], row[2::2])
        least = SMALL * (abs(float(row[0])) or float(heights.max(initial=0.0)))
        found |= {int(k) + 1 for k in np.flatnonzero(heights > least)}
    return tuple(sorted(k // cycles for k in found if k % cycles == 0 and k // cycles <= MOST))


def meetings(case: Case, low: float, high: float) -> tuple[Meeting, ...]:
    """Where one of the first orders, or a higher one that excites, meets a natural frequency between two
    speeds ω, in ascending order."""
    orders = sorted({*range(1, LEAST + 1), *exciting(case)})
    found = [
        Meeting(mode, order, frequency / order)
        for mode, frequency in enumerate(natural_frequencies(case), start=1)
        for order in orders
        if low < frequency / order < high
    ]
    return tuple(sorted(found, key=lambda one: one.omega))


def meetings_within(case: Case, bands: Sequence[Band], words: Words) -> str:
    """What meets in bands in which teeth separate: a sentence, or nothing."""
    excited = exciting(case)
    met = {
        one
        for band in bands
        for one in meetings(case, band.lower.value, band.upper.value)
        if one.order in excited
    }
    first = sorted(met, key=lambda one: (one.order, one.mode))
    if not first:
        return ""
    said = [
        f"order {one.order} of the mesh meets natural frequency {one.mode} at {words.speed(one.omega)}"
        for one in first[:NAMED]
    ]
    more = len(first) - len(said)
    return f" There {', '.join(said)}" + (f", and {more} more of them" if more else "") + "."
