"""The window without parting on the grid of speeds: real teeth, the lumped model, and what is reported."""

from __future__ import annotations

import re
from functools import cache

from gearlash.article.claims import load
from gearlash.article.verified import Verified, VerifiedPoint, VerifiedWay
from gearlash.report.blocks import Block, Cell, Table, Text
from gearlash.studies.verification.plan import AT_WINDOW

from .seen import HELD, NOT_COMPUTED, RULES, case_itself, has_label, parts, share
from .words import joined

RUN = re.compile(r"(\d+) to (\d+) rpm")
DIRECTIONS = ("rising", "falling")
KEPT_AS: dict[str, str] = dict(zip(DIRECTIONS, ("up", "down"), strict=True))
"""Their labels in the window of a way."""
ZONE = "frequency-zone"
"""The claim of the window without impacts of the article's lumped model."""


def blocks(found: Verified) -> list[Block]:
    """The table of windows and what it says beside the article's; nothing where no window was computed."""
    ways = [way for way in found.ways if way.up]
    if not ways:
        return []
    return [_table(found, ways), Text.of(_met(found, ways) + _differing(ways))]


def _table(found: Verified, ways: list[VerifiedWay]) -> Table:
    rows: list[tuple[Cell, ...]] = []
    grid, step, higher = ways[0].window["speed"], step_of(ways[0]), ways[0].points[-1].speed
    for way in ways:
        reported = reported_ends(found, way)
        last = NOT_COMPUTED if reported is None else f"{reported[0]:.0f} to {reported[1]:.0f} rpm"
        for direction, real, lumped in _both(way):
            rows.append((way.name, direction, real, *(lumped[rule] for rule in RULES), last))
    ends, case = reported_window(), [f"“{way.name}”" for way in ways if way.name not in HELD]
    speeds = f"; with {joined(case)} that is at the rpm of the case" if case else ""
    return Table(
        "table-verified-window",
        "Speeds of the grid at which teeth stay in contact, each begun from the motion at its neighbour; of "
        "the lumped model those with a periodic motion. The grid has steps of "
        f"{share(step / higher)} of the higher speed, from {grid[0] / higher:.2f} to "
        f"{grid[-1] / higher:.2f} of it: an end lies within a step beyond what is named, and what begins or "
        "ends with the grid may go on beyond. The last column is the article’s window of its lumped model, "
        f"ω {ends[0]} to {ends[1]}, at the speed that these inputs give it{speeds}.",
        ("inputs", "speed", "real teeth", *(f"lumped, {rule}" for rule in RULES), "reported"),
        tuple(rows),
        widths=(13, 9, 16, 16, 16, 16, 14),
    )


def _both(way: VerifiedWay) -> list[tuple[str, str, dict[str, str]]]:
    """Direction, real teeth, and the lumped model by rule."""
    return [(DIRECTIONS[0], way.up, way.lumped_up), (DIRECTIONS[1], way.down, way.lumped_down)]


def step_of(way: VerifiedWay) -> float:
    """Of its grid of speeds, rpm."""
    speeds = way.window["speed"]
    return (speeds[-1] - speeds[0]) / (len(speeds) - 1)


def runs(told: str) -> list[tuple[float, float]]:
    """Intervals of speeds as they are kept, rpm: ``3680 to 4320 rpm``; none for ``nowhere on the grid``."""
    return [(float(low), float(high)) for low, high in RUN.findall(told)]


@cache
def reported_window() -> tuple[float, float]:
    """ω between which the article reports that its lumped model has no impacts."""
    ends = next(claim.interval for claim in load() if claim.id == ZONE)
    assert ends is not None  # of every zone
    return ends


def reported_ends(found: Verified, way: VerifiedWay) -> tuple[float, float] | None:
    """The article's window in rpm at the inputs of a way; None without the way that has the ω of the case."""
    case = case_itself(found)
    if case is None:
        return None
    scale, (low, high) = way.points[-1].speed / case.points[-1].omega, reported_window()
    return low * scale, high * scale


def _met(found: Verified, ways: list[VerifiedWay]) -> str:
    """At how many windows an end lies within the step of the grid in which the reported one lies."""
    said, nowhere = [], (_nowhere(ways), "")
    for end, which in enumerate(("lower", "upper")):
        real = [_end_met(found, way, told, end) for way in ways for _, told, _ in _both(way)]
        lumped = [
            sum(_end_met(found, way, told[rule], end) for way in ways for _, _, told in _both(way))
            for rule in RULES
        ]
        said.append(
            f"the {which} end with {sum(real)} of {len(real)} windows of real teeth{nowhere[end]}, and with "
            f"{', '.join(map(str, lumped))} of {len(real)} of the lumped model"
        )
    rules = ", ".join(f"“{rule}”" for rule in RULES)
    return (
        f"The computed end and the reported one lie in the same step of the grid: {'; '.join(said)} (under "
        f"{rules})."
    )


def _nowhere(ways: list[VerifiedWay]) -> str:
    """Windows of real teeth that have no end which could be met."""
    none = sum(not runs(speeds) for way in ways for _, speeds, _ in _both(way))
    return f" (with {none} of them teeth stay in contact nowhere on the grid)" if none else ""


def _end_met(found: Verified, way: VerifiedWay, told: str, end: int) -> bool:
    """Whether the reported end lies between the last speed in contact and the next one of the grid."""
    reported, intervals = reported_ends(found, way), runs(told)
    if reported is None or not intervals:
        return False
    step = step_of(way)
    seen = intervals[0][0] if end == 0 else intervals[-1][1]
    beyond = seen - step if end == 0 else seen + step
    return min(seen, beyond) - 0.5 <= reported[end] <= max(seen, beyond) + 0.5


def _differing(ways: list[VerifiedWay]) -> str:
    """At how many points of the grid one model parts and the other does not."""
    count = len(DIRECTIONS) * sum(len(way.window["speed"]) for way in ways)
    counts = [
        str(sum(len(speeds) for way in ways for speeds in way.apart_differs.get(rule, []))) for rule in RULES
    ]
    return (
        f" One model parts and the other does not at {', '.join(counts)} of {count} points of the grid (in "
        "that order of rules; all inputs, both directions; an unresolved motion counts as no difference)."
    )


def coexisting(found: Verified, way: VerifiedWay) -> str:
    """Speeds at which teeth begun pressed together part, and begun from a neighbour stay in contact."""
    said = [
        f" Begun from the motion at the neighbouring speed, {joined(directions)}, teeth stay in contact at "
        f"{point.speed:.0f} rpm{_settled(found, way, point, directions)}: both motions were found there."
        for point in way.points
        if (directions := _in_contact(way, point))
    ]
    return "".join(said)


def other_motion(way: VerifiedWay, point: VerifiedPoint) -> str:
    """Directions of the grid in which teeth that part, begun pressed together, stay in contact."""
    return joined(_in_contact(way, point))


def _in_contact(way: VerifiedWay, point: VerifiedPoint) -> list[str]:
    if not parts(point.label, point.apart):
        return []
    return [direction for direction, speeds, _ in _both(way) if _within(speeds, point.speed)]


def _settled(found: Verified, way: VerifiedWay, point: VerifiedPoint, directions: list[str]) -> str:
    """What those motions are after the cycles that the window gives them; nothing between its speeds."""
    at = _index(way, point.speed)
    if at is None:
        return ""
    labels = dict.fromkeys(way.window[KEPT_AS[direction]][at] for direction in directions)
    each = [label if has_label(label) else "not repeating within 1 %" for label in labels]
    cycles = next(one["settle"] for one in found.settings if one["name"] == AT_WINDOW.name)
    return f" ({joined(each)} after {cycles} mesh cycles)"


def _within(told: str, speed: float) -> bool:
    return any(low - 0.5 <= speed <= high + 0.5 for low, high in runs(told))


def from_neighbours(way: VerifiedWay, point: VerifiedPoint, label: str) -> str:
    """From which neighbours a label was found at a speed of the grid, in words."""
    at = _index(way, point.speed)
    if at is None:
        return ""
    began = [direction for direction in DIRECTIONS if way.window[KEPT_AS[direction]][at] == label]
    if len(began) == len(DIRECTIONS):
        return "from both neighbours on the grid"
    return f"from its neighbour on the grid ({began[0]})" if began else ""


def lumped_from_neighbours(way: VerifiedWay, point: VerifiedPoint, rule: str, steps: int = 0) -> set[str]:
    """Labels of the lumped model on the grid, so many steps from a speed; empty where the grid has none."""
    at = _index(way, point.speed)
    if at is None or not 0 <= at + steps < len(way.window["speed"]):
        return set()
    return {way.window[which][rule][at + steps] for which in ("lumped_up", "lumped_down")}


def _index(way: VerifiedWay, speed: float) -> int | None:
    """Of a speed in the grid."""
    near = (i for i, each in enumerate(way.window.get("speed", ())) if abs(each - speed) <= 0.5)
    return next(near, None)


def beside_points(way: VerifiedWay) -> str:
    """How near the speeds at which teeth part are to the window on the grid."""
    intervals = [runs(told) for _, told, _ in _both(way)]
    if not all(intervals):
        return ""
    said = []
    for point in way.points:
        if not parts(point.label, point.apart) or any(
            _within(told, point.speed) for _, told, _ in _both(way)
        ):
            continue
        ends = [end for each in intervals for run in each for end in run]
        near = min(ends, key=lambda end: abs(end - point.speed))
        said.append(f" The nearest speed of the grid in contact is {near:.0f} rpm: {point.speed:.0f} rpm is ")
        steps = abs(near - point.speed) / step_of(way)
        said.append("beside the edge." if steps < 1.5 else f"{steps:.0f} steps of the grid from the edge.")
    return "".join(said)
