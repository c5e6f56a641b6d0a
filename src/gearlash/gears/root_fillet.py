"""The root fillet that the rounded tip of a rack cuts into a spur gear, and where the involute takes over.

The rack rolls on the reference circle, r φ = its way. While its centre of rounding stands `lean` beside the
pitch point, the point of the rounding that cuts lies on the line from the pitch point through that centre.
The fillet ends where the straight flank takes over, at lean = h_c / tan α, with the centre h_c below the
rolling line; of an undercut gear it ends before, where it crosses the involute. For a helical gear: that of
its virtual spur gear.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi, tan

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.system import GearlashError

from .basic_rack import BasicRack
from .involute import inv

Reals = NDArray[np.float64]


@dataclass(frozen=True)
class RootFillet:
    """Fillet of a spur gear.

    Parameters
    ----------
    teeth : float
        z, or z_n of the virtual spur gear.
    module : float
        m_n, m.
    rack : BasicRack
    shift : float
        x_E.

    Raises
    ------
    GearlashError
        For a rack whose tip is rounded more than it is wide.

    Examples
    --------
    >>> from gearlash.gears.basic_rack import ISO53_A
    >>> from gearlash.gears.root_fillet import RootFillet
    >>> fillet = RootFillet(30, 4e-3, ISO53_A, 0.0)
    >>> radius, half_angle = fillet.at([0.0, fillet.end])  # from the root circle to the involute
    >>> radius.round(5).tolist()
    [0.055, 0.05707]
    """

    teeth: float
    module: float
    rack: BasicRack
    shift: float

    def __post_init__(self) -> None:
        """A tip that is nothing but rounding is refused."""
        if self._offset < -1e-9 * self.module:
            raise GearlashError("the tip of the rack is rounded more than it is wide")

    @property
    def pitch_radius(self) -> float:
        """r, m."""
        return 0.5 * self.module * self.teeth

    @property
    def base_radius(self) -> float:
        """r_b, m."""
        return self.pitch_radius * cos(self.rack.pressure_angle)

    @property
    def base_half_angle(self) -> float:
        """ψ_b, half the angle of the tooth on the base circle, rad."""
        alpha = self.rack.pressure_angle
        return (pi / 2 + 2.0 * self.shift * tan(alpha)) / self.teeth + inv(alpha)

    @property
    def _centre_depth(self) -> float:
        """Of the centre of rounding below the datum line, m."""
        return (self.rack.dedendum - self.rack.root_radius) * self.module

    @property
    def _offset(self) -> float:
        """Of the centre of rounding from the middle of the tool's tooth, m."""
        alpha = self.rack.pressure_angle
        rounding = self.rack.root_radius * self.module
        return pi * self.module / 4 - self._centre_depth * tan(alpha) - rounding / cos(alpha)

    @property
    def _below(self) -> float:
        """h_c, of the centre of rounding below the rolling line, m."""
        return self._centre_depth - self.shift * self.module

    @property
    def last(self) -> float:
        """Lean at which the straight flank of the rack takes over, m."""
        return self._below / tan(self.rack.pressure_angle)

    def at(self, lean: ArrayLike) -> tuple[Reals, Reals]:
        """Points of the fillet.

        Parameters
        ----------
        lean : array_like
            m, from 0 to `last`.

        Returns
        -------
        (ndarray, ndarray)
            Radius, m, and angle from the middle of the tooth, rad.
        """
        lean = np.asarray(lean, dtype=float)
        below, rounding = self._below, self.rack.root_radius * self.module
        stretch = 1.0 + rounding / np.hypot(lean, below)
        across, up = lean * stretch, self.pitch_radius - below * stretch
        from_space = np.arctan2(across, up) - (lean - self._offset) / self.pitch_radius
        return np.hypot(across, up), pi / self.teeth - from_space

    def involute_angle(self, radius: ArrayLike) -> Reals:
        """Angle of the involute from the middle of the tooth, rad; below the base circle that of its end.

        Parameters
        ----------
        radius : array_like
            m; above 0.

        Returns
        -------
        ndarray
            Of the shape of ``radius``.
        """
        pressure = np.arccos(np.minimum(self.base_radius / np.asarray(radius, dtype=float), 1.0))
        return self.base_half_angle - (np.tan(pressure) - pressure)

    @property
    def undercut(self) -> bool:
        """Whether the fillet cuts into the involute: x_E < h_FfP* − z sin² α / 2."""
        alpha = self.rack.pressure_angle
        return self.shift < self.rack.straight_dedendum - 0.5 * self.teeth * (1.0 - cos(alpha) ** 2)

    @property
    def end(self) -> float:
        """Lean at which the fillet ends on the involute, m."""
        if not self.undercut:
            return self.last
        # The fillet is inside the involute near the base circle and comes out of it once: bisected.
        lean = np.linspace(0.0, self.last, 401)
        radius, angle = self.at(lean)
        inside = (radius > self.base_radius) & (angle < self.involute_angle(radius))
        if not inside.any():
            return self.last  # undercut by less than the step: the crossing is the end
        low = float(lean[np.nonzero(inside)[0][-1]])
        high = min(low + float(lean[1]), self.last)
        for _ in range(60):
            middle = 0.5 * (low + high)
            at, here = self.at(middle)
            if here < self.involute_angle(at):
                low = middle
            else:
                high = middle
        return low

    @property
    def involute_radius(self) -> float:
        """Radius at which the involute starts, m."""
        return float(self.at(self.end)[0])
