"""A measurement over speed beside what is computed there: residuals, and which jump is which event."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash.case import Case
from gearlash.flow import Propagators
from gearlash.jobs import Chain, Execution, Part, handing_on, run, stopping
from gearlash.orbits import Settings
from gearlash.orbits.figures import Figure, Quantity, figure_of, quantities
from gearlash.results import Axis, Point, Sweep
from gearlash.system import GearlashError, UnknownNameError, given

from .measured import readouts_of, trace_of, traceable
from .model import Source
from .sweep import sweeps
from .transition import Transition
from .transitions import transitions

POINTS_OF_A_TASK = 16
JUMP = 5.0  # times the median change from one measured speed to the next: a larger one is a jump
SMALLEST_JUMP = 0.1  # of the span of what was measured
NEAR = 2  # measured steps: so far from a jump an event may lie that it is put down to
Array = NDArray[np.float64]


@dataclass(frozen=True)
class MeasuredJump:
    """A jump of a measurement, and what may have made it.

    Parameters
    ----------
    lower, upper : float
        Speeds between which it lies.
    change : float
        Of the measured value, upwards in speed.
    events : tuple of (str, Transition)
        Direction of speed and change of the computed motion, the nearest first.
    """

    lower: float
    upper: float
    change: float
    events: tuple[tuple[str, Transition], ...]


@dataclass(frozen=True, eq=False)
class Comparison:
    """What was measured beside what is computed, all dimensionless.

    Parameters
    ----------
    quantity, figure : str
    order : float
    omega, measured : ndarray of shape (m,)
        As measured, ascending in speed; jumps are those of the mean at each speed.
    up, down : ndarray of shape (m,)
        Computed at these speeds, with speed rising and falling; NaN where there is none.
    labels : tuple of (str, str)
        Of both motions.
    nearer : ndarray of shape (m,)
        The one of both that lies nearer to what was measured.
    sweeps : tuple of Sweep
    jumps : tuple of MeasuredJump
    complete : bool
    """

    quantity: str
    figure: Figure
    order: float
    omega: Array
    measured: Array
    up: Array
    down: Array
    labels: tuple[tuple[str, str], ...]
    nearer: Array
    sweeps: tuple[Sweep, ...]
    jumps: tuple[MeasuredJump, ...]
    complete: bool

    @property
    def residuals(self) -> Array:
        """Measured less computed (the nearer one)."""
        return self.measured - self.nearer


def known_quantities(case: Case) -> dict[str, Quantity]:
    """Everything that can be compared of a gear pair, by name."""
    if not case.between_teeth:
        raise GearlashError(f"{case.name} is no gear pair: what is measured on it is not known")
    readouts = readouts_of(case, case.family()[0].complete())
    pair = case.numbers.pair
    none = np.zeros(0)
    if pair is None:
        return quantities(readouts, none, none)
    return quantities(readouts, pair.bearing_gains, 1.0 / np.repeat(pair.mass_ratios, 2))


def compare(
    case: Case,
    omega: ArrayLike,
    measured: ArrayLike,
    quantity: str,
    figure: Figure | str = Figure.PEAK_TO_PEAK,
    *,
    order: float = 1.0,
    settings: Settings | None = None,
    execution: Execution | None = None,
) -> Comparison:
    """A measurement beside what is computed.

    Parameters
    ----------
    case : Case
        A gear pair.
    omega, measured : array_like of shape (m,)
        Dimensionless speeds and values, in any order; a speed may be measured several times.
    quantity : str
        A name of `known_quantities`.
    figure : Figure or str
        ``rms`` is about the mean; ``order`` the rms of one line.
    order : float
        Of the mesh frequency, for ``order``.
    settings : Settings, optional
        How attractors are looked for.
    execution : Execution, optional
        Who does the work.

    Returns
    -------
    Comparison

    Raises
    ------
    GearlashError
        For names and arrays that do not fit.
    """
    known = known_quantities(case)
    if quantity not in known:
        raise UnknownNameError("quantity", quantity, known)
    figure = given.choice(Figure, "figure", figure)
    speeds, values = given.row("omega", omega), given.row("measured", measured)
    if len(speeds) != len(values) or len(speeds) < 2:
        raise GearlashError(f"{len(speeds)} speeds and {len(values)} values: expected two of each at least")
    order_of = np.argsort(speeds, kind="stable")
    speeds, values = speeds[order_of], values[order_of]
    once, place = np.unique(speeds, return_inverse=True)
    if len(once) < 2:
        raise GearlashError("all speeds are one: expected two different ones at least")
    execution = execution or Execution()
    ways = sweeps(case, Axis("omega", once), ("up", "down"), settings=settings, execution=execution)
    form = _Form(Source.of(case), known[quantity], figure, given.number("order", order))
    up, down = (_figures(form, way, execution)[place] for way in ways)
    apart = [np.where(np.isnan(way), np.inf, np.abs(way - values)) for way in (up, down)]
    labels = [(_label(a), _label(b)) for a, b in zip(ways[0].points, ways[1].points, strict=True)]
    mean = np.bincount(place, values) / np.bincount(place)
    return Comparison(
        quantity=quantity,
        figure=figure,
        order=order,
        omega=speeds,
        measured=values,
        up=up,
        down=down,
        labels=tuple(labels[at] for at in place),
        nearer=np.where(apart[0] <= apart[1], up, down),
        sweeps=ways,
        jumps=_jumps(once, mean, list(_changes(case, ways))),
        complete=all(way.complete for way in ways),
    )


def _changes(case: Case, ways: Sequence[Sweep]) -> Iterator[tuple[str, Transition]]:
    """Changes of the motion along each sweep."""
    for way in ways:
        direction = str(way.direction)
        for change in transitions(case, "omega", way, rising=direction == "up"):
            yield direction, change


def _label(point: Point) -> str:
    return "" if point.label is None else str(point.label)


def _jumps(
    omega: Array, values: Array, changes: Sequence[tuple[str, Transition]]
) -> tuple[MeasuredJump, ...]:
    """Changes of the measurement that are much larger than most, with events that lie there or beside."""
    steps = np.abs(np.diff(values))
    least = max(JUMP * float(np.median(steps)), SMALLEST_JUMP * float(np.ptp(values)))
    found = []
    for at, (low, high) in enumerate(pairwise(omega.tolist())):
        if steps[at] <= least:
            continue
        width = NEAR * (high - low)
        near = [
            (max(low - change.upper, change.lower - high, 0.0), way, change)
            for way, change in changes
            if change.upper >= low - width and change.lower <= high + width
        ]
        near.sort(key=lambda one: one[0])
        events = tuple((way, change) for _, way, change in near)
        found.append(MeasuredJump(low, high, float(values[at + 1] - values[at]), events))
    return tuple(found)


@dataclass(frozen=True)
class _Form:
    """What is computed at every point."""

    source: Source
    quantity: Quantity
    figure: Figure
    order: float


@dataclass(frozen=True)
class _Task:
    form: _Form
    fixed: tuple[tuple[str, float], ...]
    points: tuple[Point, ...]


def _figures(form: _Form, sweep: Sweep, execution: Execution) -> Array:
    """The figure of every point of a sweep; NaN where there is no motion."""
    points, fixed = list(sweep.points), tuple(sweep.fixed.items())
    parts = [points[at : at + POINTS_OF_A_TASK] for at in range(0, len(points), POINTS_OF_A_TASK)]
    chains = [Chain(k, (_Task(form, fixed, tuple(part)),), (len(part),)) for k, part in enumerate(parts)]
    outcome = run(_work, chains, execution)
    found = [value for k in range(len(parts)) for value in outcome.results.get(k, ())]
    return np.array([*found, *[np.nan] * (len(points) - len(found))])


def _work(task: _Task, _carry: object) -> Part:
    """Figures of some points (the work of a worker)."""
    form, found = task.form, []
    family, case = form.source.family(), _case(form.source.case_json or "")
    reuse: Propagators | None = None
    with handing_on(lambda: Part(tuple(found))):
        for point in task.points:
            if stopping():
                break
            if not traceable(point):
                found.append(np.nan)
                continue
            values = family.complete({**dict(task.fixed), "omega": point.value})
            try:
                trace = trace_of(family, values, point, reuse)
                reuse = trace.propagators
                readouts = readouts_of(case, values)
                found.append(figure_of(trace, readouts, form.quantity, form.figure, form.order))
            except (GearlashError, np.linalg.LinAlgError):
                found.append(np.nan)
    return Part(tuple(found))


@lru_cache(maxsize=8)
def _case(text: str) -> Case:
    return Case.from_json(text)
