"""A motion as exact pieces: read at any phase, with its extrema."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from gearlash.system import GearlashError, Record, Status, given

from . import _march
from ._tables import FREE, MINUS, ORDER, TERMS, Array
from .events import Events, contact_force, gap_displacement, gap_velocity
from .propagators import Propagators

COEFFICIENTS_AT_ONCE = 400_000  # coefficients of polynomials that are gathered at once: 3 MB
PHASE_SLACK = 1e-9  # mesh cycles beyond its ends at which a trace is still read
MOST_SAMPLES = 10_000_000


@dataclass(frozen=True, eq=False, repr=False)
class Extrema(Record):
    """Extrema of the gap of one clearance: simple zeros of X'.

    Attributes
    ----------
    phase : array (m,)
        In mesh cycles.
    displacement : array (m,)
        X.
    curvature : array (m,)
        X'', d²X/dτ².
    state : array (m, n)
        The state there.
    region : array (m,) of int
        0: contact on side +, 1: none, 2: contact on side -.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> extrema = gl.trace(family.system({"omega": 0.9}), [1.1, -0.5], 1.0).extrema
    >>> print(extrema.phase.round(4), extrema.displacement.round(4))
    [0.485] [0.283]
    """

    phase: Array
    displacement: Array
    curvature: Array
    state: Array
    region: Array

    def __len__(self) -> int:
        return len(self.phase)


@dataclass(frozen=True, eq=False, repr=False)
class Samples(Record):
    """A motion at chosen phases: its states, and what one clearance does.

    Attributes
    ----------
    phase : array (m,)
        In mesh cycles.
    state : array (m, n)
        The state there.
    displacement : array (m,)
        X, the gap.
    velocity : array (m,)
        X', its velocity.
    force : array (m,)
        Φ, the contact force.
    region : array (m,) of int
        0: contact on side +, 1: none, 2: contact on side -.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> samples = gl.trace(family.system({"omega": 0.9}), [1.1, -0.5], 1.0).samples(5)
    >>> print(samples.displacement.round(3), samples.region)
    [1.1   0.455 0.284 0.417 0.717] [0 1 1 1 1]
    """

    phase: Array
    state: Array
    displacement: Array
    velocity: Array
    force: Array
    region: Array


@dataclass(frozen=True, eq=False, repr=False)
class Trace(Record):
    """A motion as polynomials, with its contact events.

    Piece i is a polynomial in a local time of its own, which runs from 0 to 1. What is said of "the gap" is
    of the first clearance, unless another one is named.

    Attributes
    ----------
    propagators : Propagators
        Of the system.
    base : float
        Phase, in mesh cycles, from which positions are counted.
    phase : float
        Where the motion begins, in mesh cycles.
    cycles : float
        How far it was asked for, in mesh cycles.
    positions : array (pieces,)
        Where pieces begin, in cells from ``base`` on.
    lengths : array (pieces,)
        How long they are, in cells.
    modes : array (pieces, clearances) of int
        0: contact on side +, 1: none, 2: contact on side -. With the rule `no-tension` also 3 and 4: beyond
        the boundary on side + or -, but the force is zero.
    polynomials : array (pieces, degree + 1, n)
        Coefficients of the state, by rising powers of local time.
    events : Events
        Every contact that begins or ends.
    end : array (n,)
        The state at the end.
    undecided : int
        Places where it could not be decided within rounding whether a boundary is touched.
    status : Status
        Whether the motion was carried to its end.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> trace = gl.trace(family.system({"omega": 0.9}), [1.1, -0.5], 1.0)
    >>> trace.status.ok, len(trace.events)
    (True, 1)
    >>> print(trace.at([0.0, 0.5, 1.0]).displacement.round(4))
    [1.1    0.2835 0.717 ]
    """

    _printed: ClassVar = ("status", "phase", "cycles", "undecided")

    propagators: Propagators
    base: float
    phase: float
    cycles: float
    positions: Array
    lengths: Array
    modes: Array
    polynomials: Array
    events: Events
    end: Array
    undecided: int
    status: Status

    @property
    def regions(self) -> Array:
        """The side in contact of the first clearance, per piece (pieces,): 0 side +, 1 none, 2 side -."""
        return self.regions_of(0)

    def regions_of(self, clearance: int) -> Array:
        """Tell the side in contact of a clearance.

        Parameters
        ----------
        clearance : int
            Its number, from 0.

        Returns
        -------
        array (pieces,) of int
            Per piece: 0 side +, 1 none, 2 side -.
        """
        modes = self.modes[:, self.which(clearance)]
        return np.where(modes > MINUS, FREE, modes)

    @property
    def free(self) -> Array:
        """Whether pieces (pieces,) run without contact in the first clearance.

        They are in its gap, or where there is nothing to hit."""
        return self.regions == FREE

    @cached_property
    def gap(self) -> Array:
        """Taylor coefficients of X per piece (pieces, degree+1), in local time."""
        return self.gap_of(0)

    def gap_of(self, clearance: int) -> Array:
        """Give the gap of a clearance as polynomials.

        Parameters
        ----------
        clearance : int
            Its number, from 0.

        Returns
        -------
        array (pieces, degree + 1)
            Taylor coefficients of X in local time, per piece.
        """
        chosen = self.propagators.system.clearances[self.which(clearance)]
        out = self.polynomials @ chosen.h
        return out - _local_series(self.propagators, chosen.offset, self.positions, self.lengths)

    @cached_property
    def extrema(self) -> Extrema:
        """Every place where X' vanishes with a sign change."""
        return self.extrema_of(0)

    def extrema_of(self, clearance: int) -> Extrema:
        """Find every place where X' of a clearance vanishes with a sign change.

        Parameters
        ----------
        clearance : int
            Its number, from 0.

        Returns
        -------
        Extrema
            In order.
        """
        props = self.propagators
        found = np.empty((64 + 8 * len(self.positions), 4))
        regions = self.regions_of(clearance)
        pieces = np.column_stack([self.positions, self.lengths, regions.astype(float)])
        gap = np.zeros((len(pieces), TERMS))
        gap[:, : ORDER + 1] = self.gap if clearance == 0 else self.gap_of(clearance)
        table = props.shape.bernstein + (ORDER + 1) * TERMS
        count = _march.extrema(pieces, gap.reshape(-1), props.tables.memory, table, found)
        found = found[:count]
        index = found[:, 3].astype(int)
        local = (found[:, 0] - self.positions[index]) / self.lengths[index]
        duration = self.lengths[index] * props.cell_duration
        state = _values(self.polynomials, index, local)
        phase = self.base + found[:, 0] / props.cells_per_cycle
        return Extrema(phase, found[:, 1], found[:, 2] / duration**2, state, regions[index])

    def at(self, phase: ArrayLike, clearance: int = 0) -> Samples:
        """Evaluate the motion at some phases.

        Parameters
        ----------
        phase : float, or array_like (m,)
            In mesh cycles, within the trace.
        clearance : int, default 0
            Whose gap, velocity and force.

        Returns
        -------
        Samples
            The motion there.

        Raises
        ------
        GearlashError
            For a phase outside the trace: its polynomials say nothing there.
        """
        system = self.propagators.system
        phase, clearance = given.row("phase", phase), self.which(clearance)
        last = self.phase + self.cycles
        if phase.size and not (phase.min() >= self.phase - PHASE_SLACK and phase.max() <= last + PHASE_SLACK):
            span = f"{self.phase:g} to {last:g}"
            raise GearlashError(f"phases {phase.min():g} to {phase.max():g}: the trace goes from {span}")
        cell = (phase - self.base) * self.propagators.cells_per_cycle
        index = np.clip(np.searchsorted(self.positions, cell, side="right") - 1, 0, len(self.positions) - 1)
        local = (cell - self.positions[index]) / self.lengths[index]
        state, region = _values(self.polynomials, index, local), self.regions_of(clearance)[index]
        x = gap_displacement(system, phase, state, clearance)
        velocity = gap_velocity(system, phase, state, clearance)
        force = contact_force(system, phase, x, velocity, region, clearance)
        return Samples(phase, state, x, velocity, force, region)

    def samples(self, points: int) -> Samples:
        """Evaluate the motion at equally spaced phases, both ends included.

        Parameters
        ----------
        points : int
            How many, 1 to 10,000,000.

        Returns
        -------
        Samples
            The motion there.
        """
        points = given.whole("points", points, 1, MOST_SAMPLES)
        return self.at(self.phase + np.linspace(0.0, self.cycles, points))

    def which(self, clearance: int) -> int:
        """Check the number of a clearance.

        Parameters
        ----------
        clearance : int
            Its number, from 0.

        Returns
        -------
        int
            The same.

        Raises
        ------
        GearlashError
            Where the system has no such clearance.
        """
        return given.whole("clearance", clearance, 0, len(self.propagators.system.clearances) - 1)


def _values(polynomials: Array, index: Array, local: Array) -> Array:
    """Polynomials (pieces, degree+1, n), those of ``index`` (m,), at local times (m,) → (m, n)."""
    terms, n = polynomials.shape[1:]
    found, block = np.empty((len(index), n)), max(1, COEFFICIENTS_AT_ONCE // (terms * n))
    for first in range(0, len(index), block):
        rows = slice(first, first + block)
        powers = local[rows, None] ** np.arange(terms)
        found[rows] = np.einsum("mj,mjn->mn", powers, polynomials[index[rows]])
    return found


def _local_series(props: Propagators, series: Array, positions: Array, lengths: Array) -> Array:
    """Taylor coefficients (pieces, ORDER+1) of a Fourier series over each piece, in its local time."""
    width = 2.0 * np.pi / props.cells
    out = np.zeros((len(positions), ORDER + 1))
    out[:, 0] = series[0]
    for n in range(1, (len(series) + 1) // 2):
        rotor = (series[2 * n - 1] - 1j * series[2 * n]) * np.exp(1j * n * width * positions)
        term = rotor
        for j in range(ORDER + 1):
            out[:, j] += term.real
            term = term * (1j * n * width * lengths) / (j + 1)
    return out
