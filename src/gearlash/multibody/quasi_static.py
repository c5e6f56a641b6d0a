"""A pair of gears turned slowly through a mesh cycle under a torque, both bodies in rigid bearings.

Mesh stiffness, its harmonics, transmission error, contact ratio and backlash are not put in: they come out of
flanks and compliance.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import root_scalar

from gearlash.system import GearlashError

from . import _tables as places
from .contact import Details, MeshContact

Reals = NDArray[np.float64]

PROBE = 1e-3
"""Of the deflection: half the step over which a stiffness is taken."""


@dataclass(frozen=True)
class QuasiStatic:
    """A mesh cycle under a torque. Forces and ways are normal to the flanks.

    Parameters
    ----------
    torque : float
        On the pinion, N·m.
    phase : ndarray, shape (n,)
        Of the mesh: the pinion's turn times its teeth over 2π, from 0 to below 1.
    transmission_error : ndarray, shape (n,)
        How far the gear stays behind, m, counted from the middle of nominal backlash plus half of it: 0 for
        perfect rigid flanks.
    unloaded_error : ndarray, shape (n,)
        The same where flanks first touch, m.
    stiffness : ndarray, shape (n,)
        dF/dδ, N/m.
    force : ndarray, shape (n,)
        Sum of the normal forces, N.
    loads : ndarray, shape (n, pairs, slices)
        Force on every place, N.
    rolls : ndarray, shape (n, pairs, slices)
        Roll lengths of the pinion at the places, m.
    backlash : float
        What both sides leave in rigid flanks, least over the cycle, m.
    """

    torque: float
    phase: Reals
    transmission_error: Reals
    unloaded_error: Reals
    stiffness: Reals
    force: Reals
    loads: Reals
    rolls: Reals
    backlash: float

    @property
    def deflection(self) -> Reals:
        """Transmission error less that without load, m, shape (n,)."""
        return self.transmission_error - self.unloaded_error

    @property
    def mean_stiffness(self) -> float:
        """k_m, N/m."""
        return float(self.stiffness.mean())

    @property
    def total_contact_ratio(self) -> float:
        """Mean number of pairs of teeth that carry load: ε_γ under load."""
        return float((self.loads > 0.0).any(axis=2).sum(axis=1).mean())

    @property
    def transverse_contact_ratio(self) -> float:
        """Mean number of pairs that carry load in a slice: ε_α under load."""
        return float((self.loads > 0.0).sum(axis=1).mean())

    def ripple(self, order: int) -> tuple[float, float]:
        """Harmonic of the stiffness.

        Parameters
        ----------
        order : int
            n, from 1.

        Returns
        -------
        (float, float)
            ε_n, at least 0, and φ_n, rad: k = k_m (1 + Σ ε_n cos(nθ + φ_n)), θ = 2π phase.
        """
        amplitude, angle = self.error_harmonic(order, self.stiffness)
        return amplitude / self.mean_stiffness, angle

    def error_harmonic(self, order: int, curve: Reals | None = None) -> tuple[float, float]:
        """Harmonic of the transmission error, or of another curve over the cycle: amplitude and angle.

        Parameters
        ----------
        order : int
            n, from 1, below half the number of phases.
        curve : ndarray, shape (n,), optional
            The transmission error where nothing is given.

        Returns
        -------
        (float, float)
            A and φ, rad, of A cos(nθ + φ).
        """
        values = self.transmission_error if curve is None else curve
        found = 2.0 * np.fft.rfft(values)[order] / len(values)
        return float(abs(found)), float(np.angle(found))


def quasi_static(
    contact: MeshContact, torque: float, phases: int = 64, displaced: Reals | None = None
) -> QuasiStatic:
    """Turn a pair slowly through one mesh cycle.

    Parameters
    ----------
    contact : MeshContact
        Its damping does not matter, its modes rest.
    torque : float
        On the pinion, N·m; above 0: side 0 works.
    phases : int
        In the cycle, from 8.
    displaced : ndarray, shape (12,), optional
        Where the bearings hold the bodies, as a pose of `MeshContact.forces`: other centre distance,
        misalignment; as drawn where nothing is given. Both turns in it are 0.

    Returns
    -------
    QuasiStatic

    Raises
    ------
    GearlashError
        For a torque of 0 or below, or one that the flanks cannot carry.
    """
    if not torque > 0.0:
        raise GearlashError(f"torque {torque:g} N·m: it is above 0")
    at = np.arange(phases) / phases
    held = np.zeros(12) if displaced is None else np.asarray(displaced, dtype=float)
    points = [_point(contact, torque, float(u), held) for u in at]
    error, unloaded, stiffness, play = (
        np.array(column) for column in zip(*(p[:4] for p in points), strict=True)
    )
    found = [one[4] for one in points]
    return QuasiStatic(
        torque,
        at,
        error,
        unloaded,
        stiffness,
        np.array([one.normal[0] for one in found]),
        np.array([one.loads[0] for one in found]),
        np.array([contact.rolls(float(u)) for u in at]),
        float(play.min()),
    )


def _point(
    contact: MeshContact, torque: float, phase: float, held: Reals
) -> tuple[float, float, float, float, Details]:
    """Transmission error, the same without load, stiffness, backlash, and the contacts at one phase."""
    flanks = contact.flanks
    lever = flanks.base_radii[1] * cos(flanks.base_helix)
    turn = phase * flanks.phase_pitch
    rest = contact.details(*_pose(contact, held, turn, 0.0))
    target = torque * flanks.base_radii[1] / flanks.base_radii[0]

    def missing(behind: float) -> float:
        q, v = _pose(contact, held, turn, behind)
        return target + float(contact.forces(q, v)[11])

    touching, step = rest.nearest[0], 1e-6
    while missing(touching + step) > 0.0:
        step *= 2.0
        if step > flanks.play + 1e-3:
            raise GearlashError(f"a torque of {torque:g} N·m is more than the flanks carry")
    behind = float(root_scalar(missing, bracket=(touching, touching + step), xtol=1e-15, rtol=1e-12).root)
    probe = PROBE * (behind - touching)
    stiffness = (missing(behind - probe) - missing(behind + probe)) / (2.0 * probe) / lever
    half = 0.5 * flanks.play
    details = contact.details(*_pose(contact, held, turn, behind))
    return behind - half, touching - half, stiffness, sum(rest.nearest), details


def _pose(contact: MeshContact, held: Reals, turn: float, behind: float) -> tuple[Reals, Reals]:
    """The pinion turned, the gear behind by so much, normal to the flanks; at rest."""
    first, second = contact.flanks.base_radii
    q = np.zeros(12 + int(contact.tables.counts[places.MODES]))
    q[:12] = held
    q[5] = turn
    q[11] = (behind / cos(contact.flanks.base_helix) - first * turn) / second
    return q, np.zeros(len(q))
