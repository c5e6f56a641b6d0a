"""The three Poincaré sections as data."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gearlash.flow.events import contact_force, gap_displacement, gap_velocity
from gearlash.system import Record, System

from .grazing import motion_of
from .results import Attractor

ENTERING, LEAVING = 1, -1


@dataclass(frozen=True, eq=False, repr=False)
class Section(Record):
    """Points of one Poincaré section.

    Attributes
    ----------
    phase : ndarray of shape (m,)
        In mesh cycles.
    state : ndarray of shape (m, n)
    displacement : ndarray of shape (m,)
        X of the clearance.
    velocity : ndarray of shape (m,)
        X' per unit of τ.
    force : ndarray of shape (m,)
        Contact force Φ, positive where the drive side is compressed.
    direction : ndarray of int, shape (m,)
        1 into contact, -1 out of it, 0 on σ_t.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("blankenship-kahraman").family()
    >>> drive = gl.sections(gl.attractor(family.system(), family.start())).drive
    >>> len(drive), len(drive.entering), len(drive.leaving)
    (2, 1, 1)
    """

    phase: NDArray[np.float64]
    state: NDArray[np.float64]
    displacement: NDArray[np.float64]
    velocity: NDArray[np.float64]
    force: NDArray[np.float64]
    direction: NDArray[np.int64]

    def __len__(self) -> int:
        return len(self.phase)

    @property
    def entering(self) -> Section:
        """The impacts: crossings into contact."""
        return self._where(self.direction == ENTERING)

    @property
    def leaving(self) -> Section:
        """The releases: crossings out of contact."""
        return self._where(self.direction == LEAVING)

    def _where(self, mask: NDArray[np.bool_]) -> Section:
        return Section(
            self.phase[mask],
            self.state[mask],
            self.displacement[mask],
            self.velocity[mask],
            self.force[mask],
            self.direction[mask],
        )


@dataclass(frozen=True, eq=False, repr=False)
class Sections(Record):
    """The three Poincaré sections of a motion, in the gap of one clearance.

    With the rule `no-tension` contact ends where the force does, so beyond the boundary.

    Attributes
    ----------
    time : Section
        σ_t: once in every base period, at phase zero.
    drive : Section
        σ_d: all contact events at Σ1, X = +D.
    back : Section
        σ_b: all contact events at Σ2, X = -D.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("blankenship-kahraman").family()
    >>> found = gl.sections(gl.attractor(family.system(), family.start()))
    >>> len(found.time), len(found.drive), len(found.back)
    (1, 2, 0)
    """

    time: Section
    drive: Section
    back: Section


def sections(attractor: Attractor, clearance: int = 0) -> Sections:
    """The Poincaré sections of a motion, in the gap of one clearance.

    Parameters
    ----------
    attractor : Orbit, Aperiodic, Neutral or Unresolved
        What `attractor` returned: of an orbit one period is taken, of another motion the 200 base periods
        that are kept of it.
    clearance : int
        Index of the clearance.

    Returns
    -------
    Sections

    Raises
    ------
    GearlashError
        For what is no attractor, or an index that no clearance has.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> found = gl.sections(gl.attractor(family.system({"omega": 0.8}), family.start()))
    >>> found.time.displacement.round(4).tolist(), len(found.drive)
    ([1.0812], 0)
    """
    clearance = motion_of(attractor).trace.which(clearance)
    drive, back = (_crossings(attractor, clearance, boundary) for boundary in (1, -1))
    return Sections(_strobes(attractor, clearance), drive, back)


def _strobes(attractor: Attractor, clearance: int) -> Section:
    system, state = attractor.propagators.system, attractor.strobes
    phase = np.arange(len(state), dtype=np.float64) * system.cycles
    x = gap_displacement(system, phase, state, clearance)
    velocity = gap_velocity(system, phase, state, clearance)
    force = _force(system, clearance, phase, x, velocity)
    return Section(phase, state, x, velocity, force, np.zeros(len(phase), dtype=np.int64))


def _force(
    system: System, clearance: int, phase: NDArray, x: NDArray, velocity: NDArray
) -> NDArray[np.float64]:
    """Φ of a state: contact is where there is a stop beyond its boundary, and with `no-tension` presses."""
    c = system.clearances[clearance]
    plus, minus = (x > c.gap_plus) & c.stops(1), (x < -c.gap_minus) & c.stops(-1)
    region = np.where(plus, 0, np.where(minus, 2, 1))
    return contact_force(system, phase, x, velocity, region, clearance)


def _crossings(attractor: Attractor, clearance: int, boundary: int) -> Section:
    events = attractor.events.of(clearance)
    chosen = events.where(events.boundary == boundary)
    x = gap_displacement(attractor.propagators.system, chosen.phase, chosen.state, clearance)
    direction = np.where(chosen.engaging, ENTERING, LEAVING)
    return Section(chosen.phase, chosen.state, x, chosen.velocity, chosen.force, direction)
