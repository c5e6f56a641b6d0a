"""Branches of periodic orbits of a case or a family."""

from __future__ import annotations

from collections.abc import Mapping

from gearlash import flow
from gearlash.branches.continuation import (
    Branch,
    BranchPoint,
    ContinuationSettings,
    GrazingLaw,
    SpecialPoint,
    continue_orbit,
    law_at,
    switched,
)
from gearlash.jobs import Execution
from gearlash.jobs.stop import interruptible
from gearlash.orbits import Orbit, attractor
from gearlash.results import Point
from gearlash.system import Family, GearlashError, given, plain_values

from .arguments import checked_execution, checked_settings
from .beginning import member_of, orbit_of
from .following import Following, checked_steps
from .limits import Limits
from .model import Model, Source

Start = Orbit | Point | BranchPoint | SpecialPoint
STARTS = (Orbit, Point, BranchPoint, SpecialPoint)


def continue_branch(
    model: Model,
    name: str,
    start: Orbit | Point | BranchPoint | SpecialPoint | None = None,
    *,
    lower: float | str,
    upper: float | str,
    values: Mapping[str, float | str] | None = None,
    steps: ContinuationSettings | None = None,
    execution: Execution | None = None,
) -> Branch:
    """The branch of periodic orbits through one orbit, in one parameter.

    Stable and unstable orbits alike are followed by pseudo-arclength continuation, round folds and through
    grazing. Folds, doublings, Neimark-Sacker points, branch points and grazings are solved for.

    Parameters
    ----------
    model : Case or Family
    name : str
        The parameter, such as ``omega``; of a case also as in its file, such as ``pinion_speed``.
    start : Orbit, Point, BranchPoint or SpecialPoint, optional
        The orbit to begin with; without it, the motion from the cold start at ``values``. A `SpecialPoint`
        brings all parameters with it, so it may be one of a branch in another parameter. A `Point` or a
        `BranchPoint` brings the value of one parameter; it is taken for this one, unless the orbit is one at
        ``values``, which then need this one, too. An `Orbit` is one at ``values``.
    lower, upper : float or str
        Limits of the parameter; of a case also with a unit, such as ``"3000 rpm"``. The start lies between.
    values : mapping of str to float or str, optional
        Of the parameters, over the model's own.
    steps : ContinuationSettings, optional
    execution : Execution, optional
        Its ``progress`` hears of every orbit; how many there will be nobody knows. Once its ``cancel`` is
        set, the branch ends there, and says so. A branch is not split: its executor is not used.

    Returns
    -------
    Branch
        Its values are dimensionless, by short name.

    Raises
    ------
    GearlashError
        For a name that is no parameter, a start that is not periodic or of another member, or a period of
        more than 64 base periods.

    References
    ----------
    H. B. Keller, Numerical solution of bifurcation and nonlinear eigenvalue problems (1977). E. Allgower and
    K. Georg, Introduction to Numerical Continuation Methods (2003), doi:10.1137/1.9780898719154.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> branch = gl.continue_branch(family, "omega", lower=0.5, upper=1.6, values={"omega": 1.5})
    >>> for special in branch.special:
    ...     print(f"{special.kind} at {special.value:.6f}")
    grazing at 0.820631
    fold at 0.828464
    fold at 0.708032
    grazing at 1.407088
    """
    source = Source.of(model)
    family, numbers = source.family(), plain_values(model, source.family(), values)
    limits, steps = Limits.read(model, family, given.word("name", name), lower, upper), checked_steps(steps)
    short = limits.short
    if start is not None and not isinstance(start, Orbit):
        given.instance("start", start, STARTS, "an Orbit, a Point of a study, or a point of a branch")
        numbers = member_of(family, numbers, short, start)
    complete = family.complete(numbers)
    listener = Following(checked_execution(source, execution))
    orbit = None if start is None else orbit_of(family, complete, short, start)
    limits.check(complete[short])
    orbit = _from_cold(family, complete) if orbit is None else orbit
    return _followed(family, complete, limits, orbit, steps, listener)


def switch_branch(
    model: Model,
    branch: Branch,
    special: SpecialPoint,
    *,
    steps: ContinuationSettings | None = None,
    execution: Execution | None = None,
) -> tuple[Branch, ...]:
    """The branches of periodic orbits that meet another one at a special point of it.

    Parameters
    ----------
    model : Case or Family
        That of the branch.
    branch : Branch
    special : SpecialPoint
        One of its doublings or branch points, or where it joins the orbit of half its period.
    steps : ContinuationSettings, optional
    execution : Execution, optional
        As of `continue_branch`.

    Returns
    -------
    tuple of Branch
        Between the same limits; empty where none was found near by.

    Raises
    ------
    GearlashError
        For a kind of point at which no branch of periodic orbits begins.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("article")
    >>> six = gl.continue_branch(case, "D", lower=0.35, upper=0.37, values={"omega": 0.78, "D": 0.365})
    >>> (twelve,) = gl.switch_branch(case, six, six.of_kind("doubling")[0])
    >>> print(twelve.points[0].label)
    12-12-3
    """
    source = Source.of(model)
    family = source.family()
    given.instance("branch", branch, Branch, "a Branch, as from gearlash.continue_branch")
    given.instance("special", special, SpecialPoint, "one of branch.special")
    steps, listener = checked_steps(steps), Following(checked_execution(source, execution))
    limits = Limits(branch.name, branch.lower, branch.upper)
    return tuple(
        _followed(family, {**branch.values, branch.name: one.value}, limits, one.orbit, steps, listener)
        for one in switched(family, branch, special)
    )


def grazing_law(model: Model, branch: Branch, special: SpecialPoint) -> GrazingLaw:
    """How the multipliers of a branch move at a touch, predicted from the field.

    Parameters
    ----------
    model : Case or Family
        That of the branch.
    branch : Branch
    special : SpecialPoint
        One of its grazings.

    Returns
    -------
    GrazingLaw
        λ0 + c √d for every multiplier, the next fold or doubling by the law and as computed, and whether the
        conditions of the law hold.

    Raises
    ------
    GearlashError
        For a point that is no grazing, or one from the gap under `no-tension`, which has no such law.

    References
    ----------
    M. di Bernardo, C. Budd, A. Champneys, Physica D 160 (2001) 222, doi:10.1016/S0167-2789(01)00349-9.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> branch = gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5})
    >>> low = min(branch.of_kind("grazing"), key=lambda special: special.value)
    >>> law = gl.grazing_law(case, branch, low)
    >>> law.generic, law.predicted_kind.value
    (True, 'fold')
    """
    family = Source.of(model).family()
    given.instance("branch", branch, Branch, "a Branch, as from gearlash.continue_branch")
    given.instance("special", special, SpecialPoint, "one of branch.special")
    return law_at(family, branch, special)


def _followed(
    family: Family,
    values: Mapping[str, float],
    limits: Limits,
    orbit: Orbit,
    steps: ContinuationSettings,
    listener: Following,
) -> Branch:
    interval = limits.short, orbit, limits.lower, limits.upper
    return continue_orbit(family, values, *interval, steps, listener.tell, listener.stop)


def _from_cold(family: Family, values: Mapping[str, float]) -> Orbit:
    props = flow.propagators(family.system(values))
    with interruptible():
        found = attractor(props, family.start(values), checked_settings(None))
    if not isinstance(found, Orbit):
        raise GearlashError(f"the motion from the cold start is {found.label}, not periodic: give a start")
    return found
