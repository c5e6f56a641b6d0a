"""Lines through the rectangle: sweeps along them in both directions, and the branches of what they show."""

from __future__ import annotations

from dataclasses import dataclass

from gearlash.branches.continuation import Branch
from gearlash.jobs import Chain, Execution, Part
from gearlash.orbits import Settings
from gearlash.results import Axis
from gearlash.studies.follow_tasks import Question
from gearlash.studies.followed import Followed
from gearlash.studies.model import Source
from gearlash.studies.sweep import sweeps
from gearlash.system import Label

WAYS = ("up", "down")


@dataclass(frozen=True, eq=False)
class AlongLine:
    """A task: ``along`` takes its values, ``fixed`` are all others that were set, the other axis' among
    them."""

    source: Source
    fixed: tuple[tuple[str, float], ...]
    along: Axis
    across: str
    start: tuple[float, ...] | None
    settings: Settings
    longest: int


@dataclass(frozen=True, eq=False)
class OnLine:
    """What a line shows: branches, and the motions that have none here, with their value and why."""

    name: str
    across: str
    value: float
    branches: tuple[Branch, ...]
    missing: tuple[tuple[Label, float, str], ...]

    @property
    def way(self) -> str:
        return f"of a branch in {self.name} at {self.across} = {self.value:.6g}"


def line_chains(
    source: Source,
    axes: tuple[Axis, Axis],
    fixed: dict[str, float],
    start: tuple[float, ...] | None,
    settings: Settings,
    count: int,
    longest: int,
) -> list[Chain]:
    """A chain of one task for each of ``count`` lines along either axis, evenly spread."""
    found = []
    for along, across in (axes, axes[::-1]):
        first, last = float(across.values[0]), float(across.values[-1])
        for i in range(count):
            value = first + (last - first) * (2 * i + 1) / (2 * count)
            line = tuple({**fixed, across.name: value}.items())
            task = AlongLine(source, line, along, across.name, start, settings, longest)
            found.append(Chain((along.name, i), (task,), (1,)))
    return found


def follow_line(task: AlongLine, carry: object) -> Part:
    """The branches of a line: through all that both sweeps show, and on from there at doublings."""
    family, axis = task.source.family(), task.along
    ways = sweeps(family, axis, WAYS, values=dict(task.fixed), start=task.start, settings=task.settings)
    low, high = float(axis.values[0]), float(axis.values[-1])
    question = Question(task.source, task.fixed, axis.name, low, high, task.settings)
    reason = next((sweep.message for sweep in ways if not sweep.complete), "")
    followed = Followed(question, Execution(), reason=reason, longest=task.longest)
    points = [(str(sweep.direction), point) for sweep in ways for point in sweep.points]
    followed.add((way, point) for way, point in points if point.period <= task.longest)
    followed.switch()
    missing = [(p.label, p.value, why) for p, why in followed.unfollowed if p.label is not None]
    value = dict(task.fixed)[task.across]
    return Part((OnLine(axis.name, task.across, value, tuple(followed.branches), tuple(missing)),))
