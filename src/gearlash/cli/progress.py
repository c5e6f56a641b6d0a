"""Progress on standard error: a bar with points done and the time left as measured. Where that is no terminal
a line now and then, ever more seldom, of what takes long."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from time import monotonic

from gearlash.jobs import Progress, ProgressCallback, seconds_as_text

from .terminal import errors
from .terminal import tell as announce

FIRST_LINE = 30.0  # seconds until the first line where no bar can be shown; each comes after twice as long

StageCallback = Callable[[str, Progress | None], object]


@contextmanager
def progress_bar(title: str) -> Iterator[ProgressCallback]:
    """A callback for studies; the bar goes when the block ends."""
    with stage_bar() as tell:
        yield lambda progress: tell(title, progress)


@contextmanager
def stage_bar() -> Iterator[StageCallback]:
    """A callback for studies of several stages: the stage, and how far it is (None: at its beginning)."""
    console = errors()
    if not console.is_terminal:
        yield Lines().tell
        return
    from rich.progress import BarColumn, TextColumn
    from rich.progress import Progress as Bar

    columns = (TextColumn("{task.description}"), BarColumn(24), TextColumn("{task.fields[words]}"))
    with Bar(*columns, console=console, transient=True) as bar:
        task = bar.add_task("", total=None, words="")

        def tell(stage: str, progress: Progress | None) -> None:
            if progress is None:
                bar.update(task, description=stage, total=None, words="")
            else:
                done, total = progress.done, progress.total or None
                bar.update(task, description=stage, completed=done, total=total, words=in_words(progress))

        yield tell


@dataclass(eq=False)
class Lines:
    """What is told where no bar can be shown."""

    began: float = field(default_factory=monotonic)
    next: float = FIRST_LINE

    def tell(self, stage: str, progress: Progress | None) -> None:
        """A line, when it is time for one."""
        elapsed = monotonic() - self.began
        if elapsed >= self.next:
            self.next = 2.0 * elapsed
            words = "" if progress is None else f" {in_words(progress)}"
            announce(f"{stage}:{words} (after {seconds_as_text(elapsed)})")


def in_words(progress: Progress) -> str:
    """Points done and the time left, from what was measured so far."""
    if not progress.total:
        return f"{progress.done} found"  # nobody knows how many there will be
    if progress.remaining is None:
        return f"{progress.done}/{progress.total}"
    return f"{progress.done}/{progress.total}, about {seconds_as_text(progress.remaining)} left"
