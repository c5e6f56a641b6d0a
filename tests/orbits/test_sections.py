"""The three Poincaré sections as data."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from gearlash import flow
from gearlash.orbits import Orbit, sections
from gearlash.system import System, evaluate
from orbits.members import article, one_dof, orbit

PLACES = [
    (article, {"omega": 1.047}),
    (article, {"omega": 0.942}),
    (article, {"omega": 1.11}),
    (article, {"omega": 0.83}),
    (article, {"omega": 0.78, "D": 0.386}),
    (article, {"omega": 0.78, "D": 0.39}),
    (article, {"omega": 0.78, "D": 0.375}),
    (one_dof, {"omega": 0.67, "D": 0.06, "error": 0.17}),
    (one_dof, {"omega": 0.98, "D": 0.27, "error": 0.21}),
]


@pytest.fixture(params=PLACES, ids=[f"{f.__name__}-{'-'.join(map(str, p.values()))}" for f, p in PLACES])
def found(request) -> Orbit:
    family, place = request.param
    return orbit(family(), **place)


def gap(system: System, phase, state):
    """(X, X′) from the definition: X = h·z − e(θ), X′ = h·(M z + b) − ω e′(θ)."""
    (c,) = system.clearances
    theta = 2 * np.pi * np.asarray(phase)
    slope = np.zeros_like(theta)
    for n in range(1, (len(c.offset) + 1) // 2):
        slope += n * (c.offset[2 * n] * np.cos(n * theta) - c.offset[2 * n - 1] * np.sin(n * theta))
    forcing = np.array([evaluate(row, theta) for row in system.forcing]).T
    return state @ c.h - evaluate(c.offset, theta), (
        state @ system.matrix.T + forcing
    ) @ c.h - system.omega * slope


def test_on_their_boundaries(found):
    """X = +D at every crossing of Σ1, X = −D at every one of Σ2."""
    system, data = found.propagators.system, sections(found)
    (c,) = system.clearances
    scale = max(1.0, np.abs(found.strobes).max())
    for section, edge in ((data.drive, c.gap_plus), (data.back, -c.gap_minus)):
        x, velocity = gap(system, section.phase, section.state)
        assert np.abs(x - edge).max(initial=0.0) <= 1e-14 * scale
        assert np.abs(section.displacement - edge).max(initial=0.0) <= 1e-14 * scale
        assert np.abs(section.velocity - velocity).max(initial=0.0) <= 1e-14 * scale


def test_force_there_is_that_of_damping_alone(found):
    """f = 0 on both boundaries: Φ = ζ X′ to the last bit."""
    data, (c,) = sections(found), found.propagators.system.clearances
    for section in (data.drive, data.back):
        assert (section.force == c.damping * section.velocity).all()


def test_directions(found):
    """Into contact: X rises through +D or falls through −D; out of it the other way."""
    data = sections(found)
    assert (np.sign(data.drive.velocity) == data.drive.direction).all()
    assert (np.sign(data.back.velocity) == -data.back.direction).all()
    for section in (data.drive, data.back):
        assert (section.entering.direction == 1).all()
        assert (section.leaving.direction == -1).all()
        assert len(section.entering) + len(section.leaving) == len(section)


def test_what_enters_leaves(found):
    """On a closed orbit both counts agree, crossings alternate, and the entering ones are Q and R."""
    data, signature = sections(found), found.signature
    assert len(data.drive.entering) == len(data.drive.leaving) == signature.drive
    assert len(data.back.entering) == len(data.back.leaving) == signature.back
    for section in (data.drive, data.back):
        direction = section.direction
        assert (direction[1:] == -direction[:-1]).all()


def test_phases(found):
    """In order, inside one orbit, crossings of the two boundaries never interleave."""
    data, period = sections(found), found.period
    for section in (data.drive, data.back):
        assert (np.diff(section.phase) > 0.0).all()
        assert ((section.phase >= 0.0) & (section.phase < period)).all()
    every = [(p, 1, d) for p, d in zip(data.drive.phase, data.drive.direction, strict=True)]
    every += [(p, -1, d) for p, d in zip(data.back.phase, data.back.direction, strict=True)]
    walk = sorted(every)
    for (_, boundary, direction), (_, after, direction_after) in pairwise(walk):
        if direction == 1:  # in contact: it can only leave through the same boundary
            assert (after, direction_after) == (boundary, -1)
        else:
            assert direction_after == 1


def test_strobes(found):
    """σ_t: P points at whole phases, each the image of the one before."""
    data, system = sections(found), found.propagators.system
    assert len(data.time) == found.shot.period
    assert (data.time.phase == np.arange(found.shot.period)).all()
    assert (data.time.direction == 0).all()
    x, velocity = gap(system, data.time.phase, data.time.state)
    assert np.abs(data.time.displacement - x).max() < 1e-14
    assert np.abs(data.time.velocity - velocity).max() < 1e-14
    for state, image in zip(data.time.state, np.roll(data.time.state, -1, axis=0), strict=True):
        moved = flow.march(found.propagators, state, 1).states[-1]
        assert np.abs(moved - image).max() < 1e-11


def test_force_on_strobes(found):
    """Φ = η f(X) + ζ X′, with the dead zone written out."""
    data, system = sections(found).time, found.propagators.system
    (c,) = system.clearances
    for x, velocity, force in zip(data.displacement, data.velocity, data.force, strict=True):
        if x > c.gap_plus:
            elastic = float(evaluate(c.stiffness_plus, 0.0)) * (x - c.gap_plus)
        elif x < -c.gap_minus:
            elastic = float(evaluate(c.stiffness_minus, 0.0)) * (x + c.gap_minus)
        else:
            elastic = 0.0
        assert force == pytest.approx(elastic + c.damping * velocity, abs=1e-14)


@pytest.mark.parametrize("place", [{"omega": 0.942}, {"omega": 0.78, "D": 0.375}], ids=str)
def test_crossings_of_heyoka(truth, place):
    found = orbit(article(), **place)
    data, system = sections(found), found.propagators.system
    run = truth(system).run(system, found.state, float(found.period))
    for section, boundary in ((data.drive, 1), (data.back, -1)):
        here = run.boundary == boundary
        assert (section.direction == np.where(run.engaging[here], 1, -1)).all()
        assert np.abs(section.phase - run.phase[here].astype(float)).max(initial=0.0) < 1e-11
        assert np.abs(section.state - run.states[here].astype(float)).max(initial=0.0) < 1e-11


def test_orbit_from_another_of_its_points():
    """Started one cycle later, the same crossings, all one cycle earlier."""
    found = orbit(article(), omega=0.78, D=0.375)
    shifted = Orbit(found.propagators, replace(found.shot, state=found.strobes[1]), 0, found.status, "")
    one, other = sections(found), sections(shifted)
    for a, b in ((one.drive, other.drive), (one.back, other.back)):
        expected = np.sort((a.phase - 1.0) % found.period)
        assert np.abs(expected - b.phase).max() < 1e-11
