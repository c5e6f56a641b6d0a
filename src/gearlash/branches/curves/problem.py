"""The equations of special orbits, along one parameter or in a plane of two.

Unknowns, scaled: the state at the phase where the orbit is begun, the phase of every touch, the parameters.
Equations: the orbit closes; of every touch H = 0 (or -depth) and H' = 0, and H″ = 0 or H‴ = 0 where it is
degenerate; conditions on multipliers. With one touch or one condition that is a point along one parameter
and a curve in two, where with two of them it is a point again. Detecting and continuing differ only in which
unknown is free."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from gearlash.branches.continuation.extrema import Extremum
from gearlash.flow import Propagators, Trace
from gearlash.system import GearlashError

from .along import Beside, moved_end, moved_gap, moved_states
from .conditions import At, Condition, Double, Turning
from .plane import Array, Plane
from .touch import Leg, Window, carried, derivatives, legs, surface_rows, surface_values, traced

STEP = 1e-7  # of scaled unknowns: for derivatives that are no solutions of the variational equation
LEAST_STEP = 1e-10
OF_DEPTH = 1e-4  # of the distance of an extremum from its boundary, where the map is not smooth: the same


@dataclass(frozen=True)
class TouchCondition:
    """An extremum that lies ``depth`` below its boundary (above it: negative); ``zero``: orders of further
    derivatives of H that vanish there, of 2 and 3; ``held``: whether the boundary is not crossed
    there."""

    window: Window
    depth: float = 0.0
    zero: tuple[int, ...] = ()
    held: bool = True


@dataclass(frozen=True, eq=False)
class Problem:
    """For orbits of ``period`` base periods, begun at the phase ``origin``; ``size`` (n,): scale of the
    states; ``further``: more conditions, of points on a curve; ``kept``: extrema at given phases that are
    kept from crossing their boundaries; ``step``: of differences."""

    plane: Plane
    period: int
    size: Array
    origin: float = 0.0
    touches: tuple[TouchCondition, ...] = ()
    conditions: tuple[Condition, ...] = ()
    further: tuple[Double | Turning, ...] = ()
    kept: tuple[tuple[float, Window], ...] = ()
    step: float = STEP

    @property
    def all_conditions(self) -> tuple[Condition | Double | Turning, ...]:
        return (*self.conditions, *self.further)

    @property
    def is_plain(self) -> bool:
        """Whether the equations are those of closing, and of extrema of gaps that touch, alone: their
        derivatives are known without another system's maps."""
        plain = all(touch.window.surface == "gap" and not touch.zero for touch in self.touches)
        return plain and not self.all_conditions

    @property
    def states(self) -> int:
        return len(self.size)

    @cached_property
    def scale(self) -> Array:
        """Of all unknowns."""
        return np.concatenate([self.size, np.ones(len(self.touches)), self.plane.unit])

    def place(self, u: Array) -> Array:
        """(plane.names,): the parameters."""
        found: Array = (u * self.scale)[-len(self.plane.names) :]
        return found

    def state(self, u: Array) -> Array:
        """(n,) at the origin."""
        return u[: self.states] * self.size

    def phases(self, u: Array) -> Array:
        """Of the touches."""
        return u[self.states : self.states + len(self.touches)]

    def evaluate(self, u: Array, props: Propagators | None = None) -> Evaluated:
        """Raises what `UNBUILT` names."""
        props = self.plane.system_at(self.place(u)) if props is None else props
        return Evaluated(self, u, props)

    def near(self, here: Evaluated) -> Problem:
        """The same with borders that fit the orbit."""
        matrix = here.scaled_monodromy
        return replace(
            self,
            conditions=tuple(c.renewed(matrix) for c in self.conditions),
            further=tuple(f.renewed(matrix) for f in self.further),
        )

    def beside(self, nearest: float) -> Problem:
        """The same with differences that fit an orbit whose nearest extremum lies so far from its boundary,
        in units of the motion: multipliers move like the root of that."""
        step = min(STEP, max(LEAST_STEP, OF_DEPTH * nearest)) if self.conditions else STEP
        return replace(self, step=step)

    def with_condition(self, at: At, here: Evaluated) -> Problem:
        """With one condition more."""
        return replace(self, conditions=(*self.conditions, Condition.near(at, here.scaled_monodromy)))


@dataclass(frozen=True, eq=False)
class Evaluated:
    """An orbit, or what is to become one, at scaled unknowns ``u``."""

    problem: Problem
    u: Array
    props: Propagators

    @cached_property
    def windows(self) -> list[tuple[float, Window]]:
        phases = self.problem.phases(self.u).tolist()
        pairs = zip(phases, self.problem.touches, strict=True)
        touching = [(t, each.window if each.held else _shut(each.window)) for t, each in pairs]
        return [*touching, *self.problem.kept]

    @cached_property
    def cycles(self) -> float:
        """Length of the orbit, in mesh cycles."""
        return float(self.problem.period * self.props.system.cycles)

    @cached_property
    def legs(self) -> list[Leg]:
        return legs(self.problem.origin, self.cycles, self.windows)

    @cached_property
    def course(self) -> tuple[list[Array], list[Array]]:
        """States at the beginning of every leg and at the end; Jacobians to there."""
        return self.carried_from(self.problem.state(self.u))

    def carried_from(self, state: Array) -> tuple[list[Array], list[Array]]:
        """The same from another state (n,)."""
        states, flows = [state], [np.eye(len(state))]
        for leg in self.legs:
            after, jacobian = carried(self.props, states[-1], leg)
            states.append(after)
            flows.append(jacobian @ flows[-1])
        return states, flows

    @property
    def monodromy(self) -> Array:
        return self.course[1][-1]

    @cached_property
    def scaled_monodromy(self) -> Array:
        size = self.problem.size
        found: Array = self.monodromy * size / size[:, None]
        return found

    @cached_property
    def residual(self) -> Array:
        """What is left of the equations, scaled."""
        states, _ = self.course
        closing = (states[-1] - states[0]) / self.problem.size
        touching = [self.touch_values(k, states) for k in range(len(self.problem.touches))]
        matrix = self.scaled_monodromy
        return np.concatenate([closing, *touching, [c.value(matrix) for c in self.problem.all_conditions]])

    def touch_values(self, k: int, states: list[Array]) -> Array:
        """What is left of the equations of touch ``k``, with states at the beginning of every leg."""
        touch, phase = self.problem.touches[k], float(self.problem.phases(self.u)[k])
        index = self.leg_of(phase)
        leg, window = self.legs[index], touch.window
        if touch.zero or window.surface == "force":
            series = derivatives(traced(self.props, states[index], leg, phase), window)
            found = series[:2]
        else:
            own = states is self.course[0]
            at = (self.touch_flows[k] if own else carried(self.props, states[index], leg, phase))[0]
            series, found = np.empty(0), surface_values(self.props, window, at, phase, None)
        found = found + np.array([touch.depth, 0.0])
        rows = [found / self.surface_size(window)]
        if touch.zero:
            rows.append(series[list(touch.zero)] / self.surface_size(window)[0])
        return np.concatenate(rows)

    def surface_size(self, window: Window) -> Array:
        """(2,): of H and H'."""
        c = self.props.system.clearances[window.clearance]
        length = float(np.linalg.norm(c.h * self.problem.size))
        return np.array([length, length * self.props.system.omega])

    def leg_of(self, phase: float) -> int:
        """The leg on which a phase lies. Raises `GearlashError` where it lies on none."""
        for index, leg in enumerate(self.legs):
            if leg.begin < phase < leg.end:
                return index
        raise GearlashError("a touch has left the orbit")

    def moved(self, extremum: Extremum) -> float:
        """How far X of an extremum moves at most with a scaled unit of the state."""
        origin, size = self.problem.origin, self.problem.size
        phase = origin + (extremum.phase - origin) % self.cycles
        index = max(k for k, leg in enumerate(self.legs) if k == 0 or leg.begin <= phase)
        flow = carried(self.props, self.course[0][index], self.legs[index], phase)[1] @ self.course[1][index]
        h = self.props.system.clearances[extremum.clearance].h
        return float(np.linalg.norm(h @ flow * size))

    def at_touch(self, k: int) -> Array:
        """(H, H', H″, H‴) of touch ``k``."""
        return derivatives(self.touch_traces[k], self.problem.touches[k].window)

    @cached_property
    def touch_flows(self) -> list[tuple[Array, Array]]:
        """Of every touch the state there (n,), and the Jacobian (n, n) from the beginning of its leg."""
        return [carried(self.props, *where) for where in self._ways_to_touches()]

    @cached_property
    def touch_traces(self) -> list[Trace]:
        """From the beginning of its leg to every touch."""
        return [traced(self.props, *where) for where in self._ways_to_touches()]

    def _ways_to_touches(self) -> Iterator[tuple[Array, Leg, float]]:
        for phase in self.problem.phases(self.u).tolist():
            index = self.leg_of(phase)
            yield self.course[0][index], self.legs[index], phase

    def jacobian(self) -> Array:
        """Of the residual by all unknowns. Raises what `UNBUILT` names."""
        n, k = self.problem.states, len(self.problem.touches)
        out = np.zeros((len(self.residual), len(self.u)))
        out[:n, :n] = self.scaled_monodromy - np.eye(n)
        for each in range(k):
            self._touch_block(out, each)
        self._by_states(out)
        for axis in range(len(self.problem.plane.names)):
            out[:, n + k + axis] = self._along(axis)
        return out

    def _rows_of(self, k: int) -> slice:
        first = self.problem.states + sum(2 + len(touch.zero) for touch in self.problem.touches[:k])
        return slice(first, first + 2 + len(self.problem.touches[k].zero))

    def _touch_block(self, out: Array, k: int) -> None:
        """Of one touch by the state and by its own phase."""
        n, touch, phase = self.problem.states, self.problem.touches[k], float(self.problem.phases(self.u)[k])
        states, flows = self.course
        index, rows = self.leg_of(phase), self._rows_of(k)
        leg, size = self.legs[index], self.surface_size(touch.window)
        way = states[index], leg, phase, self.touch_flows[k][1]
        gradient = surface_rows(self.props, touch.window, *way) @ flows[index]
        out[rows.start : rows.start + 2, :n] = gradient * self.problem.size / size[:, None]
        series, cycle = self.at_touch(k), 2.0 * np.pi / self.props.system.omega
        out[rows.start : rows.start + 2, n + k] = series[1:3] * cycle / size
        if touch.zero:
            beyond = self._moved(n + k, self.problem.step)
            moved = beyond.touch_values(k, beyond.course[0]) - self.touch_values(k, states)
            out[rows.start + 2 : rows.stop, n + k] = moved[2:] / self.problem.step

    def _by_states(self, out: Array) -> None:
        """Conditions, and further derivatives of touches, by the state: differences."""
        n, problem = self.problem.states, self.problem
        degenerate = [k for k, touch in enumerate(problem.touches) if touch.zero]
        if not problem.all_conditions and not degenerate:
            return
        here, first, step = self.residual, len(self.residual) - len(problem.all_conditions), problem.step
        for i in range(n):
            u = self.u.copy()
            u[i] += step
            states, flows = self.carried_from(problem.state(u))
            for k in degenerate:
                rows = slice(self._rows_of(k).start + 2, self._rows_of(k).stop)
                out[rows, i] = (self.touch_values(k, states)[2:] - here[rows]) / step
            matrix = flows[-1] * problem.size / problem.size[:, None]
            for j, condition in enumerate(problem.all_conditions):
                out[first + j, i] = (condition.value(matrix) - here[first + j]) / step

    def _along(self, axis: int) -> Array:
        """Derivative of the residual along one scaled parameter."""
        if self.problem.is_plain:
            return self._along_exactly(axis)
        index = len(self.u) - len(self.problem.plane.names) + axis
        top = self.problem.plane.outer(axis) / self.problem.plane.unit[axis]
        step = self.problem.step
        step = step if self.u[index] + step <= top else -step
        return (self._moved(index, step).residual - self.residual) / step

    def _along_exactly(self, axis: int) -> Array:
        """The same, of plain equations. No differences: where a parameter is a step away the extremum lies
        on one side of its boundary, a flat one for longer than its window, so that contacts come in."""
        plane, states = self.problem.plane, self.course[0]
        beside = Beside.of(plane, self.problem.place(self.u), axis, self.props.system)
        moved = moved_states(self.props, states, self.legs, beside)
        found = [moved[-1] / self.problem.size]
        phases = self.problem.phases(self.u).tolist()
        for k, (phase, touch) in enumerate(zip(phases, self.problem.touches, strict=True)):
            at, jacobian = self.touch_flows[k]
            away = moved_end(self.touch_traces[k], jacobian, moved[self.leg_of(phase)], beside)
            rate = moved_gap(at, away, phase, touch.window, beside)
            found.append(rate / self.surface_size(touch.window))
        return np.concatenate(found) * float(plane.unit[axis])

    def _moved(self, index: int, step: float) -> Evaluated:
        u = self.u.copy()
        u[index] += step
        moved = index >= len(u) - len(self.problem.plane.names)
        return self.problem.evaluate(u, None if moved else self.props)


def _shut(window: Window) -> Window:
    return replace(window, width=0.0)
