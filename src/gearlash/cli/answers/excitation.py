"""Where nothing excites a system, nothing was asked: how that is told."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING

from gearlash.case import Case
from gearlash.system import GearlashError

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.orbits import Attractor
    from gearlash.results import Axis

NOT_EXCITED = "not-excited"
"""Status of an answer about a system in which nothing varies with time, or nothing that varies moves it."""
LOOKED_AT = 400  # members of a family
PHASES = 33  # at which a motion at rest is looked at
STILL = 1e-12  # of the size of the state: what moves less is at rest


@dataclass(frozen=True)
class Unexcited:
    """Why a motion answers no question: ``cause`` in words, and what to do."""

    cause: str
    advice: str

    @property
    def reason(self) -> str:
        return f"nothing was asked: {self.cause}"


def unexcited(case: Case, attractor: Attractor) -> Unexcited | None:
    """Why the motion that was found answers nothing, if so."""
    from gearlash.orbits import Orbit

    if not attractor.propagators.system.excited:
        return nothing_varies(case)
    if isinstance(attractor, Orbit) and at_rest(attractor):
        cause = "what varies with time does not move it"
        return Unexcited(cause, case.excitation.moving)
    return None


def nothing_varies(case: Case) -> Unexcited:
    """The words for a system without any excitation."""
    return Unexcited(case.excitation.cause, case.excitation.give)


def at_rest(attractor: Attractor) -> bool:
    """Does the state stay the same all the time?"""
    import numpy as np

    trace = attractor.trace
    states = trace.at(trace.phase + np.linspace(0.0, trace.cycles, PHASES)).state
    size = max(1.0, float(np.abs(states).max()))
    return bool(np.isfinite(states).all()) and float(np.ptp(states, axis=0).max()) <= STILL * size


def idle_study(case: Case, parameters: Mapping[str, float], axes: Sequence[Axis]) -> Unexcited | None:
    """Why a study over these axes answers nothing: nothing varies with time at any of its values, of which
    `LOOKED_AT` are looked at, evenly spread, if there are more. Values at which no system can be built count
    for nothing."""
    each = max(2, int(LOOKED_AT ** (1.0 / len(axes))))
    spread = [sorted({round(i * (len(a) - 1) / (each - 1)) for i in range(each)}) for a in axes]
    family, built = case.family()[0], 0
    for places in product(*spread):
        values = {a.name: float(a.values[i]) for a, i in zip(axes, places, strict=True)}
        try:
            system = family.system({**parameters, **values})
        except GearlashError:
            continue
        if system.excited:
            return None
        built += 1
    words = nothing_varies(case)
    return Unexcited(f"{words.cause} (at {built} values looked at)", words.advice) if built else None
