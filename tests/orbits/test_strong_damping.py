"""Exponents and multipliers of systems whose rates lie far from each other, or that shrink to nothing in a
period."""

from __future__ import annotations

import sys

import mpmath as mp
import numpy as np
import pytest

import gearlash as gl
from gearlash.orbits.subspaces import by_subspaces
from gearlash.system import Status
from oracles.oscillators import oscillator, side_by_side

FAR = 1e6  # a stop that is never met
CASES = [  # damping, stiffness, ω
    (3.0, 1.0, 0.1), (3.0, 1.0, 0.01), (20.0, 1.0, 0.1), (200.0, 1.0, 0.1), (1.0, 0.1, 1e-3),
    (50.0, 2500.0, 0.1), (0.1, 1.0, 1.0), (5.0, 1.0, 3.0),
]  # fmt: skip


def _linear(damping: float, stiffness: float, omega: float) -> gl.System:
    """x″ + damping x′ + stiffness x = cos θ, its stop never met."""
    return oscillator(omega=omega, gap=(FAR, FAR), ground=(stiffness, damping), force=(0.0, 1.0, 0.0))


def _rates(*systems: gl.System) -> np.ndarray:
    return np.sort(np.concatenate([np.linalg.eigvals(s.matrix).real for s in systems]))[::-1]


@pytest.mark.parametrize("case", CASES, ids=str)
def test_averaged_exponents_of_a_linear_system(case):
    system = _linear(*case)
    found = gl.lyapunov(gl.propagators(system), [0.0, 0.0], 60)
    assert found.status is Status.OK
    assert abs(found.trace_defect) < 1e-10
    # where two rates are equal the frame goes on turning: its average comes near them like 1/time only
    near = 1e-9 if case[0] ** 2 > 4.0 * case[1] else 10.0 / (60 * system.period)
    assert np.abs(found.values - _rates(system)).max() < near
    assert (found.errors > 0.0).all()


@pytest.mark.parametrize("case", CASES, ids=str)
def test_exponents_of_the_orbit_of_a_linear_system(case):
    system = _linear(*case)
    found = gl.attractor(system, [0.5, 0.0])
    assert isinstance(found, gl.Orbit)
    assert found.exponents == pytest.approx(_rates(system), rel=1e-9)
    assert found.exponents.sum() == pytest.approx(-case[0], rel=1e-10)
    assert found.largest_exponent == pytest.approx(_rates(system)[0], rel=1e-9)


def test_fast_and_slow_side_by_side():
    systems = _linear(3.0, 1.0, 0.2), _linear(0.05, 2.0, 0.2), _linear(30.0, 20.0, 0.2)
    both = side_by_side(*systems)
    props = gl.propagators(both)
    averaged = gl.lyapunov(props, np.zeros(6), 400)
    assert averaged.status is Status.OK
    assert np.abs(averaged.values - _rates(*systems)).max() < 2e-3
    orbit = gl.attractor(props, np.zeros(6))
    assert isinstance(orbit, gl.Orbit)
    assert orbit.exponents == pytest.approx(_rates(*systems), rel=1e-8)


def test_impacts_with_strong_damping():
    """The sum of all exponents is the trace, contact damping included while it acts."""
    system = oscillator(
        omega=0.05,
        gap=(0.2, 0.3),
        stiffness=(40.0, 8.0),
        damping=6.0,
        force=(0.0, 1.0, 0.0),
        ground=(1.0, 2.0),
    )
    found = gl.attractor(system, [0.0, 0.0])
    assert isinstance(found, gl.Orbit)
    assert found.signature.impacts > 0
    averaged = gl.lyapunov(found.propagators, found.state, 40)
    assert averaged.status is Status.OK
    assert averaged.values == pytest.approx(found.exponents, rel=1e-9)
    assert found.exponents.sum() == pytest.approx(-8.0, rel=1e-10)


def test_what_the_trace_contradicts_is_not_ok(monkeypatch):
    """Orthogonal frames once in a period only, as little as the tangent flow here allows: digits are lost."""
    monkeypatch.setattr(sys.modules["gearlash.orbits.lyapunov"], "cut", lambda props, state: 1)
    found = gl.lyapunov(gl.propagators(_linear(3.0, 1.0, 0.1)), [0.0, 0.0], 60)
    assert found.status is Status.INEXACT
    assert abs(found.trace_defect) > 1.0
    assert "fewer exponents" in found.status.advice


def test_no_error_bar_is_below_rounding():
    found = gl.lyapunov(gl.propagators(_linear(0.0, 1.0, 0.7)), [1.0, 0.0], 400)
    assert (np.abs(found.values) <= found.errors).all()
    assert (found.errors > 1e-16).all()


@pytest.mark.parametrize("seed", range(6))
def test_products_in_subspaces(seed):
    """Against 400 digits, multipliers from 1e+40 to 1e-400 among them."""
    rng = np.random.default_rng(seed)
    n, count = int(rng.integers(2, 7)), 12
    factors = [rng.normal(size=(n, n)) @ np.diag(10.0 ** rng.uniform(-5.0, 1.0, n)) for _ in range(count)]
    values, logarithms = by_subspaces(factors)
    with mp.workdps(400):
        product = mp.eye(n)
        for factor in factors:
            product = mp.matrix(factor.tolist()) * product
        exact = mp.eig(product, left=False, right=False)
        sizes = sorted((float(mp.log(abs(v))) for v in exact), reverse=True)
    assert np.abs(logarithms - sizes).max() < 1e-8  # as far as the factors' conditions allow
    assert np.log(np.abs(values[0])) == pytest.approx(sizes[0], rel=1e-10)
