"""What a gear pair lacks, and what in it contradicts what else it states."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator
from math import pi

import numpy as np

from gearlash.case.entries import Entry
from gearlash.case.errors import Problem
from gearlash.gears.mesh import harmonic_count, series
from gearlash.system import evaluate

from .curve_checks import about_curves
from .drawn import GEAR_RANGE, SPEED_RANGE, rivals
from .excitation import Curves
from .keys import REFERENCE
from .places import stated_paths
from .rules import EntriesByKey, PairRules

ESTIMATED = "; with teeth, module and angles stated, pinion.material and gear.material let it be estimated"


def missing(rules: PairRules, entries: EntriesByKey, present: Collection[str] = ()) -> list[Problem]:
    """Quantities that must be stated and are not; ``present`` are paths known to be stated, if wrongly.

    A file that states nothing at all is taken for a physical one.
    """
    places, paths = rules.places.quantities, [*stated_paths(entries), *present]
    known = {*entries, *(places[path].key for path in present if path in places)}
    physical = rules.places.physical(paths) or not any(path.startswith("dimensionless.") for path in paths)
    problems = []
    for key in (*_required(entries, physical), *rules.required(entries, physical, known)):
        if key in known or not known.isdisjoint(rivals(key)):
            continue  # stated, or said in other words that are at fault themselves
        ways = rules.places.two_way.get(key, (key,))
        place = places[ways[0]]
        other = f" (or {', '.join(ways[1:])})" if len(ways) > 1 else ""
        why = "; there is no backlash to take half of" if key == REFERENCE else ""
        why = ESTIMATED if key == "mesh.mean_stiffness" else why
        problems.append(Problem(place.path, None, f"{place.expected}{other}{why}", missing=True))
    return problems


def _required(entries: EntriesByKey, physical: bool) -> Iterator[str]:
    yield from ("omega", "D", "load", "mesh_damping")
    if physical:
        yield from ("mesh.mean_stiffness", "pinion.teeth")
        if "D" in entries:
            yield REFERENCE


def contradictions(rules: PairRules, entries: EntriesByKey, curves: Curves) -> list[Problem]:
    """Quantities stated although others determine them, and values that no gear pair can have together."""
    problems = []
    if rules.places.physical(stated_paths(entries)):
        for key, because in rules.redundant(entries):
            entry = entries[key]
            problems.append(Problem(entry.path, repr(entry.text), f"nothing here: {because}"))
    problems += about_curves(rules, entries, curves)
    problems += _speed_range(entries)
    ripples = {
        k: e.number
        for k, e in entries.items()
        if re.fullmatch(r"ripple(_phase)?(_\d)?", k) and isinstance(e.value, float)
    }
    if _least_stiffness(ripples) < 0.0:
        entry = entries[next(k for k in sorted(ripples) if "phase" not in k)]
        expected = "ripples that leave the mesh stiffness positive all round a mesh cycle"
        problems.append(Problem(entry.path, repr(entry.text), expected))
    return problems


def _speed_range(entries: EntriesByKey) -> Iterator[Problem]:
    """A range of speed has two ends, the least one first."""
    for paths in (SPEED_RANGE, GEAR_RANGE):
        stated = [entries[path] for path in paths if path in entries]
        yield from _both_ends(
            [entry for entry in stated if entry.text], paths
        )  # not what follows from others


def _both_ends(stated: list[Entry], paths: tuple[str, str]) -> Iterator[Problem]:
    if len(stated) == 1:
        other = next(path for path in paths if path != stated[0].path)
        yield Problem(stated[0].path, repr(stated[0].text), f"{other} beside it, the other end of the range")
    if len(stated) == 2 and not stated[0].number < stated[1].number:
        yield Problem(stated[1].path, repr(stated[1].text), f"more than {stated[0].path} = {stated[0].text}")


def _least_stiffness(ripples: dict[str, float]) -> float:
    count = harmonic_count(ripples, "ripple")
    stems = ("ripple", "ripple_phase")
    names = [f"{stem}_{n}" if n > 1 else stem for n in range(1, count + 1) for stem in stems]
    full = {name: ripples.get(name, 0.0) for name in names}
    return float(np.min(evaluate(series(full, "ripple", 1.0, count), np.linspace(0.0, 2.0 * pi, 721))))
