"""Orbits with fifty impacts in a mesh cycle."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

pytest.importorskip("heyoka", reason="heyoka has wheels for Linux only")

import gearlash as gl
from branches.followed import PLAIN
from gearlash.branches.continuation import Branch, continue_orbit
from gearlash.branches.continuation.extrema import Extrema
from oracles.special_points import point_again

ORDER = 25  # harmonic of the fast force: so often does the body go from one stop to the other and back
DEFAULTS = {"omega": 0.05, "slow": 0.1, "fast": 1.0, "stiffness": 8.0, "gap": 0.1}


def build(p):
    """x″ + 0.1 x′ = 0.1 cos θ + cos 25θ between two stops, with damping beside them, too."""
    forcing = np.zeros((2, 2 * ORDER + 1))
    forcing[1, 1], forcing[1, 2 * ORDER - 1] = p["slow"], p["fast"]
    matrix, stiffness = np.array([[0.0, 1.0], [0.0, -0.1]]), np.array([p["stiffness"]])
    h, g = np.array([1.0, 0.0]), np.array([0.0, -1.0])
    stops = gl.Clearance(h, g, p["gap"], p["gap"], stiffness, stiffness, 0.1, contact=gl.ContactRule.ALWAYS)
    return gl.System(p["omega"], matrix, forcing, (stops,))


@cache
def family() -> gl.Family:
    parameters = tuple(gl.Parameter(name, value) for name, value in DEFAULTS.items())
    return gl.Family(parameters, ("x", "v"), build, cold_start=lambda p: np.array([0.1, 0.0]))


@cache
def rattle() -> gl.Orbit:
    found = gl.attractor(family().system(), family().start())
    assert isinstance(found, gl.Orbit)
    return found


@cache
def branch() -> Branch:
    return continue_orbit(family(), family().complete({}), "omega", rattle(), 0.05, 0.0503, PLAIN)


def test_the_orbit_is_certified_with_fifty_impacts():
    assert rattle().signature == "1-25-25"
    assert len(rattle().events) == 100
    assert rattle().certificate.certified
    assert len(Extrema.of(rattle()).all) > 150


@pytest.mark.parametrize("part", [0.2, 0.9])
def test_orbits_and_multipliers_are_those_of_the_oracle(part: float):
    checked = point_again(family(), branch(), int(part * len(branch().points)))
    assert checked.contacts == ""
    assert checked.state_apart < 1e-10
    assert checked.multipliers_apart < 1e-7
