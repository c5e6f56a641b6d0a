"""How a motion was followed along a parameter."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Literal

from gearlash.system import Label

INTERRUPTED = "interrupted"  # why a motion was not followed further


@dataclass(frozen=True)
class Passed:
    """A change of the motion on the way that is no grazing (none: no stable orbit was found there)."""

    kind: str
    value: float
    label_below: Label
    label_above: Label


@dataclass(frozen=True)
class Path:
    """Where the motion was followed to."""

    direction: Literal["down", "up"]
    reached: Annotated[float, "last value at which it was found"]
    ended: Annotated[str, "why it was not followed further"]
    decided: Annotated[
        bool, "whether a grazing, the end of the motion, or the end of the search is there; else it was lost"
    ]
    beyond: Annotated[str, "what the orbit does just beyond its grazing"]
    passed: Annotated[tuple[Passed, ...], "changes on the way that are no grazing"]
