"""What is known of one orbit of a curve: its contacts, its extrema, the windows around them."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import count

import numpy as np

from gearlash.branches.continuation.extrema import Extrema, Extremum
from gearlash.orbits.contact_force import force_extrema
from gearlash.orbits.extrema import gap_extrema
from gearlash.orbits.grazing import checks_of
from gearlash.system import Signature

from .plane import Array
from .problem import Evaluated
from .touch import Window, traced

PART = 0.9  # of the way to the next extremum: how far a window goes
MOST = 0.49  # of the orbit
ASKED = 3  # extrema
SAME = 1e-9  # mesh cycles: an extremum so near is the same


@dataclass(frozen=True, eq=False)
class CurveOrbit:
    """``extrema`` numbered along the curve; ``signature`` with held boundaries not crossed; ``turns``:
    phases of all extrema of X of every clearance, with their curvature, and of those of the force;
    ``contacts``: phases of all contact events."""

    extrema: Extrema
    signature: Signature
    turns: tuple[tuple[Array, Array, Array], ...]
    contacts: Array
    cycles: float

    @staticmethod
    def of(here: Evaluated) -> CurveOrbit:
        system, cycles = here.props.system, here.cycles
        states = here.course[0]
        traces = [traced(here.props, z, leg) for z, leg in zip(states[:-1], here.legs, strict=True)]
        found, counts, turns = [], [], []
        for j in range(len(system.clearances)):
            checks = [check for trace in traces for check in checks_of(trace, j)]
            found += checks
            events = [trace.events.of(j) for trace in traces]
            drive, back = (
                sum(int((e.engaging & (e.boundary == side)).sum()) for e in events) for side in (1, -1)
            )
            counts.append((drive, back))
            x = [gap_extrema(trace, j) for trace in traces]
            force = np.empty(0)
            if any(check.surface == "force" for check in checks):
                force = np.concatenate([force_extrema(trace, j).phase for trace in traces])
            turns.append(
                (np.concatenate([e.phase for e in x]), np.concatenate([e.curvature for e in x]), force)
            )
        ordered = sorted(
            ((check.phase % cycles, check) for check in found), key=lambda pair: (pair[0], pair[1].boundary)
        )
        named = tuple(
            Extremum(i, c.clearance, c.surface, c.boundary, phase, c.distance, c.a0)
            for i, (phase, c) in enumerate(ordered)
        )
        (drive, back), *others = counts
        signature = Signature(int(cycles), drive, back, tuple(others))
        contacts = np.concatenate([trace.events.phase for trace in traces]) % cycles
        return CurveOrbit(
            Extrema(named, cycles, count(len(named))), signature, tuple(turns), contacts, cycles
        )

    def window(self, extremum: Extremum) -> Window:
        """Around an extremum, so wide that no other one lies in it: as far on both sides, as it may merge
        with the nearer one, and a crossing comes to lie on the other side."""
        phases, curvature, force = self.turns[extremum.clearance]
        if extremum.surface == "force":
            phases = np.concatenate([phases[curvature * extremum.a0 < 0.0], force])
        away = (phases - extremum.phase) % self.cycles
        away = away[(away > SAME) & (away < self.cycles - SAME)]
        width = MOST * self.cycles
        if len(away):
            width = min(self.cycles - float(away.max()), float(away.min()), width)
        return Window(extremum.clearance, extremum.surface, extremum.boundary, PART * width)

    def beside(self, phase: float, window: Window) -> Extremum | None:
        """The extremum of a window's boundary that is nearest to a phase."""
        kind = window.clearance, window.surface, window.boundary
        mine = [e for e in self.extrema.all if e.group[:3] == kind]
        return min(mine, key=lambda e: apart(e.phase, phase, self.cycles), default=None)

    def nearest(self, here: Evaluated, but: tuple[Extremum, ...] = ()) -> float:
        """How far the state may move, in units of the motion, until an extremum comes to its boundary; those
        are asked that are nearest to theirs."""
        asked = sorted((e for e in self.extrema.all if e not in but), key=lambda e: abs(e.distance))[:ASKED]
        return min((abs(e.distance) / here.moved(e) for e in asked), default=np.inf)

    def held(self, here: Evaluated) -> tuple[Extremum, ...]:
        """The extrema whose boundaries are held."""
        found = (self.beside(phase, window) for phase, window in here.windows if window.open)
        return tuple(each for each in found if each is not None)

    def more(self, extremum: Extremum) -> Signature:
        """The contacts where an extremum that is held crosses its boundary."""
        drive, back = int(extremum.boundary > 0), int(extremum.boundary < 0)
        counts = list(self.signature.counts)
        one, two = counts[extremum.clearance]
        counts[extremum.clearance] = (one + drive, two + back)
        (one, two), *others = counts
        return Signature(self.signature.period, one, two, tuple(others))


def apart(one: float, two: float, cycles: float) -> float:
    """Distance of two phases on an orbit."""
    away = abs(one - two) % cycles
    return min(away, cycles - away)


def is_clear(extremum: Extremum) -> bool:
    """Whether an extremum has not crossed its boundary: a minimum lies above it, a maximum below."""
    return extremum.a0 * extremum.distance > 0.0
