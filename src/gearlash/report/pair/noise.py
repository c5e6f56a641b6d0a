"""Sentences on what is measured over speed: impact-free is not quiet, and what does not matter."""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.orbits.signals import Signals
from gearlash.results import Point
from gearlash.results.pair_units import PairUnits
from gearlash.studies.assessment import Assessment
from gearlash.studies.speed_run import SpeedRun

from .words import Words


@dataclass(frozen=True)
class Loudest:
    """The largest force of one bearing direction in motions without impacts, and in those with."""

    words: str
    quiet: tuple[float, float] | None
    hitting: tuple[float, float] | None


def loudest(run: SpeedRun) -> list[Loudest]:
    """For every bearing direction, each time the peak (dimensionless) and the speed ω."""
    found, rows = [], run.measured()
    for i, readout in enumerate(run.readouts):
        if readout.quantity != "force":
            continue
        peaks = [(one.read[i].peak, point.value, point.impact_free) for point, one in rows]
        quiet = max(((p, w) for p, w, free in peaks if free), default=None)
        hitting = max(((p, w) for p, w, free in peaks if not free), default=None)
        found.append(Loudest(readout.words, quiet, hitting))
    return found


def not_quiet(run: SpeedRun, units: PairUnits, words: Words) -> str:
    """What the bearings carry without any impact, compared with where teeth separate."""
    rows = [one for one in loudest(run) if one.quiet is not None]
    if not rows:
        return ""
    force = units.force.text
    louder = [one for one in rows if one.hitting and one.quiet and one.quiet[0] > one.hitting[0]]
    if louder:
        one = max(louder, key=lambda each: (each.quiet or (0.0,))[0])
        assert one.quiet is not None
        assert one.hitting is not None
        return (
            f"Impact-free is not quiet: the {one.words} reaches {force(one.quiet[0])} at "
            f"{words.speed(one.quiet[1])}, where teeth stay in contact; where they separate it reaches no "
            f"more than {force(one.hitting[0])} (at {words.speed(one.hitting[1])})."
        )
    one = max(rows, key=lambda each: (each.quiet or (0.0,))[0])
    assert one.quiet is not None
    text = f"Without impacts the {one.words} reaches {force(one.quiet[0])} at {words.speed(one.quiet[1])}"
    if one.hitting is None:
        return f"{text}; no motion with impacts was found over these speeds."
    return f"{text}, where teeth separate {force(one.hitting[0])} at {words.speed(one.hitting[1])}."


def backlash_matters(found: Assessment, run: SpeedRun, units: PairUnits) -> str:
    """Whether the width of the backlash decides anything over these speeds."""
    clearance = found.attractor.propagators.system.clearances[0]
    rows = run.measured()
    if not rows:
        return ""
    open_, wide = (
        clearance.gap_plus - min(one.gap.least for _, one in rows),
        clearance.gap_plus + clearance.gap_minus,
    )
    reached = [(point, one) for point, one in rows if one.gap.least <= -clearance.gap_minus]
    if reached or found.back_side:
        return (
            "The backlash matters: some motions found over these speeds reach the back side, and what they "
            "do then depends on its width."
        )
    widest = f"at most {units.length.text(max(open_, 0.0), 3)} of the {units.length.text(wide)} there are"
    opened = f"teeth part by {widest}" if open_ > 0.0 else "teeth never part"
    return (
        f"The backlash does not matter for the motions found: none reaches the back side ({opened}), and "
        "while that is so another backlash only shifts the whole motion."
    )


def hardest(run: SpeedRun) -> tuple[Point, Signals] | None:
    """The motion with the highest mesh force."""
    return max(run.measured(), key=lambda pair: pair[1].force.most, default=None)
