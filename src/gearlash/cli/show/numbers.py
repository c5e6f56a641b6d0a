"""Numbers as text for people."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from math import atan2, ceil, degrees, floor, isfinite, log10

from gearlash.case.readable import readable

ASSUMED_MARK = "†"


def number(value: float | None, digits: int = 5) -> str:
    """Significant digits, ``3.2e8`` for the very large; a dash where there is none."""
    if value is None or not isfinite(value):
        return "–"
    text = f"{value:.{digits}g}"
    if abs(value) >= 1e6 and "e" not in text:
        text = f"{value:.{digits - 1}e}"
    mantissa, e, exponent = text.partition("e")
    if not e:
        return text
    return f"{mantissa.rstrip('0').rstrip('.') if '.' in mantissa else mantissa}e{int(exponent)}"


def known(value: float, uncertainty: float) -> str:
    """As many decimals as the uncertainty leaves."""
    return f"{value:.{max(0, -floor(log10(uncertainty)))}f}"


def at_least(value: float, digits: int) -> str:
    """Significant digits, rounded up and written out: what is shown is never less than it is."""
    places = digits - 1 - floor(log10(value))
    scaled = value * 10.0**places
    near = round(scaled)
    up = near if abs(scaled - near) <= 1e-9 * scaled else ceil(scaled)
    text = f"{up / 10.0**places:.{max(0, places)}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def quantity(value: float | None, unit: str, digits: int = 4) -> str:
    """With its unit, or one of the same kind that reads better."""
    if value is None or not isfinite(value):
        return "–"
    size, name = readable(value, unit)
    return f"{number(size, digits)} {name}"


def polar(real: float, imag: float, modulus: float) -> str:
    """A multiplier: real ones with sign, complex ones by modulus and angle."""
    if imag == 0.0:
        return f"{round(real, 4) + 0.0:.4f}"  # no -0.0000
    return f"{modulus:.4f} ∠{degrees(atan2(imag, real)):+.1f}°"


class Marks:
    """Marks physical numbers that rest on assumed values, and remembers which for the footnote."""

    def __init__(self, rests: Mapping[str, Iterable[str]]):
        self._rests = {kind: tuple(paths) for kind, paths in rests.items()}
        self._used: dict[str, None] = {}

    def __call__(self, text: str, *kinds: str) -> str:
        """The text with a mark if numbers of these kinds (length, model, …) rest on something assumed."""
        return self.of(text, [path for kind in kinds for path in self._rests.get(kind, ())])

    def of(self, text: str, rests_on: Iterable[str]) -> str:
        """The text with a mark if this is not empty."""
        paths = list(rests_on)
        if not paths or text == "–":
            return text
        self._used |= dict.fromkeys(paths)
        return f"{text} {ASSUMED_MARK}"

    def footnote(self, where: str = "gearlash check shows why") -> str | None:
        """Names the assumed values behind the marks; None if nothing was marked."""
        if not self._used:
            return None
        return f"{ASSUMED_MARK} rests on assumed values: {', '.join(in_short(self._used))} ({where})"


def in_short(paths: Iterable[str]) -> list[str]:
    """Paths; of three harmonics and more without a gap the first and the last."""
    rows: dict[str, dict[int, str]] = {}
    for path in paths:
        stem, _, end = path.rpartition("_")
        harmonic = int(end) if end.isdecimal() and stem else 1
        rows.setdefault(stem if harmonic > 1 else path, {})[harmonic] = path
    return [text for row in rows.values() for text in _row(row)]


def _row(row: Mapping[int, str]) -> list[str]:
    orders = sorted(row)
    if len(row) < 3 or orders != list(range(orders[0], orders[0] + len(row))):
        return list(row.values())
    return [f"{row[orders[0]]} to {row[orders[-1]]}"]
