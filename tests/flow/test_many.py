"""Many motions at once: each is the one that goes alone, to the last bit, for any number of threads."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from gearlash import flow
from gearlash.case import load
from gearlash.flow import _ensemble, many
from gearlash.flow._lanes import MOST_MOTIONS
from gearlash.flow.propagators import Propagators
from gearlash.flow.run import block_of
from gearlash.system import ContactRule, GearlashError, Status
from oracles.flow_facts import eight_as_alone
from oracles.members import random_member, random_start
from oracles.oscillators import oscillator, side_by_side


def _same_as_alone(props: Propagators, states: np.ndarray, stretches: int, stretch: int = 1) -> None:
    alone = [flow.march(props, state, stretches, stretch) for state in states]
    for threads in (1, 2, 3):
        found = flow.march_many(props, states, stretches, stretch, threads=threads)
        assert found.states.shape == (stretches + 1, *states.shape)
        for i, one in enumerate(alone):
            assert found.states[:, i].tobytes() == one.states.tobytes()
            assert found.contacts[:, i].tobytes() == one.contacts.tobytes()
            assert found.undecided[i] == one.undecided
            assert found.statuses[i] is one.status


@pytest.mark.parametrize(
    ("omega", "D"),
    [(1.05, 1.0), (0.95, 1.0), (0.78, 0.38), (0.78, 0.6), (0.78, 0.25), (0.5, 0.05), (1.112006, 1.0)],
)
def test_pairs_from_the_attractor_and_from_all_over(omega: float, D: float):
    family = load("article-first-harmonic").family()[0]
    props = flow.propagators(family.system({"omega": omega, "D": D}))
    rng = np.random.default_rng(3)
    settled = flow.march(props, family.start({"omega": omega, "D": D}), 600).states[-12:]
    scattered = settled[-1] + rng.normal(scale=0.5, size=(9, settled.shape[1]))
    _same_as_alone(props, np.concatenate([settled, scattered]), 60)
    _same_as_alone(props, scattered, 7, 3)


def test_as_many_as_go_together_fewer_and_more():
    """Blocks that are full and that are not, and more motions than one call takes."""
    props = flow.propagators(oscillator(omega=0.8, stiffness=(3.0, 2.0), damping=0.05, force=(0.2, 1.0, 0.3)))
    states = np.random.default_rng(5).standard_normal((2 * MOST_MOTIONS + 9, 2))
    for count in (0, 1, 2, 7, 8, 9, 17, *(MOST_MOTIONS + i for i in (-1, 0, 1)), 2 * MOST_MOTIONS + 9):
        _same_as_alone(props, states[:count], 25)


def test_one_side_only_and_sides_that_are_not_alike():
    rng = np.random.default_rng(11)
    for stiffness in ((4.0, 0.0), (0.0, 4.0), (1.0, 30.0)):
        system = oscillator(
            omega=1.1, gap=(0.2, 0.5), stiffness=stiffness, damping=0.1, force=(0.3, 1.0, 0.2)
        )
        _same_as_alone(flow.propagators(system), rng.standard_normal((11, 2)), 40)


@pytest.mark.jit_and_nojit
def test_compiled_or_not_eight_are_as_alone():
    eight_as_alone()


def test_what_cannot_go_together_goes_one_after_the_other():
    """Other rules, and several gaps."""
    one = oscillator(omega=1.1, gap=(0.2, 0.5), stiffness=(4.0, 3.0), damping=0.2, force=(0.3, 1.0, 0.2))
    rng = np.random.default_rng(13)
    for rule in (ContactRule.IN_CONTACT, ContactRule.NO_TENSION):
        system = replace(one, clearances=(replace(one.clearances[0], contact=rule),))
        _same_as_alone(flow.propagators(system), rng.standard_normal((5, 2)), 20)
    _same_as_alone(flow.propagators(side_by_side(one, one)), rng.standard_normal((5, 4)), 20)


@pytest.mark.parametrize("size", [2, 3, 6, 7, 8, 11, 15, 16, 24])
def test_random_systems_of_any_size(size: int):
    """Series of the gap's offset, base periods of several cycles, blocks that are full and that are not."""
    for seed in range(3):
        rng = np.random.default_rng([size, seed])
        system, start = random_member(rng, size, 1, (ContactRule.ALWAYS,))
        states = np.array([start, *(random_start(rng, system) for _ in range(9))])
        _same_as_alone(flow.propagators(system), states, 12)


def test_blocks_of_a_long_march_and_motions_that_end():
    """More periods than one call takes; some motions are torn apart on the way."""
    props = flow.propagators(
        oscillator(omega=2.5, stiffness=(-0.02, -0.02), ground=(0.5, 0.001), force=(0.0, 0.1, 0.0))
    )
    states = np.random.default_rng(17).standard_normal((9, 2))
    _same_as_alone(props, states, 4_100)
    torn = flow.propagators(
        oscillator(omega=0.5, gap=(5.0, 5.0), stiffness=(-60.0, -60.0), ground=(1.0, 0.0))
    )
    starts = np.linspace(0.0, 9.0, 10)[:, None] * [1.0, 0.0]
    found = flow.march_many(torn, starts, 30)
    assert {status.ok for status in found.statuses} == {True, False}
    _same_as_alone(torn, starts, 30)


def test_a_touch_within_rounding_is_counted():
    """At rest on the boundary: undecided, here and there."""
    props = flow.propagators(oscillator(gap=(0.5, 0.5), force=(0.0, 0.0, 0.0), damping=0.1))
    states = np.zeros((9, 2))
    states[4] = 0.5, 0.0
    found = flow.march_many(props, states, 3)
    assert found.statuses[4] is flow.march(props, states[4], 3).status
    _same_as_alone(props, states, 3)
    assert Status.OK in found.statuses


def test_side_by_side_is_what_is_used(monkeypatch: pytest.MonkeyPatch):
    """The comparisons above compare two things."""
    calls = []
    kernel = _ensemble.march_ensemble
    monkeypatch.setattr(_ensemble, "march_ensemble", lambda *a: calls.append(len(a[4])) or kernel(*a))
    props = flow.propagators(oscillator(force=(0.1, 0.4, 0.0), damping=0.05))
    flow.march_many(props, np.ones((MOST_MOTIONS + 18, 2)), 5)
    assert calls == [MOST_MOTIONS, 18]


def test_a_call_is_short_enough_to_be_interrupted(monkeypatch: pytest.MonkeyPatch):
    """A slow system has many cells a period: fewer motions go together then, and are the same."""
    calls = []
    kernel = _ensemble.march_ensemble
    monkeypatch.setattr(_ensemble, "march_ensemble", lambda *a: calls.append((len(a[4]), a[7])) or kernel(*a))
    props = flow.propagators(oscillator(omega=0.02, force=(0.1, 0.4, 0.0), damping=0.05))
    states = np.random.default_rng(19).standard_normal((20, 2))
    _same_as_alone(props, states, 2_000)
    long = [motions for motions, periods in calls if periods == block_of(props, 1)]
    assert 0 < max(long) < len(states)
    assert all(
        motions * periods * props.cells <= many.CELLS_PER_CALL or motions <= 8 for motions, periods in calls
    )


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ({"start": np.zeros(2)}, "expected (motions, 2)"),
        ({"start": np.zeros((3, 5))}, "expected (motions, 2)"),
        ({"start": [[1.0, 2.0], [3.0]]}, "expected numbers of shape (motions, 2)"),
        ({"start": [[np.nan, 0.0]]}, "NaN"),
        ({"threads": 0}, "threads is 0"),
        ({"threads": 1.5}, "threads is 1.5"),
        ({"stretches": -1}, "stretches is -1"),
        ({"stretch": 0}, "stretch is 0"),
        ({"system": "kahraman-singh"}, "system: expected a System"),
    ],
)
def test_arguments_that_do_not_fit(arguments: dict, told: str):
    fitting = {"system": flow.propagators(oscillator()), "start": np.zeros((3, 2)), "stretches": 5}
    with pytest.raises(GearlashError) as raised:
        flow.march_many(**(fitting | arguments))
    assert told in str(raised.value)


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ({"start": np.zeros(3)}, "start has shape (3,), expected (2,)"),
        ({"start": "rest"}, "expected numbers of shape (2,), not 'rest'"),
        ({"stretches": 1.5}, "stretches is 1.5: expected a whole number, 0 or more"),
        ({"stretches": 10**15}, "GiB, more than there is"),
        ({"stretch": "2"}, "stretch is '2': expected a whole number, 1 or more"),
        (
            {"system": load("article-first-harmonic")},
            "expected a System, as from family.system()",
        ),
    ],
)
def test_arguments_of_one_march_that_do_not_fit(arguments: dict, told: str):
    fitting = {"system": flow.propagators(oscillator()), "start": np.zeros(2), "stretches": 5}
    with pytest.raises(GearlashError) as raised:
        flow.march(**(fitting | arguments))
    assert told in str(raised.value)


def test_a_gap_of_no_width_has_tables_before_motions_go_side_by_side():
    """They pass through it, and kernels do not ask whether a region is there."""
    system = oscillator(omega=0.9, gap=(0.0, 0.0), stiffness=(1.0, 9.0), damping=0.1, force=(0.1, 0.3, 0.0))
    props = flow.propagators(system)
    flow.march_many(props, np.zeros((9, 2)), 1)
    assert (props.tables.slot_of >= 0).all()
