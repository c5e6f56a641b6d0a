"""Floquet multipliers and exponents of periodic orbits."""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest

from gearlash import flow
from gearlash.orbits import Orbit, floquet, multipliers
from gearlash.system import System
from orbits.members import article, cold, one_dof, orbit

PLACES = [
    (article, {"omega": 1.047}),
    (article, {"omega": 0.942}),
    (article, {"omega": 1.11}),
    (article, {"omega": 0.83}),
    (article, {"omega": 0.78, "D": 0.39}),
    (article, {"omega": 0.78, "D": 0.375}),
    (article, {"omega": 0.78, "D": 0.382}),
    (one_dof, {"omega": 1.35, "D": 0.13, "error": 0.08}),
    (one_dof, {"omega": 0.98, "D": 0.27, "error": 0.21}),
    (one_dof, {"omega": 0.3, "mesh_damping": 0.4}),
    (one_dof, {"omega": 0.05, "mesh_damping": 1.5}),
]
NAMES = [f"{family.__name__}-{'-'.join(f'{v}' for v in place.values())}" for family, place in PLACES]


@pytest.fixture(params=PLACES, ids=NAMES)
def found(request) -> Orbit:
    family, place = request.param
    return orbit(family(), **place)


def divergence(system: System) -> float:
    """Of the field, from its definition: the same in all three regions."""
    (c,) = system.clearances
    return float(np.trace(system.matrix) + c.damping * (c.h @ system.matrix @ c.g))


def factors(found: Orbit, parts: int = 1) -> list[np.ndarray]:
    out, z = [], found.state
    for part in range(found.shot.period * parts):
        step = flow.variational(found.propagators, z, 1.0 / parts, (part % parts) / parts)
        assert step.jacobian is not None
        out.append(step.jacobian)
        z = step.state
    return out


def exact_eigenvalues(found: Orbit) -> np.ndarray:
    """Of the product of the same factors, in 200 digits, so that small ones are right too."""
    with mp.workdps(200):
        product = mp.eye(len(found.state))
        for factor in factors(found, parts=8 if len(found.state) > 2 else 80):
            product = mp.matrix(factor.tolist()) * product
        values = mp.eig(product, left=False, right=False)
        return np.array([complex(v) for v in values])


def distances(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Relative distance of each in one to the nearest of the other, every one used once."""
    left, out = list(other), []
    for value in one:
        nearest = min(left, key=lambda v: abs(v - value))
        left.remove(nearest)
        out.append(abs(nearest - value) / abs(nearest))
    return np.array(out)


def test_liouville(found):
    """The product of all multipliers is exp of the trace over the orbit, to the last small one."""
    values = found.multipliers
    assert len(values) == len(found.state)
    expected = divergence(found.propagators.system) * found.duration
    assert abs(np.log(np.abs(values)).sum() - expected) < 1e-11 * max(1.0, abs(expected))
    assert abs(np.angle(np.prod(values / np.abs(values)))) < 1e-11


def test_every_multiplier_has_its_digits(found):
    assert distances(found.multipliers, exact_eigenvalues(found)).max() < 1e-11


def test_order_and_pairs(found):
    values = found.multipliers
    assert (np.diff(np.abs(values)) <= 1e-11 * np.abs(values[:-1])).all()
    assert distances(values, values.conj()).max() < 1e-11
    assert abs(values[0]) == pytest.approx(abs(found.leading), rel=1e-9)


def test_exponents(found):
    """ln|μ| over the duration; they sum up to the trace."""
    exponents = found.exponents
    assert exponents.sum() == pytest.approx(divergence(found.propagators.system), rel=1e-11)
    assert found.largest_exponent == pytest.approx(exponents[0], rel=1e-8)
    assert found.exponent_error == 0.0
    assert found.duration == pytest.approx(
        found.period * 2 * np.pi / found.propagators.system.omega, rel=1e-15
    )
    assert found.largest_exponent < 0.0


@pytest.mark.parametrize("place", [p for f, p in PLACES[:4]], ids=NAMES[:4])
def test_lifted_is_plain(place):
    """P ≤ 4: the eigenvalues of the plain product, and those of the block-cyclic matrix."""
    found = orbit(article(), **place)
    product = np.eye(10)
    for factor in factors(found):
        product = factor @ product
    lifted = floquet._lifted(factors(found, parts=4))
    assert distances(lifted, np.linalg.eigvals(product)).max() < 1e-12
    assert distances(found.multipliers, lifted).max() < 1e-12


@pytest.mark.parametrize(
    "place",
    [{"omega": 0.942}, {"omega": 0.83}, {"omega": 0.78, "D": 0.386}, {"omega": 0.78, "D": 0.375}],
    ids=str,
)
def test_monodromy_of_heyoka(truth, place):
    found = orbit(article(), **place)
    system = found.propagators.system
    run = truth(system).run(system, found.state, float(found.period))
    theirs = run.jacobian.astype(float)
    assert np.abs(found.shot.monodromy - theirs).max() < 1e-12 * np.abs(theirs).max()
    large = np.abs(found.multipliers) > 1e-2
    assert distances(found.multipliers[large], np.linalg.eigvals(theirs)).max() < 1e-11


def test_monodromy_by_differences():
    """Central differences of the return map, through the contacts of 6-6-1."""
    found = orbit(article(), omega=0.78, D=0.386)
    step, columns = 1e-6, []
    for direction in np.eye(10):
        ends = [
            flow.march(found.propagators, found.state + sign * step * direction, 6).states[-1]
            for sign in (1, -1)
        ]
        columns.append((ends[0] - ends[1]) / (2 * step))
    far = np.abs(np.array(columns).T - found.shot.monodromy).max()
    assert far < 1e-6 * np.abs(found.shot.monodromy).max()


def test_every_point_of_an_orbit_has_the_same_multipliers():
    found = orbit(article(), omega=0.78, D=0.375)
    for state in found.strobes[[1, 5, 11]]:
        assert distances(multipliers(found.propagators, state, 12), found.multipliers).max() < 1e-9


def test_a_longer_turn_is_a_power():
    """24 turns of 1-1-0: multipliers to the 24th, small ones (down to 1e-13) with their digits."""
    found = orbit(article(), omega=0.942)
    long = multipliers(found.propagators, found.state, 24)
    assert distances(long, found.multipliers**24).max() < 1e-10


def test_strongly_damped_pair_in_closed_form():
    """In permanent contact, X″ + ζX′ + X = …: exponents are the roots of s² + ζs + 1."""
    found = cold(one_dof(), omega=0.05, mesh_damping=1.5)
    assert isinstance(found, Orbit)
    assert found.label == "1-0-0"
    roots = np.sort(np.roots([1.0, 3.0, 1.0]).real)[::-1]
    assert found.exponents == pytest.approx(roots, rel=1e-11)
    assert found.largest_exponent == pytest.approx(roots[0], rel=1e-11)


def test_order_of_small_numbers():
    """Sorting is by relative size: a zero does not come before 1e-21."""
    values = floquet.ordered(np.array([0.0, 1e-21, 1e-3, 1e-20]))
    assert (values == [1e-3, 1e-20, 1e-21, 0.0]).all()


def test_many_maps_go_into_subspaces():
    """More maps than the lifted matrix may hold."""
    found = orbit(article(), omega=0.942)
    long = multipliers(found.propagators, found.state, 120)
    with np.errstate(under="ignore"):
        assert distances(long, found.multipliers**120).max() < 1e-8
