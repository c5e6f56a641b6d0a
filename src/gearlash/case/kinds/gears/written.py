"""What drawings write beside a number: a standard beside a class, a hand beside an angle, DP beside a pitch.

A reader makes of such a text the number of the place. A class of another standard is refused with the class
that is mostly taken for it: whoever knows the sheet decides.
"""

from __future__ import annotations

import re
from math import pi

from gearlash.case.quantity import ValueRefusedError
from gearlash.case.units import NUMBER, UnitError, read
from gearlash.gears import gear_fits, materials
from gearlash.gears.material_names import of_two_materials
from gearlash.system import GearlashError

CLASS = "a flank tolerance class of ISO 1328-1, a whole number from 1 to 12, such as 7"
_YEAR = r"(?:\s*[:-]?\s*(?:19|20)\d\d)?"
_STANDARDS = {
    "ISO": rf"(?:agma\s*)?(?:din\s*)?(?:en\s*)?iso(?![a-z])\s*(?:1328)?(?:-1)?(?:-?b14)?{_YEAR}"
    rf"|gb(?:/t)?\s*(?:10095)?(?:[.-]1)?{_YEAR}|jis\s*(?:b\s*1702)?(?:-1)?{_YEAR}\s*n\s*(?=\d)",
    "JIS": rf"jis\s*(?:b\s*1702)?{_YEAR}",
    "DIN": rf"\bdin\s*(?:396\d|58405)?{_YEAR}",
    "Q": r"(?:agma\s*)?(?:2000)?(?:-a88)?[\s-]*\bq\s*(?=\d)",
    "A": r"(?:agma\s*)?(?:2015)?(?:-1)?(?:-a01)?[\s-]*\ba\s*(?=\d)",
    "AGMA": r"agma\s*(?:2000|390)?(?:[.-]\w+)?",
}
"""What is written, in small letters: ISO 1328-1 and what is the same, and standards of other limits."""
_FOUND = {name: re.compile(text) for name, text in _STANDARDS.items()}
_DIGITS = re.compile(r"(?<![\d.,])\d{1,2}(?![\d.,])", re.ASCII)
_FIT = re.compile(
    r"(?<![a-z])(?P<letters>[a-h]{1,2})\s*(?P<number>2[1-9]|30)(?!\d)"
    r"|(?<!\d)(?P<first>2[1-9]|30)\s*(?P<behind>[a-h]{1,2})(?![a-z])"
)
_OF_FITS = re.compile(r"\(?din\s*3967(?:\s*[:-]\s*19\d\d(?:-\d\d)?)?\)?[\s:,;-]*")
_CLASS_BEFORE = re.compile(r"(?:[1-9]|1[0-2])(?:[\s,;-]+|(?=[a-h]))")
"""The quality that drawings set before a fit: 7 cd 25, 8e26."""
_LEFT = r"l\.?\s?h\.?|l|left|links(?:steigend|gängig)?|linkss?teigung|gauche|sinistra|izquierda|左旋?"
_RIGHT = r"r\.?\s?h\.?|r|right|rechts(?:steigend|gängig)?|rechtss?teigung|droite|destra|derecha|右旋?"
_HAND = re.compile(
    rf"[(\[]?(?:(?<![^\W\d_])|(?<=deg))(?:(?P<left>{_LEFT})|(?P<right>{_RIGHT}))"
    r"(?:[\s-]?hand(?:ed)?)?(?:\s+helix)?(?![^\W\d_])\.?[)\]]?",
    re.IGNORECASE,
)
_OF_BOTH = re.compile(r"\s*(?:/|;|\band\b|\bund\b)\s*")
_LARGEST = pi / 2.0
"""rad: an angle of more without a unit is in degrees, as a hand stands at no other number."""
_PITCH = re.compile(
    r"(?:d\.?p\.?|p_?(?:nd|[nd])?)?\s*=?\s*(\d[\d.,]*)\s*"
    r"(?:d\.?p\.?|(?:teeth\s*)?(?:/|per)\s*in(?:ch)?|1/in|in\^?-1|in⁻¹)?",
    re.IGNORECASE,
)


def tolerance_class(text: str) -> str:
    """The number of a class of ISO 1328-1, or of a standard that is the same one. Raises
    `ValueRefusedError`."""
    small = text.strip().casefold()
    standard = next((name for name, pattern in _FOUND.items() if pattern.search(small)), "")
    rest = _FOUND[standard].sub(" ", small) if standard else small
    fit = _FIT.search(rest)
    rest = _FIT.sub(" ", rest)
    found = [int(number) for number in _DIGITS.findall(rest)]
    if not found or re.search(r"\d[.,]\d|[+*]|^-|\d{3}|\de", rest):
        return text
    if len(found) > 1:
        raise ValueRefusedError(f"{CLASS}; here stand several, of which one holds", _class(max(found)))
    if standard in _TAKEN_FOR:
        why, taken = _TAKEN_FOR[standard]
        raise ValueRefusedError(f"{CLASS}; {why}", _class(taken(found[0])))
    if re.sub(r"\b(?:class|grade|klasse|quality|qualität|accuracy|no|nr|n)(?![a-z])|[\d\s.,:()-]", "", rest):
        raise ValueRefusedError(f"{CLASS}, without other words", _class(found[0]))
    if fit is not None:
        raise ValueRefusedError(f"{CLASS}; the fit beside it stands at fit", _class(found[0]))
    return str(found[0])


def _class(number: int) -> str | None:
    return str(number) if 1 <= number <= 12 else None


_OF_AGMA = (
    "Q numbers of AGMA 2000 grow as gears get finer, have other limits, and are mostly taken for 17 - Q"
)
_TAKEN_FOR = {
    "DIN": ("classes of DIN 3961 have limits of their own, and are mostly taken for the same number", int),
    "JIS": (
        "grades of JIS B 1702 of 1976 have limits of their own, and are mostly taken for those 4 above",
        lambda number: number + 4,
    ),
    "A": ("grades A of AGMA 2015 have limits of their own, and are mostly taken for the same number", int),
    "Q": (_OF_AGMA, lambda number: 17 - number),
    "AGMA": (_OF_AGMA, lambda number: 17 - number),
}
"""Standards with limits of their own: why, and the class that is mostly taken for it."""


def least_speed(text: str) -> str:
    """The least speed of a range. Raises `ValueRefusedError` for standstill, from which a range cannot begin:
    at a speed of 0 there is no mesh frequency."""
    if _NOUGHT.match(text):
        raise ValueRefusedError(
            "a speed above 0; of a range from standstill the least one that is to be examined, such as a "
            "twentieth of the greatest"
        )
    return text


_NOUGHT = re.compile(r"\s*[-+]?0+(?:[.,]0*)?(?![\d.,])")


def handed_angle(text: str) -> str:
    """An angle with the hand of the pinion's helix beside it, left-hand as below 0; or with the hands of both
    gears, of which one is the other's reverse. Raises `ValueRefusedError`."""
    plain = text.strip()
    if hand_of(plain) is None:
        return text
    both = [_parted(part) for part in _OF_BOTH.split(plain)]
    if None in both or len(both) > 2:
        return text
    hands, angles = [left for left, _ in filter(None, both)], [angle for _, angle in filter(None, both)]
    if len(both) == 2 and (hands[0] == hands[1] or len({a.lstrip("+-−–") for a in angles if a}) > 1):
        raise ValueRefusedError(
            "the hand of the pinion, or those of pinion and gear, of which one is left and one right and "
            "whose angles are the same where shafts are parallel"
        )
    angle, left = next(filter(None, angles), ""), hands[0]
    size, sign = angle.lstrip("+-−–").strip(), angle[:1]
    if sign in ("+", "-", "−", "–") and left != (sign != "+"):
        expected = (
            f"an angle by its sign or its hand, which are two here: {size} is right-hand, -{size} left-hand"
        )
        raise ValueRefusedError(expected)
    return f"-{_in_degrees(size)}" if left else _in_degrees(size)


def hand_of(text: str) -> str | None:
    """``left`` or ``right``: the first hand that stands in a text; None where there is none.

    Examples
    --------
    >>> from gearlash.case.kinds.gears.written import hand_of
    >>> hand_of("L15°"), hand_of("15 deg")
    ('left', None)
    """
    found = _HAND.search(text)
    return None if found is None else str(found.lastgroup)


def _parted(text: str) -> tuple[bool, str] | None:
    """Whether the one hand that stands there is left, and the angle without it; None of none or several."""
    found = list(_HAND.finditer(text))
    if len(found) != 1:
        return None
    at = found[0]
    return at.lastgroup == "left", (text[: at.start()] + text[at.end() :]).strip(" ,;:")


def _in_degrees(size: str) -> str:
    """With its unit, where only degrees can be meant."""
    try:
        number, found = read(size)
    except UnitError:
        return size
    return f"{size} deg" if found.dimension == NUMBER and number > _LARGEST else size


def diametral_pitch(text: str) -> str:
    """The number of ``8 DP``, ``8/in`` or ``P8``."""
    found = _PITCH.fullmatch(text.strip())
    return text if found is None else found[1]


def fit(text: str) -> str:
    """A fit of DIN 3967 as ``25cd``, of ``cd25`` or ``DIN 3967 - 25 cd``. Raises `ValueRefusedError`."""
    plain = _OF_FITS.sub(" ", text.strip().casefold()).strip()
    before = _CLASS_BEFORE.match(plain)
    found = [name for each in _FIT.finditer(plain) if (name := _fit_named(each)) is not None]
    for rest in (plain, plain[before.end() :] if before else plain):
        whole = _FIT.fullmatch(rest)
        if whole is not None and (name := _fit_named(whole)) is not None:
            return name
    series = ", ".join(gear_fits.ALLOWANCE_SERIES)
    several = "; here stand several" if len(found) > 1 else ""
    raise ValueRefusedError(
        f"a fit of DIN 3967: tolerance series 21 to 30 and allowance series {series}, such as 25cd{several}",
        found[0] if len(found) == 1 else None,
    )


def _fit_named(found: re.Match[str]) -> str | None:
    letters = found["letters"] or found["behind"]
    known = letters in gear_fits.ALLOWANCE_SERIES
    return f"{found['number'] or found['first']}{letters}" if known else None


def material(text: str) -> str:
    """A material as the drawing names it, where that has a modulus. Raises `ValueRefusedError`."""
    either = of_two_materials(text)
    if either:
        raise ValueRefusedError(f"{either}: the number alone may be either")
    try:
        materials.named(text)
    except GearlashError:
        expected = (
            f"a material of the list ({', '.join(materials.MATERIALS)}) or a designation with the modulus of "
            "one; for another one the nearest of these, beside it youngs_modulus, poisson_ratio, "
            "density and thermal_expansion"
        )
        words = [word for word in re.findall(r"[^\s,;()]*\d[^\s,;()]*", text) if materials.is_listed(word)]
        near = words[0] if len(words) == 1 else materials.nearest_name(text)  # 16MnCr5 case-hardened
        raise ValueRefusedError(expected, near) from None
    return text.strip()
