"""The four conditions of grazing, evaluated at every extremum of the gap.

An orbit grazes a boundary H = 0 where H = 0, ∇H ≠ 0, H' = 0 and H'' ≠ 0 along it (M. di Bernardo et al.,
Piecewise-smooth Dynamical Systems, 2008, ch. 6, doi:10.1007/978-1-84628-708-4). With the rule `no-tension`
contact is not lost at the boundary of the gap but where the force falls to zero: there the conditions
are those of H = Φ, at the extrema of the force."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from gearlash.flow import Trace
from gearlash.flow.events import force_of_side, gap_displacement, gap_velocity
from gearlash.system import ContactRule, Record, System, evaluate, given

from .contact_force import force_extrema
from .extrema import gap_extrema
from .results import Aperiodic, Attractor, Orbit

Surface = Literal["gap", "force"]

GRAZING_KINDS = {
    ("gap", 1, 1): "loss of contact on the drive side (minimum of X in S1)",
    ("gap", 1, -1): "engagement on the drive side (maximum of X in S2)",
    ("gap", -1, -1): "loss of contact on the back side (maximum of X in S3)",
    ("gap", -1, 1): "engagement on the back side (minimum of X in S2)",
    ("force", 1, 1): "loss of contact on the drive side (the force falls to zero in S1)",
    ("force", 1, -1): "engagement on the drive side (the force rises to zero beyond +D)",
    ("force", -1, -1): "loss of contact on the back side (the force falls to zero in S3)",
    ("force", -1, 1): "engagement on the back side (the force rises to zero beyond -D)",
}


@dataclass(frozen=True, repr=False)
class GrazingConditions(Record):
    """The four conditions of grazing a surface H = 0, as numbers along one motion at one phase.

    Parameters
    ----------
    distance : float
        H: 0 where the motion meets the surface.
    gradient : float
        |∇H|: not 0 where the surface is smooth.
    velocity : float
        H': 0 where the motion does not cross it.
    a0 : float
        H'' per unit of τ squared: not 0, and its sign names the side that the surface is met from.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.GrazingConditions(distance=0.0, gradient=1.0, velocity=0.0, a0=0.2).met()
    (True, True, True, True)
    """

    distance: float
    gradient: float
    velocity: float
    a0: float

    def met(self, tolerance: float = 1e-9) -> tuple[bool, bool, bool, bool]:
        """Which of the conditions hold.

        Parameters
        ----------
        tolerance : float
            Within which distance and velocity count as 0, and beyond which a0 does not; lengths in units of
            the reference length.

        Returns
        -------
        tuple of bool
            Of distance, gradient, velocity and a0.
        """
        return (
            abs(self.distance) <= tolerance,
            self.gradient > 0.0,
            abs(self.velocity) <= tolerance,
            abs(self.a0) > tolerance,
        )


@dataclass(frozen=True, repr=False)
class GrazingCheck(Record):
    """The four conditions of grazing at one extremum of a motion beside one boundary.

    A motion grazes H = 0 where H = 0, ∇H ≠ 0, H' = 0 and H'' ≠ 0. On Σ1 a0 > 0 is loss of contact, seen from
    S1, and a0 < 0 engagement, seen from S2; on Σ2 the signs are mirrored: `kind` says which.

    Attributes
    ----------
    phase : float
        Of the extremum, in mesh cycles.
    boundary : {1, -1}
        Σ1 or Σ2.
    displacement : float
        X there.
    distance : float
        H: X ∓ D of the surface "gap", Φ of the surface "force". The first condition wants 0.
    gradient : float
        |∇H|; the second condition wants it not to be 0.
    velocity : float
        H', 0 by construction of the extremum: the third condition.
    a0 : float
        H'' per unit of τ squared; the fourth condition wants it not to be 0.
    index : int
        Of the extremum among those of its clearance.
    clearance : int
        Index of the clearance.
    name : str
        Name of the clearance.
    surface : {"gap", "force"}
        Whether H is the distance to the boundary of the gap or, with the rule `no-tension`, the force.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> orbit = gl.attractor(family.system({"omega": 0.8}), family.start())
    >>> nearest = gl.grazing_checks(orbit)[0]
    >>> round(nearest.distance, 4), nearest.kind
    (0.0132, 'loss of contact on the drive side (minimum of X in S1)')
    """

    phase: float
    boundary: int
    displacement: float
    distance: float
    gradient: float
    velocity: float
    a0: float
    index: int
    clearance: int = 0
    name: str = "mesh"
    surface: Surface = "gap"

    @property
    def kind(self) -> str:
        """Which contact would be lost or made, in words."""
        return GRAZING_KINDS[(self.surface, self.boundary, 1 if self.a0 > 0 else -1)]

    def holds(self, tolerance: float = 1e-9) -> bool:
        """Whether all four conditions hold.

        Parameters
        ----------
        tolerance : float
            Within which distance and velocity count as 0, and beyond which a0 does not; lengths in units of
            the reference length.

        Returns
        -------
        bool
        """
        return all(self.conditions.met(tolerance))

    @property
    def conditions(self) -> GrazingConditions:
        """The four numbers that the conditions are about."""
        return GrazingConditions(self.distance, self.gradient, self.velocity, self.a0)


def grazing_checks(
    attractor: Attractor, within: float = np.inf, clearance: int | None = None
) -> tuple[GrazingCheck, ...]:
    """The conditions of grazing at every extremum of a motion, the nearest to a boundary first.

    A side that does not act (`Clearance.stops`) has no boundary. With the rule `no-tension` the extrema of
    the force are looked at, too.

    Parameters
    ----------
    attractor : Orbit, Aperiodic, Neutral or Unresolved
        What `attractor` returned.
    within : float
        Distance to a boundary up to which an extremum counts; infinity for all of them.
    clearance : int, optional
        Index of one clearance; all of them without.

    Returns
    -------
    tuple of GrazingCheck

    Raises
    ------
    GearlashError
        For arguments that do not fit.

    References
    ----------
    M. di Bernardo et al., Piecewise-smooth Dynamical Systems, 2008, ch. 6,
    doi:10.1007/978-1-84628-708-4.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> orbit = gl.attractor(family.system({"omega": 0.8}), family.start())
    >>> [round(check.distance, 4) for check in gl.grazing_checks(orbit, within=0.1)]
    [0.0132]
    """
    trace, count = motion_of(attractor).trace, len(attractor.propagators.system.clearances)
    within = given.limit("within", within)
    if clearance is not None:
        clearance = trace.which(clearance)
    found: list[GrazingCheck] = []
    for j in range(count) if clearance is None else (clearance,):
        found += (check for check in checks_of(trace, j) if abs(check.distance) <= within)
    return tuple(sorted(found, key=lambda check: abs(check.distance)))


def checks_of(trace: Trace, clearance: int) -> Iterator[GrazingCheck]:
    """Of every extremum of one clearance on a piece of a motion."""
    yield from _of_gap(trace, clearance)
    if trace.propagators.system.clearances[clearance].contact is ContactRule.NO_TENSION:
        yield from _of_force(trace, clearance)


def motion_of(attractor: Attractor) -> Attractor:
    """The attractor that was given. Raises `GearlashError` for anything else."""
    expected = "what gearlash.attractor returns: an Orbit, Aperiodic or Unresolved"
    return given.instance("attractor", attractor, (Orbit, Aperiodic), expected)


def _of_gap(trace: Trace, j: int) -> Iterator[GrazingCheck]:
    """Extrema of X against both boundaries; with `no-tension` only those seen from inside the gap, as contact
    does not end at them."""
    c, extrema = trace.propagators.system.clearances[j], gap_extrema(trace, j)
    velocity = gap_velocity(trace.propagators.system, extrema.phase, extrema.state, j)
    tension, gradient = c.contact is not ContactRule.NO_TENSION, float(np.linalg.norm(c.h))
    for boundary, gap in ((1, c.gap_plus), (-1, -c.gap_minus)):
        if not c.stops(boundary):
            continue
        for i in range(len(extrema)):
            if tension or boundary * extrema.curvature[i] < 0.0:
                yield GrazingCheck(
                    phase=float(extrema.phase[i]),
                    boundary=boundary,
                    displacement=float(extrema.displacement[i]),
                    distance=float(extrema.displacement[i] - gap),
                    gradient=gradient,
                    velocity=float(velocity[i]),
                    a0=float(extrema.curvature[i]),
                    index=i,
                    clearance=j,
                    name=c.name,
                )


def _of_force(trace: Trace, j: int) -> Iterator[GrazingCheck]:
    """Extrema of Φ at which contact may be lost (a least force, whether it still presses there or not), or
    come back before the gap opens."""
    system, extrema = trace.propagators.system, force_extrema(trace, j)
    c = system.clearances[j]
    for i in range(len(extrema)):
        boundary = int(extrema.boundary[i])
        if extrema.in_contact[i] and boundary * extrema.curvature[i] < 0.0:
            continue  # the largest force: nothing ends there
        yield GrazingCheck(
            phase=float(extrema.phase[i]),
            boundary=boundary,
            displacement=float(extrema.displacement[i]),
            distance=float(extrema.force[i]),
            gradient=float(np.linalg.norm(force_gradient(system, j, float(extrema.phase[i]), boundary))),
            velocity=0.0,
            a0=float(extrema.curvature[i]),
            index=i,
            clearance=j,
            name=c.name,
            surface="force",
        )


def conditions_at(
    system: System,
    phase: float,
    state: NDArray[np.float64],
    a0: float,
    *,
    clearance: int,
    boundary: int,
    surface: Surface,
    force_rate: float = 0.0,
) -> GrazingConditions:
    """The conditions read from the state (n,) of a motion at a phase (mesh cycles). ``a0``, and for the
    surface "force" the rate ``force_rate`` of the force, are derivatives along the motion that a state alone
    does not tell."""
    c, at = system.clearances[clearance], np.array([phase])
    x, velocity = (read(system, at, state[None], clearance) for read in (gap_displacement, gap_velocity))
    if surface == "gap":
        edge = c.gap_plus if boundary > 0 else -c.gap_minus
        return GrazingConditions(float(x[0]) - edge, float(np.linalg.norm(c.h)), float(velocity[0]), a0)
    region = np.array([0 if boundary > 0 else 2])
    force = float(force_of_side(system, at, x, velocity, region, clearance)[0])
    gradient = float(np.linalg.norm(force_gradient(system, clearance, phase, boundary)))
    return GrazingConditions(force, gradient, force_rate, a0)


def force_gradient(system: System, j: int, phase: float, boundary: int) -> NDArray[np.float64]:
    """∂Φ/∂z (n,) of a side at a phase (mesh cycles): η h + ζ h M."""
    c = system.clearances[j]
    stiffness = c.stiffness_plus if boundary > 0 else c.stiffness_minus
    eta = evaluate(stiffness, 2.0 * np.pi / system.cycles * phase)
    return eta * c.h + c.dampings[0 if boundary > 0 else 1] * (c.h @ system.matrix)
