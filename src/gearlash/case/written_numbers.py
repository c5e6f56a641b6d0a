"""Numbers as drawings write them, in one form: 0,5 and 1.234,5 of Germany, 1,234.5 and 1 1/4 of the USA.

What can mean two numbers is refused with both: 1,250 is one and a quarter in Germany, and in the USA twelve
hundred and fifty.
"""

from __future__ import annotations

import re

_VULGAR = dict(zip("½¼¾⅛⅜⅝⅞", ("1/2", "1/4", "3/4", "1/8", "3/8", "5/8", "7/8"), strict=True))
_HALVINGS = "2|4|8|16|32|64"
_HALVED = rf"(\d{{1,2}})/({_HALVINGS})(?![\d.,])"
_MIXED = re.compile(rf"([+-]?)(\d{{1,4}})(?:\s+|-){_HALVED}", re.ASCII)
_MIXED_ANYWHERE = re.compile(rf"(\d[\s-]\d{{1,2}})/({_HALVINGS})(?!\d)", re.ASCII)
_OF_THE_USA = r"""\s*(?:(?:in|ft|lb|oz|mil(?!li)|thou|pound|b?hp)[a-z]*\b|["″”]|''|′′)"""
_FRACTION = re.compile(rf"([+-]?){_HALVED}(?={_OF_THE_USA})", re.ASCII | re.IGNORECASE)
"""Before units that are halved and quartered: 3/4 in, 1/2 lb."""
_GROUPED = (
    (re.compile(r"[+-]?\d{1,3}(?:\.\d{3})+,\d+", re.ASCII), "."),
    (re.compile(r"[+-]?\d{1,3}(?:,\d{3})+\.\d+", re.ASCII), ","),
    (re.compile(r"[+-]?\d{1,3}(?:\.\d{3}){2,}(?![\d.,])", re.ASCII), "."),
    (re.compile(r"[+-]?\d{1,3}(?:,\d{3}){2,}(?![\d.,])", re.ASCII), ","),
)
"""Thousands set apart beyond doubt, and the sign that does it."""
_COMMA = re.compile(r"([+-]?)(\d*),(\d+)(?![,\d])", re.ASCII)
_SPACED = re.compile(r"[+-]?\d{1,3}(?:[ '’]\d{3})+(?![\d])(?:[.,]\d+)?", re.ASCII)


class UnitError(ValueError):
    """The text is no physical value; its message says what is wrong with it."""


class NumberError(UnitError):
    """A number that can be read in two ways, or is set apart; the message says how to write it."""


def is_fraction(text: str) -> bool:
    """Is the text one fraction without a whole number before it, as 3/4 in?"""
    found = _FRACTION.match(_written_out(text.strip().lstrip("øØ⌀")))
    return found is not None and re.search(r"/\s*(?:[-+.\d]|$)", found.string[found.end() :]) is None


def join_mixed(text: str, stroke: str) -> str:
    """A text with another stroke in its mixed numbers, as the 1 1/2 of 1 1/2/1 1/4 in."""
    return _MIXED_ANYWHERE.sub(lambda found: f"{found[1]}{stroke}{found[2]}", text)


def plain_number(text: str) -> str:
    """A text whose number at its beginning has a decimal point and nothing between its digits. Raises
    `NumberError`."""
    text = _written_out(text)
    for pattern in (_MIXED, _FRACTION):
        found = pattern.match(text)
        if found is not None:
            sign, *whole, above, below = found.groups()
            value = int(whole[0] if whole else 0) + int(above) / int(below)
            return f"{sign}{value!r}{text[found.end() :]}"
    for pattern, between in _GROUPED:
        found = pattern.match(text)
        if found is not None:
            return found[0].replace(between, "").replace(",", ".") + text[found.end() :]
    spaced = _SPACED.match(text)
    if spaced is not None:
        together = re.sub(r"[ '’]", "", spaced[0]).replace(",", ".")
        raise NumberError(f"digits are written without anything between them: {together}")
    return _with_point(text)


def _written_out(text: str) -> str:
    for sign, halves in _VULGAR.items():
        text = text.replace(sign, f" {halves}").strip()
    return text


def _with_point(text: str) -> str:
    found = _COMMA.match(text)
    if found is None:
        return text
    sign, whole, behind = found.groups()
    if len(behind) == 3 and 1 <= len(whole) <= 3 and not whole.startswith("0"):
        both = f"{sign}{whole}.{behind} or {sign}{whole}{behind}"
        raise NumberError(f"a comma before three digits may stand before decimals or thousands: write {both}")
    return f"{sign}{whole}.{behind}{text[found.end() :]}"
