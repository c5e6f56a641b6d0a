"""Two limits of a quantity in one text, as drawings and data sheets have them: 60 to 140 um, 0.06:0.14 mm,
0,06–0,14 mm, 0.1 mm ± 0.04, 32.83 mm -0.05/-0.08, 150 N·m ± 10 %."""

from __future__ import annotations

import re
from dataclasses import dataclass
from fractions import Fraction

from .spelling import plain
from .units import Unit, UnitError, behind_number, in_unit_of, read, unit

_WORDS = re.compile(r"\s*(?::|\.\.+|…|~|∼|～|—)\s*|\s+(?:to|bis|à|and|und)\s+", re.IGNORECASE)
_HYPHEN = re.compile(r"(?<=[\w%\"'²³)])(?<![\d.][eE])(-|\s+-\s+)(?=[+-]?[.,]?\d)")
"""Between two values: with blanks on both sides or on none, and in no exponent."""
_BEFORE = re.compile(r"^(?:from|between|von|zwischen)\s+", re.IGNORECASE)
_BRACKETED = re.compile(r"\(([^()]*)\)\s*([^()]*)")
_BEGINS = re.compile(r"[+-]?\s*[øØ⌀]?\s*[.,]?\d")
_NUMBER = r"(?:\d+(?:[.,]\d+)*|[.,]\d+)(?:[eE][+-]?\d+)?"
_SIZE = rf"(?P<size>[øØ⌀]?\s*[+-]?{_NUMBER})\s*(?P<unit>(?:[^\s\d+-][^+-]*?)?)"
_EITHER_WAY = re.compile(rf"{_SIZE}\s*(?:±|\+\s*/?\s*-)\s*(?P<off>{_NUMBER})\s*(?P<last>[^\d].*)?")
_ALONE = re.compile(r"^(?:±|\+\s*/\s*-)")
"""Of what is an allowance itself: ±20 um."""
_OFF = rf"(?:\s*[+-]\s*{_NUMBER}|\s+0(?![.,\d]))"
_TWO_WAYS = re.compile(
    rf"{_SIZE}(?P<first>{_OFF})\s*(?P<between>[^\s\d/;+-][^\d/;+-]*?)?\s*[/;\s]"
    rf"(?P<second>\s*[+-]\s*{_NUMBER}|\s*0(?![.,\d]))\s*(?P<last>[^\d].*)?"
)
PERCENT = "%"
LONGEST = 200
"""Characters of a number with its unit, and of two."""


@dataclass(frozen=True)
class Ends:
    """Both limits as texts with their units; ``size`` is what deviations were counted from, if they were."""

    lower: str
    upper: str
    size: str = ""


def ends_of(text: str) -> Ends | None:
    """The limits that a text has; None where it has not two.

    A unit behind one of them holds for both, and so it does for a size and its deviations; a deviation in per
    cent is a part of the size, unless that is in per cent as well. Raises `UnitError` for deviations that
    cannot be counted from their size.
    """
    if len(text) > LONGEST:
        return None
    whole = plain(text)
    found = _BRACKETED.fullmatch(whole)
    whole = _BEFORE.sub("", f"{found[1]} {found[2]}".strip() if found else whole)
    return _with_deviations(whole) or _between(whole)


def _between(text: str) -> Ends | None:
    for pattern in (_WORDS, _HYPHEN):
        cuts = list(pattern.finditer(text))
        if not cuts:
            continue
        lower, upper = text[: cuts[0].start()].strip(), text[cuts[0].end() :].strip()
        if len(cuts) > 1 or not (_BEGINS.match(lower) and _BEGINS.match(upper)):
            return None
        return Ends(in_unit_of(upper, lower), in_unit_of(lower, upper))
    return None


def _with_deviations(text: str) -> Ends | None:
    text = _ALONE.sub("0 ±", text)
    found = _EITHER_WAY.fullmatch(text)
    if found is not None:
        last = _word(found["last"])
        off = f"{found['off']} {last or _word(found['unit'])}".strip()
        return _counted(found["size"], _word(found["unit"]) or _of_size(last), (f"-{off}", off))
    found = _TWO_WAYS.fullmatch(text)
    if found is None:
        return None
    own, between, last = (_word(found[name]) for name in ("unit", "between", "last"))
    first = f"{_signed(found['first'])} {between or last or own}".strip()
    second = f"{_signed(found['second'])} {last or between or own}".strip()
    return _counted(found["size"], own or _of_size(last) or _of_size(between), (first, second))


def _word(text: str | None) -> str:
    return (text or "").strip()


def _of_size(word: str) -> str:
    """The unit of a size that has none of its own: that of its deviations, of which per cent say nothing."""
    return "" if word == PERCENT else word


def _signed(text: str) -> str:
    return re.sub(r"\s", "", text)


def _counted(size: str, word: str, deviations: tuple[str, str]) -> Ends:
    """Both limits in the unit of the size."""
    bare = size.lstrip("øØ⌀ ")
    whole = f"{bare} {word}".strip()
    number, own = read(whole)
    ends = sorted(number + _deviation(text, number, own) for text in deviations)
    lower, upper = (f"{float(end)!r} {behind_number(whole)}".strip() for end in ends)
    return Ends(lower, upper, whole)


def _deviation(text: str, size: Fraction, own: Unit) -> Fraction:
    off, its = read(text)
    percent = unit(PERCENT)
    if its == percent and own != percent:
        return abs(size) * off * its.ratio
    if (its.dimension, its.pi_power) != (own.dimension, own.pi_power):
        raise UnitError(f"the deviation {text} is no part of a size in another unit")
    return off * its.ratio / own.ratio
