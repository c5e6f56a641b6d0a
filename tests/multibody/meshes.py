"""Pairs of gears in contact, for tests: a helical one and a spur one, with a stand-in compliance."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from math import cos, radians
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash.gears import CylindricalGear, CylindricalPair
from gearlash.multibody.contact import MeshContact
from multibody.standin import Standin, standin

Reals = NDArray[np.float64]
ALLOWANCE = -50e-6


def helical(width: float = 0.065) -> CylindricalPair:
    """28 and 70 teeth of 4 mm, 18°."""
    pinion, gear = (CylindricalGear(z, 4e-3, radians(18.0)) for z in (28, 70))
    return _with_play(CylindricalPair(pinion, gear), width)


def spur(width: float = 0.02) -> CylindricalPair:
    """25 and 57 teeth of 2 mm."""
    return _with_play(CylindricalPair(CylindricalGear(25, 2e-3), CylindricalGear(57, 2e-3)), width)


def _with_play(pair: CylindricalPair, width: float) -> CylindricalPair:
    pinion, gear = (replace(one, thickness_allowance=ALLOWANCE) for one in pair.gears)
    return CylindricalPair(pinion, gear, pair.centre_distance, width)


PAIRS = {"helical": helical, "spur": spur}


@cache
def plain(name: str) -> MeshContact:
    """Perfect flanks, no damping."""
    return contact(PAIRS[name]())


def contact(
    pair: CylindricalPair, compliances: tuple[Standin, Standin] | None = None, **more: Any
) -> MeshContact:
    if compliances is None:
        first, second = (standin(gear, pair.face_width) for gear in pair.gears)
        compliances = first, second
    return MeshContact.of(pair, compliances, **more)


def pose(mesh: MeshContact, turn: float, approach: float) -> Reals:
    """The pinion turned, the gear turned so that all gaps of side 0 are less by ``approach`` (m)."""
    first, second = mesh.flanks.base_radii
    q = np.zeros(12)
    q[5] = turn
    q[11] = (approach / cos(mesh.flanks.base_helix) - first * turn) / second
    return q


def jolted(mesh: MeshContact, turn: float, approach: float, seed: int) -> Reals:
    """The same with axes displaced and tilted as bearings let them."""
    scale = np.array([5e-6, 5e-6, 5e-6, 5e-5, 5e-5, 0.0])
    move = np.random.default_rng(seed).normal(size=12) * np.tile(scale, 2)
    return pose(mesh, turn, approach) + move
