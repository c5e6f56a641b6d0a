"""Answers to other questions: moved out of the way of a new one, and put back where that is refused."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import Any

from .hold import Hold
from .question import fingerprint
from .terminal import tell

MARKER = ".gearlash.json"


@dataclass(frozen=True)
class _Moved:
    """Names that went from a folder to a place in it, and the marker file that knew them there."""

    folder: Path
    place: Path
    names: Sequence[str]
    marker: bytes
    held: Hold


_MOVED: list[_Moved] = []  # by the command that runs


def settle(*, refused: bool) -> None:
    """At the end of a command: of one that was refused, and wrote nothing in its place, all is put back."""
    while _MOVED:
        moved = _MOVED.pop()
        if refused and not any(os.path.lexists(moved.folder / name) for name in moved.names):
            with suppress(OSError):  # then it stays where it is kept, as was told
                _put_back(moved)


def _put_back(moved: _Moved) -> None:
    for name in moved.names:
        (moved.place / name).rename(moved.folder / name)
    (moved.folder / MARKER).write_bytes(moved.marker)
    moved.place.rmdir()
    tell(f"nothing was answered, so what was kept in {moved.place} is back in its place")


def noted(marker: dict[str, Any], own: set[str]) -> dict[str, str]:
    """The question that each own name is an answer to. A folder from elsewhere may name any place, and what
    gearlash did not write: those are no names."""
    found = marker.get("asked", {})
    if not isinstance(found, dict):
        return {}
    return {name: str(one) for name, one in found.items() if name in own and _is_name(name)}


def _is_name(name: str) -> bool:
    """Whether this names something in a folder; the marker itself is no answer."""
    return name == Path(name).name and name not in ("", ".", "..", MARKER)


def set_aside(path: Path, wanted: Iterable[str], asked: dict[str, str], held: Hold) -> list[str]:
    """Moves answers to other questions away that have a wanted name, each whole, and says where they are."""
    others = {asked.get(name, "") for name in wanted if (path / name).exists()} - {fingerprint()}
    names = {name for name, one in asked.items() if one in others}
    names |= {name for name in wanted if asked.get(name, "") in others}  # of a version that noted no question
    moved = sorted(name for name in names if (path / name).exists())
    if not moved:
        return []
    places = (path / f"earlier-{number}" for number in count(1))
    aside = next(place for place in places if not os.path.lexists(place))
    marker = (path / MARKER).read_bytes()
    aside.mkdir()
    _MOVED.append(_Moved(path, aside, moved, marker, held))
    for name in moved:
        (path / name).rename(aside / name)
    tell(f"what was answered there before, with other values or options, is kept in {aside}")
    return moved
