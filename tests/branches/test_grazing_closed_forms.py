"""Grazing values against closed forms (constant stiffness) and against harmonic balance (any stiffness)."""

from __future__ import annotations

import numpy as np
import pytest

from gearlash.branches import GrazingPoint, locate_grazing
from gearlash.orbits import Orbit, Shot, grazing_checks, shoot
from gearlash.system import Family, Status
from oracles import closed_forms
from orbits.members import article, built, one_dof, orbit

ERROR, DAMPING = 0.1, 0.1  # of the mild pair; DAMPING = ζ = 2 ξ_m


def touching(
    family: Family, name: str, start: Orbit, values: dict[str, float], boundary: int = 1
) -> GrazingPoint:
    """The grazing of the extremum nearest to a boundary."""
    check = next(c for c in grazing_checks(start) if c.boundary == boundary)
    return locate_grazing(family, name, start, check, values=family.complete(values))


def beside(family: Family, point: GrazingPoint, relative: float) -> tuple[Orbit, dict[str, float]]:
    """The orbit at a relative distance from a grazing, stable or not."""
    values = {**point.values, point.name: point.value * (1 + relative)}
    props = built(family, **values)
    shot = shoot(props, point.state_zero, point.period)
    assert shot.status is Status.OK
    return Orbit(props, shot, 0, shot.status, ""), values


@pytest.mark.parametrize("omega", [0.2, 0.4, 0.7, 0.95, 1.05, 1.3, 1.8])
def test_load_of_one_degree_of_freedom(omega):
    """X − D = f_m + A cos: it touches where the load is the amplitude."""
    family, exact = one_dof(), closed_forms.spur_grazing_load(omega, ERROR, DAMPING)
    values = {"omega": omega, "load": 1.05 * exact}
    point = touching(family, "load", orbit(family, **values), values)
    assert point.status is Status.OK
    assert point.value == pytest.approx(exact, rel=1e-12)
    assert point.error <= 1e-12 * exact
    assert (point.label_below, point.label_above) == ("1-1-0", "1-0-0")
    assert point.boundary == 1
    assert point.a0 == pytest.approx(omega**2 * exact, rel=1e-8)  # X″ of f_m + A cos at its minimum
    assert np.abs(point.multipliers) == pytest.approx(np.exp(-DAMPING / 2 * 2 * np.pi / omega), rel=1e-10)
    assert point.exponent == pytest.approx(-DAMPING / 2, rel=1e-10)
    assert "loss of contact on the drive side" in point.kind


@pytest.mark.parametrize("omega", [0.4, 1.3])
def test_error_of_one_degree_of_freedom(omega):
    family, per_unit = one_dof(), closed_forms.spur_grazing_load(omega, 1.0, DAMPING)
    exact = 0.1 / per_unit
    values = {"omega": omega, "error": 0.9 * exact}
    point = touching(family, "error", orbit(family, **values), values)
    assert point.status is Status.OK
    assert point.value == pytest.approx(exact, rel=1e-12)
    assert (point.label_below, point.label_above) == ("1-0-0", "1-1-0")


@pytest.mark.parametrize(
    ("load", "error", "starts"), [(0.1, 0.1, (0.6,)), (0.2, 0.1, (0.7, 1.6)), (0.2, 0.05, (0.8,))]
)
def test_frequencies_of_one_degree_of_freedom(load, error, starts):
    """Where the amplitude equals the load: roots of a quadratic in ω²."""
    family, exact = one_dof(), closed_forms.spur_grazing_omegas(load, error, DAMPING)
    for start, root in zip(starts, exact, strict=False):
        values = {"omega": start, "load": load, "error": error}
        point = touching(family, "omega", orbit(family, **values), values)
        assert point.status is Status.OK
        assert point.value == pytest.approx(root, rel=1e-12)


def test_damping_of_one_degree_of_freedom():
    """ω²E/√((1−ω²)² + ζ²ω²) = f_m solved for ζ."""
    family, omega, load = one_dof(), 1.1, 0.4
    exact = np.sqrt((omega**2 * ERROR / load) ** 2 - (1 - omega**2) ** 2) / omega / 2
    values = {"omega": omega, "load": load, "mesh_damping": 1.2 * exact}
    point = touching(family, "mesh_damping", orbit(family, **values), values)
    assert point.status is Status.OK
    assert point.value == pytest.approx(exact, rel=1e-12)


@pytest.mark.parametrize("phase", [0.0, 0.3, 1.0, 2.0, 3.14159, 4.5, 6.2])
def test_wherever_in_the_cycle_it_touches(phase):
    """The phase of the error moves the touch round the cycle, across phase zero too; the value stays."""
    family = one_dof()
    omega = 1.3
    exact = closed_forms.spur_grazing_load(omega, ERROR, DAMPING)
    values = {"omega": omega, "load": 1.02 * exact, "error_phase": phase}
    point = touching(family, "load", orbit(family, **values), values)
    assert point.status is Status.OK
    assert point.value == pytest.approx(exact, rel=1e-12)
    # X − D = f_m + A cos(θ + ψ − δ) with tan δ = ζω/(1 − ω²): least half a turn later
    lag = np.arctan2(DAMPING * omega, 1 - omega**2)
    touch = ((np.pi - phase + lag) / (2 * np.pi)) % 1.0
    away = abs(point.phase - touch)
    assert min(away, 1.0 - away) < 1e-9


def test_touch_at_the_seam():
    """The touch at phase zero exactly, where the orbit is cut."""
    family, omega = one_dof(), 1.3
    phase = np.pi + np.arctan2(DAMPING * omega, 1 - omega**2)
    exact = closed_forms.spur_grazing_load(omega, ERROR, DAMPING)
    for factor in (1.02, 0.98):
        values = {"omega": omega, "load": factor * exact, "error_phase": phase}
        point = touching(family, "load", orbit(family, **values), values)
        assert point.status is Status.OK
        assert point.value == pytest.approx(exact, rel=1e-12)
        assert min(point.phase, 1.0 - point.phase) < 1e-9


@pytest.mark.parametrize("omega", [0.4, 0.7, 1.3])
@pytest.mark.parametrize("distance", [1e-8, 1e-5, 1e-3])
def test_from_both_sides(omega, distance):
    """From the clear and from the impacting side the same value, to 1e-12."""
    family, exact = one_dof(), closed_forms.spur_grazing_load(omega, ERROR, DAMPING)
    values = {"omega": omega, "load": 1.05 * exact}
    first = touching(family, "load", orbit(family, **values), values)
    found = []
    for side in (-1, 1):
        start, there = beside(family, first, side * distance)
        assert start.label == ("1-1-0" if side < 0 else "1-0-0")
        found.append(touching(family, "load", start, there))
    assert all(point.status is Status.OK for point in found)
    assert abs(found[0].value - found[1].value) <= 1e-12 * exact
    assert abs(found[0].value - exact) <= 1e-12 * exact
    assert {(p.label_below, p.label_above) for p in found} == {("1-1-0", "1-0-0")}


# Parameter, place of the starting orbit, bracket for the harmonic balance.
BALANCE = {
    "omega, lower end": ("omega", {"omega": 0.98}, (0.96, 0.99)),
    "omega, upper end": ("omega", {"omega": 1.09}, (1.09, 1.13)),
    "load": ("load", {"omega": 0.98}, (0.07, 0.09)),
    "ripple": ("ripple", {"omega": 0.965, "load": 0.095}, (0.1, 0.45)),
    "error": ("error", {"omega": 0.98}, (0.27, 0.32)),
}


@pytest.mark.parametrize("which", BALANCE)
def test_article_case_against_harmonic_balance(which):
    """Hill's method for the linear time-periodic response, which knows nothing of events or marching."""
    name, place, bracket = BALANCE[which]
    family = article()
    exact = closed_forms.grazing_parameter(
        lambda value: family.system({**place, name: value}), *bracket, order=14
    )
    start = orbit(family, **place)
    point = touching(family, name, start, place)
    assert point.status is Status.OK, point
    assert abs(point.value - exact) <= 1e-10 * abs(exact)
    assert {point.label_below, point.label_above} == {"1-0-0", "1-1-0"}
    system = family.system(point.values)
    theirs = closed_forms.floquet_multipliers(system, order=14)
    assert np.sort(np.abs(point.multipliers)) == pytest.approx(np.sort(np.abs(theirs)), rel=1e-8)


@pytest.mark.parametrize("ripple", [0.1, 0.3])
@pytest.mark.parametrize("omega", [0.5, 1.2])
def test_one_degree_of_freedom_with_ripple(omega, ripple):
    """Time-varying stiffness, several harmonics in the response."""
    family = one_dof(ripple=0.2)
    values = {"omega": omega, "ripple": ripple, "load": 0.5}
    exact = closed_forms.grazing_parameter(
        lambda value: family.system({**values, "load": value}), 0.005, 0.5, order=14
    )
    values["load"] = 1.03 * exact
    point = touching(family, "load", orbit(family, **values), values)
    assert point.status is Status.OK
    assert abs(point.value - exact) <= 1e-10 * exact


def test_both_directions_agree_in_the_article_case():
    family = article()
    first = touching(family, "omega", orbit(family, omega=0.98), {"omega": 0.98})
    values = []
    for relative in (-1e-2, -1e-3, -1e-6, 1e-6, 1e-3, 5e-3):
        start, there = beside(family, first, relative)
        values.append(touching(family, "omega", start, there).value)
    assert np.ptp(values) <= 1e-12


def test_phases_of_error_and_ripple_are_one():
    """Only their difference counts (a shift of time): grazing over one is grazing over the other, negated."""
    family, place = article(), {"omega": 0.965}
    start = orbit(family, **place)
    one, other = (touching(family, name, start, place) for name in ("error_phase", "ripple_phase"))
    assert one.status is other.status is Status.OK
    assert one.value == pytest.approx(-other.value, rel=1e-11)
    assert (one.label_below, one.label_above) == (other.label_above, other.label_below)
    exact = closed_forms.grazing_parameter(
        lambda value: family.system({**place, "error_phase": value}), 0.2, 0.35, order=14
    )
    assert one.value == pytest.approx(exact, rel=1e-10)


def test_the_touching_orbit_under_heyoka(truth):
    """The back-side grazing of 6-6-1: at its value heyoka closes the orbit and finds X = −D, X′ = 0 there."""
    family, place = article(), {"omega": 0.78, "D": 0.389}
    point = touching(family, "D", orbit(family, **place), place, boundary=-1)
    assert point.status is Status.OK
    assert (point.label_below, point.label_above) == ("6-6-1", "6-6-2")
    system = family.system(point.values)
    start = Orbit(built(family, **point.values), _shot(point), 0, Status.OK, "")
    run = truth(system).run(system, start.state, 6.0)
    assert np.abs(run.state - start.state).max() < 1e-10
    run = truth(system).run(system, start.state, point.phase)
    assert abs(float(run.state[8]) + point.value) < 1e-11
    assert abs(float(run.state[9])) < 1e-10
    assert np.abs(run.state - point.state).max() < 1e-10


def _shot(point: GrazingPoint):
    return Shot(point.state_zero, point.period, 0.0, np.eye(10), 0.0, 0, Status.OK)
