"""How much work the following of branches may be, and what is left out when it is spent.

Counted, not timed: so results are the same on every machine and for any number of workers."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TypeVar

from gearlash.branches.continuation import Branch
from gearlash.results import Axis, Point, Sweep

T = TypeVar("T")

ORBIT = 8  # work of an orbit of a branch, besides one for each of its periods: about 1 ms of a processor each
USUAL = 60  # orbits of a branch
FEWEST = 20  # orbits of a branch each way, however long they are
BRANCH = 6  # one branch may take this part of all work, each way
MANY = 1_000  # orbits of a branch each way where the work is not limited


@dataclass(eq=False)
class Work:
    """``most``: units of work, None for as much as there is; ``spent`` of them; ``left_out``: motions that
    were not followed and ends beyond which was not looked as it was spent."""

    most: int | None = None
    spent: int = 0
    left_out: int = 0

    @property
    def limited(self) -> bool:
        return self.most is not None

    @property
    def left(self) -> int:
        """Units that are left of limited work."""
        return 0 if self.most is None else max(0, self.most - self.spent)

    def afforded(self, wanted: Sequence[T], period: Callable[[T], int]) -> list[T]:
        """The first of those wanted whose branches, as long as usual, take no more than is left."""
        if not self.limited:
            return list(wanted)
        chosen, left = [], self.left
        for one in wanted:
            expected = USUAL * of_orbit(period(one))
            if expected <= left:
                chosen.append(one)
                left -= expected
        return chosen

    def orbits_each_way(self, period: int) -> int:
        """How many orbits a branch may have each way."""
        return MANY if self.most is None else max(FEWEST, self.most // (BRANCH * of_orbit(period)))

    def followed(self, branch: Branch, orbits: int) -> None:
        """Counts a branch, for which so many orbits were computed."""
        self.spent += orbits * of_orbit(branch.points[0].period)

    def looked(self, motions: int) -> None:
        """Counts motions that were followed to what attracts them, each as much as ten orbits."""
        self.spent += 10 * ORBIT * motions


def of_orbit(period: int) -> int:
    """Work of an orbit of a branch."""
    return ORBIT + period


@dataclass(frozen=True)
class Changes:
    """Parts of an axis beside which sweeps come from motion without impacts to motion with them, or do not
    agree: there ends of zones lie."""

    spans: tuple[tuple[float, float], ...]

    @staticmethod
    def of(sweeps: Iterable[Sweep], axis: Axis) -> Changes:
        rows = [[point.impact_free for point in sweep.points] for sweep in sweeps]
        columns, values, last = (
            [set(column) for column in zip(*rows, strict=True)],
            axis.values,
            len(axis) - 1,
        )
        beside = [i for i in range(last) if len(columns[i] | columns[i + 1]) > 1]
        spans = ((float(values[max(0, i - 1)]), float(values[min(last, i + 2)])) for i in beside)
        return Changes(tuple(spans))

    def hold(self, value: float) -> bool:
        return any(low <= value <= high for low, high in self.spans)

    def order(self, point: Point) -> tuple[bool, int]:
        """The lower, the more depends on a periodic motion."""
        return not (point.impact_free or self.hold(point.value)), point.period
