"""Exact symmetries of the class of systems: two different computations, one motion.

No oracle is needed here, so these run everywhere.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearlash import flow
from gearlash.system import Clearance, GearlashError, System
from oracles.members import in_other_coordinates
from oracles.oscillators import oscillator
from oracles.pairs import (
    KINDS,
    Bodies,
    Mesh,
    gap_coordinates,
    helical,
    helical_bodies,
    random_bodies,
    random_mesh,
    random_state,
    random_system,
    spur,
)

CLOSE = 1e-12


def _run(system, state, cycles=2.0, phase=0.0):
    """Trace and derivative of one motion."""
    props = flow.propagators(system)
    trace = flow.trace(props, state, cycles, phase)
    carried = flow.variational(props, state, cycles, phase)
    assert np.abs(carried.state - trace.end).max() < CLOSE * max(1.0, np.abs(trace.end).max())
    assert carried.jacobian is not None
    return trace, carried.jacobian


def _same_events(one, other, boundary=1, shift=0.0):
    assert len(one) == len(other) > 0
    assert (one.boundary == boundary * other.boundary).all()
    assert (one.engaging == other.engaging).all()
    assert np.abs(one.phase - other.phase - shift).max() < 1e-11


@pytest.mark.parametrize("widening", [0.37, 5.0])
def test_one_boundary_knows_no_backlash(widening):
    """A motion that meets Σ1 only: X − D and the derivative do not depend on D."""
    start = np.zeros(10)
    start[8:] = 1.2, -0.4
    mesh, moved = Mesh(), Mesh(gap_plus=1.0 + widening, gap_minus=1.0 + widening)
    shift = np.zeros(10)
    shift[8] = widening
    one, derivative = _run(helical(mesh, Bodies()), start)
    other, derivative_moved = _run(helical(moved, Bodies()), start + shift)
    assert (one.events.boundary == 1).all()
    _same_events(one.events, other.events)
    assert np.abs(other.end - shift - one.end).max() < CLOSE
    assert np.abs(derivative - derivative_moved).max() < CLOSE


@pytest.mark.parametrize("factor", [1e-3, 0.3, 40.0])
@pytest.mark.parametrize("kind", ["plain", "unequal", "large-ripple"])
def test_scaling(kind, factor):
    """(f_m, E, D) → s (f_m, E, D) scales the motion by s and leaves times and derivative."""
    rng = np.random.default_rng([1, KINDS.index(kind)])
    mesh, bodies = random_mesh(rng, kind), random_bodies(rng)
    start = random_state(rng, helical(mesh, bodies))
    scaled = replace(
        mesh,
        load=factor * mesh.load,
        error=tuple(factor * e for e in mesh.error),
        gap_plus=factor * mesh.gap_plus,
        gap_minus=factor * mesh.gap_minus,
    )
    one, derivative = _run(helical(mesh, bodies), start)
    other, derivative_scaled = _run(helical(scaled, bodies), factor * start)
    _same_events(one.events, other.events)
    assert np.abs(other.end / factor - one.end).max() < CLOSE
    assert np.abs(derivative - derivative_scaled).max() < CLOSE * max(1.0, np.abs(derivative).max())


@pytest.mark.parametrize("pair", ["spur", "helical"])
def test_signs_of_odd_harmonics_are_half_a_period(pair):
    """(ε, E) → (−ε, −E) on odd harmonics is a shift of the phase by one half."""
    rng = np.random.default_rng(2)
    mesh = replace(
        Mesh(gap_plus=0.2, gap_minus=0.3),
        ripple=(0.3, 0.0, 0.1),
        ripple_phase=(0.4, 0.0, 1.0),
        error=(0.3, 0.0, 0.02),
        error_phase=(0.1, 0.0, 2.0),
    )
    opposite = replace(mesh, ripple=(-0.3, 0.0, -0.1), error=(-0.3, 0.0, -0.02))

    def build(m):
        return spur(m) if pair == "spur" else helical(m, Bodies())

    start = random_state(rng, build(mesh))
    one, derivative = _run(build(mesh), start, phase=0.2)
    other, derivative_other = _run(build(opposite), start, phase=0.7)
    _same_events(one.events, other.events, shift=-0.5)
    assert np.abs(one.end - other.end).max() < CLOSE
    assert np.abs(derivative - derivative_other).max() < CLOSE * np.abs(derivative).max()


def _mirrored(system: System) -> System:
    """X → −X: forcing and offset negated, the sides exchanged."""
    (c,) = system.clearances
    sides = Clearance(
        h=c.h,
        g=c.g,
        gap_plus=c.gap_minus,
        gap_minus=c.gap_plus,
        stiffness_plus=c.stiffness_minus,
        stiffness_minus=c.stiffness_plus,
        damping=c.damping,
        offset=-c.offset,
    )
    return replace(system, forcing=-system.forcing, clearances=(sides,))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("pair", ["spur", "helical"])
def test_mirror(pair, kind):
    """X → −X with f_m and E negated; with unequal sides these are exchanged."""
    rng = np.random.default_rng([3, KINDS.index(kind)])
    system, start = random_system(rng, pair, kind)
    cycles = 0.5 if kind == "slow" else 2.0
    one, derivative = _run(system, start, cycles, 0.1)
    other, derivative_other = _run(_mirrored(system), -start, cycles, 0.1)
    assert (one.events.boundary == -other.events.boundary).all()
    assert (one.events.engaging == other.events.engaging).all()
    assert np.abs(one.events.phase - other.events.phase).max(initial=0.0) < 1e-11
    assert np.abs(one.end + other.end).max() < CLOSE * max(1.0, np.abs(one.end).max())
    assert np.abs(derivative - derivative_other).max() < CLOSE * max(1.0, np.abs(derivative).max())


def test_symmetric_system_commutes_with_its_symmetry():
    """f_m = 0, ε = 0, E half-period antisymmetric: (X, θ) → (−X, θ + π) carries motions into motions."""
    mesh = Mesh(load=0.0, ripple=(), ripple_phase=(), error=(0.5, 0.0, 0.05), error_phase=(0.3, 0.0, 1.0))
    system = helical(replace(mesh, gap_plus=0.2, gap_minus=0.2), Bodies())
    start = random_state(np.random.default_rng(4), system)
    one, derivative = _run(system, start, 2.0, 0.15)
    other, derivative_other = _run(system, -start, 2.0, 0.65)
    _same_events(one.events, other.events, boundary=-1, shift=-0.5)
    assert np.abs(one.end + other.end).max() < CLOSE
    assert np.abs(derivative - derivative_other).max() < CLOSE * np.abs(derivative).max()


def test_any_of_these_breaks_the_symmetry():
    """The statement has a converse: load, ripple, an even harmonic of E or unequal gaps each break it."""
    mesh = Mesh(load=0.0, ripple=(), ripple_phase=(), error=(0.5,), gap_plus=0.2, gap_minus=0.2)
    start = random_state(np.random.default_rng(4), helical(mesh, Bodies()))
    for change in (
        {"load": 0.05},
        {"ripple": (0.1,), "ripple_phase": (0.0,)},
        {"error": (0.5, 0.1), "error_phase": (0.0, 0.0)},
        {"gap_minus": 0.1},
    ):
        system = helical(replace(mesh, **change), Bodies())
        one, _ = _run(system, start, 2.0, 0.15)
        other, _ = _run(system, -start, 2.0, 0.65)
        assert np.abs(one.end + other.end).max() > 1e-6


@pytest.mark.parametrize("kind", KINDS)
def test_two_sets_of_coordinates(kind):
    """Bodies with the error as an offset of the gap, against (…, X, X′) with −E″ as a force."""
    rng = np.random.default_rng([5, KINDS.index(kind)])
    mesh, bodies = random_mesh(rng, kind), random_bodies(rng)
    system, free = helical(mesh, bodies), helical_bodies(mesh, bodies)
    start, phase, cycles = random_state(rng, system), 0.3, 0.5 if kind == "slow" else 1.5
    transform = gap_coordinates(bodies)

    def from_gap(state, at):
        raised = np.array(state)
        raised[8:] += _error(mesh, at)
        return np.linalg.solve(transform, raised)

    one, derivative = _run(system, start, cycles, phase)
    other, derivative_free = _run(free, from_gap(start, phase), cycles, phase)
    assert (one.events.boundary == other.events.boundary).all()
    assert np.abs(one.events.phase - other.events.phase).max(initial=0.0) < 1e-10
    assert np.abs(from_gap(one.end, phase + cycles) - other.end).max() < CLOSE * max(
        1.0, np.abs(other.end).max()
    )
    back = transform @ derivative_free @ np.linalg.inv(transform)
    assert np.abs(derivative - back).max() < CLOSE * max(1.0, np.abs(derivative).max())


@pytest.mark.parametrize("angle", [1e-12, 1e-6, 1e-3, 0.1, 0.7])
def test_turned_coordinates(angle: float):
    """By however little: what is zero but for rounding is no coupling; what is not is refused."""
    system = oscillator(omega=0.8, gap=(0.2, 0.3), stiffness=(3.0, 2.0), damping=0.05, force=(0.2, 1.0, 0.3))
    turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    start = np.array([0.1, 0.5])
    expected = flow.carry(flow.propagators(system), start, 2.0).state @ turn.T
    found = flow.carry(flow.propagators(in_other_coordinates(system, turn)), turn @ start, 2.0).state
    assert np.abs(found - expected).max() < 1e-13
    (clearance,) = system.clearances
    with pytest.raises(GearlashError, match="is not zero"):
        replace(system, clearances=(replace(clearance, g=clearance.g + np.array([1e-13, 0.0])),))


def _error(mesh: Mesh, phase: float) -> np.ndarray:
    """(E, E′) at a phase."""
    order = np.arange(1, len(mesh.error) + 1)
    angle = order * 2 * np.pi * phase + np.array(mesh.error_phase)
    amplitude = np.array(mesh.error)
    return np.array([amplitude @ np.cos(angle), -mesh.omega * (order * amplitude) @ np.sin(angle)])


@pytest.mark.parametrize("cycles", [2, 3])
def test_longer_base_period(cycles):
    """The same forcing written over several mesh cycles is the same motion."""
    rng = np.random.default_rng(6)
    system, start = random_system(rng, "helical", "unequal")
    (c,) = system.clearances

    def spread(series):
        series = np.atleast_2d(series)
        count = (series.shape[1] - 1) // 2
        out = np.zeros((len(series), 2 * count * cycles + 1))
        out[:, 0] = series[:, 0]
        out[:, 2 * cycles - 1 :: 2 * cycles] = series[:, 1::2]
        out[:, 2 * cycles :: 2 * cycles] = series[:, 2::2]
        return out

    sides = replace(
        c, stiffness_plus=spread(c.stiffness_plus)[0], stiffness_minus=spread(c.stiffness_minus)[0]
    )
    longer = System(system.omega, system.matrix, spread(system.forcing), (sides,), cycles)
    one, derivative = _run(system, start, 2.5, 0.4)
    other, derivative_longer = _run(longer, start, 2.5, 0.4)
    _same_events(one.events, other.events)
    assert np.abs(one.end - other.end).max() < CLOSE
    assert np.abs(derivative - derivative_longer).max() < CLOSE * max(1.0, np.abs(derivative).max())


@pytest.mark.parametrize("kind", KINDS)
def test_parts_make_the_whole(kind):
    """Carrying over a, then b, is carrying over a + b, wherever the cut lies; derivatives multiply."""
    rng = np.random.default_rng([7, KINDS.index(kind)])
    system, start = random_system(rng, "helical", kind)
    whole, derivative = _run(system, start, 1.0, 0.3)
    for cut in (0.2, 0.5, float(rng.uniform(0.05, 0.95))):
        first, early = _run(system, start, cut, 0.3)
        second, late = _run(system, first.end, 1.0 - cut, 0.3 + cut)
        assert len(first.events) + len(second.events) == len(whole.events)
        assert len(first.extrema) + len(second.extrema) == len(whole.extrema)
        assert np.abs(second.end - whole.end).max() < CLOSE * max(1.0, np.abs(whole.end).max())
        assert np.abs(late @ early - derivative).max() < CLOSE * max(1.0, np.abs(derivative).max())


def test_phase_counts_modulo_the_base_period():
    """A start a million cycles later is the same motion, and its phases are absolute."""
    start = np.zeros(10)
    start[8] = 1.2
    one, _ = _run(helical(Mesh(), Bodies()), start, 2.0, 0.25)
    other, _ = _run(helical(Mesh(), Bodies()), start, 2.0, 1_000_000.25)
    assert (one.end == other.end).all()
    assert np.abs(other.events.phase - one.events.phase - 1e6).max() < 1e-9
    assert np.abs(other.samples(5).state - one.samples(5).state).max() < 1e-8
