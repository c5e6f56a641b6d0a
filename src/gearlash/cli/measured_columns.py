"""What is measured on a pair at every point of a sweep, as further columns of its table."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from gearlash.case import Case
from gearlash.jobs import Execution
from gearlash.results.columns import Column
from gearlash.results.pair_units import PairUnits
from gearlash.studies.measured import measured, readouts_of

if TYPE_CHECKING:
    from gearlash.orbits.signals import Signal
    from gearlash.results import Sweep

FIGURES = {"peak": "largest modulus", "peak_to_peak": "peak to peak", "rms": "rms about the mean"}


def measured_columns(case: Case, sweeps: Sequence[Sweep]) -> list[Column]:
    """Bearing forces and transmission error of every point of every sweep, one sweep after the other; none of
    what is no gear pair."""
    if not case.between_teeth:
        return []
    units, (table, _) = PairUnits.of(case), measured(case, sweeps, Execution())
    rows = [one for way in table for one in way]
    found: list[Column] = []
    for i, what in enumerate(readouts_of(case, case.family()[0].complete())):
        unit = units.force if what.quantity == "force" else units.length
        signals = [None if one is None else one.read[i] for one in rows]
        for figure, words in FIGURES.items():
            values = [_figure(each, figure, unit.factor) for each in signals]
            found.append(Column(f"{what.name}_{figure}", values, unit.name, f"{what.words}, {words}"))
    return found


def _figure(signal: Signal | None, name: str, factor: float) -> float:
    return np.nan if signal is None else factor * float(getattr(signal, name))
