"""The arrays from which forces between teeth are computed: geometry, compliance over the mesh phase, errors
and modifications, modes."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, cos, floor, log, pi
from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from gearlash.gears.materials import Material

from . import _tables as places
from ._tables import ContactTables
from .flanks import Flanks
from .topography import Topography

Reals = NDArray[np.float64]

RELIEF_POINTS = 400


class Compliance(Protocol):
    """What is asked of the compliance of one gear, as `gearlash.multibody.compliance` makes it.

    The displacements are of the flank that faces counter-clockwise, seen from +z, of a gear with its own hand
    of helix; tooth k + 1 is the next one counter-clockwise.
    """

    @property
    def roll(self) -> Reals:
        """Roll lengths of the grid, rising, m."""
        ...

    @property
    def axial(self) -> Reals:
        """z of the grid, rising, m."""
        ...

    @property
    def influence(self) -> Reals:
        """Shape (2M + 1, nr nz, nr nz), m/N: normal displacement on tooth k + m, for a force on tooth k."""
        ...

    @property
    def depth(self) -> float:
        """h, m: what lies less deep is not in the displacements."""
        ...


@dataclass(frozen=True)
class RimModes:
    """How the modes of a body move the flanks.

    Parameters
    ----------
    body : ndarray of int, shape (M,)
        0 pinion, 1 gear.
    order : ndarray of int, shape (M,)
        n, waves around the circumference of a mode that rotates with its body; 0 also for a mode of one wave
        whose coordinate stands still: then a is the displacement where the teeth touch.
    shape : ndarray, shape (2, M, S, 2)
        Displacement outward and normal to the flanks of side 0 and 1, for a modal coordinate of 1, at the
        slices: a cos nψ + b sin nψ, with ψ the angle of the place on the body, counted from the line of
        centres at rest for the pinion, from there by π for the gear. The slices of side 1 are those of the
        pair turned over: slice k lies at −z.

    Examples
    --------
    >>> from gearlash.multibody.contact import RimModes
    >>> RimModes.none(21).shape.shape
    (2, 0, 21, 2)
    """

    body: NDArray[np.int64]
    order: NDArray[np.int64]
    shape: Reals

    @classmethod
    def none(cls, slices: int) -> RimModes:
        """Rigid bodies."""
        empty = np.zeros(0, np.int64)
        return cls(empty, empty, np.zeros((2, 0, slices, 2)))

    def and_(self, others: RimModes) -> RimModes:
        """These modes and others behind them, at the same slices."""
        return RimModes(
            np.concatenate([self.body, others.body]),
            np.concatenate([self.order, others.order]),
            np.concatenate([self.shape, others.shape], axis=1),
        )


def contact_tables(
    flanks: Flanks,
    compliance: tuple[Compliance, Compliance],
    materials: tuple[Material, Material],
    slices: int,
    damping_time: float,
    topography: Topography,
    modes: RimModes | None,
    phases: int,
    reach: float,
) -> ContactTables:
    """All of them; the arguments are those of `MeshContact.of`."""
    pair = flanks.pair
    middles = pair.face_width * ((np.arange(slices) + 0.5) / slices - 0.5)
    depths = compliance[0].depth, compliance[1].depth
    scalars = _scalars(flanks, materials, depths, slices, damping_time, reach)
    first, last = _pairs(scalars, middles)
    moving = RimModes.none(slices) if modes is None else modes
    counts = np.array([pair.pinion.teeth, last - first + 1, first, phases, len(moving.body)], np.int64)
    return ContactTables(
        scalars,
        counts,
        middles,
        _compliance(flanks, compliance, scalars, counts, middles),
        np.array([topography.series(side) for side in range(2)]),
        relief_table(flanks, topography, scalars, middles),
        np.ascontiguousarray(moving.order, np.int64),
        np.ascontiguousarray(moving.body, np.int64),
        np.ascontiguousarray(moving.shape, np.float64),
    )


def _scalars(
    flanks: Flanks,
    materials: tuple[Material, Material],
    depths: tuple[float, float],
    slices: int,
    damping_time: float,
    reach: float,
) -> Reals:
    pair, x = flanks.pair, np.zeros(places.SCALARS)
    x[places.BASE_1], x[places.BASE_2] = flanks.base_radii
    x[places.CENTRES], x[places.ANGLE] = pair.centre_distance, pair.working_pressure_angle
    x[places.TWIST], x[places.OBLIQUE], x[places.PITCH] = flanks.twist, cos(flanks.base_helix), flanks.pitch
    x[places.ORIGIN_1], x[places.ORIGIN_2] = flanks.origins
    x[places.TIP_1], x[places.TIP_2] = flanks.tip_rolls
    x[places.CORNER_1], x[places.CURVED_1], x[places.FAR_1] = flanks.corner_coefficients(0, reach)
    x[places.CORNER_2], x[places.CURVED_2], x[places.FAR_2] = flanks.corner_coefficients(1, reach)
    x[places.PATH_START], x[places.PATH_END] = pair.path_of_contact
    x[places.LENGTH] = pair.face_width / slices / cos(flanks.base_helix)
    plane = [(1.0 - one.poisson_ratio**2) / one.youngs_modulus for one in materials]
    x[places.HERTZ] = 2.0 / pi * sum(plane)
    x[places.HERTZ_DEPTH] = sum(
        2.0 / pi * soft * (log(2.0 * depth) - 0.5 * one.poisson_ratio / (1.0 - one.poisson_ratio))
        for soft, depth, one in zip(plane, depths, materials, strict=True)
    )
    x[places.TANGENT] = pair.tangent_length
    curvature = flanks.relative_curvature(0.5 * pair.tangent_length)
    x[places.MOST_LOAD] = (0.5 * min(depths)) ** 2 / (2.0 * x[places.HERTZ] * curvature)
    x[places.LEAST_LOAD] = min(100.0, 1e-3 * x[places.MOST_LOAD])
    x[places.LOG_LEAST] = log(x[places.LEAST_LOAD])
    x[places.DAMPING_TIME], x[places.REACH] = damping_time, reach
    start, end = _window(x)
    x[places.RELIEF_START] = start
    x[places.RELIEF_STEP] = (end - start) / (RELIEF_POINTS - 1)
    return x


def _window(x: Reals) -> tuple[float, float]:
    """Between which roll lengths of the pinion contact is followed, tip corners included."""
    start = max(x[places.PATH_START] - x[places.FAR_2], 0.02 * x[places.PITCH])
    return start, x[places.PATH_END] + x[places.FAR_1]


def _roll_at_rest(x: Reals) -> float:
    return float(x[places.ORIGIN_1] + x[places.BASE_1] * x[places.ANGLE])


def _pairs(x: Reals, middles: Reals) -> tuple[int, int]:
    """The pairs that have a place in the window at some phase of a cycle."""
    (start, end), rest = _window(x), _roll_at_rest(x)
    shift = x[places.TWIST] * middles
    first = ceil((start - rest - shift.max()) / x[places.PITCH] - 1.0)
    return first, floor((end - rest - shift.min()) / x[places.PITCH])


def roll_lengths(x: Reals, counts: NDArray[np.int64], middles: Reals, phase: float) -> Reals:
    """Roll lengths of the pinion at all places of a phase, shape (P, S)."""
    pairs = counts[places.FIRST_PAIR] + np.arange(counts[places.PAIRS])
    return _roll_at_rest(x) + (phase + pairs)[:, None] * x[places.PITCH] + x[places.TWIST] * middles[None, :]


def _compliance(
    flanks: Flanks,
    bodies: tuple[Compliance, Compliance],
    x: Reals,
    counts: NDArray[np.int64],
    middles: Reals,
) -> Reals:
    """Of both gears together at all phases, shape (P S, P S, N + 3)."""
    phases = int(counts[places.PHASES])
    size = int(counts[places.PAIRS]) * len(middles)
    whole = np.zeros((size, size, phases + 3))
    for p in range(phases + 3):
        rolls = roll_lengths(x, counts, middles, (p - 1) / phases)
        whole[:, :, p] = _influence(bodies[0], rolls, middles, 1)
        whole[:, :, p] += _influence(bodies[1], flanks.pair.tangent_length - rolls, middles, -1)
    return whole


def _influence(body: Compliance, rolls: Reals, middles: Reals, direction: int) -> Reals:
    """Of one gear, all places on each other; tooth numbers rise with the pairs (1) or fall (−1)."""
    grid_roll, grid_axial = body.roll, body.axial
    along = _weights(grid_roll, np.clip(rolls.ravel(), grid_roll[0], grid_roll[-1]))
    across = np.tile(_spread(grid_axial, middles), (len(rolls), 1))
    weights = (along[:, :, None] * across[:, None, :]).reshape(rolls.size, -1)
    reach, (pairs, slices) = (len(body.influence) - 1) // 2, rolls.shape
    found = np.zeros((rolls.size, rolls.size))
    for loaded in range(pairs):
        rows = slice(loaded * slices, (loaded + 1) * slices)
        for seen in range(max(loaded - reach, 0), min(loaded + reach, pairs - 1) + 1):
            columns = slice(seen * slices, (seen + 1) * slices)
            matrix = body.influence[reach + direction * (seen - loaded)]
            found[columns, rows] = (weights[rows] @ matrix @ weights[columns].T).T
    return 0.5 * (found + found.T)


def _spread(grid: Reals, middles: Reals) -> Reals:
    """Parts of the force on a slice, evenly spread over it, that places of a grid across the face carry as
    hats: shape (slices, grid)."""
    width = (grid[-1] - grid[0]) / len(middles)
    ends = np.append(middles - 0.5 * width, middles[-1] + 0.5 * width)
    fine = np.unique(np.concatenate([grid, np.clip(ends, grid[0], grid[-1])]))
    hats = np.array([np.interp(fine, grid, row) for row in np.eye(len(grid))])
    areas = np.concatenate(
        [np.zeros((len(grid), 1)), np.cumsum(0.5 * (hats[:, 1:] + hats[:, :-1]) * np.diff(fine), axis=1)],
        axis=1,
    )
    whole = np.array([np.interp(np.clip(ends, grid[0], grid[-1]), fine, row) for row in areas])
    return np.diff(whole, axis=1).T / width


def _weights(grid: Reals, at: Reals) -> Reals:
    """Of cubic splines on a grid, shape (at, grid)."""
    if len(grid) == 1:
        return np.ones((len(at), 1))
    if len(grid) < 4:
        return np.array([np.interp(at, grid, row) for row in np.eye(len(grid))]).T
    return np.asarray(CubicSpline(grid, np.eye(len(grid)))(at))


def relief_table(flanks: Flanks, topography: Topography, x: Reals, middles: Reals) -> Reals:
    """Of both sides on a grid of roll lengths of the pinion, shape (2, S, R)."""
    rolls = x[places.RELIEF_START] + x[places.RELIEF_STEP] * np.arange(RELIEF_POINTS)
    relief, width = topography.relief, flanks.pair.face_width
    mate = flanks.pair.tangent_length - rolls
    tips = [
        [relief.of_roll(which, float(roll - flanks.tip_rolls[which])) for roll in own]
        for which, own in enumerate((rolls, mate))
    ]
    face = np.array([relief.of_face(float(z), width) for z in middles])
    one = np.sum(tips, axis=0)[None, :] + face[:, None]
    one = one + topography.modification.gap(flanks.pair, rolls[None, :], middles[:, None] / width)
    return np.array([one, one])
