"""Does impact-free motion at the present point last over the ranges of estimates and stated limits of a case?

The motion of teeth that never part is solved for at values over each range, everything else as the case has
it, and where it ends within a range that value is solved for. From there a combination is searched for with
which it ends, or else the worst one; at it the ends of its band of speed are solved for, and the cold start
is followed. Where the case states a range of speed, contact is looked for over all of it, too.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from math import isfinite, isnan, nan

from gearlash.case import Case
from gearlash.jobs import Chain, Execution, Part, run
from gearlash.orbits import Settings, attractor
from gearlash.results.impact_free import ImpactFree
from gearlash.results.pair_question import stated_speeds
from gearlash.results.tolerance import Band, ToleranceInput
from gearlash.system import GearlashError, Label

from .impact_free import impact_free_speeds
from .model import Source
from .speeds_across import SpeedsAcross, speeds_across
from .tolerances.bands import outside, positive_bands
from .tolerances.inputs import ranged_inputs
from .worst_of_ranges import margin_of, member_of, values_of, worst_together

SOLVED = 2
"""Ranges, the worst ones, for which the band of speed is solved at their worst value."""
SMALL = 1e-3
"""Of the static compression: a range that takes less does not count."""


@dataclass(frozen=True)
class Varied:
    """One estimate over its range, or a value over its stated limits, everything else as the case has it.

    Parameters
    ----------
    input : ToleranceInput
    broken : tuple of (float, float)
        Values at which the motion of teeth that never part does not exist, or is not stable, in the unit of
        the input.
    worst : float
        The value with the least compression of those that were looked at.
    margin : float
        That compression over the static one, at the torque and speed of the case: 1 where nothing moves,
        negative where teeth would have to pull; -inf where that motion is unstable.
    """

    input: ToleranceInput
    broken: tuple[Band, ...]
    worst: float
    margin: float


@dataclass(frozen=True)
class Corner:
    """Values of some ranges together, all others as the case has them.

    Parameters
    ----------
    values : mapping of str to str
        By path, with the unit.
    margin : float
        As that of `Varied`.
    speeds : ImpactFree or None
        The band of speed around the present one, solved for.
    cold : Label or None
        The motion from the cold start.
    unit : float
        Of its speeds: what an ω of the pair with these values is of one of the case as it is.
    """

    values: Mapping[str, str]
    margin: float
    speeds: ImpactFree | None = None
    cold: Label | None = None
    unit: float = 1.0


@dataclass(frozen=True)
class AcrossRanges:
    """What ranges of estimates and stated limits leave of the impact-free motion at the present point.

    Parameters
    ----------
    margin : float
        As the case has it.
    varied : tuple of Varied
        Of every range.
    single : tuple of Corner
        Ranges that take most of the margin, each at its worst value, with the ends of its band of speed.
    together : Corner or None
        The worst combination that was found, or one with which contact ends; None where no range takes
        anything.
    complete : bool
    speeds : tuple of SpeedsAcross
        Over the range of speed that the case states: first all as the case has it; where that never parts,
        then every one at both ends of its range and at its worst value at the present speed, and the worst
        combination. Empty where it states none.
    """

    margin: float
    varied: tuple[Varied, ...] = ()
    single: tuple[Corner, ...] = ()
    together: Corner | None = None
    complete: bool = True
    inputs: tuple[ToleranceInput, ...] = field(default=(), repr=False)
    speeds: tuple[SpeedsAcross, ...] = ()

    @property
    def broken(self) -> tuple[Varied, ...]:
        """Ranges in which the impact-free motion ends, the worst first."""
        return tuple(sorted((one for one in self.varied if one.broken), key=lambda one: one.margin))

    @property
    def parting(self) -> tuple[SpeedsAcross, ...]:
        """Values with which it ends somewhere in the stated range of speed, the worst first."""
        return tuple(sorted((one for one in self.speeds if one.parting), key=lambda one: one.least))

    @property
    def holds(self) -> bool:
        """Whether it exists for every value that was looked at, alone and together."""
        last = self.together is None or self.together.margin > 0.0
        return self.complete and self.margin > 0.0 and not self.broken and last


@dataclass(frozen=True)
class Task:
    """One range; or values from which a worst combination is searched for, or with the band of speed around
    the present one, or over a range of speed."""

    source: Source
    input: ToleranceInput | None = None
    moved: tuple[ToleranceInput, ...] = ()
    values: tuple[tuple[str, str], ...] = ()
    settings: Settings | None = None
    reach: tuple[float, float] | None = None


def across_ranges(
    case: Case, settings: Settings | None = None, execution: Execution | None = None
) -> AcrossRanges | None:
    """The impact-free motion over the ranges of all that a case estimates or states limits of; None where
    nothing has a range."""
    inputs = ranged_inputs(case)
    if not inputs:
        return None
    execution, source = execution or Execution(), Source.of(case)
    nominal = margin_of(case, {})
    chains = [Chain(i, (Task(source, one),), (1,)) for i, one in enumerate(inputs)]
    outcome = run(work, chains, execution)
    varied = tuple(outcome.results[i][0] for i in range(len(inputs)) if outcome.results.get(i))
    if not outcome.complete:
        return AcrossRanges(nominal, varied, complete=False, inputs=inputs)
    harmful = sorted((v for v in varied if _takes(v.margin, nominal)), key=lambda one: one.margin)
    worst, complete = _together(source, inputs, harmful, execution)
    if not complete:
        return AcrossRanges(nominal, varied, complete=False, inputs=inputs)
    corners = [Corner({v.input.path: v.input.text(v.worst)}, v.margin) for v in harmful[:SOLVED]]
    corners += [worst] if worst is not None and len(worst.values) > 1 else []
    reach = stated_speeds(case)
    own = None if reach is None else speeds_across(case, {}, reach)
    over = [] if own is None or own.parting else list(_over_speed(varied, worst))
    tasks = [Task(source, values=tuple(one.values.items()), settings=settings) for one in corners]
    tasks += [Task(source, values=tuple(one.items()), reach=reach) for one in over]
    outcome = run(work, [Chain(i, (task,), (1,)) for i, task in enumerate(tasks)], execution)
    done = [outcome.results[i][0] if outcome.results.get(i) else None for i in range(len(tasks))]
    looked = [found or one for one, found in zip(corners, done, strict=False)]
    speeds = tuple(found for found in (own, *done[len(corners) :]) if found is not None)
    last = looked.pop() if worst is not None and len(worst.values) > 1 else (looked[0] if looked else None)
    return AcrossRanges(nominal, varied, tuple(looked), last, outcome.complete, inputs, speeds)


def _together(
    source: Source, inputs: Sequence[ToleranceInput], harmful: Sequence[Varied], execution: Execution
) -> tuple[Corner | None, bool]:
    """The worst combination found, and whether the search came to its end.

    Searched for from the worst value alone, and from every range at its own worst value, where resonances may
    miss each other. Of combinations with which contact ends the one with the fewest values."""
    if not harmful:
        return None, True
    own = [(v.input.path, v.input.text(v.worst)) for v in harmful]
    alone = Corner(dict(own[:1]), harmful[0].margin)
    if not alone.margin > 0.0:
        return alone, True
    first = [one.input for one in harmful]
    moved = (*first, *(one for one in inputs if one not in first))
    tasks = [Task(source, moved=moved, values=tuple(begin)) for begin in (own[:1], own)[: len(own)]]
    outcome = run(work, [Chain(i, (task,), (1,)) for i, task in enumerate(tasks)], execution)
    found = [outcome.results[i][0] for i in range(len(tasks)) if outcome.results.get(i)]
    broken = [one for one in found if not one.margin > 0.0]
    if broken:
        return min(broken, key=lambda one: len(one.values)), outcome.complete
    return min([alone, *found], key=lambda one: one.margin), outcome.complete


def _over_speed(varied: Sequence[Varied], worst: Corner | None) -> Iterator[Mapping[str, str]]:
    """Values that are looked at over the stated range of speed."""
    for one in varied:
        for at in dict.fromkeys((one.input.lower, one.input.upper, one.worst)):
            yield {one.input.path: one.input.text(at)}
    if worst is not None and len(worst.values) > 1:
        yield worst.values


def _takes(margin: float, nominal: float) -> bool:
    return margin < nominal - SMALL


def work(task: Task, _carry: object) -> Part:
    """What one task finds."""
    case = _case(task.source.case_json or "")
    if task.input is not None:
        return Part((varied(case, task.input),))
    if task.moved:
        return Part((Corner(*worst_together(case, task.moved, dict(task.values))),))
    if task.reach is not None:
        return Part((speeds_across(case, dict(task.values), task.reach),))
    return Part((solved(case, dict(task.values), task.settings),))


@lru_cache(maxsize=4)
def _case(text: str) -> Case:
    return Case.from_json(text)


def varied(case: Case, one: ToleranceInput) -> Varied:
    """One range."""
    looked: dict[float, float] = {}

    def margin(at: float) -> float:
        if at not in looked:
            looked[at] = margin_of(case, {one.path: one.text(at)})
        return looked[at]

    bands = positive_bands(margin, values_of(one))
    known = {at: found for at, found in looked.items() if not isnan(found)}
    worst = min(known, key=lambda at: known[at], default=one.nominal)
    return Varied(one, outside([bands], one.lower, one.upper), worst, known.get(worst, nan))


def solved(case: Case, values: Mapping[str, str], settings: Settings | None) -> Corner:
    """A corner with its band of speed and the motion from the cold start."""
    margin = margin_of(case, values)
    try:
        member = member_of(case, values)
        family = member.family()[0]
        cold = attractor(family.system(), family.start(), settings or Settings()).label
        speeds = impact_free_speeds(member) if isfinite(margin) else None
    except GearlashError:  # no pair can have these values
        return Corner(values, margin)
    return Corner(values, margin, speeds, cold, case.family()[0].defaults["omega"] / family.defaults["omega"])
