"""Answers to other questions: moved out of the way of a new one, and put back where that is refused."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import count
from pathlib import Path

from .hold import Hold
from .marker import MARKER, Marker
from .question import fingerprint
from .terminal import tell


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


def set_aside(path: Path, wanted: Iterable[str], marker: Marker, held: Hold) -> Marker:
    """Moves answers to other questions away that have a wanted name, each whole, and says where they are. One
    that has changed since it was left is of no question that is known. Returns the note without them."""
    own = [name for name in wanted if name in marker.files]
    mine = marker.of(fingerprint())
    changed = bool(fingerprint()) and not marker.as_left(path, mine)
    asked = {**marker.asked, **(dict.fromkeys(mine, "") if changed else {})}
    others = {asked.get(name, "") for name in own if (path / name).exists()} - {fingerprint()}
    names = {name for name, one in asked.items() if one in others}
    names |= {name for name in own if asked.get(name, "") in others}  # of a version that noted no question
    moved = sorted(name for name in names if (path / name).exists())
    if moved:
        aside = _moved(path, moved, held)
        how = "changed since, or with" if changed and names.intersection(mine) else "with"
        tell(f"what was answered there before, {how} other values or options, is kept in {aside}")
    return marker.without({*(names if moved else ()), *(mine if changed else ())})


def _moved(path: Path, names: Sequence[str], held: Hold) -> Path:
    """Where they are after it."""
    places = (path / f"earlier-{number}" for number in count(1))
    aside = next(place for place in places if not os.path.lexists(place))
    marker = (path / MARKER).read_bytes()
    aside.mkdir()
    _MOVED.append(_Moved(path, aside, names, marker, held))
    for name in names:
        (path / name).rename(aside / name)
    return aside
