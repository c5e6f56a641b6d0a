"""The first lines of a report: may the pair run there, where are its bands, how far off, what else is there.

Every line says what was found; none says that there is nothing else."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import Literal, TypeAlias

from gearlash.case import Case
from gearlash.orbits import Neutral, Unresolved
from gearlash.plots.regimes import short
from gearlash.results.beside import Beside
from gearlash.results.pair_question import stated_speeds
from gearlash.results.pair_units import PairUnits
from gearlash.studies.assessment import Assessment
from gearlash.studies.bands import zone_with
from gearlash.system import Signature, Status

from .ranges import across
from .words import Words

MOST_NAMED = 6
"""Assumed values that the first lines name."""
Kind: TypeAlias = Literal["good", "doubt", "bad"]
NO_RANGES = (
    "No value of this case is an estimate with a range, so none was varied here; gearlash tolerance varies "
    "those that are given limits."
)
TURNED = (
    "The torque is negative, so that the back side carries. Both sides are alike, and the mirror image of "
    "the pair moves as it does: here the side that carries is called the drive side, and torque, forces and "
    "displacements count as positive towards it."
)
NO_APPROVAL = "This is an analysis of a model, and no approval."


@dataclass(frozen=True)
class Line:
    """A titled sentence."""

    title: str
    text: str


@dataclass(frozen=True)
class Verdict:
    """What stands at the top.

    Parameters
    ----------
    kind : {"good", "doubt", "bad"}
        No impacts were found at the present speed, whatever estimates are within their ranges; some motions
        have them, or nothing settled, or it does not hold across the ranges; all have.
    short : str
        In a few words.
    lines : tuple of Line
        The first one answers the question.
    """

    kind: Kind
    short: str
    lines: tuple[Line, ...]


def verdict(found: Assessment) -> Verdict:
    """The verdict of an assessment."""
    units = PairUnits.of(found.case)
    words = Words(units, found.here)
    kind, text, answer = _answer(found, words)
    over = across(found, words)
    if over is not None:
        answer = f"{answer[:-1]}; {over.clause}."
        if kind == "good" and not over.holds:
            kind, text = "doubt", "not across the ranges of its estimates"
    lines = (
        Line("May it run there", answer),
        Line("Across its ranges", NO_RANGES if over is None else over.text),
        *([Line("Turned round", TURNED)] if found.turned else []),
        *_over_its_range(found, words),
        Line("Teeth separate", _separating(found, words)),
        Line("Back side", _back(found, words)),
        Line("Margin", _margin(found, words)),
        Line("What coexists", _coexisting(found)),
        *_left_out(found),
        *_forces(found, units),
        Line("What this rests on", rests(found)),
    )
    return Verdict(kind, text, lines)


def place(case: Case, units: PairUnits, omega: float, load: float) -> str:
    """``4200 rpm and 150 N·m``, or both as numbers."""
    speed = units.speed.text(omega, 5) if units.speed.name else f"omega = {omega:.5g}"
    torque = units.torque.text(load, 5) if units.torque.name else f"load = {load:.5g}"
    return f"{speed} and {torque}"


def _answer(found: Assessment, words: Words) -> tuple[Kind, str, str]:
    load = found.values["load"]
    at = place(found.case, words.units, found.here, -load if found.turned else load)
    motion = found.attractor
    if found.signals is None or isinstance(motion, Unresolved | Neutral) or motion.status not in (
        Status.OK, Status.UNCERTAIN
    ):  # fmt: skip
        return "doubt", "no verdict", f"No verdict at {at}: {motion.label}, {motion.message}."
    low, high = (float(found.axis.values[i]) for i in (0, -1))
    label = motion.label
    hits = not (isinstance(label, Signature) and label.impacts == 0)
    others = () if found.beside is None else found.beside.others
    own = found.impact_free.at(found.here)
    if not low <= found.here <= high:
        seen = "separate" if hits else "stay in contact"
        text = f"At {at} teeth {seen} in the motion from the cold start ({short(label)}); that speed lies "
        return "doubt", "not examined", text + f"outside the range examined, {words.reach(low, high)}."
    quiet_here = own is not None or (not hits and not any(other.impacts for other in others))
    if quiet_here and not hits and not any(other.impacts for other in others):
        text = f"At {at} no impacts were found: in every motion found there ({short(label)}) "
        return "good", "no impacts found", text + "the teeth stay in contact."
    if (
        not hits
        or zone_with(found.impact_free, found.here) is not None
        or any(other.impacts is False for other in others)
    ):
        text = f"At {at} it depends on how the pair came there: a motion without impacts exists, and one in "
        return "doubt", "depends on the start", text + "which teeth separate."
    gone = f"{100.0 * found.signals.share_without_contact:.3g} % of the time"
    return "bad", "teeth separate", (
        f"At {at} teeth separate ({short(label)}): without contact {gone}"
        + (", and the back side is hit." if found.signals.back_velocity > 0.0 else ".")
    )  # fmt: skip


def _over_its_range(found: Assessment, words: Words) -> list[Line]:
    """Whether it may run at every speed that the case states."""
    stated = stated_speeds(found.case)
    if stated is None:
        return []
    low, high = stated
    reach = words.reach(low, high)
    first, last = (float(found.axis.values[i]) for i in (0, -1))
    bands = [b for b in found.separating if b.upper.value > low and b.lower.value < high]
    if not found.complete:
        text = f"Not looked for to the end in {reach}."
    elif bands:
        text = f"Not at every speed from {reach}: teeth separate at {words.bands(bands)}."
    elif first > low or last < high:
        text = f"Not told for all of {reach}: examined was {words.reach(first, last)}, where none separate."
    else:
        text = f"From {reach} no motion was found in which teeth separate."
    return [Line("Over its speed range", text)]


def _separating(found: Assessment, words: Words) -> str:
    if not found.complete:
        return f"Not looked for to the end ({found.impact_free.message or found.drive_side.message})."
    bands = found.separating
    reach = words.reach(*(float(found.axis.values[i]) for i in (0, -1)))
    if not bands:
        return f"Nowhere from {reach}, as far as motions were found."
    return f"{words.bands(bands)}; examined: {reach}."


def _back(found: Assessment, words: Words) -> str:
    if not found.complete:
        return "Not looked for to the end."
    bands = found.back_side
    if not bands:
        return "It is met by no motion that was found in that range."
    return f"It is met at {words.bands(bands)}."


def _margin(found: Assessment, words: Words) -> str:
    if not found.complete:
        return "Not looked for to the end."
    here = found.here
    zone = found.impact_free.at(here)
    if zone is not None:
        below, above = zone.margins(here)
        said = []
        for margin, inwards in ((below, 1), (above, -1)):
            if margin is not None:
                said.append((margin.distance, words.margin(margin, inwards)))
        if not said:
            return "No end of the impact-free band lies in the range examined."
        return "; ".join(text for _, text in sorted(said)) + "."
    nearest = found.impact_free.nearest(here)
    if nearest is None:
        return "None: no speed was found at which every motion found keeps its teeth in contact."
    factor, unit = words.units.speed.factor, words.units.speed.name
    apart, side = abs(nearest - here), "above" if nearest > here else "below"
    far = factor * apart
    distance = f"{far:.0f} {unit}" if far >= 100.0 else f"{far:.3g} {unit}".rstrip()
    return (
        f"None: the nearest speed at which every motion found keeps its teeth in contact is "
        f"{words.speed(nearest)}, {distance} ({100.0 * apart / here:.2g} %) {side}."
    )


def _coexisting(found: Assessment) -> str:
    beside, label = found.beside, found.attractor.label
    if beside is None or not beside.starts:
        return "Other motions at the present speed were not looked for."
    text = f"{beside.starts} other starts at the present speed: "
    text += f"{beside.same} lead to the same motion ({short(label)})"
    text += "".join(_other(beside))
    zone = zone_with(found.impact_free, found.here)
    if zone is not None:
        seen = [m.label for m in zone.coexisting if m.label != label]
        if seen:
            names = ", ".join(dict.fromkeys(map(short, seen)))
            text += f"; elsewhere in the band around it sweeps show {names} beside it"
    return f"{text}."


def _left_out(found: Assessment) -> list[Line]:
    """What was not looked for, as the work of a verdict has a limit."""
    zones = found.impact_free
    if not zones.left_out:
        return []
    text = (
        f"The work that a verdict allows was spent after {len(zones.branches)} branches of motions, those "
        f"first on which bands depend. {zones.left_out} motions and ends of motions were not followed "
        "farther: they count at the speeds at which sweeps saw them. gearlash zones follows all."
    )
    return [Line("Not followed", text)]


def _other(beside: Beside) -> list[str]:
    said = [
        f", {one.starts} to {short(one.label)} ({'with' if one.impacts else 'without'} impacts)"
        for one in beside.others
    ]
    return [*said, f", {beside.undecided} settled to nothing"] if beside.undecided else said


def _forces(found: Assessment, units: PairUnits) -> list[Line]:
    if found.signals is None:
        return []
    s, static = found.signals, found.values["load"] / found.values["rotation_factor"]
    text = (
        f"Mesh force up to {units.force.text(s.force.most)}, {s.force.most / static:.3g} times the static one"
    )
    bearings = [
        (one, sig) for one, sig in zip(found.readouts, s.read, strict=True) if one.quantity == "force"
    ]
    if bearings:
        one, sig = max(bearings, key=lambda pair: pair[1].peak)
        ratio = sig.peak / abs(sig.mean) if sig.mean else float("nan")
        text += f"; {one.words}, up to {units.force.text(sig.peak)}, {ratio:.3g} times its mean"
    return [Line("Forces there", f"{text}.")]


def rests(found: Assessment) -> str:
    """What was assumed, by name: first what takes most of the margin, then other estimates."""
    known = [value for value in found.case.values() if value.provenance == "assumed"]
    if not known:
        return "No value of the case is marked as assumed. " + NO_APPROVAL
    taken = {one.input.path: one.margin for one in found.ranges.varied} if found.ranges else {}
    known.sort(key=lambda value: (value.least is None, taken.get(value.path, inf)))
    assumed = [value.path for value in known]
    many = f"{len(assumed)} assumed value{'s' if len(assumed) > 1 else ''}"
    shown = ", ".join(assumed[:MOST_NAMED])
    if len(assumed) > MOST_NAMED:
        shown += f" and {len(assumed) - MOST_NAMED} more, which the report and gearlash check list"
    return f"{many}: {shown}. {NO_APPROVAL}"
