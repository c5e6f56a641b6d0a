"""Thousands of calls with wrong arguments: each goes through or is refused in words, and nothing else."""

from __future__ import annotations

import inspect
import random
import warnings
from pathlib import Path
from typing import get_origin

import pytest

import gearlash as gl
from api.calls import Call, calls, wrong

SEEDS, EACH = 10, 400
NEEDS_MORE = ("loads", "load_dataset", "load_branch", "load_curve", "load_measurement",
              "switch_branch", "reproduce", "pair_report")  # fmt: skip
"""What fits them takes a file, or minutes."""
HANDED_OUT = {
    *("Beside", "BesideMotion", "ImpactFree", "PassedBifurcation", "FollowedPath", "Progress"),
    *(
        "Comparison",
        "Influence",
        "MeasuredJump",
        "PairReport",
        "Profile",
        "Tolerance",
        "ToleranceInput",
        "ToleranceMember",
    ),
    *("Entry", "Excitation", "Note", "Problem", "Provenance", "Value"),
    *("GrazingConditions", "Neutral", "Unresolved", "Transition", "register_kind"),
}
"""What is only read; and `register_kind`, which would change all other calls."""
LONGEST = 3000  # characters of a refusal


@pytest.fixture(autouse=True)
def empty_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path):
    monkeypatch.chdir(tmp_path)


def test_the_arguments_that_fit_go_through():
    for call in calls():
        if call.name not in NEEDS_MORE:
            call.function(**call.arguments)


def test_every_public_name_is_called():
    called = {id(call.function) for call in calls()}
    called |= {id(type(value)) for call in calls() for value in call.arguments.values()}
    public = {name: getattr(gl, name) for name in gl.__all__}
    left = {name for name, value in public.items() if id(value) not in called and get_origin(value) is None}
    errors = {
        name for name in left if issubclass(type(public[name]), type) and issubclass(public[name], Exception)
    }
    protocols = {"Cancel", "CaseContent", "CaseKind", "HasFamily", "Sampled"}
    takes_nothing = {"__version__", "bundled", "case_schema"}
    assert left - errors - protocols - takes_nothing == HANDED_OUT


def test_every_argument_has_a_fitting_one():
    """So that all of them are tried: those that were left out are told by their names."""
    for call in calls():
        known = set(inspect.signature(call.function).parameters)
        assert set(call.arguments) <= known or call.name in (
            "ContactRule",
            "MotionKind",
            "Status",
            "Direction",
        ), call.name


def arguments(call: Call, source: random.Random) -> dict[str, object]:
    """Those that fit, with one to three that are drawn from anywhere."""
    found = dict(call.arguments)
    for name in source.sample(sorted(found), min(len(found), source.choice([1, 1, 1, 2, 3]))):
        found[name] = wrong(source)
    progress = found.get("progress")
    if progress is not None and callable(progress):
        found["progress"] = print  # what a caller's own function raises is the caller's
    return found


@pytest.mark.parametrize("seed", range(SEEDS))
def test_wrong_arguments_are_refused_in_words(seed: int):
    refused: list[str]
    source, refused = random.Random(seed), []
    for i in range(EACH):
        call = source.choice(calls())
        given = arguments(call, source)
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # a number that is silently made another one warns
            try:
                call.function(**given)
            except gl.GearlashError as error:
                refused.append(str(error))
            except Exception as error:
                raise AssertionError(f"call {i} of {seed}: {call.name}: {error!r}") from error
    assert len(refused) > EACH / 2
    assert all(10 < len(text) < LONGEST for text in refused)
