"""What studies are made of: a case, or a family of one's own, in a form that travels to other processes."""

from __future__ import annotations

import sys
from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeAlias

from gearlash._kernel import compile_all, load_all
from gearlash.case import Case
from gearlash.case.kinds import Kind, register, registered
from gearlash.jobs import Pool, cannot_pickle, cannot_travel, open_executor
from gearlash.jobs.executors import MOST_WORKERS, available_cores
from gearlash.system import Family, GearlashError, given

Model: TypeAlias = Case | Family


@dataclass(frozen=True)
class Source:
    """A case as JSON text, with its kind where a user registered that; or a family itself."""

    case_json: str | None
    own: Family | None
    kind: Kind | None = None

    @staticmethod
    def of(model: Model) -> Source:
        given.instance("model", model, (Case, Family), "a case, as from gearlash.load_case, or a Family")
        if isinstance(model, Family):
            return Source(None, model)
        return Source(model.to_json(), None, registered(model.kind))

    def family(self) -> Family:
        """The family; built once in every process for each case."""
        if self.own is not None:
            return self.own
        assert self.case_json is not None
        if self.kind is None:
            return _family(self.case_json, None)
        if registered(self.kind.name) is None:
            register(self.kind)
        return _family(self.case_json, registered(self.kind.name))


@lru_cache(maxsize=8)
def _family(case_json: str, _kind: Kind | None) -> Family:
    return Case.from_json(case_json).family()[0]


def prepare(source: Source) -> None:
    """What a worker process does before its first task: imports the kernels and builds the family."""
    source.family()


def open_workers(model: Model, workers: int | None = None) -> Executor:
    """Worker processes for studies of one model, which they know before their first task.

    Kernels that must be compiled are compiled before, by this process, which says so. Workers end with the
    ``with`` block, or with the process that started them, however that ends.

    Parameters
    ----------
    model : Case or Family
        Workers build a case themselves. The functions of a `Family` they import, so these must be functions
        of a module, or of a script that keeps its work under ``if __name__ == "__main__":``.
    workers : int, optional
        Number of processes; one for each core that is free to use, without. With 0 or 1 there are none, and
        this process does the work.

    Returns
    -------
    concurrent.futures.Executor
        For `Execution`.

    Raises
    ------
    GearlashError
        For a family or a kind of case of one's own that workers cannot get.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> with gl.open_workers(case, 1) as workers:
    ...     found = gl.sweep(case, gl.Axis.even("omega", 0.7, 0.8, 2), execution=gl.Execution(workers))
    >>> found.complete
    True
    """
    source = Source.of(model)
    workers = None if workers is None else given.whole("workers", workers, 0, MOST_WORKERS)
    if (available_cores() if workers is None else workers) > 1:
        _check_sent(source, cannot_travel)
        compile_all(load_all())
    return open_executor(workers, prepare, (source,))


def check_travels(source: Source, executor: Executor | None) -> None:
    """Raises `GearlashError` where a family or a kind of one's own cannot be sent to worker processes: of
    this package, or of the standard library, which finds what is defined in ``__main__`` in its own way."""
    standard = sys.modules.get("concurrent.futures.process")  # loaded by whoever has such an executor
    if isinstance(executor, Pool):
        _check_sent(source, cannot_travel)
    elif standard and isinstance(executor, standard.ProcessPoolExecutor):
        _check_sent(source, cannot_pickle)


def _check_sent(source: Source, why_not: Callable[[object], str]) -> None:
    for thing, what, parts in (
        (source.own, "family", "its `build` and `cold_start` as functions of a module"),
        (source.kind, "kind of case", "its class in a module"),
    ):
        reason = "" if thing is None else why_not(thing)
        if reason:
            raise GearlashError(
                f"this {what} cannot be sent to worker processes ({reason}); "
                f"define {parts}, or use workers=1, which needs none"
            )
