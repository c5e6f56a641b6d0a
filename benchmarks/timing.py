"""Timing that survives a busy machine: everybody takes turns, and ratios are of neighbours in time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from statistics import median
from time import perf_counter


@dataclass(frozen=True)
class Runner:
    """Somebody who does a piece of work: one call of ``run`` does ``units`` of it (periods, pixels …)."""

    name: str
    run: Callable[[], object]
    units: int = 1


@dataclass(frozen=True)
class Times:
    """Seconds per unit, one for each repeat."""

    each: tuple[float, ...]

    @property
    def median(self) -> float:
        return median(self.each)

    @property
    def best(self) -> float:
        return min(self.each)

    def over(self, other: Times) -> float:
        """Median of the ratios to ``other`` within each repeat: a slow spell meets both and cancels."""
        return median(self._ratios(other))

    def least_over(self, other: Times) -> float:
        """The least of those ratios: how far the median can be trusted."""
        return min(self._ratios(other))

    def _ratios(self, other: Times) -> list[float]:
        return [mine / theirs for mine, theirs in zip(self.each, other.each, strict=True)]


def in_turns(runners: Sequence[Runner], repeats: int, warm: bool = True) -> dict[str, Times]:
    """A B A B …: each runner once to warm up (if asked for), then once in each of the repeats."""
    for runner in runners if warm else ():
        runner.run()
    spent: dict[str, list[float]] = {runner.name: [] for runner in runners}
    for _ in range(repeats):
        for runner in runners:
            spent[runner.name].append(seconds(runner.run) / runner.units)
    return {name: Times(tuple(each)) for name, each in spent.items()}


def seconds(run: Callable[[], object]) -> float:
    """Wall time of one call."""
    began = perf_counter()
    run()
    return perf_counter() - began
