"""What is compared of two motions: whether teeth part, whether their back sides touch, and the label."""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.system import GearlashError, MotionKind, Signature, read_label

from .lumped import LumpedPoint
from .point import PointFound


@dataclass(frozen=True)
class Seen:
    """What a motion does.

    Attributes
    ----------
    parts, back : bool or None
        Whether teeth part, and whether back sides touch; None where it is not known.
    label : str
        P-Q-R of a periodic motion; empty where none was found.
    """

    parts: bool | None
    back: bool | None
    label: str


def seen_of_label(label: str) -> Seen:
    """What a label says by itself.

    Parameters
    ----------
    label : str
        P-Q-R, or what the motion is where it has none.

    Returns
    -------
    Seen
        Of a motion that is not periodic: teeth part, as one that never leaves a region of a linear model with
        damping goes to its periodic motion there. Of anything else without a label nothing is known.

    Examples
    --------
    >>> from gearlash.studies.verification.alike import seen_of_label
    >>> seen_of_label("2-1-0")
    Seen(parts=True, back=False, label='2-1-0')
    """
    try:
        read = read_label(label)
    except (GearlashError, ValueError):
        return Seen(None, None, "")
    if not isinstance(read, Signature):
        return Seen(True if read is MotionKind.APERIODIC else None, None, "")
    return Seen(read.impacts > 0, read.back > 0, label)


def seen_of_lumped(point: LumpedPoint) -> Seen:
    """Of a motion of the lumped model.

    Parameters
    ----------
    point : LumpedPoint

    Returns
    -------
    Seen
    """
    return seen_of_label(point.label)


def seen_of_teeth(point: PointFound) -> Seen:
    """Of a motion of real teeth: its label, or what was seen in the cycles that were read.

    Parameters
    ----------
    point : PointFound

    Returns
    -------
    Seen
    """
    reading = point.reading
    label = "" if reading.label is None else str(reading.label)
    return Seen(reading.apart > 0.0, reading.back_impacts > 0 or reading.most_back > 0.0, label)
