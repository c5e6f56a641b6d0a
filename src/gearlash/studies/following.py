"""Following an orbit under an execution: who hears of it, and whether to stop."""

from __future__ import annotations

from dataclasses import dataclass, field
from time import monotonic

from gearlash.branches.continuation import ContinuationSettings
from gearlash.jobs import Execution, Progress
from gearlash.jobs.stop import stopping
from gearlash.system import given


@dataclass
class Following:
    """Tells how many orbits there are, and hears whether to stop: from the execution, or by a signal."""

    execution: Execution
    orbits: int = 0
    began: float = field(default_factory=monotonic)

    def tell(self, _: object) -> None:
        self.orbits += 1
        if self.execution.progress is not None:
            self.execution.progress(Progress(self.orbits, 0, monotonic() - self.began, None))

    def stop(self) -> bool:
        cancel = self.execution.cancel
        return stopping() or (cancel is not None and cancel.is_set())


def checked_steps(steps: ContinuationSettings | None) -> ContinuationSettings:
    """Raises `GearlashError` for what are no settings."""
    expected = "ContinuationSettings, such as gearlash.ContinuationSettings(longest=0.02)"
    if steps is None:
        return ContinuationSettings()
    return given.instance("steps", steps, ContinuationSettings, expected)
