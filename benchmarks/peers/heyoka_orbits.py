"""Orbits with heyoka: multipliers, and the speed at which an orbit grazes. With its variational equations,
Newton's method and a secant, as one would write it with that integrator at hand."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import heyoka as hy
import numpy as np
from numpy.typing import NDArray

from .heyoka import FINEST, TOLERANCE, Model, _single
from .plain import Array, Pair

NEWTON, SECANT = 8, 20
MULTIPLIERS = "monodromy from its variational equations, eigenvalues by numpy"
GRAZING = "variational equations, Newton for the orbit, extrema as events, secant in ω to 1e-13"


class Monodromy:
    """The derivative of the period map; the field is continuous under the rule 'always', so it runs through
    crossings unchanged. ``real`` as for `Heyoka`."""

    def __init__(self, pair: Pair, real: type = float):
        self.pair, self.real, self.model = pair, real, Model(pair)
        box: list[Any] = []
        events = [
            hy.t_event(self.model.above, callback=_single(box, 1, pair.edge, None), fp_type=real),
            hy.t_event(self.model.below, callback=_single(box, -1, pair.edge, None), fp_type=real),
        ]
        self.integrator = _variational(self.model, real, pars=2, t_events=events)
        box.append(self.integrator.pars)

    def multipliers(self, z: Array, period: int) -> NDArray[np.complex128]:
        """All multipliers (n,) of the orbit through ``z``."""
        ta = self.integrator
        _start(ta, z, self.model.parameters(self.pair, z))
        ta.propagate_until(self.real(self.pair.system.period) * period)
        n = len(z)
        values = np.linalg.eigvals(np.asarray(ta.state[n:].reshape(n, n), dtype=float))
        return values.astype(np.complex128)


class Grazing:
    """An orbit that stays in contact, followed in a parameter until its least X is D."""

    def __init__(self, pair: Pair, real: type = float):
        self.real, self.model, self.extrema = real, Model(pair, free=True), []
        found, place = self.extrema, self.model.size - 2

        def turned(ta, time, sign):
            ta.update_d_output(time)
            found.append(ta.d_output[place])

        events = [hy.nt_event(self.model.velocity, callback=turned, fp_type=real)]
        self.integrator = _variational(
            self.model,
            real,
            pars=len(self.model.parameters(pair, np.ones(self.model.size))),
            nt_events=events,
        )

    def locate(self, pair_at: Callable[[float], Pair], guess: float, z: Array) -> float:
        """The parameter, by a secant from a guess at which ``z`` (n,) is near the orbit."""
        state = np.array(z, dtype=self.real)
        values, gaps = [guess, guess * (1.0 - 1e-3)], []
        for value in values:
            state, gap = self._margin(pair_at(value), state)
            gaps.append(gap)
        for _ in range(SECANT):
            step = gaps[-1] * (values[-1] - values[-2]) / (gaps[-1] - gaps[-2])
            values.append(float(values[-1] - step))
            if abs(step) < 1e-13:
                break
            state, gap = self._margin(pair_at(values[-1]), state)
            gaps.append(gap)
        return values[-1]

    def _margin(self, pair: Pair, z: Array) -> tuple[Array, float]:
        """The orbit's state and min X - D of it."""
        ta, n = self.integrator, len(z)
        inside = self.model.parameters(pair, np.full(n, 2.0 * pair.edge + 1.0))  # held in contact
        for _ in range(NEWTON):
            _start(ta, z, inside)
            self.extrema.clear()
            ta.propagate_until(self.real(1.0))
            defect = np.asarray(ta.state[:n] - z, dtype=float)
            if np.abs(defect).max() < 1e-14:
                break
            jacobian = np.asarray(ta.state[n:].reshape(n, n), dtype=float)
            z = z - np.linalg.solve(jacobian - np.eye(n), defect)
        return z, min(self.extrema) - pair.edge


def _variational(model: Model, real: type, pars: int, **events: Any) -> Any:
    equations = hy.var_ode_sys(model.equations, hy.var_args.vars, order=1)
    return hy.taylor_adaptive(
        equations,
        np.zeros(model.size * (1 + model.size), dtype=real),
        fp_type=real,
        tol=real(TOLERANCE if real is float else FINEST),
        pars=np.zeros(pars, dtype=real),
        compact_mode=real is not float,  # the reference is not timed
        fast_math=real is float,
        **events,
    )


def _start(ta: Any, z: Array, parameters: list[float]) -> None:
    n = len(z)
    ta.time = ta.time * 0
    ta.state[:n] = z
    ta.state[n:] = np.eye(n).ravel()
    ta.pars[:] = parameters
    ta.reset_cooldowns()
