"""May a gear pair run where it is meant to: its motion there, bands of speed, margins, what coexists."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from gearlash.case import Case
from gearlash.jobs import Execution, Progress
from gearlash.orbits import Attractor, Settings, attractor
from gearlash.orbits.signals import Signals, signals
from gearlash.results import Axis
from gearlash.results.beside import Beside
from gearlash.results.pair_question import SPEED, carrying_forwards, check_pair
from gearlash.system import GearlashError
from gearlash.system.readout import Readout

from .bands import Band, back_bands, bands
from .beside import motions_beside
from .measured import readouts_of, traceable
from .point import summary
from .ranges import AcrossRanges, across_ranges
from .sweep import sweeps
from .zone import Zones
from .zone_end import Quiet
from .zones import zones_of_kinds

WORK = 12_000
"""Units of `studies.work.Work`, about a millisecond of a processor each, that following branches may take: a
verdict is wanted within seconds. Of most pairs that is all there is."""
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
        What the ranges of estimates leave of the motion without impacts; None where nothing has a range.
    turned : bool
        Whether the back side carries: then ``case`` is the mirror image of what was asked, which moves alike.
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

    @property
    def here(self) -> float:
        """The present speed, ω."""
        return self.values[SPEED]

    @property
    def complete(self) -> bool:
        """Whether all was computed."""
        over = self.ranges is None or self.ranges.complete
        return self.impact_free.complete and self.drive_side.complete and over

    @property
    def separating(self) -> tuple[Band, ...]:
        """Bands of speed in which teeth of a motion that was found separate."""
        return bands(self.impact_free)

    @property
    def back_side(self) -> tuple[Band, ...]:
        """Bands of speed in which a motion that was found meets the back side."""
        system = self.attractor.propagators.system
        return back_bands(self.drive_side, -system.clearances[0].gap_minus)


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
        Speeds ω to sweep; ends of bands are solved for.
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
    if axis.name != SPEED:
        raise GearlashError(f"axis {axis.name}: a report goes over speed ({SPEED}, pinion_speed)")
    asked, case = case, carrying_forwards(case)
    execution, settings = execution or Execution(), settings or Settings()
    say = tell or (lambda _stage, _progress: None)
    family = case.family()[0]
    values, cold = family.complete(), family.start()
    say("motion here", None)
    found = attractor(family.system(), cold, settings)
    readouts = readouts_of(case, values)
    measured = signals(found.trace, readouts) if traceable(summary(found)) else None
    beside = motions_beside(
        found, dict(zip(family.states, map(float, cold), strict=True)), cold, settings=settings
    )
    ways = sweeps(case, axis, ("up", "down"), settings=settings, execution=telling(execution, say, "speeds"))
    quiet, drive = zones_of_kinds(
        case, axis, [Quiet.IMPACT_FREE, Quiet.DRIVE_SIDE_ONLY], known=ways, settings=settings,
        execution=telling(execution, say, "ends of bands"), work=WORK,
    )  # fmt: skip
    ranges = across_ranges(case, settings, telling(execution, say, "ranges of estimates"))
    return Assessment(
        case, values, axis, found, readouts, measured, beside, quiet, drive, ranges, case is not asked
    )


def telling(execution: Execution, say: Tell, stage: str) -> Execution:
    """The execution of one stage, whose progress is told with its name."""
    say(stage, None)
    return replace(execution, progress=lambda progress: say(stage, progress))
