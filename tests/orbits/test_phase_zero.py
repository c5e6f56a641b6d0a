"""What is said of an orbit depends neither on which place of the base period is called phase zero nor on the
units of its states, and its error holds against 80-bit arithmetic."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from gearlash.flow import carry, propagators
from gearlash.orbits import Orbit, Verdict, attractor, shoot
from gearlash.orbits.certificate import _Examined
from gearlash.orbits.shooting import TOLERANCE, minimal
from gearlash.system import Clearance, ContactRule, System, constant
from orbits.contacts import two_gaps
from orbits.members import article, one_dof, orbit

APART = 6.0  # times the least error of an orbit: the largest, from other phases
ALWAYS, IN_CONTACT = ContactRule.ALWAYS, ContactRule.IN_CONTACT


def stop(omega, zeta, force, gap, stiffness, rule=IN_CONTACT, both=False) -> System:
    """x″ + 2ζx′ + x = 0.1 + a cos ωt with elastic stops that take up nothing."""
    forcing = np.array([[0.0, 0.0, 0.0], [0.1, force, 0.0]])
    other = (gap, constant(stiffness)) if both else (100.0, constant(0.0))
    h, g = np.array([1.0, 0.0]), np.array([0.0, -1.0])
    mass = np.array([[0.0, 1.0], [-1.0, -2.0 * zeta]])
    clearance = Clearance(h, g, gap, other[0], constant(stiffness), other[1], contact=rule, name="stop")
    return System(omega, mass, forcing, (clearance,))


def in_units(system: System, units) -> System:
    """The same system with states in these units."""
    units = np.asarray(units)
    gaps = tuple(replace(c, h=c.h * units, g=c.g / units) for c in system.clearances)
    matrix, forcing = system.matrix * units / units[:, None], system.forcing / units[:, None]
    return replace(system, matrix=matrix, forcing=forcing, clearances=gaps)


def turned(system: System, angle: float) -> System:
    """The same system seen from another phase zero."""

    def series(values):
        out, order = values.copy(), np.arange(1, values.shape[-1] // 2 + 1)
        c, s = values[..., 1::2], values[..., 2::2]
        out[..., 1::2] = c * np.cos(order * angle) + s * np.sin(order * angle)
        out[..., 2::2] = s * np.cos(order * angle) - c * np.sin(order * angle)
        return out

    names = "stiffness_plus", "stiffness_minus", "offset"
    gaps = tuple(replace(c, **{n: series(getattr(c, n)) for n in names}) for c in system.clearances)
    return replace(system, forcing=series(system.forcing), clearances=gaps)


STOPS = {
    "stiff": stop(0.9, 0.02, 1.0, 0.5, 1e4),
    "stiffer": stop(1.7, 0.02, 1.0, 0.5, 1e5),
    "stiffest": stop(1.7, 0.02, 1.0, 0.5, 1e7),
    "several periods": stop(2.4, 0.01, 1.0, 0.2, 1e2),
    "hardly damped": stop(1.5, 0.00071, 0.3, 0.14, 92.0),
    "hardly damped and stiff": stop(1.8, 0.0011, 1.8, 0.14, 1.1e4, ALWAYS),
    "two stiff sides": stop(1.5, 0.0015, 0.7, 0.47, 3e5, ALWAYS, both=True),
    "strongly damped": stop(1.1, 3.0, 3.0, 0.1, 50.0),
    "strongly damped and stiff": stop(0.7, 5.0, 8.0, 0.1, 1e5),
}
OTHERS = {
    "article": (article, {"omega": 0.83}),
    "one degree of freedom": (one_dof, {"omega": 0.98, "D": 0.27, "error": 0.21}),
    "two gaps": (two_gaps, {"omega": 0.5}),
}


@cache
def solved(name: str) -> Orbit:
    if name in OTHERS:
        family, values = OTHERS[name]
        return orbit(family(), **values)
    found = attractor(STOPS[name], np.zeros(2))
    assert isinstance(found, Orbit), found.message
    assert found.signature.impacts > 0
    return found


def everywhere(found: Orbit, count: int) -> Iterator[Orbit]:
    """The orbit, solved for from so many phases zero by chance, and from the midst of its first contacts."""
    system, contacts = found.propagators.system, found.events.phase
    phases = np.random.default_rng(11).uniform(0.0, system.cycles, count)
    midst = 0.5 * (contacts[1:] + contacts[:-1])[:4] % system.cycles
    for phase in [*phases, *midst]:
        props = propagators(turned(system, 2.0 * np.pi * phase / system.cycles))
        start = carry(found.propagators, found.state, float(phase)).state
        shot = minimal(props, shoot(props, start, found.shot.period))
        yield Orbit(props, shot, 0, shot.status, "")


@pytest.mark.parametrize("name", [*STOPS, *OTHERS])
def test_verdict_and_error_do_not_depend_on_where_phase_zero_lies(name):
    first = solved(name)
    seen = list(everywhere(first, 2 if name == "stiffest" else 5))
    assert {(each.label, each.certificate.verdict) for each in seen} == {(first.label, Verdict.CERTIFIED)}
    errors = [_Examined(each._closed()).error for each in seen]
    assert max(errors) <= APART * min(errors)


@pytest.mark.parametrize("name", ["stiffer", "several periods", "hardly damped", "strongly damped"])
@pytest.mark.parametrize("units", [(1e-3, 1e3), (1e3, 1.0)])
def test_units_of_the_states_do_not_matter(name, units):
    first = solved(name)
    props = propagators(in_units(first.propagators.system, units))
    shot = minimal(props, shoot(props, first.state / units, first.shot.period))
    found = Orbit(props, shot, 0, shot.status, "")
    assert shot.residual <= TOLERANCE
    assert (found.label, found.certificate.verdict) == (first.label, Verdict.CERTIFIED)
    error, before = _Examined(found._closed()).reach * units, _Examined(first._closed()).reach
    assert (error <= APART * before).all()
    assert (before <= APART * error).all()


@pytest.mark.parametrize("name", ["stiffer", "several periods", "hardly damped", "two stiff sides", *OTHERS])
def test_the_error_holds_against_80_bits(name):
    """A step of Newton's method from the return of an independent integrator, far more exact, is less."""
    pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")
    from oracles import region_oracle

    for found in everywhere(solved(name), 1):
        truth = region_oracle.run(found.propagators.system, found.state, found.period)
        missed = (truth.state - found.state).astype(float)
        step = np.abs(np.linalg.solve(found.shot.monodromy - np.eye(len(missed)), missed))
        assert (step <= _Examined(found._closed()).reach).all()
        assert step.max() <= found.shot.error
