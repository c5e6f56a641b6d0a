"""Estimates that rest on values with stated limits: their ranges with what those limits make of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Protocol

from gearlash.case.entries import Entry
from gearlash.case.stated import Stated

from . import play
from .entries import replaced
from .estimated import Completed
from .places import Places
from .rules import EntriesByKey

SAME = 1e-9
"""Of the width of a range: what moves an end by less does not."""
Ends = tuple[float, float]


class Completing(Protocol):
    """What is asked of a pair."""

    @property
    def places(self) -> Places:
        """Its places."""
        ...

    @property
    def stated(self) -> EntriesByKey:
        """Stated values."""
        ...

    @property
    def completed(self) -> Completed:
        """With what is estimated."""
        ...

    def with_stated(self, stated: EntriesByKey) -> Completing:
        """The pair with other stated values."""
        ...


def carried(pair: Completing) -> EntriesByKey:
    """Entries of a pair, the ranges of estimates as wide as limits of the values that they rest on make them.

    Each limit is looked at alone, all else as stated. For each end of the range of an estimate those limits
    that move it outwards are then taken together, so that the range is that of all of them where it grows or
    falls with each: the backlash of a chain of tolerances. Limits that no pair can have are left out.
    """
    entries = pair.completed.entries
    paths = sorted({entry.path for entry in pair.stated.values() if entry.limited})
    keys = [key for key, entry in entries.items() if entry.estimated]
    if not paths or not keys:
        return entries
    ends = _AtLimits(pair, {entry.path: entry for entry in pair.stated.values() if entry.limited}, {})
    wider = {key: _widened(key, entries[key], paths, ends) for key in keys}
    return {**entries, **wider}


def least_play_added(pair: Completing) -> float:
    """What the backlash at work has more than the stated one, m: the least of it with limits of temperatures
    and of the centre distance."""
    done = pair.completed
    ends = {}
    for entry in pair.stated.values():
        if entry.limited and entry.path in play.KEYS:
            looked = [(_at(pair, {entry.path: end}).play_added, end) for end in (entry.least, entry.greatest)]
            ends[entry.path] = min(looked)[1]
    return min(done.play_added, _at(pair, ends).play_added) if ends else done.play_added


def _at(pair: Completing, values: Mapping[str, float | None]) -> Completed:
    """The pair with other values, in SI."""
    stated = {path: Stated(float(value or 0.0), f"{value!r}") for path, value in values.items()}
    return pair.with_stated(replaced(pair.places, pair.stated, stated)).completed


@dataclass(frozen=True)
class _AtLimits:
    """Ranges of estimates of the pair with some values at one of their limits, each found once."""

    pair: Completing
    limited: Mapping[str, Entry]
    found: dict[tuple[tuple[str, int], ...], Mapping[str, Ends]]

    def of(self, key: str, at: tuple[tuple[str, int], ...]) -> Ends | None:
        """The range of one estimate; None where no such pair can be, or it is no estimate there."""
        if at not in self.found:
            self.found[at] = dict(self._ranges(at))
        return self.found[at].get(key)

    def _ranges(self, at: tuple[tuple[str, int], ...]) -> Iterator[tuple[str, Ends]]:
        values = {path: (self.limited[path].least, self.limited[path].greatest)[end] for path, end in at}
        done = _at(self.pair, values)
        if done.problems:
            return
        for key, entry in done.entries.items():
            if entry.estimated and entry.least is not None and entry.greatest is not None:
                yield key, (entry.least, entry.greatest)


def _widened(key: str, own: Entry, paths: list[str], at_limits: _AtLimits) -> Entry:
    """One estimate with the range that limits make, which are named as its reason."""
    least, greatest = own.least, own.greatest
    assert least is not None
    assert greatest is not None
    wide = [(least, greatest)]
    outwards: tuple[dict[str, tuple[float, int]], ...] = {}, {}
    for path in paths:
        for end in (0, 1):
            found = at_limits.of(key, ((path, end),))
            if found is None:
                continue
            wide.append(found)
            for side, by in enumerate((least - found[0], found[1] - greatest)):
                if by > max(SAME * (greatest - least), outwards[side].get(path, (0.0, 0))[0]):
                    outwards[side][path] = by, end
    for side in outwards:
        if len(side) > 1:
            together = at_limits.of(key, tuple((path, end) for path, (_, end) in sorted(side.items())))
            wide += [together] if together is not None else []
    moving = sorted({path for side in outwards for path in side})
    if not moving:
        return own
    why = f"{own.reason}; with the limits of {' and '.join(moving)}"
    low, high = min(one[0] for one in wide), max(one[1] for one in wide)
    return replace(own, least=low, greatest=high, reason=why)
