"""Contact beyond the path of contact: the corner at a tip, before its flank touches and after it has left.

Teeth that bend let the next pair touch early and the last one leave late. There the corner at the tip of one
tooth touches the flank of its mate, off the line of action, as soon as the pair has given way by the gap that
the corner leaves.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .cylindrical_pair import CylindricalPair

Reals = NDArray[np.float64]


def tip_corner_gap(pair: CylindricalPair, which: int, beyond: ArrayLike) -> Reals:
    """Gap that a tip corner leaves to the mate's flank beyond the end of its own.

    Parameters
    ----------
    pair : CylindricalPair
    which : int
        Whose tip: 0 pinion, 1 gear.
    beyond : array_like
        e, m: how far the pair has rolled beyond the end of the flank, on the line of action, in the
        transverse section; at least 0.

    Returns
    -------
    ndarray
        m, in the transverse section, where the mate's flank is reached along its own normal; both turning as
        flanks without gap would. Exact, for flanks that go on below.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> from gearlash.gears.tip_corner import tip_corner_gap
    >>> pair = CylindricalPair(CylindricalGear(25, 2e-3), CylindricalGear(57, 2e-3), face_width=0.02)
    >>> (tip_corner_gap(pair, 0, [0.0, 5e-4, 1e-3]) * 1e6).round(1).tolist()  # µm
    [0.0, 5.9, 24.3]
    """
    e, angle = np.asarray(beyond, dtype=float), pair.working_pressure_angle
    gear, other = pair.gears[which], pair.gears[1 - which]
    own, mate = 0.5 * gear.base_diameter, 0.5 * other.base_diameter
    roll = gear.roll_length(gear.tip_form_diameter)
    turned = np.arctan2(roll, own) - angle + e / own
    tip = np.hypot(roll, own)
    across, along = pair.centre_distance - tip * np.cos(turned), -tip * np.sin(turned)
    pressure = np.arccos(np.minimum(mate / np.hypot(across, along), 1.0))
    begins = np.arctan2(along, across) + np.tan(pressure) - pressure
    return mate * (begins + angle) - (pair.tangent_length - roll - e)
