"""Extrema that touch a boundary, and those that are kept from crossing it.

Within a window around it a boundary is not treated as crossed (`Hold`). What is left is the one-sided system,
in which the orbit and its multipliers depend smoothly on everything, through the touch."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gearlash import flow
from gearlash.flow import Hold, Propagators, Trace
from gearlash.flow.events import gap_displacement, gap_velocity
from gearlash.orbits.contact_force import force_series
from gearlash.orbits.grazing import force_gradient
from gearlash.system import CARRIED, GearlashError, System

from .plane import Array

FORCE_STEP = 1e-5  # mesh cycles: for the rate of the gradient of a force


@dataclass(frozen=True)
class Window:
    """Of one extremum beside a boundary, as wide on both sides of it, in mesh cycles; none where that is
    zero."""

    clearance: int
    surface: str
    boundary: int
    width: float

    def hold(self, phase: float) -> Hold:
        return Hold(self.boundary, phase - self.width, phase + self.width, self.clearance)

    @property
    def open(self) -> bool:
        return self.width > 0.0


@dataclass(frozen=True, eq=False)
class Leg:
    """A piece of the orbit between two phases, on which one boundary is held at most."""

    begin: float
    end: float
    hold: Hold | None


def legs(begin: float, cycles: float, windows: list[tuple[float, Window]]) -> list[Leg]:
    """The orbit cut between the windows, in order. Raises `GearlashError` where two of them are one."""
    ordered = sorted(windows, key=lambda pair: pair[0])
    ends = [0.5 * (a + va.width + b - vb.width) for (a, va), (b, vb) in pairwise(ordered)]
    places = [begin, *ends, begin + cycles]
    if any(two - one <= 0.0 for one, two in pairwise(places)):
        raise GearlashError("two touches at one phase cannot be told apart")
    if not ordered:
        return [Leg(begin, begin + cycles, None)]
    holds = [window.hold(phase) if window.open else None for phase, window in ordered]
    return [Leg(*each) for each in zip(places[:-1], places[1:], holds, strict=True)]


def carried(props: Propagators, state: Array, leg: Leg, stop: float | None = None) -> tuple[Array, Array]:
    """State (n,) and Jacobian (n, n) at the end of a leg, or at a phase on it. Raises `GearlashError` where
    the motion cannot be carried."""
    end = leg.end if stop is None else stop
    found = flow.carry(props, state, end - leg.begin, leg.begin, jacobian=True, hold=leg.hold)
    if found.status not in CARRIED or found.jacobian is None or not np.isfinite(found.jacobian).all():
        raise GearlashError("the motion could not be carried")
    return found.state, found.jacobian


def traced(props: Propagators, state: Array, leg: Leg, stop: float | None = None) -> Trace:
    """The same as polynomials."""
    end = leg.end if stop is None else stop
    return flow.trace(props, state, end - leg.begin, leg.begin, hold=leg.hold)


def surface_values(
    props: Propagators, window: Window, state: Array, phase: float, trace: Trace | None
) -> Array:
    """(H, H') at a phase: X ∓ D and X'; of the surface "force", Φ and Φ' from a trace that ends there."""
    if window.surface == "force":
        assert trace is not None
        return derivatives(trace, window)[:2]
    return gap_values(props.system, window, state, phase)


def gap_values(system: System, window: Window, state: Array, phase: float) -> Array:
    """(X ∓ D, X') at a phase."""
    j, at = window.clearance, [phase]
    c = system.clearances[j]
    edge = c.gap_plus if window.boundary > 0 else -c.gap_minus
    x = gap_displacement(system, at, state[None], j)[0]
    return np.array([x - edge, gap_velocity(system, at, state[None], j)[0]])


def surface_rows(
    props: Propagators, window: Window, state: Array, leg: Leg, phase: float, flow_to: Array
) -> Array:
    """∂(H, H')/∂z (2, n), z at the beginning of a leg; ``flow_to`` (n, n): the Jacobian from there."""
    if window.surface == "gap":
        c = props.system.clearances[window.clearance]
        return np.stack([c.h, c.h @ props.system.matrix]) @ flow_to
    step = FORCE_STEP * 2.0 * np.pi / props.system.omega
    low, here, high = (
        force_gradient(props.system, window.clearance, phase + d, window.boundary)
        @ carried(props, state, leg, phase + d)[1]
        for d in (-FORCE_STEP, 0.0, FORCE_STEP)
    )
    return np.stack([here, (high - low) / (2.0 * step)])


def derivatives(trace: Trace, window: Window) -> Array:
    """(H, H', H″, H‴) in τ at the end of a trace, from its last piece; of a force H‴ is not told."""
    last = len(trace.positions) - 1
    if window.surface == "force":
        at, side = np.array([last]), np.array([window.boundary])
        force = np.concatenate(force_series(trace, window.clearance, at, np.ones(1), side))
        return np.append(force, np.nan)
    c = trace.propagators.system.clearances[window.clearance]
    edge = c.gap_plus if window.boundary > 0 else -c.gap_minus
    terms = trace.gap_of(window.clearance)[last]
    duration = float(trace.lengths[last]) * trace.propagators.cell_duration
    series, power = [], np.arange(len(terms))
    for order in range(4):
        series.append(float(terms.sum()) / duration**order)
        terms = (terms * power)[1:]
        power = power[:-1]
    series[0] -= edge
    return np.array(series)
