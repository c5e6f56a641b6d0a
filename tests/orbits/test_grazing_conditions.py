"""The article's four grazing conditions at every extremum of the gap."""

from __future__ import annotations

import numpy as np
import pytest

from gearlash import flow
from gearlash.branches import locate_grazing
from gearlash.orbits import GrazingCheck, Orbit, Shot, attractor, grazing_checks
from gearlash.system import Status
from orbits.members import article, built, cold, one_dof, orbit

PLACES = [
    (article, {"omega": 0.942}),
    (article, {"omega": 0.83}),
    (article, {"omega": 0.78, "D": 0.39}),
    (article, {"omega": 0.78, "D": 0.375}),
    (one_dof, {"omega": 1.39, "D": 0.61, "error": 0.36}),
]
NAMES = [f"{family.__name__}-{'-'.join(map(str, place.values()))}" for family, place in PLACES]


@pytest.fixture(params=PLACES, ids=NAMES)
def found(request) -> Orbit:
    family, place = request.param
    return orbit(family(), **place)


def gap_at(found: Orbit, phase: float) -> float:
    """X at a phase, by carrying the orbit's state there."""
    state = flow.carry(found.propagators, found.state, phase).state
    return float(found.propagators.system.clearances[0].h @ state)


def test_every_extremum_is_checked_against_both_boundaries(found):
    checks = grazing_checks(found)
    assert len(checks) == 2 * len(found.extrema)
    distances = [abs(check.distance) for check in checks]
    assert distances == sorted(distances)
    (c,) = found.propagators.system.clearances
    for check in checks:
        edge = c.gap_plus if check.boundary > 0 else -c.gap_minus
        assert check.displacement == found.extrema.displacement[check.index]
        assert check.distance == check.displacement - edge
        assert check.gradient == 1.0


def test_velocity_vanishes_and_a0_is_the_curvature(found):
    """X′ = 0 to rounding; a0 is the second difference of X, by marching."""
    omega, step = found.propagators.system.omega, 2e-4
    scale = max(1.0, np.abs(found.extrema.displacement).max())
    for check in grazing_checks(found):
        assert abs(check.velocity) <= 1e-14 * scale
        if check.boundary < 0:
            continue  # the same extremum once more
        low, middle, high = (gap_at(found, check.phase + d) for d in (-step, 0.0, step))
        assert middle == pytest.approx(check.displacement, abs=1e-11)
        second = (low - 2 * middle + high) / (step * 2 * np.pi / omega) ** 2
        assert second == pytest.approx(check.a0, abs=2e-5 + 2e-3 * abs(check.a0))


def test_extrema_are_all_of_them(found):
    """Between neighbours X is monotone: minima and maxima alternate, and no sample exceeds them."""
    extrema = found.extrema
    order = np.argsort(extrema.phase)
    curvature = extrema.curvature[order]
    assert len(extrema) % 2 == 0
    assert (np.sign(curvature) == -np.sign(np.roll(curvature, 1))).all()
    samples = found.trace.samples(4_001)
    assert samples.displacement.max() <= extrema.displacement.max() + 1e-12
    assert samples.displacement.min() >= extrema.displacement.min() - 1e-12
    turns = np.sum(np.diff(np.sign(np.diff(samples.displacement[:-1], append=samples.displacement[0]))) != 0)
    assert abs(int(turns) - len(extrema)) <= 1  # one may lie at the seam


def test_within_keeps_the_near_ones(found):
    near = grazing_checks(found, within=0.15)
    assert all(abs(check.distance) <= 0.15 for check in near)
    assert near == grazing_checks(found)[: len(near)]


KINDS = {
    (1, "loss"): ({"omega": 0.98}, "omega", "loss of contact on the drive side (minimum of X in S1)", 1.0),
    (-1, "engagement"): (
        {"omega": 0.78, "D": 0.389},
        "D",
        "engagement on the back side (minimum of X in S2)",
        1.0,
    ),
    (-1, "loss"): ({"omega": 0.98}, "omega", "loss of contact on the back side (maximum of X in S3)", -1.0),
    (1, "engagement"): (
        {"omega": 0.78, "D": 0.389},
        "D",
        "engagement on the drive side (maximum of X in S2)",
        -1.0,
    ),
}


@pytest.mark.parametrize(("boundary", "what"), KINDS)
def test_the_four_kinds(boundary, what):
    """Loss of contact and engagement on either side; the mirrored pair (f_m < 0) has them on the other."""
    place, name, kind, sign = KINDS[boundary, what]
    family = article()
    mirrored = {**place, "load": sign * 0.09, "error": sign * family.defaults["error"]}
    start = attractor(built(family, **mirrored), sign * orbit(family, **place).state)
    assert isinstance(start, Orbit)
    check = next(c for c in grazing_checks(start) if c.boundary == boundary)
    assert check.kind == kind
    point = locate_grazing(family, name, start, check, values=family.complete(mirrored))
    assert point.status is Status.OK
    assert point.kind == kind
    assert (point.a0 > 0) == (check.a0 > 0)
    unmirrored = locate_grazing(
        family,
        name,
        orbit(family, **place),
        next(c for c in grazing_checks(orbit(family, **place)) if c.boundary == sign * boundary),
        values=family.complete(place),
    )
    assert point.value == pytest.approx(unmirrored.value, rel=1e-12)
    assert point.a0 == pytest.approx(sign * unmirrored.a0, rel=1e-7)


def test_conditions_hold_at_the_point_and_nowhere_else():
    start = orbit(article(), omega=0.98)
    assert not any(check.holds() for check in grazing_checks(start))
    point = locate_grazing(
        article(), "omega", start, grazing_checks(start)[0], values=article().complete({"omega": 0.98})
    )
    props = built(article(), omega=point.value)
    shot = Shot(point.state_zero, 1, 0.0, np.eye(10), 0.0, 0, Status.OK)
    checks = grazing_checks(Orbit(props, shot, 0, Status.OK, ""))
    holding = [check for check in checks if check.holds()]
    assert len(holding) == 1
    assert holding[0] is checks[0]
    assert holding[0].phase == pytest.approx(point.phase, abs=1e-9)
    assert holding[0].a0 == pytest.approx(point.a0, rel=1e-6)
    assert holding[0].boundary == 1


@pytest.mark.parametrize(
    "changed",
    [{"distance": 1e-6}, {"gradient": 0.0}, {"velocity": 1e-6}, {"a0": 0.0}],
    ids=lambda changed: next(iter(changed)),
)
def test_each_condition_counts(changed):
    met = {"distance": 0.0, "gradient": 1.0, "velocity": 0.0, "a0": 0.1}
    rest = {"phase": 0.3, "boundary": 1, "displacement": 1.0, "index": 0}
    assert GrazingCheck(**met, **rest).holds()
    assert not GrazingCheck(**{**met, **changed}, **rest).holds()


def test_of_a_motion_that_does_not_repeat():
    """The conditions are evaluated on the stretch that is kept, too."""
    found = cold(article(), omega=0.78, D=0.3)
    checks = grazing_checks(found, within=0.05)
    assert checks
    assert all(abs(check.velocity) <= 1e-13 for check in checks)
