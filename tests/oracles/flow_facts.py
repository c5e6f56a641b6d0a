"""Facts about the flow with a truth of their own, quick enough for kernels as plain Python.

`python -m oracles.flow_facts NAME …` asserts the named facts (without a name: all). It is what mutants of the
flow have to fail (`mutants`), so every fact sits where a bound, a remainder or a direction decides.
Nothing here asks the kernels for the truth: motions are exponentials and harmonics, events are put by hand.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import product
from types import SimpleNamespace
from typing import Any

import mpmath as mp
import numpy as np

from gearlash import flow
from gearlash.system import ContactRule, Status, System
from oracles.oscillators import oscillator, side_by_side

ENGAGED = {1: [1, 0, 0, 0], -1: [0, 1, 0, 0]}  # columns of `Strobes.contacts`
RELEASED = {1: [0, 0, 1, 0], -1: [0, 0, 0, 1]}
HARMONIC = (0.05, 0.6, -0.4)


def region(system: System, side: int) -> tuple[np.ndarray, np.ndarray]:
    """Matrix and forcing (2, 2H+1) of X″ = … with contact on ``side`` (±1) or none (0), k constant."""
    (c,) = system.clearances
    matrix, forcing = np.array(system.matrix), np.array(system.forcing)
    if side != 0 or c.contact is ContactRule.ALWAYS:
        matrix[1, 1] -= c.dampings[0 if side >= 0 else 1]
    if side != 0:
        stiffness = (c.stiffness_plus if side > 0 else c.stiffness_minus)[0]
        matrix[1, 0] -= stiffness
        forcing[1, 0] += stiffness * (c.gap_plus if side > 0 else -c.gap_minus)
    return matrix, forcing


def moved(system: System, side: int, state, cycles: float, phase: float) -> np.ndarray:
    """The state after ``cycles`` (also backwards) in one region: the exponential of the linear system that
    (z, 1, cos θ, sin θ, cos 2θ, …) obeys, to 30 digits."""
    matrix, forcing = region(system, side)
    whole = np.zeros((2 + forcing.shape[1], 2 + forcing.shape[1]))
    whole[:2, :2], whole[:2, 2:] = matrix, forcing
    for n in range(1, (forcing.shape[1] - 1) // 2 + 1):
        whole[1 + 2 * n, 2 + 2 * n], whole[2 + 2 * n, 1 + 2 * n] = -n * system.omega, n * system.omega
    with mp.workdps(30):
        angles = [n * 2 * mp.pi * mp.mpf(phase) for n in range(1, (forcing.shape[1] - 1) // 2 + 1)]
        turns = [f(angle) for angle in angles for f in (mp.cos, mp.sin)]
        start = mp.matrix([*map(mp.mpf, state), mp.mpf(1), *turns])
        tau = 2 * mp.pi * mp.mpf(cycles) / mp.mpf(system.omega)
        end = mp.expm(mp.matrix(whole.tolist()) * tau) * start
        return np.array([float(end[0]), float(end[1])])


def carried_tangents(matrix: np.ndarray, tau: float) -> np.ndarray:
    """exp(matrix τ)."""
    with mp.workdps(30):
        rows = mp.expm(mp.matrix(matrix.tolist()) * mp.mpf(tau)).tolist()
        return np.array(rows, dtype=float)


def crossings(system: System, places: list[float]) -> Iterator[SimpleNamespace]:
    """One crossing each, of either boundary either way, ``places`` cells behind phase 0: put there, then
    carried backwards to the edge of the cell before and forwards by 0.3 cells."""
    props = flow.propagators(system)
    for boundary, engaging, place in product((1, -1), (True, False), places):
        edge = system.clearances[0].gap_plus if boundary > 0 else system.clearances[0].gap_minus
        speed = boundary * (1.0 if engaging else -1.0)
        there, phase = np.array([boundary * edge, speed]), place / props.cells
        start = (math.ceil(place) - 2) / props.cells
        span = (0.3 + place) / props.cells - start
        first, then = (0, boundary) if engaging else (boundary, 0)
        yield SimpleNamespace(
            props=props, phase=start, span=span, there=there, first=first, then=then, at=phase,
            start=moved(system, first, there, start - phase, phase),
            end=moved(system, then, there, start + span - phase, phase),
            contacts=(ENGAGED if engaging else RELEASED)[boundary],
        )  # fmt: skip


def _hitting(rule: ContactRule, force=HARMONIC) -> System:
    """Few, wide cells for the harmonic: what rough coefficients leave of it is some 1e-9."""
    return oscillator(
        omega=5.0, gap=(0.3, 0.7), stiffness=(2.0, 3.0), damping=0.5, rule=rule, force=force
    )  # fmt: skip


def crossing_at_the_end_of_a_cell() -> None:
    """X is beyond the boundary only by what the proof's polynomial leaves out; the motion must be right."""
    places = [k - short for k in (2, 4, 6) for short in (1e-9, 1e-8, 1e-7)] + [2.6]
    opposite = tuple(-f for f in HARMONIC)
    for rule, force in (
        (ContactRule.IN_CONTACT, HARMONIC),
        (ContactRule.IN_CONTACT, opposite),
        (ContactRule.ALWAYS, HARMONIC),
    ):
        for case in crossings(_hitting(rule, force), places):
            carried = flow.carry(case.props, case.start, case.span, case.phase)
            assert carried.status is Status.OK
            assert carried.contacts.tolist() == case.contacts
            assert np.abs(carried.state - case.end).max() < 2e-14


def tangent_over_a_crossing() -> None:
    """The quotient form of the saltation matrix, between two matrix exponentials."""
    for rule in (ContactRule.ALWAYS, ContactRule.IN_CONTACT):
        system = _hitting(rule)
        for case in crossings(system, [2.5, 4.3]):
            before, after = (region(system, side)[0] for side in (case.first, case.then))
            change = (after - before) @ [0.0, case.there[1]]  # at the edge itself no spring acts
            jump = np.eye(2) + np.outer(change, [1.0, 0.0]) / case.there[1]
            tau, rest = ((case.at - case.phase), case.phase + case.span - case.at)
            expected = carried_tangents(after, rest * system.period) @ jump
            expected = expected @ carried_tangents(before, tau * system.period)
            carried = flow.variational(case.props, case.start, case.span, case.phase)
            assert carried.jacobian is not None
            assert np.abs(carried.jacobian - expected).max() < 1e-13


def _touch(at: float, depth: float, side: int, omega: float = 3.0) -> tuple[System, np.ndarray]:
    """X touches ``side``·D at phase angle ``at``, ``depth`` beyond it (−: short of it), from inside."""
    size, turn = 0.3, np.array([np.cos(at), np.sin(at)])
    gaps = (size - depth, 0.7) if side > 0 else (0.7, size - depth)
    push = -side * size * omega**2 * turn
    system = oscillator(
        omega=omega, gap=gaps, damping=0.2, rule=ContactRule.IN_CONTACT, force=(0.0, *push),
        stiffness=(2.0, 1.0),
    )  # fmt: skip
    return system, side * size * np.array([turn[0], omega * turn[1]])


def _parting(at: float, depth: float) -> tuple[System, np.ndarray]:
    """In contact at + all the time, but for a minimum ``depth`` beyond the edge, at phase angle ``at``."""
    size, stiff, omega, turn = 0.2, 2.0, 1.7, np.array([np.cos(at), np.sin(at)])
    push = -size * (stiff - omega**2) * turn
    system = oscillator(
        omega=omega, gap=(0.5, 0.7), rule=ContactRule.IN_CONTACT, stiffness=(stiff, 1.0),
        force=(stiff * (size - depth), *push),
    )  # fmt: skip
    return system, np.array([0.5 + size - depth, 0.0]) - size * np.array([turn[0], omega * turn[1]])


def _both(system: System, start: np.ndarray, at: float) -> list:
    """Carried over a whole period, over a part of it, and traced."""
    props, part = flow.propagators(system), at / (2 * np.pi) + 0.11
    return [
        *(flow.carry(props, start, cycles) for cycles in (1.0, part)),
        flow.trace(props, start, part),
    ]


def _touches(depth: float, places: tuple[float, ...]) -> Iterator[tuple[System, np.ndarray, float]]:
    """From the gap at either boundary and from contact, on edges of cells and between them."""
    for make in (
        lambda at: _touch(at, depth, 1),
        lambda at: _touch(at, depth, -1),
        lambda at: _parting(at, depth),
    ):
        cells = flow.propagators(make(0.0)[0]).cells
        for place in places:
            at = 2 * np.pi * place / cells
            yield *make(at), at


def touch_beyond_or_short() -> None:
    """An extremum at mid-cell or on an edge: two events where it is beyond, none where it is short."""
    for depth in (1e-4, -1e-4, 1e-11, -1e-11):
        for system, start, at in _touches(depth, (2.0, 3.9)):
            for found in _both(system, start, at):
                events = found.events if isinstance(found, flow.Trace) else found.contacts.nonzero()[0]
                assert found.status is Status.OK
                assert len(events) == (2 if depth > 0 else 0)


def there_and_back_in_a_cell() -> None:
    """X goes well beyond a boundary and comes back within one cell, or from contact into the gap: the same
    as with a rest in between."""
    for depth in (3e-3, 1e-2):
        for system, start, at in _touches(depth, (3.4, 3.5, 3.6)):
            props, rest = flow.propagators(system), at / (2 * np.pi)
            found = flow.carry(props, start, 1.0)
            assert found.status is Status.OK
            assert sorted(found.contacts.tolist()) == [0, 0, 1, 1]
            half = flow.carry(props, start, rest)
            parts = flow.carry(props, half.state, 1.0 - rest, rest)
            assert np.abs(found.state - parts.state).max() < 1e-14


def touch_within_rounding() -> None:
    """An extremum on the boundary itself: rounding decides, so nothing may be claimed."""
    for system, start, at in _touches(0.0, (2.0, 3.0, 4.0, 5.0, 6.0, 2.3, 4.9)):
        for found in _both(system, start, at):
            assert found.status is Status.UNCERTAIN
            assert found.undecided > 0


def touch_within_rounding_before_a_crossing() -> None:
    """The same in a cell in which another clearance is crossed afterwards: still undecided, once told."""
    touching, start = _touch(2.3, 0.0, 1)
    crossing = oscillator(omega=3.0, gap=(0.5, 0.5), stiffness=(2.0, 1.0), rule=ContactRule.IN_CONTACT)
    system = side_by_side(touching, crossing)
    props = flow.propagators(system)
    cell = math.floor(2.3 / (2 * np.pi) * props.cells)
    moment = (cell + 0.98) / props.cells  # behind the touch, in its cell
    assert cell < 2.3 / (2 * np.pi) * props.cells < cell + 0.95
    state = np.array([*start, 0.5 - 0.3 * moment * system.period, 0.3])
    for found in (flow.carry(props, state, moment + 0.001), flow.trace(props, state, moment + 0.001)):
        assert found.status is Status.UNCERTAIN
        assert found.undecided == 1


def transient_peak() -> None:
    """The first swing of a damped oscillator, a hair beyond D or short of it: seen in a whole period too."""
    stiff, loss = 1.0, 0.1
    rate = math.sqrt(stiff - loss**2 / 4)
    angle = math.atan2(rate, loss / 2)
    peak = math.exp(-loss / 2 * angle / rate) * math.sin(angle) / rate  # of X from X = 0, X′ = 1
    for side, depth in product((1, -1), (1e-3, 1e-6, -1e-6, -1e-3)):
        gap = (peak - depth, 9.0) if side > 0 else (9.0, peak - depth)
        system = oscillator(gap=gap, ground=(stiff, loss), rule=ContactRule.IN_CONTACT, stiffness=(2.0, 2.0))
        strobes = flow.march(flow.propagators(system), [0.0, float(side)], 3)
        hit = [a + b for a, b in zip(ENGAGED[side], RELEASED[side], strict=True)]
        assert strobes.contacts[0].tolist() == (hit if depth > 0 else [0, 0, 0, 0])
        assert not strobes.contacts[1:].any()


def closed_orbit_that_parts() -> None:
    """In contact for good, with a decaying swing that leaves once, or just does not."""
    stiff, loss, load = 1.0, 0.1, 0.3
    rate = math.sqrt(stiff - loss**2 / 4)
    angle = math.atan2(rate, loss / 2)
    peak = math.exp(-loss / 2 * angle / rate) * math.sin(angle) / rate
    for side, depth in product((1, -1), (1e-4, -1e-4)):
        system = oscillator(
            gap=(0.5, 0.5), damping=loss, rule=ContactRule.IN_CONTACT, stiffness=(stiff, stiff),
            force=(side * load,),
        )  # fmt: skip
        start = side * np.array([0.5 + load / stiff, -(load / stiff + depth) / peak])
        carried = flow.carry(flow.propagators(system), start, 1.0)
        hit = [a + b for a, b in zip(ENGAGED[side], RELEASED[side], strict=True)]
        assert carried.contacts.tolist() == (hit if depth > 0 else [0, 0, 0, 0])


def grid_that_is_too_coarse() -> None:
    """However few cells are tried first, the maps are exact: the majorant asks for more."""
    module: Any = sys.modules["gearlash.flow.regions"]
    assert isinstance(module.RATE_PER_CELL, float)
    aimed, module.RATE_PER_CELL = module.RATE_PER_CELL, 12.0
    system = oscillator(omega=0.2, gap=(9.0, 9.0), ground=(0.9, 0.1), force=HARMONIC)
    props = flow.propagators(system)
    module.RATE_PER_CELL = aimed
    expected = moved(system, 0, [0.2, -0.4], 1.0, 0.0)
    assert np.abs(flow.carry(props, [0.2, -0.4], 1.0).state - expected).max() < 1e-13


def start_on_a_boundary() -> None:
    """X = ±D exactly: it goes the way it moves, and the start is no event: a crossing there, with its
    saltation, belongs to the span that ended in it."""
    system = _hitting(ContactRule.IN_CONTACT)
    props = flow.propagators(system)
    for side, speed in product((1, -1), (0.4, 1e-6, -1e-6, -0.4)):
        start = np.array([0.3 if side > 0 else -0.7, side * speed])
        span = 0.1 if abs(speed) > 0.1 else 2e-7
        carried = flow.variational(props, start, span)
        now = side if speed > 0 else 0
        tangents = carried_tangents(region(system, now)[0], span * system.period)
        assert carried.jacobian is not None
        assert np.abs(carried.jacobian - tangents).max() < 1e-14
        expected = moved(system, now, start, span, 0.0)
        assert carried.status is Status.OK
        assert not carried.contacts.any()
        assert np.abs(carried.state - expected).max() < 1e-14


def crossing_at_a_crawl() -> None:
    """So slow that speed and depth are near rounding: the crossing is told once all the same."""
    system = oscillator(gap=(0.5, 0.5), stiffness=(2.0, 1.0), rule=ContactRule.IN_CONTACT)
    props = flow.propagators(system)
    for speed, moment in product((3e-14, 6e-14, 1e-13, 3e-13), (1.1, 1.3, 1.7, 2.3)):
        start, span = np.array([0.5 - speed * moment, speed]), (moment + 1.0) / system.period
        carried = flow.carry(props, start, span)
        assert carried.contacts.tolist() == ENGAGED[1]


def no_width_at_all() -> None:
    """D⁺ = −D⁻ and equal sides: one linear system; both boundaries are crossed at one instant."""
    system = oscillator(
        omega=0.9, gap=(0.1, -0.1), stiffness=(2.0, 2.0), damping=0.2, rule=ContactRule.IN_CONTACT,
        force=(0.1, 0.5, 0.2),
    )  # fmt: skip
    expected = moved(system, 1, [0.3, -0.4], 2.0, 0.1)
    carried = flow.carry(flow.propagators(system), [0.3, -0.4], 2.0, 0.1)
    assert carried.status is Status.OK
    assert np.abs(carried.state - expected).max() < 1e-13
    assert carried.contacts[0] == carried.contacts[3] > 0 or carried.contacts[1] == carried.contacts[2] > 0


def release_where_nothing_presses() -> None:
    """Rule `no-tension`: contact ends where kδ + ζδ′ = 0, still beyond the boundary, and the field is
    continuous there."""
    damping, depth, at, rest = 0.5, 0.05, 0.05, 0.15
    for side in (1, -1):
        system = oscillator(
            omega=0.8, gap=(0.5, 0.4), stiffness=(2.0, 3.0), damping=damping, rule=ContactRule.NO_TENSION,
            force=(-0.3 * side,),
        )  # fmt: skip
        edge, stiff = (0.5, 2.0) if side > 0 else (0.4, 3.0)
        there = side * np.array([edge + depth, -stiff * depth / damping])
        start, end = moved(system, side, there, -at, at), moved(system, 0, there, rest, at)
        assert side * end[0] < edge
        carried = flow.variational(flow.propagators(system), start, at + rest)
        assert carried.status is Status.OK
        assert carried.contacts.tolist() == RELEASED[side]
        assert np.abs(carried.state - end).max() < 1e-13
        free, closed = (region(system, s)[0] for s in (0, side))
        expected = carried_tangents(free, rest * system.period) @ carried_tangents(closed, at * system.period)
        assert carried.jacobian is not None
        assert np.abs(carried.jacobian - expected).max() < 1e-13


def two_side_by_side() -> None:
    """Each of two uncoupled systems has its own crossing: at one instant, one behind the other in a
    cell, or in different cells; seen at a glance, and in pieces."""
    for rule in (ContactRule.IN_CONTACT, ContactRule.NO_TENSION):
        one = _hitting(rule)
        for gap, later in (((0.3, 0.7), 1.0), ((0.35, 0.6), 1.1), ((0.35, 0.6), 1.3)):
            two = replace(one, clearances=(replace(one.clearances[0], gap_plus=gap[0], gap_minus=gap[1]),))
            for system in (side_by_side(one, two), side_by_side(two, one)):
                _side_by_side(one, system, later)


def _side_by_side(one: System, system: System, later: float) -> None:
    props = flow.propagators(system)
    at, span = 1.8 / props.cells, 2.9 / props.cells
    start, end = np.empty(4), np.empty(4)
    for j, c in enumerate(system.clearances):
        there, moment = np.array([c.gap_plus, 1.0]), at if c.gap_plus == 0.3 else at * later
        part = replace(one, clearances=(replace(c, h=one.clearances[0].h, g=one.clearances[0].g),))
        start[2 * j : 2 * j + 2] = moved(part, 0, there, -moment, moment)
        end[2 * j : 2 * j + 2] = moved(part, 1, there, span - moment, moment)
    carried = flow.carry(props, start, span)
    assert carried.status is Status.OK
    assert carried.contacts.tolist() == ENGAGED[1] * 2
    assert np.abs(carried.state - end).max() < 2e-14


def behind_what_another_crosses() -> None:
    """Of two uncoupled systems one goes beyond a boundary and comes back in one cell. Wherever the other
    crosses in that cell, before, between or after, each moves as it does alone."""
    for one, start, at in _touches(1e-2, (3.4,)):
        other = oscillator(omega=one.omega, gap=(0.5, 0.5), stiffness=(2.0, 1.0))
        parts = [flow.propagators(system) for system in (one, other)]
        whole = flow.propagators(side_by_side(one, other)), flow.propagators(side_by_side(other, one))
        cell = math.floor(at / (2 * np.pi) * whole[0].cells)
        for place in (0.02, 0.3, 0.6, 0.9):
            moment = (cell + place) / whole[0].cells
            states = [start, np.array([0.5 - 0.3 * moment * one.period, 0.3])]
            alone = [flow.carry(props, z, 1.0) for props, z in zip(parts, states, strict=True)]
            for props, turn in zip(whole, (1, -1), strict=True):
                found = flow.carry(props, np.concatenate(states[::turn]), 1.0)
                assert found.status is Status.OK
                assert found.contacts.tolist() == [n for a in alone[::turn] for n in a.contacts.tolist()]
                assert np.abs(found.state - np.concatenate([a.state for a in alone[::turn]])).max() < 1e-13


def _alike_and_not() -> Iterator[tuple[System, np.ndarray]]:
    """Systems with one gap and states of theirs: some together, some scattered, one on a boundary, one that
    has had its way; with contacts on both sides, on one, and nearly none; one system that is torn apart."""
    rng = np.random.default_rng(7)
    for omega, gap, stiffness, damping, force, scatter in (
        (0.8, (0.3, 0.4), (2.0, 3.0), 0.03, (0.2, 1.0, -0.5), 1.5),
        (0.8, (0.3, 0.4), (2.0, 3.0), 0.03, (0.2, 1.0, -0.5), 1e-3),
        (1.3, (0.2, 0.4), (6.0, 0.0), 0.05, (0.3, 0.5, 0.2), 0.6),
        (5.0, (1.0, 1.0), (1.0, 1.0), 0.2, (0.0, 0.02, 0.0), 0.4),
        (0.9, (0.0, 0.0), (1.0, 9.0), 0.1, (0.1, 0.3, 0.0), 1.0),
    ):
        system = oscillator(omega=omega, gap=gap, stiffness=stiffness, damping=damping, force=force)
        states = scatter * rng.standard_normal((11, 2))
        states[3] = gap[0], 0.5
        states[5] = flow.march(flow.propagators(system), states[5], 4).states[-1]
        yield system, states
    torn = oscillator(omega=0.5, stiffness=(-60.0, -60.0), force=(0.1, 0.2, 0.0))
    assert not flow.march(flow.propagators(torn), [1.0, 0.0], 12).status.ok
    yield torn, rng.standard_normal((9, 2))


def eight_as_alone() -> None:
    """Motions side by side are, to the last bit, those that go alone."""
    with np.errstate(all="ignore"):  # what is torn apart overflows, here as in the kernels
        for system, states in _alike_and_not():
            props = flow.propagators(system)
            together = flow.march_many(props, states, 12)
            twice = flow.march_many(props, states[:4], 3, 2, threads=2)
            for i, state in enumerate(states):
                alone = flow.march(props, state, 12)
                assert together.states[:, i].tobytes() == alone.states.tobytes()
                assert together.contacts[:, i].tobytes() == alone.contacts.tobytes()
                assert together.undecided[i] == alone.undecided
                assert together.statuses[i] is alone.status
            for i, state in enumerate(states[:4]):
                assert twice.states[:, i].tobytes() == flow.march(props, state, 3, 2).states.tobytes()


FACTS: dict[str, Callable[[], None]] = {
    fact.__name__: fact
    for fact in (
        crossing_at_the_end_of_a_cell,
        tangent_over_a_crossing,
        touch_beyond_or_short,
        there_and_back_in_a_cell,
        touch_within_rounding,
        touch_within_rounding_before_a_crossing,
        transient_peak,
        closed_orbit_that_parts,
        grid_that_is_too_coarse,
        start_on_a_boundary,
        crossing_at_a_crawl,
        no_width_at_all,
        release_where_nothing_presses,
        two_side_by_side,
        behind_what_another_crosses,
        eight_as_alone,
    )
}

if __name__ == "__main__":
    for name in sys.argv[1:] or FACTS:
        print("asked", name, flush=True)  # what is raised from here on is the fact's
        FACTS[name]()
