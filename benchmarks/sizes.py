"""Cost against size: the same measurement along one size at a time."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from gearlash import flow
from gearlash.flow import Propagators
from gearlash.system import Clearance, GearlashError, System, constant

from .peers.plain import Array
from .results import Curve
from .timing import Runner, in_turns, seconds
from .works import family

SETTLING, COUNTED, TIMED = 300, 150, 400  # base periods
Model = Callable[[float], tuple[System, Array]]  # size → system and start


def curves(repeats: int, quick: bool) -> list[Curve]:
    """All curves; one whose systems the engine does not take ends there, and says so."""
    found = []
    for axis, (model, sizes) in AXES.items():
        chosen = (sizes[0], sizes[len(sizes) // 2]) if quick else sizes
        found.append(_curve(axis, model, chosen, repeats))
    return found


def harmonics(count: float) -> tuple[System, Array]:
    """The article's pair with a first-harmonic ripple at 1-1, and more harmonics that fall as 1/k²."""
    pairs, values = family("article-first-harmonic"), {"omega": 0.95, "D": 1.0}
    system, start = pairs.system(values), pairs.start(values)
    (clearance,) = system.clearances
    order = np.arange(2, int(count) + 1)
    series = np.concatenate([clearance.stiffness_plus[:3], np.zeros(2 * len(order))])
    series[3::2] = 0.1 / order**2
    sides = replace(clearance, stiffness_plus=series, stiffness_minus=series)
    return replace(system, clearances=(sides,)), start


def states(count: float) -> tuple[System, Array]:
    """A pair at ω = 0.7 with 1-1-1 motion, whatever the number of bearings, which its force drives weakly."""
    n = int(count)
    matrix, g, h = np.zeros((n, n)), np.zeros(n), np.zeros(n)
    for i, square in zip(range(0, n - 2, 2), np.linspace(0.1, 1.5, max(1, n // 2 - 1)), strict=False):
        matrix[i, i + 1] = 1.0
        matrix[i + 1, i : i + 2] = -square, -0.05 * np.sqrt(square)
        matrix[n - 1, i : i + 2] = 0.05 * matrix[i + 1, i : i + 2]
        g[i + 1] = 0.05
    matrix[n - 2, n - 1], h[n - 2], g[n - 1] = 1.0, 1.0, -1.0
    forcing = np.zeros((n, 3))
    forcing[n - 1] = 0.1, 0.2, 0.0
    start = np.zeros(n)
    start[n - 2] = 1.1
    return System(0.7, matrix, forcing, (_mesh(h, g),)), start


def clearances(count: float) -> tuple[System, Array]:
    """A row of three masses between elastic stops, of which so many have play: the others are glued. They are
    shaken one after the other."""
    n, play = 6, int(count)
    matrix, forcing, start, gaps = np.zeros((n, n)), np.zeros((n, 3)), np.zeros(n), []
    for i in range(3):
        matrix[2 * i, 2 * i + 1] = 1.0
        matrix[2 * i + 1, 2 * i : 2 * i + 2] = -0.05, -0.05
        forcing[2 * i + 1] = 0.1, 0.3 * np.cos(LATER * i), 0.3 * np.sin(LATER * i)
        h, g = np.zeros(n), np.zeros(n)
        h[2 * i], g[2 * i + 1] = 1.0, -1.0
        if i < play:
            gaps.append(replace(_mesh(h, g), name=f"stop {i + 1}"))
        else:
            matrix[2 * i + 1, 2 * i] -= 1.0
        if i:  # neighbours are coupled
            for here, there in ((i, i - 1), (i - 1, i)):
                matrix[2 * here + 1, 2 * here] -= 0.1
                matrix[2 * here + 1, 2 * there] += 0.1
    return System(0.8, matrix, forcing, tuple(gaps)), start


def impacts(load: float) -> tuple[System, Array]:
    """One degree of freedom, slow (ω = 0.02) and shaken by harmonic 25 of the error: the less load, the more
    of the 25 shakes in a period separate and hit, on one side or both."""
    pairs = family("kahraman-singh")
    system = pairs.system({"omega": 0.02, "D": 0.2, "load": load})
    forcing = np.zeros((2, 51))
    forcing[1, 0], forcing[1, 49] = load, 0.3
    (clearance,) = system.clearances
    ripple = np.zeros(3)
    ripple[:2] = 1.0, 0.3
    sides = replace(clearance, stiffness_plus=ripple, stiffness_minus=ripple)
    return replace(system, forcing=forcing, clearances=(sides,)), np.array([load + 0.2, 0.0])


def speeds(omega: float) -> tuple[System, Array]:
    """The article's pair."""
    values = {"omega": omega, "D": 1.0}
    pairs = family("article")
    return pairs.system(values), pairs.start(values)


LATER = 2.1  # rad by which each of several masses is shaken after the one before
IMPACTS = "impacts per period"
AXES: dict[str, tuple[Model, Sequence[float]]] = {
    "stiffness harmonics": (harmonics, (1, 2, 3, 5, 8, 12, 16, 20)),
    "states": (states, (2, 4, 6, 8, 10, 14, 18, 24, 32, 40)),
    "clearances": (clearances, (1, 2, 3)),
    IMPACTS: (impacts, (2.0, 0.46, 0.45, 0.42, 0.4, 0.38, 0.35, 0.25, 0.15)),
    "speed ω": (speeds, (0.05, 0.1, 0.2, 0.4, 0.7, 1.05, 1.5, 2.5, 5.0)),
}


def _mesh(h: Array, g: Array) -> Clearance:
    stiffness = np.array([1.0, 0.2, 0.0])
    return Clearance(h, g, 0.5, 0.5, stiffness, stiffness, damping=0.1, offset=constant(0.0))


def _curve(axis: str, model: Model, sizes: Sequence[float], repeats: int) -> Curve:
    """All points take turns; the least time of each counts, as there is nobody to compare with."""
    points, runners, note = [], [], ""
    for size in sizes:
        try:
            props, z, crossings = _settled(*model(size))
        except GearlashError as error:
            note = f"from {size:g} on: {error}"
            break
        runners.append(Runner(f"{size:g}", lambda p=props, z=z: flow.march(p, z, TIMED), TIMED))
        building = min(seconds(lambda p=props: flow.propagators(p.system)) for _ in range(repeats))
        points.append((size, building, props.cells, crossings))
    times = in_turns(runners, repeats)
    rows = [(p[0], times[f"{p[0]:g}"].best, *p[1:]) for p in points]
    if axis == IMPACTS:  # the load is the knob; what it gives is the size
        rows = sorted((row[-1] / 2, *row[1:]) for row in rows)
    columns = list(zip(*rows, strict=True)) or [()] * 5
    return Curve(axis, *(tuple(column) for column in columns), note=note)


def _settled(system: System, start: Array) -> tuple[Propagators, Array, float]:
    """Propagators, a state after the transient, crossings per period."""
    props = flow.propagators(system)
    run = flow.march(props, start, SETTLING)
    return props, run.states[-1], float(run.contacts[-COUNTED:].sum()) / COUNTED
