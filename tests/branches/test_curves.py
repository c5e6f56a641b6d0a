"""Curves in two parameters, and the points where two things happen at once, against numbers from another
program, against closed forms, and against an integrator that shares no code with them."""

from __future__ import annotations

import numpy as np
import pytest

from branches.curved import (
    COARSE,
    E1,
    E2,
    PSI2,
    article,
    between_two_stops,
    corner,
    curve_family,
    doubling_over_error,
    flat,
    fold_over_backlash,
    followed,
    lowest,
    named,
    only,
    swallowtail,
)
from branches.followed import PLAIN, bundled, linear, six, window
from gearlash.branches.continuation import (
    ContinuationSettings,
    SpecialKind,
    continue_orbit,
)
from gearlash.branches.curves import (
    CodimTwoKind,
    CurveEndKind,
    CurvePoint,
)
from gearlash.orbits import orbit_at
from gearlash.system import ContactRule, GearlashError
from orbits.contacts import one_dof_under
from orbits.members import built, one_dof, orbit


def test_a_fold_of_impacts_meets_the_back_side():
    """Known from another program."""
    found = only(fold_over_backlash(), CodimTwoKind.GRAZING_FOLD)
    assert found.values == pytest.approx((0.708031618721831, 0.145906154662747), abs=1e-14)
    assert found.point.multipliers.sum() == pytest.approx(1.4117182920892, abs=1e-12)
    assert {found.label_before, found.label_after} == {"1-1-0", "1-1-1"}


def test_an_orbit_on_one_boundary_does_not_depend_on_the_backlash():
    curve = fold_over_backlash()
    meets = only(curve, CodimTwoKind.GRAZING_FOLD)
    straight = [p.values[0] for p in curve.points if p.arclength > meets.arclength]
    assert len(straight) > 10
    assert np.ptp(straight) < 1e-12


def test_grazing_with_a_multiplier_minus_one_in_permanent_contact():
    """Known from another program; the curve of the side without impacts is straight."""
    found = only(doubling_over_error(), CodimTwoKind.GRAZING_DOUBLING)
    assert found.values == pytest.approx((1.88314401708371501, 0.0934128021427322), abs=1e-14)


def test_the_contact_only_corner():
    """Known from another program. Its orbit is touched by another curve there: the forcing is orthogonal."""
    found = only(corner(), CodimTwoKind.CORNER)
    assert found.values == pytest.approx((1.0219614962, 0.0909609), abs=1e-7)
    assert found.values[0] == pytest.approx(1.0219614962, abs=1e-10)
    assert not any(map(any, found.point.signature.counts))


def test_two_grazing_curves_cross_at_the_corner():
    """The other one, of an orbit that touches elsewhere in the cycle, passes through the same point."""
    found = only(corner(), CodimTwoKind.CORNER)
    names, family = ("omega", "error"), one_dof(error=0.09, ripple=0.95)
    values = named(names, found.values)
    other = followed(family, values, names, found, (1.0, 0.08), (1.05, 0.1), steps=COARSE, touch=1)
    again = only(other, CodimTwoKind.CORNER)
    assert again.values == pytest.approx(found.values, abs=1e-12)
    assert abs(again.point.touches[0].phase - found.point.touches[0].phase) > 0.1
    ends = [end.values for end in other.ends]
    assert all(np.abs(np.subtract(end, found.values)).max() > 1e-3 for end in ends)


def test_the_flat_touch():
    """Closed form: X″ = X‴ = 0 at θ = π."""
    found = only(flat(), CodimTwoKind.FLAT)
    assert found.values == pytest.approx((E1, E2), abs=1e-14)
    (touch,) = found.point.touches
    assert touch.phase == pytest.approx(0.5, abs=1e-5)


def test_a_degenerate_touch_is_a_cusp_of_the_curve():
    """Both parameters are stationary there; on the two sides the extremum is of the other kind."""
    cusps = swallowtail().of_kind(CodimTwoKind.DEGENERATE)
    assert len(cusps) == 2
    for cusp in cusps:
        sides = [p for p in swallowtail().points if abs(p.arclength - cusp.arclength) < 0.05]
        before = [p for p in sides if p.arclength < cusp.arclength]
        after = [p for p in sides if p.arclength > cusp.arclength]
        assert before[-1].touches[0].a0 * after[0].touches[0].a0 < 0.0
        (touch,) = cusp.point.touches
        assert abs(touch.a0) < 1e-7
        forth, back = (np.subtract(p.values, cusp.values) for p in (before[-1], after[0]))
        assert forth @ back > 0.0


def test_two_touches_at_once_are_met_on_both_arms():
    """The crossing of the curve with itself: the same values, each extremum taking its turn."""
    one, two = swallowtail().of_kind(CodimTwoKind.TWO_GRAZINGS)
    assert one.values == pytest.approx(two.values, abs=1e-12)
    assert one.values[1] == pytest.approx(PSI2, abs=1e-10)  # where the response is symmetric
    assert len(one.point.touches) == len(two.point.touches) == 2
    assert one.point.state == pytest.approx(two.point.state, abs=1e-11)


def test_the_point_of_the_article():
    """The doubling of 6-6-1 at D = 0.3523 and the touch at 0.3855 are curves of one point."""
    found = only(article(), CodimTwoKind.GRAZING_DOUBLING)
    assert found.values == pytest.approx((0.3448140829648, 0.0475457194044), abs=1e-12)
    assert {found.label_before, found.label_after} == {"6-6-1", "6-6-2"}
    values = named(("omega", "D", "bearing_damping"), (0.78, *found.values))
    names, limits = ("D", "bearing_damping"), ((0.34, 0.0378), (0.4, 0.05))
    touching = followed(bundled(), values, names, found, *limits, steps=COARSE)
    ends = [end.values for end in touching.ends if end.values[1] == pytest.approx(0.0378, abs=1e-12)]
    (grazing,) = six().of_kind(SpecialKind.GRAZING)
    assert [end[0] for end in ends] == pytest.approx([grazing.value], abs=1e-11)
    doubled = followed(bundled(), values, names, found, *limits, steps=COARSE, doubled=True)
    assert doubled.ends[0].kind is CurveEndKind.HALF_PERIOD
    assert doubled.ends[0].values == pytest.approx(found.values, abs=1e-11)
    assert {str(point.signature) for point in doubled.points} == {"12-12-2"}
    assert doubled.ends[1].values[0] == pytest.approx(0.3523, abs=5e-4)


def test_the_point_of_the_article_by_an_evaluation_that_shares_no_code():
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    from oracles import region_oracle
    from oracles.clearances import gap, gap_velocity

    found = only(article(), CodimTwoKind.GRAZING_DOUBLING)
    system = bundled().system({"omega": 0.78, **named(("D", "bearing_damping"), found.values)})
    (touch,) = found.point.touches
    walk = region_oracle.run(system, found.point.state, 6.0, variational=True)
    assert np.abs(walk.state - found.point.state).max() < 1e-12
    assert walk.jacobian is not None
    matrix = np.asarray(walk.jacobian, dtype=np.float64) + np.eye(system.size)
    assert np.linalg.svd(matrix)[1][-1] < 1e-11
    at = region_oracle.run(system, found.point.state, touch.phase).state
    assert abs(float(gap(system, system.clearances[0], at, touch.phase) + found.values[0])) < 1e-12
    assert abs(float(gap_velocity(system, system.clearances[0], at, touch.phase))) < 1e-12


def test_the_same_point_from_every_curve_that_leaves_it():
    found = only(article(), CodimTwoKind.GRAZING_DOUBLING)
    values = named(("omega", "D", "bearing_damping"), (0.78, *found.values))
    names, limits = ("D", "bearing_damping"), ((0.34, 0.045), (0.35, 0.05))
    for kind in (SpecialKind.GRAZING, SpecialKind.DOUBLING):
        again = followed(bundled(), values, names, found, *limits, kind=kind, steps=COARSE)
        (met,) = again.of_kind(CodimTwoKind.GRAZING_DOUBLING)
        assert met.values == pytest.approx(found.values, abs=1e-12)


def test_a_torus_curve_meets_the_back_side():
    """An orbit on the drive side alone does not depend on the backlash: where its minimum lies on −D is told
    by its distance from +D."""
    torus = lowest(window(), SpecialKind.TORUS)
    (least,) = [e for e in torus.point.extrema if e.boundary == 1 and e.a0 > 0.0]
    values, names, steps = (
        {"omega": torus.value},
        ("omega", "D"),
        ContinuationSettings(longest=0.5, certify=False),
    )
    curve = followed(bundled(), values, names, torus, (0.915, 0.01), (0.925, 1.1), steps=steps)
    found = only(curve, CodimTwoKind.GRAZING_TORUS)
    assert found.values == pytest.approx((torus.value, -0.5 * least.distance), abs=1e-11)
    assert {found.label_before, found.label_after} == {"1-1-0", "1-1-1"}
    assert {str(point.signature) for point in curve.points} == {"1-1-0", "1-1-1"}
    for point in curve.points:
        pairs = point.multipliers[point.multipliers.imag > 0.0]
        assert np.abs(np.abs(pairs) - 1.0).min() < 1e-9


@pytest.mark.parametrize(
    "curve", [fold_over_backlash, doubling_over_error, corner, flat, swallowtail, article]
)
def test_a_curve_ends_at_limits_and_is_admissible(curve):
    assert all(end.kind is CurveEndKind.LIMIT for end in curve().ends)
    assert len(curve().admissible) == 1
    assert all(point.residual < 1e-10 for point in (*curve().points, *(s.point for s in curve().special)))
    arclengths = [point.arclength for point in curve().points]
    assert arclengths == sorted(arclengths)


def test_a_doubling_curve_is_tangent_to_the_grazing_beyond_it_and_crosses_it_before():
    """Depth grows as the square of the way on the side with impacts, distance with the way on the other."""
    curve = doubling_over_error()
    meets = only(curve, CodimTwoKind.GRAZING_DOUBLING)
    (touch,) = meets.point.touches

    def nearest(point: CurvePoint) -> float:
        alike = [e for e in point.extrema if e.group == touch.group]
        return abs(min(alike, key=lambda e: abs(e.phase - touch.phase)).distance)

    for order, beyond in ((1.0, False), (2.0, True)):
        points = [p for p in curve.points if (p.signature == "1-1-0") is beyond]
        ways = np.array([np.linalg.norm(np.subtract(p.values, meets.values)) for p in points])
        near = np.argsort(ways)
        chosen = [int(i) for i in near if 1e-4 < ways[i] < 0.02][:2]
        depths = [nearest(points[i]) for i in chosen]
        slope = np.polyfit(np.log(ways[chosen]), np.log(depths), 1)[0]
        assert slope == pytest.approx(order, abs=0.1)


@pytest.mark.parametrize("curve", [fold_over_backlash, doubling_over_error, corner, flat, swallowtail])
def test_equations_hold_by_an_evaluation_that_shares_no_code(curve):
    """In 80 bits: the orbit closes, what touches lies on its boundary, multipliers lie where they should."""
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    from oracles import region_oracle

    found = curve()
    family = curve_family[curve]()
    for point in found.points[:: max(1, len(found.points) // 8)]:
        values = {**found.values, **dict(zip(found.names, point.values, strict=True))}
        system = family.system(values)
        held = None
        for touch in point.touches:
            held = (touch.clearance, touch.boundary, touch.boundary * touch.a0 > 0.0)
            at = region_oracle.run(system, point.state, touch.phase).state
            gap = system.clearances[touch.clearance].h @ at - touch.boundary * values["D"]
            assert abs(float(gap)) < 1e-10
            assert abs(float(system.clearances[touch.clearance].h @ (system.matrix @ at))) < 1e-10
        assert held is None or found.kind is SpecialKind.GRAZING
        walk = region_oracle.run(system, point.state, point.period, variational=not point.touches)
        assert np.abs(walk.state - point.state).max() < 1e-10
        if walk.jacobian is not None:
            target = 1.0 if found.kind is SpecialKind.FOLD else -1.0
            matrix = np.asarray(walk.jacobian, dtype=np.float64) - target * np.eye(system.size)
            assert np.linalg.svd(matrix)[1][-1] < 1e-10


@pytest.mark.parametrize("curve", [fold_over_backlash, doubling_over_error, corner])
def test_the_same_curve_from_one_of_its_ends(curve):
    found = curve()
    start = found.points[2]
    values = {**found.values, **dict(zip(found.names, start.values, strict=True))}
    family = curve_family[curve]()
    again = followed(family, values, found.names, start, found.lower, found.upper, kind=found.kind)
    assert [special.kind for special in again.special] in (
        [special.kind for special in found.special],
        [special.kind for special in found.special[::-1]],
    )
    one, two = (sorted(special.values for special in each.special) for each in (found, again))
    assert np.abs(np.subtract(one, two)).max() < 1e-11
    one, two = (sorted(end.values for end in each.ends) for each in (found, again))
    assert np.abs(np.subtract(one, two)).max() < 1e-9


def test_no_curve_begins_far_from_the_orbit_or_with_another_kind():
    fold = lowest(linear(), SpecialKind.FOLD)
    family, names, limits = one_dof(error=0.05), ("omega", "D"), ((0.6, 0.05), (0.9, 1.2))
    with pytest.raises(GearlashError, match=r"no special orbit|no point of a curve"):
        followed(family, {"omega": fold.value + 0.02}, names, fold, *limits)
    with pytest.raises(GearlashError, match="is a fold"):
        followed(family, {"omega": fold.value}, names, fold, *limits, SpecialKind.DOUBLING)


def test_where_the_local_law_has_no_root():
    """Inside the tongue of a ripple, M₁₂ of the monodromy at the touch vanishes: in 80 bits."""
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    from oracles import region_oracle

    family, values = one_dof(error=0.0005, ripple=0.3, error_phase=1.0), {"omega": 1.9, "error": 0.01}
    start = orbit_at(built(family, **values), [1.1, 0.0], 1)
    assert start is not None
    branch = continue_orbit(family, values, "error", start, 0.001, 0.2, PLAIN)
    touch = lowest(branch, SpecialKind.GRAZING)
    values = {**values, "error": touch.value}
    names, limits = ("omega", "error"), ((1.9, 0.0001), (2.0, 0.2))
    found = only(followed(family, values, names, touch, *limits, steps=COARSE), CodimTwoKind.NO_ROOT)
    system = family.system(named(names, found.values))
    (extremum,) = found.point.touches
    state = region_oracle.run(system, found.point.state, extremum.phase, held=(0, 1, True)).state
    walk = region_oracle.run(system, state, 1.0, extremum.phase, True, held=(0, 1, True))
    assert walk.jacobian is not None
    assert abs(float(walk.jacobian[0, 1])) < 1e-10


def test_orders_of_contact_where_a_fold_meets_a_grazing():
    """The grazing curve is tangent to the fold of the clear side, of second order, and of third order to
    that of the side with the new impact."""
    meets = only(fold_over_backlash(), CodimTwoKind.GRAZING_FOLD)
    names, limits = ("omega", "D"), ((0.7079, 0.1446), (0.7082, 0.1470))
    family, values = one_dof(error=0.05), named(names, meets.values)
    grazing = followed(family, values, names, meets, *limits)
    omega, d = (grazing.parameters - meets.values).T
    graze = np.polynomial.Polynomial.fit(d, omega, 7)
    assert abs(graze(0.0)) < 1e-9
    assert abs(graze.deriv()(0.0)) < 1e-6
    assert graze.deriv(2)(0.0) > 10.0
    fine = ContinuationSettings(longest=0.02, certify=False)
    folds = followed(family, values, names, meets, *limits, SpecialKind.FOLD, fine)
    away = np.array([np.subtract(p.values, meets.values) for p in folds.points if p.signature == "1-1-1"])
    gaps, ways = np.abs(away[:, 0] - graze(away[:, 1])), np.abs(away[:, 1])
    near = (ways > 2e-5) & (ways < 5e-4)
    assert near.sum() >= 3
    assert np.polyfit(np.log(ways[near]), np.log(gaps[near]), 1)[0] == pytest.approx(3.0, abs=0.2)


def test_a_closed_curve_is_followed_once():
    """The touches of an orbit with three impacts, from the two values at which its branch meets them."""
    rng = np.random.default_rng(10)
    names = ("load", "mesh_damping", "error", "ripple")
    drawn = named(
        names, tuple(rng.uniform(*ends) for ends in ((0.05, 0.3), (0.02, 0.1), (0.02, 0.2), (0.0, 0.3)))
    )
    family = one_dof_under(ContactRule.IN_CONTACT, **drawn, D=float(rng.uniform(0.2, 1.0)))
    values = {"omega": float(rng.uniform(1.3, 1.6))}
    branch = continue_orbit(family, values, "omega", orbit(family, **values), 1.1, 1.7, PLAIN)
    for touch in branch.of_kind(SpecialKind.GRAZING)[:2]:
        values = {"omega": touch.value}
        curve = followed(family, values, ("omega", "error"), touch, (0.5, 0.005), (1.8, 0.3))
        assert {end.kind for end in curve.ends} == {CurveEndKind.CLOSED}
        assert np.ptp(curve.parameters[:, 0]) == pytest.approx(0.166, abs=2e-3)


@pytest.mark.parametrize("one", [False, True])
def test_two_clearances_or_both_sides_of_one_grazed_at_once(one):
    """Closed form: the amplitude 1/√((1 − ω²)² + 0.01 ω²) is as large as both gaps."""
    family, quiet = between_two_stops(one), "1-0-0" if one else "1-0-0/0-0"
    branch = continue_orbit(family, {"omega": 2.0}, "omega", orbit(family, omega=2.0), 1.3, 2.1, COARSE)
    free = next(s for s in branch.of_kind(SpecialKind.GRAZING) if quiet in (s.label_before, s.label_after))
    values, names = {"omega": free.value}, ("omega", "other")
    curve = followed(family, values, names, free, (1.3, 0.5), (2.1, 2.0), steps=COARSE)
    found = only(curve, CodimTwoKind.TWO_GRAZINGS)
    square = np.roots([1.0, 0.01 - 2.0, 0.0]).max()  # of ω where the amplitude is 1
    assert found.values == pytest.approx((np.sqrt(square), 1.0), abs=1e-13)
    sides = {(extremum.clearance, extremum.boundary) for extremum in found.point.touches}
    assert sides == ({(0, 1), (0, -1)} if one else {(0, 1), (1, -1)})
    other = followed(
        family, named(names, found.values), names, found, (1.3, 0.5), (2.1, 2.0), steps=COARSE, touch=1
    )
    omega, gap = other.parameters.T
    clear = gap < 1.0
    amplitude = 1.0 / np.sqrt((1.0 - omega**2) ** 2 + 0.01 * omega**2)
    assert clear.sum() > 3
    assert amplitude[clear] == pytest.approx(gap[clear], abs=1e-11)


def test_a_curve_of_doubled_orbits_ends_where_that_of_the_simple_ones_has_a_multiplier_minus_one():
    """Its ends are told from the orbits before them; the points were solved for on the curve of 3-3-0."""
    bearings = [-0.0110672, 0.0119397, -0.0090352, -0.0181742, 0.0834476, 0.0196876, 0.0241313, 0.0189272]
    state = [*bearings, 0.7956098, 0.2431697]
    values = {"omega": 0.7698783659796269, "D": 0.5}
    doubled = orbit_at(built(bundled(), **values), state, 6)
    assert doubled is not None
    branch = continue_orbit(bundled(), values, "D", doubled, 0.499, 0.501, COARSE)
    touch = min(branch.of_kind(SpecialKind.GRAZING), key=lambda each: abs(each.value - 0.5))
    values = {**values, "D": touch.value}
    curve = followed(bundled(), values, ("omega", "D"), touch, (0.7, 0.3), (0.8, 0.6), steps=COARSE)
    assert {end.kind for end in curve.ends} == {CurveEndKind.HALF_PERIOD}
    ends = sorted(end.values for end in curve.ends)
    known = [(0.7613856795022322, 0.5235045266697037), (0.772674979127485, 0.4500202631687911)]
    assert np.abs(np.subtract(ends, known)).max() < 1e-5
