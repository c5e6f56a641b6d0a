"""Where both gears are at times of a mesh cycle, like the frames of a film."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.multibody import Trajectory

Array = NDArray[np.float64]
FRAMES = 6
"""Of a mesh cycle."""


@dataclass(frozen=True, eq=False)
class Frames:
    """Poses over the last whole mesh cycle that was read.

    Attributes
    ----------
    phase : ndarray, shape (n,)
        Of the mesh cycle, from 0 to below 1.
    turns : ndarray, shape (n, 2)
        Of pinion and gear, rad, less the pitches that went by before the cycle.
    forces : ndarray, shape (n, 2)
        Of the drive side and of the back side, N.
    """

    phase: Array
    turns: Array
    forces: Array

    @property
    def poses(self) -> Array:
        """As the drawing of teeth takes them, shape (n, 12): in its section at mid face the turns count."""
        made = np.zeros((len(self.phase), 12))
        made[:, [5, 11]] = self.turns
        return made


def frames_of(motion: Trajectory, teeth: tuple[int, int]) -> Frames:
    """Frames at even distances of phase, one of them in the middle of the longest time apart: one that lasts
    to the end of the cycle goes on where the cycle begins.

    Parameters
    ----------
    motion : Trajectory
        Kept at every step, over at least one mesh cycle.
    teeth : (int, int)
        Of pinion and gear.

    Returns
    -------
    Frames
    """
    phase = motion.q[:, 5] * teeth[0] / (2.0 * np.pi)
    first = np.floor(phase[-1] + 1e-9) - 1.0
    cycle = np.flatnonzero((phase >= first) & (phase < first + 1.0))
    begins = _apart(phase[cycle] - first, motion.recorded[cycle, :2].max(axis=1) <= 0.0) % (1.0 / FRAMES)
    at = [int(np.abs(phase - first - begins - k / FRAMES).argmin()) for k in range(FRAMES)]
    pitches = 2.0 * np.pi * first / np.array(teeth) * np.array([1.0, -1.0])
    turns = motion.q[np.ix_(at, [5, 11])] - pitches
    return Frames(phase[at] - first, turns, motion.recorded[at, :2])


def _apart(phase: Array, free: NDArray[np.bool_]) -> float:
    """Phase in the middle of the longest time in which no tooth carries, in a cycle that goes round; 0
    without such a time."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], free, [False]])))
    if not len(edges):
        return 0.0
    begins, ends = phase[edges[::2]], phase[edges[1::2] - 1]
    if free[0] and free[-1] and len(begins) > 1:
        begins, ends = begins[1:], np.append(ends[1:-1], ends[0] + 1.0)
    longest = int((ends - begins).argmax())
    return 0.5 * float(begins[longest] + ends[longest])
