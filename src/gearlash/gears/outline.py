"""The outline of a gear in the transverse section: true involutes, fillets, tip and root circles.

Angles are counted from the middle of a tooth. The fillet is that of the virtual spur gear, turned into the
transverse section (its width over cos β, its height as it is) and fitted to where the involute starts.
"""

from __future__ import annotations

from math import cos, pi

import numpy as np
from numpy.typing import NDArray

from .cylindrical_gear import CylindricalGear

Reals = NDArray[np.float64]
POINTS = 24
"""Of each involute and each fillet."""


def half_tooth(gear: CylindricalGear, thinner: float = 0.0) -> tuple[Reals, Reals]:
    """One flank from the middle of the space to the tip.

    Parameters
    ----------
    gear : CylindricalGear
    thinner : float
        By which angle each half of a tooth is thinner than the gear's, rad.

    Returns
    -------
    (ndarray, ndarray)
        Radius, m, rising from the root circle to the tip circle, and angle from the middle of the tooth, rad.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear
    >>> from gearlash.gears.outline import half_tooth
    >>> radius, angle = half_tooth(CylindricalGear(30, 4e-3))
    >>> (radius[[0, -1]] * 1e3).round(2).tolist()  # root and tip
    [55.0, 64.0]
    """
    start = max(gear.root_form_diameter, gear.base_diameter)
    diameters = np.linspace(start, max(gear.tip_diameter, start), POINTS)
    flank = np.array([max(gear.transverse_thickness(float(d)), 0.0) / d for d in diameters])
    fillet = gear.root_fillet
    radius, angle = fillet.at(np.linspace(0.0, fillet.end, POINTS))
    width = radius * angle / cos(gear.helix_angle)
    root = radius - fillet.pitch_radius + 0.5 * gear.reference_diameter
    below = root < 0.5 * start
    turned = width / root
    turned = turned * (flank[0] / turned[-1])
    radii = np.append(root[below], 0.5 * diameters)
    return radii, np.clip(np.append(turned[below], flank) - thinner, 0.0, pi / gear.teeth)


def outline(gear: CylindricalGear, middle: float = 0.0, thinner: float = 0.0) -> tuple[Reals, Reals]:
    """The whole outline of a gear about its axis.

    Parameters
    ----------
    gear : CylindricalGear
    middle : float
        Direction of the middle of one tooth, rad from the x axis.
    thinner : float
        As of `half_tooth`.

    Returns
    -------
    (ndarray, ndarray)
        x and y, m; closed.

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash.gears import CylindricalGear
    >>> from gearlash.gears.outline import outline
    >>> x, y = outline(CylindricalGear(30, 4e-3))
    >>> round(float(np.hypot(x, y).max()) * 1e3, 6)
    64.0
    """
    radius, angle = half_tooth(gear, thinner)
    tip = np.linspace(-angle[-1], angle[-1], 7)[1:-1]
    radii = np.concatenate([radius, np.full(len(tip), radius[-1]), radius[::-1]])
    angles = np.concatenate([-angle, tip, angle[::-1]])
    teeth = middle + 2.0 * pi * np.arange(gear.teeth) / gear.teeth
    around = (teeth[:, None] + angles[None, :]).ravel()
    all_radii = np.tile(radii, gear.teeth)
    return (
        np.append(all_radii * np.cos(around), all_radii[0] * np.cos(around[0])),
        np.append(all_radii * np.sin(around), all_radii[0] * np.sin(around[0])),
    )
