"""Stable zones: ends against closed forms and the article's windows, hysteresis, ranges that end first."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from gearlash import case, flow, orbits, studies
from gearlash.branches.continuation import SpecialKind, SpecialPoint
from gearlash.jobs import Execution
from gearlash.studies import Axis, Quiet
from gearlash.studies.zone_end import RANGE
from gearlash.studies.zones import zones_of_kinds
from gearlash.system import GearlashError, UnknownNameError
from studies.classical import CLASSICAL, SPEEDS, loss_of_contact

ARTICLE = case.load("article-first-harmonic")


@pytest.fixture(scope="module")
def classical():
    return studies.zones(CLASSICAL, SPEEDS)


def test_grazing_ends_are_those_of_the_closed_form(classical):
    low, high = loss_of_contact()
    (wide,) = classical.wider
    last = classical.zones[-1]
    assert wide.upper.value == pytest.approx(low, abs=1e-10)
    assert last.lower.value == pytest.approx(high, abs=1e-10)
    for end in (wide.upper, last.lower):
        assert end.kind == "grazing"
        assert isinstance(end.point, SpecialPoint)
        assert end.point.kind is SpecialKind.GRAZING
        assert {end.point.label_before, end.point.label_after} == {"1-0-0", "1-1-0"}
        assert (end.inside, end.outside) == ("1-0-0", "1-1-0")
        assert end.uncertainty < 1e-12


def test_zones_at_the_ends_of_the_range_say_that_nothing_bounds_them(classical):
    first, last = classical.zones
    assert (first.lower.value, first.lower.kind) == (0.3, RANGE)
    assert (last.upper.value, last.upper.kind) == (1.6, RANGE)
    assert "not bounded within the range" in str(first)
    assert not last.upper.bounded
    assert last.margin(1.5) == pytest.approx(1.5 - last.lower.value, abs=1e-9)


def test_where_another_attractor_coexists_only_the_wider_interval_holds(classical):
    first, wide = classical.zones[0], classical.wider[0]
    assert first.every
    assert not wide.every
    assert first.upper.kind == "fold"
    assert "down" in first.upper.direction
    assert first.upper.value < wide.upper.value
    assert {t.label for t in wide.coexisting} == {"1-0-0", "1-1-0"}
    beside = next(t for t in wide.motions if not t.quiet)
    assert beside.label == "1-1-0"
    assert beside.lower == pytest.approx(first.upper.value, abs=1e-12)
    assert beside.upper > wide.upper.value
    assert beside.exists is not None
    assert (beside.exists.lower.kind, beside.exists.upper.kind) == (RANGE, RANGE)
    assert first.coexisting == ()


def test_the_fold_is_where_the_impacting_motion_really_ends(classical):
    """Followed down by hand in ever smaller steps, it lives just above and is gone just below."""
    fold = classical.zones[0].upper.value
    above = Axis("omega", np.append(fold + np.geomspace(1e-7, 0.1, 16), 0.95))
    lives = studies.sweep(CLASSICAL, above, direction="down")
    assert {p.label for p in lives.points} == {"1-1-0"}
    below = Axis("omega", np.array([fold - 1e-6, fold + 1e-6]))
    gone = studies.sweep(CLASSICAL, below, direction="down", start=lives.points[1].state)
    assert [p.label for p in gone.points] == ["1-0-0", "1-1-0"]


def test_nearest_quiet_value(classical):
    low = classical.zones[0].upper.value
    assert classical.nearest(0.5) == 0.5
    assert classical.nearest(0.8) == low
    assert classical.nearest(1.3) == classical.zones[1].lower.value
    assert classical.at(1.0) is None
    assert classical.at(1.5) is classical.zones[1]
    assert classical.resolution == pytest.approx(0.025)


def test_threads_and_known_sweeps_give_the_same(classical):
    with ThreadPoolExecutor(2) as executor:
        again = studies.zones(CLASSICAL, SPEEDS, known=classical.sweeps, execution=Execution(executor))
    assert [str(z) for z in again.zones + again.wider] == [str(z) for z in classical.zones + classical.wider]
    assert [z.upper.value for z in again.zones] == [z.upper.value for z in classical.zones]


def test_sweeps_of_another_question_are_refused(classical):
    with pytest.raises(GearlashError, match="another axis"):
        studies.zones(CLASSICAL, Axis.even("omega", 0.3, 1.6, 27), known=classical.sweeps)
    with pytest.raises(GearlashError, match="other fixed"):
        studies.zones(CLASSICAL, SPEEDS, known=classical.sweeps, values={"load": 0.2})
    with pytest.raises(GearlashError, match="at least one"):
        studies.zones(CLASSICAL, SPEEDS, known=())
    with pytest.raises(UnknownNameError, match="kind of zone"):
        studies.zones(CLASSICAL, SPEEDS, "silent")
    with pytest.raises(GearlashError, match="two values"):
        studies.zones(CLASSICAL, Axis("omega", np.array([0.5])))


def test_the_windows_of_the_article():
    """Both reported ends of the impact-free window, and what the article does not mention: a 2-1-0 motion
    inside it.
    """
    found = studies.zones(ARTICLE, Axis.even("omega", 0.94, 1.13, 20))
    (zone,), (wide,) = found.zones, found.wider
    assert wide.lower.value == pytest.approx(0.9725, abs=5e-4)
    assert wide.upper.value == pytest.approx(1.112, abs=5e-4)
    assert wide.lower.kind == wide.upper.kind == "grazing"
    assert zone.lower.value == pytest.approx(wide.lower.value, abs=1e-12)
    assert zone.upper.kind == "fold"
    assert (zone.upper.inside, zone.upper.outside) == ("1-0-0", "2-1-0")
    assert {t.label for t in wide.coexisting} == {"1-0-0", "2-1-0"}
    rpm = next(p for p in wide.physical if p.unit == "rpm")
    assert rpm.lower == pytest.approx(float(ARTICLE.scales.pinion_rpm(wide.lower.value)), rel=1e-14)
    assert rpm.upper > rpm.lower


@pytest.mark.slow
def test_backlash_without_back_side_impacts():
    axis = Axis.even("D", 0.4, 0.55, 11)
    found = studies.zones(ARTICLE, axis, Quiet.DRIVE_SIDE_ONLY, values={"omega": 0.78})
    (zone,), (wide,) = found.zones, found.wider
    assert zone.upper.kind == wide.upper.kind == RANGE
    assert (wide.lower.inside, wide.lower.outside) == ("6-6-0", "6-6-1")
    assert wide.lower.point is not None
    assert "back side" in str(wide.lower)
    assert zone.lower.value > wide.lower.value
    assert {t.label for t in wide.coexisting if not t.quiet} == {"3-3-1"}
    assert [p.unit for p in zone.physical] == ["um"]


def test_an_orbit_that_turns_unstable_ends_the_zone_there():
    """Not at a periodic window that lies behind it between the same two points of the sweep: the 2-1-0 motion
    of the article's pair gives way to a torus, where a pair of multipliers has the modulus 1."""
    pair = case.load("article")
    family, _ = pair.family()
    axis = Axis("omega", np.array([1.15, 1.175]))
    up = studies.sweep(pair, axis, direction="up")
    assert not up.points[-1].periodic
    (zone,) = studies.zones(pair, axis, "drive-side-only", known=[up]).zones
    assert zone.upper.uncertainty < 1e-8
    before = {"omega": zone.upper.value - 2.0 * zone.upper.uncertainty}
    start = studies.sweep(pair, Axis("omega", np.array([1.158])), direction="up").points[0].state
    found = orbits.orbit_at(flow.propagators(family.system(before)), start, 2)
    assert found is not None
    assert found.label == zone.upper.inside == "2-1-0"
    assert found.leading.imag != 0.0
    assert abs(found.leading) == pytest.approx(1.0, abs=1e-6)


@pytest.mark.slow
def test_several_kinds_at_once_are_those_of_one():
    both = zones_of_kinds(CLASSICAL, SPEEDS, ["impact-free", "drive-side-only"])
    for kind, found in zip(("impact-free", "drive-side-only"), both, strict=True):
        alone = studies.zones(CLASSICAL, SPEEDS, kind, known=found.sweeps)
        assert [str(z) for z in alone.zones + alone.wider] == [str(z) for z in found.zones + found.wider]
