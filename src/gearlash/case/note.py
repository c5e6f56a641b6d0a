"""A remark on one value of a case."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Note:
    """A remark on one value: its path and a sentence."""

    path: str
    text: str
