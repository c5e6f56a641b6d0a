"""Stable zones: ends against closed forms, hysteresis, ranges that end first, and interval algebra."""

from __future__ import annotations

import math
import threading
from concurrent.futures import ThreadPoolExecutor
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearlash import case, flow, orbits, studies
from gearlash.branches import locate_multiplier
from gearlash.branches.continuation import SpecialKind, SpecialPoint
from gearlash.jobs import Execution, Progress
from gearlash.studies import Axis, Direction, Interval, Quiet, ZoneEnd
from gearlash.studies.intervals import intersection, union
from gearlash.studies.model import Source
from gearlash.studies.quiet import Row, Search
from gearlash.studies.scanned import scanned_zones
from gearlash.studies.zone import Zone, ZoneMotion
from gearlash.studies.zone_end import BASIN, RANGE, UNKNOWN
from gearlash.studies.zone_end import Interval as Plain
from gearlash.studies.zones import zones_of_kinds
from gearlash.system import GearlashError, Signature, UnknownNameError

ARTICLE = case.load("article-first-harmonic")
CLASSICAL = case.load("kahraman-singh")
SPEEDS = Axis.even("omega", 0.3, 1.6, 53)


def loss_of_contact() -> tuple[float, float]:
    """Frequencies at which x'' + 0.1 x' + x = 0.1 + 0.05 ω² cos ωτ just reaches x = 0: amplitude 0.1, that is
    (1 − w)² + 0.01 w = w²/4 in w = ω²."""
    a, b, c = 0.75, -1.99, 1.0
    root = math.sqrt(b * b - 4.0 * a * c)
    return math.sqrt((-b - root) / (2.0 * a)), math.sqrt((-b + root) / (2.0 * a))


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


def test_a_basin_that_ends_is_no_bifurcation():
    """From far outside, the cold start falls into the impacting motion long before the quiet one ends."""
    axis = Axis.even("omega", 0.65, 0.8, 7)
    cold = studies.sweep(CLASSICAL, axis, start=[2.0, 0.0])
    found = scanned_zones(CLASSICAL, axis, "impact-free", [cold], start=[2.0, 0.0])
    (zone,) = found.zones
    assert zone.upper.kind == BASIN
    assert 0.0 < zone.upper.uncertainty <= 1e-6
    assert zone.upper.value < loss_of_contact()[0]


def test_what_cannot_be_computed_ends_a_zone_without_a_bound():
    axis = Axis("D", np.array([-1.0, -0.5, 0.5, 1.0]))
    found = studies.zones(CLASSICAL, axis, values={"omega": 0.5})
    (zone,) = found.zones
    assert (zone.lower.kind, zone.upper.kind) == (UNKNOWN, RANGE)
    assert zone.lower.value == pytest.approx(0.0, abs=1e-6)
    assert zone.lower.outside is None
    assert "no system" in zone.lower.reason
    assert found.wider == ()


def test_a_cancelled_search_knows_that_it_is_incomplete():
    cancel = threading.Event()
    count = 3 * len(SPEEDS)
    found = studies.zones(
        CLASSICAL,
        SPEEDS,
        execution=Execution(progress=lambda p: p.done == count and cancel.set(), cancel=cancel),
    )
    assert (found.complete, found.message) == (False, "cancelled")
    assert found.zones == found.wider == found.branches == ()


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


def test_an_orbit_that_ends_in_a_fold_beside_chaos():
    """The 2-1-0 motion of the article's pair ends at a fold; what is seen beyond is aperiodic."""
    settings = studies.Settings(patience=600, budget=1_500, exponent_periods=600)
    axis = Axis.even("omega", 1.14, 1.18, 3)
    up = studies.sweep(ARTICLE, axis, direction="up", settings=settings)
    assert up.points[-1].label == "aperiodic"
    (zone,) = scanned_zones(ARTICLE, axis, "drive-side-only", [up], settings=settings).zones
    assert zone.upper.kind == "fold"
    assert zone.upper.inside == "2-1-0"
    beside = Axis("omega", zone.upper.value + np.array([-1e-3, -1e-5, 1e-4]))
    seen = studies.sweep(ARTICLE, beside, direction="up", settings=settings, start=up.points[0].state)
    assert [p.label for p in seen.points[:2]] == ["2-1-0", "2-1-0"]
    assert not seen.points[2].periodic
    assert seen.points[1].leading.real == pytest.approx(1.0, abs=0.1)


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


def ends(pair: tuple[int, int]) -> Interval:
    low, high = sorted(pair)
    return Interval(ZoneEnd(float(low), "x"), ZoneEnd(float(high + 1), "x"))


ROWS = st.lists(
    st.lists(st.tuples(st.integers(0, 20), st.integers(0, 20)).map(ends), max_size=4), min_size=1, max_size=3
)


@given(ROWS)
def test_interval_algebra_is_that_of_sets(rows):
    rows = [union([row]) for row in rows]  # intervals of one row do not overlap
    every, some = intersection(rows), union(rows)
    for value in np.arange(0.5, 21.0):
        inside = [any(i.contains(value) for i in row) for row in rows]
        assert any(i.contains(value) for i in every) == all(inside)
        assert any(i.contains(value) for i in some) == any(inside)
    assert all(a.upper.value < b.lower.value for a, b in pairwise(some))


def test_margins():
    zone = Zone(ZoneEnd(1.0, "fold", 0.1), ZoneEnd(2.0, RANGE), "D", Quiet.IMPACT_FREE, True)
    assert zone.margin(1.5) == pytest.approx(0.4)
    assert zone.margin(0.7) == pytest.approx(-0.3)
    assert zone.margin(2.5) == pytest.approx(-0.5)
    assert (
        Zone(ZoneEnd(1.0, RANGE), ZoneEnd(2.0, RANGE), "D", Quiet.IMPACT_FREE, True).margin(1.2) == math.inf
    )


def test_motions_coexist_only_where_they_overlap():
    motions = (
        ZoneMotion(Signature(1, 0), ("up",), 1.0, 1.4, True),
        ZoneMotion(Signature(2, 1), ("down",), 1.3, 1.6, False),
    )
    apart = (motions[0], ZoneMotion(Signature(2, 1), ("up",), 1.5, 1.6, False))
    span = Plain(ZoneEnd(1.0, RANGE), ZoneEnd(2.0, RANGE))
    meeting = tuple(
        ZoneMotion(Signature(period, 0), ("up",), low, high, True, span, span, 0)
        for period, low, high in ((1, 1.0, 1.4), (2, 1.4, 1.6))
    )

    def make(motions):
        return Zone(ZoneEnd(1.0, RANGE), ZoneEnd(2.0, RANGE), "D", Quiet.IMPACT_FREE, False, motions)

    assert make(motions).coexisting == motions
    assert make(apart).coexisting == ()
    assert make(meeting).coexisting == ()


def sharp_loss_of_contact(damping: float, load: float, error: float) -> tuple[float, float]:
    """Frequencies at which the amplitude ω²E/|1 − ω² + 2iζω| is the load: a quadratic in w = ω²."""
    a, b, c = 1.0 - (error / load) ** 2, 4.0 * damping**2 - 2.0, 1.0
    root = math.sqrt(b * b - 4.0 * a * c)
    return math.sqrt((-b - root) / (2.0 * a)), math.sqrt((-b + root) / (2.0 * a))


@pytest.mark.parametrize("count", [2, 3, 5, 15])
def test_impacts_between_two_quiet_points_end_the_zones(count: int):
    """However few points: motion is quiet at both ends of the range, and has impacts around the resonance."""
    low, high = loss_of_contact()
    found = studies.zones(CLASSICAL, Axis.even("omega", 0.3, 1.6, count))
    intervals = [*found.zones, *found.wider]
    assert not any(z.lower.value < 0.5 * (low + high) < z.upper.value for z in intervals)
    solved = [end for z in intervals for end in (z.lower, z.upper) if end.kind == "grazing"]
    assert any(abs(end.value - low) < 1e-9 for end in solved)
    assert any(abs(end.value - high) < 1e-9 for end in solved)


def test_an_end_does_not_depend_on_the_step_of_the_sweep():
    """The impacting motion of this pair is lost in a step of a 128th of the axis, but goes on to a fold."""
    drive = case.load(str(Path(__file__).parents[1] / "cases" / "drive.toml"))
    family, scales = drive.family()
    values = scales.omega_from_rpm(np.array([1000.0, 3500.0, 6000.0]))
    down = studies.sweep(family, Axis("omega", np.linspace(0.503, 0.517, 15)), direction="down")
    assert down.points[0].label == "1-1-0"
    orbit = orbits.attractor(family.system({"omega": 0.503}), down.points[0].state)
    assert isinstance(orbit, orbits.Orbit)
    fold = locate_multiplier(family, "omega", orbit, 1, values={"omega": 0.503})
    end = studies.zones(drive, Axis("omega", values)).zones[0].upper
    assert (end.kind, end.inside, end.outside) == ("fold", "1-0-0", "1-1-0")
    assert end.value == pytest.approx(fold.value, rel=1e-9)


@pytest.mark.parametrize("range_", [(0.5, 1.5), (0.4, 1.31), (0.73, 1.9)])
def test_a_loss_of_contact_narrower_than_a_step_is_found_by_its_flanks(range_: tuple[float, float]):
    """A resonance with ζ = 0.001, in which contact is lost over 1.3e-3 in ω only."""
    values = {"mesh_damping": 1e-3, "load": 0.1, "error": 2.4e-4}
    low, high = sharp_loss_of_contact(1e-3, 0.1, 2.4e-4)
    assert 1e-3 < high - low < 2e-3
    found = studies.zones(CLASSICAL, Axis.even("omega", *range_, 5), values=values)
    assert found.resolution > 3.0 * (high - low)
    intervals = [*found.zones, *found.wider]
    assert not any(z.contains(0.5 * (low + high)) for z in intervals)
    ends = {round(e.value, 9) for z in intervals for e in (z.lower, z.upper) if e.kind == "grazing"}
    assert {round(low, 9), round(high, 9)} <= ends


def test_a_load_that_changes_sides_is_no_quiet_interval_through_zero():
    """Contact on the drive side and contact on the back side have the gap between them."""
    values = {"omega": 0.5, "mesh_damping": 0.3}
    found = studies.zones(CLASSICAL, Axis.even("load", -0.2, 0.2, 2), values=values)
    intervals = [*found.zones, *found.wider]
    amplitude = 0.05 * 0.25 / abs(0.75 + 0.3j)
    assert not any(z.lower.value < 0.0 < z.upper.value for z in intervals)
    ends = [e.value for z in intervals for e in (z.lower, z.upper) if e.kind == "grazing"]
    assert min(abs(e - amplitude) for e in ends) < 1e-9
    assert min(abs(e + amplitude) for e in ends) < 1e-9


def test_the_step_that_is_told_is_that_between_orbits_of_a_branch():
    found = studies.zones(CLASSICAL, Axis.even("omega", 0.3, 0.6, 4))
    assert found.resolution == pytest.approx(0.1)
    (branch,) = found.branches
    assert found.step == pytest.approx(float(np.diff(branch.parameter).max()), rel=1e-9)


def test_several_kinds_at_once_are_those_of_one():
    both = zones_of_kinds(CLASSICAL, SPEEDS, ["impact-free", "drive-side-only"])
    for kind, found in zip(("impact-free", "drive-side-only"), both, strict=True):
        alone = studies.zones(CLASSICAL, SPEEDS, kind, known=found.sweeps)
        assert [str(z) for z in alone.zones + alone.wider] == [str(z) for z in found.zones + found.wider]


def test_an_end_of_one_row_is_looked_at_in_the_others():
    """A grazing that ends another sweep's interval between two quiet points of this one is probed there."""
    axis = Axis.even("omega", 0.4, 0.6, 2)
    (up,) = studies.sweeps(CLASSICAL, axis, ["up"])
    search = Search(Source.of(CLASSICAL), (), studies.Settings(), Quiet.IMPACT_FREE, None, Execution())
    row = Row(up.direction, up.points, frozenset(p.value for p in up.points))
    known = studies.sweeps(CLASSICAL, SPEEDS, ["up"])
    point = scanned_zones(CLASSICAL, SPEEDS, "impact-free", known).zones[0].upper.point
    assert point is not None
    assert point.is_grazing
    end = ZoneEnd(0.5, "grazing", 1e-12, point=point)
    ((at, found),) = search.probes(row, {(Direction.COLD, 0.4, 0.6): end})
    assert (at, found) == (0, end)
    (probed,) = search.probed([row], [[(at, found)]], "omega", 0.1)
    values = [p.value for p in probed.points]
    assert values == pytest.approx([0.4, 0.5, 0.5, 0.6], abs=1e-6)
    assert values[1] < 0.5 < values[2]
    assert search.probes(probed, {(Direction.COLD, 0.4, 0.6): end}) == []


def test_one_quiet_point_is_enough_to_follow_its_motion():
    axis = Axis("D", np.array([-1.0, 0.5]))
    found = studies.zones(CLASSICAL, axis, values={"omega": 0.5})
    (zone,) = found.zones
    assert (zone.lower.kind, zone.upper.value) == (UNKNOWN, 0.5)
    assert found.complete


def test_a_search_that_was_stopped_before_any_end_says_so():
    """Nothing is known beside a single quiet point: no interval, and no error."""
    axis = Axis.even("omega", 0.79, 1.3, 3)  # quiet, with impacts, quiet
    cancel = threading.Event()
    found = studies.zones(
        CLASSICAL, axis, execution=Execution(progress=lambda p: p.done == 9 and cancel.set(), cancel=cancel)
    )
    assert not found.complete
    assert found.message == "cancelled"
    assert all(zone.width > 0.0 for zone in (*found.zones, *found.wider))


def test_ctrl_c_while_zones_are_swept_begins_nothing_more():
    told = []

    def interrupt(progress: Progress) -> None:
        told.append(progress.total)
        if progress.done == 40:
            raise KeyboardInterrupt

    found = studies.zones(CLASSICAL, SPEEDS, execution=Execution(progress=interrupt))
    assert set(told) == {3 * len(SPEEDS)}  # no end was looked for
    assert (found.complete, found.message) == (False, "interrupted")
    assert sum(sweep.computed for sweep in found.sweeps) == 40
    assert found.zones == found.wider == ()
