"""What Taylor series leave out, worked out to 60 digits, is within the bounds that proofs rest on."""

from __future__ import annotations

from dataclasses import replace

import mpmath as mp
import numpy as np
import pytest

from gearlash import flow
from gearlash.flow._tables import FREE, MINUS, ORDER, PLUS, Array
from gearlash.system import System
from oracles.oscillators import oscillator

FAST = [
    (1.0, 3),
    (5.0, 3),
    (20.0, 3),
    (50.0, 20),
]  # ω and harmonics: a cell's phase is long, its duration short


def left_out(series: Array, phase: float, width: float, order: int) -> mp.mpf:
    """|Taylor terms behind degree ORDER| about a phase, at phase + width: of a Fourier series (order 0), or
    of its derivative in local time (order 1)."""
    total = mp.mpf(0)
    for h in range(1, (len(series) + 1) // 2):
        turned = (mp.mpf(series[2 * h - 1]) - mp.j * mp.mpf(series[2 * h])) * mp.expj(h * mp.mpf(phase))
        rate = mp.j * h * mp.mpf(width)
        terms = ((j if order else 1) * rate**j / mp.factorial(j) for j in range(ORDER + 1, ORDER + 60))
        total += mp.re(turned * mp.fsum(terms))
    return abs(total)


def _tails(props: flow.Propagators, code: int) -> Array:
    """Bounds of the first clearance in a region: of X and of dX/ds, per unit of the state and constant."""
    shape = props.shape
    at = shape.slots + int(props.tables.slot_of[code]) * shape.slot + shape.tail
    return props.tables.memory[at : at + 4]


def _worst(series: Array, props: flow.Propagators, order: int) -> float:
    width = 2 * np.pi / props.cells
    with mp.workdps(60):
        return float(max(left_out(series, cell * width, width, order) for cell in range(props.cells)))


@pytest.mark.parametrize(("omega", "count"), FAST)
def test_of_the_offset(omega, count):
    """X = h·z − e: what the series of e leaves out is part of what that of X does, however short the cell."""
    base, offset = oscillator(omega=omega, gap=(0.3, 0.2), damping=0.1), np.zeros(2 * count + 1)
    offset[-2:] = 0.3, -0.2
    system = replace(base, clearances=(replace(base.clearances[0], offset=offset),))
    props = flow.propagators(system)
    for code in (FREE, PLUS):
        tails = _tails(props, code)
        assert tails[1] >= _worst(offset, props, 0) > 0.0
        assert tails[3] >= _worst(offset, props, 1) > 0.0


@pytest.mark.parametrize(("omega", "count"), FAST)
def test_of_the_stiffness(omega, count):
    """Φ holds η (X − D) under `no-tension`: what the series of η leaves out, Φ leaves out too."""
    rng = np.random.default_rng(count)
    plus, minus = (np.r_[1.0, rng.normal(0.0, 0.05, 2 * count)] for _ in range(2))
    props = flow.propagators(oscillator(omega=omega, stiffness=(plus, minus), damping=0.1))
    bounds = props.tables.memory[props.shape.lost : props.shape.lost + 2]
    for bound, series in zip(bounds, (plus, minus), strict=True):
        assert 30.0 * _worst(series, props, 0) > bound >= _worst(series, props, 0) > 0.0


def _constant(system: System, side: int) -> mp.matrix:
    stiffness = {PLUS: system.clearances[0].stiffness_plus[0], FREE: 0.0, MINUS: 0.0}[side]
    damping = system.clearances[0].damping
    return mp.matrix([[0, 1], [system.matrix[1, 0] - stiffness, system.matrix[1, 1] - damping]])


@pytest.mark.parametrize("omega", [0.05, 0.9, 7.0])
@pytest.mark.parametrize("stiffness", [1.0, 2000.0])
def test_of_the_state(omega, stiffness):
    """Constant coefficients: Σ_{j > ORDER} (M h)^j/j! is known, entry by entry."""
    system = oscillator(
        omega=omega, stiffness=(stiffness, stiffness), damping=0.3, force=(0.1, 0.2, 0.1), ground=(0.5, 0.1)
    )
    props = flow.propagators(system)
    for code in (FREE, PLUS):
        value, derived = _tails(props, code)[[0, 2]]
        with mp.workdps(60):
            step = _constant(system, code) * mp.mpf(props.cell_duration)
            term, rest, slope = mp.eye(2), mp.zeros(2), mp.zeros(2)
            for j in range(1, ORDER + 60):
                term = term * step / j
                if j > ORDER:
                    rest, slope = rest + term, slope + j * term
            assert value >= max(abs(rest[0, k]) for k in range(2)) > 0.0
            assert derived >= max(abs(slope[0, k]) for k in range(2)) > 0.0
            assert value < 2e-15
