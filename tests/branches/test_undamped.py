"""Motions without damping, whose multipliers are reciprocal: where pairs leave the unit circle."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import gearlash as gl
from branches.followed import PLAIN
from gearlash.branches.continuation import Branch, SpecialKind, continue_orbit
from gearlash.branches.continuation.reciprocal import Reciprocal
from gearlash.branches.continuation.testfunctions import Spectrum, outside
from gearlash.orbits import orbit_at

DEFAULTS = {"omega": 2.3, "coupling": 0.5, "ground": 1.5, "load": 0.5, "force": 0.02, "ripple": 0.3}


def two_masses(values: dict[str, float]) -> gl.Family:
    """x″ = load + F cos ωτ − (1 + ε cos ωτ) f(x) − c (x − y), y″ = c (x − y) − k y, f with a gap of ±1."""

    def build(p):
        c, k = p["coupling"], p["ground"]
        matrix = np.array(
            [[0.0, 1.0, 0.0, 0.0], [-c, 0.0, c, 0.0], [0.0, 0.0, 0.0, 1.0], [c, 0.0, -c - k, 0.0]]
        )
        forcing = np.zeros((4, 3))
        forcing[1] = p["load"], p["force"], 0.0
        h, g = np.array([1.0, 0.0, 0.0, 0.0]), np.array([0.0, -1.0, 0.0, 0.0])
        stiffness = np.array([1.0, p["ripple"], 0.0])
        gap = gl.Clearance(h, g, 1.0, 1.0, stiffness, stiffness, contact=gl.ContactRule.ALWAYS)
        return gl.System(p["omega"], matrix, forcing, (gap,))

    parameters = tuple(gl.Parameter(name, value) for name, value in {**DEFAULTS, **values}.items())
    return gl.Family(parameters, ("x", "v", "y", "w"), build, cold_start=lambda p: np.zeros(4))


def discriminant(omega: float) -> float:
    """By another integrator, from the traces of the monodromy of permanent contact: with a = tr M and
    b = (a² − tr M²)/2, the sums of μ + 1/μ have the product b − 2."""

    def rate(t: float, z: np.ndarray) -> np.ndarray:
        x, v, y, w = z.reshape(4, 4)
        stiffness = 1.0 + DEFAULTS["ripple"] * np.cos(omega * t)
        c, k = DEFAULTS["coupling"], DEFAULTS["ground"]
        return np.concatenate([v, -stiffness * x - c * (x - y), w, c * (x - y) - k * y])

    span = (0.0, 2.0 * np.pi / omega)
    found = solve_ivp(rate, span, np.eye(4).ravel(), method="DOP853", rtol=1e-13, atol=1e-14)
    monodromy = found.y[:, -1].reshape(4, 4)
    trace = np.trace(monodromy)
    return float(trace**2 - 4.0 * (0.5 * (trace**2 - np.trace(monodromy @ monodromy)) - 2.0))


@cache
def followed() -> Branch:
    family = two_masses({})
    orbit = orbit_at(gl.propagators(family.system()), np.array([1.5, 0.0, 0.3, 0.0]), 1)
    assert orbit is not None
    return continue_orbit(family, family.complete({}), "omega", orbit, 2.2, 3.2, PLAIN)


def test_pairs_that_meet_and_leave_the_circle_are_solved_for():
    """A combination resonance near the sum of the natural frequencies, 2.611, between two Krein collisions;
    that of the second mode alone near 3.04 between two doublings."""
    branch = followed()
    assert [special.kind for special in branch.special] == [
        SpecialKind.DOUBLING, SpecialKind.KREIN, SpecialKind.KREIN, SpecialKind.DOUBLING, SpecialKind.DOUBLING
    ]  # fmt: skip
    counts = [(special.unstable_before, special.unstable_after) for special in branch.special]
    assert counts == [(1, 0), (0, 2), (2, 0), (0, 1), (1, 0)]
    for special in branch.of_kind(SpecialKind.KREIN):
        zero = brentq(discriminant, special.value - 1e-3, special.value + 1e-3, xtol=1e-14)
        assert special.value == pytest.approx(zero, abs=1e-10)
        assert special.error < 1e-12


def test_stability_changes_at_special_points_only_and_it_is_said_what_is_not_decided():
    branch = followed()
    edges = [special.value for special in branch.special]
    for point in branch.points:
        place = int(np.searchsorted(edges, point.value))
        assert point.unstable == (1, 0, 2, 0, 1, 0)[place]
    (said,) = branch.unexplained
    assert "where pairs leave the circle is solved for" in said
    assert "whether orbits with all multipliers on it are stable is not decided" in said


def test_rounding_of_a_double_multiplier_is_not_outside():
    """Two pairs at one place of the circle: their moduli are known to 1e-8, their sums to 1e-16."""
    turn = np.exp(1j)
    split = turn * (1.0 + 1e-8), turn / (1.0 + 1e-8)
    multipliers = np.array([*split, *np.conj(split)], dtype=np.complex128)
    assert (np.abs(multipliers) > 1.0 + 1e-9).any()
    assert len(outside(multipliers)) == 0
    assert Spectrum(multipliers, 1.0).unstable.total == 0


@pytest.mark.parametrize(
    ("sums", "above", "below", "four"),
    [
        ((0.5, -1.2), 0, 0, 0),
        ((2.5, -1.2), 1, 0, 0),
        ((2.5, -3.0), 1, 1, 0),
        ((0.4 + 0.3j, 0.4 - 0.3j), 0, 0, 1),
        ((0.4 + 0.3j, 0.4 - 0.3j, -2.2), 0, 1, 1),
    ],
)
def test_sums_tell_where_multipliers_lie(sums, above, below, four):
    multipliers = np.concatenate([np.roots([1.0, -each, 1.0]) for each in sums]).astype(np.complex128)
    found = Reciprocal.of(multipliers)
    assert found is not None
    assert (found.above, found.below, found.complex) == (above, below, four)
    assert len(outside(multipliers)) == above + below + 2 * four == int((np.abs(multipliers) > 1.0001).sum())
    assert Reciprocal.of((0.99 * multipliers).astype(np.complex128)) is None
