"""Grazing values: exact invariances, other base periods, what is no result."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np
import pytest

from gearlash import flow
from gearlash.branches import GrazingPoint, locate_grazing, locate_multiplier
from gearlash.branches.grazing_point import distance_to_unit
from gearlash.orbits import Orbit, Shot, attractor, grazing_checks, shoot
from gearlash.system import Family, Signature, Status, System, UnknownNameError
from oracles import closed_forms
from orbits.members import article, built, count_by_marching, one_dof, orbit


def touching(family: Family, name: str, place: dict[str, float], boundary: int = 1) -> GrazingPoint:
    start = orbit(family, **place)
    check = next(c for c in grazing_checks(start) if c.boundary == boundary)
    return locate_grazing(family, name, start, check, values=family.complete(place))


@pytest.mark.parametrize("factor", [0.1, 0.7, 3.0, 20.0])
def test_grazing_load_is_proportional_to_the_error(factor):
    """In permanent contact the response is linear: load and error amplitude scale together, exactly."""
    family = article()
    error = family.defaults["error"]
    unit = touching(family, "load", {"omega": 0.98})
    scaled = touching(family, "load", {"omega": 0.98, "error": factor * error, "load": factor * 0.09})
    assert unit.status is scaled.status is Status.OK
    assert scaled.value == pytest.approx(factor * unit.value, rel=1e-12)
    assert np.abs(scaled.multipliers - unit.multipliers).max() < 1e-10


@pytest.mark.parametrize("factor", [0.2, 5.0])
def test_scaling(factor):
    """(f_m, E, D) → s (f_m, E, D): grazing frequencies stay, grazing gaps scale."""
    family = article()
    error = family.defaults["error"]
    scaled = {"load": factor * 0.09, "error": factor * error}
    one = touching(family, "omega", {"omega": 0.98})
    other = touching(family, "omega", {"omega": 0.98, "D": factor, **scaled})
    assert other.value == pytest.approx(one.value, rel=1e-12)
    gap = touching(family, "D", {"omega": 0.78, "D": 0.389}, boundary=-1)
    wide = touching(family, "D", {"omega": 0.78, "D": 0.389 * factor, **scaled}, boundary=-1)
    assert wide.value == pytest.approx(factor * gap.value, rel=1e-12)
    assert (gap.label_below, gap.label_above) == (wide.label_below, wide.label_above) == ("6-6-1", "6-6-2")


@pytest.mark.parametrize("back_gap", [1.0, 0.6, 1.7])
def test_gap_of_the_back_side_in_closed_form(back_gap):
    """An orbit that meets Σ1 only keeps X − D = m at its least: it touches Σ2 at D = −m/(1 + r)."""
    family, place = article(), {"omega": 0.78, "D": 0.5}
    free = orbit(family, **place)
    assert free.label == "6-6-0"
    least = float(free.extrema.displacement.min()) - 0.5
    exact = -least / (1.0 + back_gap)
    near = {"omega": 0.78, "D": 1.02 * exact, "back_gap": back_gap}
    shot = shoot(built(family, **near), free.state + (1.02 * exact - 0.5) * np.eye(10)[8], 6)
    start = Orbit(built(family, **near), shot, 0, shot.status, "")
    assert start.label == "6-6-0"
    check = next(c for c in grazing_checks(start) if c.boundary == -1)
    point = locate_grazing(family, "D", start, check, values=family.complete(near))
    assert point.status is Status.OK
    assert point.value == pytest.approx(exact, rel=1e-12)
    assert (point.label_below, point.label_above) == ("6-6-1", "6-6-0")
    assert "engagement on the back side" in point.kind
    assert point.boundary == -1


@pytest.mark.parametrize("name", ["mesh_damping", "rotation_factor", "bearing_damping", "ripple"])
def test_value_by_bisection_of_the_distance(name):
    """Another way: the clear orbit followed by Newton, its least X − D bisected up to the touch."""
    family = article()
    place = {"omega": 0.98 if name != "mesh_damping" else 0.965}
    point = touching(family, name, place)
    assert point.status is Status.OK
    clear = 1 if point.label_above == "1-0-0" else -1

    def least(relative: float) -> float:
        values = {**place, name: point.value * (1 + clear * relative)}
        shot = shoot(built(family, **values), point.state_zero, 1)
        found = Orbit(built(family, **values), shot, 0, shot.status, "")
        assert found.label == "1-0-0"
        return float(found.extrema.displacement.min()) - 1.0

    near, far = least(1e-6), least(2e-6)
    assert near > 0.0
    assert abs(2 * near - far) < 1e-9 * (far / 1e-6)  # the line through both ends at the touch


def test_labels_one_contact_apart_and_a0_at_the_point():
    """The four conditions at the point: X = D, X′ = 0, a0 by second difference of the touching orbit."""
    family = article()
    point = touching(family, "omega", {"omega": 0.98})
    props = built(family, **point.values)
    touch = Orbit(props, Shot(point.state_zero, 1, 0.0, np.eye(10), 0.0, 0, Status.OK), 0, Status.OK, "")
    assert abs(point.state[8] - 1.0) < 1e-13
    assert abs(point.state[9]) < 1e-13
    step = 1e-4
    low, middle, high = touch.trace.at([point.phase - step, point.phase, point.phase + step]).displacement
    assert (low - 2 * middle + high) / (step * props.system.period) ** 2 == pytest.approx(point.a0, rel=1e-5)
    assert point.a0 > 1e-2


def test_numbers_of_a_point_are_plain():
    """What is compared with them is then a plain truth value, which JSON has a form for."""
    family = article()
    doubling = locate_multiplier(
        family, "omega", orbit(family, omega=0.79), -1, values=family.complete({"omega": 0.79})
    )
    for point in (touching(family, "omega", {"omega": 0.98}), doubling):
        assert not [f.name for f in fields(point) if isinstance(getattr(point, f.name), np.generic)]


@pytest.mark.parametrize(
    ("place", "name", "boundary"),
    [
        ({"omega": 0.98}, "omega", 1),
        ({"omega": 0.78, "D": 0.389}, "D", -1),
        ({"omega": 0.78, "D": 0.38}, "D", -1),
        ({"omega": 0.78, "D": 0.399}, "D", -1),
    ],
    ids=str,
)
def test_phase_is_told_from_the_state_at_phase_zero(place, name, boundary):
    """Also in an orbit of twelve cycles: carried over ``phase``, ``state_zero`` is the touching state."""
    family = article()
    point = touching(family, name, place, boundary)
    assert point.status is Status.OK
    assert 0.0 <= point.phase < point.period
    there = flow.carry(built(family, **point.values), point.state_zero, point.phase).state
    assert np.abs(there - point.state).max() < 1e-11
    edge = boundary * point.values.get("D", 1.0)
    assert abs(there[8] - edge) < 1e-12


def test_error_estimate_covers():
    """The stated error is no smaller than the true one, and far below 1e-10."""
    family = one_dof()
    for omega in (0.3, 0.7, 1.3):
        exact = closed_forms.spur_grazing_load(omega, 0.1, 0.1)
        point = touching(family, "load", {"omega": omega, "load": 1.05 * exact})
        assert abs(point.value - exact) <= point.error <= 1e-12 * exact


def half_frequency(amplitude: float) -> Family:
    """A base period of two mesh cycles: a force of half the mesh frequency besides."""
    plain = one_dof()

    def build(values) -> System:
        system = plain.build(values)
        forcing = np.zeros((2, 5))
        forcing[1, :2] = system.forcing[1, 0], amplitude
        forcing[:, 3:] = system.forcing[:, 1:]
        return replace(system, forcing=forcing, cycles=2)

    return replace(plain, build=build)


def test_longer_base_period_in_closed_form():
    """Two unequal minima in two mesh cycles: the lower one touches first, one contact in P = 2."""
    omega, amplitude = 1.3, 0.004
    theta = np.linspace(0.0, 4 * np.pi, 2_000_001)
    x = np.zeros_like(theta)
    for w, force in ((omega, omega**2 * 0.1), (omega / 2, amplitude)):
        x += np.real(force * np.exp(1j * w / omega * theta) / (1 - w**2 + 1j * 0.1 * w))
    exact = -x.min()
    family, values = half_frequency(amplitude), {"omega": omega, "load": 1.02 * exact}
    clear = attractor(built(family, **values), family.start(values))
    assert isinstance(clear, Orbit)
    assert clear.label == "2-0-0"
    point = locate_grazing(family, "load", clear, grazing_checks(clear)[0], values=family.complete(values))
    assert point.status is Status.OK
    assert point.value == pytest.approx(exact, rel=1e-10)
    assert (point.label_below, point.label_above) == ("2-1-0", "2-0-0")
    assert point.period == 2
    assert point.phase == pytest.approx(theta[np.argmin(x)] / (2 * np.pi), abs=1e-5)


@pytest.mark.parametrize("omega", [0.98, 0.965])
def test_what_does_not_depend_on_the_parameter_is_no_result(omega):
    """An orbit that meets Σ1 only keeps X − D: no gap makes it graze Σ1."""
    point = touching(article(), "D", {"omega": omega})
    assert point.status is not Status.OK


def test_every_extremum_of_an_orbit_gives_a_result_or_says_that_it_is_none():
    """Also those far from any boundary: whatever is called ok touches, and changes one count by one."""
    family, place = article(), {"omega": 0.78, "D": 0.389}
    start, good = orbit(family, **place), 0
    for check in grazing_checks(start)[:16]:
        point = locate_grazing(family, "D", start, check, values=family.complete(place))
        if point.status is not Status.OK:
            continue
        good += 1
        assert point.residual <= 1e-11
        edge = point.value if check.boundary > 0 else -point.value
        assert abs(point.state[8] - edge) <= 1e-11
        assert abs(point.state[9]) <= 1e-11
        below, above = point.label_below, point.label_above
        assert isinstance(below, Signature)
        assert isinstance(above, Signature)
        assert below.period == above.period
        assert np.abs(np.array(below.counts) - np.array(above.counts)).sum() == 1
    assert good >= 2


@pytest.mark.parametrize("seed", range(4))
def test_random_pairs(seed):
    """Whatever is called ok: brute marching beside it counts the contacts that its labels say."""
    rng = np.random.default_rng([20, seed])
    family, verified = one_dof(ripple=0.1, back_stiffness=2.0, back_gap=0.5), 0
    for _ in range(5):
        place = {"omega": rng.uniform(0.4, 1.6), "D": 10 ** rng.uniform(-1.3, 0.2)}
        place |= {"error": rng.uniform(0.05, 0.4), "mesh_damping": rng.uniform(0.03, 0.1)}
        start = attractor(built(family, **place), family.start(place))
        if not isinstance(start, Orbit) or start.period > 12:
            continue
        for name, boundary in (("load", 1), ("omega", 1), ("D", -1)):
            check = next(c for c in grazing_checks(start) if c.boundary == boundary)
            point = locate_grazing(family, name, start, check, values=family.complete(place))
            if point.status is Status.OK and abs(point.multipliers[0]) < 0.9:
                counted_as_labelled(family, point)
                verified += 1
    assert verified >= 2


def counted_as_labelled(family: Family, point: GrazingPoint) -> None:
    assert point.error <= 1e-10 * abs(point.value)
    for side, label in ((-1, point.label_below), (1, point.label_above)):
        props = built(family, **{**point.values, point.name: point.value + side * 1e-5 * abs(point.value)})
        settled = flow.march(props, point.state_zero, 300 * point.period).states[-1]
        drive, back = count_by_marching(props, settled, point.period)
        assert label == f"{point.period}-{drive}-{back}", f"{point.name} = {point.value}"


def test_unknown_names_are_named():
    start = orbit(article(), omega=0.98)
    values, check = article().complete({"omega": 0.98}), grazing_checks(start)[0]
    with pytest.raises(UnknownNameError, match="omega"):
        locate_grazing(article(), "omgea", start, check, values=values)
    with pytest.raises(UnknownNameError, match="omega"):
        locate_multiplier(article(), "omgea", start, -1, values=values)


@pytest.mark.parametrize(
    ("multipliers", "doubling", "fold"),
    [
        ([0.5, 0.1], 1.1, 0.5),
        ([-0.9995, 0.1], 0.0005, 0.9),
        ([0.9995, 0.1], 1.1, 0.0005),
        ([0.6 + 0.8j, 0.6 - 0.8j], np.sqrt(3.2), np.sqrt(0.8)),
    ],
)
def test_distance_of_multipliers_from_those_of_doublings_and_folds(multipliers, doubling, fold):
    assert distance_to_unit(np.array(multipliers, dtype=complex)) == pytest.approx((doubling, fold))
