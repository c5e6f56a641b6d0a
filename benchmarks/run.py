"""The whole benchmark."""

from __future__ import annotations

from collections.abc import Callable
from time import monotonic

from .bars import bars
from .branches import branch_rows
from .limits import limits
from .machine import this_machine
from .pixels import REPEATS as MAPPED
from .pixels import pixel_rows
from .questions import grazing_rows, multiplier_rows, thread_speedup
from .results import OWN, Benchmark, Row
from .sizes import curves
from .special_curves import curve_rows
from .startup import long_rows, start_rows
from .tooth_contact import contact_rows
from .trajectories import trajectory_rows
from .works import works

REPEATS, QUICK_REPEATS = 7, 2


def _silent(stage: str) -> None:
    """Says nothing."""


def benchmark(quick: bool = False, progress: Callable[[str], object] = _silent) -> Benchmark:
    """Runs all of it, some two minutes on two cores; ``quick``: everything once through on small work, some
    twenty seconds, with times that mean little. ``progress`` is told every stage."""
    began, repeats = monotonic(), QUICK_REPEATS if quick else REPEATS
    progress("attractors")
    found = works(quick)
    one: list[Row] = []
    many: list[Row] = []
    for work in found:
        progress(work.name)
        single, together = trajectory_rows(work, repeats, 10 if quick else 100)
        one += single
        many += together
    progress("single questions")
    questions = multiplier_rows(found[1], repeats) + grazing_rows(repeats)
    threads = thread_speedup(found[1], repeats, 1_000 if quick else 20_000)
    progress("branches")
    branches, spent_on = branch_rows(1 if quick else MAPPED, quick)
    progress("curves in two parameters")
    followed = curve_rows(1 if quick else MAPPED, quick)
    progress("contact of teeth")
    pressed = contact_rows(repeats, quick)
    progress("map")
    mapped, facts = pixel_rows(10 if quick else 400, 1 if quick else MAPPED)
    progress("start-up")
    starts = start_rows(1 if quick else 5)
    if not quick:
        progress("first run and whole study")
        starts += long_rows()
    rows = [*one, *many, *questions, *branches, *followed, *pressed, *mapped, *starts]
    progress("sizes")
    sizes = curves(repeats, quick)
    progress("limits")
    spent, together = (
        {r.work: r.best for r in rows if r.solver == OWN and r.best is not None} for rows in (one, many)
    )
    return Benchmark(
        quick=quick,
        repeats=repeats,
        machine=this_machine(),
        rows=tuple(rows),
        bars=bars(rows, found, threads),
        curves=tuple(sizes),
        limits=limits(found, spent, together),
        pixels=facts,
        branch=spent_on,
        threads=threads,
        seconds=monotonic() - began,
    )
