"""What callers of studies hand over, checked once where it enters, and refused in words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.jobs import Execution
from gearlash.orbits import Settings
from gearlash.results import Axis
from gearlash.system import Family, GearlashError, given, plain_values

from .model import Model, Source, check_travels


def checked_settings(settings: Settings | None) -> Settings:
    """The settings that were given, or the usual ones."""
    expected = "Settings, such as gearlash.Settings(max_period=128)"
    return Settings() if settings is None else given.instance("settings", settings, Settings, expected)


def checked_start(family: Family, start: ArrayLike | None) -> NDArray[np.float64] | None:
    """The state (n,) that was given as a start, or None for the cold start."""
    if start is None:
        return None
    try:
        return given.numbers("start", start, (len(family.states),))
    except GearlashError as error:
        raise GearlashError(f"{error} (states: {', '.join(family.states)})") from None


def checked_values(
    model: Model, family: Family, values: Mapping[str, float | str] | None, axes: Sequence[Axis]
) -> dict[str, float]:
    """Parameters that are set beside the axes, by short name. Raises `GearlashError` for names and values
    that do not fit."""
    found = plain_values(model, family, values)
    for axis in axes:
        if axis.name in found:
            raise GearlashError(f"{axis.name} is an axis of the study and cannot be fixed as well")
    complete = family.complete(found)
    return {name: complete[name] for name in found}


def checked_execution(source: Source, execution: Execution | None) -> Execution:
    """The execution that was given, or the usual one. Raises `GearlashError` where its workers cannot get the
    model."""
    expected = "an Execution, such as gearlash.Execution(executor=workers)"
    found = Execution() if execution is None else given.instance("execution", execution, Execution, expected)
    check_travels(source, found.executor)
    return found
