"""What kind of motion a label names, with the colour and the hatch it has in every figure."""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.orbits import Signature
from gearlash.system import GearlashError

from . import style


@dataclass(frozen=True)
class Regime:
    """A kind of motion: words, fill colour, hatch, colour of text on the fill."""

    words: str
    colour: str
    hatch: str = ""
    ink: str = style.INK


# From light to dark, so that a grey print tells them apart: lightness (CIE L*) 90, 75, 59 and 33.
FREE = Regime("no impacts", "#c9ebdd")
DRIVE = Regime("drive-side impacts", "#74c0ee")
BACK = Regime("drive- and back-side impacts", "#cd7f00")
APERIODIC = Regime("aperiodic", "#4d4d4d", ink="white")
NEUTRAL = Regime("neutral: one of a continuum", "white", "....")
UNRESOLVED = Regime("unresolved", "white", "xxxx")
ALL = (FREE, DRIVE, BACK, APERIODIC, NEUTRAL, UNRESOLVED)
NAMED = {"aperiodic": APERIODIC, "neutral": NEUTRAL}


def regime(label: str) -> Regime:
    """The regime of a label: P-Q-R (impacts of all clearances count), ``aperiodic``, or anything else:
    unresolved."""
    if label in NAMED:
        return NAMED[label]
    try:
        signature = Signature.parse(label)
    except GearlashError:
        return UNRESOLVED
    if signature.back_impacts:
        return BACK
    return DRIVE if signature.impacts else FREE


def short(label: str) -> str:
    """A label without R where the back side is not met: 1-1 for 1-1-0."""
    return label[:-2] if label.count("-") == 2 and label.endswith("-0") else label
