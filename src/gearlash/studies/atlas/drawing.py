"""Curves from seeds, several at once, each once, until the budget is spent."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np

from gearlash.branches.continuation import ContinuationSettings
from gearlash.branches.curves import Curve
from gearlash.jobs import Chain, Execution, Part, run
from gearlash.studies.curve import continue_curve
from gearlash.studies.model import Source
from gearlash.system import GearlashError

from .drawn import Drawn
from .seeds import DRAWN, Seed

Pair = tuple[float, float]


@dataclass(frozen=True, eq=False)
class Draw:
    """A task: the curve of a seed."""

    source: Source
    names: tuple[str, str]
    lower: Pair
    upper: Pair
    seed: Seed
    steps: ContinuationSettings


def draw_curve(task: Draw, carry: object) -> Part:
    """The curve, or in words why there is none."""
    seed = task.seed
    try:
        found = continue_curve(
            task.source.family(),
            task.names,
            seed.start,
            lower=task.lower,
            upper=task.upper,
            values=seed.values,
            kind=seed.kind,
            touch=seed.number,
            doubled=seed.doubled,
            steps=task.steps,
        )
    except (GearlashError, np.linalg.LinAlgError) as error:
        return Part((str(error),))
    return Part((found,))


@dataclass(eq=False)
class Drawing:
    """``tried``: curves that were followed or could not be begun, ``most`` of them at the most; ``left``:
    seeds whose curves were not drawn, and why; ``reason``: why it was stopped."""

    source: Source
    lower: Pair
    upper: Pair
    steps: ContinuationSettings
    execution: Execution
    drawn: Drawn
    most: int
    longest: int
    tried: int = 0
    left: list[tuple[Seed, str]] = field(default_factory=list)
    reason: str = ""

    def draw(self, seeds: Iterable[Seed]) -> None:
        """The curves of all seeds that lie on none yet. Of those that are followed at once, no two have one
        kind and one period: these might be one curve."""
        open_ = list(self._within(seeds))
        while open_:
            open_ = [seed for seed in open_ if self.drawn.knows(seed) < 0]
            chosen: dict[tuple[int, int, bool], Seed] = {}
            for seed in open_:
                chosen.setdefault((seed.period, DRAWN.index(seed.kind), seed.doubled), seed)
            batch = [chosen[key] for key in sorted(chosen)][: self.most - self.tried]
            if not batch or self.reason:
                plural = "" if self.most == 1 else "s"
                why = self.reason or f"the budget of {self.most} curve{plural} was spent"
                self.left += [(seed, why) for seed in open_]
                return
            self._follow(batch)
            done = {id(seed) for seed in batch}
            open_ = [seed for seed in open_ if id(seed) not in done]

    def _within(self, seeds: Iterable[Seed]) -> Iterable[Seed]:
        for seed in seeds:
            place = seed.place(self.drawn.names)
            if seed.period > self.longest:
                self.left.append((seed, f"its period of {seed.period} is longer than is followed"))
            elif all(a <= x <= b for a, x, b in zip(self.lower, place, self.upper, strict=True)):
                yield seed

    def _follow(self, batch: list[Seed]) -> None:
        names, limits = self.drawn.names, (self.lower, self.upper)
        chains = [
            Chain(i, (Draw(self.source, names, *limits, seed, self.steps),), (1,))
            for i, seed in enumerate(batch)
        ]
        outcome = run(draw_curve, chains, self.execution)
        self.reason = outcome.reason
        for i, seed in enumerate(batch):
            found = outcome.results.get(i)
            if not found:
                self.left.append((seed, self.reason))
                continue
            self.tried += 1
            if isinstance(found[0], Curve):
                self.drawn.add(found[0], seed.way)
            else:
                self.left.append((seed, found[0]))
