"""The sweeps behind the study: every direction of a parameter, with what changes along it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass

from gearlash.case import Case
from gearlash.jobs import INTERRUPTED, Execution, ProgressCallback, UnfinishedError
from gearlash.orbits import Settings
from gearlash.results import Axis, Direction, Sweep
from gearlash.studies.sweep import sweeps
from gearlash.studies.transition import Transition
from gearlash.studies.transitions import transitions

Found = tuple[Transition, tuple[Direction, ...]]
"""A change that was solved for, and the sweeps that met it."""
STUDY_SETTINGS = Settings(
    budget=9_000, patience=600, exponent_periods=1_000
)  # base periods of one transient; what needs more is flagged, not guessed
PARTS = 4  # of a sweep: so that no worker waits for another to come to its end


@dataclass(frozen=True, eq=False)
class Row:
    """One direction of one parameter: its sweep and the transitions along it."""

    sweep: Sweep
    transitions: tuple[Transition, ...]

    @property
    def direction(self) -> Direction:
        return self.sweep.direction


def rows(
    case: Case,
    axis: Axis,
    fixed: Mapping[str, float],
    executor: Executor,
    progress: ProgressCallback | None = None,
    keep: Callable[[Sequence[Sweep]], None] | None = None,
) -> tuple[Row, ...]:
    """Sweeps cold, up and down, and what changes along each, on the executor's workers. ``keep`` gets the
    sweeps before that is looked for, which takes as long again."""
    done = sweeps(
        case, axis, values=fixed, settings=STUDY_SETTINGS, execution=Execution(executor, progress=progress)
    )
    if keep is not None:
        keep(done)
    stopped = next((each.message for each in done if not each.complete), "")
    if stopped == INTERRUPTED:
        raise KeyboardInterrupt
    if stopped:
        raise UnfinishedError(f"the sweeps over {axis.name} are not complete: {stopped}")
    text = case.to_json()
    found = [[executor.submit(locate, text, each, part) for part in range(PARTS)] for each in done]
    return tuple(
        Row(each, tuple(change for part in parts for change in part.result()))
        for each, parts in zip(done, found, strict=True)
    )


def locate(case_json: str, done: Sweep, part: int) -> tuple[Transition, ...]:
    """The transitions along one part of a sweep (a task for a worker)."""
    family, _ = Case.from_json(case_json).family()
    points = [point for point in done.points if point.computed]
    first, last = (place * max(0, len(points) - 1) // PARTS for place in (part, part + 1))
    rising = done.direction is not Direction.DOWN
    return transitions(family, done.axis.name, points[first : last + 1], values=done.fixed, rising=rising)


def distinct(rows: tuple[Row, ...]) -> list[Found]:
    """Solved transitions of all rows, each once, with the directions it was met in, by rising value."""
    found: list[tuple[Transition, list[Direction]]] = []
    for row in rows:
        for transition in row.transitions:
            if transition.point is None:
                continue
            for other, directions in found:
                if _same(transition, other):
                    if row.direction not in directions:
                        directions.append(row.direction)
                    break
            else:
                found.append((transition, [row.direction]))
    found.sort(key=lambda pair: pair[0].value)
    return [(transition, tuple(directions)) for transition, directions in found]


def _same(one: Transition, two: Transition) -> bool:
    close = abs(one.value - two.value) <= 1e-8 * abs(one.value)
    return close and (one.kind, one.label_below, one.label_above) == (
        two.kind,
        two.label_below,
        two.label_above,
    )
