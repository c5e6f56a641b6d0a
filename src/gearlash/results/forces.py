"""The sign of contact forces in stored sweeps.

In the library a contact force is Φ, positive where the drive side is compressed. The columns `drive_force`,
`back_force` and `back_release_force` of a sweep dataset hold −Φ, as their `long_name` says; files of all
versions have them so. The two functions here are the only place where the sign is turned."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def stored(force: Array) -> Array:
    """What a column holds of the contact force Φ."""
    return -force


def from_stored(column: Array) -> Array:
    """The contact force Φ of what a column holds."""
    return -column
