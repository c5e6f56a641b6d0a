"""Grazing points: where a periodic orbit touches a boundary, in one parameter.

The equations are those of a grazing curve (`curves/problem.py`) with one parameter less: the orbit closes,
the extremum lies on the boundary, and is one. Beside it the boundary is not treated as crossed: what is left
is the one-sided system, in which the orbit is smooth through the touch. A touch is a result only where the
orbits on both sides differ by that contact."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from gearlash.orbits import GrazingCheck, Orbit
from gearlash.orbits.contact_force import force_extrema
from gearlash.orbits.extrema import gap_extrema
from gearlash.orbits.floquet import ordered, rate
from gearlash.system import Family, HasFamily, MotionKind, Status, given

from .curves.newton import Corrected, correct
from .curves.plane import UNBUILT, Array
from .curves.problem import Evaluated, Problem, TouchCondition
from .curves.touch import Window
from .grazing_point import GrazingPoint
from .one_parameter import CLOSED, at_phase_zero, begun, checked, error_of, residual_of
from .sides import Sides

WIDTH = 0.9  # of the way to the nearest other extremum: how far the boundary is held
MOST = 0.49  # of the orbit
SAME = 1e-9  # mesh cycles: an extremum so near is the same


def locate_grazing(
    model: Family | HasFamily,
    name: str,
    orbit: Orbit,
    check: GrazingCheck,
    *,
    values: Mapping[str, float | str] | None = None,
) -> GrazingPoint:
    """The value of a parameter at which an extremum of a periodic orbit touches its boundary.

    Newton's method for the orbit, the phase of the touch and the parameter together. The extremum is not
    treated as a crossing, so that the equations are smooth whichever side the orbit comes from.

    Parameters
    ----------
    model : Case or Family
    name : str
        The parameter that is solved for: a short name, or the physical one of a case.
    orbit : Orbit
        Near the touch, found at ``values``.
    check : GrazingCheck
        The extremum, of `grazing_checks`.
    values : mapping of str to float or str, optional
        Parameters of the member that the orbit is of, ``name`` among them; the model's own where nothing is
        given.

    Returns
    -------
    GrazingPoint
        Good to about 1e-12 of the value where its status is ok. It is `not-converged` where no solution was
        come to, or the way there leaves the range of the parameter or comes to values that have no system,
        and `not-admissible` where the labels beside it do not differ by one contact.

    Raises
    ------
    GearlashError
        For arguments that do not fit.

    References
    ----------
    M. di Bernardo et al., Piecewise-smooth Dynamical Systems, 2008, ch. 6, doi:10.1007/978-1-84628-708-4.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> orbit = gl.attractor(case.family()[0].system({"omega": 0.8}), [1.1, 0.0])
    >>> nearest = gl.grazing_checks(orbit)[0]
    >>> point = gl.locate_grazing(case, "omega", orbit, nearest, values={"omega": 0.8})
    >>> round(point.value, 9), point.status.value
    (0.820631088, 'ok')
    """
    family, members, name = checked(model, values, name, orbit)
    given.instance("check", check, GrazingCheck, "one of gearlash.grazing_checks(orbit)")
    given.whole("clearance of the check", check.clearance, 0, len(orbit.propagators.rules) - 1)
    corrected, start = _solved(family, members, name, orbit, check)
    residual, here = residual_of(corrected), corrected.here or corrected.nearest or start
    read, mu = _Read.of(here), float(here.problem.place(here.u)[0])
    sides = None
    if corrected.here is not None and residual <= CLOSED:
        sides = Sides.of(here.problem.plane, mu, read.zero, orbit.shot.period, check)
    status = Status.NOT_CONVERGED
    if sides is not None:
        status = Status.OK if sides.admissible else Status.NOT_ADMISSIBLE
    system = here.props.system
    duration = orbit.period / system.cycles * system.period
    return GrazingPoint(
        name=name,
        value=mu,
        error=error_of(here, corrected.jacobian) if sides else float("inf"),
        values={**members, name: mu},
        boundary=check.boundary,
        phase=float(read.phase % orbit.period),
        a0=read.a0,
        period=orbit.period,
        state=read.state,
        state_zero=read.zero,
        multipliers=read.multipliers,
        exponent=rate(complex(read.multipliers[0]), duration),
        label_below=sides.below.label if sides else MotionKind.NONE,
        label_above=sides.above.label if sides else MotionKind.NONE,
        residual=residual,
        status=status,
        clearance=check.clearance,
        clearance_name=check.name,
        surface=check.surface,
        stable_below=sides.below.stable if sides else None,
        stable_above=sides.above.stable if sides else None,
    )


def _solved(
    family: Family, values: Mapping[str, float], name: str, orbit: Orbit, check: GrazingCheck
) -> tuple[Corrected, Evaluated]:
    """The orbit that touches, begun half of it before, and the guess for it."""
    cycles = float(orbit.period)
    origin = (check.phase - 0.5 * cycles) % cycles
    alone = begun(family, values, name, orbit, origin)
    window = Window(check.clearance, check.surface, check.boundary, _width(orbit, check))
    problem: Problem = replace(alone.problem, touches=(TouchCondition(window),))
    n = problem.states
    guess = np.concatenate([alone.u[:n], [origin + 0.5 * cycles], alone.u[n:]])
    return correct(problem, guess), problem.evaluate(guess, alone.props)


@dataclass(frozen=True, eq=False)
class _Read:
    """Of an orbit: the states (n,) at the touch and at phase zero, the touch's phase from there, H″, and the
    multipliers; no numbers where it cannot be carried round."""

    state: Array
    zero: Array
    phase: float
    a0: float
    multipliers: NDArray[np.complex128]

    @staticmethod
    def of(here: Evaluated) -> _Read:
        try:
            zero, first = at_phase_zero(here)
            phase = float(here.problem.phases(here.u)[0]) - first
            multipliers = ordered(np.linalg.eigvals(here.monodromy))
            return _Read(here.touch_flows[0][0], zero, phase, float(here.at_touch(0)[2]), multipliers)
        except UNBUILT:
            none = np.full(here.problem.states, np.nan)
            return _Read(none, none, np.nan, np.nan, none.astype(np.complex128))


def _width(orbit: Orbit, check: GrazingCheck) -> float:
    """How far from the touch the boundary is held. The force turns just before X does: there the extrema of X
    of the same kind do not bound it."""
    extrema = gap_extrema(orbit.trace, check.clearance)
    phases = extrema.phase
    if check.surface == "force":
        away = extrema.phase[extrema.curvature * check.a0 < 0.0]
        phases = np.concatenate([away, force_extrema(orbit.trace, check.clearance).phase])
    cycles = float(orbit.period)
    far = (phases - check.phase) % cycles
    far = np.minimum(far, cycles - far)
    return WIDTH * float(far[far > SAME].min(initial=MOST * cycles))
