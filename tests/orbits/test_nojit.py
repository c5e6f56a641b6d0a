"""The kernels as plain Python and compiled: the same motion, contacts and derivative."""

from __future__ import annotations

import numpy as np
import pytest

from gearlash import flow
from gearlash.branches import locate_grazing
from gearlash.orbits import Orbit, grazing_checks, lyapunov, sections, shoot
from gearlash.system import Status
from oracles.closed_forms import spur_grazing_load
from oracles.impacts import exact_impacts
from orbits.members import article, built, one_dof

pytestmark = pytest.mark.jit_and_nojit

PLACE = {"omega": 1.35, "D": 0.13, "error": 0.08}


def solved() -> Orbit:
    """1-1-0 of the mild pair, from a state near it."""
    props = built(one_dof(), **PLACE)
    shot = shoot(props, np.array([0.04, 0.15]), 1)
    assert shot.status is Status.OK
    return Orbit(props, shot, 0, shot.status, "")


def test_motion_and_contacts_in_closed_form():
    family = one_dof()
    system = family.system(PLACE)
    start = np.array([0.2, -0.1])
    trace = flow.trace(flow.propagators(system), start, 2.0)
    end, crossings = exact_impacts(system, start, 2)
    assert np.abs(trace.end - np.array([float(x) for x in end])).max() < 1e-13
    assert len(trace.events) == len(crossings) > 2
    for phase, (exact, boundary, engaging, _) in zip(trace.events.phase, crossings, strict=True):
        assert abs(phase - float(exact)) < 1e-12
        assert boundary in (1, -1)
        assert engaging in (True, False)


def test_orbit_and_multipliers():
    found = solved()
    assert found.label == "1-1-0"
    assert found.residual <= 1e-11
    assert np.log(np.abs(found.multipliers)).sum() == pytest.approx(-0.1 * found.duration, rel=1e-11)
    data = sections(found)
    assert len(data.drive.entering) == len(data.drive.leaving) == 1
    assert np.abs(data.drive.displacement - 0.13).max() <= 1e-14


def test_exponents():
    found = solved()
    average = lyapunov(found.propagators, found.state, 20, settle=5)
    assert average.values.sum() == pytest.approx(-0.1, rel=1e-11)


def test_grazing():
    family, exact = one_dof(), spur_grazing_load(1.3, 0.1, 0.1)
    values = {"omega": 1.3, "load": 1.02 * exact}
    props = built(family, **values)
    shot = shoot(props, family.start(values), 1)
    start = Orbit(props, shot, 0, shot.status, "")
    point = locate_grazing(family, "load", start, grazing_checks(start)[0], values=family.complete(values))
    assert point.status is Status.OK
    assert point.value == pytest.approx(exact, rel=1e-12)


def test_ten_states_and_both_sides(truth):
    """Three cycles of the article's pair, hard against both sides: end, derivative, contacts of heyoka."""
    system = article().system({"omega": 0.78, "D": 0.386})
    props, start = flow.propagators(system), article().start({"D": 0.386})
    start[9] = -0.6
    trace, carried = flow.trace(props, start, 3.0), flow.variational(props, start, 3.0)
    run = truth(system).run(system, start, 3.0)
    assert np.abs(carried.state - trace.end).max() < 1e-14
    assert np.abs(trace.end - run.state).max() < 1e-13
    assert carried.jacobian is not None
    assert np.abs(carried.jacobian - run.jacobian).max() < 1e-12 * np.abs(run.jacobian).max()
    crossings = list(zip(trace.events.boundary.tolist(), trace.events.engaging.tolist(), strict=True))
    assert crossings == run.crossings
    assert {boundary for boundary, _ in crossings} == {1, -1}
    strobes = flow.march(props, start, 3)
    assert np.abs(strobes.states[-1] - trace.end).max() < 1e-14
    assert strobes.contacts[:, 0].sum() == crossings.count((1, True))
