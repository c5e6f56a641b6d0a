"""Whether a verdict holds over the ranges of estimates and stated limits, in words and as a table."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import isfinite, isnan

from gearlash.case import Case, Value
from gearlash.case.stated import MIDDLE
from gearlash.case.units import pretty
from gearlash.report.blocks import Block, Cell, Table, Text
from gearlash.report.numbers import number
from gearlash.results.pair_question import stated_speeds
from gearlash.results.tolerance import ToleranceInput
from gearlash.results.zone_words import percent
from gearlash.studies.assessment import Assessment
from gearlash.studies.ranges import AcrossRanges, Corner, Varied
from gearlash.studies.tolerances.bands import outside
from gearlash.system import ContactRule, Signature

from .words import Words

MOST = 3
"""Values that the first lines name together."""
NAMED = 5
"""Ranges that the first lines name."""


@dataclass(frozen=True)
class Across:
    """What is said of the ranges: whether the verdict holds, a clause for the first sentence, and a line."""

    holds: bool
    clause: str
    text: str


def not_given(case: Case) -> list[Value]:
    """Values that the case does not give and a report rests on. The distance of bearings is none of them: an
    end of the range of their stiffness follows from it, and no value."""
    values = (value for value in case.values() if value.provenance not in ("given", "derived"))
    return [value for value in values if not value.path.endswith(".bearing_span")]


def across(found: Assessment, words: Words) -> Across | None:
    """In the first lines; None where nothing has a range."""
    ranges = found.ranges
    if ranges is None:
        return None
    if not ranges.complete:
        return Across(False, "its ranges were not looked at to the end", "Not looked at to the end.")
    many = counted(ranges.varied)
    if not ranges.margin > 0.0:
        return Across(False, *_where_it_would_hold(ranges, many))
    ends = speed_ends(found, words)
    if ranges.broken:
        named = listed([_broken(one) for one in ranges.broken])
        rest = [one for one in ranges.varied if not one.broken]
        text = f"Does not hold if {named}: there no motion without impacts exists, all else {as_is(ranges)}. "
        text += f"It holds across the ranges of the other {counted(rest)}, one at a time." if rest else ""
        clause = listed([_broken(one).partition(" (")[0] for one in ranges.broken])
        return Across(False, f"no motion without impacts exists if {clause}", f"{text}{ends}")
    worst = ranges.together
    if worst is not None and not worst.margin > 0.0:
        said = f"Holds across the range of each of its {many}, one at a time, but not for all together: "
        text = f"{said}with {_together(worst)} no motion without impacts exists.{ends}"
        clause = (
            f"at least one combination of values of its {many} within their ranges has no motion without "
            "impacts"
        )
        return Across(False, clause, text)
    return Across(
        True,
        f"a motion without impacts exists there across the ranges of its {many}",
        _holding(ranges, many, measure(found)) + ends,
    )


def _holding(ranges: AcrossRanges, many: str, measure: str) -> str:
    worst = ranges.together
    if worst is None:
        return f"Holds across the ranges of its {many}: none takes from what presses the teeth together."
    text = (
        f"Holds across the ranges of its {many}, one at a time and in the worst combination found: a motion "
        f"without impacts exists there, in which the {measure} at the teeth is at least "
        f"{_percent(worst.margin)} of the static one ({_percent(ranges.margin)} {as_is(ranges)}). Most is "
        "taken by "
    )
    text += " and ".join(settings(one.values) for one in ranges.single[:2]) + "."
    if worst.cold is not None and not (isinstance(worst.cold, Signature) and worst.cold.impacts == 0):
        text += f" In that combination the motion from the cold start has impacts, though ({worst.cold})."
    return text


def _where_it_would_hold(ranges: AcrossRanges, many: str) -> tuple[str, str]:
    """Of a pair whose teeth separate as it is."""
    some = [one for one in ranges.varied if one.broken and _quiet(one)]
    if not some:
        text = f"No motion without impacts was found over the range of any of its {many}, one at a time."
        return f"within the ranges of its {many}, one at a time, no motion without impacts was found", text
    named = listed([_quiet(one) for one in some])
    text = f"All else {as_is(ranges)}, a motion without impacts exists if {named}."
    return f"within the ranges of its {many} a motion without impacts exists if {named}", text


def measure(found: Assessment) -> str:
    """What ends contact where it comes to nothing: how far teeth are pressed in, or the force on them."""
    contact = found.attractor.propagators.system.clearances[0].contact
    return "mesh force" if contact is ContactRule.NO_TENSION else "deflection"


def listed(said: Sequence[str]) -> str:
    """The first ones, and how many more there are: one more is named as well."""
    shown = said[:NAMED] if len(said) > NAMED + 1 else said
    more = len(said) - len(shown)
    return ", or if ".join(shown) + (f", and for {more} more of its ranges (listed below)" if more else "")


def _broken(one: Varied) -> str:
    return f"{one.input.path} is {_intervals(one.input, one.broken)}"


def _quiet(one: Varied) -> str:
    """Where teeth stay in contact."""
    free = outside([one.broken], one.input.lower, one.input.upper)
    return f"{one.input.path} is {_intervals(one.input, free)}" if free else ""


def _intervals(one: ToleranceInput, bands: tuple[tuple[float, float], ...]) -> str:
    """``above 11.2 µm (its range: 0 to 16.3 µm)``."""
    unit = f" {pretty(one.unit)}".rstrip()
    said = []
    for low, high in bands:
        if low <= one.lower and high >= one.upper:
            said.append("anywhere")
        elif low <= one.lower:
            said.append(f"below {number(high, 3)}{unit}")
        elif high >= one.upper:
            said.append(f"above {number(low, 3)}{unit}")
        else:
            said.append(f"from {number(low, 3)} to {number(high, 3)}{unit}")
    return f"{' or '.join(said)} (its range: {number(one.lower, 3)} to {number(one.upper, 3)}{unit})"


def speed_ends(found: Assessment, words: Words) -> str:
    """How near the ends of the band of speed come to the present speed, at the worst values: those within the
    range of speed that is stated, where there is one; beyond it the pair is not to run."""
    ranges = found.ranges
    assert ranges is not None
    corners = [*ranges.single, *([ranges.together] if ranges.together is not None else [])]
    said, stated = [], stated_speeds(found.case)
    for corner in corners:
        near = _nearest(corner, found.here, stated)
        if near is None:
            continue
        what = settings(corner.values) if len(corner.values) == 1 else "the worst combination found"
        side = "above" if near > found.here else "below"
        share = percent(100.0 * abs(near - found.here) / found.here)
        within = "" if stated is None else ", within the range of speed that is stated"
        said.append(f"with {what} at {words.speed(near)}, {share} % {side}{within}")
    return f" Around the present speed it ends {'; '.join(dict.fromkeys(said))}." if said else ""


def _nearest(corner: Corner, here: float, within: tuple[float, float] | None) -> float | None:
    """The end of the band of speed that lies nearest, as an ω of the case; ``within`` leaves out others."""
    speeds = corner.speeds
    if speeds is None or not speeds.here:
        return None
    ends = [corner.unit * end for end in (speeds.lower, speeds.upper) if end is not None]
    ends = [end for end in ends if within is None or within[0] < end < within[1]]
    return min(ends, key=lambda end: abs(end - here), default=None)


def _together(corner: Corner) -> str:
    first = dict(list(corner.values.items())[:MOST])
    more = len(corner.values) - len(first)
    return settings(first) + (f" and {more} more (listed at the end)" if more else "")


def settings(values: Mapping[str, str]) -> str:
    """``mesh.error = 16.3 µm, …``."""
    return ", ".join(f"{path} = {shown(text)}" for path, text in values.items())


def shown(text: str) -> str:
    """A value with its unit, to three digits."""
    size, _, unit = text.partition(" ")
    return f"{number(float(size), 3)} {pretty(unit)}".rstrip()


def _typed(text: str) -> str:
    """A value as it is typed, to six digits."""
    size, _, unit = text.partition(" ")
    return f"{float(size):.6g} {unit}".rstrip()


def _percent(share: float) -> str:
    return f"{number(100.0 * share, 3)} %"


def limits_of(value: Value) -> str:
    """``60 to 140 µm, here 100 µm, the middle of its limits``."""
    unit = f" {pretty(value.unit)}".rstrip()
    assert value.least is not None
    assert value.greatest is not None
    why = f", {MIDDLE}" if MIDDLE in value.reason else ""
    ends = f"{number(value.least, 5)} to {number(value.greatest, 5)}{unit}"
    return f"{ends}, here {number(float(value.value), 5)}{unit}{why}"


def counted(varied: Sequence[Varied]) -> str:
    """``12 estimates and 2 values with stated limits``."""
    stated = sum(one.input.of_case for one in varied)
    said = []
    for count, one, several in (
        (len(varied) - stated, "estimate", "estimates"),
        (stated, "value with stated limits", "values with stated limits"),
    ):
        said += [f"{count} {one if count == 1 else several}"] if count else []
    return " and ".join(said)


def as_is(ranges: AcrossRanges) -> str:
    """Of everything else: estimated, or as the case has it where limits of stated values are looked at."""
    return "as the case has it" if any(one.input.of_case for one in ranges.varied) else "as estimated"


def _whose(ranges: AcrossRanges) -> str:
    stated = {one.input.of_case for one in ranges.varied}
    both = "Estimates and values with stated limits"
    return both if len(stated) == 2 else "Values with stated limits" if True in stated else "Estimates"


def table(found: Assessment) -> Iterator[Block]:
    """Every range with what it takes, and the worst combination."""
    ranges = found.ranges
    if ranges is None or not ranges.varied:
        return
    rows: list[tuple[Cell, ...]] = []
    of_teeth = measure(found)
    for one in sorted(ranges.varied, key=lambda each: (isnan(each.margin), each.margin)):
        unit = f" {pretty(one.input.unit)}".rstrip()
        low, high = number(one.input.lower, 3), number(one.input.upper, 3)
        least = _percent(one.margin) if isfinite(one.margin) else "none: not stable"
        said = (
            f"not if {_intervals(one.input, one.broken).partition(' (')[0]}" if one.broken else "everywhere"
        )
        origin = ", stated" if one.input.of_case else ""
        rows.append(
            (one.input.path, f"{low} to {high}{unit}{origin}", f"{number(one.worst, 3)}{unit}", least, said)
        )
    caption = (
        f"{_whose(ranges)}, each over its range at the present speed, all else {as_is(ranges)} "
        f"({_percent(ranges.margin)}): the value at which teeth are pressed together least in the motion of "
        f"a mesh held closed, the least {of_teeth} at the teeth there over the static one (below 0 they "
        "would have to pull, and part instead), and where they stay in contact. Other motions were not "
        "looked for."
    )
    head = ("value", "range", "worst at", f"least {of_teeth}", "in contact")
    yield Table("ranges", caption, head, tuple(rows), widths=(25, 22, 14, 16, 23))
    worst = ranges.together
    if worst is not None and len(worst.values) > 1:
        options = " ".join(f"--set '{path}={_typed(text)}'" for path, text in worst.values.items())
        found_there = _percent(worst.margin) if isfinite(worst.margin) else "no stable motion"
        if worst.margin > 0.0:
            said = f"The worst combination found, by moving one value after the other ({found_there}; "
            yield Text.of(f"{said}worse ones between are not excluded): {options}")
        else:
            said = (
                "A combination with which teeth do not stay in contact, found by moving one value after the "
            )
            yield Text.of(
                f"{said}other until that was so ({found_there}; worse ones were not looked for): {options}"
            )
