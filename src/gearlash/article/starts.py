"""Simple starts beside the default one: the article does not say which it used, and where motions coexist the
start decides which of them is seen."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.case import Case
from gearlash.studies.model import Source
from gearlash.system import Family, System

Array = NDArray[np.float64]
X = "X"  # the displacement along the line of action, among the states

STARTS: Mapping[str, Callable[[Mapping[str, float]], float]] = {
    "X = 1, all else zero": lambda values: 1.0,
    "X = D + f_m, all else zero": lambda values: values["D"] + values["load"],
    "all zero": lambda values: 0.0,
}
"""What X is at phase zero; every other state is zero."""


@dataclass(frozen=True)
class _Build:
    """The systems of a case; travels to worker processes, where the family is built once."""

    source: Source

    def __call__(self, values: Mapping[str, float]) -> System:
        return self.source.family().build(values)


@dataclass(frozen=True)
class _Start:
    """The state of one of `STARTS`."""

    name: str
    states: tuple[str, ...]

    def __call__(self, values: Mapping[str, float]) -> Array:
        state = np.zeros(len(self.states))
        state[self.states.index(X)] = STARTS[self.name](values)
        return state


def starting(case: Case, name: str) -> Family:
    """The family of a case with one of `STARTS` as its cold start."""
    family = case.family()[0]
    return Family(family.parameters, family.states, _Build(Source.of(case)), _Start(name, family.states))
