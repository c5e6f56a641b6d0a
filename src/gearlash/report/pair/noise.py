"""Sentences on what is measured over speed: impact-free is not quiet, and what does not matter."""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.gears.helical import BEARING_WORDS, BEARINGS
from gearlash.orbits.signals import Signal
from gearlash.results.pair_units import PairUnits
from gearlash.studies.assessment import Assessment
from gearlash.studies.speed_run import SpeedRun, bearing_modes

from .words import Words

MOST = 0.5
"""Share of the motions with impacts: a bearing force without impacts that is larger is remarked on."""


@dataclass(frozen=True)
class Loudest:
    """The force of one bearing direction in motions without impacts, and in those with.

    Parameters
    ----------
    words : str
    quiet, hitting : (float, float) or None
        Largest peak and the speed ω at which it was found; None where there was no such motion.
    mean : float
        Of the quiet one, its mean.
    exceeded : float
        Share of the motions with impacts, 0 to 1, whose peak is below that of the quiet one.
    """

    words: str
    quiet: tuple[float, float] | None
    hitting: tuple[float, float] | None
    mean: float
    exceeded: float


def loudest(run: SpeedRun) -> list[Loudest]:
    """For every bearing direction."""
    found, rows = [], run.measured()
    for i, readout in enumerate(run.readouts):
        if readout.quantity != "force":
            continue
        quiet = [(one.read[i].peak, p.value, one.read[i].mean) for p, one in rows if p.impact_free]
        hitting = [(one.read[i].peak, p.value) for p, one in rows if not p.impact_free]
        best, worst = max(quiet, default=None), max(hitting, default=None)
        below = sum(peak < best[0] for peak, _ in hitting) / len(hitting) if best and hitting else 0.0
        found.append(
            Loudest(readout.words, best[:2] if best else None, worst, abs(best[2]) if best else 0.0, below)
        )
    return found


def not_quiet(run: SpeedRun, units: PairUnits, words: Words) -> str:
    """What the bearings carry without any impact, compared with where teeth separate: of the direction in
    which that is more than wherever they separate, or in most such motions, else of the most loaded one."""
    rows = [(one.quiet, one) for one in loudest(run) if one.quiet is not None]
    if not rows:
        return ""

    def telling(row: tuple[tuple[float, float], Loudest]) -> tuple[bool, bool, float]:
        (peak, _), one = row
        return one.exceeded >= 1.0, one.exceeded >= MOST, peak

    quiet, one = max(rows, key=telling)
    force = units.force.text
    times = f", {quiet[0] / one.mean:.3g} times its mean" if one.mean > 0.0 else ""
    text = f"the {one.words} reaches {force(quiet[0])} at {words.speed(quiet[1])}{times}"
    if one.hitting is None:
        return f"Without impacts {text}; no motion with impacts was found at these speeds."
    there = f"{force(one.hitting[0])} at {words.speed(one.hitting[1])}{_another(run, one, units, words)}"
    if one.exceeded >= 1.0:
        return (
            f"Impact-free is not quiet: without any impact {text}: more than in the same direction "
            f"wherever teeth separate ({there})."
        )
    if one.exceeded >= MOST:
        return (
            f"Impact-free is not quiet: without any impact {text}: more than in {100.0 * one.exceeded:.0f} "
            f"% of the motions in which teeth separate (largest there in the same direction: {there})."
        )
    return f"Without impacts {text}; where teeth separate it reaches {there}."


def _another(run: SpeedRun, one: Loudest, units: PairUnits, words: Words) -> str:
    """The largest bearing force where teeth separate, if it has another direction."""
    hitting = [(each.hitting, each) for each in loudest(run) if each.hitting is not None]
    worst, most = max(hitting, key=lambda row: row[0])
    if most.words == one.words:
        return ""
    return f"; the largest of all there is that of the {most.words.removeprefix('bearing force, ')}, " + (
        f"{units.force.text(worst[0])} at {words.speed(worst[1])}"
    )


def reversing(run: SpeedRun, words: Words) -> str:
    """Bearing forces whose direction changes within a motion."""
    said = []
    for i, readout in enumerate(run.readouts):
        at = [p.value for p, one in run.measured() if one.read[i].least < 0.0 < one.read[i].most]
        mean = [abs(one.read[i].mean) for _, one in run.measured()]
        if readout.quantity == "force" and at and max(mean) > 0.0:
            name = readout.words.removeprefix("bearing force, ")
            said.append(
                f"{name}, at {len(set(at))} of {len(run.axis)} speeds from {words.reach(min(at), max(at))}"
            )
    if not said:
        return ""
    return (
        f"The bearing force changes its direction within a motion: {'; '.join(said)}. The clearance of "
        "bearings is not in this model: each is a spring that pulls as it pushes."
    )


def unloaded(run: SpeedRun, units: PairUnits, words: Words) -> str:
    """The speed without impacts at which a body swings most on its bearing alone, and unloads the mesh."""
    said: list[tuple[float, str]] = []
    rows = [(point, one) for point, one in run.measured() if point.impact_free]
    for omega, name, body in zip(bearing_modes(run.case), BEARINGS, BEARING_WORDS, strict=False):
        near = [(point, one) for point, one in rows if abs(point.value - omega) <= 1e-12 * omega]
        if not near:
            continue
        one = near[0][1]
        i = next(k for k, readout in enumerate(run.readouts) if readout.name == f"bearing_force_{name}")
        if one.read[i].peak_to_peak <= one.force.peak_to_peak:
            continue
        ratio = one.read[i].peak_to_peak / one.force.peak_to_peak
        text = (
            f"The mode of a body on its bearing alone ({body}) lies at {words.speed(omega)}. There, without "
            f"any impact, the bearing force changes by {units.force.text(one.read[i].peak_to_peak)}, "
            f"{ratio:.3g} times as much as the mesh force ({_changes(one.force, units)}): the body swings, "
            "and the load between the teeth hardly varies."
        )
        said.append((one.read[i].peak_to_peak, text))
    return max(said, default=(0.0, ""))[1]


def _changes(signal: Signal, units: PairUnits) -> str:
    return f"{units.force.text(signal.peak_to_peak)} peak to peak"


def backlash_matters(found: Assessment, run: SpeedRun, units: PairUnits) -> str:
    """Whether the width of the backlash decides anything over these speeds."""
    clearance = found.attractor.propagators.system.clearances[0]
    rows = run.measured()
    if not rows:
        return ""
    opened = clearance.gap_plus - min(one.gap.least for _, one in rows)
    reached = any(one.gap.least <= -clearance.gap_minus for _, one in rows)
    if not (reached or found.searched):
        return ""
    if reached or found.back_side:
        return (
            "The backlash matters: some motions found over these speeds reach the back side, and what they "
            "do then depends on its width."
        )
    width = units.length.text(clearance.gap_plus + clearance.gap_minus)
    widest = f"at most {units.length.text(opened, 3)} of the {width} there are"
    parted = f"teeth part by {widest}" if opened > 0.0 else "teeth never part"
    return (
        f"The backlash does not matter for the motions found: none reaches the back side ({parted}), and "
        "while that is so another backlash only shifts the whole motion."
    )
