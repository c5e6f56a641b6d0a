"""Answers to other questions: moved out of the way of a new one."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from itertools import count
from pathlib import Path

from .marker import Marker
from .question import fingerprint
from .terminal import tell


def set_aside(path: Path, wanted: Iterable[str], marker: Marker) -> Marker:
    """Moves answers to other questions away that have a wanted name, each whole, and says where they are. One
    that has changed since it was left is of no question that is known. Returns the note without them."""
    own = [name for name in wanted if name in marker.files]
    mine = marker.of(fingerprint())
    changed = not marker.as_left(path, mine)
    asked = {**marker.asked, **(dict.fromkeys(mine, "") if changed else {})}
    others = {asked.get(name, "") for name in own if (path / name).exists()} - {fingerprint()}
    names = {name for name, one in asked.items() if one in others}
    names |= {name for name in own if asked.get(name, "") in others}  # of a version that noted no question
    moved = sorted(name for name in names if (path / name).exists())
    if moved:
        aside = _moved(path, moved)
        how = "changed since, or with" if changed and names.intersection(mine) else "with"
        tell(f"what was answered there before, {how} other values or options, is kept in {aside}")
    return marker.without({*(names if moved else ()), *(mine if changed else ())})


def _moved(path: Path, names: Sequence[str]) -> Path:
    """Where they are after it."""
    places = (path / f"earlier-{number}" for number in count(1))
    aside = next(place for place in places if not os.path.lexists(place))
    aside.mkdir()
    for name in names:
        (path / name).rename(aside / name)
    return aside
