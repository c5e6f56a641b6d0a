"""Bounds that the study measures on itself, and how it ran."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Mapping, Sequence

from gearlash.case import Case
from gearlash.results import provenance
from gearlash.system import MotionKind

from .reproduction import Check, Run
from .rows import Found, Row


def checks(done: Sequence[Row], found: Mapping[str, Sequence[Found]]) -> tuple[Check, ...]:
    """Bounds that this run can measure on itself."""
    points = [p for row in done for p in row.sweep.points if p.periodic]
    worst = max((p.residual for p in points), default=float("nan"))
    solved = [t for pairs in found.values() for t, _ in pairs]
    graze = max((t.point.residual for t in solved if t.point is not None), default=float("nan"))
    error = max((t.point.error / abs(t.value) for t in solved if t.point is not None), default=float("nan"))
    leading = max((abs(p.leading) for p in points), default=float("nan"))
    unresolved = sum(p.label is MotionKind.UNRESOLVED for row in done for p in row.sweep.points)
    total = sum(len(row.sweep.points) for row in done)
    return (
        Check(
            f"largest residual of {len(points)} periodic orbits", f"{worst:.1e}", "≤ 1e-11", worst <= 1e-11
        ),
        Check(
            "largest |multiplier| of an orbit reported as attractor", f"{leading:.6f}", "< 1", leading < 1.0
        ),
        Check(f"largest residual of {len(solved)} located points", f"{graze:.1e}", "≤ 1e-10", graze <= 1e-10),
        Check(
            "largest relative error estimate of a located value", f"{error:.1e}", "≤ 1e-10", error <= 1e-10
        ),
        Check(
            "points neither proved periodic nor shown aperiodic", f"{unresolved} of {total}", "reported", None
        ),
    )


def how_it_ran(case: Case, seconds: Mapping[str, float], workers: int | None, done: Sequence[Row]) -> Run:
    """Seconds of every stage, versions, and how many points have which status and certificate."""
    statuses = Counter(p.status for row in done for p in row.sweep.points)
    cores = os.cpu_count() or 1
    seconds = {**seconds, "total": sum(seconds.values())}
    about = provenance(case)
    versions = {name: text for name, text in about.items() if "version" in name}
    certificates = Counter(p.certificate for row in done for p in row.sweep.points if p.certificate)
    complete = all(row.sweep.complete for row in done)
    return Run(seconds, workers or cores, cores, versions, dict(statuses), complete, dict(certificates))
