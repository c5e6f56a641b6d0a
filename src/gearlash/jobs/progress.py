"""How far a study is, and when it will be done."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import nan


@dataclass(frozen=True)
class Progress:
    """How far a study is.

    The estimate of what remains comes from measured times of what was done in this run. Where points differ
    much in cost it moves: it is made anew each time, never smoothed into agreement with an earlier one.

    Attributes
    ----------
    done : int
        Points that were computed.
    total : int
        Points in all; 0 where nobody knows, as along a branch.
    elapsed : float
        Seconds since the study began.
    remaining : float or None
        Seconds until it is done; None while nothing was measured.

    Examples
    --------
    >>> import gearlash as gl
    >>> print(gl.Progress(30, 120, 10.0, 30.0))
    30/120 after 10 s, about 30 s left
    """

    done: int
    total: int
    elapsed: float
    remaining: float | None

    @property
    def share(self) -> float:
        """Part of the points that is done, 0 to 1; NaN where nobody knows how many there will be."""
        if not self.total:
            return nan if self.done else 1.0
        return self.done / self.total

    def __str__(self) -> str:
        rest = "" if self.remaining is None else f", about {seconds_as_text(self.remaining)} left"
        done = f"{self.done}/{self.total}" if self.total else f"{self.done}"
        return f"{done} after {seconds_as_text(self.elapsed)}{rest}"


ProgressCallback = Callable[[Progress], object]


@dataclass
class Load:
    """Points of one chain: all, done, and the seconds that a worker spent on those done."""

    total: int
    done: int = 0
    seconds: float = 0.0

    @property
    def left(self) -> int:
        return self.total - self.done


def remaining(loads: list[Load], workers: int) -> float | None:
    """Seconds until the workers have done all chains: the work left shared evenly, but no less than the
    longest chain, whose tasks wait for each other. A chain not yet begun is taken to cost what the others did
    a point.
    """
    done, seconds = sum(load.done for load in loads), sum(load.seconds for load in loads)
    if not done:
        return None
    left = [load.left * (load.seconds / load.done if load.done else seconds / done) for load in loads]
    return max(sum(left) / workers, max(left))


def seconds_as_text(seconds: float) -> str:
    """`0.4 s`, `48 s`, `3 min 20 s`, `2 h 05 min`."""
    if seconds < 10.0:
        return f"{seconds:.1f} s"
    whole = round(seconds)
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60:02d} s"
    return f"{whole // 3600} h {whole % 3600 // 60:02d} min"
