"""What the motion of the centre line makes of contact ratio and backlash."""

from __future__ import annotations

from dataclasses import dataclass, replace

from gearlash.gears import CylindricalPair, backlash


@dataclass(frozen=True)
class Breathing:
    """Least and greatest values over a motion.

    Attributes
    ----------
    change : (float, float)
        Of the centre distance at mid face, m, from that at rest.
    contact_ratio : (float, float)
        ε_α of the geometry at the greatest and at the least distance.
    backlash : (float, float)
        Normal, at the least and at the greatest distance, m.
    """

    change: tuple[float, float]
    contact_ratio: tuple[float, float]
    backlash: tuple[float, float]


def breathing_of(pair: CylindricalPair, change: tuple[float, float]) -> Breathing:
    """Contact ratio and backlash at the ends of the way of the centre line.

    Parameters
    ----------
    pair : CylindricalPair
    change : (float, float)
        Least and greatest change of the centre distance, m.

    Returns
    -------
    Breathing
    """
    near, far = (
        replace(pair, stated_centre_distance=pair.centre_distance + moved) for moved in sorted(change)
    )
    return Breathing(
        (min(change), max(change)),
        (far.transverse_contact_ratio, near.transverse_contact_ratio),
        (backlash.of_pair(near).normal, backlash.of_pair(far).normal),
    )
