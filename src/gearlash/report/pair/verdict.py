"""The first lines of a report: may the pair run there, where are its bands, how far off, what else is there.

Every line says what was found; none says that there is nothing else."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf
from typing import Literal, TypeAlias

from gearlash.case import Case, Value
from gearlash.case.edges import at_most
from gearlash.orbits import Neutral, Unresolved
from gearlash.plots.regimes import short
from gearlash.results.beside import Beside
from gearlash.results.pair_units import PairUnits, stated_at_gear
from gearlash.studies.assessment import Assessment
from gearlash.studies.bands import Band, living_at, zone_with
from gearlash.system import ContactRule, Label, Signature, Status

from .orders import meetings_within
from .ranges import across, limits_of, not_given
from .speed_range import speed_range
from .words import Words

MOST_NAMED = 6
"""Assumed values that the first lines name."""
Kind: TypeAlias = Literal["good", "doubt", "bad"]
NO_RANGES = (
    "No value of this case is an estimate with a range or has stated limits, so none was varied here; "
    "gearlash tolerance varies those that are given limits."
)
TURNED = (
    "The torque is negative, so that the back side carries. Both sides are alike, and the mirror image of "
    "the pair moves as it does: here the side that carries is called the drive side, and torque, forces and "
    "displacements count as positive towards it."
)
OPEN = "no sweep shows impacts there, but not every motion was followed, or something settled to nothing"
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
        No impacts were found at the present speed nor over the range of speed that the case states, whatever
        estimates and values with stated limits are within their ranges; some motions have them, or nothing
        settled, or it does not hold across the ranges; all have them at the present speed.
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
    over, speeds = across(found, words), speed_range(found, words)
    if over is not None:
        answer = f"{answer[:-1]}; {over.clause}."
    if speeds is not None:
        answer += f" {speeds.first}"
    if kind == "good":
        if speeds is not None and not speeds.free:
            kind = "doubt"
            text = "not over its range of speed" if speeds.told else "not told over its range of speed"
        elif over is not None and not over.holds:
            kind, text = "doubt", f"not across the ranges of its {_ranged(found)}"
        elif speeds is not None and not speeds.holds:
            kind, text = "doubt", f"over its range of speed not across the ranges of its {_ranged(found)}"
    lines = (
        Line("May it run there", answer),
        *_remarks(found),
        *([] if speeds is None else [Line("Over its speed range", speeds.text)]),
        Line("Across its ranges", NO_RANGES if over is None else over.text),
        *_limits(found.case),
        *([Line("Turned round", TURNED)] if found.turned else []),
        *_shaft(found),
        Line("Teeth separate", _separating(found, words)),
        Line("Back side", _back(found, words)),
        Line("Margin", _margin(found, words)),
        Line("What coexists", _coexisting(found)),
        *_left_out(found),
        *_names(found),
        *_forces(found, units),
        Line("What this rests on", rests(found)),
    )
    return Verdict(kind, text, lines)


def _ranged(found: Assessment) -> str:
    """Of what there are ranges."""
    stated = {one.input.of_case for one in found.ranges.varied} if found.ranges is not None else set()
    return " and ".join(
        words for words, kind in (("estimates", False), ("stated limits", True)) if kind in stated
    )


def _limits(case: Case) -> list[Line]:
    """Values that the case states limits of, and at which of them all else is computed."""
    limited = [value for value in case.values() if value.limited]
    if not limited:
        return []
    said = "; ".join(f"{value.path} {limits_of(value)}" for value in limited)
    return [Line("Stated limits", f"{said}. Where nothing is said of ranges, the values named here hold.")]


def place(case: Case, units: PairUnits, omega: float, load: float) -> str:
    """``4200 rpm and 150 N·m``, or both as numbers; of the gear first, where the case states those."""
    speed = units.speed.text(omega, 5) if units.speed.name else f"omega = {omega:.5g}"
    torque = units.torque.text(load, 5) if units.torque.name else f"load = {load:.5g}"
    return f"{_both(case, 'omega', omega, speed)} and {_both(case, 'load', load, torque)}"


def _remarks(found: Assessment) -> list[Line]:
    """What is unusual about the case, before anything that is computed from it."""
    told = " ".join(f"{note.path}: {note.text.rstrip('.')}." for note in found.case.notes())
    return [Line("Remarks on the case", told)] if told else []


def _shaft(found: Assessment) -> list[Line]:
    """Which shaft speeds are of, where the case states that of the gear."""
    if not stated_at_gear(found.case, "omega", found.here, 5):
        return []
    entries = found.case.content.entries
    teeth = " over ".join(f"{entries[f'{gear}.teeth'].number:.0f}" for gear in ("gear", "pinion"))
    return [
        Line("Speeds", f"Those that are told without a shaft are of the pinion: {teeth} times the gear's.")
    ]


def _both(case: Case, short: str, value: float, pinion: str) -> str:
    of_gear = stated_at_gear(case, short, value, 5)
    return f"{of_gear} of the gear ({pinion} of the pinion)" if of_gear else pinion


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
    if not found.searched:
        return _stopped(at, hits, label, found)
    inside = [band for band in found.separating if band.contains(found.here) and own is None]
    hit = [other.label for other in others if other.impacts]
    hit += living_at(found.impact_free, found.here) if inside else ()
    if not hits and not hit and not inside:
        all_found = ", ".join(dict.fromkeys(short(each) for each in (label, *(o.label for o in others))))
        text = f"At {at} no impacts were found: in every motion found there ({all_found}) "
        return "good", "no impacts found", f"{text}the teeth stay in contact{_pressed(found)}."
    if (
        not hits
        or zone_with(found.impact_free, found.here) is not None
        or any(other.impacts is False for other in others)
    ):
        text = f"At {at} it depends on how the pair came there: a motion without impacts exists, and "
        text += _apart([label] if hits else hit, inside, words)
        return "doubt", "depends on the start", f"{text}{_force_apart(found, hits, words)}."
    gone = f"{100.0 * found.signals.share_without_contact:.3g} % of the time"
    return "bad", "teeth separate", (
        f"At {at} teeth separate ({short(label)}): without contact {gone}"
        + (", and the back side is hit." if found.signals.back_velocity > 0.0 else ".")
    )  # fmt: skip


def _apart(labels: Sequence[Label], bands: Sequence[Band], words: Words) -> str:
    """What moves with impacts at the present speed, or else where in the bands around it that was seen."""
    if labels:
        return f"one in which teeth separate ({', '.join(dict.fromkeys(map(short, labels)))})"
    return f"motions in which teeth separate were found beside it in the band {words.bands(bands)}"


def _stopped(at: str, hits: bool, label: Label, found: Assessment) -> tuple[Kind, str, str]:
    """The answer of a search that was stopped: what is known is the motion from the cold start."""
    does = "separate" if hits else "stay in contact"
    text = f"At {at} teeth {does} in the motion from the cold start ({short(label)}); the search for other "
    return "doubt", "stopped early", f"{text}motions was stopped ({_why_stopped(found)})."


def _why_stopped(found: Assessment) -> str:
    return found.impact_free.message or found.drive_side.message


def _force_apart(found: Assessment, hits: bool, words: Words) -> str:
    """The largest mesh force of the motions in which teeth separate."""
    own = found.signals if hits else found.other[1] if found.other is not None else None
    if own is None:
        return ""
    static = found.values["load"] / found.values["rotation_factor"]
    most = words.units.force.text(own.force.most)
    return f", with a mesh force of up to {most}, {own.force.most / static:.3g} times the static one"


def _pressed(found: Assessment) -> str:
    """How much of the static mesh force is left between teeth that stay in contact; a share never rounded
    up. Measured on the motion from the cold start alone."""
    assert found.signals is not None
    share = found.signals.force.least / (found.values["load"] / found.values["rotation_factor"])
    if share <= 0.0:
        return ""
    several = found.beside is not None and bool(found.beside.others)
    whose = "in that from the cold start" if several else "there"
    left = at_most(100.0 * share, 3)
    return f"; {whose} the least mesh force over a cycle is {left} % of the static mesh force"


def _pulling(found: Assessment) -> str:
    """Under the rule `always` the damper acts while teeth are apart."""
    contact = found.attractor.propagators.system.clearances[0].contact
    if contact is not ContactRule.ALWAYS or not found.separating:
        return ""
    return (
        " While they are apart the damper of the mesh still acts, also pulling: contact = always is the rule "
        "of this case, and --set contact=no-tension lets teeth only push."
    )


def _separating(found: Assessment, words: Words) -> str:
    if not found.searched:
        return f"Not looked for to the end ({_why_stopped(found)})."
    bands = found.separating
    reach = words.reach(*(float(found.axis.values[i]) for i in (0, -1)))
    reach += f", at {len(found.axis)} speeds, each from the motions at its neighbours"
    reach += ", from the cold start" if found.throws else " and from the cold start"
    reach += f" and from {found.throws} starts with teeth thrown together or apart" if found.throws else ""
    open_ = _not_told(found, words)
    if not bands:
        return f"In no motion that was found; examined: {reach}.{open_}"
    met = meetings_within(found.case, bands, words)
    return f"{words.bands(bands)}; examined: {reach}.{open_}{met}{_pulling(found)}"


def _not_told(found: Assessment, words: Words) -> str:
    """Where is told neither that teeth separate nor that they do not."""
    if not found.not_told:
        return ""
    where = " and ".join(words.span(one.lower, one.upper) for one in found.not_told)
    return f" Not told for {where}: {OPEN}."


def _back(found: Assessment, words: Words) -> str:
    if not found.searched:
        return "Not looked for to the end."
    bands = found.back_side
    if not bands:
        return "It is met by no motion that was found in that range."
    return f"It is met at {words.bands(bands)}."


def _margin(found: Assessment, words: Words) -> str:
    if not found.searched:
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
    part = next((one for one in found.not_told if one.contains(here)), None)
    if part is not None:
        return f"Not known: the present speed lies in {words.span(part.lower, part.upper)}, where {OPEN}."
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
            text += f"; in the band around it sweeps show {names} beside it, at this speed or others"
    return f"{text}."


def _names(found: Assessment) -> list[Line]:
    """How motions are called in these lines."""
    if found.signals is None:
        return []
    text = "2-1: in 2 mesh cycles the drive side is hit once, and all repeats; 1-0: it is never hit. A third "
    return [
        Line("Names of motions", f"{text}number counts hits of the back side. Aperiodic: it never repeats.")
    ]


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
    least, most = (units.force.text(each) for each in (s.force.least, s.force.most))
    times = f"{s.force.least / static:.3g} to {s.force.most / static:.3g} times the static one"
    if least == most:
        text = f"Mesh force {most} all the time, to the digits shown: the static one"
    else:
        text = f"Mesh force from {least} to {most}, {times}"
    bearings = [
        (one, sig) for one, sig in zip(found.readouts, s.read, strict=True) if one.quantity == "force"
    ]
    if bearings:
        one, sig = max(bearings, key=lambda pair: pair[1].peak)
        ratio = sig.peak / abs(sig.mean) if sig.mean else float("nan")
        text += f"; {one.words}, up to {units.force.text(sig.peak)}, {ratio:.3g} times its mean"
        text += ", and changing its direction" if sig.mean and sig.least < 0.0 < sig.most else ""
    return [Line("Forces there", f"{text}.")]


def _named(value: Value) -> str:
    """A value in words, with its place in the file."""
    return f"{value.description} ({value.path})" if value.description else value.path


def rests(found: Assessment) -> str:
    """What was assumed, by name: first what takes most of the margin, then other estimates."""
    known = [value for value in not_given(found.case) if value.provenance == "assumed"]
    if not known:
        return "No value of the case is marked as assumed. " + NO_APPROVAL
    taken = {one.input.path: one.margin for one in found.ranges.varied} if found.ranges else {}
    known.sort(key=lambda value: (value.least is None, taken.get(value.path, inf)))
    ranged = sum(value.least is not None for value in known)
    many = f"{len(known)} assumed value{'s' if len(known) > 1 else ''}"
    many += f", {ranged} of them with a range" if ranged else ""
    shown = "; ".join(map(_named, known[:MOST_NAMED]))
    if len(known) > MOST_NAMED:
        shown += f"; and {len(known) - MOST_NAMED} more, which the report and gearlash check list"
    return f"{many}: {shown}. {NO_APPROVAL}"
