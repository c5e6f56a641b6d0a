"""Where a multiplier of an orbit is −1 or +1."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.optimize import brentq

from gearlash.branches import BifurcationPoint, locate_multiplier
from gearlash.orbits import Orbit, attractor, shoot
from gearlash.system import Status
from oracles import closed_forms
from orbits.members import article, built, one_dof, orbit

DOUBLINGS = {
    "1-1-0": ({"omega": 1.3}, "omega", 1),
    "3-3-0": ({"omega": 0.79}, "omega", 1),
    "6-6-1": ({"omega": 0.78, "D": 0.386}, "D", 1),
    "6-6-2": ({"omega": 0.78, "D": 0.392}, "D", -1),
}


@cache
def doubling(label: str) -> BifurcationPoint:
    place, name, _ = DOUBLINGS[label]
    return locate_multiplier(article(), name, orbit(article(), **place), -1, values=article().complete(place))


@pytest.mark.parametrize("label", DOUBLINGS)
def test_multiplier_is_minus_one(label):
    point = doubling(label)
    assert point.status is Status.OK
    assert point.label == label
    assert np.abs(point.multipliers + 1.0).min() <= 1e-8
    assert (np.abs(point.multipliers) <= 1.0 + 1e-8).all()
    assert point.residual <= 1e-11
    assert point.error <= 1e-10 * abs(point.value)
    assert point.kind == "doubling"


@pytest.mark.parametrize("label", DOUBLINGS)
def test_labels_of_both_sides(label):
    """The short orbit is stable on its side; on the other it is not, and the doubled one is."""
    place, name, side = DOUBLINGS[label]
    point = doubling(label)
    period, drive, back = map(int, label.split("-"))
    for relative, right in ((side, label), (-side, f"{2 * period}-{2 * drive}-{2 * back}")):
        values = {**place, name: point.value * (1 + 3e-4 * relative)}
        props = built(article(), **values)
        found = attractor(props, point.state + 1e-3)
        assert found.label == right
        assert isinstance(found, Orbit)
        assert found.stable
        short = shoot(props, point.state, period)
        assert (np.abs(np.linalg.eigvals(short.monodromy)).max() < 1.0) == (right == label)


@pytest.mark.parametrize("label", DOUBLINGS)
def test_value_by_bisection(label):
    """Another way: the orbit followed by Newton, its multiplier nearest to −1 bisected."""
    place, name, side = DOUBLINGS[label]
    point, (period, *_) = doubling(label), map(int, label.split("-"))

    def critical(value: float) -> float:
        shot = shoot(built(article(), **{**place, name: value}), point.state, period)
        assert shot.residual <= 1e-11
        values = np.linalg.eigvals(shot.monodromy)
        return float(values[np.argmin(np.abs(values + 1.0))].real) + 1.0

    ends = sorted(point.value * (1 + r * side) for r in (-2e-4, 2e-4))
    assert brentq(critical, *ends, xtol=1e-13) == pytest.approx(point.value, rel=1e-9)


def test_doubling_solved_from_afar_is_the_same():
    label = "1-1-0"
    far = orbit(article(), omega=1.34)
    point = locate_multiplier(article(), "omega", far, -1, values=article().complete({"omega": 1.34}))
    assert point.value == pytest.approx(doubling(label).value, rel=1e-10)


def test_parametric_resonance_against_hill():
    """Permanent contact of one degree of freedom at ω ≈ 2: a linear, Mathieu-like equation doubles."""
    family = one_dof(ripple=0.2)
    values = {"omega": 2.03, "ripple": 0.2, "load": 50.0, "error": 0.01, "mesh_damping": 0.05}

    def critical(ripple: float) -> float:
        system = family.system({**values, "ripple": ripple})
        multipliers = closed_forms.floquet_multipliers(system, order=16)
        return float(multipliers[np.argmin(np.abs(multipliers + 1.0))].real) + 1.0

    exact = float(brentq(critical, 0.21, 0.3, xtol=1e-14))  # pyright: ignore[reportArgumentType]
    start = orbit(family, **{**values, "ripple": 0.95 * exact})
    assert start.label == "1-0-0"
    point = locate_multiplier(
        family, "ripple", start, -1, values=family.complete({**values, "ripple": 0.95 * exact})
    )
    assert point.status is Status.OK
    assert point.value == pytest.approx(exact, rel=1e-9)


@cache
def fold() -> BifurcationPoint:
    start = orbit(article(), omega=1.1)
    return locate_multiplier(article(), "omega", start, 1, values=article().complete({"omega": 1.1}))


def test_fold():
    """2-1-0 of the article's pair is born at ω ≈ 1.0922: two orbits above, none below."""
    point = fold()
    assert point.status is Status.OK
    assert point.kind == "fold"
    assert point.label == "2-1-0"
    assert np.abs(point.multipliers - 1.0).min() <= 1e-6  # at a fold the orbit itself is good to √ε only
    vector = np.linalg.svd(shoot(built(article(), **point.values), point.state, 2).monodromy - np.eye(10))[2][
        -1
    ]
    above = built(article(), omega=point.value * (1 + 1e-6))
    pair = [shoot(above, point.state + sign * 3e-3 * vector, 2) for sign in (-1, 1)]
    assert all(shot.residual <= 1e-11 for shot in pair)
    assert np.abs(pair[0].state - pair[1].state).max() > 1e-4
    stable = [np.abs(np.linalg.eigvals(shot.monodromy)).max() < 1.0 for shot in pair]
    assert sorted(stable) == [False, True]
    below = built(article(), omega=point.value * (1 - 1e-6))
    for sign in (-1, 1):
        shot = shoot(below, point.state + sign * 3e-3 * vector, 2)
        assert shot.residual > 1e-11 or np.abs(shot.state - point.state).max() > 0.05


def test_fold_law():
    """Beside a fold the multiplier leaves 1 as the square root of the distance."""
    point, away = fold(), []
    for relative in (1e-6, 4e-6):
        found = attractor(built(article(), omega=point.value * (1 + relative)), point.state)
        assert isinstance(found, Orbit)
        away.append(1.0 - found.leading.real)
    assert away[1] / away[0] == pytest.approx(2.0, rel=0.02)


def test_doubling_law():
    """Beside a doubling the multiplier crosses −1 linearly, the doubled orbit's size grows as the root."""
    point = doubling("1-1-0")
    slopes, sizes = [], []
    for relative in (1e-4, 4e-4):
        short = shoot(built(article(), omega=point.value * (1 + relative)), point.state, 1)
        values = np.linalg.eigvals(short.monodromy)
        slopes.append((values[np.argmin(np.abs(values + 1.0))].real + 1.0) / relative)
        double = attractor(built(article(), omega=point.value * (1 - relative)), point.state + 1e-3)
        assert double.label == "2-2-0"
        sizes.append(np.abs(double.strobes[1] - double.strobes[0]).max())
    assert slopes[1] == pytest.approx(slopes[0], rel=0.02)
    assert sizes[1] / sizes[0] == pytest.approx(2.0, rel=0.05)


def test_plus_one_of_a_doubled_orbit_is_no_fold():
    """2-2-0 ends at the doubling of 1-1-0: its multiplier +1 there is not reported as a fold."""
    double = orbit(article(), omega=1.2935)
    assert double.label == "2-2-0"
    point = locate_multiplier(article(), "omega", double, 1, values=article().complete({"omega": 1.2935}))
    assert point.status is not Status.OK


def test_no_doubling_is_not_invented():
    """Permanent contact over D: multipliers do not depend on it, so none ever becomes −1."""
    start = orbit(article(), omega=1.047)
    point = locate_multiplier(article(), "D", start, -1, values=article().complete({"omega": 1.047}))
    assert point.status is Status.NOT_CONVERGED
