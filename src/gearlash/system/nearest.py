"""The valid name that was probably meant."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Mapping

LONGEST_NAME = 60  # longer ones are no misspelt names
ALIKE = 0.65  # of difflib: bakclash and backlash have 0.88, power and order 0.60, torque and error 0.55
SHORTEST_PART = 4  # letters: of shorter words too many names have a part


def nearest(
    name: object, valid: Iterable[str], other_words: Mapping[str, tuple[str, ...]] | None = None
) -> str | None:
    """The valid name that looks like this one, large letters or small, if any does.

    A name that is a part of one valid name only stands for that, too (``speed``: ``pinion_speed``).
    ``other_words`` are names in use elsewhere, each with those that they may mean here.
    """
    if not isinstance(name, str) or len(name) > LONGEST_NAME:
        return None
    by_look = {_look(each): each for each in valid}
    look = _look(name)
    if look.removesuffix("_1") in by_look:  # ripple_1: the first harmonic carries no number
        return by_look[look.removesuffix("_1")]
    for meant in (other_words or {}).get(look, ()):
        if _look(meant) in by_look:
            return by_look[_look(meant)]
    found = difflib.get_close_matches(look, list(by_look), n=1, cutoff=ALIKE)
    if found:
        return by_look[found[0]]
    having = [
        each for part, each in by_look.items() if len(look) >= SHORTEST_PART and look in part.split("_")
    ]
    return having[0] if len(having) == 1 else None


def _look(name: str) -> str:
    return name.casefold().replace("-", "_").replace(" ", "_")
