"""What a motion of bodies in space shows, read by the definitions of the lumped model.

A mesh cycle is one pitch of the pinion's rotation. The teeth are apart where no slice of either side carries
force. An impact is a beginning of contact; P-Q-R counts those of the drive side and of the back side in every
period of P mesh cycles: where they are not as many in each, there is no label, though the mean forces repeat.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.system import Signature

from .bodies import SPIN
from .dynamics import Trajectory

Array = NDArray[np.float64]
SAMPLES = 64
"""Parts of a mesh cycle whose mean forces two cycles are compared by."""


@dataclass(frozen=True)
class Reading:
    """Figures of a motion over whole mesh cycles.

    Attributes
    ----------
    label : Signature or None
        None where the motion does not come back within `longest` cycles, or its impacts do not: not as many
        in every period, or contact lost in some cycles alone. In P-0-R the drive side never lost contact in
        the cycles read, or never had it.
    period : int or None
        Mesh cycles after which the mean forces come back; None where they do not.
    returns : float
        How far the mean forces of every 1/64 of a mesh cycle miss themselves after P cycles, over the range
        of these means.
    cycles : int
        That were read.
    apart : float
        Share of time in which no tooth carries.
    drive_impacts, back_impacts : int
        Beginnings of contact in all cycles read.
    least, mean, most : float
        Normal force of the drive side, N.
    most_back : float
        Largest normal force of the back side, N.
    orders : ndarray, shape (n,)
        Amplitudes of the force at mesh orders 1/2, 1, 3/2, …, N.
    phase, force : ndarray
        The last `shown` mesh cycles: phase in mesh cycles, drive force less back force in N.
    speed : float
        Mean speed of the pinion, rad/s.
    """

    label: Signature | None
    period: int | None
    returns: float
    cycles: int
    apart: float
    drive_impacts: int
    back_impacts: int
    least: float
    mean: float
    most: float
    most_back: float
    orders: Array
    phase: Array
    force: Array
    speed: float


def read_motion(
    motion: Trajectory, teeth: int, *, longest: int = 8, tolerance: float = 0.01, shown: int = 2
) -> Reading:
    """Period, label and figures of a motion that has settled.

    Parameters
    ----------
    motion : Trajectory
        Kept at every step or nearly so, over at least twice ``longest`` mesh cycles.
    teeth : int
        Of the pinion.
    longest : int
        Longest period that is looked for, mesh cycles.
    tolerance : float
        A motion has come back where the mean force of every 1/64 of a mesh cycle is what it was, within this
        share of the range of these means: the force itself jumps where one more slice begins to carry, and
        would be read once before and once after a jump at the same phase.
    shown : int
        Mesh cycles of force that are kept.

    Returns
    -------
    Reading

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash.multibody import Trajectory, read_motion
    >>> t = np.linspace(0.0, 16.0, 2049)
    >>> q = np.zeros((2049, 12))
    >>> q[:, 5] = 2.0 * np.pi * t / 20
    >>> force = np.maximum(1.0 + 1.5 * np.cos(2.0 * np.pi * t), 0.0)
    >>> motion = Trajectory(t, q, np.gradient(q, t, axis=0), np.outer(force, [1.0, 0, 0, 0, 0]))
    >>> reading = read_motion(motion, 20)
    >>> str(reading.label), round(reading.apart, 2)
    ('1-1-0', 0.27)
    """
    phase = motion.q[:, SPIN] * teeth / (2.0 * np.pi)
    first, last = int(np.ceil(phase[0] - 1e-9)), int(np.floor(phase[-1] + 1e-9))
    cycles = last - first
    grid = first + np.arange(cycles * SAMPLES) / SAMPLES
    drive = np.interp(grid, phase, motion.drive_force)
    back = np.interp(grid, phase, motion.back_force)
    force = drive - back
    means = _means(phase, motion.drive_force - motion.back_force, first, cycles)
    period, returns = _period(means, longest, tolerance)
    within = (phase >= first) & (phase < last)
    sides = motion.drive_force, motion.back_force
    begun = [_beginnings(side[within]) for side in sides]
    free = (motion.drive_force[within] <= 0.0) & (motion.back_force[within] <= 0.0)
    label = None
    if period is not None:
        impacts = [_in_every_period(phase, side, within, period, cycles // period) for side in sides]
        label = _label(period, impacts, bool(free.any()))
    return Reading(
        label=label,
        period=period,
        returns=returns,
        cycles=cycles,
        apart=float(np.mean(free)),
        drive_impacts=begun[0],
        back_impacts=begun[1],
        least=float(motion.drive_force[within].min()),
        mean=float(means.mean()),
        most=float(motion.drive_force[within].max()),
        most_back=float(motion.back_force[within].max()),
        orders=_half_orders(force, cycles),
        phase=grid[-shown * SAMPLES :] - (last - shown),
        force=force[-shown * SAMPLES :],
        speed=float((motion.q[-1, SPIN] - motion.q[0, SPIN]) / (motion.t[-1] - motion.t[0])),
    )


def _means(phase: Array, force: Array, first: int, cycles: int) -> Array:
    """Mean force over each part of each mesh cycle, shape (cycles, SAMPLES)."""
    passed = np.append(0.0, np.cumsum(0.5 * (force[1:] + force[:-1]) * np.diff(phase)))
    ends = first + np.arange(cycles * SAMPLES + 1) / SAMPLES
    return np.diff(np.interp(ends, phase, passed)).reshape(cycles, SAMPLES) * SAMPLES


def _half_orders(force: Array, cycles: int) -> Array:
    """Amplitudes at the mesh orders 1/2, 1, …, 8, over an even number of cycles; none of a single cycle."""
    even = cycles // 2 * 2
    if not even:
        return np.zeros(0)
    spectrum = np.abs(np.fft.rfft(force[-even * SAMPLES :])) * 2.0 / (even * SAMPLES)
    return spectrum[:: even // 2][1:17]


def _beginnings(force: Array) -> int:
    """How often a side begins to carry; what carries at the first reading began before."""
    carries = force > 0.0
    return int(np.count_nonzero(carries[1:] & ~carries[:-1]))


def _in_every_period(
    phase: Array, force: Array, within: NDArray[np.bool_], period: int, periods: int
) -> int | None:
    """Beginnings of contact of a side in each of the last periods; None where they are not as many in all, or
    where there are none in these and the side yet began or ceased to carry in the cycles read."""
    carries = force > 0.0
    at = phase[1:][carries[1:] & ~carries[:-1]]
    end = _between(at, max(phase[-1] - 1.0, phase[0] + period * periods), phase[-1], period)
    back = np.ceil((end - at) / period).astype(int)  # 1 in the last period
    counts = np.bincount(back[(back > 0) & (back <= periods)], minlength=periods + 1)[1:]
    if np.ptp(counts):
        return None
    read = carries[within]
    if counts[0] == 0 and read.any() != read.all():
        return None
    return int(counts[0])


def _between(at: Array, low: float, high: float, period: int) -> float:
    """The phase from low to high that is farthest from all beginnings, whatever number of periods away: a
    beginning near the end of a period, which comes now earlier and now later, is counted in one of them."""
    tried = np.linspace(high, low, SAMPLES + 1)
    if not len(at):
        return high
    off = np.abs((tried[:, None] - at + 0.5 * period) % period - 0.5 * period).min(axis=1)
    return float(tried[off.argmax()])


def _label(period: int, impacts: list[int | None], free: bool) -> Signature | None:
    """Of impacts a period; none where contact is lost without an impact."""
    drive, back = impacts
    if drive is None or back is None or (free and not drive and not back):
        return None
    return Signature(period, drive, back)


def _period(cycles: Array, longest: int, tolerance: float) -> tuple[int | None, float]:
    """The shortest period after which the force comes back, and by how much it misses."""
    span = float(np.ptp(cycles))
    if not cycles.any():
        return None, 1.0  # teeth that never touch are accelerated
    if span == 0.0:
        return 1, 0.0
    missed = {
        p: float(np.abs(cycles[p:] - cycles[:-p])[-longest:].max()) / span
        for p in range(1, min(longest, len(cycles) // 2) + 1)
    }
    for p, off in missed.items():
        if off <= tolerance:
            return p, off
    return None, min(missed.values(), default=1.0)
