"""Structured quadrilaterals of one tooth of a gear in the transverse section.

Two blocks: the tooth, in rows of constant radius from the fillet to the tip, and the rim below it, from the
middle of one space to the middle of the next. They share the foot of the tooth. The first and the last column
of the tooth lie within a constant depth below its flanks: in them is the local dent of a load on a flank.
Lengths in m, angles in rad from the middle of the tooth.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi

import numpy as np
from numpy.typing import NDArray

from gearlash.gears import CylindricalGear
from gearlash.gears.outline import half_tooth
from gearlash.system import GearlashError

Reals = NDArray[np.float64]
Integers = NDArray[np.int64]


@dataclass(frozen=True)
class Fineness:
    """How many elements a tooth and the rim below it have.

    Parameters
    ----------
    flank : int
        Rows of elements on the involute; at least 1.
    fillet : int
        Rows on the upper half of each fillet, and columns of the rim below its lower half; at least 1.
    layer : int
        Columns in the layer below each flank; at least 1.
    core : int
        Columns between the layers below both flanks; at least 1.
    rim : int
        Rows below the foot of the tooth; at least 1.
    axial : int
        Layers along the face; at least 1.

    Examples
    --------
    >>> from gearlash.multibody.tooth_section import Fineness
    >>> Fineness().finer(2).flank
    12
    """

    flank: int = 6
    fillet: int = 2
    layer: int = 1
    core: int = 2
    rim: int = 4
    axial: int = 12

    def __post_init__(self) -> None:
        """Every block has an element."""
        if min(self.flank, self.fillet, self.layer, self.core, self.rim, self.axial) < 1:
            raise GearlashError("every block of a tooth has at least one element")

    def finer(self, times: int) -> Fineness:
        """The same with so many times the elements in every direction.

        Parameters
        ----------
        times : int
            At least 1.

        Returns
        -------
        Fineness
        """
        return Fineness(
            times * self.flank,
            times * self.fillet,
            times * self.layer,
            times * self.core,
            times * self.rim,
            times * self.axial,
        )


@dataclass(frozen=True)
class ToothSection:
    """The nodes of one tooth and the rim below it, in rows from inside to outside and left to right.

    Parameters
    ----------
    rim : ndarray, shape (rows, columns, 2)
        Radius and angle; its first and last column lie in the middles of the spaces.
    tooth : ndarray, shape (rows, columns, 2)
        Its first row is in the last row of the rim. The last column is the flank with angles above 0.
    involute : int
        Row of the tooth at which the involute starts.
    layer : int
        Columns of the layer below each flank.
    depth : float
        Of the layers below the flanks, normal to them, m.
    """

    rim: Reals
    tooth: Reals
    involute: int
    layer: int
    depth: float

    @property
    def shoulder(self) -> int:
        """Columns of the rim on each side of the tooth."""
        return (self.rim.shape[1] - self.tooth.shape[1]) // 2


def tooth_section(
    gear: CylindricalGear, fineness: Fineness, rim_depth: float, depth: float | None = None
) -> ToothSection:
    """The section of one tooth.

    Parameters
    ----------
    gear : CylindricalGear
    fineness : Fineness
    rim_depth : float
        From the root circle inward, m; above 0 and below the root radius.
    depth : float, optional
        Of the layers below the flanks, normal to them, m; `default_depth` where nothing is given.

    Returns
    -------
    ToothSection

    Raises
    ------
    GearlashError
        For a rim that reaches the axis, or layers that meet in the middle of the tooth.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear
    >>> from gearlash.multibody.tooth_section import Fineness, tooth_section
    >>> section = tooth_section(CylindricalGear(30, 4e-3), Fineness(), 16e-3)
    >>> section.tooth.shape, section.involute
    ((9, 5, 2), 2)
    """
    if not 0.0 < rim_depth < 0.5 * gear.root_diameter:
        raise GearlashError(f"a rim {rim_depth * 1e3:.4g} mm deep: it ends above the axis")
    below, foot, flank = _boundary(gear, fineness)
    side = np.concatenate([foot[:-1], flank])
    layer = depth if depth is not None else default_depth(gear)
    tooth = _tooth(gear, side, layer, fineness)
    involute = len(foot) - 1
    top = np.concatenate([_mirrored(below)[:-1], tooth[0], below[::-1][1:]])
    return ToothSection(_rim(gear, top, rim_depth, fineness.rim), tooth, involute, fineness.layer, layer)


def default_depth(gear: CylindricalGear) -> float:
    """Depth of the layers below the flanks, m: 0.2 m_n, at most 0.3 of the tip's normal thickness.

    Parameters
    ----------
    gear : CylindricalGear

    Returns
    -------
    float
    """
    return min(0.2 * gear.normal_module, 0.3 * gear.tip_thickness())


def _boundary(gear: CylindricalGear, fineness: Fineness) -> tuple[Reals, Reals, Reals]:
    """Radius and angle on the side with angles above 0: middle of the space to fillet, fillet, involute."""
    radius, angle = half_tooth(gear)
    start = 0.5 * max(gear.root_form_diameter, gear.base_diameter)
    tip = 0.5 * gear.tip_form_diameter
    base = 0.5 * gear.base_diameter
    # Rows of equal height on the flank: the arc of an involute is ρ²/(2 r_b) = (r² − r_b²)/(2 r_b).
    radii = np.sqrt(np.linspace(start**2 - base**2, tip**2 - base**2, fineness.flank + 1) + base**2)
    flank = np.array([[r, gear.transverse_thickness(2.0 * r) / (2.0 * r)] for r in radii])
    root = radius <= start * (1.0 + 1e-12)
    curve = np.column_stack([radius[root], angle[root]])
    if curve[0, 1] < pi / gear.teeth * (1.0 - 1e-9):
        curve = np.vstack([[radius[0], pi / gear.teeth], curve])
    curve[-1] = flank[0]
    steps = np.hypot(np.diff(curve[:, 0]), np.diff(curve[:, 1]) * curve[1:, 0])
    arc = np.append(0.0, np.cumsum(steps))
    middle = 0.5 * (arc[-1] + (steps[0] if len(curve) > np.count_nonzero(root) else 0.0))
    lower = _resampled(curve, arc, np.linspace(0.0, middle, fineness.fillet + 1))
    upper = _resampled(curve, arc, np.linspace(middle, arc[-1], fineness.fillet + 1))
    return lower, upper, flank


def _resampled(curve: Reals, arc: Reals, at: Reals) -> Reals:
    return np.column_stack([np.interp(at, arc, curve[:, k]) for k in range(2)])


def _mirrored(points: Reals) -> Reals:
    return points * np.array([1.0, -1.0])


def _tooth(gear: CylindricalGear, side: Reals, depth: float, fineness: Fineness) -> Reals:
    """Rows of constant radius; columns flank, layer, core, layer, flank."""
    across = np.empty((len(side), fineness.core + 2 * fineness.layer + 1, 2))
    involute = len(side) - fineness.flank - 1
    for row, (radius, half) in enumerate(side):
        at = max(radius, side[involute, 0])
        slope = cos(gear.pressure_angle_at(2.0 * at)) * cos(gear.base_helix_angle)
        inner = half - depth / slope / radius
        if inner <= 0.1 * half:
            raise GearlashError(
                f"layers {depth * 1e3:.4g} mm below both flanks meet: the tooth is "
                f"{2e3 * half * radius:.4g} mm thick at a radius of {radius * 1e3:.4g} mm"
            )
        across[row, :, 0] = radius
        outer = np.linspace(half, inner, fineness.layer + 1)
        core = np.linspace(-inner, inner, fineness.core + 1)
        across[row, :, 1] = np.concatenate([-outer[:-1], core, outer[::-1][1:]])
    return across


def _rim(gear: CylindricalGear, top: Reals, rim_depth: float, rows: int) -> Reals:
    """From a circle below the root to the foot of the tooth; rows get higher inward."""
    inner = 0.5 * gear.root_diameter - rim_depth
    bottom = np.column_stack([np.full(len(top), inner), np.linspace(-1.0, 1.0, len(top)) * pi / gear.teeth])
    share = (1.0 - np.linspace(1.0, 0.0, rows + 1) ** 1.6)[:, None, None]
    return bottom * (1.0 - share) + top * share
