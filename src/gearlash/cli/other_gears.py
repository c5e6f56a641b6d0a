"""Gears that drawings have and no model here takes: refused in words, with what can be done."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from gearlash.case.units import ANGLE, NUMBER, UnitError, read
from gearlash.system import GearlashError

if TYPE_CHECKING:
    from gearlash.case import Case

_SPUR = r"spurs?|straight|gerad\w*"
_HELICAL = r"helicals?|schräg\w*|schraeg\w*"
_BESIDE = (
    r"externally|involutes?|evolvent\w*|single|gears?|gearing|gearset|wheels?|pairs?|"
    r"sets?|tooth|toothed|teeth|cut|cutting|shafts?|axes|axis|with|and|on|of|a|the|type|pinions?|hobbed|hob|"
    r"ground|shaved|honed|shaped|milled|hardened|crowned|by|zahnr[aä]d\w*|paar|verzahn\w*|außen\w*|aussen\w*"
)
"""Words that say nothing of which gears they are, or what all of these are."""
_TOOL = re.compile(
    r"\bby\s+(?:a\s+)?(?:rack|worm|grinding[\s-]+worm)s?\b(?:[\s-]*(?:cutters?|tools?|type|wheels?))*|\brack[\s-]+cut(?:ters?)?\b",
    re.I,
)
"""A rack or a worm that cuts or grinds the teeth, and is none of the gears."""
_ALL = r"cylindrical|external|parallel|stirnr[aä]d\w*"
_KNOWN = re.compile(f"(?:{_SPUR}|{_HELICAL}|{_ALL}|{_BESIDE})", re.IGNORECASE)
_WORDS = re.compile(r"[^\W\d_]+")
HERE = "gearlash new takes external cylindrical gears, spur or helical, on parallel shafts"
OWN = (
    'what is known of its mesh (stiffness, backlash, masses) may be stated as kind = "piecewise-linear" '
    "(docs/own-system.md)"
)
OTHERS = {
    r"herringbone|double[\s-]*helicals?|pfeil\w*": "one half of a double helical pair can be entered, with "
    "half of torque, width and inertia",
    r"bevels?|bevel+ed|kegel\w*|hypoids?|conical|crown|face[\s-]*gears?": "teeth of bevel gears change along "
    "the face",
    r"worms?|schnecken?\w*|crossed|skew|screws?": "worms and crossed helical gears slide along their teeth",
    r"planets?|planetary|planeten\w*|epicyclic|sun": "a planetary set is several meshes on one carrier: sun "
    "and planet can be entered as a pair, in which the other meshes are left out",
    r"intern\w*|rings?|annul\w*|hohlr[aä]d\w*|innen\w*": "a ring gear has a geometry and a stiffness of its "
    "own",
    r"racks?|zahnstangen?": "a rack has no centre",
    r"cycloid\w*|novikov|circular[\s-]*arcs?": "these teeth are no involutes",
    r"belts?|chains?|sprockets?|pulleys?": "these are no gears",
}
"""Words of a type, and what is said of it."""


def check_type(text: str) -> str:
    """``spur`` or ``helical``; empty where the words tell neither. Raises `GearlashError` for gears of
    another type, and for words that may be of another one."""
    plain = text.strip()
    left = _TOOL.sub(" ", plain)
    for words, why in OTHERS.items():
        if _has(words, left):
            raise GearlashError(f"--type {plain}: {HERE}; {why}; {OWN}")
    spur, helical = _has(_SPUR, left), _has(_HELICAL, left)
    other = [word for word in _WORDS.findall(left) if not _KNOWN.fullmatch(word)]
    tells = spur or helical or _has(_ALL, left)
    if other or not tells:
        without = f", without {', '.join(other)}" if other and tells else ""
        raise GearlashError(f"--type {plain}: expected spur or helical{without}; {HERE}")
    return "" if spur == helical else "spur" if spur else "helical"


def check_teeth(teeth: str, case: Case) -> None:
    """Raises `GearlashError` where the type says spur teeth and the helix angle does not, or the other way
    round.

    Parameters
    ----------
    teeth : str
        As of `check_type`.
    case : Case
        With the helix angle that was stated, if any.
    """
    entry = next((each for each in case.entries.values() if each.path == "mesh.helix_angle"), None)
    stated = "" if entry is None or entry.number == 0.0 else entry.text
    if teeth == "helical" and not stated:
        raise GearlashError("--type helical: the helix angle is needed, such as --helix-angle 15deg")
    if teeth == "spur" and stated:
        raise GearlashError(
            f"--type spur: --helix-angle {stated} is that of helical teeth; leave one of the two out"
        )


def check_shafts(text: str) -> None:
    """Raises `GearlashError` for shafts that are not parallel."""
    try:
        number, unit = read(text)
    except UnitError as error:
        raise GearlashError(f"--shaft-angle {text}: expected an angle, 0 deg; {error}") from None
    if number == 0 and unit.dimension in (ANGLE, NUMBER):
        return
    if unit.dimension != ANGLE:
        raise GearlashError(f"--shaft-angle {text}: expected an angle with its unit, 0 deg; {HERE}")
    if number * unit.ratio != 1 or unit.pi_power != 1:  # 180 deg is parallel too
        raise GearlashError(
            f"--shaft-angle {text}: {HERE}; those of other shafts are bevel gears or worms; {OWN}"
        )


def _has(words: str, text: str) -> bool:
    return re.search(rf"\b(?:{words})\b", text, re.IGNORECASE) is not None
