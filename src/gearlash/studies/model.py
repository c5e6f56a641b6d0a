"""What studies are made of: a case, or a family of one's own, in a form that travels to other processes."""

from __future__ import annotations

import pickle
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import lru_cache
from typing import TypeAlias

from gearlash.case import Case
from gearlash.jobs import Pool
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


def check_travels(source: Source, executor: Executor | None) -> None:
    """Raises `GearlashError` where a family of one's own cannot be sent to worker processes."""
    if source.own is None or not isinstance(executor, Pool):
        return
    try:
        pickle.dumps(source.own)
    except (pickle.PicklingError, AttributeError, TypeError) as error:
        raise GearlashError(
            f"this family cannot be sent to worker processes ({error}): "
            "define its `build` and `initial` as functions of a module, or use workers=0"
        ) from None
