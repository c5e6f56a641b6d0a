"""Following one motion away from where it was found, to its first grazing."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Literal

from gearlash.branches.continuation import (
    EndKind,
    EndOfBranch,
    Item,
    Node,
    SpecialKind,
    SpecialPoint,
    walk,
)
from gearlash.jobs.stop import interruptible
from gearlash.orbits import Settings
from gearlash.results import Direction, Point
from gearlash.results.followed import INTERRUPTED, FollowedPath, PassedBifurcation
from gearlash.system import Family, GearlashError, Label, MotionKind, given, plain_values, short_name

from .arguments import checked_settings
from .beginning import orbit_of, value_of
from .model import Model, Source
from .transition import kind_of

REACH = 0.95  # as far as it is followed, relative to the value at the start
SMALL = 1e-3  # what counts as the size of a small value
BEYOND = 1e-3  # how far beyond a touch the orbit is looked after, relative to that value
PARTS = 1000  # of one direction, for the progress
MET = {SpecialKind.DOUBLING: "its period doubles", SpecialKind.FOLD: "it ends in a fold"}
"""What happens to an orbit beyond its touch, in words."""


def first_grazing(
    model: Model,
    name: str,
    start: Point,
    direction: Literal["down", "up"],
    *,
    values: Mapping[str, float | str] | None = None,
    settings: Settings | None = None,
    tell: Callable[[int, int], object] | None = None,
) -> tuple[FollowedPath, SpecialPoint | None]:
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
    touch : SpecialPoint or None
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
    orbit, to = orbit_of(family, others, name, start), _last(family, name, start.value, direction)
    items = walk(family, others, name, orbit, to, longest=settings.max_period)
    way = _Way(direction, start.value)
    try:
        with interruptible():
            for item in items:
                way.read(item, family, name)
                if tell is not None and isinstance(item, Node) and to != start.value:
                    tell(round(PARTS * abs(item.value - start.value) / abs(to - start.value)), PARTS)
                if way.touch is not None:
                    farthest = _last(family, name, way.touch.value, direction)
                    way.beyond = _beyond(items, way.touch.value, farthest)
                    break
    except KeyboardInterrupt:
        if way.touch is None:
            way.ended = INTERRUPTED, False
        else:
            way.beyond = INTERRUPTED
    return way.path, way.touch


@dataclass(eq=False)
class _Way:
    """How far a motion was followed, and what it met up to its first grazing."""

    direction: Literal["down", "up"]
    reached: float
    touch: SpecialPoint | None = None
    beyond: str = ""
    ended: tuple[str, bool] = ("", False)
    passed: list[PassedBifurcation] = field(default_factory=list)
    met: SpecialPoint | None = None

    @property
    def path(self) -> FollowedPath:
        ended, decided = self.ended
        return FollowedPath(self.direction, self.reached, ended, decided, self.beyond, tuple(self.passed))

    def read(self, item: Item, family: Family, name: str) -> None:
        if self.met is not None:  # it is told with the label that comes behind it
            self.passed.append(_passed(self.met, _label_before(item), self.direction))
            self.met = None
        if isinstance(item, Node):
            self.reached = item.value
        elif isinstance(item, EndOfBranch):
            self.ended = _ended(item, family, name)
            self.reached = item.value
        elif item.is_grazing:
            self.touch, self.reached = item, item.value
            self.ended = f"grazing at {item.value:.10g}", True
        else:
            self.met = item


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


def _last(family: Family, name: str, value: float, direction: str) -> float:
    """The end of the search: of its reach, or of the range of the parameter."""
    parameter = next(p for p in family.parameters if p.name == name)
    reach = REACH * (max(abs(value), SMALL) if value != 0.0 else 1.0)
    return min(value + reach, parameter.upper) if direction == "up" else max(value - reach, parameter.lower)


def _ended(end: EndOfBranch, family: Family, name: str) -> tuple[str, bool]:
    """Why the motion was not followed further, and whether that is the end of it, or of the search."""
    if end.kind is EndKind.ARRIVED:
        parameter = next(p for p in family.parameters if p.name == name)
        at_limit = end.value in (parameter.lower, parameter.upper)
        return ("end of the range of the parameter" if at_limit else "end of the search"), True
    if end.kind is EndKind.PERIOD:
        return f"at {end.value:.10g} {end.kind} (--max-period)", False
    if end.kind in (EndKind.UNBUILT, EndKind.SHORT, EndKind.POINTS):
        return f"{end.kind}: {end.note}", False
    return f"at {end.value:.10g} {end.kind}", True


def _label_before(item: Item) -> Label:
    """Of the motion that leads up to an item."""
    if isinstance(item, EndOfBranch):
        return MotionKind.NONE
    return item.label if isinstance(item, Node) else item.label_before


def _passed(point: SpecialPoint, after: Label, direction: str) -> PassedBifurcation:
    below, above = (point.label_before, after) if direction == "up" else (after, point.label_before)
    return PassedBifurcation(kind_of(point), point.value, below, above)


def _beyond(items: Iterator[Item], touch: float, farthest: float) -> str:
    """What the orbit does just beyond its touch."""
    enough = min(BEYOND * max(abs(touch), SMALL), abs(farthest - touch))
    followed = f"followed to {touch + (enough if farthest > touch else -enough):.7g}"
    label: Label | None = None
    for item in items:
        if isinstance(item, SpecialPoint) and item.is_grazing:
            return f"{item.label_before} goes on to the next grazing, at {item.value:.10g}"
        if isinstance(item, SpecialPoint):
            what = MET.get(item.kind, str(item.kind))
            return f"{item.label_before} goes on to {item.value:.10g}, where {what}"
        if isinstance(item, EndOfBranch):
            if item.kind is EndKind.ARRIVED:
                return f"{label} goes on ({followed})" if label is not None else ""
            return (
                str(item.kind)
                if label is None
                else f"{label} goes on to {item.value:.10g}, where {item.kind}"
            )
        label = item.label
        if abs(item.value - touch) >= enough:
            return f"{label} goes on ({followed})"
    return ""
