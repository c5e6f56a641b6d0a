"""Stable zones: where every motion that was found runs without impacts, or without impacts on the back side.

Every motion found is followed along its whole branch; its stable arcs say where it lives, and the special
points at their ends are the ends of zones. So a coarse axis gives the same ends as a fine one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.jobs import Execution
from gearlash.orbits import Settings
from gearlash.results import Axis, Sweep
from gearlash.system import GearlashError, given

from .arguments import checked_execution, checked_settings, checked_start, checked_values
from .follow_tasks import Question
from .followed import PASSES, Followed
from .found_zones import Found
from .model import Model, Source
from .named import plain_axis
from .scanned import check_sweeps
from .seen import Onsets
from .sweep import sweeps
from .work import Changes, Work
from .zone import Zones
from .zone_end import Quiet

FEWEST = 2  # values of an axis


def zones(
    model: Model,
    axis: Axis,
    quiet: Quiet | str = Quiet.IMPACT_FREE,
    *,
    values: Mapping[str, float | str] | None = None,
    known: Sequence[Sweep] | None = None,
    start: ArrayLike | None = None,
    settings: Settings | None = None,
    execution: Execution | None = None,
) -> Zones:
    """Intervals of a parameter with quiet motion, their ends solved for, and what coexists in them.

    Motions are looked for by cold, up and down sweeps, and from just beyond the ends of those found. Each
    periodic one is followed once along its whole branch, stable or not, with its doublings. A zone counts
    where every attractor found is quiet; intervals where only some are come beside it. Their ends are special
    points of branches: grazings, folds, doublings, Neimark-Sacker points. Motion that is not periodic has no
    branch: it begins where the periodic motion beside it in its sweep loses its stability, or was seen at
    values of the axis only; then the interval between two of them is halved to 1e-4 of the value.

    Parameters
    ----------
    model : Case or Family
    axis : Axis
        At least two values.
    quiet : Quiet or str
        What counts as quiet: "impact-free" or "drive-side-only".
    values : mapping of str to float or str, optional
        Other parameters than the axis, over those of the model.
    known : sequence of Sweep, optional
        Sweeps made before, of this model, axis, ``values``, ``start`` and ``settings``; without them a cold,
        an up and a down sweep are computed.
    start : array_like of shape (n,), optional
        State at phase zero that the sweeps start from; the cold start without.
    settings : Settings, optional
        How attractors are looked for.
    execution : Execution, optional
        How the work is carried out. Its progress counts points of the sweeps, then branches.

    Returns
    -------
    Zones

    Raises
    ------
    GearlashError
        For arguments that do not fit, and for sweeps of another question.

    Examples
    --------
    >>> import gearlash as gl
    >>> axis = gl.Axis.even("omega", 0.6, 0.9, 4)
    >>> found = gl.zones(gl.load_case("kahraman-singh"), axis)
    >>> [(round(zone.upper.value, 4), zone.upper.kind) for zone in found.zones]
    [(0.708, 'fold')]
    """
    return zones_of_kinds(
        model, axis, [quiet], values=values, known=known, start=start, settings=settings, execution=execution
    )[0]


def zones_of_kinds(
    model: Model,
    axis: Axis,
    kinds: Sequence[Quiet | str],
    *,
    values: Mapping[str, float | str] | None = None,
    known: Sequence[Sweep] | None = None,
    start: ArrayLike | None = None,
    settings: Settings | None = None,
    execution: Execution | None = None,
    thrown: Sequence[tuple[NDArray[np.float64], Sweep]] = (),
    work: int | None = None,
    assure: bool = True,
) -> tuple[Zones, ...]:
    """The same of several kinds from the same sweeps and branches.

    ``thrown`` are more sweeps made before, each with the state that all of its points start from: what they
    find counts as what ``known`` found.
    Where ``work`` is given no more of it is spent on following (units of `work.Work`), first on motions that
    matter most. What is left out counts where sweeps saw it, and `Zones.left_out` says how much that is.
    Without ``assure`` nothing is assured between computed orbits (`ZoneMotion.assured`)."""
    source = Source.of(model)
    family = source.family()
    wanted, settings = [given.choice(Quiet, "kind of zone", k) for k in kinds], checked_settings(settings)
    axis = plain_axis(model, family, axis)
    fixed, begin = checked_values(model, family, values, [axis]), checked_start(family, start)
    execution = checked_execution(source, execution)
    if len(axis) < FEWEST:
        raise GearlashError(f"zones along {axis.name}: expected at least two values")
    ways = None if known is None else given.instances("known", known, Sweep, "sweeps made before")
    if ways is None:
        ways = sweeps(model, axis, values=fixed, start=begin, settings=settings, execution=execution)
    starts_of = {id(sweep): state for state, sweep in thrown}
    ways = [*ways, *(sweep for _, sweep in thrown)]
    check_sweeps(ways, axis, fixed)
    low, high = float(axis.values[0]), float(axis.values[-1])
    question = Question(source, tuple(fixed.items()), axis.name, low, high, settings)
    followed, starts = branches_found(ways, question, execution, work)
    found = Found(model, axis, tuple(ways), followed, Onsets(followed, begin, starts_of), starts, assure)
    return tuple(found.zones(quiet) for quiet in wanted)


def branches_found(
    ways: Sequence[Sweep], question: Question, execution: Execution, work: int | None = None
) -> tuple[Followed, int]:
    """The branches of all motions that the sweeps show, of those that meet them, and of what motion goes on
    as beyond their ends; and from how many starts motions were looked for."""
    reason = next((sweep.message for sweep in ways if not sweep.complete), "")
    changes = Changes(()) if work is None else Changes.of(ways, ways[0].axis)
    followed = Followed(question, execution, reason=reason, work=Work(work), changes=changes)
    followed.add((sweep.way, point) for sweep in ways for point in sweep.points)
    followed.switch()
    starts = sum(point.computed for sweep in ways for point in sweep.points)
    for _ in range(PASSES):
        more = followed.look_beyond()
        starts += len(more)
        before = len(followed.branches)
        followed.add(more)
        followed.switch()
        if len(followed.branches) == before:
            break
    return followed, starts
