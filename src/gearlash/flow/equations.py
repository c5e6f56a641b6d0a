"""The equations of a system and of its regions, as kernels read them."""

from __future__ import annotations

from math import exp, factorial, hypot, pi

import numpy as np

from gearlash.system import Clearance, System, derivative
from gearlash.system.harmonics import harmonics

from ._surfaces import NO_STOP
from ._tables import ORDER, Array, Shape

LEFT_OUT = factorial(ORDER + 1)


def left_out(series: Array, width: float) -> tuple[float, float]:
    """Bounds on what the Taylor series of a Fourier series over a phase ``width`` leaves out behind degree
    ORDER, and on its derivative in local time: Σ_{j>m} r^j/j! ≤ e^r r^(m+1)/(m+1)! for a harmonic that turns
    by r."""
    value, numbers = 0.0, series.tolist()
    for n in range(1, harmonics(series) + 1):
        size = hypot(numbers[2 * n - 1], numbers[2 * n])
        if size != 0.0:
            turn = n * width
            value += size * exp(turn) * turn ** (ORDER + 1) / LEFT_OUT
    return value, (ORDER + 1) * value


def write_system(system: System, shape: Shape, memory: Array) -> None:
    """What is the same in all regions: scalars, gaps, how gaps are read, stiffness. The memory is empty, or
    was written to for a system with as many harmonics."""
    rate, width = system.omega / system.cycles, 2 * shape.harmonics + 1
    turn = 2 * pi / shape.cells
    memory[shape.scalars : shape.scalars + 3] = rate, system.period / shape.cells, turn
    for c, clearance in enumerate(system.clearances):
        plus = clearance.gap_plus if clearance.stops(1) else NO_STOP
        minus = clearance.gap_minus if clearance.stops(-1) else NO_STOP
        at = shape.gaps + 4 * c
        memory[at : at + 4] = plus, minus, *clearance.dampings
        stops = [abs(gap) for gap in (plus, minus) if gap < NO_STOP]
        memory[shape.reach + c] = sum(stops) + float(np.abs(clearance.offset).sum())
        at = shape.reads + c * shape.p + 1
        memory[at : at + shape.n] = clearance.h
        at = shape.speed + c * shape.p + 1
        memory[at : at + shape.n] = clearance.h @ system.matrix
        _write_drift(system, clearance, memory[shape.drift + c * width : shape.drift + (c + 1) * width])
        for place, series in (
            (shape.offset + c * width, clearance.offset),
            (shape.stiffness + 2 * c * width, clearance.stiffness_plus),
            (shape.stiffness + (2 * c + 1) * width, clearance.stiffness_minus),
        ):
            memory[place : place + len(series)] = series
        for side, series in enumerate((clearance.stiffness_plus, clearance.stiffness_minus)):
            memory[shape.lost + 2 * c + side] = left_out(series, turn)[0]


def _write_drift(system: System, clearance: Clearance, drift: Array) -> None:
    """h·b - e'."""
    own = clearance.h @ system.forcing
    drift[: len(own)], drift[len(own) :] = own, 0.0
    if len(clearance.offset) > 1:
        slope = system.omega / system.cycles * derivative(clearance.offset)
        drift[: len(slope)] -= slope


def write_region(system: System, shape: Shape, memory: Array, at: int, matrix: Array) -> None:
    """The equations of one region, for expansions of the state."""
    columns = memory[at + shape.matrix : at + shape.matrix + (shape.n + shape.clearances) * shape.p]
    columns = columns.reshape(shape.n + shape.clearances, shape.p)
    columns[: shape.n, 1 : 1 + shape.n] = matrix.T
    for c, clearance in enumerate(system.clearances):
        columns[shape.n + c, 1 : 1 + shape.n] = clearance.g
