"""Phases that nobody states of harmonics whose phase matters: assumed, and not taken for 0 in silence."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

from gearlash.case.entries import Entry
from gearlash.case.stated import Provenance
from gearlash.gears.mesh import harmonic_name

from .excitation import Curves
from .rules import EntriesByKey
from .shared import HIGHEST_HARMONIC

REASON = "not stated: 0, and the motion depends on it"
STEMS = ("ripple", "error", "mesh.loaded_error")
"""The first one that is there is what the phases of all others are counted from."""


def assumed_phases(entries: EntriesByKey, curves: Curves) -> Iterator[Entry]:
    """Phases of stated amplitudes, as long as a harmonic, a curve or a run-out is there to differ in phase
    from."""
    orders = range(1, HIGHEST_HARMONIC + 1)
    names = [(stem, n) for n in orders for stem in STEMS]
    there = [(stem, n) for stem, n in names if _amplitude(entries, stem, n) != 0.0]
    if not curves and not any(f"{shaft}_runout" in entries for shaft in ("pinion", "gear")):
        there = there[1:]
    for stem, n in there:
        amplitude, key = harmonic_name(stem, n), harmonic_name(f"{stem}_phase", n)
        entry = entries[amplitude]
        if key not in entries and entry.text:
            table = entry.path.partition(".")[0]
            path = f"{table}.{key.rpartition('.')[2]}"
            yield Entry(key, path, 0.0, "", Provenance.ASSUMED, REASON, -pi, pi)


def _amplitude(entries: EntriesByKey, stem: str, order: int) -> float:
    entry = entries.get(harmonic_name(stem, order))
    return 0.0 if entry is None else entry.number
