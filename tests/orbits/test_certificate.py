"""Certificates: given to ordinary orbits, withheld where something lies within the error."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearlash.branches import GrazingPoint, locate_grazing, locate_multiplier
from gearlash.orbits import Aperiodic, Orbit, Settings, Verdict, attractor, grazing_checks, shoot
from gearlash.orbits.certificate import Closed, _Examined
from gearlash.results import blank
from gearlash.studies import point
from gearlash.system import ContactRule, Family, Status
from orbits.contacts import one_dof_under, two_gaps
from orbits.members import article, built, cold, one_dof, orbit

ORDINARY = [
    (article(), {"omega": 1.047}),
    (article(), {"omega": 0.942}),
    (article(), {"omega": 0.83}),
    (article(), {"omega": 0.78, "D": 0.39}),
    (article(), {"omega": 0.78, "D": 0.375}),
    (one_dof(), {"omega": 0.98, "D": 0.27, "error": 0.21}),
    (two_gaps(), {"omega": 0.5}),
    (two_gaps(ContactRule.IN_CONTACT), {"omega": 0.3}),
    (two_gaps(ContactRule.NO_TENSION), {"omega": 0.3}),
    (one_dof_under(ContactRule.NO_TENSION), {"omega": 0.8, "error": 0.2}),
]


def closed(family: Family, values: dict[str, float], guess, period: int) -> Orbit:
    """The orbit near a guess, stable or not."""
    props = built(family, **values)
    shot = shoot(props, guess, period)
    assert shot.status.value in ("ok", "uncertain")
    return Orbit(props, shot, 0, shot.status, "")


def touch(
    family: Family, values: dict[str, float], name: str, boundary: int = 1, gap: int = 0
) -> GrazingPoint:
    start = orbit(family, **values)
    check = next(c for c in grazing_checks(start, clearance=gap) if c.boundary == boundary)
    found = locate_grazing(family, name, start, check, values=family.complete(values))
    assert found.status.ok
    return found


def examined(found: Orbit) -> _Examined:
    return _Examined(Closed(found.propagators, found.shot, found.trace, found.strobes, found.leading))


@pytest.mark.parametrize(("family", "values"), ORDINARY)
def test_ordinary_orbits_are_certified(family, values):
    found = orbit(family, **values).certificate
    assert found.certified, str(found)
    assert found.reasons == ()
    assert str(found) == "certified"


@pytest.mark.parametrize(("family", "values"), ORDINARY)
def test_the_error_bounds_what_newton_leaves_open(family, values):
    """Orbits that Newton's method ends at from other guesses differ by less than the error, all along."""
    first = orbit(family, **values)
    error = examined(first).error
    assert 0.0 < error < 1e-9
    rng = np.random.default_rng(7)
    phases = np.linspace(0.0, float(first.period), 40 * first.period + 1)
    for _ in range(3):
        guess = first.state + 1e-7 * rng.normal(size=len(first.state))
        other = closed(family, values, guess, first.shot.period)
        apart = np.abs(other.trace.at(phases).state - first.trace.at(phases).state).max()
        assert apart <= error


GRAZES = {
    "drive side": (article(), {"omega": 0.98}, "omega", 1, 0, "minimum of X is"),
    "back side": (article(), {"omega": 0.78, "D": 0.389}, "D", -1, 0, "minimum of X is"),
    "second gap": (two_gaps(), {"omega": 0.5}, "gap", -1, 1, "of X (link) is"),
    "force": (
        one_dof_under(ContactRule.NO_TENSION),
        {"omega": 0.7, "load": 0.12},
        "load",
        1,
        0,
        "the force comes to",
    ),
}


@pytest.mark.parametrize("name", GRAZES)
def test_a_graze_within_the_error_is_uncertain_and_one_beyond_is_not(name):
    family, values, parameter, boundary, gap, words = GRAZES[name]
    at = touch(family, values, parameter, boundary, gap)
    period = at.period
    for relative in (0.0, 2e-15, -2e-15):
        beside = {**at.values, parameter: at.value * (1.0 + relative)}
        found = closed(family, beside, at.state_zero, period).certificate
        assert found.verdict is Verdict.UNCERTAIN
        assert any(words in reason and "within the error" in reason for reason in found.reasons), found
    for relative in (1e-8, -1e-8):
        beside = {**at.values, parameter: at.value * (1.0 + relative)}
        found = closed(family, beside, at.state_zero, period).certificate
        assert found.certified, str(found)


def test_a_doubling_within_the_error_is_uncertain_and_one_beyond_is_not():
    values = {"omega": 0.78, "D": 0.385}
    start = orbit(article(), **values)
    at = locate_multiplier(article(), "D", start, -1, values=article().complete(values))
    assert at.status.ok
    found = closed(article(), dict(at.values), at.state, start.shot.period).certificate
    assert found.verdict is Verdict.UNCERTAIN
    assert any("leading multiplier" in reason and "from modulus 1" in reason for reason in found.reasons)
    for relative in (1e-5, -1e-5):
        beside = {**at.values, "D": at.value * (1.0 + relative)}
        assert closed(article(), beside, at.state, start.shot.period).certificate.certified


def test_a_period_that_is_not_the_least_is_uncertain():
    once = orbit(article(), omega=0.942)
    twice = closed(article(), {"omega": 0.942}, once.state, 2).certificate
    assert twice.verdict is Verdict.UNCERTAIN
    assert any("after 1 of 2 base periods" in reason for reason in twice.reasons)


def test_an_orbit_that_does_not_close_fails():
    found = orbit(article(), omega=0.942)
    worse = Orbit(found.propagators, replace(found.shot, residual=1e-9), 0, found.status, "")
    assert worse.certificate.verdict is Verdict.FAILED
    assert "1e-09" in worse.certificate.reason


def test_a_larger_error_certifies_less():
    """Nothing but the numbers decides: with an error beyond the distance to the boundary it is withheld."""
    found = orbit(article(), omega=0.98)
    distance, mesh = abs(grazing_checks(found)[0].distance), found.propagators.system.clearances[0]

    def with_defect(size: float) -> _Examined:
        other = Orbit(found.propagators, found.shot, 0, found.status, "")
        vars(other)["trace"] = replace(found.trace, end=found.state + size)
        return examined(other)

    growth = float(np.abs(mesh.h) @ with_defect(1e-3).reach) / 1e-3
    for factor, certified in ((0.5, True), (2.0, False)):
        reasons = list(with_defect(factor * distance / growth).of_boundaries(0, mesh))
        assert (reasons == []) is certified


def test_of_motion_that_does_not_repeat():
    chaos = cold(article(), omega=1.2)
    assert isinstance(chaos, Aperiodic)
    assert chaos.certificate.certified
    doubtful = replace(chaos, undecided=2)
    assert doubtful.certificate.verdict is Verdict.UNCERTAIN
    assert doubtful.certificate.reason == "2 of the contacts examined lie within rounding of touching"
    flat = replace(chaos, largest_exponent=1e-4, exponent_error=2e-4)
    assert "zero within its error" in flat.certificate.reason


def test_unresolved_motion_says_its_reason():
    found = attractor(
        article().system({"omega": 1.2}),
        article().start({}),
        Settings(max_period=4, budget=60, patience=1_000),
    )
    assert found.label == "unresolved"
    assert found.certificate.verdict is Verdict.UNCERTAIN
    assert found.certificate.reasons == (found.message,)


def test_points_carry_it():
    good, bad = point(article(), {"omega": 0.942}), point(article(), {"omega": -1.0})
    assert (good.certificate, good.certificate_reason) == ("certified", "")
    assert bad.certificate == "failed"
    assert bad.certificate_reason == bad.message
    assert blank(1.0, Status.FAILED, "why").certificate == "failed"
    assert blank(1.0, Status.NOT_COMPUTED, "stopped").certificate == ""
