"""Aperiodic motion beside a quiet one is followed through the windows of periodic motion within it."""

from pathlib import Path

import pytest

import gearlash as gl
from gearlash.system import MotionKind

SOFT_STOP = Path(__file__).parents[1] / "cases" / "soft-stop.toml"


@pytest.mark.slow
def test_a_window_within_chaos_is_no_end_of_what_coexists():
    """At 0.727 the chaos has a window of 6-4-0; a way down in finer steps leads through it."""
    case = gl.load_case(SOFT_STOP)
    found = gl.zones(case, gl.Axis.even("omega", 0.6, 1.0, 9))
    way = gl.Axis.even("omega", 0.719, 0.79, 72)
    sweep = gl.sweep(case, way, direction="down")
    labels = {str(point.label) for point in sweep.points if point.value < 0.73}
    assert {"6-4-0", str(MotionKind.APERIODIC)} <= labels
    met = [point.value for point in sweep.points if point.computed and not point.impact_free]
    every = [zone for zone in found.zones if zone.every and zone.quiet is gl.Quiet.IMPACT_FREE]
    assert len(every) >= 2
    for zone in every:
        assert not [value for value in met if zone.lower.value < value < zone.upper.value]
