"""Values as a case states them: a number in SI with the text it was written as, its limits, where it is from,
and why."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum

from .errors import shown
from .limits import LONGEST, Ends, ends_of
from .quantity import Choice, Quantity
from .quantity import ValueRefusedError as ValueRefusedError
from .read_number import read_number
from .texts import refused
from .units import UnitError, in_si, in_unit_of, read
from .words import nearest_name


class Provenance(StrEnum):
    """Where a value is from. What a file does not say is ``given``.

    ``given`` is stated by the source of the case, ``inferred`` follows from what it states, ``assumed`` was
    chosen by whoever wrote the case, ``calibrated`` was fitted to measurements or results.
    """

    GIVEN = "given"
    INFERRED = "inferred"
    ASSUMED = "assumed"
    CALIBRATED = "calibrated"


@dataclass(frozen=True)
class Stated:
    """A value in SI (or the name of an option) with the text it was written as, provenance and reason; its
    limits, in SI, where they are stated."""

    value: float | str
    text: str
    provenance: Provenance = Provenance.GIVEN
    reason: str = ""
    least: float | None = None
    greatest: float | None = None


RANGE = "here stands one value; two ends go to gearlash tolerance with --limits, or to a sweep with --over"
MIDDLE = "the middle of its limits"
"""The reason of a value of which limits alone are stated."""
_STROKE = re.compile(r"(?<=[\w.])\s*/\s*(?=[-+]?[.\d])")
_FRACTION = re.compile(r"\s*\d+\s*/\s*\d+\s*(?:in|ft|[\"″”])", re.ASCII)
_KEYS = ("value", "range", "provenance", "reason")


def read_one(raw: object, place: Quantity | Choice) -> Stated:
    """As `read_stated`, where a value stands that has no limits. Raises `ValueRefusedError`."""
    stated = read_stated(raw, place)
    if stated.least is not None and isinstance(place, Quantity):
        raise ValueRefusedError(f"{place.expected} ({RANGE})")
    return stated


def read_stated(raw: object, place: Quantity | Choice) -> Stated:
    """A raw TOML value: plain, two limits, or ``{value = …, range = …, provenance = …, reason = …}`` with a
    value, its limits or both. Raises `ValueRefusedError`."""
    if not isinstance(raw, Mapping):
        return _plain_or_limits(raw, place)
    for key in raw:
        if key not in _KEYS:
            raise ValueRefusedError(
                f"a table of value, range, provenance and reason, without {key!r}", nearest_name(key, _KEYS)
            )
    if "value" not in raw and "range" not in raw:
        raise ValueRefusedError(
            'a table with a value, such as {value = …, provenance = "inferred", reason = "…"}'
        )
    provenance, reason = raw.get("provenance", "given"), raw.get("reason", "")
    if provenance not in tuple(Provenance):
        names = ", ".join(Provenance)
        raise ValueRefusedError(
            f"a provenance out of {names}, not {shown(provenance)}", _nearest(provenance, Provenance)
        )
    if not isinstance(reason, str):
        raise ValueRefusedError(f"a reason in words, not {shown(reason)}")
    if expected := refused(reason):
        raise ValueRefusedError(f"{expected} as its reason")
    stated = _in_table(raw, place)
    why = "; ".join(part for part in (reason, stated.reason) if part)
    return replace(stated, provenance=Provenance(str(provenance)), reason=why)


def _in_table(raw: Mapping[str, object], place: Quantity | Choice) -> Stated:
    """Value and limits of a table."""
    if "range" not in raw:
        return _plain_or_limits(raw["value"], place)
    if not isinstance(place, Quantity):
        raise ValueRefusedError("a table without range: names have no limits")
    limits = _plain_or_limits(raw["range"], place)
    if limits.least is None or limits.greatest is None:
        raise ValueRefusedError("a range of two limits, the smaller one first")
    if "value" not in raw:
        return limits
    value, text = read_number(raw["value"], place), _text_of(raw["value"])
    if not limits.least <= value <= limits.greatest:
        raise ValueRefusedError(f"a value within its range, {limits.text}")
    return Stated(value, f"{text}, {limits.text}", least=limits.least, greatest=limits.greatest)


def _plain_or_limits(raw: object, place: Quantity | Choice) -> Stated:
    """One value, or two limits, of which the middle is the value where none stands between them."""
    if isinstance(place, Choice):
        return Stated(_choice(raw, place), _text_of(raw))
    if isinstance(raw, list | tuple):
        return _limits(_ends_of_list(raw, place), " to ".join(map(_text_of, raw)), place)
    try:
        return Stated(read_number(raw, place), _text_of(raw))
    except ValueRefusedError as error:
        ends = _ends_of_text(raw, place)
        if ends is None:
            raise _with_stroke(raw, place, error) or error from None
        if why := _one_alone(place):
            expected = place.expected if place.reader is None else error.expected
            raise ValueRefusedError(f"{expected}; not two limits: {why}", error.nearest) from None
    return _limits(ends, _text_of(raw), place)


def _ends_of_text(raw: object, place: Quantity) -> Ends | None:
    if not isinstance(raw, str) or len(raw) > LONGEST or refused(raw):
        return None
    try:
        return ends_of(raw)
    except UnitError as error:
        raise ValueRefusedError(f"{place.expected}, or two limits ({error})") from None


def _ends_of_list(raw: Sequence[object], place: Quantity) -> Ends:
    if len(raw) != 2 or any(isinstance(end, str) and len(end) > LONGEST for end in raw):
        raise ValueRefusedError(f"{place.expected}, or two limits, the smaller one first")
    lower, upper = (_text_of(end) for end in raw)
    return Ends(in_unit_of(upper, lower), in_unit_of(lower, upper))


def _limits(ends: Ends, text: str, place: Quantity) -> Stated:
    """Both limits and the value between them."""
    if why := _one_alone(place):
        raise ValueRefusedError(f"{place.expected}, not two limits: {why}")
    least, greatest = _both(ends, place)
    if not least < greatest:
        swapped = f"{ends.upper} to {ends.lower}" if greatest < least else None
        raise ValueRefusedError("two different limits, the smaller one first", swapped)
    if ends.size and least < (size := read_number(ends.size, place)) < greatest:
        return Stated(size, text, least=least, greatest=greatest)
    middle = _middle(ends, place)
    middle = 0.5 * (least + greatest) if middle is None else middle
    why = f"{MIDDLE}, as {ends.size} does not lie between them" if ends.size else MIDDLE
    return Stated(middle, text, reason=why, least=least, greatest=greatest)


def _middle(ends: Ends, place: Quantity) -> float | None:
    """As the text of it in their unit would be read; None where they have two units."""
    try:
        (lower, own), (upper, other) = (read(end, place.dimension) for end in (ends.lower, ends.upper))
    except UnitError:
        return None
    return in_si(place.dimension, (lower + upper) / 2, own) if own == other else None


def _one_alone(place: Quantity) -> str:
    """Why no limits stand there; empty where they may."""
    any_between = "limits are of quantities that may have any value between"
    return place.alone or (any_between if place.integer else "")


def _both(ends: Ends, place: Quantity) -> tuple[float, float]:
    """Both limits in SI."""
    found, near, wrong = [], [], ""
    for text in (ends.lower, ends.upper):
        try:
            found.append(read_number(text, place))
            near.append(text)
        except ValueRefusedError as error:
            wrong = wrong or f"two limits, each {error.expected}; {text!r} is none"
            near += [error.nearest] if error.nearest else []
    if wrong:
        raise ValueRefusedError(wrong, " to ".join(near) if len(near) == 2 else None)
    return found[0], found[1]


def _with_stroke(raw: object, place: Quantity, error: ValueRefusedError) -> ValueRefusedError | None:
    """Of limits with a stroke between, which stands for pinion and gear elsewhere; None of other texts."""
    if not isinstance(raw, str) or len(raw) > LONGEST or error.nearest or place.reader is not None:
        return None
    if len(_STROKE.findall(raw)) != 1 or _FRACTION.match(raw) or _one_alone(place):
        return None
    ends = _STROKE.split(raw)
    for lower, upper in (ends, ends[::-1]):
        meant = f"{in_unit_of(upper, lower.strip())} to {in_unit_of(lower, upper.strip())}"
        try:
            read_stated(meant, place)
        except ValueRefusedError:
            continue
        return ValueRefusedError(f"{error.expected}; two limits stand without a stroke", meant)
    return None


def _text_of(raw: object) -> str:
    """As it was written, of a value that was read."""
    return raw if isinstance(raw, str) else str(raw)


def _choice(raw: object, place: Choice) -> str:
    if isinstance(raw, str) and place.takes(raw):
        return str(raw)
    if isinstance(raw, str) and place.reader is not None and len(raw) <= LONGEST:
        return place.reader(raw)
    raise ValueRefusedError(f"one of {', '.join(place.choices)}", _nearest(raw, place.choices))


def _nearest(raw: object, valid: Iterable[str]) -> str | None:
    return nearest_name(raw, [str(name) for name in valid]) if isinstance(raw, str) else None
