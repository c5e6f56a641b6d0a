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
    """An executor whose processes know the model before their first task; see `jobs.open_executor`. Kernels
    that must be compiled are so before, by this process, which says it. Raises `GearlashError` for a family
    or a kind of case of one's own that they cannot get."""
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
