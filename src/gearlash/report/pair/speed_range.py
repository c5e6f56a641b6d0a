"""May the pair run over the whole range of speed that its case states, in words."""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.results.pair_question import stated_speeds
from gearlash.studies.assessment import Assessment
from gearlash.studies.speeds_across import STEP, SpeedsAcross

from .ranges import as_is, counted, settings
from .words import Words

NAMED = 5
"""Values of estimates that are named with their speeds."""


@dataclass(frozen=True)
class OverSpeed:
    """What is said of the range of speed that a case states.

    Parameters
    ----------
    free : bool
        Whether no motion was found in it in which teeth separate.
    holds : bool
        Whether that is so at the ends of ranges of estimates and of stated limits, too.
    told : bool
        Whether all of it was examined to the end, or motion with impacts was found in it.
    first : str
        A sentence for the first line.
    text : str
        A line.
    """

    free: bool
    holds: bool
    told: bool
    first: str
    text: str


def speed_range(found: Assessment, words: Words) -> OverSpeed | None:
    """None where the case states no range of speed."""
    stated = stated_speeds(found.case)
    if stated is None:
        return None
    low, high = stated
    reach = words.reach(low, high)
    first, last = (float(found.axis.values[i]) for i in (0, -1))
    bands = [b for b in found.separating if b.upper.value > low and b.lower.value < high]
    if not found.searched:
        return _not_told(f"Not looked for to the end in {reach}.")
    if bands:
        return _not_free(f"Not at every speed from {reach}: teeth separate at {words.bands(bands)}.")
    if first > low or last < high:
        seen = words.reach(first, last)
        return _not_told(f"Not told for all of {reach}: examined was {seen}, where none separate.")
    open_ = [one for one in found.not_told if one.upper.value > low and one.lower.value < high]
    if open_:
        where = " and ".join(words.span(one.lower, one.upper) for one in open_)
        return _not_told(f"Not told for all of {reach}: at {where} not all was followed or settled.")
    free = f"From {reach} no motion was found in which teeth separate"
    if found.ranges is None or not found.ranges.speeds:
        return OverSpeed(True, True, True, f"{free}.", f"{free}.")
    looked = f"speeds {100.0 * (STEP - 1.0):.0f} % apart, closer where teeth are pressed together least"
    parting = found.ranges.parting
    if not parting:
        return OverSpeed(True, True, True, f"{free}.", f"{free}. {_nor(found, looked)}")
    own = as_is(found.ranges)
    what = "an estimate" if own == "as estimated" else "a value"
    short = f"{free}, {own}; with {what} elsewhere in its range they do."
    shown = parting[: NAMED if len(parting) > NAMED + 1 else None]
    more = len(parting) - len(shown)
    text = "; ".join(_parting(one, words) for one in shown)
    text += f"; and with {more} more" if more else ""
    said = f"No motion without impacts exists {text}; all else {own} ({looked})."
    return OverSpeed(True, False, True, short, f"{free}, {own}. {said}")


def _not_free(text: str) -> OverSpeed:
    return OverSpeed(False, False, True, text, text)


def _not_told(text: str) -> OverSpeed:
    return OverSpeed(False, False, False, text, text)


def _nor(found: Assessment, looked: str) -> str:
    assert found.ranges is not None
    many = counted(found.ranges.varied)
    return (
        f"At {looked}, a motion without impacts exists with each of its {many} at both ends of its range, "
        "one at a time, and in the worst combination found at the present speed."
    )


def _parting(one: SpeedsAcross, words: Words) -> str:
    what = settings(one.values) if len(one.values) == 1 else "the combination found at the present speed"
    return "at " + " and ".join(words.reach(low, high) for low, high in one.parting) + f" with {what}"
