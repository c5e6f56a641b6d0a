"""A compliance in place of finite elements: teeth that bend along the face, on a rim that they share."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.gears import CylindricalGear, CylindricalPair

Reals = NDArray[np.float64]


@dataclass(frozen=True)
class Standin:
    roll: Reals
    axial: Reals
    influence: Reals
    depth: float


def standin(gear: CylindricalGear, width: float, single: float = 1.6e10, slope: float = 1.0) -> Standin:
    """Teeth whose stiffness for a load spread over the face is about ``single`` N/m²; softer to the tip."""
    low = gear.roll_length(max(gear.root_form_diameter, gear.base_diameter))
    roll = np.linspace(low, gear.roll_length(gear.tip_diameter), 7)
    axial = np.linspace(-0.5 * width, 0.5 * width, 9)
    lever = 1.0 + slope * (roll - roll.mean()) / (roll[-1] - roll[0])
    spread = 2.0 * gear.normal_module
    near = np.exp(-np.hypot(axial[:, None] - axial[None, :], 0.3 * spread) / spread) / (2.0 * spread)
    tooth = np.einsum("i,j,kl->ikjl", lever, lever, near).reshape(len(roll) * 9, -1) / single
    rim = 0.1 / (single * width) * np.exp(-np.abs(axial[:, None] - axial[None, :]) / (4.0 * spread))
    rim = np.einsum("i,j,kl->ikjl", np.ones(7), np.ones(7), rim).reshape(tooth.shape)
    return Standin(roll, axial, np.array([rim, tooth + rim, rim]), 0.5 * gear.normal_module)


def standins(
    pair: CylindricalPair, widths: tuple[float, float], materials: object = None
) -> tuple[Standin, Standin]:
    """Of both gears, in place of `gearlash.multibody.compliance.pair_compliances`."""
    return standin(pair.pinion, widths[0]), standin(pair.gear, widths[1])
