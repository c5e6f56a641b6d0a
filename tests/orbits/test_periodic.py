"""Periodic attractors: signature, proved period, residual; against heyoka and against closed forms."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from gearlash import flow
from gearlash.orbits import Orbit, Settings, Signature, attractor, shoot
from gearlash.orbits.shooting import minimal
from gearlash.studies import summary
from gearlash.system import Family, GearlashError, Status
from oracles.impacts import exact_impacts
from orbits.members import article, built, cold, count_by_marching, displaced, one_dof, orbit

# ω, D → label of the cold start of the article's pair; heyoka confirms each below.
ARTICLE = {
    (1.047, 1.0): "1-0-0",
    (0.942, 1.0): "1-1-0",
    (1.11, 1.0): "2-1-0",
    (0.83, 1.0): "3-3-0",
    (0.78, 0.5): "6-6-0",
    (0.78, 0.386): "6-6-1",
    (0.78, 0.39): "6-6-2",
    (0.78, 0.382): "12-12-2",
    (0.78, 0.375): "12-12-3",
}
# Pairs of one degree of freedom: overrides of the mild pair (all of constant stiffness) → label.
SPUR = {
    (("omega", 0.83), ("D", 0.06), ("error", 0.04)): "1-0-0",
    (("omega", 1.35), ("D", 0.13), ("error", 0.08)): "1-1-0",
    (("omega", 0.67), ("D", 0.06), ("error", 0.17)): "1-1-1",
    (("omega", 1.18), ("D", 0.68), ("error", 0.11)): "2-2-0",
    (("omega", 1.27), ("D", 0.87), ("error", 0.13)): "4-2-0",
    (("omega", 1.39), ("D", 0.61), ("error", 0.36)): "6-4-4",
    (("omega", 0.98), ("D", 0.27), ("error", 0.21)): "8-6-6",
}


def is_periodic(found: Orbit) -> None:
    """What every orbit that is returned must hold."""
    assert found.status is Status.OK
    assert found.residual <= 1e-11
    assert found.stable
    assert len(found.strobes) == found.shot.period
    props, period = found.propagators, found.shot.period
    back = flow.march(props, found.state, period).states
    scale = max(1.0, np.abs(back).max())
    assert np.abs(back[-1] - back[0]).max() <= 1e-11 * scale
    for divisor in range(1, period):
        if period % divisor == 0:
            assert np.abs(back[divisor] - back[0]).max() > 1e-6 * scale, f"it closes after {divisor} already"
    assert count_by_marching(props, found.state, period) == (found.signature.drive, found.signature.back)


@pytest.mark.parametrize(("place", "label"), ARTICLE.items(), ids=str)
def test_labels_of_the_article_case(truth, place, label):
    found = orbit(article(), omega=place[0], D=place[1])
    assert found.label == label
    is_periodic(found)
    run = truth(found.propagators.system).run(found.propagators.system, found.state, float(found.period))
    assert np.abs(run.state - found.state).max() <= 1e-11
    counts = (run.crossings.count((1, True)), run.crossings.count((-1, True)))
    assert counts == (found.signature.drive, found.signature.back)


@pytest.mark.parametrize("place", [(0.942, 1.0), (0.78, 0.386)], ids=str)
def test_cold_start_runs_into_it_by_another_method(truth, place):
    """heyoka from the cold start ends on the orbit."""
    found = orbit(article(), omega=place[0], D=place[1])
    system = found.propagators.system
    run = truth(system, variational=False).run(system, article().start({"D": place[1]}), 600.0)
    assert np.abs(found.strobes - run.state.astype(float)).max(axis=1).min() < 1e-7


@pytest.mark.parametrize(("place", "label"), SPUR.items(), ids=str)
def test_labels_of_one_degree_of_freedom(place, label):
    """Constant stiffness: the orbit closes, and has these impacts, in closed form."""
    found = orbit(one_dof(), **dict(place))
    assert found.label == label
    is_periodic(found)
    end, crossings = exact_impacts(found.propagators.system, found.state, found.period)
    assert max(abs(float(e) - s) for e, s in zip(end, found.state, strict=True)) < 1e-11
    engaging = [boundary for _, boundary, engages, _ in crossings if engages]
    assert (engaging.count(1), engaging.count(-1)) == (found.signature.drive, found.signature.back)


@pytest.mark.parametrize("times", [2, 3, 6])
@pytest.mark.parametrize(
    ("family", "place"),
    [
        (article, {"omega": 0.942}),
        (article, {"omega": 0.83}),
        (article, {"omega": 0.78, "D": 0.386}),
        (one_dof, {"omega": 1.18, "D": 0.68, "error": 0.11}),
    ],
    ids=["1-1-0", "3-3-0", "6-6-1", "spur 2-2-0"],
)
def test_least_period_is_found(family, place, times):
    """Newton for 2P, 3P, 6P, from beside the orbit, comes back to P."""
    found = orbit(family(), **place)
    props, period = found.propagators, found.shot.period
    rng = np.random.default_rng(times)
    guess = found.state + 1e-4 * rng.normal(size=len(found.state))
    shot = shoot(props, guess, times * period)
    assert shot.residual <= 1e-11
    assert shot.period == times * period
    least = minimal(props, shot)
    assert least.period == period
    assert least.residual <= 1e-11
    assert np.abs(found.strobes - least.state).max(axis=1).min() < 1e-9


def test_a_doubled_orbit_is_not_halved():
    """12-12-2 lies beside 6-6-1: its least period is 12 though it nearly closes after 6."""
    found = orbit(article(), omega=0.78, D=0.3823)
    assert found.label == "12-12-2"
    near = np.abs(found.strobes[6] - found.strobes[0]).max()
    assert 1e-4 < near < 0.1
    again = minimal(found.propagators, shoot(found.propagators, found.state, 12))
    assert again.period == 12


def test_trial_orbit_of_a_neighbour_gives_the_same_orbit():
    """Following: the neighbour's orbit as a trial, to the same attractor as without."""
    neighbour = orbit(article(), omega=0.78, D=0.386)
    props = built(article(), omega=0.78, D=0.387)
    followed = attractor(props, neighbour.state, trial=(neighbour.state, 6))
    free = attractor(props, neighbour.state)
    assert isinstance(followed, Orbit)
    assert isinstance(free, Orbit)
    assert followed.periods_used == 0
    assert followed.label == free.label == "6-6-1"
    assert np.abs(free.strobes - followed.state).max(axis=1).min() < 1e-9


def test_trial_period_that_is_a_multiple_is_reduced():
    found = orbit(article(), omega=0.942)
    again = attractor(found.propagators, found.state, trial=(found.state, 4))
    assert isinstance(again, Orbit)
    assert again.period == 1


def test_coexisting_attractors():
    """ω = 1.11: cold start 2-1-0; 1-0-0 followed up from ω = 1.05. Each start keeps its own."""
    assert cold(article(), omega=1.11).label == "2-1-0"
    values = np.linspace(1.05, 1.11, 7)
    followed = orbit(article(), omega=1.05)
    for _, value in pairwise(values):
        found = attractor(built(article(), omega=value), followed.state, trial=(followed.state, 1))
        assert isinstance(found, Orbit)
        followed = found
    assert followed.label == "1-0-0"
    is_periodic(followed)
    free = attractor(followed.propagators, followed.state + 1e-3)
    assert free.label == "1-0-0"


def test_a_motion_that_wanders_by_is_not_taken_for_captured():
    """Two attractors and a long irregular transient that passes near 4-2-2 on its way to 24-12-12."""
    family = one_dof(ripple=0.2)
    values = {
        "omega": 1.2162286037947787,
        "D": 0.8113663988054419,
        "ripple": 0.11123965592815038,
        "error": 0.29465208334344906,
        "mesh_damping": 0.010285019839497672,
        "load": 0.17596503715553274,
    }
    props, start = built(family, **values), np.array([0.9730805642597203, -0.00025823080254307613])
    found = attractor(props, start)
    assert isinstance(found, Orbit)
    end = flow.march(props, start, 12_000).states[-1]
    assert np.abs(found.strobes - end).max(axis=1).min() < 1e-6, f"the motion does not end on {found.label}"


def test_period_in_mesh_cycles_of_a_longer_base_period():
    """Base period of two mesh cycles: P counts mesh cycles."""
    found = orbit(article(), omega=0.83)
    system = found.propagators.system

    def spread(series):
        out = np.zeros((*series.shape[:-1], 5))
        out[..., 0], out[..., 3], out[..., 4] = series[..., 0], series[..., 1], series[..., 2]
        return out

    (c,) = system.clearances
    stiffness = spread(c.stiffness_plus)
    longer = replace(
        system,
        forcing=spread(system.forcing),
        clearances=(replace(c, stiffness_plus=stiffness, stiffness_minus=stiffness),),
        cycles=2,
    )
    same = attractor(longer, found.state)
    assert isinstance(same, Orbit)
    assert same.label == "6-6-0"  # 3 base periods of 2 mesh cycles
    assert same.shot.period == 3
    assert abs(same.largest_exponent - found.largest_exponent) < 1e-12
    assert np.abs(np.sort_complex(same.multipliers) - np.sort_complex(found.multipliers**2)).max() < 1e-12


UNEQUAL = one_dof(back_stiffness=2.5, back_gap=0.4, ripple=0.1)


@pytest.mark.parametrize(
    ("place", "label"),
    [
        ({"omega": 0.66, "D": 0.73, "error": 0.35}, "1-1-1"),
        ({"omega": 1.52, "D": 0.24, "error": 0.12}, "2-1-1"),
        ({"omega": 1.27, "D": 0.33, "error": 0.31}, "8-8-4"),
    ],
    ids=lambda value: value if isinstance(value, str) else "",
)
def test_unequal_sides(truth, place, label):
    found = orbit(UNEQUAL, **place)
    assert found.label == label
    is_periodic(found)
    system = found.propagators.system
    assert system.clearances[0].gap_minus == pytest.approx(0.4 * system.clearances[0].gap_plus)
    run = truth(system).run(system, found.state, float(found.period))
    assert np.abs(run.state - found.state).max() <= 1e-11


def test_a_side_without_stiffness_is_no_stop():
    """Σ2 is passed, nothing is hit there: R = 0, and moving that boundary changes nothing."""
    family = one_dof(back_stiffness=0.0, ripple=0.2)
    found = orbit(family, omega=0.88, D=0.22, error=0.35)
    assert found.extrema.displacement.min() < -0.22
    assert found.events.boundary.min() == 1
    assert found.signature == Signature(12, 7, 0)
    wide = attractor(
        built(family, omega=0.88, D=0.22, error=0.35, back_gap=1e3), family.start({"D": 0.22, "error": 0.35})
    )
    assert wide.label == found.label
    assert np.abs(wide.strobes - found.strobes).max() < 1e-9
    near, far = summary(found), summary(wide)
    assert (len(near.back_force), len(near.back_release_force), len(near.drive_force)) == (0, 0, 7)
    assert near.share_without_contact == pytest.approx(far.share_without_contact, abs=1e-9)


@pytest.mark.parametrize(
    "place",
    [
        {"omega": 0.78, "D": 0.386},
        {"omega": 0.78, "D": 0.375},
        {"omega": 0.942, "D": 1.0},
    ],
    ids=str,
)
def test_mirror_swaps_the_sides(place):
    """f_m and E negated: X → −X, and Q and R change places."""
    family = article()
    found = orbit(family, **place)
    mirrored = {**place, "load": -0.09, "error": -family.defaults["error"]}
    other = attractor(built(family, **mirrored), -found.state)
    assert isinstance(other, Orbit)
    signature = found.signature
    assert other.signature == Signature(signature.period, signature.back, signature.drive)
    assert np.abs(other.strobes + found.strobes).max() < 1e-9
    assert np.abs(other.multipliers - found.multipliers).max() < 1e-9
    cold_one = cold(family, **mirrored)
    assert cold_one.label == other.label


@pytest.mark.parametrize("seed", range(6))
def test_starts_may_differ_attractors_are_attractors(seed):
    """From far starts: whatever is found, the motion of that start is on it after a long march."""
    family = article() if seed % 2 else one_dof(ripple=0.25, mesh_damping=0.02)
    values = {"omega": (0.9, 0.78, 1.25, 0.7, 1.4, 0.6)[seed], "D": (1.0, 0.5, 0.3, 1.0, 0.6, 0.8)[seed]}
    props, start = built(family, **values), displaced(family, seed, **values)
    found = attractor(props, start)
    if isinstance(found, Orbit):
        is_periodic(found)
        end = flow.march(props, start, 6_000).states[-1]
        assert np.abs(found.strobes - end).max(axis=1).min() < 1e-6
    else:
        states = flow.march(props, flow.march(props, start, 6_000).states[-1], 200).states
        returns = [np.abs(states[p:] - states[:-p]).max() for p in range(1, 65)]
        assert min(returns) > 1e-6, f"{found.label}, but it closes after {np.argmin(returns) + 1}"


def test_scaling_keeps_label_and_multipliers():
    """(f_m, E, D) → s (f_m, E, D)."""
    family, factor = article(), 7.3
    found = orbit(family, omega=0.78, D=0.386)
    scaled = {"omega": 0.78, "D": 0.386 * factor, "load": 0.09 * factor}
    scaled["error"] = family.defaults["error"] * factor
    other = attractor(built(family, **scaled), factor * found.state)
    assert isinstance(other, Orbit)
    assert other.label == found.label
    assert np.abs(other.strobes / factor - found.strobes).max() < 1e-10
    assert np.abs(other.multipliers - found.multipliers).max() < 1e-10


def test_one_boundary_knows_no_backlash():
    """Beyond its last back-side contact an orbit's X − D and multipliers do not depend on D."""
    one, other = orbit(article(), omega=0.78, D=0.5), orbit(article(), omega=0.78, D=0.9)
    assert one.label == other.label == "6-6-0"
    shifted = other.strobes.copy()
    shifted[:, 8] += 0.5 - 0.9
    far = min(np.abs(np.roll(shifted, k, axis=0) - one.strobes).max() for k in range(6))
    assert far < 1e-11
    assert np.abs(one.multipliers - other.multipliers).max() < 1e-11


def test_a_period_beyond_those_looked_for_is_named():
    """96-96-24 at D = 0.37: not found up to 64, its period is named, and found when allowed."""
    props, start = built(article(), omega=0.78, D=0.37), article().start({"D": 0.37})
    short = attractor(props, start, Settings(budget=4_000))
    assert short.label == "unresolved"
    assert short.status is Status.UNRESOLVED
    assert "stable orbit of 96 base periods" in short.message
    long = attractor(props, start, Settings(max_period=128))
    assert long.label == "96-96-24"
    assert isinstance(long, Orbit)
    is_periodic(long)


@pytest.mark.parametrize(
    ("text", "parts"), [("6-6-1", (6, 6, 1)), ("1-0", (1, 0, 0)), ("12-12-3", (12, 12, 3))]
)
def test_signature_reads_what_it_prints(text, parts):
    signature = Signature.parse(text)
    assert (signature.period, signature.drive, signature.back) == parts
    assert signature.short == text
    assert Signature.parse(str(signature)) == signature


@pytest.mark.parametrize("text", ["", "6", "6-6-1-0", "a-b", "6--1", "6-6.5", "-1-1", "aperiodic"])
def test_signature_refuses_what_is_none(text):
    with pytest.raises(GearlashError, match="P-Q"):
        Signature.parse(text)


@pytest.mark.parametrize(
    "bad", [np.zeros(3), np.full(10, np.nan), np.full(10, np.inf)], ids=["short", "nan", "inf"]
)
def test_a_start_that_is_no_state_is_refused(bad):
    with pytest.raises(GearlashError, match="start"):
        attractor(built(article()), bad)


def test_a_motion_that_runs_away_says_so():
    """Negative damping: no attractor, no number pretends to be one."""
    family: Family = article()
    system = family.system({"omega": 0.9})
    grows = replace(system, matrix=system.matrix + 0.3 * np.eye(10))
    found = attractor(grows, family.start({}))
    assert found.label == "unresolved"
    assert found.status is Status.DIVERGED
    assert found.status.advice not in found.message
