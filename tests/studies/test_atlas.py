"""Atlases: curves against closed forms, the map as a check, and what is left undone."""

from __future__ import annotations

import threading
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import gearlash as gl
from branches.shaken import response, shaken
from branches.softening import softening
from gearlash.branches.continuation import SpecialKind
from gearlash.results.atlas import STAGES, LabelChangeKind
from gearlash.studies.atlas.links import Link, connected

CURVE, COEXIST, POINT, NONE = (
    LabelChangeKind(each) for each in ("curve", "coexistence", "special point without a curve", "unexplained")
)
KS = "kahraman-singh"


@cache
def oscillator(turned: bool = False) -> gl.Atlas:
    x, y = gl.Axis("omega", np.array([0.65, 0.7, 0.75, 0.8])), gl.Axis("gap", np.array([1, 2]))
    axes = (y, x) if turned else (x, y)
    return gl.atlas(shaken(), *axes, values={"a": 1, "beta": 2.0, "zeta": 0.05}, lines=1, longest=1)


def amplitude(omega: float) -> float:
    return abs(response({"omega": omega, "a": 1.0, "zeta": 0.05}))


def test_the_grazing_curve_of_a_linear_motion_is_its_resonance_curve():
    """Below the stop the motion is linear, so that it grazes where its amplitude is the gap."""
    touches = [each.curve for each in oscillator().of_kind("grazing")]
    points = [p for curve in touches for p in curve.points if p.signature.impacts == 0]
    assert len(points) > 5
    for point in points:
        omega, gap = point.values
        assert gap == pytest.approx(amplitude(omega), rel=1e-9)
    reached = [point.values[0] for point in points]
    assert min(reached) == pytest.approx(0.7071, abs=0.02)


def test_either_order_of_the_axes_draws_the_same_curves():
    one, other = oscillator(), oscillator(turned=True)
    assert one.names == other.names[::-1] == ("omega", "gap")
    assert sorted(str(each.kind) for each in one.curves) == sorted(str(each.kind) for each in other.curves)
    for each in one.curves:
        ends = sorted(end.values for end in each.curve.ends)
        turned = [sorted(end.values[::-1] for end in like.curve.ends) for like in other.of_kind(each.kind)]
        assert any(np.allclose(ends, like, rtol=0.0, atol=1e-7) for like in turned)
    assert one.counts == other.counts


@cache
def below(columns: int = 5, rows: int = 4) -> gl.Atlas:
    x, y = gl.Axis.even("omega", 0.65, 0.85, columns), gl.Axis.even("D", 0.12, 1.1, rows)
    return gl.atlas(gl.load_case(KS), x, y, lines=1)


@pytest.mark.slow
def test_a_curve_is_straight_until_the_farthest_extremum_meets_the_back_side():
    """An orbit on one boundary does not depend on D. Its least X, taken from the drive side, is the same for
    every D, so that where it meets the back side follows from one orbit alone."""
    straight = [each for each in below().of_kind("fold") if each.straight]
    fold = min(straight, key=lambda each: each.straight[0].value)
    (piece,) = fold.straight
    assert piece.name == "D"
    assert piece.value == pytest.approx(0.708031618721831, abs=1e-10)
    assert piece.upper == pytest.approx(1.1, abs=1e-12)
    point = max(fold.curve.points, key=lambda each: each.values[1])
    omega, gap = point.values
    family, _ = gl.load_case(KS).family()
    trace = gl.trace(family.system({"omega": omega, "D": gap}), point.state, 1.0)
    least = float(trace.extrema.displacement.min())
    meets = (gap - least) / 2.0
    assert meets == pytest.approx(0.145906154662747, abs=1e-9)
    assert piece.lower == pytest.approx(meets, abs=1e-9)
    special = next(each for each in below().points if each.kind is gl.CodimTwoKind.GRAZING_FOLD)
    assert special.values == pytest.approx((0.708031618721831, 0.145906154662747), abs=1e-9)


def test_the_grazing_line_of_a_motion_that_stays_in_contact_is_straight_all_the_way():
    (line,) = (
        each
        for each in below().of_kind("grazing")
        if all(p.signature.impacts == 0 for p in each.curve.points)
    )
    (piece,) = line.straight
    assert piece.name == "D"
    assert (piece.lower, piece.upper) == pytest.approx((0.12, 1.1), abs=1e-12)


@pytest.mark.slow
def test_a_coarse_map_and_a_fine_one_give_the_same_curves():
    coarse, fine = below(), below(2, 2)
    folds = [sorted(round(p.value, 8) for each in a.curves for p in each.straight) for a in (coarse, fine)]
    assert set(folds[0]) == set(folds[1])
    assert fine.counts[NONE] == fine.counts[POINT] == 0


def test_every_curve_is_drawn_once():
    for each in below().curves:
        alike = [o for o in below().curves if o.kind is each.kind and o is not each]
        middle = np.array(each.curve.points[len(each.curve.points) // 2].values)
        for other in alike:
            near = np.abs(other.curve.parameters - middle).max(axis=1).min()
            state = each.curve.points[len(each.curve.points) // 2].state
            same = min(float(np.abs(p.state - state).max()) for p in other.curve.points)
            assert near > 1e-4 or same > 1e-2


def test_the_budget_leaves_the_rest_and_says_so():
    x, y = gl.Axis.even("omega", 0.65, 0.85, 3), gl.Axis.even("D", 0.5, 1.1, 2)
    found = gl.atlas(gl.load_case(KS), x, y, lines=1, curves=1)
    assert (found.tried, len(found.curves), found.complete) == (1, 1, True)
    left = [each for each in found.undone if each.why == "the budget of 1 curve was spent"]
    assert {each.what for each in left} == {"curve of kind fold"}
    assert {round(each.values[0], 4) for each in left} == {0.708, 0.8285}


def test_one_missing_curve_is_told_once_however_many_lines_it_crosses():
    x, y = gl.Axis.even("omega", 0.81, 0.83, 2), gl.Axis.even("D", 0.9, 1.1, 2)
    found = gl.atlas(gl.load_case(KS), x, y, lines=2, curves=0)
    assert sorted(each.what for each in found.undone) == ["curve of kind fold", "curve of kind grazing"]
    assert all("met at 4 places, of one curve or of several" in each.why for each in found.undone)


def test_what_has_no_curve_to_follow_is_told_as_undone():
    axes = gl.Axis.even("kappa", 0.7, 1.2, 4), gl.Axis.even("D", 0.5, 1.0, 2)
    (left,) = gl.atlas(softening(), *axes, lines=2).undone
    assert left.what == "curve of kind end of existence"
    assert left.values[0] == pytest.approx(1.0, abs=1e-12)
    assert left.why == "no curve of this kind is followed; met at 2 places, of one curve or of several"


def test_without_lines_the_check_finds_what_curves_begin_with():
    x, y = gl.Axis.even("omega", 1.36, 1.44, 2), gl.Axis.even("D", 0.5, 1.1, 2)
    case = gl.load_case(KS)
    bare = gl.atlas(case, x, y, lines=0, depth=0)
    assert bare.counts[NONE] == len(bare.changes) == 2
    points = gl.atlas(case, x, y, lines=0, depth=1, curves=0)
    assert points.counts[POINT] == 2
    assert "grazing at omega = 1.40709" in points.changes[0].note
    drawn = gl.atlas(case, x, y, lines=0, depth=1)
    assert drawn.counts[CURVE] == 2
    assert all(change.curves for change in drawn.changes)


def test_a_boundary_between_basins_is_told_as_coexistence():
    """Where neither motion ends between two pixels, both attract at either of them."""
    x, y = gl.Axis.even("omega", 0.77, 0.79, 3), gl.Axis.even("D", 0.9, 1.1, 2)
    found = gl.atlas(gl.load_case(KS), x, y, start=[1.0, 0.3], lines=0, depth=1)
    assert found.counts[COEXIST] == len(found.changes) == 2
    assert not found.curves


def test_changes_beside_motion_without_a_period_are_apart():
    x, y = gl.Axis.even("omega", 0.55, 0.6, 2), gl.Axis.even("D", 0.9, 1.1, 2)
    found = gl.atlas(gl.load_case("article"), x, y, lines=0, depth=0)
    kinds = {
        change.kind for change in found.changes if not all(isinstance(a, gl.Signature) for a in change.labels)
    }
    assert kinds <= {LabelChangeKind.APERIODIC}


def test_what_is_stopped_keeps_what_is_there():
    stop, told = threading.Event(), []

    def hear(progress: gl.Progress) -> None:
        told.append(progress)
        if progress.total <= 4 and progress.done >= 2:  # the lines, or the first curves
            stop.set()

    x, y = gl.Axis.even("omega", 0.65, 0.85, 5), gl.Axis.even("D", 0.5, 1.1, 3)
    execution = gl.Execution(progress=hear, cancel=stop)
    found = gl.atlas(gl.load_case(KS), x, y, lines=1, execution=execution)
    assert (found.complete, found.message) == (False, "cancelled")
    assert found.plane.complete
    assert found.done == STAGES[: len(found.done)]
    assert found.done[:1] == STAGES[:1]
    assert 0 < len(found.done) < len(STAGES)
    assert found.changes
    assert found.counts[LabelChangeKind.UNSEEN] > 0
    assert found.counts[LabelChangeKind.NONE] == 0
    assert any(each.why == "cancelled" for each in found.undone) or not found.curves


def test_time_may_be_a_budget_too():
    x, y = gl.Axis.even("omega", 0.65, 0.85, 2), gl.Axis.even("D", 0.5, 1.1, 2)
    found = gl.atlas(gl.load_case(KS), x, y, seconds=1e-9)
    assert (found.complete, found.message) == (False, "the time that was given is over")


def test_workers_draw_the_same_to_the_last_bit():
    case = gl.load_case(KS)
    x, y = gl.Axis.even("omega", 0.65, 0.85, 4), gl.Axis.even("D", 0.5, 1.1, 2)
    alone = gl.atlas(case, x, y, lines=1)
    with gl.open_workers(case, 2) as workers:
        shared = gl.atlas(case, x, y, lines=1, execution=gl.Execution(workers))
    assert alone.plane.label.tobytes() == shared.plane.label.tobytes()
    for one, other in zip(alone.curves, shared.curves, strict=True):
        assert one.curve.parameters.tobytes() == other.curve.parameters.tobytes()
    assert [c.kind for c in alone.changes] == [c.kind for c in shared.changes]


@pytest.mark.parametrize(
    ("given", "match"),
    [
        ({"x": gl.Axis("omega", np.array([0.7]))}, "at least two values"),
        ({"x": gl.Axis("D", np.array([0.7, 0.8]))}, "two different parameters"),
        ({"x": "omega"}, "expected an Axis"),
        ({"curves": "5"}, "curves"),
        ({"curves": -1}, "curves"),
        ({"lines": 2.5}, "lines"),
        ({"depth": [1]}, "depth"),
        ({"longest": 0}, "longest"),
        ({"seconds": 0}, "positive time"),
        ({"values": {"omega": 0.7}}, "axis of the study"),
    ],
)
def test_what_does_not_fit_is_refused(given: dict, match: str):
    asked = {"x": gl.Axis("omega", np.array([0.7, 0.8])), "y": gl.Axis("D", np.array([1, 2])), **given}
    with pytest.raises(gl.GearlashError, match=match):
        gl.atlas(gl.load_case(KS), **asked)


def test_links_lead_from_motion_to_motion():
    one, two, three = gl.Signature(1, 0), gl.Signature(1, 1), gl.Signature(2, 2, 1)
    graze, doubling = Link(one, two), Link(two, gl.Signature(2, 2))
    assert connected(one, two, [graze])
    assert not connected(one, three, [graze, doubling])
    assert connected(one, three, [graze, doubling, Link(gl.Signature(2, 2), three)])
    assert connected(one, three, [Link(three, None)])
    assert not connected(one, three, [Link(two, None)])
    assert connected(one, three, [Link(one, 2)])
    assert not connected(one, two, [Link(one, 2)])
    assert SpecialKind.FOLD.value == "fold"


def test_the_numbers_of_its_page_are_those_of_the_atlas():
    page = (Path(__file__).resolve().parents[2] / "docs" / "atlas.md").read_text(encoding="utf-8")
    for each in below().curves:
        for piece in each.straight:
            if piece.upper - piece.lower > 0.97:
                assert f"straight: omega = {piece.value:.8g} for D from 0.12 to 1.1" in page
    (point,) = (each for each in below().points if each.kind is gl.CodimTwoKind.GRAZING_FOLD)
    assert "{:.8f}  {:.8f}".format(*point.values) in page
    assert f"\n  {below().counts[CURVE]}  a curve of these motions" in page


@pytest.mark.slow
def test_at_a_corner_both_grazing_curves_are_drawn():
    """Where the forcing is orthogonal two grazing curves of the motion in contact cross."""
    case = gl.load_case(KS, {"ripple": 0.95, "error_phase": 0.0})
    x, y = gl.Axis.even("omega", 1.0, 1.04, 2), gl.Axis.even("error", 0.08, 0.1, 2)
    found = gl.atlas(case, x, y, lines=1, longest=1, curves=12)
    corners = [each for each in found.points if each.kind is gl.CodimTwoKind.CORNER]
    for each in corners:
        assert each.values == pytest.approx((1.0219614962, 0.0909609), abs=1e-7)
        assert len(each.curves) == 2
    assert corners
