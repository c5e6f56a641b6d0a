"""What stands for a letter that the encoding of a stream lacks."""

from __future__ import annotations

import re
import unicodedata

_GREEK = re.compile(r"GREEK (SMALL|CAPITAL) LETTER (\w+)")

_SPELLED = {
    "µ": "u",
    "μ": "u",
    "·": "*",
    "×": "x",
    "−": "-",
    "–": "-",
    "‑": "-",
    "…": "...",
    "≤": "<=",
    "≥": ">=",
    "±": "+/-",
    "∓": "-/+",
    "≠": "!=",
    "→": "->",
    "∠": "at ",
    "∂": "d",
    "√": "sqrt",
    "∞": "inf",
    "′": "'",
    "Ẋ": "X'",
    "″": "''",
    "’": "'",
    "“": '"',
    "”": '"',
    "°": " deg",
    "²": "^2",
    "³": "^3",
    "₁": "1",
    "₂": "2",
    "⁺": "+",
    "⁻": "-",
    "†": "*",
}


def spelled(letter: str) -> str:
    """In ASCII: by the table, a Greek letter by its name, others without accents, else a question mark."""
    if letter in _SPELLED:
        return _SPELLED[letter]
    greek = _GREEK.match(unicodedata.name(letter, ""))
    if greek:
        return greek[2].lower() if greek[1] == "SMALL" else greek[2].capitalize()
    bare = unicodedata.normalize("NFKD", letter).encode("ascii", "ignore").decode("ascii")
    return bare or "?"
