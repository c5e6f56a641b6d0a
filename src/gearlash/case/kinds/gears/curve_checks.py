"""What in curves and run-out of a gear pair contradicts what else it states."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from gearlash.case.errors import Problem
from gearlash.gears.excitation import SHAFTS, least
from gearlash.system import GearlashError

from .curves import LOADED, STEMS, TABLE
from .excitation import Curves, mean_of, reconstructed, teeth_of
from .places import stated_paths
from .rules import EntriesByKey, PairRules


def about_curves(rules: PairRules, entries: EntriesByKey, curves: Curves) -> list[Problem]:
    """Every problem of curves and run-out."""
    problems = [
        *_named_too(entries, curves),
        *_without(entries, curves),
        *_shafts(rules, entries, curves),
        *_loaded(rules, entries, curves),
    ]
    return problems or list(_negative(entries, curves))


def _named_too(entries: EntriesByKey, curves: Curves) -> Iterator[Problem]:
    """Harmonics beside a curve that has them already."""
    for name in curves:
        stem = STEMS[name]
        for key, entry in entries.items():
            stated = entry.text and entry.value != 0.0
            if key.startswith(stem) and not key.endswith("_scale") and stated:
                expected = f"nothing here: {TABLE}.{name} states the whole of it ({stem}_scale multiplies it)"
                yield Problem(entry.path, repr(entry.text), expected)


def _without(entries: EntriesByKey, curves: Curves) -> Iterator[Problem]:
    """What needs a curve, or a run-out, that is not there."""
    for name, stem in STEMS.items():
        entry = entries.get(f"{stem}_scale")
        if entry is not None and name not in curves:
            yield Problem(entry.path, repr(entry.text), f"nothing here: there is no {TABLE}.{name}")
    for shaft in SHAFTS:
        entry = entries.get(f"{shaft}_runout_phase")
        if entry is not None and f"{shaft}_runout" not in entries:
            yield Problem(entry.path, repr(entry.text), f"nothing here: there is no {shaft}.runout")


def _shafts(rules: PairRules, entries: EntriesByKey, curves: Curves) -> Iterator[Problem]:
    """Turns of a shaft whose teeth are not known."""
    teeth = teeth_of(entries)
    needs = {f"{TABLE}.{name}": str(curve["over"]).partition(" ")[0] for name, curve in curves.items()} | {
        entries[f"{shaft}_runout"].path: shaft for shaft in SHAFTS if f"{shaft}_runout" in entries
    }
    for path, shaft in needs.items():
        if shaft in SHAFTS and shaft not in teeth:
            place = rules.places.quantities[f"{shaft}.teeth"]
            expected = f"{place.expected}, as {path} repeats with that shaft"
            yield Problem(place.path, None, expected, missing=True)


def _loaded(rules: PairRules, entries: EntriesByKey, curves: Curves) -> Iterator[Problem]:
    """A loaded error whose stiffness part cannot be taken out, and lengths in a case that knows none."""
    error: Mapping[str, Any] = curves.get("error", {})
    physical = rules.places.physical(stated_paths(entries))
    if error.get("physical") and not physical:
        yield Problem(
            f"{TABLE}.error.unit", None, "no unit, as this case is given in dimensionless numbers only"
        )
    if error.get("state") != LOADED:
        return
    path = f"{TABLE}.error.state"
    if not error["physical"] or not physical:
        expected = (
            "unloaded: the stiffness part of a loaded error is taken out in N and m, which are not there"
        )
        yield Problem(path, repr(LOADED), expected)
    elif error["torque"] == 0.0:
        yield Problem(f"{TABLE}.error.torque", "0", "a torque other than 0: without load nothing is loaded")
    elif "stiffness" in curves and curves["stiffness"]["over"] not in ("mesh cycle", error["over"]):
        expected = f"unloaded: the stiffness over a {curves['stiffness']['over']} cannot be taken out of it"
        yield Problem(path, repr(LOADED), expected)


def _negative(entries: EntriesByKey, curves: Curves) -> Iterator[Problem]:
    """A stiffness that is not positive all round."""
    if "stiffness" not in curves:
        return
    path, stated = f"{TABLE}.stiffness", curves["stiffness"]
    if not mean_of(stated) > 0.0:
        yield Problem(path, f"mean {mean_of(stated):.6g}", "a mean above 0")
        return
    from gearlash.case.scales import Scales

    try:
        (curve,) = reconstructed({"stiffness": stated}, entries, Scales()).values()
    except GearlashError as error:
        yield Problem(path, None, str(error))
        return
    scale = entries["ripple_scale"].number if "ripple_scale" in entries else 1.0
    series = np.array(curve.series) * scale
    series[0] = 1.0
    low = least(series)
    if low < 0.0:
        expected = f"a curve whose {curve.harmonics} harmonics stay above 0"
        yield Problem(path, f"down to {low:.3g} of its mean", expected)
