"""How people write numbers and units, brought into one form: 3.4·10⁸ N/m, 3.4 × 10^8 N/m, min⁻¹, µm."""

from __future__ import annotations

import re

from .written_numbers import plain_number

_SIGNS = str.maketrans(
    {"µ": "u", "μ": "u", "−": "-", "–": "-", "·": "*", "⋅": "*", "∙": "*", "•": "*", "×": "*", "°": " deg "}
    | dict.fromkeys("º˚", " deg ")  # an ordinal and a ring, which look like degrees
    | dict.fromkeys("\u00a0\u2002\u2003\u2007\u2009\u202f\u3000", " ")
    | {0xFF10 + digit: str(digit) for digit in range(10)}
)
"""Signs that look alike, spaces, and the wide digits of Japanese keyboards."""
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻", "0123456789+-")
_SUPERSCRIPT = re.compile("[⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻]+")
_POWER = re.compile(
    r"([+-]?)(?:(\d+(?:\.\d*)?|\.\d+)\s*[*xX]\s*)?10\s*(?:\^|\*\*)\s*(\(?)([+-]?\d+)(\)?)", re.ASCII
)
_PER = re.compile(r"/\s*(?=(?:min|s|h|K|deg[CF])$)")
_CELSIUS = re.compile(r"℃|(?:[°º˚]|deg\b)\s*C\b")
_FAHRENHEIT = re.compile(r"℉|(?:[°º˚]|deg\b)\s*F\b")
_INCHES = re.compile(r"""(?<=[\d.])\s*(?:["″”]|''|′′)$""", re.ASCII)
_MINUTES = re.compile(
    r"""([+-]?)(\d+)\s*deg\s*(\d{1,2}(?:\.\d*)?)\s*['′´’](?:\s*(\d{1,2}(?:\.\d*)?)\s*(?:["″”]|''|′′))?""",
    re.ASCII,
)
_BELOW = re.compile(r"/\s*\(([^()/]+)\)")
_HYPHEN = re.compile(r"(?<=[A-Za-z])[-.](?=[A-Za-z])")


def plain(text: str) -> str:
    """A text with ASCII signs: superscripts as ``^2``, products as ``*``, spaces as such."""
    degrees = _FAHRENHEIT.sub(" degF", _CELSIUS.sub(" degC", text))
    raised = _SUPERSCRIPT.sub(lambda m: f"^{m[0].translate(_RAISED)}", degrees)
    return raised.translate(_SIGNS).strip()


def plain_value(text: str) -> str:
    """The same of a number with its unit; a power of ten before the unit as ``e8``, inches as ``in``. Raises
    `NumberError`."""
    signs = plain(text)
    if "deg" not in signs:  # where they are seconds
        signs = _INCHES.sub(" in", signs)
    found = _in_degrees(plain_number(signs))
    power = _POWER.match(found)
    if power is None or len(power[3]) != len(power[5]):
        return found
    sign, number, _, exponent, _ = power.groups()
    return f"{sign}{number or '1'}e{exponent}{found[power.end() :]}"


def _in_degrees(text: str) -> str:
    """An angle in degrees, minutes and seconds, 15°30′, as decimal degrees; other texts as they are."""
    match = _MINUTES.fullmatch(text)
    if match is None or float(match[3]) >= 60.0 or float(match[4] or 0) >= 60.0:
        return text
    size = int(match[2]) + float(match[3]) / 60.0 + float(match[4] or 0) / 3600.0
    return f"{match[1]}{size!r} deg"


def plain_unit(text: str) -> str:
    """A unit as products of words: ``/min`` behind a number is ``1/min``, ``N-m`` and ``N.m`` are ``N*m``,
    ``N/(mm um)`` is ``N/mm/um``."""
    text = _BELOW.sub(lambda m: "/" + "/".join(re.split(r"[\s*·⋅×]+", m[1].strip())), text)
    return _HYPHEN.sub("*", _PER.sub("1/", plain(text), count=1) if text.startswith("/") else plain(text))
