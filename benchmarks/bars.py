"""What was aimed at (ratios in one run on one machine), held against the rows."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from .branches import ASKED, POINTS
from .branches import TASK as BRANCH
from .pixels import AIM
from .pixels import TASK as PIXELS
from .questions import DIFFERENT, LOOP, MARCH, TOUCH
from .results import OWN, Bar, Row
from .special_curves import ASKED as CURVES
from .special_curves import POINTS as CURVE_POINTS
from .special_curves import TASK as CURVE
from .startup import FRESH, IMPORT, RUN, STUDY, TASK
from .trajectories import MANY, ONE
from .works import Work

ERROR = 1e-11
MOST = 1.0, 4.0  # seconds of the branches
MOST_OF_CURVES = 2.0, 10.0  # seconds


def bars(rows: Sequence[Row], found: Sequence[Work], threads: Mapping[str, float]) -> tuple[Bar, ...]:
    """Every bar with the worst value over the works that it speaks of."""
    free = {w.name for w in found if w.crossings == 0.0}
    hit = {w.name for w in found} - free
    errors = [(e, r.work) for r in rows if r.solver == OWN for e in (r.error, r.time_error) if e is not None]
    own = {r.work: r.seconds for r in rows if r.task == TASK and r.solver == OWN}
    worst, where = max(errors, default=(None, ""))
    one, many, batch = "one trajectory", "many trajectories", "times heyoka's batch mode"
    return (
        _ratio(f"{one} with impacts: times heyoka", 10.0, _ratios(rows, ONE, hit)),
        _ratio(f"{one} without impacts: times heyoka", 20.0, _ratios(rows, ONE, free)),
        _ratio(f"{many} with impacts: {batch}", 6.0, _ratios(rows, MANY, hit)),
        _ratio(f"{many} without impacts: {batch}", 12.0, _ratios(rows, MANY, free)),
        _ratio("map pixels: times 500 brute-force periods of heyoka", AIM, _ratios(rows, PIXELS)),
        _ratio("a grazing located: times a secant on heyoka", 1.0, _ratios(rows, TOUCH)),
        *(_branch(rows, asked.period, asked.work, most) for asked, most in zip(ASKED, MOST, strict=True)),
        _ratio("a branch: times an arclength loop on heyoka", 3.0, _ratios(rows, BRANCH)),
        *(_curve(rows, a.period, a.work, most) for a, most in zip(CURVES, MOST_OF_CURVES, strict=True)),
        _threads(threads),
        Bar.judged("bytes that differ between one thread and two", 0.0, threads[DIFFERENT], False),
        Bar.judged("largest error of any row of gearlash", ERROR, worst, False, where),
        Bar.judged("import gearlash, warm, seconds", 0.3, own.get(IMPORT), False),
        Bar.judged("gearlash run, warm, seconds", 1.0, own.get(RUN), False),
        Bar.judged("gearlash run on a new machine, with compilation, seconds", 30.0, own.get(FRESH), False),
        Bar.judged("gearlash reproduce, warm, seconds", 60.0, own.get(STUDY), False),
    )


def _branch(rows: Sequence[Row], period: int, work: str, most: float) -> Bar:
    """Seconds of so many points."""
    found = [r.seconds for r in rows if (r.task, r.work, r.solver) == (BRANCH, work, OWN)]
    spent = None if not found or found[0] is None else POINTS * found[0]
    return Bar.judged(
        f"{POINTS} points of a branch of the article, P = {period}, seconds", most, spent, False
    )


def _curve(rows: Sequence[Row], period: int, work: str, most: float) -> Bar:
    """Seconds of so many points."""
    found = [r.seconds for r in rows if (r.task, r.work, r.solver) == (CURVE, work, OWN)]
    spent = None if not found or found[0] is None else CURVE_POINTS * found[0]
    sentence = f"{CURVE_POINTS} points of a curve of the article, P = {period}, seconds"
    return Bar.judged(sentence, most, spent, False)


def _threads(threads: Mapping[str, float]) -> Bar:
    """Not measured where even a loop of multiply-adds gets no second core: something else has it."""
    aim, free = 1.9, threads[LOOP]
    measured = threads[MARCH] if free >= aim or threads[MARCH] >= aim else None
    busy = "" if measured is not None else f"no core free: multiply-adds alone {free:.2f}"
    return Bar.judged("two threads: times one", aim, measured, where=busy)


def _ratio(sentence: str, aim: float, rows: dict[str, Row]) -> Bar:
    where = min(rows, key=lambda work: rows[work].ratio or 0.0, default="")
    worst = rows.get(where)
    return Bar.judged(
        sentence,
        aim,
        None if worst is None else worst.ratio,
        where=where if len(rows) > 1 else "",
        least=None if worst is None else worst.least_ratio,
    )


def _ratios(rows: Iterable[Row], task: str, works: set[str] | None = None) -> dict[str, Row]:
    """Work → heyoka's row: of its batches the faster; of pixels the one that is no batch."""
    best: dict[str, Row] = {}
    for row in rows:
        peer = row.solver == "heyoka" if task == PIXELS else row.solver.startswith("heyoka")
        if row.task == task and peer and row.ratio is not None and (works is None or row.work in works):
            known = best.get(row.work)
            if known is None or known.ratio is None or row.ratio < known.ratio:
                best[row.work] = row
    return best
