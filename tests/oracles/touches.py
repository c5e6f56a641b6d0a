"""Near-touches of any surface of the class, built backwards from the extremum, as in `grazes`.

The touch is put first: δ of one side (or, under `no-tension`, what presses: P = η δ + ζ δ′) at an extremum,
a depth d beyond or short of zero. Other clearances are where the draw has them, or one of them is put on its
boundary within 1e-3 to 1e-10 of the same instant. Then 80-bit integration backwards gives a start. So how
many events there are near the touch does not rest on any method having found them.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from gearlash.system import System

from . import region_oracle
from .clearances import TAU, Real, Side, angle, contact_forces, gap, gap_velocity, series_taylor, sides
from .members import RULES, random_member, random_start
from .motion import Walk

NEAR = Real(1e-4)  # τ over which the curvature at the touch is measured
SIZES = (2, 3, 4, 6, 9, 12)


@dataclass(frozen=True)
class Touch:
    """A start from which one surface comes to an extremum at ``depth`` beyond (+) or short of (−) zero.

    ``events``: how many there are of this side within ``window`` mesh cycles of ``at``, known from the depth;
    None where that does not tell: under `no-tension` a minimum of δ lies between two zeros of P, and the
    contact of another clearance nearby bends what follows.
    """

    system: System
    start: np.ndarray
    phase: float  # of the start
    span: float  # cycles from the start to a little after the touch
    side: Side
    early: bool  # P touches, else δ
    rising: bool  # a maximum, seen from below; else a minimum, seen from above
    depth: float
    curvature: float
    at: float  # phase of the touch
    window: float
    events: int | None
    companion: int | None  # clearance that was put on its boundary at the same time
    truth: Walk  # forward, over exactly [phase, phase + span]

    @property
    def told(self) -> str:
        what = "P" if self.early else "δ"
        return (
            f"{self.side.rule.value}, {what} of clearance {self.side.clearance} side {self.side.sign:+d}, "
            f"{'maximum' if self.rising else 'minimum'}, depth {self.depth:.3e}, curvature "
            f"{self.curvature:.2e}, at {self.at!r}, companion {self.companion}, "
            f"{self.system.size} states"
        )

    def near(self, events) -> int:
        """How many of the events of a trace belong to the touch."""
        index = getattr(events, "clearance", np.zeros(len(events), dtype=int))
        mine = (index == self.side.clearance) & (events.boundary == self.side.sign)
        return int((mine & (np.abs(events.phase - self.at) < self.window)).sum())


def touches(
    seed: int, count: int, clearances: tuple[int, ...] = (1, 2, 3), rules=RULES, depths=(1e-10, 1e-3)
) -> Iterator[Touch]:
    """``count`` touches with depths of either sign in that range; up to eight of one system in a row."""
    rng, made = np.random.default_rng(seed), 0
    while made < count:
        system, _ = random_member(rng, int(rng.choice(SIZES)), int(rng.choice(clearances)), rules)
        for _ in range(8):
            touch = random_touch(rng, system, depths)
            if touch is not None:
                made += 1
                yield touch
            if made == count:
                return


def random_touch(rng: np.random.Generator, system: System, depths) -> Touch | None:
    """One touch, or None where the draw allows none (curvature of the wrong sign, useless start)."""
    phase = float(rng.uniform(0, system.cycles))
    stiff = sides(system)
    if not stiff or not all(side.stiffness.any() for side in stiff):  # dampers: `test_dampers`
        return None
    side = stiff[int(rng.integers(len(stiff)))]
    early = side.releases_early and side.damping > 0.0 and system.size > 2 and rng.uniform() < 0.8
    rising = bool(rng.integers(2))
    depth = float(rng.choice([-1, 1])) * 10 ** rng.uniform(*np.log10(depths))
    height = depth if rising else -depth
    companion = _companion(rng, system, side)
    state = random_start(rng, system, phase).astype(Real)
    extra = [] if companion is None else [_on_boundary(rng, system, companion, phase)]
    if early:
        state = place_early_touch(rng, system, side, state, phase, height, extra)
    else:
        state = place_touch(system, side, state, phase, height, extra)
    if state is None or np.abs(state).max() > 20.0:
        return None
    curvature = _curvatures(system, side, early, state, phase)
    if any(c * (1 if rising else -1) > -1e-2 for c in curvature):
        return None
    back = region_oracle.run(system, state, -_backward_cycles(rng, system), phase)
    start, begin = back.state.astype(float), float(back.end)
    if np.abs(start).max() > 100.0 or _nearest(system, start, begin) < 1e-6:
        return None
    span = 1.5 * (phase - begin)
    truth = region_oracle.run(system, start, span, begin)
    period = 2 * np.pi / system.omega
    window = 2 * np.sqrt(2 * abs(depth) / min(abs(float(c)) for c in curvature)) / period
    alone = companion is None and not any(
        event.clearance != side.clearance and abs(float(event.phase) - phase) < window
        for event in truth.events
    )
    known = (early or rising or not side.releases_early) and window < 0.004 and alone
    return Touch(
        system, start, begin, span, side, early, rising, depth, float(curvature[0]), phase, window,
        events=2 * int(depth > 0) if known else None,
        companion=companion and companion.clearance,
        truth=truth,
    )  # fmt: skip


Row = tuple[np.ndarray, np.longdouble]  # coefficients and wanted value of an affine condition on the state


def place_touch(system: System, side: Side, state, phase: float, height: float, extra: list[Row]):
    """The state moved to δ = height, δ′ = 0, or None."""
    read, level = _rows(system, side.clearance, phase)
    x = side.sign * (Real(side.edge) + Real(height))
    return _placed(state, [(read[0], x - level[0]), (read[1], -level[1]), *extra])


def place_early_touch(rng, system: System, side: Side, state, phase: float, height: float, extra: list[Row]):
    """The state moved to P = height, P′ = 0 at some overlap: conditions on X, X′ and X″. The contact forces
    in X″ are those of the last state, until they stay. None if they do not."""
    rate = Real(system.omega) / system.cycles
    c, (read, level) = system.clearances[side.clearance], _rows(system, side.clearance, phase)
    eta, slope = series_taylor(side.stiffness, angle(system, phase), rate, 1)
    overlap, press = Real(rng.uniform(0.02, 0.3)), Real(height)
    closing = (press - eta * overlap) / Real(side.damping)
    bend = -(slope * overlap + eta * closing) / Real(side.damping)
    gains = np.array([c.h.astype(Real) @ system.matrix.astype(Real) @ other.g for other in system.clearances])
    for _ in range(60):
        push = gains @ contact_forces(system, state, phase)
        values = side.sign * np.array([side.edge + overlap, closing, bend]) - level - [0, 0, push]
        moved = _placed(state, [*zip(read, values, strict=True), *extra])
        if moved is None:
            return None
        if np.abs(moved - state).max() < 1e-16:
            return moved
        state = moved
    return None


def _on_boundary(rng, system: System, side: Side, phase: float) -> Row:
    """δ within 1e-10 to 1e-3 of zero, for whatever velocity it has."""
    read, level = _rows(system, side.clearance, phase)
    away = Real(rng.choice([-1, 1]) * 10 ** rng.uniform(-10, -3))
    return read[0], side.sign * (Real(side.edge) + away) - level[0]


def _rows(system: System, clearance: int, phase: float):
    """(read (3, n), level (3,)): X, X′ and X″ without contact forces are read·z + level."""
    c, at = system.clearances[clearance], angle(system, phase)
    rate = Real(system.omega) / system.cycles
    h, matrix, forcing = c.h.astype(Real), system.matrix.astype(Real), system.forcing.astype(Real)
    read = np.array([h, h @ matrix, h @ matrix @ matrix])
    offset = series_taylor(c.offset, at, rate, 2) * [1, 1, 2]
    push = series_taylor(h @ forcing, at, rate, 1)
    second = series_taylor(h @ matrix @ forcing, at, 0, 0)[0]
    return read, np.array([-offset[0], push[0] - offset[1], push[1] + second - offset[2]])


def _placed(state: np.ndarray, wanted: list[Row]) -> np.ndarray | None:
    """The nearest state that meets the conditions, or None where they contradict each other."""
    rows, values = np.array([r for r, _ in wanted]), np.array([v for _, v in wanted])
    inverse = np.linalg.pinv(rows.astype(float)).astype(Real)
    for _ in range(6):
        state = state + inverse @ (values - rows @ state)
    return state if np.abs(values - rows @ state).max() < 1e-16 else None


def surface_height(system: System, side: Side, early: bool, state, phase):
    """δ, or P."""
    c = system.clearances[side.clearance]
    delta = side.sign * gap(system, c, state, phase) - Real(side.edge)
    if not early:
        return delta
    eta = series_taylor(side.stiffness, angle(system, phase), 0, 0)[0]
    return eta * delta + Real(side.damping) * side.sign * gap_velocity(system, c, state, phase)


def _curvatures(system: System, side: Side, early: bool, state, phase: float):
    """Second derivative (d²/dτ²) of the surface just after and just before."""
    here, cycles = surface_height(system, side, early, state, phase), NEAR * Real(system.omega) / TAU
    out = []
    for way in (1, -1):
        there = region_oracle.run(system, state, way * cycles, phase)
        out.append(2 * (surface_height(system, side, early, there.state, there.end) - here) / NEAR**2)
    return out


def _companion(rng, system: System, side: Side) -> Side | None:
    others = [s for s in sides(system) if s.clearance != side.clearance]
    return others[int(rng.integers(len(others)))] if others and rng.integers(2) else None


def _nearest(system: System, state, phase: float) -> float:
    """Least distance to any surface."""
    found = [abs(surface_height(system, s, False, state, phase)) for s in sides(system)]
    found += [abs(surface_height(system, s, True, state, phase)) for s in sides(system) if s.releases_early]
    return float(min(found))


def _backward_cycles(rng: np.random.Generator, system: System) -> float:
    """At most half a cycle and 3 units of τ: damping makes the backward flow grow."""
    return min(float(rng.uniform(0.02, 0.5)), float(rng.uniform(0.1, 3.0)) * system.omega / (2 * np.pi))
