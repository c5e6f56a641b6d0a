"""A bar for what is nearly always too short to need one: it comes after a second."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from time import monotonic

PATIENCE = 1.0  # seconds


@contextmanager
def late_bar(title: str) -> Iterator[Callable[[int, int], None]]:
    """A callback for what is done, out of how much."""
    began, shown = monotonic(), []
    with ExitStack() as stack:

        def tell(done: int, total: int) -> None:
            if monotonic() - began < PATIENCE:
                return
            from gearlash.jobs import Progress  # late too: loading it takes as long as many a search

            from .progress import stage_bar

            if not shown:
                shown.append(stack.enter_context(stage_bar()))
            shown[0](title, Progress(done, total, monotonic() - began, None))

        yield tell
