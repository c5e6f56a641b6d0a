"""Names of columns and their units, as they stand above numbers."""

from __future__ import annotations

import re
from collections.abc import Sequence

from .column_figures import figure_in, without_figure
from .units import UNIT_WORDS, plain_unit

_BRACKETS = re.compile(r"^(?P<name>.*?)\s*[\[({](?P<unit>[^\])}]*)[\])}]\s*$")
_BEHIND = re.compile(r"^(?P<name>.*?)\s*(?P<unit>[\[(][^\])]*[\])])\s*(?P<tail>[^\[\](){}]+)$")
_STROKE = re.compile(r"^(?P<name>.*\S)\s*(?:\s/\s*|\s+in\s+)(?P<unit>\S.*)$")
STANDARD_GRAVITY = 9.80665
_SUFFIX = re.compile(r"^(?P<name>.*[^_])_(?P<unit>rpm|Hz|kHz|kN|N|um|mm|ms|deg|Nm|m_s2|mm_s)$")
ACCELERATIONS = ("m/s^2", "mm/s^2", "um/s^2", "in/s^2", "ft/s^2", "g")
_ACCELERATION = re.compile(r"(m|mm|um|cm|in|ft)(?:/s(?:ec)?(?:\^2|\*\*2|2|/s)|[* ]s\^-2)")
_METRES = {"m": 1.0, "mm": 1e-3, "um": 1e-6, "cm": 1e-2, "in": 0.0254, "ft": 0.3048}
_GRAVITIES = {"g": STANDARD_GRAVITY, "gn": STANDARD_GRAVITY, "g_n": STANDARD_GRAVITY}
NO_UNIT = ("", "-", "1")


def head_of(lines: Sequence[Sequence[str]], count: int) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Names and units of columns from the whole lines above the numbers: the last one, and the one above it
    where the last has nothing but units; a single line of units is both."""
    if not lines:
        return tuple(f"column {i}" for i in range(1, count + 1)), ("",) * count
    last = lines[-1]
    if len(lines) == 1 and all(cell not in NO_UNIT and _is_unit(cell) for cell in last):
        return tuple(last), tuple(map(_bare, last))
    if len(lines) > 1 and any(cell not in NO_UNIT for cell in last) and all(map(_is_unit, last)):
        below = [_bare(cell) for cell in last]
        pairs = [_named(cell) for cell in lines[-2]]
        both = [(name, under or behind) for (name, behind), under in zip(pairs, below, strict=True)]
    else:
        both = [_named(cell) for cell in last]
    names = tuple(name or f"column {i}" for i, (name, _) in enumerate(both, 1))
    return names, tuple(each for _, each in both)


def acceleration_in(unit: str) -> float | None:
    """m/s² in one of these units; None where it is no unit of acceleration."""
    plain = plain_unit(unit.strip())
    found = _ACCELERATION.fullmatch(plain)
    return _METRES[found[1]] if found else _GRAVITIES.get(plain)


def _named(cell: str) -> tuple[str, str]:
    """Name and unit of ``Force [N]``, ``Force / N``, ``n in rpm`` or ``force_N``."""
    behind = _BEHIND.match(cell)
    if behind is not None and figure_in(behind["tail"]):
        cell = f"{behind['name']} {behind['tail']} {behind['unit']}"
    found = _BRACKETS.match(cell)
    if found is None:
        found = _STROKE.match(cell) or _SUFFIX.match(cell)
        if found is not None and not (_is_unit(found["unit"]) or found["unit"] in ("m_s2", "mm_s")):
            found = None
    if found is None:
        return cell.strip(), ""
    told = found["unit"].strip().replace("m_s2", "m/s^2").replace("mm_s", "mm/s")
    name, bare = found["name"].strip(), without_figure(told)
    if bare != told and not figure_in(name):
        name = f"{name} {figure_in(told)}"
    return name, "" if bare in NO_UNIT else bare


def _bare(cell: str) -> str:
    found = _BRACKETS.match(cell)
    told = without_figure((found["unit"] if found and not found["name"] else cell).strip())
    return "" if told in NO_UNIT else told


def _is_unit(cell: str) -> bool:
    told = _bare(cell)
    if told in NO_UNIT or acceleration_in(told) or told.lower().startswith("db"):
        return True
    words = re.findall(r"[^\W\d_]+|%", plain_unit(told))
    return bool(words) and all(word in UNIT_WORDS or word in ("Nm", "Nmm", "kNm") for word in words)
