"""Fits of gears: tooth thickness allowances and tolerances of DIN 3967, centre distance deviations of DIN
3964.

A drawing's "27cd" is tolerance series 27 and allowance series cd: the upper allowance of the normal tooth
thickness by series and reference diameter, and how far below it the lower one lies. Values of DIN
3967:1978-08; the standard's own example is 27cd at d = 100 mm: −70 and −170 µm. Lengths in m.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Sequence
from math import sqrt

from gearlash.system import GearlashError

ALLOWANCE_SERIES = ("a", "ab", "b", "bc", "c", "cd", "d", "e", "f", "g", "h")
"""From the widest backlash to none."""
TOLERANCE_SERIES = tuple(range(21, 31))
_DIAMETERS = (10, 50, 125, 280, 560, 1000, 1600, 2500, 4000, 6300, 10000)  # mm: up to and including
_UPPER = (  # µm, below the nominal thickness; a row for each range of diameters, a column for each series
    (100, 85, 70, 58, 48, 40, 33, 22, 10, 5, 0),
    (135, 110, 95, 75, 65, 54, 44, 30, 14, 7, 0),
    (180, 150, 125, 105, 85, 70, 60, 40, 19, 9, 0),
    (250, 200, 170, 140, 115, 95, 80, 56, 26, 12, 0),
    (330, 280, 230, 190, 155, 130, 110, 75, 35, 17, 0),
    (450, 370, 310, 260, 210, 175, 145, 100, 48, 22, 0),
    (600, 500, 420, 340, 290, 240, 200, 135, 64, 30, 0),
    (820, 680, 560, 460, 390, 320, 270, 180, 85, 41, 0),
    (1100, 920, 760, 620, 520, 430, 360, 250, 115, 56, 0),
    (1500, 1250, 1020, 840, 700, 580, 480, 330, 155, 75, 0),
    (2000, 1650, 1350, 1150, 940, 780, 640, 450, 210, 100, 0),
)
_TOLERANCE = (  # µm
    (3, 5, 8, 12, 20, 30, 50, 80, 130, 200),
    (5, 8, 12, 20, 30, 50, 80, 130, 200, 300),
    (6, 10, 16, 25, 40, 60, 100, 160, 250, 400),
    (8, 12, 20, 30, 50, 80, 130, 200, 300, 500),
    (10, 16, 25, 40, 60, 100, 160, 250, 400, 600),
    (12, 20, 30, 50, 80, 130, 200, 300, 500, 800),
    (16, 25, 40, 60, 100, 160, 250, 400, 600, 1000),
    (20, 30, 50, 80, 130, 200, 300, 500, 800, 1300),
    (25, 40, 60, 100, 160, 250, 400, 600, 1000, 1600),
    (30, 50, 80, 130, 200, 300, 500, 800, 1300, 2000),
    (40, 60, 100, 160, 250, 400, 600, 1000, 1600, 2400),
)
_DESIGNATION = re.compile(r"\s*(?:(\d{2})\s*([a-h]{1,2})|([a-h]{1,2})\s*(\d{2}))\s*")
_SIZES = (
    3,
    6,
    10,
    18,
    30,
    50,
    80,
    120,
    180,
    250,
    315,
    400,
    500,
    630,
    800,
    1000,
    1250,
    1600,
    2000,
    2500,
    3150,
)
SAME_SIZE = 1e-9
"""Relative: sizes that lie nearer are one, as a centre distance of 18 mm is that is computed of teeth."""
_UNITS = {5: 7.0, 6: 10.0, 7: 16.0, 8: 25.0, 9: 40.0, 10: 64.0, 11: 100.0}


def thickness_allowances(designation: str, reference_diameter: float) -> tuple[float, float]:
    """Upper and lower allowance of the normal tooth thickness.

    Parameters
    ----------
    designation : str
        Tolerance series and allowance series, in either order: ``"27cd"``, ``"cd25"``.
    reference_diameter : float
        d, m; to 10.

    Returns
    -------
    (float, float)
        E_sns and E_sni (A_sne and A_sni), m; at most 0.

    Raises
    ------
    GearlashError
        For a designation or a diameter that the standard does not have.

    References
    ----------
    DIN 3967:1978-08, System of gear fits: backlash, tooth thickness allowances, tooth thickness tolerances.

    Examples
    --------
    >>> from gearlash.gears import gear_fits
    >>> [round(allowance * 1e6) for allowance in gear_fits.thickness_allowances("27cd", 0.1)]
    [-70, -170]
    """
    found = _DESIGNATION.fullmatch(designation)
    series = found and (found[2] or found[3])
    number = int(found[1] or found[4]) if found else 0
    if series not in ALLOWANCE_SERIES or number not in TOLERANCE_SERIES:
        raise GearlashError(
            f"{designation!r} is no fit of DIN 3967: a number from 21 to 30 and one of "
            f"{', '.join(ALLOWANCE_SERIES)}, as in 27cd"
        )
    row = _row(_DIAMETERS, reference_diameter * 1e3)
    if row == len(_DIAMETERS):
        raise GearlashError(f"d = {reference_diameter:g} m: DIN 3967 ends at 10 m")
    upper = _UPPER[row][ALLOWANCE_SERIES.index(series)]
    tolerance = _TOLERANCE[row][TOLERANCE_SERIES.index(number)]
    return -upper * 1e-6, -(upper + tolerance) * 1e-6


def centre_distance_deviation(grade: int, centre_distance: float) -> float:
    """Half the standard tolerance of a centre distance: the js deviations of DIN 3964.

    Parameters
    ----------
    grade : int
        Standard tolerance grade of ISO 286, from 5 to 11: the 7 of js7.
    centre_distance : float
        a, m; above 0, to 3.15.

    Returns
    -------
    float
        A_a, m: the distance may be this much larger or smaller. By the formula of ISO 286-1 for the geometric
        mean of the range of sizes, i = 0.45 ∛D + 0.001 D µm (D in mm; above 500 mm 0.004 D + 2.1), not
        rounded as in the standard's lists.

    Raises
    ------
    GearlashError
        For a grade or a size outside.

    References
    ----------
    DIN 3964:1980, Deviations of shaft centre distances; ISO 286-1:2010, standard tolerances.

    Examples
    --------
    >>> from gearlash.gears import gear_fits
    >>> round(gear_fits.centre_distance_deviation(7, 0.082) * 1e6)
    17
    """
    size = centre_distance * 1e3
    row = _row(_SIZES, size)
    if grade not in _UNITS or not size > 0.0 or row == len(_SIZES):
        raise GearlashError(
            f"js{grade} at {size:g} mm: grades from 5 to 11 and distances up to 3150 mm are known"
        )
    mean = sqrt((_SIZES[row - 1] if row else 1) * _SIZES[row])
    unit = 0.45 * mean ** (1.0 / 3.0) + 0.001 * mean if _SIZES[row] <= 500 else 0.004 * mean + 2.1
    return 0.5e-6 * _UNITS[grade] * unit


def _row(limits: Sequence[int], size: float) -> int:
    """The range of sizes, mm, that a size lies in: a limit belongs to the smaller ones, and what computing
    leaves beside it is that limit."""
    return bisect_left(limits, size * (1.0 - SAME_SIZE))
