"""Single questions: multipliers of an orbit, the speed at which one grazes, two threads."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np

from gearlash import flow
from gearlash.branches import locate_grazing
from gearlash.orbits import Orbit, attractor, floquet, grazing_checks
from gearlash.system import GearlashError

from .limits import multiply_adds
from .peers import MISSING, installed
from .peers.plain import Pair
from .results import OWN, Row
from .timing import Runner, in_turns
from .works import Work, family

GUESS, GAP = 0.98, 1.0  # impact-free; the orbit grazes at 0.9725
TOUCH = "a grazing located"
MARCH, LOOP, DIFFERENT = "march", "multiply-adds alone", "bytes that differ"
MARCHES = 20  # in a row, on each thread
AGAIN = 20  # times in a row that an orbit's multipliers are asked for: one call is short


def multiplier_rows(work: Work, repeats: int) -> list[Row]:
    """All multipliers of the period-one orbit of a piece of work."""
    orbit = _orbit(attractor(work.props, work.states[-1]))
    z, period = orbit.state, orbit.shot.period
    ask: dict[str, tuple[str, Callable[[], Any]]] = {
        OWN: ("", lambda: floquet.multipliers(work.props, z, period))
    }
    truth = None
    if installed("heyoka") != MISSING:
        from .peers.heyoka_orbits import MULTIPLIERS, Monodromy

        peer = Monodromy(work.pair)
        ask["heyoka"] = (MULTIPLIERS, lambda: peer.multipliers(z, period))
        truth = Monodromy(work.pair, np.longdouble).multipliers(z, period)
    from .peers import scipy

    other = scipy.Monodromy(work.pair)
    ask["scipy"] = (scipy.MULTIPLIERS, lambda: other.multipliers(z, period))
    return _rows("multipliers of an orbit", work.name, "orbit", ask, truth, repeats, _apart, AGAIN)


def grazing_rows(repeats: int) -> list[Row]:
    """The speed at which the impact-free orbit of the article's pair grazes, from one beside it."""
    pairs, values = family("article"), {"omega": GUESS, "D": GAP}
    system = pairs.system(values)
    orbit = _orbit(attractor(system, pairs.start(values)))
    check = grazing_checks(orbit)[0]
    ask: dict[str, tuple[str, Callable[[], Any]]] = {
        OWN: (
            "labels on both sides included",
            lambda: locate_grazing(pairs, "omega", orbit, check, values=values).value,
        )
    }
    truth = None
    if installed("heyoka") != MISSING:
        from .peers.heyoka_orbits import GRAZING, Grazing

        def at(omega: float) -> Pair:
            return Pair.of(pairs.system({"omega": omega, "D": GAP}))

        peer, exact = Grazing(Pair.of(system)), Grazing(Pair.of(system), np.longdouble)
        ask["heyoka"] = (GRAZING, lambda: peer.locate(at, GUESS, orbit.state))
        truth = exact.locate(at, GUESS, orbit.state)
    work = f"article D = {GAP:g}, from ω = {GUESS:g}"
    return _rows(TOUCH, work, "point", ask, truth, repeats, lambda a, b: abs(a - b))


def thread_speedup(work: Work, repeats: int, periods: int) -> dict[str, float]:
    """What two threads do in the time that one takes: marches of two different motions, and beside it a loop
    of multiply-adds alone, which is what this machine's two cores can give at the most; both for long enough
    that the system has moved the threads to cores of their own (some 10 ms). `bytes that differ`:
    in the strobes of the two marches, side by side and one after the other."""
    halves = work.scattered[:2]

    def march(which: int):
        return flow.march(work.props, halves[which], periods).states

    def loop(_which: int) -> None:
        multiply_adds(40 * periods)

    with ThreadPoolExecutor(2) as pool:
        side_by_side = np.array(list(pool.map(march, (0, 1))))
    one_by_one = np.array([march(0), march(1)])
    return {
        MARCH: _twice(lambda which: [march(which) for _ in range(MARCHES)], repeats),
        LOOP: _twice(loop, repeats),
        DIFFERENT: float(np.count_nonzero(side_by_side.view(np.uint8) != one_by_one.view(np.uint8))),
    }


def _twice(task: Callable[[int], object], repeats: int) -> float:
    with ThreadPoolExecutor(2) as pool:
        alone = Runner("1", lambda: task(0), 1)
        both = Runner("2", lambda: list(pool.map(task, (0, 1))), 2)
        times = in_turns([alone, both], repeats)
    return times["1"].over(times["2"])


def _orbit(found: Any) -> Orbit:
    if not isinstance(found, Orbit):
        raise GearlashError(f"the benchmark expects a periodic orbit here, found: {found.message}")
    return found


def _often(run: Callable[[], Any], again: int) -> Callable[[], None]:
    def often() -> None:
        for _ in range(again):
            run()

    return often


def _apart(a, b) -> float:
    """Largest distance of a multiplier to the nearest of the others."""
    return float(np.abs(np.asarray(a)[:, None] - np.asarray(b)[None]).min(axis=1).max())


def _rows(task, work, unit, ask, truth, repeats, distance, again=1) -> list[Row]:
    times = in_turns([Runner(name, _often(run, again), again) for name, (_, run) in ask.items()], repeats)
    rows = []
    for name, (how, run) in ask.items():
        error = None if truth is None else float(distance(run(), truth))
        ratio = None if name == OWN else times[name].over(times[OWN])
        mine = times[name]
        least = None if name == OWN else mine.least_over(times[OWN])
        rows.append(Row(task, work, name, unit, mine.median, mine.best, ratio, least, error, None, how))
    if "heyoka" not in ask:
        rows.append(Row(task, work, "heyoka", unit, note=MISSING))
    return rows
