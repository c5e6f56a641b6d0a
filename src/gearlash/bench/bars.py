"""What was aimed at (ratios in one run on one machine), held against the rows."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from .pixels import TASK as PIXELS
from .results import OWN, Bar, Row
from .trajectories import MANY, ONE
from .works import Work

ERROR = 1e-11


def bars(rows: Sequence[Row], found: Sequence[Work], speedup: float) -> tuple[Bar, ...]:
    """Every bar with the worst value over the works that it speaks of."""
    free = {w.name for w in found if w.crossings == 0.0}
    hit = {w.name for w in found} - free
    errors = [e for r in rows if r.solver == OWN for e in (r.error, r.time_error) if e is not None]
    own = {r.work: r.seconds for r in rows if r.task == "start-up" and r.solver == OWN}
    one, many = "one trajectory", "many trajectories"
    batch, pixels = "times heyoka's batch mode", _least(rows, PIXELS, None, "heyoka")
    return (
        Bar.judged(f"{one} with impacts: times heyoka", 10.0, _least(rows, ONE, hit)),
        Bar.judged(f"{one} without impacts: times heyoka", 20.0, _least(rows, ONE, free)),
        Bar.judged(f"{many} with impacts: {batch}", 6.0, _least(rows, MANY, hit)),
        Bar.judged(f"{many} without impacts: {batch}", 12.0, _least(rows, MANY, free)),
        Bar.judged("map pixels: times 500 brute-force periods of heyoka", 30.0, pixels),
        Bar.judged("two threads: times one", 1.9, speedup),
        Bar.judged("largest error of any row of gearlash", ERROR, max(errors, default=None), False),
        Bar.judged("import gearlash, warm, seconds", 0.3, own.get("import gearlash"), False),
        Bar.judged("gearlash run, warm, seconds", 1.0, own.get("gearlash run article"), False),
    )


def _least(rows: Iterable[Row], task: str, works: set[str] | None, solver: str | None = None) -> float | None:
    """The least ratio to heyoka over these works: to its fastest way, unless one is named."""
    best: dict[str, float] = {}
    for row in rows:
        named = row.solver == solver if solver else row.solver.startswith("heyoka")
        if row.task == task and named and row.ratio is not None and (works is None or row.work in works):
            best[row.work] = min(row.ratio, best.get(row.work, row.ratio))
    return min(best.values(), default=None)
