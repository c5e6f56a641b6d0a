"""The derivative of a motion by a parameter: exact invariances, and differences of motions."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from gearlash import flow
from gearlash.flow.sensitivity import SystemChange, sensitivity
from gearlash.system import Clearance, ContactRule, System, constant, cosines
from oracles.members import random_member

Varied = Callable[[System, float], System]
CYCLES = 2.0


def members(seed: int, count: int = 3):
    """Systems of one to three gaps under each rule, with motions that meet contacts."""
    rng = np.random.default_rng(seed)
    for rule in ContactRule:
        for k in range(count):
            yield random_member(rng, 2 + 2 * (k % 2), 1 + k % 2, (rule,), harmonics=2)


def with_clearances(system: System, change: Callable[[Clearance], Clearance], **more) -> System:
    return replace(system, clearances=tuple(change(c) for c in system.clearances), **more)


def scaled(system: System, s: float) -> System:
    """Load, errors and gaps s times as large: so is every motion."""
    return with_clearances(
        system,
        lambda c: replace(c, offset=s * c.offset, gap_plus=s * c.gap_plus, gap_minus=s * c.gap_minus),
        forcing=s * system.forcing,
    )


def faster(system: System, s: float) -> System:
    """All runs s times as fast: over phases, nothing changes."""
    return with_clearances(
        system,
        lambda c: replace(
            c,
            g=s * c.g,
            damping=c.damping / s,
            damping_minus=None if c.damping_minus is None else c.damping_minus / s,
        ),
        omega=s * system.omega,
        matrix=s * system.matrix,
        forcing=s * system.forcing,
    )


def moved(system: System, a: float) -> System:
    """Gaps that are read from another place, with boundaries that are there too: nothing changes."""

    def change(c: Clearance) -> Clearance:
        offset = c.offset.copy()
        offset[0] += a
        return replace(c, offset=offset, gap_plus=c.gap_plus - a, gap_minus=c.gap_minus + a)

    return with_clearances(system, change)


def derivative(system: System, start: np.ndarray, vary: Varied, at: float, step: float) -> np.ndarray:
    trace = flow.trace(system, start, CYCLES * system.cycles)
    assert trace.status.ok
    return sensitivity(
        trace, SystemChange.between(vary(system, at - step), vary(system, at + step), 2.0 * step)
    )[0]


def test_a_motion_is_as_large_as_all_that_makes_it():
    """Euler: the derivatives by the scale of all lengths and of the start add up to the end itself."""
    crossings = 0
    for system, start in members(1):
        by_scale = derivative(system, start, scaled, 1.0, 0.5)
        end = flow.variational(system, start, CYCLES * system.cycles)
        assert end.jacobian is not None
        crossings += int(end.contacts.sum())
        size = np.abs(end.jacobian) @ np.abs(start) + np.abs(end.state).max() + 1.0
        assert (np.abs(end.jacobian @ start + by_scale - end.state) <= 1e-12 * size).all()
    assert crossings > 20


@pytest.mark.parametrize(
    ("vary", "at", "step", "most"), [(moved, 0.0, 0.25, 1e-12), (faster, 1.0, 1e-5, 1e-8)]
)
def test_what_changes_nothing_has_no_derivative(vary, at, step, most):
    for system, start in members(2):
        found = derivative(system, start, vary, at, step)
        assert np.abs(found).max() < most * (1.0 + np.abs(start).max())


def by_offset(system: System, s: float) -> System:
    return with_clearances(system, lambda c: replace(c, offset=(1.0 + s) * c.offset))


def by_gap(system: System, s: float) -> System:
    return with_clearances(
        system, lambda c: replace(c, gap_plus=c.gap_plus + s, gap_minus=c.gap_minus + 2.0 * s)
    )


def by_stiffness(system: System, s: float) -> System:
    return with_clearances(
        system,
        lambda c: replace(
            c, stiffness_plus=(1.0 + s) * c.stiffness_plus, stiffness_minus=(1.0 - s) * c.stiffness_minus
        ),
    )


def by_damping(system: System, s: float) -> System:
    return with_clearances(system, lambda c: replace(c, damping=c.damping + s))


def by_directions(system: System, s: float) -> System:
    return with_clearances(system, lambda c: replace(c, h=(1.0 + s) * c.h, g=(1.0 - 2.0 * s) * c.g))


def by_matrix(system: System, s: float) -> System:
    return replace(system, matrix=(1.0 + s) * system.matrix, forcing=(1.0 + s) * system.forcing)


def by_speed(system: System, s: float) -> System:
    return replace(system, omega=system.omega * (1.0 + s))


EVERY = [by_offset, by_gap, by_stiffness, by_damping, by_directions, by_matrix, by_speed]


@pytest.mark.parametrize("vary", EVERY)
def test_against_differences_of_motions(vary):
    """Of fourth order, where the contacts stay the same over all of its steps."""
    compared, step = 0, 1e-4
    for system, start in members(3):
        cycles = CYCLES * system.cycles
        ends = {k: flow.carry(vary(system, k * step), start, cycles) for k in (-2, -1, 0, 1, 2)}
        if len({tuple(end.contacts) for end in ends.values()}) > 1:
            continue
        states = {k: end.state for k, end in ends.items()}
        expected = (8.0 * (states[1] - states[-1]) - (states[2] - states[-2])) / (12.0 * step)
        found = derivative(system, start, vary, 0.0, 1e-5)
        wide = (states[2] - states[-2]) / (4.0 * step)  # what terms of higher order are worth
        allowed = 1e-8 * (1.0 + np.abs(expected).max()) + 1e-2 * np.abs(wide - expected).max()
        assert np.abs(found - expected).max() < allowed
        compared += 1
    assert compared > 6


@pytest.mark.jit_and_nojit
@pytest.mark.parametrize("rule", ContactRule)
def test_parts_begin_anew(rule):
    h, g = np.array([1.0, 0.0]), np.array([0.0, -1.0])
    soft, hard = cosines(4.0, [0.3]), constant(2.0)
    stop = Clearance(h, g, 0.3, 0.4, soft, hard, 0.1, constant(0.1), rule)
    matrix, forcing = np.array([[0.0, 1.0], [-1.0, -0.1]]), np.zeros((2, 3))
    forcing[1] = 0.1, 1.0, 0.2
    system = System(1.1, matrix, forcing, (stop,))
    start = np.array([0.5, 0.6])
    change = SystemChange.between(scaled(system, 0.5), scaled(system, 1.5), 1.0)
    trace = flow.trace(system, start, 2.0 * system.cycles)
    first, second = sensitivity(trace, change, 2)
    whole = sensitivity(trace, change)[0]
    half = flow.carry(system, start, float(system.cycles)).state
    later = flow.variational(system, half, float(system.cycles))
    assert later.jacobian is not None
    assert whole == pytest.approx(later.jacobian @ first + second, rel=1e-11, abs=1e-12)


@pytest.mark.parametrize("length", [1e-3, 1e-9])
def test_a_motion_much_shorter_than_a_cell(length):
    """In proportion to its length."""
    system, start = next(members(3))
    change = SystemChange.between(scaled(system, 0.5), scaled(system, 1.5), 1.0)
    found, longer = (
        sensitivity(flow.trace(system, start, part * length), change)[0] / (part * length)
        for part in (1.0, 2.0)
    )
    assert np.abs(longer).max() > 0.1
    assert found == pytest.approx(longer, rel=100.0 * length, abs=100.0 * length)
