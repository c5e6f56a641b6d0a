"""What studies are made of: a case, or a family of one's own, in a form that travels to other processes."""

from __future__ import annotations

import sys
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeAlias

from gearlash._kernel import compile_all, load_all
from gearlash.case import Case
from gearlash.jobs import Pool, cannot_pickle, cannot_travel, open_executor
from gearlash.jobs.executors import MOST_WORKERS, available_cores
from gearlash.system import Family, GearlashError, given

Model: TypeAlias = Case | Family


@dataclass(frozen=True)
class Source:
    """A case as JSON text, or a family itself."""

    case_json: str | None
    own: Family | None

    @staticmethod
    def of(model: Model) -> Source:
        given.instance("model", model, (Case, Family), "a case, as from gearlash.load_case, or a Family")
        return Source(None, model) if isinstance(model, Family) else Source(model.to_json(), None)

    def family(self) -> Family:
        """The family; built once in every process for each case."""
        if self.own is not None:
            return self.own
        assert self.case_json is not None
        return _family(self.case_json)


@lru_cache(maxsize=8)
def _family(case_json: str) -> Family:
    return Case.from_json(case_json).family()[0]


def prepare(source: Source) -> None:
    """What a worker process does before its first task: imports the kernels and builds the family."""
    source.family()


def open_workers(model: Model, workers: int | None = None) -> Executor:
    """An executor whose processes know the model before their first task; see `jobs.open_executor`. Kernels
    that must be compiled are so before, by this process, which says it. Raises `GearlashError` for a family
    of one's own that they cannot get."""
    source = Source.of(model)
    workers = None if workers is None else given.whole("workers", workers, 0, MOST_WORKERS)
    if (available_cores() if workers is None else workers) > 1:
        if source.own is not None:
            _check_sent(cannot_travel(source.own))
        compile_all(load_all())
    return open_executor(workers, prepare, (source,))


def check_travels(source: Source, executor: Executor | None) -> None:
    """Raises `GearlashError` where a family of one's own cannot be sent to worker processes: of this package,
    or of the standard library, which has ways of its own to find what is defined in ``__main__``."""
    standard = sys.modules.get("concurrent.futures.process")  # loaded by whoever has such an executor
    if source.own is not None and isinstance(executor, Pool):
        _check_sent(cannot_travel(source.own))
    elif source.own is not None and standard and isinstance(executor, standard.ProcessPoolExecutor):
        _check_sent(cannot_pickle(source.own))


def _check_sent(reason: str) -> None:
    if reason:
        raise GearlashError(
            f"this family cannot be sent to worker processes ({reason}); "
            "define its `build` and `initial` as functions of a module, or use workers=1, which needs none"
        )
