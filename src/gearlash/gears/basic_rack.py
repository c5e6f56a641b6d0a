"""The standard basic rack tooth profile: what a tool gives to every gear it cuts.

ISO 53:1998, Cylindrical gears for general and heavy engineering: standard basic rack tooth profile, types A
to D.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import radians, sin


@dataclass(frozen=True)
class BasicRack:
    """A basic rack tooth profile; heights over the normal module.

    Parameters
    ----------
    pressure_angle : float
        Normal pressure angle α_n (α_P), rad; above 0 and below π/2.
    addendum : float
        h_aP/m_n.
    dedendum : float
        h_fP/m_n: the tip height of the tool.
    root_radius : float
        ρ_fP/m_n: the tip radius of the tool.

    References
    ----------
    ISO 53:1998; ISO 21771-1, basic rack tooth profile.

    Examples
    --------
    >>> from gearlash.gears.basic_rack import ISO53_A
    >>> ISO53_A.dedendum, round(ISO53_A.straight_dedendum, 4)
    (1.25, 1.0)
    """

    pressure_angle: float = radians(20.0)
    addendum: float = 1.0
    dedendum: float = 1.25
    root_radius: float = 0.38

    @property
    def straight_dedendum(self) -> float:
        """h_FfP/m_n: how far below the datum line the straight flank reaches, h_fP − ρ_fP (1 − sin α_n)."""
        return self.dedendum - self.root_radius * (1.0 - sin(self.pressure_angle))


ISO53_A = BasicRack()
"""For gears that transmit high torques."""
ISO53_B = BasicRack(root_radius=0.30)
"""For standard hobs."""
ISO53_C = BasicRack(root_radius=0.25)
"""For standard hobs."""
ISO53_D = BasicRack(dedendum=1.4, root_radius=0.39)
"""For ground or shaved flanks and full root radii, high quality."""
STUB = BasicRack(addendum=0.8, dedendum=1.0, root_radius=0.3)
"""American stub teeth of 20° (ASA B6.1): 0.8 and 1.0; their fillet is not told, 0.3 is that of hobs."""
