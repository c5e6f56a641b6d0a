"""Points of curves where two multipliers coincide, or a normal form loses a term: against closed forms, by an
integrator that shares no code with them, and by what is found beside them in one parameter."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import mathieu_a, mathieu_b

from branches.coinciding import fed, side_by_side
from branches.curved import Pair, article, followed, lowest, only
from branches.followed import bundled
from gearlash.branches.continuation import (
    ContinuationSettings,
    SpecialKind,
    continue_orbit,
    switched,
)
from gearlash.branches.curves import CodimTwoKind, CodimTwoPoint, Curve, CurveEndKind, locate
from gearlash.orbits import orbit_at
from gearlash.system import Family
from orbits.members import built, orbit

WIDE = ContinuationSettings(certify=False, longest=0.1)


def monodromy(family: Family, curve: Curve, special: CodimTwoPoint) -> np.ndarray:
    """In 80 bits."""
    from oracles import region_oracle

    system = family.system({**curve.values, **dict(zip(curve.names, special.values, strict=True))})
    walk = region_oracle.run(system, special.point.state, special.point.period, variational=True)
    assert np.abs(walk.state - special.point.state).max() < 1e-11
    assert walk.jacobian is not None
    return np.asarray(walk.jacobian, dtype=np.float64)


@cache
def tongue() -> Curve:
    """The doubling of permanent contact over a ripple, through no damping."""
    values = {"free": 0.05, "contact": 0.0, "ripple": 0.3, "force": 0.0}
    start = orbit_at(built(fed(), omega=2.4, **values), [1.1, 0.0], 1)
    assert start is not None
    branch = continue_orbit(fed(), {**values, "omega": 2.4}, "omega", start, 1.6, 2.5, WIDE)
    doubling = branch.of_kind(SpecialKind.DOUBLING)[0]
    names: tuple[str, str] = ("omega", "free")
    return followed(
        fed(), {**values, "omega": doubling.value}, names, doubling, (1.6, -0.1), (2.5, 0.3), steps=WIDE
    )


def test_without_damping_a_tongue_ends_in_two_double_multipliers():
    """Closed form: Mathieu's equation with a = 4/ω² on the edges of its first tongue, q = 2ε/ω²."""
    found = sorted(each.values for each in tongue().of_kind(CodimTwoKind.ONE_TWO))

    def edge(characteristic):
        return brentq(lambda w: 4.0 / w**2 - characteristic(1, 0.6 / w**2), 1.6, 2.5, xtol=1e-15)

    edges = sorted(edge(each) for each in (mathieu_a, mathieu_b))
    assert [each[0] for each in found] == pytest.approx(edges, abs=1e-12)
    assert [each[1] for each in found] == pytest.approx([0.0, 0.0], abs=1e-13)
    for each in tongue().of_kind(CodimTwoKind.ONE_TWO):
        assert each.solved
        assert max(each.errors) < 1e-12
        assert each.point.multipliers.sum() == pytest.approx(-2.0, abs=1e-12)


@cache
def torus() -> Curve:
    """Where an oscillator is fed as much as its contact takes."""
    values = {"omega": 1.0, "force": 0.05, "free": 0.01}
    branch = continue_orbit(fed(), values, "free", orbit(fed(), **values), -0.3, 0.2, WIDE)
    start = lowest(branch, SpecialKind.TORUS)
    values = {**values, "free": start.value}
    return followed(fed(), values, ("omega", "free"), start, (0.3, -0.3), (1.6, 0.2), steps=WIDE)


def test_pairs_that_turn_by_parts_of_a_circle():
    """Closed forms in permanent contact: nothing is damped where one takes what the other feeds; the pair
    turns by 2π/ω there, and the amplitude force/|1 − ω²| is the load where the orbit touches."""
    by_kind = {
        CodimTwoKind.ONE_FOUR: (4.0 / 3.0, -0.1),
        CodimTwoKind.ONE_THREE: (1.5, -0.1),
        CodimTwoKind.GRAZING_TORUS: (np.sqrt(1.5), -0.1),
    }
    for kind, values in by_kind.items():
        last = max(torus().of_kind(kind), key=lambda each: each.values[0])
        assert last.values == pytest.approx(values, abs=1e-12)
        assert last.solved
        assert max(last.errors) < 1e-12


@pytest.mark.parametrize(
    ("kind", "trace"),
    [(CodimTwoKind.ONE_ONE, 2.0), (CodimTwoKind.ONE_FOUR, 0.0), (CodimTwoKind.ONE_TWO, -2.0)],
)
def test_resonances_of_orbits_with_impacts(kind, trace):
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    curve = doubled_ring() if kind is CodimTwoKind.ONE_TWO else torus()
    for found in curve.of_kind(kind):
        matrix = monodromy(fed(), curve, found)
        assert np.trace(matrix) == pytest.approx(trace, abs=1e-9)
        assert np.linalg.det(matrix) == pytest.approx(1.0, abs=1e-9)
        assert found.solved


def test_the_curve_ends_where_the_pair_becomes_real():
    assert torus().ends[0].kind is CurveEndKind.RESONANCE
    assert torus().ends[0].values == only(torus(), CodimTwoKind.ONE_ONE).values


@cache
def doubled_ring() -> Curve:
    """A closed curve of doublings of an orbit with impacts on both sides."""
    values = {"omega": 1.45, "force": 0.05, "free": 0.01}
    branch = continue_orbit(fed(), values, "omega", orbit(fed(), **values), 0.33, 1.6, WIDE)
    doubling = lowest(branch, SpecialKind.DOUBLING)
    values = {**values, "omega": doubling.value}
    return followed(fed(), values, ("omega", "free"), doubling, (0.3, -0.3), (1.6, 0.2), steps=WIDE)


@cache
def fold_of_fed() -> Curve:
    values = {"omega": 0.68, "force": 0.05}
    branch = continue_orbit(fed(), values, "omega", orbit(fed(), **values), 0.6, 0.8, WIDE)
    fold = lowest(branch, SpecialKind.FOLD)
    lower: Pair = (0.3, -0.2)
    return followed(fed(), {**values, "omega": fold.value}, ("omega", "free"), fold, lower, (1.6, 0.2))


@pytest.mark.parametrize("source", [torus, fold_of_fed])
def test_a_torus_curve_begun_at_a_double_multiplier_goes_the_way_on_which_the_pair_is_complex(source):
    """On the other way the two multipliers are real, and their product is 1: these are no such orbits."""
    (start,) = source().of_kind(CodimTwoKind.ONE_ONE)
    values = {**source().values, **dict(zip(source().names, start.values, strict=True))}
    upper = (min(1.0, 1.3 * start.values[0]), 0.1)
    curve = followed(fed(), values, source().names, start, (0.3, -0.2), upper, SpecialKind.TORUS)
    first, last = curve.ends
    assert (first.kind, first.values) == (CurveEndKind.RESONANCE, pytest.approx(start.values, abs=1e-9))
    assert last.values != pytest.approx(start.values, abs=1e-3)
    assert len(curve.points) > 5
    assert all((np.abs(p.multipliers.imag) > 0.0).all() for p in curve.points[1:])


def test_the_same_double_multiplier_on_the_fold_curve():
    """A fold curve and a Neimark-Sacker curve meet where 1 is double."""
    one = only(fold_of_fed(), CodimTwoKind.ONE_ONE)
    assert one.point.multipliers.sum() == pytest.approx(2.0, abs=1e-9)
    assert np.prod(one.point.multipliers).real == pytest.approx(1.0, abs=1e-9)
    assert one.solved
    assert max(one.errors) < 1e-12


def test_a_fold_and_a_doubling_at_once():
    """Of two oscillators that do not feel each other one folds, at the same value for every stiffness of the
    other; and that doubles, in 80 bits."""
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    branch = continue_orbit(
        side_by_side(), {"omega": 0.68}, "omega", orbit(side_by_side(), omega=0.68), 0.65, 0.8, WIDE
    )
    fold = lowest(branch, SpecialKind.FOLD)
    names: tuple[str, str] = ("omega", "stiffness")
    limits = (0.7, 0.1), (1.0, 0.2)
    curve = followed(side_by_side(), {"omega": fold.value}, names, fold, *limits, steps=WIDE)
    found = curve.of_kind(CodimTwoKind.FOLD_FLIP)
    assert len(found) == 2
    for each in found:
        assert each.values[0] == pytest.approx(fold.value, abs=1e-12)
        matrix = monodromy(side_by_side(), curve, each)
        assert np.linalg.svd(matrix[:2, :2] - np.eye(2))[1][-1] < 1e-11
        assert np.linalg.svd(matrix[2:, 2:] + np.eye(2))[1][-1] < 1e-11
        assert max(each.errors) < 1e-11


def test_two_folds_meet_in_a_cusp():
    """Beside it, in one parameter, two folds on one side and none on the other; as far from each other as the
    power 3/2 of the distance."""
    start = lowest(
        continue_orbit(
            fed(),
            {"omega": 0.68, "force": 0.05},
            "omega",
            orbit(fed(), omega=0.68, force=0.05),
            0.6,
            0.8,
            WIDE,
        ),
        SpecialKind.FOLD,
    )
    values, names = {"omega": start.value, "force": 0.05}, ("omega", "force")
    curve = followed(fed(), values, names, start, (0.74, 0.005), (1.1, 0.06), steps=WIDE)
    cusp = only(curve, CodimTwoKind.CUSP)
    assert max(cusp.errors) < 1e-12
    folds = {}
    for part in (0.99, 1.002, 1.008):
        force = part * cusp.values[1]
        first = orbit(fed(), omega=1.1, force=force)
        values = {"omega": 1.1, "force": force}
        branch = continue_orbit(fed(), values, "omega", first, 0.9, 1.15, WIDE)
        folds[part] = sorted(each.value for each in branch.of_kind(SpecialKind.FOLD))
    assert [len(each) for each in folds.values()] == [0, 2, 2]
    widths = [np.ptp(folds[part]) for part in (1.002, 1.008)]
    assert np.log(widths[1] / widths[0]) / np.log(4.0) == pytest.approx(1.5, abs=0.05)


def test_the_doubled_orbit_changes_sides():
    """At the generalised doubling of the article's 6-6-1."""
    found = only(article(), CodimTwoKind.GENERALISED_DOUBLING)
    assert max(found.errors) < 1e-7
    sides = []
    for damping in (0.0415, 0.0455):
        near = min(article().points, key=lambda point: abs(point.values[1] - damping))
        values = {"omega": 0.78, "D": near.values[0], "bearing_damping": near.values[1]}
        start = orbit_at(built(bundled(), **values), near.state, 6)
        assert start is not None
        beyond = {**values, "D": values["D"] + 0.001}
        start = orbit_at(built(bundled(), **beyond), near.state, 6)
        assert start is not None
        branch = continue_orbit(bundled(), beyond, "D", start, near.values[0] - 1e-3, 0.36, WIDE)
        doubling = min(
            branch.of_kind(SpecialKind.DOUBLING), key=lambda each: abs(each.value - near.values[0])
        )
        (beside,) = switched(bundled(), branch, doubling)
        sides.append(beside.value - doubling.value)
    assert sides[0] * sides[1] < 0.0


def test_orbits_of_a_torus_curve_by_an_evaluation_that_shares_no_code():
    """In 80 bits: the orbit closes, and the product of its two multipliers is 1."""
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    from oracles import region_oracle

    clear = [p for p in torus().points if min(abs(e.distance) for e in p.extrema) > 1e-6]
    for point in clear[::8]:
        values = {**torus().values, **dict(zip(torus().names, point.values, strict=True))}
        walk = region_oracle.run(fed().system(values), point.state, point.period, variational=True)
        assert np.abs(walk.state - point.state).max() < 1e-10
        assert walk.jacobian is not None
        assert abs(np.linalg.det(np.asarray(walk.jacobian, dtype=np.float64)) - 1.0) < 1e-10


def test_the_same_closed_curve_from_another_of_its_orbits_where_neither_way_has_points_enough_to_come_back():
    ring = doubled_ring()
    start, steps = ring.points[len(ring.points) // 2], replace(WIDE, most_points=2 * len(ring.points) // 3)
    values = {**ring.values, **dict(zip(ring.names, start.values, strict=True))}
    again = followed(fed(), values, ring.names, start, ring.lower, ring.upper, ring.kind, steps=steps)
    assert {end.kind for end in again.ends} == {CurveEndKind.CLOSED}
    one, two = (sorted(each.values for each in curve.special) for curve in (ring, again))
    assert np.abs(np.subtract(one, two)).max() < 1e-10


def test_a_function_that_is_not_smooth_between_two_orbits_has_no_zero_there(monkeypatch):
    def node(at: float) -> Any:
        return SimpleNamespace(u=np.array([at]), problem=None)

    def function(here: Any) -> float:
        return float("nan") if 0.2 < here.u[0] < 0.8 else float(here.u[0]) - 0.5

    monkeypatch.setattr(locate, "solved", lambda problem, guess, row, target, before: (node(target), None))
    assert locate.zero_between(node(0.0), node(1.0), function) is None
