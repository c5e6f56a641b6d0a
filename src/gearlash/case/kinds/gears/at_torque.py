"""Stiffness of a mesh, and the error that its flanks make under load, at any torque."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from math import copysign

import numpy as np

from gearlash.gears.drawing import Drawing, Estimate
from gearlash.gears.estimates import estimates
from gearlash.gears.loaded_mesh import LoadedMesh
from gearlash.gears.mesh import harmonic_count, harmonic_name, series
from gearlash.gears.stiffness_estimates import loaded_mesh
from gearlash.system import Fourier

from .rules import EntriesByKey
from .shared import HIGHEST_HARMONIC

MEAN = "mesh.mean_stiffness"


@dataclass(frozen=True)
class MeshAt:
    """What a mesh cycle has at one torque.

    Parameters
    ----------
    mean : float
        Mean stiffness, N/m.
    shape : ndarray
        Stiffness over its mean, [1, c1, s1, …], without that of a curve.
    relief : ndarray
        Error of flanks that are modified or touch beyond the path of contact, [0, c1, s1, …], m.
    """

    mean: float
    shape: Fourier
    relief: Fourier


def loaded_of(drawing: Drawing | None, entries: EntriesByKey) -> LoadedMesh | None:
    """The mesh under the torque of a drawing, where its contact lines are those of the model: flanks are
    modified, or the variation of the stiffness is estimated from them at a torque that is known."""
    if drawing is None or not (drawing.modification.modified or (drawing.torque and varies(entries))):
        return None
    return loaded_mesh(drawing)


def varies(entries: EntriesByKey) -> bool:
    """Is a harmonic of the stiffness estimated?"""
    return any(
        each.estimated for key, each in entries.items() if key.startswith("ripple") and "phase" not in key
    )


def relief_error(drawing: Drawing | None, entries: EntriesByKey) -> Fourier | None:
    """The error that belongs to the contact lines under load at the torque of a drawing, m: what relief,
    crowning and contact beyond the path of contact make. What flanks lack lets the gear fall behind; under a
    negative torque their back sides bear, and it runs ahead. None where the lines are not those of the
    model."""
    found = loaded_of(drawing, entries)
    if found is None or drawing is None:
        return None
    return copysign(1.0, drawing.torque or 0.0) * found.error_series(HIGHEST_HARMONIC)


def mesh_at(entries: EntriesByKey, drawing: Drawing | None, torque: float) -> MeshAt:
    """Stiffness and error at a torque of the pinion, N·m: what is estimated is estimated for it."""
    mean, shape = entries[MEAN].number, named_stiffness(entries)
    if drawing is None:
        return MeshAt(mean, shape, np.zeros(3))
    there = replace(drawing, torque=torque)
    if entries[MEAN].estimated:
        mean = _estimated(there, "mean_stiffness")["mean_stiffness"].value
    if varies(entries):
        values = {name: one.value for name, one in _estimated(there, "ripple").items()}
        shape = _series({_renamed(name): value for name, value in values.items()})
    error = relief_error(there, entries)
    return MeshAt(mean, shape, np.zeros(3) if error is None else error)


@lru_cache(maxsize=64)
def _estimated(drawing: Drawing, name: str) -> Mapping[str, Estimate]:
    return estimates(drawing, HIGHEST_HARMONIC, (name,))


def _renamed(name: str) -> str:
    """``ripple_1`` as ``ripple``: the first harmonic has no number where a family names it."""
    return name.removesuffix("_1")


def named_stiffness(entries: EntriesByKey) -> Fourier:
    """1 and the ripples that are named."""
    return _series({key: entry.number for key, entry in entries.items() if key.startswith("ripple")})


def _series(values: Mapping[str, float]) -> Fourier:
    count = harmonic_count(values, "ripple")
    names = [harmonic_name(stem, n) for n in range(1, count + 1) for stem in ("ripple", "ripple_phase")]
    return series({name: values.get(name, 0.0) for name in names}, "ripple", 1.0, count)
