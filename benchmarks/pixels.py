"""A map of the (ω, D) plane: label and largest exponent of every pixel, from the equations on."""

from __future__ import annotations

from dataclasses import dataclass
from time import perf_counter

import numpy as np

from gearlash import flow
from gearlash.orbits import Aperiodic, Orbit, attractor
from gearlash.orbits.attractor import DEFAULT
from gearlash.system import Family

from .peers import MISSING, installed
from .peers.plain import Pair
from .results import OWN, Row
from .timing import Runner, Times, in_turns
from .works import family

SEED = 20_240_917
OMEGA, HALF_BACKLASH = (0.5, 1.4), (0.2, 1.2)
TASK = "map pixels"
REPEATS = 3
BUILDING = "building its propagators, ms of a pixel"
MARCHING = "marching its periods with a tangent, ms of a pixel"
ELSE = "all else, ms of a pixel"
BEST = "times heyoka, if all else took no time"  # of what is here, no bound on what could be written
AIM = 30.0  # times heyoka
PATIENT = f"{DEFAULT.patience} periods of the aperiodic ones alone, ms of a pixel"
ALLOWED = f"what {AIM:.0f} times heyoka would leave for everything, ms of a pixel"


@dataclass(frozen=True)
class Pixel:
    label: str
    exponent: float
    periods: int
    periodic: bool
    aperiodic: bool


def pixel_values(count: int) -> list[dict[str, float]]:
    """The same points every time; fewer of them are the first ones."""
    rng = np.random.default_rng(SEED)
    drawn = rng.uniform(size=(count, 2))
    low, high = np.array([OMEGA, HALF_BACKLASH]).T
    return [{"omega": float(o), "D": float(d)} for o, d in low + drawn * (high - low)]


def pixel_rows(count: int, repeats: int) -> tuple[list[Row], dict[str, float]]:
    """Rows, and what else is to be known about the map."""
    pairs, points = family("article"), pixel_values(count)
    own: list[Pixel] = []
    labels: list[str] = []

    def ours() -> None:
        own[:] = [_pixel(pairs, values) for values in points]

    _pixel(pairs, points[0])  # to warm up

    runners = [Runner(OWN, ours, count)]
    notes = {OWN: "label and largest exponent, propagators included"}
    if installed("heyoka") != MISSING:
        from .peers.heyoka import lanes
        from .peers.heyoka_plane import HOW, Plane, PlaneBatch

        shape, width = Pair.of(pairs.system(points[0])), lanes()[-1]
        planes = {"heyoka": Plane(shape), f"heyoka, {width} lanes": PlaneBatch(shape, width)}
        for name, plane in planes.items():
            notes[name] = HOW
            runners.append(
                Runner(
                    name, lambda p=plane: labels.__setitem__(slice(None), _theirs(p, pairs, points)), count
                )
            )
    times = in_turns(runners, repeats, warm=False)
    work = f"article, {count} random pixels of the (ω, D) plane"
    rows = [
        Row(
            TASK, work, name, "pixel", t.median, t.best,
            None if name == OWN else t.over(times[OWN]),
            None if name == OWN else t.least_over(times[OWN]), how=notes[name],
        )
        for name, t in times.items()
    ]  # fmt: skip
    if len(rows) == 1:
        rows.append(Row(TASK, work, "heyoka", "pixel", note=MISSING))
    return rows, {**_facts(own, labels), **_parts(pairs, points, own, times)}


def _pixel(pairs: Family, values: dict[str, float]) -> Pixel:
    found = attractor(flow.propagators(pairs.system(values)), pairs.start(values))
    kinds = isinstance(found, Orbit), isinstance(found, Aperiodic)
    return Pixel(str(found.label), found.largest_exponent, found.periods_used, *kinds)


def _parts(
    pairs: Family, points: list[dict[str, float]], own: list[Pixel], times: dict[str, Times]
) -> dict[str, float]:
    """What a pixel's time goes to, by doing two parts of it again alone: the propagators, and as many periods
    with a tangent as it took, in one call from its start."""
    building = marching = 0.0
    for values, pixel in zip(points, own, strict=True):
        began = perf_counter()
        props = flow.propagators(pairs.system(values))
        built = perf_counter()
        n = props.system.size
        flow.growth(props, pairs.start(values), np.full(n, n**-0.5), pixel.periods, pixel.periods)
        building, marching = building + built - began, marching + perf_counter() - built
    building, marching = building / len(points), marching / len(points)
    a_period = marching / float(np.mean([pixel.periods for pixel in own]))
    aperiodic = float(np.mean([pixel.aperiodic for pixel in own]))
    found = {
        BUILDING: 1e3 * building,
        MARCHING: 1e3 * marching,
        ELSE: 1e3 * (times[OWN].median - building - marching),
        PATIENT: 1e3 * aperiodic * DEFAULT.patience * a_period,
    }
    if "heyoka" in times:
        found[ALLOWED] = 1e3 * times["heyoka"].median / AIM
        found[BEST] = times["heyoka"].median / (building + marching)
    return found


def _theirs(plane, pairs: Family, points: list[dict[str, float]]) -> list[str]:
    return plane.labels([Pair.of(pairs.system(v)) for v in points], [pairs.start(v) for v in points])


def _facts(own: list[Pixel], labels: list[str]) -> dict[str, float]:
    periodic = [p.periods for p in own if p.periodic]
    rest = [p.periods for p in own if not p.periodic]
    facts = {
        "pixels": float(len(own)),
        "periodic pixels": float(len(periodic)),
        "mean periods of a pixel": float(np.mean([p.periods for p in own])),
        "mean periods of a periodic pixel": float(np.mean(periodic)) if periodic else 0.0,
        "mean periods of any other pixel": float(np.mean(rest)) if rest else 0.0,
    }
    if labels:
        same = sum(p.label == label for p, label in zip(own, labels, strict=True))
        facts["labels equal to heyoka's after 500 periods"] = float(same)
    return facts
