"""Motions that do not repeat: chaos, quasi-periodic motion, their exponents; and what is not one of them."""

from __future__ import annotations

import numpy as np
import pytest

from gearlash import flow
from gearlash.orbits import Aperiodic, Orbit, Settings, Unresolved, attractor, lyapunov, sections, shoot
from gearlash.system import Status
from orbits.members import article, built, cold, one_dof, orbit

CHAOS = [
    (article, {"omega": 0.78, "D": 0.3}),
    (article, {"omega": 0.6}),
    (article, {"omega": 0.78, "D": 0.2}),
    (one_dof, {"omega": 1.35, "D": 0.56, "error": 0.22}),
]
NAMES = ["D = 0.3", "omega = 0.6", "D = 0.2", "one degree of freedom"]


def divergence(system) -> float:
    (c,) = system.clearances
    return float(np.trace(system.matrix) + c.damping * (c.h @ system.matrix @ c.g))


@pytest.mark.parametrize(("family", "place"), CHAOS, ids=NAMES)
def test_chaos(family, place):
    found = cold(family(), **place)
    assert type(found) is Aperiodic
    assert found.label == "aperiodic"
    assert found.status is Status.OK
    assert found.largest_exponent > found.exponent_error > 0.0
    for name in ("period", "signature", "multipliers", "residual"):
        assert not hasattr(found, name), f"a motion that does not repeat has no {name}"
    assert "exponent" in found.message


@pytest.mark.parametrize(("family", "place"), CHAOS, ids=NAMES)
def test_trace_identity_in_chaos(family, place):
    """The sum of the whole spectrum is the divergence of the field, exactly, whatever the motion."""
    found = cold(family(), **place)
    spectrum = lyapunov(found.propagators, found.final_state, 2_400)
    expected = divergence(found.propagators.system)
    assert abs(spectrum.values.sum() - expected) <= 1e-10 * abs(expected)
    assert abs(spectrum.trace_defect) <= 1e-10 * abs(expected)
    assert (np.diff(spectrum.values) <= 0.0).all()
    assert spectrum.values[0] > spectrum.errors[0]


@pytest.mark.parametrize("seed", [1, 2])
def test_exponent_from_two_neighbours(seed):
    """Another method: the growth of a small difference, put back to its size after every period."""
    found = cold(article(), omega=0.78, D=0.3)
    props, z = found.propagators, found.final_state
    rng = np.random.default_rng(seed)
    size, periods, growth = 1e-7, 2_000, 0.0
    other = z + size * rng.normal(size=10) / 4
    for _ in range(periods):
        z, other = (flow.march(props, state, 1).states[-1] for state in (z, other))
        far = np.linalg.norm(other - z)
        growth += np.log(far / size)
        other = z + (other - z) * size / far
    rate = growth / (periods * props.system.period)
    average = lyapunov(props, found.final_state, 3_000, count=1)
    assert abs(rate - average.values[0]) < 3 * average.errors[0] + 5e-4


def test_quasi_periodic_with_default_settings():
    """ω = 0.875: largest exponent zero within its bar, recognised as a motion that does not close."""
    found = cold(article(), omega=0.875)
    assert type(found) is Aperiodic
    assert found.label == "aperiodic"
    assert found.status is Status.OK
    assert abs(found.largest_exponent) <= 2 * found.exponent_error
    assert found.exponent_error < 1e-3
    assert "quasi-periodic" in found.message
    spectrum = lyapunov(found.propagators, found.final_state, 1_000)
    assert abs(spectrum.values[0]) <= 2 * spectrum.errors[0]
    assert spectrum.values[1] < -5e-3  # a two-torus: one zero besides the phase's
    points = flow.march(found.propagators, found.final_state, 3_000).states
    returns = [np.abs(points[p:] - points[:-p]).max() for p in range(1, 257)]
    assert min(returns) > 1e-4


@pytest.mark.parametrize(
    "place",
    [
        {"omega": 1.047},
        {"omega": 0.942},
        {"omega": 0.83},
        {"omega": 0.78, "D": 0.39},
        {"omega": 0.78, "D": 0.375},
    ],
    ids=str,
)
def test_average_on_a_periodic_orbit_is_its_multipliers(place):
    """The QR average agrees with ln|μ|/(P T) within its bar; the two ends are worth a factor of order one."""
    found = orbit(article(), **place)
    periods = 1_200
    average = lyapunov(found.propagators, found.state, periods)
    ends = 1.0 / (periods * found.propagators.system.period)
    assert (np.abs(average.values - found.exponents) <= average.errors + ends).all()
    assert average.values.sum() == pytest.approx(found.exponents.sum(), rel=1e-10)


def test_error_bar_shrinks_and_covers():
    """Longer averages have smaller bars; short ones that do not overlap stay within theirs of a long one."""
    found = cold(article(), omega=0.78, D=0.3)
    props, z = found.propagators, found.final_state
    long = lyapunov(props, z, 20_000, count=1)
    covered, errors = 0, []
    for _ in range(12):
        short = lyapunov(props, z, 1_000, count=1)
        z = short.final_state
        covered += abs(short.values[0] - long.values[0]) <= short.errors[0] + long.errors[0]
        errors.append(short.errors[0])
    assert covered >= 9
    assert long.errors[0] < 0.5 * np.mean(errors)


def test_first_exponents_do_not_depend_on_how_many():
    found = cold(article(), omega=0.78, D=0.3)
    few = lyapunov(found.propagators, found.final_state, 2_000, count=2)
    all_ = lyapunov(found.propagators, found.final_state, 2_000)
    assert len(few.values) == 2
    assert len(all_.values) == 10
    assert np.isnan(few.trace_defect)
    assert (np.abs(few.values - all_.values[:2]) <= few.errors + all_.errors[:2]).all()


def test_the_same_start_gives_the_same_bytes():
    one, other = (
        attractor(built(article(), omega=0.78, D=0.3), article().start({"D": 0.3})) for _ in range(2)
    )
    assert one.largest_exponent == other.largest_exponent
    assert (one.final_state == other.final_state).all()


def test_sections_of_a_motion_that_does_not_repeat():
    """A stretch of it is kept, with its crossings."""
    found = cold(article(), omega=0.78, D=0.3)
    data = sections(found)
    assert len(data.time) == len(found.strobes) == 200
    assert len(data.drive.entering) > 50
    assert abs(len(data.drive.entering) - len(data.drive.leaving)) <= 1


def test_a_locked_orbit_longer_than_asked_for_is_not_quasi_periodic():
    """53-53-0 at ω = 0.858, when orbits are looked for up to 40 only."""
    props, start = built(article(), omega=0.858), article().start({})
    short = attractor(props, start, Settings(max_period=40))
    assert type(short) is Unresolved
    assert "53 base periods" in short.message
    long = attractor(props, start)
    assert isinstance(long, Orbit)
    assert long.label == "53-53-0"


def test_leaving_an_unstable_orbit_is_not_chaos():
    """From beside 1-1-0 past its doubling: an exponent above zero for 1e4 periods, and 2-2-0 in the end."""
    values = {"omega": 1.29395}
    props = built(article(), **values)
    unstable = orbit(article(), omega=1.295)
    shot = shoot(props, unstable.state, 1)
    leading = np.abs(np.linalg.eigvals(shot.monodromy)).max()
    assert 1.0 < leading < 1.001
    escaping = lyapunov(props, shot.state + 1e-6, 1_500, count=1)
    assert escaping.values[0] > 2 * escaping.errors[0]
    for away in (0.0, 1e-9, 1e-6, 1e-4):
        found = attractor(props, shot.state + away)
        assert found.label in ("2-2-0", "unresolved"), found.message
    assert attractor(props, shot.state + 1e-4).label == "2-2-0"


@pytest.mark.parametrize("omega", [1e3, 1e6, 1e9])
def test_periods_that_last_no_time_show_no_quasi_periodic_motion(omega):
    """Twenty thousand of them are far shorter than the motion takes to decay: its neighbours have neither
    left nor come, whatever the average says."""
    found = cold(article(), omega=omega)
    assert type(found) is Unresolved
    assert found.status is Status.UNRESOLVED


@pytest.mark.parametrize("away", [0.0, 1e-6, 2e-6, 3e-6])
def test_patience_outlasts_a_chaotic_transient(away):
    """Some 2,500 periods of chaos on the average, with an exponent like any other, end in 6-4-2."""
    family, values = one_dof(), {"omega": 1.12, "D": 0.82, "error": 0.37}
    props, start = built(family, **values), family.start(values) + away
    assert attractor(props, start, Settings(patience=40_000, budget=60_000)).label == "6-4-2"
    short = attractor(props, start)
    assert short.label in ("6-4-2", "aperiodic")
    assert short.periods_used < 40_000


def test_no_motion_is_called_aperiodic_before_patience():
    props, start = built(article(), omega=0.78, D=0.3), article().start({"D": 0.3})
    for patience in (200, 700, 1_700):
        found = attractor(props, start, Settings(patience=patience))
        assert type(found) is Aperiodic
        assert patience <= found.periods_used


def test_precision_sharpens_the_exponent():
    """Asked for a smaller bar, it is, and both averages agree."""
    props, start = built(article(), omega=0.78, D=0.3), article().start({"D": 0.3})
    rough, sharp = attractor(props, start), attractor(props, start, Settings(precision=0.07))
    assert type(rough) is type(sharp) is Aperiodic
    assert sharp.exponent_error <= 0.07 * sharp.largest_exponent
    assert sharp.exponent_error < rough.exponent_error <= rough.largest_exponent / 3.0
    assert sharp.periods_used > rough.periods_used
    assert abs(rough.largest_exponent - sharp.largest_exponent) <= rough.exponent_error + sharp.exponent_error


@pytest.mark.parametrize(("family", "place"), CHAOS, ids=NAMES)
def test_the_exponent_of_a_search_is_that_of_a_long_average(family, place):
    found = cold(family(), **place)
    long = lyapunov(found.propagators, found.final_state, 12_000, count=1)
    assert abs(found.largest_exponent - long.values[0]) <= found.exponent_error + long.errors[0]
