"""Where a panel is so crowded that a closer look is worth a panel of its own."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import KDTree

Array = NDArray[np.float64]
NEIGHBOURS = 9.0  # mm: things so near to each other are of one crowd
FEWEST = 4  # things of a crowd
AROUND = 3.5  # mm of room around a crowd
CLOSER = 1.3  # times as large as before, in one direction at least, is worth a look
SMALLEST, LARGEST = 0.08, 0.6  # of the panel: width and height of what is shown closer


@dataclass(frozen=True)
class Box:
    """A part of a panel, in shares of its width and height from the lower left corner."""

    left: float
    right: float
    low: float
    high: float

    def meets(self, other: Box) -> bool:
        """Whether two parts have some of the panel in common."""
        return (
            self.left < other.right and other.left < self.right
            and self.low < other.high and other.low < self.high
        )  # fmt: skip

    def with_(self, other: Box) -> Box:
        """The smallest part that holds both."""
        return Box(
            min(self.left, other.left), max(self.right, other.right),
            min(self.low, other.low), max(self.high, other.high),
        )  # fmt: skip


def crowds(
    places: Array,
    size: tuple[float, float],
    seen: tuple[float, float],
    most: int,
    owners: NDArray[np.int64] | None = None,
) -> list[Box]:
    """The parts of a panel that are crowded, those with the most things first, then from left to right.

    Parameters
    ----------
    places : ndarray of shape (m, 2)
        Of things, in shares of the panel.
    size, seen : tuple of float
        Of the panel, and of another one in which such a part is shown, mm.
    most : int
        Parts at the most.
    owners : ndarray of int, of shape (m,), optional
        To what each thing belongs: of one owner alone there is no crowd.

    Returns
    -------
    list of Box
    """
    if len(places) < FEWEST:
        return []
    pairs = KDTree(places * size).query_pairs(NEIGHBOURS, output_type="ndarray")
    count = len(places)
    graph = coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    groups = connected_components(graph, directed=False)[1]
    found: list[tuple[int, Box]] = []
    for group in range(int(groups.max()) + 1):
        mine = places[groups == group]
        alone = owners is not None and len(set(owners[groups == group].tolist())) < 2
        if len(mine) >= FEWEST and not alone:
            found.append((len(mine), _around(mine, size)))
    found = _apart(found)
    small = [e for e in found if max(e[1].right - e[1].left, e[1].high - e[1].low) <= LARGEST]
    worth = [each for each in small if _gain(each[1], size, seen) >= CLOSER]
    chosen = sorted(worth, key=lambda each: (-each[0], each[1].left))[:most]
    return sorted((box for _, box in chosen), key=lambda box: (box.left, box.low))


def _around(places: Array, size: tuple[float, float]) -> Box:
    ends = []
    for axis in (0, 1):
        low, high = float(places[:, axis].min()), float(places[:, axis].max())
        room = max(AROUND / size[axis], 0.5 * (SMALLEST - (high - low)))
        ends += [max(0.0, low - room), min(1.0, high + room)]
    return Box(*ends)


def _apart(found: list[tuple[int, Box]]) -> list[tuple[int, Box]]:
    """Those that overlap put together."""
    for i, (count, box) in enumerate(found):
        for k, (other_count, other) in enumerate(found[:i]):
            if box.meets(other):
                rest = [each for n, each in enumerate(found) if n not in (i, k)]
                return _apart([*rest, (count + other_count, box.with_(other))])
    return found


def _gain(box: Box, size: tuple[float, float], seen: tuple[float, float]) -> float:
    """How many times as large it is shown, in the direction in which that is more."""
    width, height = (box.right - box.left) * size[0], (box.high - box.low) * size[1]
    return max(seen[0] / width, seen[1] / height)
