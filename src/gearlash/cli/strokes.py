"""A text of both gears: what of it is the pinion's and what the gear's, where a stroke may be that of a
fraction."""

from __future__ import annotations

import re

_BETWEEN = re.compile(r"/(?=\s*[-+−–.\døØ⌀½¼¾⅛⅜⅝⅞]|\s*$)|^\s*/")
"""Not that of a unit (N/m)."""
_DEVIATIONS = re.compile(
    r"(?<=[\w%])(?<![\d.][eE])(\s*[-+−–]\s*[.,\d][^/;+−–-]*|\s+0\s*)/(?=\s*(?:[-+−–]\s*[.,\d]|0(?![.,\d])))"
)
"""The stroke between the deviations of one size: 32.83 mm -0.05/-0.08."""
_MIXED = "\u2044"
"""In place of the stroke in 1 1/2, which is between no gears, as that between deviations."""


def names(text: str) -> list[str]:
    """Of both gears one, or that of pinion and gear: every stroke stands between two."""
    return [part.strip() for part in text.split("/", 1)]


def quantities(option: str, text: str) -> list[str]:
    """One text of both gears, or those of pinion and gear, one of which may be empty.

    Parameters
    ----------
    option : str
        That is named where the text is refused.
    text : str

    Returns
    -------
    list of str

    Raises
    ------
    GearlashError
        For a text that can be read in two ways, as 3/4 in can.
    """
    from gearlash.case.written_numbers import join_mixed  # late: help needs none of it
    from gearlash.system import GearlashError

    whole = _DEVIATIONS.sub(rf"\1{_MIXED}", join_mixed(text.strip(), _MIXED))
    ways = [[whole]] if _is_value(whole, "") else []
    for stroke in _BETWEEN.finditer(whole):
        parts = [whole[: stroke.start()].strip(), whole[stroke.end() :].strip()]
        if all(not own or _is_value(own, other) for own, other in zip(parts, parts[::-1], strict=True)):
            ways.append(parts)
    if not ways:  # what is refused when it is read
        ways = [[part.strip() for part in _BETWEEN.split(whole, maxsplit=1)]]
    ways = [_with_units([part.replace(_MIXED, "/") for part in way]) for way in ways]
    if len(ways) > 1:
        raise GearlashError(
            f"{option} {text.strip()}: a stroke stands in a fraction, or between pinion and gear; here it "
            f"may be either: write {' or '.join(_plainly(way) for way in ways)}"
        )
    return ways[0]


def _is_value(text: str, other: str) -> bool:
    """One value: without a stroke between two, or a fraction, whose unit may stand behind the other one."""
    from gearlash.case.written_numbers import is_fraction

    return _BETWEEN.search(text) is None or is_fraction(text) or is_fraction(f"{text} {_unit(other)}")


def _with_units(parts: list[str]) -> list[str]:
    """One unit that stands for both, as in 34/32mm, behind either."""
    from gearlash.case.units import in_unit_of
    from gearlash.case.written_numbers import is_fraction

    if not all(parts) or len(parts) == 1:
        return parts
    found = []
    for own, other in zip(parts, parts[::-1], strict=True):
        lent = f"{own} {_unit(other)}"
        without = _has_limits(own) and not _unit(own)
        fraction = is_fraction(lent) and not is_fraction(own)
        found.append(lent.strip() if without or fraction else in_unit_of(other, own))
    return found


def _has_limits(text: str) -> bool:
    return _upper(text) != text


def _upper(text: str) -> str:
    """The greater one of two limits; a value without such as it is."""
    from gearlash.case.limits import ends_of
    from gearlash.case.units import UnitError

    try:
        ends = ends_of(text)
    except UnitError:  # told when it is read
        return text
    return text if ends is None else ends.upper


def _unit(text: str) -> str:
    from gearlash.case.units import behind_number

    return behind_number(_upper(text.replace(_MIXED, "/")).lstrip("øØ⌀ "))


def _plainly(parts: list[str]) -> str:
    from gearlash.case.written_numbers import plain_number

    return "/".join(plain_number(part.lstrip("øØ⌀ ")) for part in parts)
