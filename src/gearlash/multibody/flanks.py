"""True involute helicoid flanks of a pair of gears, as the contact between them needs them.

An involute through a point is told by the arc of the base circle at which it begins; that arc, as a function
of the point, has a gradient of length 1 along the tangent to the base circle. So distances of involutes along
their common tangent are differences of arcs, for any centre distance, without approximation. A helicoid is
an involute that turns with the axial place: the gradient is then 1/cos β_b long, and the distance normal to
the flanks cos β_b times the arc.

Side 0 of the teeth works when the pinion drives towards +z (counter-clockwise seen from +z). With places ρ_1
on the pinion's flank and ρ_2 on the gear's, both roll lengths, its gap in the transverse section is

    g_t = (r_b1 + r_b2) tan α − ρ_1 − ρ_2,   ρ_i = r_bi (ψ_i + α − χ),

with ψ_i the angle at which the involute leaves the base circle, α the working pressure angle of this slice's
own centres and χ the direction of the line through them. Side 1 is side 0 of the pair turned by half a turn
about the line of centres, which leaves the pair as it is.

Beyond the end of its flank a tooth touches with its tip corner, off the line of action. The corner's distance
from the mate's involute is closed form, too; over e, how far the pair has rolled beyond the end, it is
e² (c_0 + c_1 e) to within a few per cent. Below the form circle of the root nothing is known of the mate:
pairs whose tips reach there are refused.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi, sin, tan

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.gears import CylindricalGear, CylindricalPair
from gearlash.gears.tip_corner import tip_corner_gap
from gearlash.system import GearlashError

from ._tables import CORNER_REACH

Reals = NDArray[np.float64]


@dataclass(frozen=True)
class Flanks:
    """The working flanks of a pair of gears.

    Parameters
    ----------
    pair : CylindricalPair
        With its face width.

    Raises
    ------
    GearlashError
        For a pair whose tips reach below the involutes of their mates, without contact, or without width.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> from gearlash.multibody.flanks import Flanks
    >>> gears = [CylindricalGear(z, 2e-3, thickness_allowance=-40e-6) for z in (25, 57)]
    >>> flanks = Flanks(CylindricalPair(*gears, 82e-3, face_width=0.02))
    >>> round(flanks.play * 1e6, 2)  # backlash normal to the flanks
    75.18
    """

    pair: CylindricalPair

    def __post_init__(self) -> None:
        """What does not mesh is refused."""
        if any(self.pair.interference):
            raise GearlashError("the tip of one gear reaches below the involute of the other")
        if not self.pair.transverse_contact_ratio > 1.0:
            raise GearlashError(
                f"ε_α = {self.pair.transverse_contact_ratio:.3g}: above 1 the teeth hand over the contact"
            )
        if not self.pair.face_width > 0.0:
            raise GearlashError("face width 0: a pair of bodies has one")

    @property
    def base_radii(self) -> tuple[float, float]:
        """r_b1 and r_b2, m."""
        return 0.5 * self.pair.pinion.base_diameter, 0.5 * self.pair.gear.base_diameter

    @property
    def pitch(self) -> float:
        """p_bt, m: from pair to pair of teeth on the line of action, in the transverse section."""
        return self.pair.pinion.transverse_base_pitch

    @property
    def base_helix(self) -> float:
        """β_b, rad; above 0 for a right-handed pinion."""
        angle = self.pair.pinion.base_helix_angle
        return angle if self.pair.pinion.helix_angle >= 0.0 else -angle

    @property
    def hands(self) -> tuple[CylindricalGear, CylindricalGear]:
        """Both gears, the second with the hand that meshes with the first."""
        pinion, gear = self.pair.gears
        return pinion, gear.mirrored() if pinion.helix_angle * gear.helix_angle > 0.0 else gear

    @property
    def origins(self) -> tuple[float, float]:
        """r_bi ψ_i at rest, m: of the pair of flanks with the pinion tooth on the line of centres.

        At rest that tooth of the pinion, and a space of the gear, stand on the line of centres at mid face.
        """
        first, second = (0.5 * gear.transverse_thickness(gear.base_diameter) for gear in self.pair.gears)
        return first, second - 0.5 * self.pitch

    @property
    def rest_rolls(self) -> tuple[float, float]:
        """ρ_1 and ρ_2 of that pair of flanks at rest, at the pair's own centre distance, m."""
        angle = self.pair.working_pressure_angle
        first, second = (
            origin + radius * angle for origin, radius in zip(self.origins, self.base_radii, strict=True)
        )
        return first, second

    @property
    def play(self) -> float:
        """j_n, m: both sides' gaps at rest together, normal to the flanks."""
        return 2.0 * cos(self.base_helix) * (self.pair.tangent_length - sum(self.rest_rolls))

    @property
    def tip_rolls(self) -> tuple[float, float]:
        """Roll lengths at which the flanks end at the tips, m."""
        first, second = (gear.roll_length(gear.tip_form_diameter) for gear in self.pair.gears)
        return first, second

    def corner(self, which: int, beyond: ArrayLike) -> Reals:
        """Gap that a tip corner leaves to the mate's flank beyond the end of its own.

        Parameters
        ----------
        which : int
            Whose tip: 0 pinion, 1 gear.
        beyond : array_like
            e, m: on the line of action, in the transverse section; at least 0.

        Returns
        -------
        ndarray
            m, in the transverse section, where the mate's flank is reached along its own normal; both turning
            as flanks without gap would.

        Examples
        --------
        >>> from gearlash.gears import CylindricalGear, CylindricalPair
        >>> from gearlash.multibody.flanks import Flanks
        >>> pair = CylindricalPair(CylindricalGear(25, 2e-3), CylindricalGear(57, 2e-3), face_width=0.02)
        >>> (Flanks(pair).corner(0, [0.0, 5e-4, 1e-3]) * 1e6).round(1).tolist()  # µm
        [0.0, 5.9, 24.3]
        """
        return tip_corner_gap(self.pair, which, beyond)

    def corner_coefficients(self, which: int, reach: float = CORNER_REACH) -> tuple[float, float, float]:
        """c_0, 1/m, and c_1, 1/m², of the corner's gap e² (c_0 + c_1 e), and how far it is followed, m.

        The gap at the end is about ``reach``, m.
        """
        first = float(self.corner(which, 1e-4)) / 1e-8
        far = np.sqrt(reach / first)
        e = np.linspace(0.05, 1.0, 20) * far
        slope, start = np.polyfit(e, self.corner(which, e) / e**2, 1)
        return float(start), float(slope), float(far)

    def contact_point(self, roll: float) -> tuple[float, float]:
        """Place on the line of action, m: from the pinion's axis towards the gear's, and across."""
        angle, radius = self.pair.working_pressure_angle, self.base_radii[0]
        return (
            radius * cos(angle) + roll * sin(angle),
            -radius * sin(angle) + roll * cos(angle),
        )

    def relative_curvature(self, roll: float) -> float:
        """Relative radius of curvature normal to the flanks at a roll length of the pinion, m."""
        return roll * (1.0 - roll / self.pair.tangent_length) / cos(self.base_helix)

    @property
    def twist(self) -> float:
        """tan β_b, with its sign: by how much a pair is further on its path for 1 m along the axis."""
        return tan(self.base_helix)

    @property
    def phase_pitch(self) -> float:
        """Rotation of the pinion for one mesh cycle, rad."""
        return 2.0 * pi / self.pair.pinion.teeth
