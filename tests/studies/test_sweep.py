"""Sweeps: the same bytes however they are computed, followed attractors, flags, early ends."""

from __future__ import annotations

import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from gearlash import case, results, studies
from gearlash.jobs import Execution, Progress
from gearlash.results import content_hash, sweep_dataset
from gearlash.studies import Axis
from gearlash.system import Family, GearlashError, Parameter, Status, UnknownNameError

ARTICLE = case.load("article-first-harmonic")
CLASSICAL = case.load("kahraman-singh")
SPEEDS = Axis.even("omega", 0.6, 0.9, 16)


@pytest.fixture(scope="module")
def classical():
    return studies.sweeps(CLASSICAL, SPEEDS)


def labels(sweep):
    return [point.label for point in sweep.points]


def test_up_and_down_show_the_jump_phenomenon(classical):
    """Kahraman and Singh's jumps: between the two of them the motion depends on where one comes from."""
    cold, up, down = classical
    assert [s.direction for s in classical] == ["cold", "up", "down"]
    coexist = SPEEDS.values[studies.coexisting(classical)]
    assert coexist.min() == pytest.approx(0.72)
    assert coexist.max() == pytest.approx(0.82)
    at = int(np.argmin(np.abs(SPEEDS.values - 0.78)))
    assert (up.points[at].label, down.points[at].label) == ("1-0-0", "1-1-0")
    assert labels(up)[-1] == labels(down)[-1] == labels(cold)[-1] == "1-1-0"


@pytest.mark.parametrize("chunk", [1, 3, 100])
def test_any_cut_gives_the_same_bytes(classical, chunk):
    again = studies.sweeps(CLASSICAL, SPEEDS, execution=Execution(chunk=chunk))
    assert content_hash(sweep_dataset(CLASSICAL, again)) == content_hash(sweep_dataset(CLASSICAL, classical))


def test_threads_give_the_same_bytes(classical):
    with ThreadPoolExecutor(3) as executor:
        again = studies.sweeps(CLASSICAL, SPEEDS, execution=Execution(executor, chunk=2))
    assert content_hash(sweep_dataset(CLASSICAL, again)) == content_hash(sweep_dataset(CLASSICAL, classical))


def test_processes_give_the_same_bytes():
    """The gap of the article's pair, where propagators are used again: cold, up and down, with back-side
    impacts and aperiodic motion.
    """
    axis = Axis.even("D", 0.33, 0.4, 8)
    fixed = {"omega": 0.78}
    settings = studies.Settings(patience=300, budget=2_000, exponent_periods=400)
    alone = studies.sweeps(ARTICLE, axis, values=fixed, settings=settings)
    assert {"aperiodic", "12-12-3", "6-6-2"} <= {label for sweep in alone for label in labels(sweep)}
    seen: list[Progress] = []
    with studies.open_workers(ARTICLE, 2) as executor:
        for chunk in (2, 3):
            shared = studies.sweeps(
                ARTICLE,
                axis,
                values=fixed,
                settings=settings,
                execution=Execution(executor, chunk=chunk, progress=seen.append),
            )
            assert content_hash(sweep_dataset(ARTICLE, shared)) == content_hash(sweep_dataset(ARTICLE, alone))
    assert seen[-1].done == seen[-1].total == 24
    assert seen[-1].remaining == 0.0


def test_a_followed_point_depends_on_the_one_before_only():
    """An up sweep goes on where another one ended."""
    whole = studies.sweep(CLASSICAL, SPEEDS, direction="up")
    later = Axis("omega", SPEEDS.values[8:])
    rest = studies.sweep(CLASSICAL, later, direction="up", start=whole.points[7].state)
    assert labels(rest) == labels(whole)[8:]
    for one, other in zip(whole.points[8:], rest.points, strict=True):
        np.testing.assert_allclose(one.state, other.state, atol=1e-10)


def test_values_that_fail_are_flagged_and_the_sweep_goes_on():
    axis = Axis("D", np.array([-0.5, 0.5, 1.0]))
    for direction in ("cold", "up", "down"):
        found = studies.sweep(CLASSICAL, axis, direction=direction)
        assert found.complete
        assert [point.status for point in found.points] == [Status.FAILED, "ok", "ok"]
        assert "D" in found.points[0].message
        assert found.points[0].value == -0.5


def test_cancel_keeps_what_was_computed():
    cancel = threading.Event()

    def after_five(progress: Progress) -> None:
        if progress.done == 5:
            cancel.set()

    found = studies.sweep(
        CLASSICAL, SPEEDS, direction="down", execution=Execution(progress=after_five, cancel=cancel)
    )
    assert (found.complete, found.message, found.computed) == (False, "cancelled", 5)
    assert [point.status for point in found.points] == [Status.NOT_COMPUTED] * 11 + ["ok"] * 5
    dataset = sweep_dataset(CLASSICAL, [found])
    assert dataset.attrs["complete"] == 0
    assert np.isnan(dataset["largest_exponent"].values[0, :11]).all()


def test_ctrl_c_keeps_what_was_computed():
    def interrupt(progress: Progress) -> None:
        if progress.done == 3:
            raise KeyboardInterrupt

    found = studies.sweep(CLASSICAL, SPEEDS, execution=Execution(progress=interrupt))
    assert (found.complete, found.message, found.computed) == (False, "interrupted", 3)


def test_names_and_starts_are_checked_before_anything_runs():
    with pytest.raises(GearlashError, match="did you mean 'omega'"):
        studies.sweep(CLASSICAL, Axis("omgea", np.array([1.0])))
    with pytest.raises(GearlashError, match="cannot be fixed as well"):
        studies.sweep(CLASSICAL, SPEEDS, values={"omega": 1.0})
    with pytest.raises(UnknownNameError, match="direction"):
        studies.sweep(CLASSICAL, SPEEDS, direction="upp")
    with pytest.raises(GearlashError, match=r"expected \(2,\) \(states: X"):
        studies.sweep(CLASSICAL, SPEEDS, start=[1.0, 2.0, 3.0])
    with pytest.raises(GearlashError, match="chunk"):
        studies.sweep(CLASSICAL, SPEEDS, execution=Execution(chunk=0))


def test_a_family_of_ones_own_runs_here_and_says_why_it_cannot_travel():
    base = CLASSICAL.family()[0]
    family = Family(
        (Parameter("omega", 0.6),),
        base.states,
        lambda values: base.system({"omega": values["omega"]}),
        lambda values: base.start(),
    )
    found = studies.sweep(family, SPEEDS)
    whole = studies.sweep(CLASSICAL, SPEEDS)
    assert labels(found) == labels(whole)
    dataset = results.sweep_dataset(family, [found])
    assert "case_hash" not in dataset.attrs
    with pytest.raises(GearlashError, match="workers=1"):
        studies.open_workers(family, 2)
    with studies.open_workers(CLASSICAL, 2) as executor, pytest.raises(GearlashError, match="workers=1"):
        studies.sweep(family, SPEEDS, execution=Execution(executor))
