"""What kind of motion a label names, with the colour and the hatch it has in every figure."""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.system import Label, MotionKind, Signature, label_text

from . import style


@dataclass(frozen=True)
class Regime:
    """A kind of motion: words, fill colour, hatch, colour of text on the fill."""

    words: str
    colour: str
    hatch: str = ""
    ink: str = style.INK


# A grey print tells them apart: lightness (CIE L*) 90, 75, 82, 59 and 33.
FREE = Regime("no impacts", "#c9ebdd")
DRIVE = Regime("drive-side impacts", "#74c0ee")
BACK_ONLY = Regime("back-side impacts", "#f0c987")
BACK = Regime("drive- and back-side impacts", "#cd7f00")
APERIODIC = Regime("aperiodic", "#4d4d4d", ink="white")
NEUTRAL = Regime("neutral: one of a continuum", "white", "....")
UNRESOLVED = Regime("unresolved", "white", "xxxx")
ALL = (FREE, DRIVE, BACK_ONLY, BACK, APERIODIC, NEUTRAL, UNRESOLVED)
BY_KIND = {MotionKind.APERIODIC: APERIODIC, MotionKind.NEUTRAL: NEUTRAL}


def regime(label: Label | None) -> Regime:
    """The regime of a label; the impacts of all clearances count."""
    if not isinstance(label, Signature):
        return UNRESOLVED if label is None else BY_KIND.get(label, UNRESOLVED)
    if label.back_impacts:
        return BACK if label.impacts > label.back_impacts else BACK_ONLY
    return DRIVE if label.impacts else FREE


def short(label: Label | str | None) -> str:
    """A label, or its text, without R where the back side is not met: 1-1 for 1-1-0. Other words stay."""
    if isinstance(label, Signature):
        return label.short
    text = label_text(label)
    return text[:-2] if text.count("-") == 2 and text.endswith("-0") else text
