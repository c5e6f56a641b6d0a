"""May a gear pair run where it is meant to: its motion there, bands of speed, margins, what coexists."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from gearlash.case import Case
from gearlash.jobs import Execution, Progress
from gearlash.orbits import Attractor, Settings, attractor
from gearlash.orbits.signals import Signals, signals
from gearlash.results import Axis, Sweep
from gearlash.results.beside import Beside
from gearlash.results.pair_question import SPEED, carrying_forwards, check_pair
from gearlash.system import GearlashError, Label
from gearlash.system.readout import Readout

from .bands import Band, back_bands, bands, not_told
from .beside import THROWS, motions_beside, thrown
from .measured import readouts_of, traceable
from .named import plain_axis
from .point import summary
from .ranges import AcrossRanges, across_ranges
from .sweep import sweeps
from .zone import Zones
from .zone_end import Interval, Quiet
from .zones import zones_of_kinds

WORK = 12_000
"""Units of `studies.work.Work`, about a millisecond of a processor each, that following branches may take: a
verdict is wanted within seconds. Of most pairs that is all there is."""
WAYS = ("up", "down", "cold")
"""In which the speeds are swept, besides the thrown starts."""
Tell = Callable[[str, Progress | None], object]


@dataclass(frozen=True, eq=False)
class Assessment:
    """What a verdict on a gear pair at its speed and torque rests on.

    Parameters
    ----------
    case : Case
    values : mapping of str to float
        Every parameter by short name.
    axis : Axis
        Speeds that were swept, ω.
    attractor : Attractor
        The motion from the cold start at the present speed.
    readouts : tuple of Readout
        What was read of it beside force and gap: of `signals.read`, in this order.
    signals : Signals or None
        None where there is no motion.
    beside : Beside or None
        What other starts lead to there.
    impact_free, drive_side : Zones
        Zones free of impacts, and of impacts on the back side, from the same sweeps.
    ranges : AcrossRanges or None
        What ranges of estimates and stated limits leave of the motion without impacts; None where nothing has
        a range.
    turned : bool
        Whether the back side carries: then ``case`` is the mirror image of what was asked, which moves alike.
    other : (Label, Signals) or None
        Of the other motions at the present speed that have impacts, the one with the largest contact force.
    """

    case: Case
    values: Mapping[str, float]
    axis: Axis
    attractor: Attractor
    readouts: tuple[Readout, ...]
    signals: Signals | None
    beside: Beside | None
    impact_free: Zones
    drive_side: Zones
    ranges: AcrossRanges | None = None
    turned: bool = False
    other: tuple[Label, Signals] | None = None

    @property
    def throws(self) -> int:
        """From how many thrown starts motions were looked for at every speed."""
        return len(self.impact_free.sweeps) - len(WAYS)

    @property
    def here(self) -> float:
        """The present speed, ω."""
        return self.values[SPEED]

    @property
    def complete(self) -> bool:
        """Whether all was computed."""
        return self.searched and (self.ranges is None or self.ranges.complete)

    @property
    def searched(self) -> bool:
        """Whether bands of speed were looked for to the end; what was stopped tells none."""
        return self.impact_free.complete and self.drive_side.complete

    @cached_property
    def separating(self) -> tuple[Band, ...]:
        """Bands of speed in which teeth of a motion that was found separate."""
        return bands(self.impact_free) if self.searched else ()

    @cached_property
    def not_told(self) -> tuple[Interval, ...]:
        """Parts of the range that are neither impact-free bands nor bands in which teeth separate."""
        return not_told(self.impact_free) if self.searched else ()

    @cached_property
    def back_side(self) -> tuple[Band, ...]:
        """Bands of speed in which a motion that was found meets the back side."""
        if not self.searched:
            return ()
        system = self.attractor.propagators.system
        return back_bands(self.drive_side, -system.clearances[0].gap_minus)


def speed_axis(case: Case, axis: Axis) -> Axis:
    """The speeds ω of an axis that names the speed somehow. Raises `GearlashError` for another parameter."""
    found = plain_axis(case, case.family()[0], axis)
    if found.name != SPEED:
        raise GearlashError(f"axis {axis.name}: a report goes over speed, such as pinion_speed or omega")
    return found


def assess(
    case: Case,
    axis: Axis,
    *,
    settings: Settings | None = None,
    execution: Execution | None = None,
    tell: Tell | None = None,
) -> Assessment:
    """The motion at the present speed, what coexists with it, and the bands of speed around it.

    Parameters
    ----------
    case : Case
        A gear pair under load.
    axis : Axis
        Speeds to sweep, as ω or by another name of the speed, with its unit; ends of bands are solved for.
    settings : Settings, optional
        How attractors are looked for.
    execution : Execution, optional
        Who does the work.
    tell : callable, optional
        Hears the stage, and how far it is.

    Returns
    -------
    Assessment

    Raises
    ------
    GearlashError
        For a case that is no gear pair under load, and an axis of another parameter.
    """
    check_pair(case)
    axis = speed_axis(case, axis)
    asked, case = case, carrying_forwards(case)
    execution, settings = execution or Execution(), settings or Settings()
    say = tell or (lambda _stage, _progress: None)
    family = case.family()[0]
    values, cold = family.complete(), family.start()
    say("motion here", None)
    found = attractor(family.system(), cold, settings)
    readouts = readouts_of(case, values)
    measured = signals(found.trace, readouts) if traceable(summary(found)) else None
    ways = sweeps(case, axis, WAYS, settings=settings, execution=telling(execution, say, "speeds"))
    states = thrown(found, cold)
    runs = [
        replace(
            sweeps(
                case, axis, ("cold",), start=state, settings=settings,
                execution=telling(execution, say, "speeds, thrown starts"),
            )[0],
            start=f"thrown {factor:+g}",
        )
        for factor, state in zip(THROWS, states, strict=False)  # no states where nothing settled
    ]  # fmt: skip
    own = dict(zip(family.states, map(float, cold), strict=True))
    beside = motions_beside(found, own, cold, more=_next_to([*ways, *runs], values[SPEED]), settings=settings)
    quiet, drive = zones_of_kinds(
        case, axis, [Quiet.IMPACT_FREE, Quiet.DRIVE_SIDE_ONLY], known=ways,
        thrown=list(zip(states, runs, strict=True)), settings=settings,
        execution=telling(execution, say, "ends of bands"), work=WORK, assure=False,
    )  # fmt: skip
    ranges = across_ranges(case, settings, telling(execution, say, "ranges"))
    loud = _loudest(found, beside, readouts, settings)
    return Assessment(
        case, values, axis, found, readouts, measured, beside, quiet, drive, ranges, case is not asked, loud
    )


def _next_to(ways: Sequence[Sweep], here: float) -> list[NDArray[np.float64]]:
    """States of the motions that sweeps found at the speeds next to this one, below and above."""
    states = []
    for way in ways:
        points = [point for point in way.points if traceable(point)]
        below = max((p for p in points if p.value <= here), key=lambda p: p.value, default=None)
        above = min((p for p in points if p.value > here), key=lambda p: p.value, default=None)
        states += [point.state for point in (below, above) if point is not None]
    return states


def _loudest(
    found: Attractor, beside: Beside | None, readouts: tuple[Readout, ...], settings: Settings
) -> tuple[Label, Signals] | None:
    """Of the other motions with impacts the one with the largest contact force, with what was measured."""
    rows = []
    for other in () if beside is None else beside.others:
        if not other.impacts:
            continue
        motion = attractor(found.propagators, np.array(list(other.start.values())), settings)
        if traceable(summary(motion)):
            rows.append((motion.label, signals(motion.trace, readouts)))
    return max(rows, key=lambda row: row[1].force.most, default=None)


def telling(execution: Execution, say: Tell, stage: str) -> Execution:
    """The execution of one stage, whose progress is told with its name."""
    say(stage, None)
    return replace(execution, progress=lambda progress: say(stage, progress))
