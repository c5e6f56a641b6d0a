"""Values of ranges at which teeth are pressed together least: of one range, and of all together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import ceil, inf, isnan, log

import numpy as np

from gearlash.case import Case
from gearlash.results.tolerance import ToleranceInput
from gearlash.system import GearlashError

from .impact_free import closed_margin, static_compression

FACTOR = 1.08
"""From one value to the next in a range that spans a factor: of a stiffness 4 % of a natural frequency, and
where the margin is least a closer look finds what lies between."""
EVEN = 5
"""Values of other ranges, both ends included."""
AROUND = 13
"""Of an angle that may be any."""
FIRST = 7
"""Of every range where a combination is searched for, the first time; then its ends and what lies beside."""
ROUNDS = 4
"""How often every range is moved at most."""
WORSE = 1e-4
"""Of the static compression: what a move must take to be made."""


def margin_of(case: Case, values: Mapping[str, str]) -> float:
    """Least compression of the motion of teeth that never part, over the static one; -inf where it is not
    stable, and where no pair can have these values; 0 where no torque presses the teeth; NaN where it was not
    solved for."""
    try:
        member = member_of(case, values)
        family, static = member.family()[0], static_compression(member)
        if static == 0.0:
            return 0.0
        return closed_margin(family.system(), 1 if family.defaults["load"] > 0.0 else -1) / static
    except GearlashError:
        return -inf


def member_of(case: Case, values: Mapping[str, str]) -> Case:
    """The case with other values. Raises `GearlashError` where no pair can have them."""
    return case.with_overrides(values) if values else case


def values_of(one: ToleranceInput) -> list[float]:
    """Ascending values from one end of a range to the other."""
    low, high = one.lower, one.upper
    if one.unit == "deg" and high - low >= 360.0:
        return np.linspace(low, high, AROUND).tolist()
    if low * high > 0.0:
        small, large = sorted((abs(low), abs(high)))
        count = ceil(log(large / small) / log(FACTOR))
        if count >= EVEN:
            sign = 1.0 if low > 0.0 else -1.0
            inner = np.geomspace(small, large, count + 1)[1:-1]
            return [low, *sorted((sign * inner).tolist()), high]
    return np.linspace(low, high, EVEN).tolist()


def worst_together(
    case: Case, inputs: Sequence[ToleranceInput], begin: Mapping[str, str]
) -> tuple[dict[str, str], float]:
    """A bad combination, and its margin, from the values of ``begin`` on, all others as the case has them.

    One range after the other is put where it makes things worst, all others held, until none does, or until
    teeth would have to pull: so few values are named where few suffice. Ranges that take nothing alone are
    moved as well: a mesh a little stiffer matters once a bearing is near its resonance.
    """
    looked: dict[frozenset[tuple[str, str]], float] = {}  # a later round meets many combinations again

    def margin(of: Mapping[str, str]) -> float:
        key = frozenset(of.items())
        if key not in looked:
            looked[key] = margin_of(case, of)
        return looked[key]

    values, least = dict(begin), margin(begin)
    least = inf if isnan(least) else least
    for count in range(ROUNDS):
        before = least
        for one in inputs:
            if not least > 0.0:
                return values, least
            for text in _tried(one, values.get(one.path), FIRST if count == 0 else 2):
                found = margin({**values, one.path: text})
                if found < least - WORSE:
                    values, least = {**values, one.path: text}, found
        if least == before:
            break
    return values, least


def _tried(one: ToleranceInput, now: str | None, count: int) -> list[str]:
    """Values all over a range, and those beside the present one: so a resonance that moved is followed."""
    every = values_of(one)
    at = one.nominal if now is None else float(now.partition(" ")[0])
    nearest = int(np.argmin(np.abs(np.array(every) - at)))
    spread = {round(share * (len(every) - 1)) for share in np.linspace(0.0, 1.0, count)}
    beside = {near for near in range(nearest - 2, nearest + 3) if 0 <= near < len(every)}
    return [text for text in (one.text(every[k]) for k in sorted(spread | beside)) if text != now]
