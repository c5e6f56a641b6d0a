"""What makes real flanks other than involute helicoids: errors and intended modifications, added to the gaps.

All normal to the flank, in m; above 0 opens the gap.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from gearlash.gears.flank_modification import PairModification

Reals = NDArray[np.float64]


@dataclass(frozen=True)
class Relief:
    """Intended modification of the flanks, the same on every tooth and on both sides.

    Parameters
    ----------
    pinion_tip, gear_tip : float
        Material taken off at the tip, m; at least 0.
    pinion_length, gear_length : float
        How far from the tip it begins, as roll length, m; above 0 where a tip is relieved.
    exponent : float
        1 for a straight relief, 2 for a parabola; at least 1.
    crowning : float
        Off at both ends of the face, m, parabolic from mid face.
    slope : float
        Helix correction: off at z = +b/2 of side 0, m, and so much added at −b/2.
    end_relief : float
        Off at both ends of the face, m, parabolic over ``end_length``.
    end_length : float
        m; above 0 where ends are relieved.

    Examples
    --------
    >>> from gearlash.multibody.topography import Relief
    >>> Relief(pinion_tip=20e-6, pinion_length=3e-3).of_roll(0, -1.5e-3)  # half way down
    1e-05
    """

    pinion_tip: float = 0.0
    gear_tip: float = 0.0
    pinion_length: float = 1e-3
    gear_length: float = 1e-3
    exponent: float = 1.0
    crowning: float = 0.0
    slope: float = 0.0
    end_relief: float = 0.0
    end_length: float = 1e-3

    def of_roll(self, which: int, from_tip: float) -> float:
        """Off the flank of pinion (0) or gear (1), m, at a roll length counted from its tip (below 0)."""
        depth = (self.pinion_tip, self.gear_tip)[which]
        length = (self.pinion_length, self.gear_length)[which]
        return depth * min(max(1.0 + from_tip / length, 0.0), 1.0) ** self.exponent

    def of_face(self, axial: float, width: float) -> float:
        """Off both flanks together across the face, m, at z of side 0."""
        part = 2.0 * axial / width
        beyond = max(abs(axial) - (0.5 * width - self.end_length), 0.0) / self.end_length
        return self.crowning * part**2 + self.slope * part + self.end_relief * beyond**2


@dataclass(frozen=True)
class Topography:
    """Error and modification of a pair of gears.

    Parameters
    ----------
    error : tuple of (float, float, int)
        Amplitude A, m, phase φ, rad, and harmonic n of the transmission error e = Σ A cos(n θ + φ), θ the
        mesh phase (the pinion's turn times its teeth). As a topography: waves whose crests are parallel to
        the lines of contact, so that all contacts have the same e at a time.
    back : str
        ``"opposite"``: e opens side 0 and closes side 1, as an error of the tooth's place does; ``"none"``:
        side 1 has none.
    relief : Relief
    modification : PairModification
        More of it, as a drawing states it.

    Examples
    --------
    >>> from gearlash.multibody.topography import Topography
    >>> Topography(error=((5e-6, 0.0, 1),)).series(1)[0].round(9).tolist()  # closes side 1
    [-5e-06, 0.0]
    """

    error: tuple[tuple[float, float, int], ...] = ()
    back: str = "opposite"
    relief: Relief = field(default_factory=Relief)
    modification: PairModification = field(default_factory=PairModification)

    def series(self, side: int) -> Reals:
        """Amplitudes of cos nθ and sin nθ on a side, shape (harmonics, 2), θ counted forwards on side 0.

        Side 1 counts θ backwards, as it is looked at from the pair turned over.
        """
        count = max((harmonic for _, _, harmonic in self.error), default=0)
        series = np.zeros((count, 2))
        for amplitude, phase, harmonic in self.error:
            series[harmonic - 1] += amplitude * np.cos(phase), -amplitude * np.sin(phase)
        if side == 0:
            return series
        return (-1.0 if self.back == "opposite" else 0.0) * series * np.array([1.0, -1.0])
