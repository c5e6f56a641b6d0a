"""The mean stiffness that a curve of stiffness has."""

from __future__ import annotations

from gearlash.case.entries import Entries, Entry
from gearlash.case.errors import Problem
from gearlash.case.stated import Provenance

from .curves import TABLE
from .excitation import Curves, mean_of
from .places import Places

KEY = "mesh.mean_stiffness"
REASON = f"mean of {TABLE}.stiffness"


def with_mean_stiffness(places: Places, entries: Entries, curves: Curves) -> tuple[Entries, list[Problem]]:
    """The entries with it, where the curve has a unit; stated twice is a problem."""
    stated = curves.get("stiffness")
    if stated is None or not stated["physical"]:
        return entries, []
    if KEY in entries:
        expected = f"nothing here: {TABLE}.stiffness has a unit, and with it a mean"
        return entries, [Problem(KEY, repr(entries[KEY].text), expected)]
    mean = mean_of(stated)
    place = places.quantities[KEY]
    if not place.accepts(mean):
        return entries, [Problem(f"{TABLE}.stiffness", f"mean {mean:.6g} N/m", place.expected_in_range)]
    because = f"{REASON}; {stated['reason']}" if stated["reason"] else REASON
    entry = Entry(KEY, KEY, mean, f"{mean!r} N/m", Provenance(stated["provenance"]), because)
    return {**entries, KEY: entry}, []
