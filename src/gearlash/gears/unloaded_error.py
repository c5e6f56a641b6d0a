"""Unloaded transmission error of a pair from its grades: a range, since a grade is a limit and no amplitude.

The short-waved part of the error of one gear on a master, from tooth to tooth, is limited by (ISO
1328-1:1995, Annex A)

    f_i′ = K (4.3 µm √2^(A−5) + f_p + F_α),   K = 0.2 (ε_γ + 4)/ε_γ, 0.4 from ε_γ = 4 on,

here with the tolerances f_pT and F_αT of ISO 1328-1:2013. It is an arc on the reference circle, peak to peak;
along the line of action normal to the flanks it is cos α_n cos β of that. From it, for the harmonic of the
mesh frequency:

- least: 0, since a perfect gear meets every grade;
- greatest: a signal that stays within P has no harmonic above 2P/π (that of a square wave), and both gears
add up;
- nominal, an assumption: half of each limit is used, by a sine, and the two gears add up as independent ones
do.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, hypot, pi

from .cylindrical_gear import CylindricalGear
from .cylindrical_pair import CylindricalPair
from .flank_tolerances import class_factor, flank_tolerances

ASSUMPTION = (
    "a grade is a limit: 0 to 2/π of the sum of both gears' tooth-to-tooth limits; nominal: half of each "
    "limit used, as a sine, independent gears"
)


@dataclass(frozen=True)
class AmplitudeRange:
    """Amplitude of one harmonic of the unloaded error, along the line of action normal to the flanks.

    Parameters
    ----------
    least, nominal, greatest : float
        m; only the ends are limits, the nominal one rests on `ASSUMPTION`.
    """

    least: float
    nominal: float
    greatest: float


@dataclass(frozen=True)
class UnloadedError:
    """What the grades of a pair say about its unloaded error.

    Parameters
    ----------
    mesh : AmplitudeRange
        Of the mesh frequency. No higher harmonic of it is above `greatest` either.
    shafts : (AmplitudeRange, AmplitudeRange)
        Of one turn of pinion and gear, from the total pitch tolerance F_pT.
    limits : (float, float)
        Tooth-to-tooth limit f_i′ of pinion and gear, an arc, peak to peak, m.
    beyond : tuple of str
        Limits of the tolerances' standard that are left.
    """

    mesh: AmplitudeRange
    shafts: tuple[AmplitudeRange, AmplitudeRange]
    limits: tuple[float, float]
    beyond: tuple[str, ...] = ()


def tooth_to_tooth_limit(
    gear: CylindricalGear, grade: int, face_width: float, total_contact_ratio: float
) -> float:
    """Limit of the single flank tooth-to-tooth deviation of one gear.

    Parameters
    ----------
    gear : CylindricalGear
    grade : int
        From 1 to 12.
    face_width : float
        b, m.
    total_contact_ratio : float
        ε_γ; above 0.

    Returns
    -------
    float
        f_i′, m: peak to peak, an arc on the reference circle.

    References
    ----------
    ISO 1328-1:1995, Annex A, tangential composite deviations; ISO 1328-1:2013 for f_pT and F_αT.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear
    >>> from gearlash.gears.unloaded_error import tooth_to_tooth_limit
    >>> round(tooth_to_tooth_limit(CylindricalGear(40, 3e-3), 6, 0.03, 1.7) * 1e6, 1)
    18.1
    """
    found = flank_tolerances(gear, grade, face_width)
    factor = 0.4 if total_contact_ratio >= 4.0 else 0.2 * (total_contact_ratio + 4.0) / total_contact_ratio
    return factor * (4.3e-6 * class_factor(grade) + found.single_pitch + found.profile)


def unloaded_error(pair: CylindricalPair, grades: tuple[int, int]) -> UnloadedError:
    """Range of the unloaded transmission error of a pair.

    Parameters
    ----------
    pair : CylindricalPair
        With its face width.
    grades : (int, int)
        Flank tolerance classes of pinion and gear.

    Returns
    -------
    UnloadedError

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> from gearlash.gears.unloaded_error import unloaded_error
    >>> pair = CylindricalPair(CylindricalGear(25, 2e-3), CylindricalGear(57, 2e-3), face_width=0.02)
    >>> error = unloaded_error(pair, (6, 6)).mesh
    >>> [round(value * 1e6, 1) for value in (error.least, error.nominal, error.greatest)]
    [0.0, 5.7, 20.5]
    """
    ratio = pair.total_contact_ratio
    along = cos(pair.pinion.rack.pressure_angle) * cos(pair.pinion.helix_angle)
    limits, shafts, beyond = [], [], []
    for gear, grade in zip(pair.gears, grades, strict=True):
        limits.append(tooth_to_tooth_limit(gear, grade, pair.face_width, ratio))
        tolerances = flank_tolerances(gear, grade, pair.face_width)
        total = tolerances.total_pitch * along
        shafts.append(AmplitudeRange(0.0, 0.25 * total, 2.0 * total / pi))
        beyond += [text for text in tolerances.beyond if text not in beyond]
    first, second = (along * limit for limit in limits)
    mesh = AmplitudeRange(0.0, 0.25 * hypot(first, second), 2.0 * (first + second) / pi)
    return UnloadedError(mesh, (shafts[0], shafts[1]), (limits[0], limits[1]), tuple(beyond))
