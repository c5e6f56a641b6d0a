"""What the impact-free window holds: all motions found at one ω of it, and bearings in resonance."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gearlash.case import Case
from gearlash.flow import propagators
from gearlash.orbits import orbit_at
from gearlash.studies.motion import Motion, motion
from gearlash.system import GearlashError, Label

from .bearing import bearing_modes
from .reproduction import BearingMode, Reading, ReportedZone
from .rows import Row
from .zoning import SOME


def _window(zones: Sequence[ReportedZone]) -> Reading | None:
    """The impact-free zone as found with some of the scans; None where there is none."""
    wide = next((z.reading(SOME) for z in zones if z.kind == "impact-free"), None)
    return wide if wide is not None and wide.found else None


def motions_inside(
    case: Case, done: Sequence[Row], zones: Sequence[ReportedZone], values: Mapping[str, float]
) -> tuple[Motion, ...]:
    """Every motion found at one ω of the impact-free zone: where most of them coexist, else in its middle."""
    wide = _window(zones)
    if wide is None:
        return ()
    inside = [i for i, p in enumerate(done[0].sweep.points) if wide.lower.value < p.value < wide.upper.value]
    if not inside:
        return ()

    def labels(i: int) -> set[Label | None]:
        return {row.sweep.points[i].label for row in done}

    most = max(len(labels(i)) for i in inside)
    crowded = [i for i in inside if len(labels(i)) == most]
    chosen = crowded[len(crowded) // 2]
    family, _ = case.family()
    seen, motions = set(), []
    for row in done:
        sampled = row.sweep.points[chosen]
        if sampled.label in seen or not sampled.periodic:
            continue
        seen.add(sampled.label)
        props = propagators(family.system({**values, "omega": sampled.value}))
        orbit = orbit_at(props, sampled.state, sampled.period // props.system.cycles)
        if orbit is None:  # a point of the sweep was proved to be one
            raise GearlashError(f"no orbit closes at omega = {sampled.value:.10g}, {sampled.label}")
        motions.append(motion(orbit, value=sampled.value))
    return tuple(motions)


def bearings_inside(
    case: Case, done: Sequence[Row], zones: Sequence[ReportedZone], fixed: Mapping[str, float]
) -> tuple[BearingMode, ...]:
    """Bearings in resonance inside the impact-free window, with the motion there."""
    wide = _window(zones)
    quiet = next((p for row in done for p in row.sweep.points if p.impact_free), None)
    return () if wide is None or quiet is None else bearing_modes(case, wide, quiet.state, fixed)
