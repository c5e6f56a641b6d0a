"""Where impact-free motion exists."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated


@dataclass(frozen=True)
class ImpactFree:
    """Where impact-free motion exists around a speed (values of ω); null: not met within the search."""

    here: Annotated[bool, "an impact-free motion exists at this speed (perhaps beside the one found)"]
    lower: Annotated[float | None, "lower end of the impact-free interval that holds this speed"]
    upper: Annotated[float | None, "its upper end"]
    nearest: Annotated[float | None, "nearest impact-free speed when there is none here"]
    searched_from: float
    searched_to: float
