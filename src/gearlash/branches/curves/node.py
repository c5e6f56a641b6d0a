"""One orbit of a curve with all that the follower looks at."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from gearlash.branches.continuation.extrema import Extrema, Extremum
from gearlash.branches.continuation.testfunctions import Spectrum
from gearlash.orbits.floquet import ordered
from gearlash.system import ContactRule, GearlashError

from .motion import CurveOrbit, apart
from .newton import ENOUGH, Corrected, correct, left_over, tangent
from .plane import UNBUILT, Array
from .problem import Evaluated, Problem, TouchCondition
from .touch import carried

MIDDLE = 0.2  # of the orbit: a touch so near to where it is begun or ends is too near
CONTACT = 0.03  # mesh cycles: the same of a contact
OPPOSITE = 0.499
"""Of an orbit: where one begins that touches at 0. At 0.5 a motion that is alike both ways has an extremum,
which rounding may put before the beginning and behind the end."""
LEAST_GAIN = 0.1  # of the distance that is far enough: for less it is not begun elsewhere


@dataclass(frozen=True, eq=False)
class Node:
    """``direction``: unit tangent of the curve; ``touching``: numbers of the extrema that touch."""

    here: Evaluated
    jacobian: Array
    direction: Array
    motion: CurveOrbit
    touching: frozenset[int]

    @property
    def problem(self) -> Problem:
        return self.here.problem

    @property
    def u(self) -> Array:
        return self.here.u

    @property
    def place(self) -> Array:
        return self.problem.place(self.u)

    @property
    def extrema(self) -> Extrema:
        return self.motion.extrema

    @cached_property
    def spectrum(self) -> Spectrum:
        return Spectrum(ordered(np.linalg.eigvals(self.here.monodromy)), 0.0)

    @cached_property
    def touch_series(self) -> list[Array]:
        """(H, H', H″, H‴) of every touch."""
        return [self.here.at_touch(k) for k in range(len(self.problem.touches))]

    @property
    def touched(self) -> list[Extremum]:
        """The extrema that touch, in the order of the touches."""
        phases, touches = self.problem.phases(self.u).tolist(), self.problem.touches
        found = [self.motion.beside(t, each.window) for t, each in zip(phases, touches, strict=True)]
        return [each for each in found if each is not None]

    @property
    def linear(self) -> bool:
        """Whether the orbit meets no boundary."""
        return not any(map(any, self.motion.signature.counts))

    @property
    def turned(self) -> Node:
        return replace(self, direction=-self.direction)

    def along(self, problem: Problem) -> Node:
        """The same with another problem of the same unknowns (other extrema kept)."""
        return replace(self, here=problem.evaluate(self.u, self.here.props))


def node_of(corrected: Corrected, toward: Array, before: Node | None) -> Node:
    """Of a solution; its direction agrees with ``toward``, its extrema continue those of ``before``. Raises
    what `UNBUILT` names."""
    here = corrected.here
    assert here is not None
    motion = CurveOrbit.of(here)
    problem = here.problem.near(here).beside(motion.nearest(here, motion.held(here)))
    here = Evaluated(problem, here.u, here.props)
    jacobian = here.jacobian()
    if before is not None:
        motion = replace(motion, extrema=motion.extrema.after(before.extrema))
    node = Node(here, jacobian, tangent(jacobian, toward), motion, frozenset())
    return _with_windows(node)


def _with_windows(node: Node) -> Node:
    """With the windows of now around the touches, and the numbers of what touches."""
    touched = node.touched
    if len(touched) < len(node.problem.touches):
        raise GearlashError("the extremum that touches is no longer one whose boundary could be held")
    touches = tuple(
        replace(touch, window=node.motion.window(extremum))
        for touch, extremum in zip(node.problem.touches, touched, strict=True)
    )
    problem = replace(node.problem, touches=touches)
    here = Evaluated(problem, node.u, node.here.props)
    return replace(node, here=here, touching=frozenset(extremum.number for extremum in touched))


def solved(
    problem: Problem,
    guess: Array,
    row: Array,
    target: float,
    before: Node | None,
    jacobian: Array | None = None,
) -> tuple[Node | None, Corrected]:
    """The point of a curve with row·u = ``target``, or why there is none; ``jacobian``: one that is near."""
    if jacobian is None and before is not None:
        jacobian = before.jacobian
    corrected = correct(problem, guess, row, target, jacobian)
    if corrected.here is None:
        return None, corrected
    toward = row if before is None else before.direction
    try:
        node = node_of(corrected, toward, before)
        if left_over(node.here, node.jacobian) > ENOUGH:  # the windows have changed it
            again = correct(node.problem, node.u, row, target, node.jacobian)
            if again.here is None:
                return None, again
            node = node_of(again, toward, before)
        return node, corrected
    except UNBUILT as error:
        return None, Corrected(None, corrected.jacobian, corrected.steps, str(error))


def begun_at(node: Node, origin: float) -> Node:
    """The same orbit, begun at another phase. Raises what `UNBUILT` names."""
    here, problem, n = node.here, node.problem, node.problem.states
    cycles = here.cycles
    forward = (origin - problem.origin) % cycles
    state = state_at(here, problem.origin + forward)
    origin = origin % cycles
    u = node.u.copy()
    u[:n] = state / problem.size
    phases = origin + (problem.phases(node.u) - origin) % cycles
    u[n : n + len(phases)] = phases
    kept = tuple((origin + (phase - origin) % cycles, window) for phase, window in problem.kept)
    moved = replace(problem, origin=origin, kept=kept)
    return node_of(Corrected(Evaluated(moved, u, here.props), np.empty(0)), _toward(node, moved), node)


def _toward(node: Node, moved: Problem) -> Array:
    """The direction, as far as it does not depend on where the orbit is begun."""
    toward: Array = node.direction.copy()
    toward[: moved.states] = 0.0
    return toward


def state_at(here: Evaluated, phase: float) -> Array:
    """The state (n,) at a phase of the orbit."""

    states = here.course[0]
    cycles, origin = here.cycles, here.problem.origin
    phase = origin + (phase - origin) % cycles
    for state, leg in zip(states[:-1], here.legs, strict=True):
        if phase <= leg.end:
            return state if phase == leg.begin else carried(here.props, state, leg, phase)[0]
    raise GearlashError("a phase has left the orbit")


def well_begun(node: Node, phases: list[float]) -> Node:
    """The same orbit, begun far from some phases at which something touches; and from all contacts, where
    the acceleration jumps there: else states have a kink along the curve, although the orbit has none."""
    jumps = any(
        c.contact is not ContactRule.ALWAYS and any(c.dampings) for c in node.here.props.system.clearances
    )
    contacts = node.motion.contacts.tolist() if jumps else []

    def room(origin: float) -> float:
        """How far from everything an origin lies, 1 where that is far enough."""
        cycles = node.here.cycles
        return min(
            1.0,
            *(apart(origin, each, cycles) / (MIDDLE * cycles) for each in phases),
            *(apart(origin, each, cycles) / CONTACT for each in contacts),
        )

    if (not phases and not contacts) or room(node.problem.origin) >= 1.0:
        return node
    marks = np.sort(np.array([*phases, *contacts]) % node.here.cycles)
    between = marks + OPPOSITE * np.diff(np.append(marks, marks[0] + node.here.cycles))
    tried = [*between.tolist(), *(phase - OPPOSITE * node.here.cycles for phase in phases)]
    best = max(tried, key=room)
    return begun_at(node, best) if room(best) > room(node.problem.origin) + LEAST_GAIN else node


def touch_of(node: Node, extremum: Extremum) -> tuple[TouchCondition, float]:
    """An extremum as a touch, and its phase on the orbit as it is begun."""
    origin = node.problem.origin
    return TouchCondition(node.motion.window(extremum)), origin + (extremum.phase - origin) % node.here.cycles
