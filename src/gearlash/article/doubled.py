"""What a doubled orbit touches first: how far a period doubling and a grazing lie apart, and why.

At a doubling the doubled orbit opens from the single one like a square root: at the distance s its motion
differs by an amplitude a, with s = c a² + …. An extremum at a clearance h from a boundary then comes nearer
by about b a, so that it touches at a = h/b, that is at s = c (h/b)²: small amplitudes reach far, and a
doubling whose orbit passes a boundary closely has a grazing right beside it. Both would fall into one point
only where h = 0 as well, which takes a second parameter.

The doubled orbit is followed by its amplitude, which is regular where the parameter is not: unknowns z0 and
μ, equations P(z0) = z0 over the doubled period and v·(z0 − z_d) = a, with v the eigenvector of the multiplier
−1 of the orbit z_d at the doubling."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash import flow
from gearlash.branches import GrazingPoint, locate_grazing
from gearlash.branches.continuation import SpecialPoint
from gearlash.case import Case
from gearlash.flow import Propagators
from gearlash.orbits import GrazingCheck, Orbit, grazing_checks, orbit_at
from gearlash.results import Direction
from gearlash.studies.transition import DOUBLING, Transition
from gearlash.system import Family, GearlashError, MotionKind, Status

from .reproduction import Coincidence, Opening

Array = NDArray[np.float64]
Found = tuple[Transition, tuple[Direction, ...]]
Beside = tuple[Coincidence, tuple[Direction, ...]]
SAME_DOUBLING = 1e-8  # relative distance of two values that are one doubling
FIRST, GROWTH, MOST = 3e-4, 1.3, 40  # amplitudes of the doubled orbit: the first, its growth, how many
NEAREST = 3  # extrema that are tried, those nearest to a boundary first
FARTHEST = 0.02  # of the parameter: a touch beyond is not beside the doubling
ITERATIONS, SOLVED = 15, 1e-12
STEP = 1e-7  # of the parameter: for the derivative
LEAST_AMPLITUDES = 4  # amplitudes from which the square root is read
SHOWN = 6  # amplitudes that are kept, evenly among those that were followed


def first_touch(family: Family, point: SpecialPoint) -> Coincidence | None:
    """The grazing that the orbit born at a doubling meets first, within 2 % of the parameter; None if there
    is none, or it cannot be followed there."""
    try:
        branch = _Branch.at(family, point)
        single = branch.single()
        followed = [(0.0, point.value, single)]
        for step in branch.steps():
            if step[2].signature != single.signature.twice:
                break  # it has touched
            followed.append(step)
        touch = _located(branch, followed) if len(followed) > LEAST_AMPLITUDES else None
        return None if touch is None else _coincidence(point, touch, followed)
    except (GearlashError, np.linalg.LinAlgError):
        return None


def coincidences(case: Case, found: Sequence[Found], executor: Executor) -> list[Beside]:
    """The first touch beside every doubling that was located, with the directions it was met in."""
    met: dict[float, tuple[SpecialPoint, list[Direction]]] = {}
    for transition, directions in found:
        if transition.kind != DOUBLING or transition.point is None:
            continue
        value = next(
            (v for v in met if abs(v - transition.value) <= SAME_DOUBLING * abs(v)), transition.value
        )
        ways = met.setdefault(value, (transition.point, []))[1]
        ways += [d for d in directions if d not in ways]
    tasks = [executor.submit(beside, case.to_json(), point) for point, _ in met.values()]
    touches = [task.result() for task in tasks]
    return [
        (touch, tuple(directions))
        for touch, (_, directions) in zip(touches, met.values(), strict=True)
        if touch is not None
    ]


def beside(case_json: str, point: SpecialPoint) -> Coincidence | None:
    """`first_touch` of a case (a task for a worker)."""
    return first_touch(Case.from_json(case_json).family()[0], point)


@dataclass(frozen=True, eq=False)
class _Branch:
    """The doubled orbits of one doubling."""

    family: Family
    values: Mapping[str, float]
    name: str
    value: float
    state: Array
    period: int
    direction: Array

    @staticmethod
    def at(family: Family, point: SpecialPoint) -> _Branch:
        props = flow.propagators(family.system(point.values))
        end = flow.variational(props, point.point.state, float(point.period))
        assert end.jacobian is not None
        values, vectors = np.linalg.eig(end.jacobian)
        vector = np.real(vectors[:, np.abs(values + 1.0).argmin()])
        vector = vector / np.linalg.norm(vector)
        return _Branch(family, point.values, point.name, point.value, point.point.state, point.period, vector)

    def props(self, mu: float) -> Propagators:
        return flow.propagators(self.family.system({**self.values, self.name: mu}))

    def orbit(self, mu: float, state: Array, periods: int) -> Orbit:
        """The orbit over so many of the single one's periods."""
        props = self.props(mu)
        found = orbit_at(props, state, periods * self.period // props.system.cycles)
        if found is None:
            raise GearlashError(f"no orbit at {self.name} = {mu:.10g}")
        return found

    def single(self) -> Orbit:
        return self.orbit(self.value, self.state, 1)

    def steps(self) -> Iterator[tuple[float, float, Orbit]]:
        """(amplitude, parameter, doubled orbit) from small to large, as far as they can be had."""
        amplitude, state, mu = FIRST, self.state + FIRST * self.direction, self.value
        for _ in range(MOST):
            try:
                solved = self.solved(amplitude, state, mu)
            except (GearlashError, np.linalg.LinAlgError):  # Newton's method left the valid range
                return
            if solved is None or abs(solved[1] - self.value) > FARTHEST * abs(self.value):
                return
            state, mu = solved
            orbit = self.orbit(mu, state, 2)
            if not orbit.status.ok:
                return
            yield amplitude, mu, orbit
            amplitude *= GROWTH
            state = self.state + GROWTH * (state - self.state)

    def solved(self, amplitude: float, state: Array, mu: float) -> tuple[Array, float] | None:
        """The doubled orbit of this amplitude and its parameter, by Newton's method."""
        n, cycles = len(state), 2.0 * self.period
        matrix = np.zeros((n + 1, n + 1))
        matrix[n, :n] = self.direction
        step = STEP * max(abs(mu), 1e-3)
        for _ in range(ITERATIONS):
            end = flow.variational(self.props(mu), state, cycles)
            beside = flow.variational(self.props(mu + step), state, cycles)
            assert end.jacobian is not None
            matrix[:n, :n] = end.jacobian - np.eye(n)
            matrix[:n, n] = (beside.state - end.state) / step
            defect = np.append(end.state - state, self.direction @ (state - self.state) - amplitude)
            change = np.linalg.solve(matrix, -defect)
            if not np.isfinite(change).all():
                return None
            state, mu = state + change[:n], mu + float(change[n])
            if np.abs(change).max() <= SOLVED * max(1.0, float(np.abs(state).max())):
                return state, mu
        return None


def _located(branch: _Branch, followed: list[tuple[float, float, Orbit]]) -> GrazingPoint | None:
    """The touch that comes next, solved for from the last doubled orbit before it: its label towards the
    doubling is that of the doubled orbit."""
    _, mu, orbit = followed[-1]
    wanted = followed[0][2].signature.twice
    for check in grazing_checks(orbit)[:NEAREST]:
        graze = locate_grazing(
            branch.family, branch.name, orbit, check, values={**branch.values, branch.name: mu}
        )
        near = abs(graze.value - branch.value) <= FARTHEST * abs(branch.value)
        towards = graze.label_above if graze.value < branch.value else graze.label_below
        known = graze.status is Status.OK and MotionKind.NONE not in (graze.label_below, graze.label_above)
        if known and graze.surface == "gap" and near and towards == wanted:
            return graze
    return None


def _coincidence(
    point: SpecialPoint,
    graze: GrazingPoint,
    followed: list[tuple[float, float, Orbit]],
) -> Coincidence:
    orbits = [orbit for _, _, orbit in followed]
    clearances = _clearances(orbits, graze)
    opening = [
        Opening(a, abs(mu - point.value), clearance)
        for (a, mu, _), clearance in zip(followed[1:], clearances[1:], strict=True)
    ]
    predicted, power = _square_root(opening, clearances[0])
    return Coincidence(
        doubling=point,
        grazing=graze,
        single=followed[0][2].label,
        doubled=orbits[0].signature.twice,
        beyond=graze.label_below if graze.value < point.value else graze.label_above,
        apart=abs(graze.value - point.value),
        clearance=clearances[0],
        predicted=predicted,
        power=power,
        opening=tuple(opening[:: max(1, len(opening) // SHOWN)]),
    )


def _square_root(opening: list[Opening], clearance: float) -> tuple[float, float]:
    """Distance of the touch as foreseen from the smallest amplitudes alone, and the power of the opening
    measured there: amplitude ∼ distance^power."""
    if len(opening) < LEAST_AMPLITUDES:
        return float("nan"), float("nan")
    a, s, d = np.array([(o.amplitude, o.distance, o.clearance) for o in opening[:LEAST_AMPLITUDES]]).T
    power = float(np.polyfit(np.log(s), np.log(a), 1)[0])
    approach = float(np.mean((clearance - d) / a))
    return float(np.mean(s / a**2)) * (clearance / approach) ** 2, power


def _clearances(orbits: list[Orbit], graze: GrazingPoint) -> list[float]:
    """Distance from its boundary of the extremum that touches, in each of these orbits: followed by its
    phase, from the last one, where it is nearest to the boundary, back to the first."""
    last = next(check for check in grazing_checks(orbits[-1]) if _alike(check, graze))
    found, phase = [], last.phase
    for orbit in reversed(orbits):
        alike = [check for check in grazing_checks(orbit) if _alike(check, graze)]
        apart = [_apart(check.phase, phase, float(orbit.period)) for check in alike]
        check = alike[int(np.argmin(apart))]
        phase = check.phase
        found.append(abs(check.distance))
    return found[::-1]


def _apart(one: float, other: float, period: float) -> float:
    """Distance of two phases of one period."""
    return abs((one - other + 0.5 * period) % period - 0.5 * period)


def _alike(check: GrazingCheck, graze: GrazingPoint) -> bool:
    same = check.surface == graze.surface and check.clearance == graze.clearance
    return same and check.boundary == graze.boundary and check.a0 * graze.a0 > 0.0
