"""The stages of the study: what is told while one runs, and how long each took."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from gearlash.jobs import Progress

SWEEPS_OMEGA, SWEEPS_BACKLASH, ZONES, EVENTS, VERDICTS, RULES, BRANCHES = STAGES = (
    "sweeps over ω",
    "sweeps over D",
    "zones",
    "events",
    "verdicts",
    "contact rules",
    "branches",
)
StageProgress = Callable[[str, Progress | None], object]


class Stages:
    """Tells how far each stage is, and keeps its seconds.

    Parameters
    ----------
    tell : callable or None
        Called with the name of a stage and how far it is (`Progress`, or None at its beginning).
    """

    def __init__(self, tell: StageProgress | None) -> None:
        self._tell = tell or (lambda stage, state: None)
        self._ended = time.perf_counter()
        self.seconds: dict[str, float] = {}

    @contextmanager
    def stage(self, name: str) -> Iterator[Callable[[Progress], object]]:
        """One stage; gives what its work calls with its progress. It counts all since the stage before."""
        self._tell(name, None)
        yield lambda state: self._tell(name, state)
        now = time.perf_counter()
        self.seconds[name] = now - self._ended
        self._ended = now
