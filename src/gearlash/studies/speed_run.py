"""Everything that is measured over speed, with the motion at the present speed and the hardest one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearlash.case import Case
from gearlash.jobs import Execution, stopping
from gearlash.orbits import Settings
from gearlash.orbits.signals import Signals
from gearlash.results import Axis, Point, Sweep
from gearlash.system.readout import Readout

from .assessment import Assessment, Tell, telling
from .history import History, history
from .joined import apart_in
from .measured import measured, readouts_of, traceable
from .point import summary
from .sweep import sweeps

FINE = 201
"""Speeds at which quantities are measured where nothing else is asked for."""
Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class SpeedRun:
    """What is measured over speed.

    Parameters
    ----------
    case : Case
    axis : Axis
        Speeds ω.
    sweeps : tuple of Sweep
        Up and down.
    signals : tuple of tuple of (Signals or None)
        Of every point of every sweep.
    readouts : tuple of Readout
        What was read beside force and gap: of `Signals.read`, in this order.
    complete : bool
    apart : tuple of ndarray of bool, shape (m-1,)
        Of each sweep the steps over which its motion changes to another one.
    """

    case: Case
    axis: Axis
    sweeps: tuple[Sweep, ...]
    signals: tuple[tuple[Signals | None, ...], ...]
    readouts: tuple[Readout, ...]
    complete: bool
    apart: tuple[NDArray[np.bool_], ...]

    def measured(self) -> list[tuple[Point, Signals]]:
        """Every point at which there is something, with what was measured."""
        return [
            (point, one)
            for sweep, row in zip(self.sweeps, self.signals, strict=True)
            for point, one in zip(sweep.points, row, strict=True)
            if one is not None
        ]

    def column(self, way: int, name: str) -> Array:
        """One figure along a sweep, NaN where there is none; a name of `COLUMNS` or of a readout and a
        figure, such as ``bearing_force_yp.peak``."""
        return np.array([np.nan if one is None else self.figure(one, name) for one in self.signals[way]])

    def figure(self, one: Signals, name: str) -> float:
        """The same of one point."""
        what, _, which = name.rpartition(".")
        if not what:
            return float(getattr(one, which))
        if what in ("force", "gap"):
            return float(getattr(getattr(one, what), which))
        index = next(i for i, readout in enumerate(self.readouts) if readout.name == what)
        return float(getattr(one.read[index], which))


def speed_run(
    case: Case,
    axis: Axis,
    *,
    settings: Settings | None = None,
    execution: Execution | None = None,
    tell: Tell | None = None,
) -> SpeedRun:
    """Sweeps up and down over speed, with everything that is measured at every point.

    Parameters
    ----------
    case : Case
        A gear pair.
    axis : Axis
        Speeds ω; those of bearing modes between them are added.
    settings : Settings, optional
        How attractors are looked for.
    execution : Execution, optional
        Who does the work.
    tell : callable, optional
        Hears the stage, and how far it is.

    Returns
    -------
    SpeedRun
    """
    execution, say = execution or Execution(), tell or (lambda _stage, _progress: None)

    axis = with_modes(case, axis)
    ways = sweeps(
        case, axis, ("up", "down"), settings=settings, execution=telling(execution, say, "finer speeds")
    )
    table, whole = measured(case, ways, telling(execution, say, "forces over speed"))
    whole = whole and all(way.complete for way in ways)
    readouts = readouts_of(case, case.family()[0].complete())
    joined = apart_in(case, ways, telling(execution, say, "lines over speed").progress)
    return SpeedRun(case, axis, ways, table, readouts, whole and not stopping(), joined)


def bearing_modes(case: Case) -> list[float]:
    """Speeds ω at which the mesh meets the frequency of a body on one of its bearings alone."""
    pair = case.numbers.pair
    return [] if pair is None else [float(one) for one in pair.bearing_frequencies]


def with_modes(case: Case, axis: Axis) -> Axis:
    """The same speeds, and those of the bearing modes between them."""
    low, high = float(axis.values[0]), float(axis.values[-1])
    more = [omega for omega in bearing_modes(case) if low < omega < high]
    return Axis(axis.name, np.unique(np.concatenate([axis.values, more])))


def histories(found: Assessment, run: SpeedRun | None) -> tuple[History, ...]:
    """The motion at the present speed, and the one with the highest mesh force of all over speed, where that
    is another one."""
    here, fixed = replace(summary(found.attractor), value=found.here), _others(found.values)
    shown = [history(found.case, fixed, here)] if traceable(here) else []
    worst = max(run.measured(), key=lambda pair: pair[1].force.most, default=None) if run else None
    if worst is not None and (not shown or worst[1].force.most > shown[0].signals.force.most):
        shown.append(history(found.case, fixed, worst[0]))
    return tuple(shown)


def _others(values: Mapping[str, float]) -> dict[str, float]:
    return {name: value for name, value in values.items() if name != "omega"}
