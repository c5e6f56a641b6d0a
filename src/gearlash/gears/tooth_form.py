"""Form of a tooth in its normal section: involute and the fillet that the tip of a rack cuts.

A helical tooth counts as one of its virtual spur gear, z_n teeth of module m_n. Coordinates from the centre
of that gear: y along the middle of the tooth, x its half thickness. Lengths in m, angles in rad.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi, tan

import numpy as np
from numpy.typing import NDArray

from gearlash.system import GearlashError

from .cylindrical_gear import CylindricalGear
from .involute import inv

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
        Not undercut.
    points : int
        On the fillet, and on the involute.

    Returns
    -------
    ToothForm

    Raises
    ------
    GearlashError
        For an undercut gear, or a tool tip that is rounded more than it is wide.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear
    >>> from gearlash.gears.tooth_form import tooth_form
    >>> form = tooth_form(CylindricalGear(30, 4e-3))
    >>> round(form.foot_thickness * 1e3, 2)  # 30° tangents
    8.26
    """
    if gear.undercut:
        raise GearlashError(
            f"z = {gear.teeth}, x_E = {gear.generating_profile_shift:.3g}: the form of an undercut tooth "
            f"is not computed; undercut ends at x_E = {gear.undercut_limit:.3g}"
        )
    alpha, module, teeth = gear.rack.pressure_angle, gear.normal_module, gear.virtual_teeth
    pitch = 0.5 * module * teeth
    base = pitch * cos(alpha)
    shift = gear.generating_profile_shift
    half_angle = (pi / 2 + 2.0 * shift * tan(alpha)) / teeth + inv(alpha)
    fillet_x, fillet_y = _fillet(gear, pitch, shift, points)
    start = float(np.hypot(fillet_x[-1], fillet_y[-1]))
    tip = pitch + 0.5 * (gear.tip_diameter - gear.reference_diameter)
    radius = np.linspace(start, max(tip, start), points + 1)[1:]
    pressure = np.arccos(np.minimum(base / radius, 1.0))
    angle = half_angle - (np.tan(pressure) - pressure)
    x = np.concatenate([fillet_x, radius * np.sin(angle)])
    y = np.concatenate([fillet_y, radius * np.cos(angle)])
    return ToothForm(base, half_angle, *_above_foot(x, y))


def _fillet(gear: CylindricalGear, pitch: float, shift: float, points: int) -> tuple[Reals, Reals]:
    """From the root circle to the involute: envelope of the rounded tip of the rack."""
    rack, module = gear.rack, gear.normal_module
    alpha, rounding = rack.pressure_angle, rack.root_radius * module
    depth = rack.dedendum * module - rounding  # of the centre of rounding, below the datum line
    offset = pi * module / 4 - depth * tan(alpha) - rounding / cos(alpha)
    if offset < -1e-9 * module:
        raise GearlashError("the tip of the rack is rounded more than it is wide")
    below = depth - shift * module  # below the rolling line
    # The rack rolls from where its centre of rounding stands below the pitch point to where its flank takes
    # over.
    lean = np.linspace(0.0, below / tan(alpha), points)
    distance = np.hypot(lean, below)
    across = lean * (1.0 + rounding / distance)
    down = below * (1.0 + rounding / distance)
    rolled = (lean - offset) / pitch
    from_space = np.arctan2(across, pitch - down) - rolled
    radius = np.hypot(across, pitch - down)
    angle = pi / gear.virtual_teeth - from_space
    return radius * np.sin(angle), radius * np.cos(angle)


def _above_foot(x: Reals, y: Reals) -> tuple[Reals, Reals]:
    """The part above the 30° tangent; of a tooth that is nowhere so flat, all of it."""
    lean = np.degrees(np.arctan2(-np.diff(x), np.diff(y)))
    flat = np.nonzero(lean[: len(x) // 2] > 30.0)[0]  # of the fillet
    first = int(flat[-1]) + 1 if len(flat) else 0
    return x[first:], y[first:]
