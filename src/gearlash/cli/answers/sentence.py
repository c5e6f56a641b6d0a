"""The plain sentence that a run begins with."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from math import ceil, floor
from typing import TYPE_CHECKING

from gearlash.case import Case

from .impact_free import ImpactFree
from .motion import MotionNumbers, OtherClearance
from .parts import PhysicalValue, rests_on

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.orbits import Attractor

MARK = "†"  # behind a physical number that rests on an assumed value
TIMES = {1: "once", 2: "twice"}
DIGITS = 4  # of a speed that is not in rpm


def run_sentence(
    case: Case,
    parameters: Mapping[str, float],
    attractor: Attractor,
    numbers: MotionNumbers | None,
    impact_free: ImpactFree | None,
) -> str:
    """Such as ``3600 rpm: 1-1, teeth separate once per mesh cycle; nearest impact-free speed 3715 rpm``."""
    from gearlash.orbits import Orbit, Unresolved

    speed = _Speed(case, numbers)
    here = speed.text(parameters["omega"])
    if isinstance(attractor, Unresolved) or numbers is None:
        return f"{here}: {attractor.label}, {message_of(attractor)}"
    label = attractor.signature.short if isinstance(attractor, Orbit) else "aperiodic"
    own = case.structure.get("clearance")  # of a system that need not have teeth
    doing = met(own[0]["name"], numbers, numbers.cycles) if own else contacts(numbers)
    parts = [f"{here}: {label}, {doing}"]
    if impact_free is not None:
        parts += _quiet(impact_free, speed, free_now=not numbers.events)
    return "; ".join([*parts, *(met(other.name, other, numbers.cycles) for other in numbers.others)])


def message_of(attractor: Attractor) -> str:
    """What the search says, without the advice that goes with its status."""
    return attractor.message.removesuffix(f": {attractor.status.advice}")


def contacts(numbers: MotionNumbers) -> str:
    """What teeth do, in words."""
    drive = sum(e.event == "engagement" and e.side == "drive" for e in numbers.events)
    back = sum(e.event == "engagement" and e.side == "back" for e in numbers.events)
    cycles = round(numbers.cycles)
    if not drive and not back:
        if numbers.share_without_contact == 1.0:
            return "teeth never touch"
        side = " on the back side" if numbers.distances.back.maximum <= 0.0 else ""
        return f"teeth stay in contact{side}"
    if not back:
        return f"teeth separate {rate(drive, cycles)}"
    if not drive:
        return f"teeth separate on the back side {rate(back, cycles)}"
    return f"teeth hit the drive side {rate(drive, cycles)} and the back side {rate(back, cycles)}"


def met(name: str, gap: MotionNumbers | OtherClearance, cycles: float) -> str:
    """What happens in a clearance, between teeth or not: ``bearing met on side + once per cycle``."""
    counts = [
        (sum(e.event == "engagement" and e.side == side for e in gap.events), sign)
        for side, sign in (("drive", "+"), ("back", "-"))
    ]
    each = [f"on side {sign} {rate(n, round(cycles))}" for n, sign in counts if n]
    if each:
        return f"{name} met {' and '.join(each)}".replace("mesh cycle", "cycle")
    if gap.share_without_contact == 1.0:
        return f"{name} never in contact"
    return f"{name} always in contact on side {'-' if gap.distances.back.maximum <= 0.0 else '+'}"


def rate(count: int, cycles: int) -> str:
    """``once per mesh cycle``, ``3 times in 6 mesh cycles``, ``1.4 times per mesh cycle on average``."""
    if count % cycles == 0:
        return f"{_times(count // cycles)} per mesh cycle"
    if cycles > 64:  # a stretch of a motion that does not repeat
        return f"{count / cycles:.2g} times per mesh cycle on average"
    return f"{_times(count)} in {cycles} mesh cycles"


def _times(count: int) -> str:
    return TIMES.get(count, f"{count} times")


def physical_text(value: PhysicalValue, digits: int) -> str:
    """With unit, and a mark if it rests on assumed values."""
    unit = {"um": "µm", "N*m": "N·m"}.get(value.unit, value.unit)
    return f"{value.value:.{digits}g} {unit}{f' {MARK}' if value.rests_on else ''}"


def _quiet(found: ImpactFree, speed: _Speed, free_now: bool) -> list[str]:
    if not found.here:
        if found.nearest is None:
            reach = f"from {speed.text(found.searched_from)} to {speed.text(found.searched_to)}"
            return [f"no impact-free speed was found {reach}"]
        up = found.nearest > (found.searched_from * found.searched_to) ** 0.5
        return [f"nearest impact-free speed {speed.text(found.nearest, towards=1 if up else -1)}"]
    low = None if found.lower is None else speed.text(found.lower, towards=1)
    high = None if found.upper is None else speed.text(found.upper, towards=-1)
    if not free_now:
        return ["an impact-free motion exists at this speed too, from another start"]
    if low and high:
        return [f"impact-free from {low} to {high}"]
    if low or high:
        return [f"impact-free down to {low}" if low else f"impact-free up to {high}"]
    return []


class _Speed:
    """Speeds as this case's user reads them: rpm, else ω."""

    def __init__(self, case: Case, numbers: MotionNumbers | None):
        self.scales = case.scales if case.scales.physical else None
        rests = rests_on(case, numbers is not None and numbers.distances.back.minimum < 0.0)
        self.asked = f" {MARK}" if "speed" in rests else ""
        self.computed = f" {MARK}" if "time" in rests or "model" in rests else ""

    def text(self, omega: float, towards: int = 0) -> str:
        """Rounded up (+1), down (-1) or to the nearest (0): a bound stays on its impact-free side."""
        shown = self.plain(omega, {1: ceil, -1: floor, 0: round}[towards])
        return shown + (self.computed if towards else self.asked)

    def plain(self, omega: float, turn: Callable[[float], int]) -> str:
        if self.scales is None:
            unit = 10.0 ** (DIGITS - 1)
            return f"ω = {turn(omega * unit) / unit:g}"
        rpm = float(self.scales.pinion_rpm(omega))
        near = round(rpm)
        if abs(rpm - near) <= 1e-6 * abs(rpm):
            return f"{near} rpm"
        return f"{turn(rpm)} rpm" if rpm >= 100.0 else f"{rpm:.4g} rpm"
