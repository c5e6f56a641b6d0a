"""The solvers of Exudyn that integrate a motion, and how their runs follow each other.

They share nothing but the force function and check each other: classical Runge–Kutta of order 4 with a fixed
step, the generalized-α method with a Newton iteration in every step, and the method of Dormand and Prince,
whose own step keeps to a tolerance also where a force jumps.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from gearlash.system import GearlashError

Array = NDArray[np.float64]
ABSOLUTE = 1e-4
"""Of `Solver.DOPRI5`: the error in m, rad and their rates that is let pass, over the tolerance. Bodies move
by micrometres."""
LEAST = 1e-12
"""The shortest step of `Solver.DOPRI5` over the longest: at a jump of a force it takes such short ones."""
PARTS = (2, 4, 8, 16, 32, 64, 128)
"""Of a step of `Solver.GENERALIZED_ALPHA` in which its Newton iteration does not converge."""


class Solver(StrEnum):
    """How the equations are integrated."""

    RK44 = "rk44"
    GENERALIZED_ALPHA = "generalized-alpha"
    DOPRI5 = "dopri5"


class SimulationError(GearlashError):
    """The integration of a multibody model failed; the text says where."""


class Keeper(Protocol):
    """What hears of every step and keeps states.

    Attributes
    ----------
    start, step : float
        Time at the first step, and from one to the next, s.
    every : int
        Steps from one state that is kept to the next.
    count : int
        Steps that were begun.
    interrupted : bool
        Whether the work was asked to stop.
    """

    start: float
    step: float
    every: int
    count: int
    interrupted: bool

    def before_step(self, mbs: Any, t: float) -> bool:
        """Keeps the state where it is one to be kept; whether to go on."""
        ...

    def go_on(self, mbs: Any, t: float) -> bool:
        """Before a step whose state is not kept: whether to go on."""
        ...

    def keep(self, count: int, mbs: Any) -> None:
        """Keeps the state before a step where it is one to be kept."""
        ...


@dataclass(frozen=True)
class Integration:
    """Runs of Exudyn's solvers that follow each other, from the state that the system has to begin with."""

    exu: Any
    mbs: Any
    kept: Keeper
    solver: Solver
    tolerance: float

    def to(self, steps: int) -> None:
        """All steps, and the last state kept."""
        if self.solver is Solver.DOPRI5:
            self._keeping(steps)
        else:
            self._counting(steps)
        self.kept.keep(steps, self.mbs)

    def _keeping(self, steps: int) -> None:
        """Steps of any length, and a run from each state that is kept to the next one."""
        for first in range(0, steps, self.kept.every):
            self.kept.keep(first, self.mbs)
            self._run(first, self.kept.every, self.kept.go_on)
            self._begin_at(self.exu.ConfigurationType.Current)

    def _counting(self, steps: int) -> None:
        """Steps of one length. The damping of the teeth jumps where a slice begins to carry; a step that ends
        at the jump may have no state that its Newton iteration could find, and is taken in parts instead."""
        while self.kept.count < steps:
            begun = self.kept.count
            try:
                self._run(self.kept.count, steps - self.kept.count, self.kept.before_step)
            except SimulationError:
                if (
                    self.solver is not Solver.GENERALIZED_ALPHA or self.kept.count == begun
                ):  # before its first step
                    raise
                self._in_parts(self.kept.count - 1)

    def _in_parts(self, step: int) -> None:
        """The step that failed again, in as few equal parts as it takes."""
        self._begin_at(self.exu.ConfigurationType.StartOfStep)
        for parts in PARTS:
            try:
                self._run(step, 1, self.kept.go_on, parts)
                break
            except SimulationError:
                if parts == PARTS[-1]:
                    raise
        self._begin_at(self.exu.ConfigurationType.Current)

    def begin(self, q: Array, v: Array) -> None:
        """The next run begins with this state, which is also the one that is there."""
        state, kinds = self.mbs.systemData, self.exu.ConfigurationType
        for configuration in (kinds.Initial, kinds.Current):
            state.SetODE2Coordinates(q, configuration=configuration)
            state.SetODE2Coordinates_t(v, configuration=configuration)

    def _begin_at(self, configuration: Any) -> None:
        """The next run begins with a state of the last one."""
        state = self.mbs.systemData
        self.begin(state.GetODE2Coordinates(configuration), state.GetODE2Coordinates_t(configuration))

    def _run(self, first: int, steps: int, before_step: Callable[[Any, float], bool], parts: int = 1) -> None:
        kinds = self.exu.DynamicSolverType
        kind = {
            Solver.RK44: kinds.RK44,
            Solver.GENERALIZED_ALPHA: kinds.GeneralizedAlpha,
            Solver.DOPRI5: kinds.DOPRI5,
        }[self.solver]
        self.mbs.SetPreStepUserFunction(before_step)
        try:
            self.mbs.SolveDynamic(self._settings(first, steps, parts), solverType=kind)
        except (self.exu.SolverError, self.exu.ModelError) as error:
            if not self.kept.interrupted:
                raise SimulationError(f"the multibody model could not be integrated: {error}") from error
        if self.kept.interrupted:
            raise KeyboardInterrupt

    def _settings(self, first: int, steps: int, parts: int) -> Any:
        settings, step = self.exu.SimulationSettings(), self.kept.step
        integration = settings.timeIntegration
        integration.numberOfSteps = steps * parts
        integration.startTime = self.kept.start + first * step
        integration.endTime = self.kept.start + (first + steps) * step
        integration.verboseMode = 0
        integration.automaticStepSize = self.solver is Solver.DOPRI5
        integration.relativeTolerance = self.tolerance
        integration.absoluteTolerance = ABSOLUTE * self.tolerance
        integration.minimumStepSize = LEAST * step
        integration.adaptiveStep = False
        integration.explicit.computeEndOfStepAccelerations = False
        integration.generalizedAlpha.spectralRadius = 0.95
        integration.newton.relativeTolerance = 1e-8
        integration.newton.absoluteTolerance = 1e-7
        settings.solution.file.write = False
        settings.parallel.numberOfThreads = 1  # bodies are two: several threads only slow it down
        return settings
