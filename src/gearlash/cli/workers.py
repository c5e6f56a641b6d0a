"""How many processes a study gets."""

from __future__ import annotations

from concurrent.futures import Executor

from gearlash.case import Case
from gearlash.jobs import Inline
from gearlash.jobs.executors import available_cores
from gearlash.studies import open_workers

WORTH = 150  # points from which starting processes costs less than it saves


def executor_for(case: Case, workers: int | None, points: int) -> Executor:
    """An executor: what was asked for, else one process a core where there is enough to do."""
    if workers is None:
        workers = available_cores() if points >= WORTH else 1
    return open_workers(case, workers) if workers > 1 else Inline()
