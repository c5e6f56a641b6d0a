"""A bar for what is nearly always too short to need one: it comes after a second."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from time import monotonic

from .terminal import errors
from .terminal import tell as announce

PATIENCE, LONG = 1.0, 5.0  # seconds


@contextmanager
def late_bar(title: str, steady: bool = True) -> Iterator[Callable[[int, int], None]]:
    """A callback for what is done, out of how much. Where no bar can be shown, one line says how long it
    takes, if that is long; of what is not ``steady``, as steps that grow on the way, nothing is foretold."""
    began, shown = monotonic(), []
    with ExitStack() as stack:

        def tell(done: int, total: int) -> None:
            if monotonic() - began < PATIENCE:
                return
            from gearlash.jobs import (
                Progress,
                seconds_as_text,
            )  # late too: loading it takes as long as many a search

            from .progress import stage_bar

            if not shown:
                shown.append(stack.enter_context(stage_bar()))
                seconds = (monotonic() - began) * total / max(done, 1)
                if steady and not errors().is_terminal and seconds > LONG:
                    announce(f"{title}: about {seconds_as_text(seconds)}")
            shown[0](title, Progress(done, total, monotonic() - began, None))

        yield tell
