"""What callers of studies hand over, checked once where it enters, and refused in words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.jobs import Cancel, ProgressCallback
from gearlash.orbits import Settings
from gearlash.results import Axis
from gearlash.system import Family, GearlashError, given, shown

from .model import Model
from .named import plain_values


def checked_settings(settings: Settings | None) -> Settings:
    """These, or the usual ones."""
    expected = "Settings, such as gearlash.Settings(max_period=128)"
    return Settings() if settings is None else given.instance("settings", settings, Settings, expected)


def checked_start(family: Family, initial: ArrayLike | None) -> NDArray[np.float64] | None:
    """A start for every point, or None: the cold one."""
    if initial is None:
        return None
    try:
        return given.numbers("initial state", initial, (len(family.states),))
    except GearlashError as error:
        raise GearlashError(f"{error} (states: {', '.join(family.states)})") from None


def checked_fixed(
    model: Model, family: Family, fixed: Mapping[str, float | str] | None, axes: Sequence[Axis]
) -> dict[str, float]:
    """Parameters that are set beside the axes. Raises `GearlashError` for names and values that do
    not fit."""
    found = plain_values(model, family, "fixed", fixed)
    for axis in axes:
        if axis.name in found:
            raise GearlashError(f"{axis.name} is an axis of the study and cannot be fixed as well")
    complete = family.complete(found)
    return {name: complete[name] for name in found}


def checked_ways(executor: Executor | None, progress: ProgressCallback | None, cancel: Cancel | None) -> None:
    """How a study is to be done. Raises `GearlashError` for what cannot do it."""
    if executor is not None:
        expected = "an executor, as from gearlash.open_workers(case, 2)"
        given.instance("executor", executor, Executor, expected)
    if progress is not None:
        given.function("progress", progress, "a function of a Progress")
    if cancel is not None and not callable(getattr(cancel, "is_set", None)):
        raise GearlashError(f"cancel = {shown(cancel)}: expected what has is_set(), as a threading.Event")
