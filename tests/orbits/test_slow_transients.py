"""Just beside a bifurcation everything is slow: what is found is right, or is called unresolved."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.optimize import brentq

from gearlash.branches import BifurcationPoint, locate_grazing, locate_multiplier
from gearlash.orbits import Attractor, Orbit, Signature, attractor, grazing_checks, shoot
from gearlash.system import Status
from orbits.members import article, built, displaced, one_dof, orbit

# Where the short orbit of a doubling stands, the parameter, and the side (in it) of the short orbit.
DOUBLINGS = {
    "1-1-0": (article, {"omega": 1.3, "D": 1.0}, "omega", 1),
    "3-3-0": (article, {"omega": 0.79, "D": 1.0}, "omega", 1),
    "6-6-1": (article, {"omega": 0.78, "D": 0.386}, "D", 1),
    "spur 1-1-0": (one_dof, {"omega": 1.22, "D": 1.0, "error": 0.11}, "omega", 0),
}


@cache
def doubling(which: str) -> BifurcationPoint:
    family, place, name, _ = DOUBLINGS[which]
    short = orbit(family(), **place)
    return locate_multiplier(family(), name, short, -1, values=family().complete(place))


def honest(found: Attractor, right: Signature) -> bool:
    """Right, or openly undecided."""
    if found.label == str(right):
        return found.status is Status.OK
    return found.label == "unresolved" and found.status is Status.UNRESOLVED and len(found.message) > 40


@pytest.mark.parametrize("relative", [1e-4, 1e-6])
@pytest.mark.parametrize("side", [-1, 1])
@pytest.mark.parametrize("which", ["1-1-0", "3-3-0", "6-6-1"])
def test_beside_a_doubling(which, side, relative):
    """Before it P, after it 2P, from the cold start, from a displaced one, and from the critical orbit."""
    family, _, name, short_side = DOUBLINGS[which]
    point = doubling(which)
    short = point.label
    assert isinstance(short, Signature)
    double = Signature(2 * short.period, 2 * short.drive, 2 * short.back)
    right = short if side == short_side else double
    values = {**point.values, name: point.value * (1 + side * relative)}
    props = built(family(), **values)
    displaced = point.state + 0.01 * np.random.default_rng(3).normal(size=10)
    for start in (family().start(values), displaced):
        found = attractor(props, start)
        assert found.label == str(right), found.message
        assert found.status is Status.OK
        assert isinstance(found, Orbit)
        assert found.stable
        assert found.residual <= 1e-11
    # Beside the short orbit, unstable on one side: at 1e-6 the motion needs 1e5 periods to leave it.
    found = attractor(props, point.state + 1e-5)
    assert found.label == str(right) if relative > 1e-5 else honest(found, right), found.message


@pytest.mark.parametrize("side", [-1, 1])
@pytest.mark.parametrize("which", ["1-1-0", "6-6-1"])
def test_extremely_close_to_a_doubling(which, side):
    """At 1e-10 a motion may stay undecided, but must say so."""
    family, _, name, short_side = DOUBLINGS[which]
    point = doubling(which)
    short = point.label
    assert isinstance(short, Signature)
    double = Signature(2 * short.period, 2 * short.drive, 2 * short.back)
    values = {**point.values, name: point.value * (1 + side * 1e-10)}
    for start in (family().start(values), point.state + 1e-3):
        assert honest(attractor(built(family(), **values), start), short if side == short_side else double)


@cache
def fold() -> BifurcationPoint:
    """Where 2-1-0 of the article's pair is born, ω ≈ 1.0922; below it only 1-0-0 is left."""
    born = orbit(article(), omega=1.1)
    return locate_multiplier(article(), "omega", born, 1, values=article().complete({"omega": 1.1}))


@pytest.mark.parametrize("relative", [1e-3, 1e-5, 1e-7])
def test_beside_a_fold(relative):
    point = fold()
    assert point.label == "2-1-0"
    for side, right in ((1, "2-1-0"), (-1, "1-0-0")):
        props = built(article(), omega=point.value * (1 + side * relative))
        found = attractor(props, point.state)
        assert found.label == right, found.message
        assert found.status is Status.OK


def test_the_ghost_of_a_fold_is_no_orbit():
    """1e-10 below it the motion lingers for 1e5 periods."""
    point = fold()
    found = attractor(built(article(), omega=point.value * (1 - 1e-10)), point.state)
    assert honest(found, Signature(1, 0, 0))


@cache
def torus() -> tuple[float, np.ndarray]:
    """Where a complex pair of multipliers of 1-1-0 leaves the unit circle; and the orbit there."""
    start = orbit(article(), omega=0.742)

    def at(omega: float):
        shot = shoot(built(article(), omega=omega), start.state, 1)
        return shot.state, float(np.abs(np.linalg.eigvals(shot.monodromy)).max()) - 1.0

    value, _ = brentq(lambda omega: at(omega)[1], 0.742, 0.744, xtol=1e-14, full_output=True)
    return value, at(value)[0]


@pytest.mark.parametrize("relative", [1e-3, 1e-4, 1e-6])
def test_before_a_torus_is_born(relative):
    """A spiral that shrinks by 1e-6 a period is not quasi-periodic."""
    value, state = torus()
    for start in (article().start({}), state + 1e-2, state + 1e-4):
        found = attractor(built(article(), omega=value * (1 - relative)), start)
        assert found.label == "1-1-0", found.message
        assert found.status is Status.OK


@pytest.mark.parametrize("relative", [1e-3, 1e-5])
def test_after_a_torus_is_born(relative):
    """Never the orbit that has become unstable."""
    value, state = torus()
    for start in (article().start({}), state + 1e-3):
        found = attractor(built(article(), omega=value * (1 + relative)), start)
        assert found.label in ("aperiodic", "unresolved"), found.message


GRAZINGS = {
    "window, lower end": ({"omega": 0.98}, "omega", "1-1-0", "1-0-0"),
    "window, upper end": ({"omega": 1.09}, "omega", "1-0-0", "1-1-0"),
    "back side": ({"omega": 0.78, "D": 0.389}, "D", "6-6-1", "6-6-2"),
}


@pytest.mark.parametrize("relative", [1e-4, 1e-6, 1e-8])
@pytest.mark.parametrize("which", GRAZINGS)
def test_beside_a_grazing(which, relative):
    """Labels of both sides, from beside the orbit at the grazing: the map is C¹, nothing is slow."""
    place, name, below, above = GRAZINGS[which]
    start = orbit(article(), **place)
    boundary = 1 if "window" in which else -1
    check = next(c for c in grazing_checks(start) if c.boundary == boundary)
    point = locate_grazing(article(), name, start, check, values=article().complete(place))
    assert point.status is Status.OK
    for side, right in ((-1, below), (1, above)):
        values = {**point.values, name: point.value * (1 + side * relative)}
        found = attractor(built(article(), **values), point.state_zero + 1e-4)
        assert found.label == right, found.message
        assert isinstance(found, Orbit)
        assert found.residual <= 1e-11


def test_cold_start_just_beside_the_lower_grazing():
    place, _, below, above = GRAZINGS["window, lower end"]
    start = orbit(article(), **place)
    point = locate_grazing(
        article(), "omega", start, grazing_checks(start)[0], values=article().complete(place)
    )
    for side, right in ((-1, below), (1, above)):
        values = {"omega": point.value * (1 + side * 1e-8)}
        for begin in (article().start({}), displaced(article(), 4)):
            assert attractor(built(article(), **values), begin).label == right


def test_at_the_grazing_itself():
    """On the point, touching lies within rounding: either label, never another one, and never aperiodic."""
    place, _, below, above = GRAZINGS["window, lower end"]
    start = orbit(article(), **place)
    point = locate_grazing(
        article(), "omega", start, grazing_checks(start)[0], values=article().complete(place)
    )
    found = attractor(built(article(), omega=point.value), article().start({}))
    assert found.label in (below, above)
    assert found.status in (Status.OK, Status.UNCERTAIN)
