"""Curves of special orbits of a case or a family, in a plane of two parameters."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from gearlash import flow
from gearlash.branches.continuation import Branch, ContinuationSettings, SpecialKind, SpecialPoint
from gearlash.branches.curves import (
    CodimTwoPoint,
    Curve,
    CurvePoint,
    Listener,
    Plane,
    beginning,
    curve_through,
)
from gearlash.flow import Propagators
from gearlash.jobs import Execution
from gearlash.system import CARRIED, Family, GearlashError, given, plain_values

from .arguments import checked_execution
from .following import Following, checked_steps
from .limits import Limits
from .model import Model, Source

STARTS = (SpecialPoint, CodimTwoPoint, CurvePoint)
SAME_STATE = 1e-6  # of the largest state: how well the orbit of a start must close

Pair = tuple[float | str, float | str]
"""One value of each of the two parameters."""


def continue_curve(
    model: Model,
    names: tuple[str, str],
    special: SpecialPoint | CodimTwoPoint | CurvePoint,
    *,
    lower: Pair,
    upper: Pair,
    values: Mapping[str, float | str] | None = None,
    branch: Branch | None = None,
    kind: SpecialKind | str | None = None,
    touch: int = 0,
    doubled: bool = False,
    steps: ContinuationSettings | None = None,
    execution: Execution | None = None,
) -> Curve:
    """The curve of grazing, fold, doubling or Neimark-Sacker orbits through one of them, in two parameters.

    On it the itinerary is frozen: the extremum that grazes is not treated as a crossing, so that the
    equations are smooth. Whether the orbits are ones of the real system is looked at on every one of them.
    Where a curve of folds, doublings or Neimark-Sacker points meets a grazing it is begun anew on the other
    side of it. Points at which two things happen at once are solved for.

    Parameters
    ----------
    model : Case or Family
    names : tuple of str
        Two parameters, such as ``("omega", "D")``; of a case also as in its file.
    special : SpecialPoint, CodimTwoPoint or CurvePoint
        Of a branch (also one from a file), or of a curve.
    lower, upper : tuple of float or str
        Limits of the two parameters; of a case also with units.
    values : mapping of str to float or str, optional
        At which the special point was found, over the model's own. The value that a point of a branch brings
        with it is taken for the first of ``names`` that makes it an orbit, those of a point of a curve for
        both.
    branch : Branch, optional
        That of the special point: it tells all values.
    kind : SpecialKind or str, optional
        Which curve, where several meet in a point of a curve: grazing where nothing is said and something
        touches there.
    touch : int, default 0
        Which of the extrema that touch there stays in touch, where there are two. At the corner of a
        contact-only orbit 1 is the other grazing curve that crosses there.
    doubled : bool, default False
        Where an orbit grazes with a multiplier -1: the curve on which the orbit of twice its period grazes.
    steps : ContinuationSettings, optional
        Lengths in scaled unknowns: 1 is the width of the limits, or as far as the states move.
    execution : Execution, optional
        Its progress hears how many orbits there are, its cancel ends the curve where it is.

    Returns
    -------
    Curve

    Raises
    ------
    GearlashError
        For names that are no two parameters, a start of another member, or one at which no curve begins.

    References
    ----------
    M. di Bernardo, C. Budd, A. Champneys, P. Kowalczyk, Piecewise-smooth Dynamical Systems (2008), ch. 8,
    doi:10.1007/978-1-84628-708-4. Yu. A. Kuznetsov, Elements of Applied Bifurcation Theory (2004), ch. 10,
    doi:10.1007/978-1-4757-3978-7.

    Examples
    --------
    >>> import gearlash as gl
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> branch = gl.continue_branch(family, "omega", lower=0.7, upper=1.6, values={"omega": 1.5})
    >>> fold = branch.of_kind("fold")[-1]
    >>> curve = gl.continue_curve(family, ("omega", "D"), fold, lower=(0.6, 0.13), upper=(0.8, 1.1))
    >>> for special in curve.special:
    ...     print(special.kind, [round(value, 9) for value in special.values])
    grazing with a multiplier 1 [0.708031619, 0.145906155]
    """
    source = Source.of(model)
    family = source.family()
    limits = limits_of(model, family, names, lower, upper)
    given.instance("special", special, STARTS, "one of branch.special, or a point of a Curve")
    numbers = dict(plain_values(model, family, values))
    if branch is not None:
        branch = given.instance("branch", branch, Branch, "a Branch, as from gearlash.continue_branch")
        brought = {branch.name: special.value} if isinstance(special, SpecialPoint) else {}
        numbers = {**branch.values, **brought, **numbers}
    chosen = None if kind is None else given.choice(SpecialKind, "kind", kind)
    touch, doubled = given.whole("touch", touch, 0), given.truth("doubled", doubled)
    steps, following = checked_steps(steps), Following(checked_execution(source, execution))
    complete = _values(family, family.complete(numbers), (limits[0].short, limits[1].short), special)
    for limit in limits:
        limit.check(complete[limit.short])
    plane = Plane(
        family,
        complete,
        (limits[0].short, limits[1].short),
        (limits[0].lower, limits[1].lower),
        (limits[0].upper, limits[1].upper),
    )
    place = np.array([complete[name] for name in plane.names])
    begun = beginning(plane, special, place, chosen, touch, doubled)
    return curve_through(begun, steps, Listener(following.tell, following.stop))


def limits_of(
    model: Model, family: Family, names: tuple[str, str], lower: Pair, upper: Pair
) -> tuple[Limits, Limits]:
    """Of both parameters. Raises `GearlashError` for what are none."""
    names = _pair("names", names, "two names of parameters")
    lower, upper = _pair("lower", lower, "two limits"), _pair("upper", upper, "two limits")
    one, two = (
        Limits.read(model, family, given.word("name", name), low, high)
        for name, low, high in zip(names, lower, upper, strict=True)
    )
    if one.short == two.short:
        raise GearlashError(f"names: {names[0]} and {names[1]} are one parameter, {one.short}")
    return one, two


def _pair(name: str, pair: object, expected: str) -> tuple:
    if not isinstance(pair, tuple | list) or len(pair) != 2:
        raise GearlashError(f"{name}: expected {expected}, got {given.kind_of(pair)}")
    return tuple(pair)


def _values(
    family: Family,
    values: dict[str, float],
    names: tuple[str, str],
    special: SpecialPoint | CodimTwoPoint | CurvePoint,
) -> dict[str, float]:
    """With the values that the point brings with it, as far as they make it an orbit."""
    if isinstance(special, SpecialPoint):
        brought = [{name: special.point.value} for name in names]
    else:
        brought = [dict(zip(names, special.values, strict=True))]
    point = special if isinstance(special, CurvePoint) else special.point
    for each in (*brought, {}):
        tried = {**values, **each}
        if _closes(flow.propagators(family.system(tried)), point.state, point.period):
            return tried
    at = ", ".join(f"{each} = {values[each]:.10g}" for each in values)
    raise GearlashError(
        f"special: it is no periodic motion at {at}. Expected one that was found there: give the branch that "
        "it is of, or as values all other parameters that it was found at"
    )


def _closes(props: Propagators, state: np.ndarray, period: int) -> bool:
    if state.shape != (props.system.size,):
        return False
    end = flow.carry(props, state, float(period))
    largest = max(float(np.abs(state).max()), 1e-300)
    return end.status in CARRIED and float(np.abs(end.state - state).max()) <= SAME_STATE * largest
