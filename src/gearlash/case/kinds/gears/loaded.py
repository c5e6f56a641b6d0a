"""A transmission error measured or computed under load: what of it the stiffness makes is taken out.

The model has two excitations, the varying stiffness and the error without load. A static error under load has
both in it, δ = F/K + e: beside a varying stiffness it would count that twice. So it has words of its own, and
e = δ − F/K is what the model gets.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

import numpy as np

from gearlash.case.entries import Entry
from gearlash.case.errors import Problem
from gearlash.case.quantity import Quantity
from gearlash.case.stated import Provenance
from gearlash.case.units import ANGLE, LENGTH, TORQUE
from gearlash.gears.drawing import Drawing
from gearlash.gears.mesh import harmonic_name
from gearlash.gears.waveform import unloaded_error_of
from gearlash.system import cosines, evaluate

from .at_torque import mesh_at
from .drawn import ERRORS
from .excitation import Curves
from .numbers import geometry_of, line_of
from .rules import EntriesByKey, PairRules
from .shared import HIGHEST_HARMONIC

STEM = "mesh.loaded_error"
AT = "mesh.loaded_error_torque"
ORDERS = range(1, HIGHEST_HARMONIC + 1)
AMPLITUDES = tuple(harmonic_name(STEM, n) for n in ORDERS)
PHASES = tuple(harmonic_name(f"{STEM}_phase", n) for n in ORDERS)
POINTS = 720
TWICE = (
    "no error beside it: a loaded error holds the part that the stiffness makes, and the model has that "
    "already"
)


def is_loaded(entries: EntriesByKey) -> bool:
    """Is an error under load stated?"""
    return not entries.keys().isdisjoint(AMPLITUDES)


def unloaded(
    rules: PairRules, entries: EntriesByKey, curves: Curves, drawing: Drawing | None = None
) -> tuple[EntriesByKey, list[Problem]]:
    """The entries with the error that is left of a loaded one."""
    if not is_loaded(entries):
        return entries, list(_alone(entries))
    problems = list(_refused(rules, entries, curves))
    if problems or "mesh.mean_stiffness" not in entries:
        return entries, problems
    line = line_of(rules, entries, geometry_of(rules, entries))
    assert line is not None  # refused otherwise
    force = entries[AT].number / (line.radii[0] * line.c_t)
    theta = 2.0 * pi * np.arange(POINTS) / POINTS
    amplitudes, phases = ([_number(entries, key) for key in keys] for keys in (AMPLITUDES, PHASES))
    loaded = evaluate(cosines(0.0, amplitudes, phases), theta)
    mesh = mesh_at(entries, drawing, entries[AT].number)
    own = loaded - evaluate(mesh.relief, theta)
    left = unloaded_error_of(own, mesh.mean * evaluate(mesh.shape, theta), force)
    found = np.fft.rfft(left)[1 : HIGHEST_HARMONIC + 1] * 2.0 / POINTS
    made = np.ptp(loaded - left)
    makes = "the stiffness makes" if not np.any(mesh.relief) else "stiffness and contact under load make"
    reason = f"what is left of the loaded error without the {made * 1e6:.3g} µm that {makes}"
    return {**entries, **{e.key: e for e in _entries(found, reason)}}, []


def _alone(entries: EntriesByKey) -> Iterator[Problem]:
    """Words of a loaded error that is not there."""
    for key in (AT, *PHASES):
        if key in entries:
            yield Problem(STEM, None, f"the amplitude that {entries[key].path} belongs to", missing=True)
            return


def _number(entries: EntriesByKey, key: str) -> float:
    return entries[key].number if key in entries else 0.0


def _entries(found: np.ndarray, reason: str) -> Iterator[Entry]:
    for order, value in enumerate(found, start=1):
        for stem, number in (("error", abs(value)), ("error_phase", float(np.angle(value)))):
            name = harmonic_name(stem, order)
            yield Entry(name, f"mesh.{name}", float(number), "", Provenance.INFERRED, reason)


def _refused(rules: PairRules, entries: EntriesByKey, curves: Curves) -> Iterator[Problem]:
    """Why the stiffness cannot be taken out."""
    first = next(key for key in AMPLITUDES if key in entries)
    text = repr(entries[first].text)
    if "error" in curves or not ERRORS.isdisjoint(entries):
        yield Problem(first, text, TWICE)
    if "stiffness" in curves:
        yield Problem(first, text, 'an error curve with state = "loaded", as the stiffness is a curve')
    if AT not in entries:
        example = quantities_by_path()[AT].example
        yield Problem(AT, None, f'the pinion torque it was found at, such as "{example}"', missing=True)
    elif entries[AT].number == 0.0:
        yield Problem(AT, repr(entries[AT].text), "a torque other than 0: without load nothing is loaded")
    if line_of(rules, entries, geometry_of(rules, entries)) is None:
        yield Problem(first, text, "an unloaded error (mesh.error): without radii no torque is a force")


def quantities() -> Iterator[Quantity]:
    """What the table [mesh] may hold of it."""
    for n, (amplitude, phase) in enumerate(zip(AMPLITUDES, PHASES, strict=True), start=1):
        what = f"zero-to-peak transmission error under load, mesh harmonic {n}"
        yield Quantity(amplitude, LENGTH, "um", "8 um", what, -0.01, 0.01)
        what = f"phase of the cosine of that harmonic ({n})"
        yield Quantity(phase, ANGLE, "deg", "90 deg", what, -100.0, 100.0)
    yield Quantity(AT, TORQUE, "N*m", "150 N·m", "pinion torque of the loaded error", -1e9, 1e9)


def quantities_by_path() -> dict[str, Quantity]:
    """The same by path."""
    return {each.path: each for each in quantities()}
