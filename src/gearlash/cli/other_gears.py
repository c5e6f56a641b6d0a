"""Gears that drawings have and no model here takes: refused in words, with what can be done."""

from __future__ import annotations

import re

from gearlash.case.units import ANGLE, UnitError, read
from gearlash.system import GearlashError

TAKEN = re.compile(r"spur|helical|cylindrical|external|parallel", re.IGNORECASE)
HERE = "gearlash new takes external cylindrical gears, spur or helical, on parallel shafts"
OWN = (
    'what is known of its mesh (stiffness, backlash, masses) may be stated as kind = "piecewise-linear" '
    "(docs/own-system.md)"
)
OTHERS = {
    r"herringbone|double[- ]?helical|pfeil": "one half of a double helical pair can be entered, with half "
    "of torque, width and inertia",
    r"bevel|kegel|hypoid|conical|crown|face[- ]?gear": "teeth of bevel gears change along the face",
    r"worm|schnecke|crossed|skew|screw": "worms and crossed helical gears slide along their teeth",
    r"planet|epicyclic|sun": "a planetary set is several meshes on one carrier: sun and planet can be "
    "entered as a pair, in which the other meshes are left out",
    r"intern|ring|annul|hohlrad|innen": "a ring gear has a geometry and a stiffness of its own",
    r"rack|zahnstange": "a rack has no centre",
    r"cycloid|novikov|circular[- ]?arc": "these teeth are no involutes",
    r"belt|chain|sprocket|pulley": "these are no gears",
}
"""Words of a type, and what is said of it."""


def check_type(text: str) -> None:
    """Raises `GearlashError` for gears of another type."""
    plain = text.strip()
    for words, why in OTHERS.items():
        if re.search(words, plain, re.IGNORECASE):
            raise GearlashError(f"--type {plain}: {HERE}; {why}; {OWN}")
    if not TAKEN.fullmatch(plain):
        raise GearlashError(f"--type {plain}: expected spur or helical; {HERE}")


def check_shafts(text: str) -> None:
    """Raises `GearlashError` for shafts that are not parallel."""
    try:
        number, unit = read(text)
    except UnitError as error:
        raise GearlashError(f"--shaft-angle {text}: expected an angle, 0 deg; {error}") from None
    if unit.dimension != ANGLE or number not in (0, 180):
        raise GearlashError(
            f"--shaft-angle {text}: {HERE}; those of other shafts are bevel gears or worms; {OWN}"
        )
