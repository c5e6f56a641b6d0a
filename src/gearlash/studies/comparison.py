"""A measurement over speed beside what is computed there: residuals, and which jump is which event."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from gearlash.case import Case
from gearlash.case.measurement import Measurement
from gearlash.flow import Propagators
from gearlash.jobs import Chain, Execution, Part, handing_on, run, stopping
from gearlash.orbits import Settings
from gearlash.orbits.figures import Figure, Quantity, figure_of, quantities
from gearlash.results import Axis, Direction, Point, Sweep
from gearlash.system import GearlashError, Record, UnknownNameError, given

from .arguments import checked_execution
from .joined import apart_at
from .measured import readouts_of, trace_of, traceable
from .measured_jumps import MeasuredJump, directions_of, jumps_of
from .model import Source
from .sweep import sweeps
from .transition import Transition
from .transitions import transitions

POINTS_OF_A_TASK = 16
Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class Comparison(Record):
    """What was measured beside what is computed, all dimensionless, as `compare` returns it.

    Parameters
    ----------
    measurement : Measurement
        As it was given.
    figure : str
    order : float
    omega, measured : ndarray of shape (m,)
        As measured, ascending in speed.
    up, down : ndarray of shape (m,)
        Computed at these speeds, with speed rising and falling; NaN where there is none.
    labels : tuple of (str, str)
        Of both motions.
    nearer : ndarray of shape (m,)
        The one of both that lies nearer to what was measured.
    directions : tuple of str
        Of every row ``up`` or ``down``, as the speed came to it when it was measured; empty where the rows
        do not say it.
    sweeps : tuple of Sweep
    jumps : tuple of MeasuredJump
        Of each run of the measurement, in the order of speed.
    complete : bool
    apart : tuple of (ndarray of bool, ndarray of bool)
        Of shape (m-1,), with speed rising and falling: whether the computed motion changes to another one
        from a row to the next.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("kahraman-singh")
    >>> found = gl.compare(case, gl.measurement(case, [0.7, 0.72], [0.28, 0.29], "mesh_force"), "peak")
    >>> found.labels[0], found.jumps
    (('1-0-0', '1-0-0'), ())
    """

    _printed = "figure", "order", "omega", "residuals", "jumps", "complete"

    measurement: Measurement
    figure: str
    order: float
    omega: Array
    measured: Array
    up: Array
    down: Array
    labels: tuple[tuple[str, str], ...]
    nearer: Array
    directions: tuple[str, ...]
    sweeps: tuple[Sweep, ...]
    jumps: tuple[MeasuredJump, ...]
    complete: bool
    apart: tuple[NDArray[np.bool_], NDArray[np.bool_]]

    @property
    def residuals(self) -> Array:
        """Measured less computed with speed going the same way, shape (m,); less the nearer one where the
        direction is not known, or nothing was found that way."""
        ways = np.array(self.directions)
        same = np.where(ways == "up", self.up, np.where(ways == "down", self.down, np.nan))
        return self.measured - np.where(np.isnan(same), self.nearer, same)

    @property
    def nearer_residuals(self) -> Array:
        """Measured less the nearer one of both, shape (m,)."""
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


def known_quantity(case: Case, name: str) -> Quantity:
    """The quantity of this name; raises an `UnknownNameError` with those that the pair has."""
    known = known_quantities(case)
    if name not in known:
        raise UnknownNameError("quantity", name, known)
    return known[name]


def compare(
    case: Case,
    measurement: Measurement,
    figure: str = "peak-to-peak",
    *,
    order: float = 1.0,
    settings: Settings | None = None,
    execution: Execution | None = None,
) -> Comparison:
    """A measurement over speed beside what is computed at the same speeds, rising and falling.

    Residuals are to the motion computed with speed going the way it went when it was measured. Jumps of the
    measurement are changes from one speed to the next that are larger than five times the median change, than
    a tenth of the span and than twice the changes beside them; to each belong the changes of the computed
    motion that lie there or within two usual steps. That one of them made the jump is not shown by that.

    Parameters
    ----------
    case : Case
        A gear pair.
    measurement : Measurement
        As from `load_measurement` or `measurement`.
    figure : str
        ``peak`` (largest modulus), ``peak-to-peak``, ``rms`` about the mean, ``mean``, or ``order``: the rms
        of one line.
    order : float
        Of the mesh frequency, for ``order``.
    settings : Settings, optional
        How attractors are looked for.
    execution : Execution, optional
        Who does the work, who is told and who may stop it.

    Returns
    -------
    Comparison

    Raises
    ------
    UnknownNameError
        For a quantity that this pair does not have.
    GearlashError
        For a case that is no gear pair, for fewer than two different speeds, for an order that is not above
        zero, and for values below zero where the figure is not the mean.

    Examples
    --------
    >>> import gearlash as gl
    >>> case = gl.load_case("article")
    >>> measured = gl.measurement(case, [3990, 4010], [9.1, 9.0], "gap", speed_unit="rpm", unit="um")
    >>> found = gl.compare(case, measured, "peak-to-peak")
    >>> [label[0] for label in found.labels], len(found.residuals)
    (['1-0-0', '1-0-0'], 2)
    """
    given.instance("case", case, Case, "a case, as from gearlash.load_case")
    given.instance("measurement", measurement, Measurement, "as from gearlash.load_measurement")
    taken, quantity = given.choice(Figure, "figure", figure), known_quantity(case, measurement.quantity)
    line = given.number("order", order)
    _check_sizes(measurement, taken, line)
    in_order = np.argsort(measurement.omega, kind="stable")
    speeds, values = measurement.omega[in_order], measurement.values[in_order]
    once, place = np.unique(speeds, return_inverse=True)
    if len(once) < 2:
        raise GearlashError(
            f"{len(speeds)} speeds, {len(once)} different: expected two different ones at least"
        )
    directions = directions_of(measurement.omega)
    source = Source.of(case)
    execution = checked_execution(source, execution)
    ways = sweeps(case, Axis("omega", once), ("up", "down"), settings=settings, execution=execution)
    form = _Form(source, quantity, taken, line)
    figures = [_figures(form, way, execution) for way in ways]
    up, down = (values[place] for values, _ in figures)
    apart = [np.where(np.isnan(way), np.inf, np.abs(way - values)) for way in (up, down)]
    labels = [(_label(a), _label(b)) for a, b in zip(ways[0].points, ways[1].points, strict=True)]
    changes = [_changes(case, way) for way in ways]
    rising, falling = (_of_rows(apart_at(*one), place) for one in zip(ways, changes, strict=True))
    events = [(str(way.direction), one) for way, some in zip(ways, changes, strict=True) for one in some]
    return Comparison(
        measurement=measurement,
        figure=taken,
        order=line,
        omega=speeds,
        measured=values,
        up=up,
        down=down,
        labels=tuple(labels[at] for at in place),
        nearer=np.where(apart[0] <= apart[1], up, down),
        directions=tuple(directions[row] for row in in_order),
        sweeps=ways,
        jumps=jumps_of(measurement, events),
        complete=all(way.complete for way in ways) and all(whole for _, whole in figures),
        apart=(rising, falling),
    )


def _check_sizes(measurement: Measurement, figure: Figure, order: float) -> None:
    """Raises `GearlashError` where no motion can have such figures."""
    if order <= 0.0:
        raise GearlashError(f"order = {order:g}: expected a multiple of the mesh frequency above zero")
    below = measurement.values[measurement.values < 0.0]
    if len(below) and figure is not Figure.MEAN:
        least = f"{float(below.min()) * measurement.factor:.4g} {measurement.unit}".strip()
        raise GearlashError(
            f"values of {measurement.quantity} down to {least}: expected none below zero, as the figure is "
            f"{figure}; only a mean has a sign (figure mean)"
        )


def _changes(case: Case, way: Sweep) -> tuple[Transition, ...]:
    """Changes of the motion along a sweep."""
    return transitions(case, "omega", way, rising=way.direction is Direction.UP)


def _of_rows(apart: NDArray[np.bool_], place: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Steps between rows, of which several may have one speed; ``place``: of each row among the speeds."""
    below, above = place[:-1], place[1:]
    return (below != above) & apart[np.minimum(below, len(apart) - 1)]


def _label(point: Point) -> str:
    return "" if point.label is None else str(point.label)


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


def _figures(form: _Form, sweep: Sweep, execution: Execution) -> tuple[Array, bool]:
    """The figure of every point of a sweep, NaN where there is no motion or none was computed; and whether
    all were looked at."""
    points, fixed = list(sweep.points), tuple(sweep.fixed.items())
    parts = [points[at : at + POINTS_OF_A_TASK] for at in range(0, len(points), POINTS_OF_A_TASK)]
    chains = [Chain(k, (_Task(form, fixed, tuple(part)),), (len(part),)) for k, part in enumerate(parts)]
    outcome = run(_work, chains, execution)
    found = np.full(len(points), np.nan)
    for k in range(len(parts)):  # a part may have been stopped before its end, and the next one not
        done = outcome.results.get(k, ())
        found[k * POINTS_OF_A_TASK :][: len(done)] = done
    return found, outcome.complete


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
                how = form.quantity, form.figure, form.order
                found.append(figure_of(trace, readouts, *how, repeats=point.periodic))
            except (GearlashError, np.linalg.LinAlgError):
                found.append(np.nan)
    return Part(tuple(found))


@lru_cache(maxsize=8)
def _case(text: str) -> Case:
    return Case.from_json(text)
