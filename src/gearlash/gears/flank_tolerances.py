"""Flank tolerances of a gear from its grade: ISO 1328-1:2013, clause 5.3.

For class 5; each class is √2 times the one before. d, m_n and b in mm, tolerances in µm, as the standard
writes them:

    f_pT = 0.001 d + 0.4 m_n + 5                 (5)    f_HβT = 0.05 √d + 0.35 √b + 4     (10)
    F_pT = 0.002 d + 0.55 √d + 0.7 m_n + 12      (6)    f_fβT = 0.07 √d + 0.45 √b + 4     (11)
    f_HαT = 0.4 m_n + 0.001 d + 4                (7)    F_βT = √(f_HβT² + f_fβT²)         (12)
    f_fαT = 0.55 m_n + 5                         (8)    F_rT = 0.9 F_pT          (Annex E)
    F_αT = √(f_HαT² + f_fαT²)                    (9)

Arguments and results here in m. A tolerance is a limit: a gear of the class may be as much better as it
likes.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot, sqrt

from gearlash.system import GearlashError

from .cylindrical_gear import CylindricalGear

_UM = 1e-6


@dataclass(frozen=True)
class FlankTolerances:
    """Tolerances of one gear, not rounded, m.

    Parameters
    ----------
    single_pitch : float
        f_pT.
    total_pitch : float
        F_pT, of all pitches over a turn.
    profile_slope, profile_form, profile : float
        f_HαT, f_fαT and F_αT.
    helix_slope, helix_form, helix : float
        f_HβT, f_fβT and F_βT.
    runout : float
        F_rT.
    beyond : tuple of str
        Limits of the standard that this gear leaves, each a sentence.
    """

    single_pitch: float
    total_pitch: float
    profile_slope: float
    profile_form: float
    profile: float
    helix_slope: float
    helix_form: float
    helix: float
    runout: float
    beyond: tuple[str, ...] = ()


def flank_tolerances(gear: CylindricalGear, grade: int, face_width: float) -> FlankTolerances:
    """Tolerances of a gear of a flank tolerance class.

    Parameters
    ----------
    gear : CylindricalGear
    grade : int
        Flank tolerance class A, from 1 to 12; the standard has 1 to 11.
    face_width : float
        b, m; above 0.

    Returns
    -------
    FlankTolerances

    Raises
    ------
    GearlashError
        For a class that is none.

    References
    ----------
    ISO 1328-1:2013, Cylindrical gears, ISO system of flank tolerance classification, part 1.

    Examples
    --------
    >>> from gearlash.gears import CylindricalGear
    >>> from gearlash.gears.flank_tolerances import flank_tolerances
    >>> found = flank_tolerances(CylindricalGear(40, 3e-3), 6, 0.03)
    >>> [round(value * 1e6, 2) for value in (found.single_pitch, found.total_pitch, found.profile)]
    [8.94, 28.8, 12.04]
    """
    step = class_factor(grade)
    d, module, b = gear.reference_diameter * 1e3, gear.normal_module * 1e3, face_width * 1e3
    if not b > 0.0:
        raise GearlashError(f"face width {b:g} mm: flank tolerances are for one above 0")
    unit = _UM * step
    slope, form = 0.4 * module + 0.001 * d + 4.0, 0.55 * module + 5.0
    lead, waves = 0.05 * sqrt(d) + 0.35 * sqrt(b) + 4.0, 0.07 * sqrt(d) + 0.45 * sqrt(b) + 4.0
    total = 0.002 * d + 0.55 * sqrt(d) + 0.7 * module + 12.0
    return FlankTolerances(
        unit * (0.001 * d + 0.4 * module + 5.0),
        unit * total,
        unit * slope,
        unit * form,
        unit * hypot(slope, form),
        unit * lead,
        unit * waves,
        unit * hypot(lead, waves),
        unit * 0.9 * total,
        _beyond(gear, grade, d, module, b),
    )


def class_factor(grade: int) -> float:
    """√2^(A − 5): tolerances of a class over those of class 5.

    Examples
    --------
    >>> from gearlash.gears.flank_tolerances import class_factor
    >>> [round(class_factor(grade), 3) for grade in (5, 7, 8)]
    [1.0, 2.0, 2.828]
    """
    if not 1 <= grade <= 12:
        raise GearlashError(f"class {grade}: flank tolerance classes are 1 to 11, and 12 by the same rule")
    return 2.0 ** (0.5 * (grade - 5))


def rounded(tolerance: float) -> float:
    """As the standard rounds, m: above 10 µm to 1 µm, from 5 to 10 µm to 0.5 µm, below to 0.1 µm (5.2.3).

    Examples
    --------
    >>> from gearlash.gears.flank_tolerances import rounded
    >>> [round(rounded(value * 1e-6) * 1e6, 1) for value in (28.8, 8.94, 3.14)]
    [29.0, 9.0, 3.1]
    """
    micrometres = tolerance / _UM
    step = 1.0 if micrometres > 10.0 else 0.5 if micrometres >= 5.0 else 0.1
    return _UM * step * round(micrometres / step)


def _beyond(gear: CylindricalGear, grade: int, d: float, module: float, b: float) -> tuple[str, ...]:
    """Limits of the standard's range of application that are left."""
    checks = (
        (grade > 11, f"class {grade}: the standard ends at class 11"),
        (not 5 <= gear.teeth <= 1000, f"z = {gear.teeth}: the standard is for 5 to 1000 teeth"),
        (not 5.0 <= d <= 15000.0, f"d = {d:.4g} mm: the standard is for 5 to 15000 mm"),
        (not 0.5 <= module <= 70.0, f"m_n = {module:.4g} mm: the standard is for 0.5 to 70 mm"),
        (not 4.0 <= b <= 1200.0, f"b = {b:.4g} mm: the standard is for 4 to 1200 mm"),
        (abs(gear.helix_angle) > 0.7853982, "the helix angle is above 45°"),
    )
    return tuple(text for left, text in checks if left)
