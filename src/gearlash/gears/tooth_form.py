"""Form of a tooth in its normal section: involute and the fillet that the tip of a rack cuts.

A helical tooth counts as one of its virtual spur gear, z_n teeth of module m_n. Coordinates from the centre
of that gear: y along the middle of the tooth, x its half thickness. Lengths in m, angles in rad.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .cylindrical_gear import CylindricalGear

Reals = NDArray[np.float64]


@dataclass(frozen=True)
class ToothForm:
    """Right side of a tooth of the virtual spur gear, from the foot to the tip.

    Parameters
    ----------
    base_radius : float
        r_bn, m.
    half_angle : float
        ψ_b, half the angle of the tooth on the base circle, rad.
    x, y : ndarray, shape (n,)
        m; y increases.

    Notes
    -----
    The foot is where the fillet leans 30° against the middle of the tooth, as in ISO 6336-3.
    """

    base_radius: float
    half_angle: float
    x: Reals
    y: Reals

    @property
    def foot_thickness(self) -> float:
        """s_Fn, m: chord at the foot."""
        return 2.0 * float(self.x[0])


def tooth_form(gear: CylindricalGear, points: int = 200) -> ToothForm:
    """The form of a gear's teeth, cut with its generating profile shift.

    Parameters
    ----------
    gear : CylindricalGear
    points : int
        On the fillet, and on the involute.

    Returns
    -------
    ToothForm

    Raises
    ------
    GearlashError
        For a tool tip that is rounded more than it is wide.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear
    >>> from gearlash.gears.tooth_form import tooth_form
    >>> form = tooth_form(CylindricalGear(30, 4e-3))
    >>> round(form.foot_thickness * 1e3, 2)  # 30° tangents
    8.26
    """
    fillet = gear.root_fillet
    radius, angle = fillet.at(np.linspace(0.0, fillet.end, points))
    start = float(radius[-1])
    tip = fillet.pitch_radius + 0.5 * (gear.tip_diameter - gear.reference_diameter)
    above = np.linspace(start, max(tip, start), points + 1)[1:]
    radius = np.concatenate([radius, above])
    angle = np.concatenate([angle, fillet.involute_angle(above)])
    x, y = _above_foot(radius * np.sin(angle), radius * np.cos(angle))
    return ToothForm(fillet.base_radius, fillet.base_half_angle, x, y)


def _above_foot(x: Reals, y: Reals) -> tuple[Reals, Reals]:
    """The part above the 30° tangent; of a tooth that is nowhere so flat, all of it."""
    lean = np.degrees(np.arctan2(-np.diff(x), np.diff(y)))
    flat = np.nonzero(lean[: len(x) // 2] > 30.0)[0]  # of the fillet
    first = int(flat[-1]) + 1 if len(flat) else 0
    return x[first:], y[first:]
