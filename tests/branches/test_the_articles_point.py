"""The orbit of six cycles that doubles where its second-lowest minimum lies on the back side, in every plane
of the article's values, and the three curves that leave it."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from branches.curved import article, followed, lowest, named, only
from branches.followed import bundled, six
from gearlash.branches.continuation import ContinuationSettings, SpecialKind
from gearlash.branches.curves import CodimTwoKind, Curve
from gearlash.results.curve_file import load_curve, save_curve

STEPS = ContinuationSettings(certify=False, longest=0.1)
FINE = ContinuationSettings(certify=False, longest=0.03)
PLANE: tuple[str, str] = ("D", "bearing_damping")
PLANES = {
    "error_phase": ((0.32, 0.5), (0.37, 0.75), (0.3299912810801, 0.5250470386465)),
    "omega": ((0.33, 0.775), (0.36, 0.8), (0.3372309544876, 0.7919290494845)),
    "ripple_2": ((0.31, 0.23), (0.37, 0.4), (0.3219688463498, 0.3664624429304)),
}


@cache
def in_plane(name: str) -> Curve:
    doubling = lowest(six(), SpecialKind.DOUBLING)
    lower, upper, _ = PLANES[name]
    values = {"omega": 0.78, "D": doubling.value}
    return followed(bundled(), values, ("D", name), doubling, lower, upper, steps=STEPS)


@cache
def leaving(which: str) -> Curve:
    """A curve from the point itself."""
    found = only(article(), CodimTwoKind.GRAZING_DOUBLING)
    values = named(("omega", *PLANE), (0.78, *found.values))
    limits = (0.343, 0.0465), (0.346, 0.049)
    if which == "doubled":
        return followed(bundled(), values, PLANE, found, *limits, steps=FINE, doubled=True)
    return followed(bundled(), values, PLANE, found, *limits, SpecialKind(which), steps=FINE)


@pytest.mark.parametrize("name", PLANES)
def test_the_same_point_in_every_plane(name):
    found = only(in_plane(name), CodimTwoKind.GRAZING_DOUBLING)
    assert found.values == pytest.approx(PLANES[name][2], abs=1e-12)
    assert {found.label_before, found.label_after} == {"6-6-1", "6-6-2"}


@pytest.mark.parametrize("name", PLANES)
def test_by_an_evaluation_that_shares_no_code(name):
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    from oracles import region_oracle
    from oracles.clearances import gap, gap_velocity

    found = only(in_plane(name), CodimTwoKind.GRAZING_DOUBLING)
    system = bundled().system({"omega": 0.78} | named(("D", name), found.values))
    (touch,) = found.point.touches
    state, matrix, phase = found.point.state, np.eye(system.size), 0.0
    for length, held in (
        (touch.phase - 0.02, None),
        (0.04, (0, -1, False)),
        (6.0 - touch.phase - 0.02, None),
    ):
        walk = region_oracle.run(system, state, length, phase, variational=True, held=held)
        assert walk.jacobian is not None
        state, matrix, phase = (
            walk.state,
            np.asarray(walk.jacobian, dtype=np.float64) @ matrix,
            phase + length,
        )
    assert np.abs(state - found.point.state).max() < 1e-12
    assert np.linalg.svd(matrix + np.eye(system.size))[1][-1] < 1e-11
    at = region_oracle.run(system, found.point.state, touch.phase).state
    assert abs(float(gap(system, system.clearances[0], at, touch.phase) + found.values[0])) < 1e-12
    assert abs(float(gap_velocity(system, system.clearances[0], at, touch.phase))) < 1e-12


def ways(curve: Curve, label: str) -> np.ndarray:
    """From the point to the orbits of a label."""
    found = only(article(), CodimTwoKind.GRAZING_DOUBLING)
    return np.array([np.subtract(p.values, found.values) for p in curve.points if p.signature == label])


def graze(way: np.ndarray) -> np.polynomial.Polynomial:
    """Of points of a curve through the point, over D, to high order."""
    return np.polynomial.Polynomial.fit(way[:, 0], way[:, 1], 6)


def order(size: np.ndarray, gaps: np.ndarray, within: tuple[float, float]) -> float:
    near = (size > within[0]) & (size < within[1])
    assert near.sum() >= 3
    return np.polyfit(np.log(size[near]), np.log(np.abs(gaps[near])), 1)[0]


def test_orders_of_contact_of_the_curves_that_leave_it():
    """The doubling crosses the grazing from the clear side and touches it, to second order, from the other;
    the grazing of the doubled orbit touches the doubling of the clear side, to second order."""
    touching = graze(ways(leaving("grazing"), "6-6-1"))
    assert abs(touching(0.0)) < 1e-9
    clear, beyond = (ways(leaving("doubling"), label) for label in ("6-6-1", "6-6-2"))
    angle = np.arctan(touching.deriv()(0.0)) - np.arctan2(clear[-3, 1], clear[-3, 0])
    assert abs(np.sin(angle)) > 0.3
    gaps = beyond[:, 1] - touching(beyond[:, 0])
    assert order(np.abs(beyond[:, 0]), gaps, (3e-4, 1.6e-3)) == pytest.approx(2.0, abs=0.1)
    doubling = np.polynomial.Polynomial.fit(clear[:, 0], clear[:, 1], 6)
    twelve = ways(leaving("doubled"), "12-12-2")
    gaps = twelve[:, 1] - doubling(twelve[:, 0])
    # The orbits begin at a third of the reach: a cubic, as more terms carry rounding from there to the point.
    fit = np.polynomial.Polynomial.fit(twelve[:, 0], gaps, 3).convert()
    reach = twelve[:, 0].max()
    assert max(abs(fit.coef[0]), abs(fit.coef[1]) * reach) < 0.1 * abs(fit.coef[2]) * reach**2


def test_all_three_curves_tell_the_point_they_leave():
    found = only(article(), CodimTwoKind.GRAZING_DOUBLING)
    for which in ("grazing", "doubling", "doubled"):
        again = only(leaving(which), CodimTwoKind.GRAZING_DOUBLING)
        assert again.values == pytest.approx(found.values, abs=1e-12)
        places = [point.arclength for point in leaving(which).points]
        assert places == sorted(places)
        inside = np.array([point.values for point in leaving(which).points])
        assert (inside >= np.array((0.343, 0.0465)) - 1e-12).all()
        assert (inside <= np.array((0.346, 0.049)) + 1e-12).all()


def test_the_point_comes_back_from_the_file_of_its_curve(tmp_path):
    """From the point in the file along every curve that leaves it, and from another orbit in the file."""
    found = only(article(), CodimTwoKind.GRAZING_DOUBLING)
    kept = load_curve(save_curve(article(), tmp_path / "curve.json", bundled()))
    again = only(kept, CodimTwoKind.GRAZING_DOUBLING)
    assert again.values == found.values
    limits = (0.343, 0.0465), (0.346, 0.049)
    for kind in (SpecialKind.DOUBLING, SpecialKind.GRAZING):
        curve = followed(
            bundled(), {**kept.values, **named(PLANE, again.values)}, PLANE, again, *limits, kind
        )
        assert only(curve, CodimTwoKind.GRAZING_DOUBLING).values == pytest.approx(found.values, abs=1e-9)
    near = [
        point for point in kept.points if 0.0465 < point.values[1] < 0.049 and 0.343 < point.values[0] < 0.346
    ]
    far = max(near, key=lambda point: abs(point.values[1] - found.values[1]))
    values = {**kept.values, **named(PLANE, far.values)}
    curve = followed(bundled(), values, PLANE, far, *limits, SpecialKind.DOUBLING)
    assert only(curve, CodimTwoKind.GRAZING_DOUBLING).values == pytest.approx(found.values, abs=1e-9)
