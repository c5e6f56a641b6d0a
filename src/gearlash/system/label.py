"""What a motion is called: its signature, or what it is where it has none."""

from __future__ import annotations

from .signature import Signature
from .status import Named


class MotionKind(Named):
    """What a motion is that has no signature.

    ``APERIODIC`` motion does not repeat, ``NEUTRAL`` motion is one of a continuum, of ``UNRESOLVED`` motion
    nothing was proved. ``GRAZING`` motion touches a boundary, so it stands between two signatures. ``NONE``:
    no orbit was found there.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.MotionKind("aperiodic") is gl.MotionKind.APERIODIC
    True
    """

    APERIODIC = "aperiodic"
    NEUTRAL = "neutral"
    UNRESOLVED = "unresolved"
    GRAZING = "grazing"
    NONE = "none"

    def __repr__(self) -> str:
        return self.value


Label = Signature | MotionKind
"""What a motion is called. Either kind prints as its text, and is equal to it."""


def read_label(text: str | Label | None) -> Label | None:
    """The label that a text of a file stands for; None for an empty one: no motion was computed.

    Raises `GearlashError` for a text that is no label.
    """
    if text is None or isinstance(text, Label):
        return text
    text = str(text)
    if not text:
        return None
    return Signature.parse(text) if text[0].isdigit() else MotionKind(text)


def label_text(label: object) -> str:
    """The text of a label in files; empty where there is none."""
    return "" if label is None else str(label)
