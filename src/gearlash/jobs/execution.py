"""How a study is carried out: by which processes, in which parts, who is told, who may stop it."""

from __future__ import annotations

from concurrent.futures import Executor
from dataclasses import dataclass, field

from gearlash.system import GearlashError, Record, given, shown

from .progress import ProgressCallback
from .stop import Cancel


@dataclass(frozen=True, repr=False)
class Execution(Record):
    """How a study is carried out. What it computes does not depend on it.

    Parameters
    ----------
    executor : concurrent.futures.Executor, optional
        Who does the work, such as ``gearlash.open_workers(case, 2)``. Without it this process does.
    chunk : int, optional
        Points (of a map: pixels) of one task, 1 or more. Without it the study chooses.
    progress : callable, optional
        Is called with a `Progress` after every task, or ten times a second where there are many.
    cancel : Cancel, optional
        Anything with ``is_set()``, such as a ``threading.Event``: once it is set, the study returns what it
        has by then, marked as incomplete.

    Raises
    ------
    GearlashError
        For an argument that is none of these.

    Examples
    --------
    >>> import gearlash as gl
    >>> counts = []
    >>> told = gl.Execution(progress=lambda progress: counts.append(progress.done))
    >>> case = gl.load_case("kahraman-singh")
    >>> found = gl.sweep(case, gl.Axis.even("omega", 0.9, 1.0, 3), execution=told)
    >>> counts
    [1, 2, 3]
    """

    executor: Executor | None = None
    chunk: int | None = field(default=None, kw_only=True)
    progress: ProgressCallback | None = field(default=None, kw_only=True)
    cancel: Cancel | None = field(default=None, kw_only=True)

    def __post_init__(self) -> None:
        if self.executor is not None:
            expected = "an executor, as from gearlash.open_workers(case, 2)"
            given.instance("executor", self.executor, Executor, expected)
        if self.chunk is not None:
            object.__setattr__(self, "chunk", given.whole("chunk", self.chunk))
        if self.progress is not None:
            given.function("progress", self.progress, "a function of a Progress")
        if self.cancel is not None and not callable(getattr(self.cancel, "is_set", None)):
            told = shown(self.cancel)
            raise GearlashError(f"cancel = {told}: expected what has is_set(), as a threading.Event")
