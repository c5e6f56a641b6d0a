"""Bands beside zones: where motion that is not quiet was found, and what it is called."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import gearlash as gl
from gearlash.results import Axis, Sweep
from gearlash.studies.bands import back_bands, bands, living_at, loud_label, not_told
from gearlash.studies.zone import Zone, ZoneMotion, Zones
from gearlash.studies.zone_end import RANGE, SEEN, Interval, Quiet, ZoneEnd
from gearlash.studies.zones import zones_of_kinds
from gearlash.system import Label, MotionKind, Signature

CASES = Path(__file__).parents[1] / "cases"
LOW, HIGH = 0.74, 0.86  # between them another motion lives beside the quiet one


@pytest.fixture(scope="module")
def sweep() -> Sweep:
    """Of the article's pair at 0.7, 0.75 ... 0.9: periodic motions, and an aperiodic one at its end."""
    return gl.sweep(gl.load_case("article"), Axis.even("omega", 0.7, 0.9, 5), direction="up")


def _zones(sweep: Sweep, label: Label) -> Zones:
    """Zones without impacts on the back side, with a motion of this label that was followed from an end."""
    between = Interval(ZoneEnd(LOW, "fold", inside=label), ZoneEnd(HIGH, SEEN, inside=label))
    motion = ZoneMotion(label, ("beyond an end",), LOW, HIGH, False, between)

    def zone(low: float, high: float, every: bool, *motions: ZoneMotion) -> Zone:
        kind = Quiet.DRIVE_SIDE_ONLY
        return Zone(ZoneEnd(low, RANGE), ZoneEnd(high, RANGE), "omega", kind, every, motions)

    certain = zone(0.7, LOW, True), zone(HIGH, 0.9, True)
    return Zones(Quiet.DRIVE_SIDE_ONLY, sweep.axis, certain, (zone(0.7, 0.9, False, motion),), (sweep,))


def _reaching(sweep: Sweep, least: float) -> Sweep:
    """Aperiodic motion down to a displacement at the three values in the middle."""
    quiet, *_, aperiodic = sweep.points
    assert aperiodic.label is MotionKind.APERIODIC
    assert quiet.drive_side_only
    points = [
        replace(aperiodic, value=p.value, minimum=least)
        if LOW < p.value < HIGH
        else replace(quiet, value=p.value)
        for p in sweep.points
    ]
    return replace(sweep, points=tuple(points))


@pytest.mark.parametrize(("least", "met"), [(-1.2, [(0.75, 0.85)]), (-0.8, [])])
def test_motion_without_a_period_meets_the_back_side_where_it_was_seen_to(
    sweep: Sweep, least: float, met: list[tuple[float, float]]
):
    """That it was also followed from the end of a branch takes nothing away."""
    found = back_bands(_zones(_reaching(sweep, least), MotionKind.APERIODIC), -1.0)
    assert [(one.lower.value, one.upper.value) for one in found] == [pytest.approx(each) for each in met]
    assert all(one.labels == (MotionKind.APERIODIC,) for one in found)


def test_periodic_motion_without_a_branch_meets_the_back_side_where_its_label_says_so(sweep: Sweep):
    quiet, met = (_zones(sweep, Signature(2, 1, back)) for back in (0, 1))
    assert back_bands(quiet, -1.0) == ()
    (band,) = back_bands(met, -1.0)
    assert (band.lower.value, band.upper.value) == (LOW, HIGH)
    assert band.labels == (Signature(2, 1, 1),)
    assert living_at(met, 0.8) == (Signature(2, 1, 1),)
    assert living_at(met, 0.72) == ()


def test_motion_that_was_followed_without_a_branch_is_called_by_its_own_label(sweep: Sweep):
    """Not by that of its last point; and what settled to nothing all the way is no motion."""
    found = _zones(_reaching(sweep, -0.8), MotionKind.APERIODIC)
    (zone,) = found.wider
    (motion,) = zone.motions
    lost = ZoneEnd(LOW, SEEN, inside=MotionKind.UNRESOLVED), ZoneEnd(HIGH, "fold", inside=motion.label)

    def named(label: Label) -> tuple[Label, ...]:
        other = replace(motion, label=label, stable=Interval(*lost))
        return living_at(replace(found, wider=(replace(zone, motions=(other,)),)), 0.78)

    assert named(MotionKind.APERIODIC) == (MotionKind.APERIODIC,)
    assert named(MotionKind.UNRESOLVED) == ()


def test_a_soft_stop_is_met_by_chaos_that_was_also_followed():
    """Its branch begins at 0.716; down and cold sweeps see it at 0.724 with X = -1.45."""
    case = gl.load_case(CASES / "soft-stop.toml")
    found = gl.zones(case, Axis("omega", np.array([0.6, 0.65, 0.7, 0.724, 0.75, 1.0])), "drive-side-only")
    seen = [p for sweep in found.sweeps for p in sweep.points if p.label is MotionKind.APERIODIC]
    assert {point.value for point in seen} == {0.724}
    assert all(-1.5 < point.minimum < -1.4 for point in seen)
    followed = [m for zone in found.wider for m in zone.motions if m.branch is None and m.stable]
    assert any(m.label is MotionKind.APERIODIC for m in followed)
    (band,) = back_bands(found, -0.9)
    assert (band.lower.value, band.upper.value, band.labels) == (0.724, 0.724, (MotionKind.APERIODIC,))
    assert back_bands(found, -1000.0) == ()


def test_what_settled_to_nothing_is_no_motion(sweep: Sweep):
    """A band does not name it, nor does a value at which it was met."""
    unresolved = replace(
        sweep.points[-1], label=MotionKind.UNRESOLVED, status=gl.Status.UNRESOLVED, value=0.8
    )
    points = tuple(unresolved if i == 2 else p for i, p in enumerate(_reaching(sweep, -1.2).points))
    found = _zones(replace(sweep, points=points), Signature(2, 1, 1))
    assert living_at(found, 0.8) == (Signature(2, 1, 1),)
    assert {label for band in bands(found) for label in band.labels} == {
        MotionKind.APERIODIC,
        Signature(2, 1, 1),
    }


def test_motion_without_impacts_that_was_not_followed_is_no_band():
    """With no work allowed nothing is followed, and sweeps show no impact."""
    axis = Axis.even("omega", 0.5, 0.6, 3)
    (found,) = zones_of_kinds(gl.load_case("kahraman-singh"), axis, ["impact-free"], work=1)
    assert found.left_out
    assert found.zones == ()
    assert all(point.impact_free for sweep in found.sweeps for point in sweep.points)
    assert bands(found) == ()
    (part,) = not_told(found)
    assert (part.lower.value, part.upper.value) == (0.5, 0.6)


@pytest.mark.parametrize("work", [1, 600, 1500, None])
@pytest.mark.parametrize("quiet", list(Quiet))
def test_bands_and_parts_that_are_not_told_agree_with_sweeps_whatever_was_followed(
    work: int | None, quiet: Quiet
):
    """Motions up to 0.708 and from 0.9 are quiet; between them one with impacts lives, in part beside one."""
    axis = Axis.even("omega", 0.5, 1.1, 13)
    (found,) = zones_of_kinds(gl.load_case("kahraman-singh"), axis, [quiet], work=work)
    told, open_ = bands(found), not_told(found)
    for sweep in found.sweeps:
        for point in sweep.points:
            inside = [band for band in told if band.contains(point.value)]
            between = [one for one in open_ if one.lower.value < point.value < one.upper.value]
            if loud_label(found, point) is not None:
                assert inside
                assert any(point.label in band.labels for band in inside)
                assert not between
            elif inside and not any(band.lower.value == point.value or band.upper.value == point.value
                                    for band in inside):  # fmt: skip
                assert not all(band.every for band in inside)
    ends = sorted([*told, *open_, *found.zones], key=lambda one: (one.lower.value, one.upper.value))
    assert (ends[0].lower.value, ends[-1].upper.value) == (0.5, 1.1)
    assert all(a.upper.value == b.lower.value for a, b in pairwise(ends))
    for band in told:
        assert band.labels
        assert not any(quiet.holds_label(label) for label in band.labels)
    if work is None:
        assert open_ == ()
