"""The zone around an operating point in a plane of two parameters, bounded by curves that are solved for."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash import flow
from gearlash.branches.continuation import SpecialPoint
from gearlash.branches.curves import Plane
from gearlash.jobs import Execution
from gearlash.jobs.stop import interruptible
from gearlash.orbits import Orbit, Settings, attractor
from gearlash.system import Family, GearlashError, given, plain_values

from .arguments import checked_execution, checked_settings, checked_start
from .curve import Pair as Typed
from .curve import limits_of
from .following import Following
from .limits import Limits
from .model import Model, Source
from .plane_zone import AxisMargin, PlaneZone
from .zone_end import RANGE, Quiet
from .zone_lines import STOPPED, Line, Seen
from .zone_nearest import BOX, ELLIPSE, Nearest
from .zone_search import Search

Array = NDArray[np.float64]


def plane_zone(
    model: Model,
    names: tuple[str, str],
    *,
    lower: Typed,
    upper: Typed,
    quiet: Quiet | str = Quiet.IMPACT_FREE,
    values: Mapping[str, float | str] | None = None,
    tolerances: Mapping[str, float | str] | None = None,
    start: ArrayLike | None = None,
    lines: int = 4,
    settings: Settings | None = None,
    execution: Execution | None = None,
) -> PlaneZone:
    """The quiet zone around an operating point in a plane of two parameters, and margins to its boundary.

    The orbit of the operating point is followed along both parameters, along more lines of the plane from
    there, and along the edges of the rectangle, as long as it is quiet and stable. Through every end of these
    the curve of grazings, folds, doublings or Neimark-Sacker points is followed; where two things happen at
    once on it the curve that takes over is begun there. So the boundary is put together of curves whose
    points are solved for, not of pixels.

    Parameters
    ----------
    model : Case or Family
    names : tuple of str
        Two parameters, such as ``("omega", "D")``; of a case also as in its file.
    lower, upper : tuple of float or str
        The rectangle; of a case also with units.
    quiet : Quiet or str
        What counts as quiet: "impact-free" or "drive-side-only".
    values : mapping of str to float or str, optional
        The operating point and all else, over the model's own values.
    tolerances : mapping of str to float or str, optional
        Of both parameters, by the names they are asked for with: how far each may lie beside its value.
    start : array_like of shape (n,), optional
        State at phase zero that leads to the orbit at the operating point; the cold start without.
    lines : int
        How many more lines are followed across each parameter.
    settings : Settings, optional
        How the attractor at the operating point is looked for.
    execution : Execution, optional
        Its progress hears how many orbits there are, its cancel ends the search with what it has.

    Returns
    -------
    PlaneZone

    Raises
    ------
    GearlashError
        For arguments that do not fit, and where the motion at the operating point is not quiet, stable and
        periodic.

    References
    ----------
    M. di Bernardo, C. Budd, A. Champneys, P. Kowalczyk, Piecewise-smooth Dynamical Systems (2008), ch. 8,
    doi:10.1007/978-1-84628-708-4.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> zone = gl.plane_zone(
    ...     case, ("omega", "load"), lower=(0.78, 0.095), upper=(0.85, 0.105), values={"omega": 0.81},
    ...     tolerances={"omega": 0.005, "load": 0.002}, lines=0,
    ... )
    >>> box, ellipse = zone.tolerance_margins
    >>> print(zone.label, zone.complete, round(box.multiple, 3), round(ellipse.multiple, 3))
    1-0-0 True 1.35 1.846
    """
    source = Source.of(model)
    family = source.family()
    limits, quiet = limits_of(model, family, names, lower, upper), given.choice(Quiet, "kind of zone", quiet)
    complete = family.complete(plain_values(model, family, values))
    for limit in limits:
        limit.check(complete[limit.short])
    wide = _tolerances(model, family, limits, tolerances)
    lines, begin = given.whole("lines", lines, 0), checked_start(family, start)
    following = Following(checked_execution(source, execution))
    orbit = _orbit_at(family, complete, quiet, begin, checked_settings(settings))
    short = (limits[0].short, limits[1].short)
    low, high = (limits[0].lower, limits[1].lower), (limits[0].upper, limits[1].upper)
    plane = Plane(family, complete, short, low, high)
    at = np.array([complete[name] for name in short])
    found = Search(plane, quiet, Seen(at, orbit.state, orbit.shot.period), lines, following)
    found.run()
    margins = tuple(_margin(model, plane, at, line) for line in found.axes)
    outline, holes, parts, notes = found.borders()
    nearest = [] if wide is None else [Nearest(plane, at, wide).of(norm, parts) for norm in (BOX, ELLIPSE)]
    return PlaneZone(
        names=short,
        at=(float(at[0]), float(at[1])),
        lower=low,
        upper=high,
        quiet=quiet,
        label=orbit.signature,
        values=complete,
        parts=tuple(part.bound for part in parts),
        outline=outline,
        holes=holes,
        margins=margins,
        tolerance_margins=tuple(nearest),
        tolerances=() if wide is None else (float(wide[0]), float(wide[1])),
        lines=len(found.lines),
        followed=np.array([seen.place for line in found.lines for seen in line.seen]),
        complete=not notes,
        notes=(*notes, *found.remarks),
    )


def _tolerances(
    model: Model, family: Family, limits: tuple[Limits, Limits], tolerances: Mapping[str, float | str] | None
) -> Array | None:
    if tolerances is None:
        return None
    plain = plain_values(model, family, tolerances)
    short = [limit.short for limit in limits]
    if set(plain) != set(short):
        raise GearlashError(
            f"tolerances: expected those of {short[0]} and {short[1]}, got {', '.join(plain)}"
        )
    found = np.array([plain[name] for name in short])
    if not (np.isfinite(found) & (found > 0.0)).all():
        raise GearlashError("tolerances: expected positive numbers")
    return found


def _orbit_at(
    family: Family, values: Mapping[str, float], quiet: Quiet, start: Array | None, settings: Settings
) -> Orbit:
    props = flow.propagators(family.system(values))
    with interruptible():
        found = attractor(props, family.start(values) if start is None else start, settings)
    if not isinstance(found, Orbit):
        raise GearlashError(f"the motion at the operating point is {found.label}: expected a periodic one")
    if not quiet.holds_signature(found.signature):
        raise GearlashError(f"the motion at the operating point is {found.signature}, which is not {quiet}")
    return found


def _margin(model: Model, plane: Plane, at: Array, line: Line) -> AxisMargin:
    axis, name, end = line.axis, plane.names[line.axis], line.end
    here, there = float(at[axis]), float(end.place[axis])
    special = end.special
    event = RANGE if end.at_limit else end.reason if special is None else event_of(special)
    physical = getattr(model, "physical", None)
    units = () if physical is None else physical(name, np.array([here, there]))
    return AxisMargin(
        name=name,
        upward=line.upward,
        distance=abs(there - here),
        percent=100.0 * abs(there - here) / abs(here) if here else np.inf,
        value=there,
        event=event,
        bounded=not end.at_limit and end.reason != STOPPED,
        physical=tuple(
            (path.rpartition(".")[2], float(abs(both[1] - both[0])), unit) for path, both, unit in units
        ),
        point=special,
    )


def event_of(special: SpecialPoint) -> str:
    """What happens there, in words."""
    return f"{special.kind}, {special.note}" if special.is_grazing else str(special.kind)
