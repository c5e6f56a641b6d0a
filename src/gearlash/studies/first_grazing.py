"""Following one motion away from where it was found, to its first grazing."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Literal

from gearlash.branches import BifurcationPoint, GrazingPoint, Outcome, Passage, PathEnd, follow
from gearlash.jobs.stop import interruptible
from gearlash.orbits import Settings
from gearlash.results import Direction, Point
from gearlash.results.followed import INTERRUPTED, FollowedPath, PassedBifurcation
from gearlash.system import Family, GearlashError, MotionKind, given, plain_values, short_name

from .arguments import checked_settings
from .beginning import orbit_of, value_of
from .model import Model, Source

REACH = 0.95  # as far as it is followed, relative to the value at the start
SMALL = 1e-3  # what counts as the size of a small value
BEYOND = 1e-3  # how far beyond a touch the orbit is looked after, relative to that value
PARTS = 1000  # of one direction, for the progress


def first_grazing(
    model: Model,
    name: str,
    start: Point,
    direction: Literal["down", "up"],
    *,
    values: Mapping[str, float | str] | None = None,
    settings: Settings | None = None,
    tell: Callable[[int, int], object] | None = None,
) -> tuple[FollowedPath, GrazingPoint | None]:
    """Follows one periodic motion in one parameter, through doublings, until a contact is born or dies.

    Parameters
    ----------
    model : Case or Family
    name : str
        Parameter to follow in, such as ``omega``; a case knows it by a physical name, too.
    start : Point
        A periodic motion and the value of ``name`` at which it was found: ``gearlash.point(model, values,
        name=name)``, or a point of a sweep.
    direction : {"down", "up"}
    values : mapping of str to float or str, optional
        Other parameters than ``name``; the model's own where nothing is given.
    settings : Settings, optional
        Its ``max_period`` is the longest period (base periods) that is followed through doublings.
    tell : callable, optional
        Hears how much of the way is done, out of how much. Ctrl-C ends the search with what it has.

    Returns
    -------
    path : FollowedPath
        How far the motion was followed and why not farther. The way ends 95 % of the value away from it, or
        at the end of the parameter's range.
    touch : GrazingPoint or None
        The first grazing on this way, solved for.

    Raises
    ------
    GearlashError
        For a name that is no parameter, a start that is not periodic, or a member that cannot be built.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("article")
    >>> start = gl.point(case, {"omega": 1.0}, name="omega")
    >>> path, touch = gl.first_grazing(case, "omega", start, "down")
    >>> round(touch.value, 4), path.ended
    (0.9725, 'grazing at 0.9724999996')
    """
    family, name, others = _checked(model, name, start, values)
    direction, settings = _way(direction), checked_settings(settings)
    if tell is not None:
        given.function("tell", tell, "a function of two whole numbers")
    to, reached = _last(family, name, start.value, direction), start.value
    way, passed = abs(to - start.value), []
    found: Passage | None = None

    def hear(value: float) -> None:
        nonlocal reached
        reached = value
        if tell is not None:
            tell(round(PARTS * abs(value - start.value) / way), PARTS)

    beyond = ""
    try:
        with interruptible():
            for step in _steps(family, others, name, start, to, hear, settings):
                if isinstance(step, PathEnd):
                    ended, decided = _ended(step, family, name)
                    return FollowedPath(direction, step.last.value, ended, decided, "", tuple(passed)), None
                if isinstance(step.point, GrazingPoint):
                    found = step
                    beyond = _beyond(family, others, name, step, direction)
                    break
                passed.append(_passed(step.point, step, direction))
    except KeyboardInterrupt:
        if found is None:
            return FollowedPath(direction, reached, INTERRUPTED, False, "", tuple(passed)), None
        beyond = INTERRUPTED
    assert found is not None  # what is followed ends with a PathEnd
    assert isinstance(found.point, GrazingPoint)
    ended = f"grazing at {found.value:.10g}"
    return FollowedPath(direction, found.value, ended, True, beyond, tuple(passed)), found.point


def _checked(
    model: Model, name: str, start: Point, values: Mapping[str, float | str] | None
) -> tuple[Family, str, dict[str, float]]:
    """The family, the short name of the parameter, and the values of all parameters at the start."""
    family = Source.of(model).family()
    name = short_name(model, family, name)
    given.instance("start", start, Point, "a point, as from gearlash.point(model, values, name=...)")
    if not start.periodic:
        raise GearlashError(f"start: expected a periodic motion, not one of status {start.status}")
    return family, name, family.complete({**plain_values(model, family, values), name: value_of(start, name)})


def _way(direction: str) -> Literal["down", "up"]:
    expected = "down or up"
    found = given.choice(Direction, "direction", direction)
    if found is Direction.COLD:
        raise GearlashError(f"direction = 'cold': expected {expected}")
    return "up" if found is Direction.UP else "down"


def _steps(
    family: Family,
    values: Mapping[str, float],
    name: str,
    start: Point,
    to: float,
    hear: Callable[[float], object],
    settings: Settings,
) -> Iterator[Passage | PathEnd]:
    """The way from a point of a study."""
    orbit = orbit_of(family, values, name, start)
    yield from follow(family, name, orbit, to, values=values, tell=hear, longest=settings.max_period)


def _last(family: Family, name: str, value: float, direction: str) -> float:
    """The end of the search: of its reach, or of the range of the parameter."""
    parameter = next(p for p in family.parameters if p.name == name)
    reach = REACH * (max(abs(value), SMALL) if value != 0.0 else 1.0)
    return min(value + reach, parameter.upper) if direction == "up" else max(value - reach, parameter.lower)


def _ended(end: PathEnd, family: Family, name: str) -> tuple[str, bool]:
    """Why the motion was not followed further, and whether that is the end of it, or of the search."""
    if end.outcome is Outcome.ARRIVED:
        parameter = next(p for p in family.parameters if p.name == name)
        at_limit = end.last.value in (parameter.lower, parameter.upper)
        return ("end of the range of the parameter" if at_limit else "end of the search"), True
    if end.outcome is Outcome.PERIOD:
        return f"at {end.beyond:.10g} {end.outcome} (--max-period)", False
    if end.outcome in (Outcome.UNBUILT, Outcome.LOST):
        return f"{end.outcome}: {end.reason}", False
    return f"at {end.beyond:.10g} {end.outcome}", True


def _passed(point: BifurcationPoint, met: Passage, direction: str) -> PassedBifurcation:
    before, after = met.before.label, met.after.label if met.after else MotionKind.NONE
    below, above = (before, after) if direction == "up" else (after, before)
    return PassedBifurcation("doubling" if point.multiplier < 0 else "fold", point.value, below, above)


def _beyond(family: Family, values: Mapping[str, float], name: str, met: Passage, direction: str) -> str:
    """What the orbit does just beyond its touch."""
    if met.after is None:
        return str(Outcome.TOUCH)
    node, sign = met.after, 1.0 if direction == "up" else -1.0
    farthest = _last(family, name, met.value, direction)
    to = met.value + sign * min(BEYOND * max(abs(met.value), SMALL), abs(farthest - met.value))
    if sign * (to - node.value) <= 0.0:
        return ""
    step = next(follow(family, name, node.orbit, to, values={**values, name: node.value}))
    if isinstance(step, Passage):
        if isinstance(step.point, GrazingPoint):
            return f"{node.label} goes on to the next grazing, at {step.value:.10g}"
        what = "its period doubles" if step.point.multiplier < 0 else "it ends in a fold"
        return f"{node.label} goes on to {step.value:.10g}, where {what}"
    if step.outcome is Outcome.ARRIVED:
        return f"{node.label} goes on (followed to {to:.7g})"
    return f"{node.label} goes on to {step.last.value:.10g}, where {step.outcome}"
