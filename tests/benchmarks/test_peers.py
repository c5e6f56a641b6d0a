"""The others solve the same problem: each against gearlash, within what its method can do."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from benchmarks import trajectories
from benchmarks.branches import ASKED
from benchmarks.peers import MISSING
from benchmarks.peers.plain import Pair
from benchmarks.peers.rk4 import RungeKutta
from benchmarks.peers.scipy import Monodromy, Scipy
from benchmarks.trajectories import Own, trajectory_rows
from benchmarks.works import MANY_PERIODS, POINTS, Work, _work, family
from gearlash import flow
from gearlash.branches import locate_grazing
from gearlash.orbits import Orbit, attractor, grazing_checks, orbit_at
from gearlash.system import ContactRule, GearlashError


@pytest.fixture(scope="module")
def work() -> Work:
    return _work(*POINTS[1])


def apart(solver, work: Work) -> float:
    z = work.states[-1]
    return float(np.abs(solver.carry(z, 1) - flow.march(work.props, z, 1).states[-1]).max())


def crossings_apart(solver, work: Work) -> float:
    own = Own(work)
    own.locate(work.states[-1])
    solver.carry(work.states[-1], 1)
    assert [c[1:] for c in solver.crossings] == [c[1:] for c in own.crossings]
    return max(abs(float(a[0] - b[0])) for a, b in zip(solver.crossings, own.crossings, strict=True))


def test_scipy(work: Work):
    assert apart(Scipy(work.pair), work) < 1e-11
    assert crossings_apart(Scipy(work.pair), work) < 1e-9


def test_multipliers_of_scipy(work: Work):
    orbit = attractor(work.props, work.states[-1])
    assert isinstance(orbit, Orbit)
    theirs = np.sort_complex(Monodromy(work.pair).multipliers(orbit.state, 1))
    assert np.abs(theirs - np.sort_complex(orbit.multipliers)).max() < 1e-9


@pytest.mark.parametrize("at", [0, 1, 3, 6])
def test_many_are_motions_of_their_own(at: int):
    """Marched for as long as the benchmark does, no two of them have been the same all the way; and where the
    attractor has no impacts, they have none."""
    work = _work(*POINTS[at])
    run = flow.march_many(work.props, work.scattered, MANY_PERIODS)
    early = run.states[MANY_PERIODS // 4]
    apart = np.abs(early[:, None] - early[None]).max(axis=2) + np.eye(len(early))
    assert apart.min() > 1e-9
    assert run.contacts.any() == (work.crossings > 0.0)


def test_runge_kutta_is_coarse_where_teeth_hit(work: Work):
    assert 1e-8 < apart(RungeKutta(work.pair), work) < 1e-4


def test_cvode(work: Work):
    cvode = pytest.importorskip("benchmarks.peers.cvode", exc_type=ImportError)
    assert apart(cvode.Cvode(work.pair), work) < 1e-10
    assert crossings_apart(cvode.Cvode(work.pair), work) < 1e-9


def test_heyoka_and_the_reference(work: Work):
    heyoka = pytest.importorskip("benchmarks.peers.heyoka", exc_type=ImportError)
    for real in (float, np.longdouble):
        solver = heyoka.Heyoka(work.pair, real=real, record=True)
        assert apart(solver, work) < 1e-13
        assert crossings_apart(solver, work) < 1e-12
    ends = heyoka.HeyokaBatch(work.pair, 4).carry(work.states[-4:], 3)
    own = [flow.march(work.props, z, 3).states[-1] for z in work.states[-4:]]
    assert np.abs(ends - np.array(own)).max() < 1e-13


def test_heyoka_on_orbits(work: Work):
    orbits = pytest.importorskip("benchmarks.peers.heyoka_orbits", exc_type=ImportError)
    orbit = attractor(work.props, work.states[-1])
    assert isinstance(orbit, Orbit)
    theirs = np.sort_complex(orbits.Monodromy(work.pair).multipliers(orbit.state, 1))
    assert np.abs(theirs - np.sort_complex(orbit.multipliers)).max() < 1e-11
    pairs, values = family("article-first-harmonic"), {"omega": 0.98, "D": 1.0}
    quiet = attractor(pairs.system(values), pairs.start(values))
    assert isinstance(quiet, Orbit)
    point = locate_grazing(pairs, "omega", quiet, grazing_checks(quiet)[0], values=values)
    peer = orbits.Grazing(Pair.of(pairs.system(values)))
    there = peer.locate(lambda omega: Pair.of(pairs.system({"omega": omega, "D": 1.0})), 0.98, quiet.state)
    assert there == pytest.approx(point.value, abs=1e-11)


def test_heyoka_on_a_map():
    plane = pytest.importorskip("benchmarks.peers.heyoka_plane", exc_type=ImportError)
    pairs = family("article-first-harmonic")
    points = [{"omega": 1.05, "D": 1.0}, {"omega": 0.95, "D": 1.0}, {"omega": 0.78, "D": 0.25}]
    systems = [pairs.system(v) for v in points]
    shape, starts = [Pair.of(s) for s in systems], [pairs.start(v) for v in points]
    labels = plane.Plane(shape[0]).labels(shape, starts)
    assert plane.PlaneBatch(shape[0], 2).labels(shape, starts) == labels
    assert labels == ["1-0-0", "1-1-0", "aperiodic"]


def test_the_peers_refuse_what_their_equations_do_not_say(work: Work):
    (clearance,) = work.system.clearances
    for other in (
        replace(clearance, contact=ContactRule.IN_CONTACT),
        replace(clearance, gap_minus=2.0),
        replace(clearance, offset=np.array([0.0, 0.1, 0.0])),
    ):
        with pytest.raises(GearlashError, match="written for gear pairs"):
            Pair.of(replace(work.system, clearances=(other,)))


def test_a_peer_that_is_missing_is_a_row(work: Work, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(trajectories, "installed", lambda package: MISSING)
    monkeypatch.setattr(trajectories, "PERIODS", 16)
    one, many = trajectory_rows(work, 1, 1)
    notes = {row.solver: (row.seconds, row.note) for row in (*one, *many)}
    for solver in ("heyoka", "CVODE", "heyoka batch"):
        assert notes[solver] == (None, MISSING)
    assert all(row.error is None for row in (*one, *many))  # there is no reference either


@pytest.mark.parametrize("asked", ASKED, ids=lambda asked: asked.name)
def test_a_branch_on_heyoka(asked):
    """Its orbits, multipliers and extrema are those of gearlash, through a grazing too."""
    module = pytest.importorskip("benchmarks.peers.heyoka_branch", exc_type=ImportError)
    pairs = family("article")
    system = pairs.system(asked.values)
    orbit = attractor(system, pairs.start(asked.values))
    assert isinstance(orbit, Orbit)
    peer = module.Branch(Pair.of(system), asked.name, asked.period)
    points = peer.follow(orbit.state, asked.values[asked.name], 8.0 * asked.length, 12, asked.upper)
    assert len(points) == 12
    for point in points[::5]:
        values = {**asked.values, asked.name: point.value}
        found = orbit_at(pairs.system(values), point.state * (1.0 + 1e-7), asked.period)
        assert found is not None
        assert np.abs(found.state - point.state).max() < 1e-11
        assert np.abs(np.sort(np.abs(found.multipliers)) - np.sort(np.abs(point.multipliers))).max() < 1e-9
        assert sorted(point.extrema) == pytest.approx(sorted(found.extrema.displacement), abs=1e-10)
