"""The plain sentence that a run begins with."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from itertools import pairwise
from math import floor
from typing import TYPE_CHECKING

from gearlash.case import Case
from gearlash.case.edges import shown_edge
from gearlash.results.beside import Beside, BesideMotion
from gearlash.results.impact_free import ImpactFree
from gearlash.results.pair_units import stated_at_gear
from gearlash.system import Label, MotionKind, Signature

from .excitation import Unexcited, at_rest
from .motion import MotionNumbers, OtherClearance
from .parts import PhysicalValue, rests_on

if TYPE_CHECKING:  # answers are described without the engine
    from gearlash.orbits import Attractor

ASSUMED_MARK = "†"  # behind a physical number that rests on an assumed value
MANY = 64  # mesh cycles: of more only an average is given, as mostly the motion does not repeat
PHASE_ROUNDING = 1e-9  # of a phase
TIMES = {1: "once", 2: "twice"}
NO_TORQUE = "state the torque that bearings, seals and oil take without load"
LOST = {"stability": "unstable", "unsolved": "not solved for"}
"""How a motion without impacts ends where it does not touch."""


def run_sentence(
    case: Case,
    parameters: Mapping[str, float],
    attractor: Attractor,
    numbers: MotionNumbers | None,
    impact_free: ImpactFree | None,
    beside: Beside | None,
    idle: Unexcited | None,
) -> str:
    """Such as ``3600 rpm: 1-1, teeth separate once per mesh cycle; nearest impact-free motion found at 3715
    rpm; 5 other starts lead to the same motion``."""
    from gearlash.orbits import Neutral, Orbit, Unresolved

    speed = _Speed(case, numbers, parameters["omega"])
    here = speed.here
    if idle is not None:
        return f"{here}: {_idle(case, attractor, numbers, idle)}"
    if isinstance(attractor, Neutral) and case.between_teeth and parameters.get("load") == 0.0:
        return f"{here}: no torque presses the teeth together, and they float in the backlash; {NO_TORQUE}"
    if isinstance(attractor, Unresolved | Neutral) or numbers is None:
        return f"{here}: {attractor.label}, {attractor.message}"
    label = attractor.signature.short if isinstance(attractor, Orbit) else "aperiodic"
    parts = [f"{here}: {label}, {_doing(case, attractor, numbers)}"]
    if impact_free is not None:
        parts += _quiet(impact_free, speed, free_now=not numbers.events)
    parts[1:1] = [met(other.name, other, numbers.cycles) for other in numbers.others]
    return "; ".join([*parts, coexisting(beside, attractor.label)])


def _doing(case: Case, attractor: Attractor, numbers: MotionNumbers) -> str:
    """What happens in the first clearance, which need not be between teeth."""
    if case.between_teeth:
        return contacts(numbers)
    return met(attractor.propagators.system.clearances[0].name, numbers, numbers.cycles)


def _idle(case: Case, attractor: Attractor, numbers: MotionNumbers | None, idle: Unexcited) -> str:
    """That nothing was asked, and what is there all the same."""
    if numbers is None:
        there = attractor.message
    elif at_rest(attractor):
        there = f"it rests, {_doing(case, attractor, numbers)}"
    else:
        there = f"from this start it moves by itself, {attractor.label}"
    return f"{idle.cause}; {there}; {idle.advice}"


def coexisting(beside: Beside | None, own: Label) -> str:
    """What other starts lead to, beside a motion labelled ``own``: ``4 of 5 other starts lead to other
    motions: 2-1, aperiodic``."""
    if beside is None or not beside.starts:
        return "motions that may coexist were not looked for"
    tried, elsewhere = beside.starts, sum(motion.starts for motion in beside.others)
    starts = f"{tried} other start{'s' if tried > 1 else ''}"
    lead = "leads" if tried == 1 else "lead"
    if beside.same == tried:
        same = "aperiodic motion, too" if own is MotionKind.APERIODIC else "the same motion"
        return f"{starts} {lead} to {same}"
    said = []
    if elsewhere:
        names = ", ".join(_named(motion, own) for motion in beside.others)
        what = "another motion" if len(beside.others) == 1 else "other motions"
        lead = "leads" if elsewhere == 1 else "lead"
        said.append(f"{elsewhere} of {starts} {lead} to {what}: {names}")
    if beside.undecided:
        of = "" if said else f" of {starts}"
        said.append(f"{beside.undecided}{of} settled to nothing in the time given")
    return ", ".join(said)


def _named(motion: BesideMotion, own: Label) -> str:
    label = motion.label.short if isinstance(motion.label, Signature) else str(motion.label)
    label = f"a different {label}" if motion.label == own else label
    return label if motion.impacts else f"{label}, without impacts"


def contacts(numbers: MotionNumbers) -> str:
    """What teeth do, in words."""
    drive, back = impacts(numbers, "drive"), impacts(numbers, "back")
    if not drive and not back:
        if numbers.share_without_contact == 1.0:
            return "teeth never touch"
        side = " on the back side" if numbers.distances.back.maximum <= 0.0 else ""
        return f"teeth stay in contact{side}"
    if not back:
        return f"teeth separate {rate(drive, numbers.cycles)}"
    if not drive:
        return f"teeth separate on the back side {rate(back, numbers.cycles)}"
    on_drive, on_back = rate(drive, numbers.cycles), rate(back, numbers.cycles)
    return f"teeth hit the drive side {on_drive} and the back side {on_back}"


def impacts(gap: MotionNumbers | OtherClearance, side: str) -> list[float]:
    """Phases of the impacts on a side."""
    return [e.phase for e in gap.events if e.event == "engagement" and e.side == side]


def met(name: str, gap: MotionNumbers | OtherClearance, cycles: float) -> str:
    """What happens in a clearance, between teeth or not: ``bearing met on side + once per cycle``."""
    found = [(impacts(gap, side), sign) for side, sign in (("drive", "+"), ("back", "-"))]
    each = [f"on side {sign} {rate(phases, cycles)}" for phases, sign in found if phases]
    if each:
        return f"{name} met {' and '.join(each)}".replace("mesh cycle", "cycle")
    if gap.share_without_contact == 1.0:
        return f"{name} never in contact"
    return f"{name} always in contact on side {'-' if gap.distances.back.maximum <= 0.0 else '+'}"


def rate(phases: Sequence[float], cycles: float) -> str:
    """``once per mesh cycle``, ``3 times in 6 mesh cycles``, ``1.4 times per mesh cycle on average``."""
    count, cycles = len(phases), round(cycles)
    if cycles > MANY:
        average = f"{count / cycles:.2g}"
        return f"{'about once' if average == '1' else f'{average} times'} per mesh cycle on average"
    if count % cycles == 0 and _evenly(phases, cycles):
        return f"{_times(count // cycles)} per mesh cycle"
    return f"{_times(count)} in {cycles} mesh cycles"


def _evenly(phases: Sequence[float], cycles: int) -> bool:
    """Are there as many in one cycle as in any other? Cycles are counted from where impacts are rarest."""
    within = sorted(phase % 1.0 for phase in phases)
    arcs = [later - earlier for earlier, later in pairwise([within[-1] - 1.0, *within])]
    first = within[arcs.index(max(arcs))]
    counts = Counter(floor((phase - first) % cycles + PHASE_ROUNDING) % cycles for phase in phases)
    return len(counts) == cycles and len(set(counts.values())) == 1


def _times(count: int) -> str:
    return TIMES.get(count, f"{count} times")


def physical_text(value: PhysicalValue, digits: int) -> str:
    """With unit, and a mark if it rests on assumed values."""
    unit = {"um": "µm", "N*m": "N·m"}.get(value.unit, value.unit)
    return f"{value.value:.{digits}g} {unit}{f' {ASSUMED_MARK}' if value.rests_on else ''}"


def _quiet(found: ImpactFree, speed: _Speed, free_now: bool) -> list[str]:
    """Where the motion of teeth that never part exists; of this motion, if it is that one."""
    if not found.here:
        if free_now:
            return ["how far this motion stays impact-free was not found"]
        if found.nearest is None:
            reach = f"from {speed.text(found.searched_from)} to {speed.text(found.searched_to)}"
            return [f"no impact-free motion was found {reach}, looked at in steps of {_steps(found)}"]
        inwards = 1 if found.nearest > speed.omega else -1
        return [f"nearest impact-free motion found at {speed.text(found.nearest, inwards)}"]
    if not free_now:
        return ["an impact-free motion exists at this speed too, from another start"]
    low = None if found.lower is None else speed.text(found.lower, 1)
    high = None if found.upper is None else speed.text(found.upper, -1)
    if low and high:
        ends = [f"from {low} to {high}"]
    elif low or high:
        to = found.searched_to if low else found.searched_from
        ends = [
            f"{'down' if low else 'up'} to {low or high}, and {'up' if low else 'down'} to "
            f"{speed.text(to)} at least"
        ]
    else:
        ends = [f"from {speed.text(found.searched_from)} to {speed.text(found.searched_to)} at least"]
    lost = [
        f"{LOST[why]} beyond {end}"
        for end, why in ((low, found.lower_ending), (high, found.upper_ending))
        if end and why in LOST
    ]
    beyond = f" ({', '.join(lost)})" if lost else ""
    return [f"this motion is impact-free {ends[0]}{beyond}, looked at in steps of {_steps(found)}"]


def _steps(found: ImpactFree) -> str:
    return f"{100.0 * found.step:.3g} %"


class _Speed:
    """Speeds as this case's user reads them: rpm, else ω."""

    def __init__(self, case: Case, numbers: MotionNumbers | None, omega: float):
        self.omega = omega
        self.scales = case.scales if case.scales.physical else None
        rests = rests_on(case, numbers is not None and numbers.distances.back.minimum < 0.0)
        self.asked = f" {ASSUMED_MARK}" if "speed" in rests else ""
        self.computed = f" {ASSUMED_MARK}" if "time" in rests or "model" in rests else ""
        self.of_gear = stated_at_gear(case, "omega", omega, 6)

    @property
    def here(self) -> str:
        """The present speed, as it was asked for."""
        value = self.omega if self.scales is None else float(self.scales.pinion_rpm(self.omega))
        near = round(value)
        whole = self.scales is not None and abs(value - near) <= 1e-6 * abs(value)
        shown = f"{near}" if whole else f"{value:.6g}"
        told = self._with_unit(shown) + self.asked
        return f"{self.of_gear} of the gear, {told}" if self.of_gear else told

    def text(self, omega: float, inwards: int = 0) -> str:
        """The end of an interval (see `shown_edge`)."""
        if self.scales is None:
            shown = shown_edge(omega, inwards, self.omega)
        else:
            value, beside = (float(self.scales.pinion_rpm(w)) for w in (omega, self.omega))
            shown = shown_edge(value, inwards, beside)
        return self._with_unit(shown) + (self.computed if inwards else self.asked)

    def _with_unit(self, shown: str) -> str:
        if self.scales is None:
            return f"ω = {shown}"
        return f"{shown} rpm of the pinion" if self.of_gear else f"{shown} rpm"
