"""One word for one thing: a system is taken as its propagators are, a case as its family is."""

from __future__ import annotations

import inspect
from typing import Any

import pytest

import gearlash as gl
from api.calls import calls

NAMES = {"props", "z", "fixed", "initial", "guess", "executor", "chunk", "cold"}
"""Arguments that have another name now."""


def of_one_system() -> list[str]:
    """Functions whose argument ``system`` may be its propagators."""
    found = [call for call in calls() if "system" in call.arguments and "reuse" not in call.arguments]
    return [call.name for call in found if "Propagators" in str(inspect.signature(call.function))]


@pytest.mark.parametrize("name", of_one_system())
def test_a_system_is_taken_as_its_propagators_are(name: str):
    (call,) = (call for call in calls() if call.name == name)
    given: Any = call.arguments["system"]
    system = given.system if isinstance(given, gl.Propagators) else given
    ways = system, gl.propagators(system)
    own, made = (call.function(**{**call.arguments, "system": one}) for one in ways)
    assert repr(own) == repr(made)


def test_a_case_is_taken_as_its_family_is():
    case = gl.load_case("kahraman-singh")
    family, axis = case.family()[0], gl.Axis.even("omega", 0.7, 0.9, 3)
    for one, other in (
        (gl.sweep(case, axis), gl.sweep(family, axis)),
        (gl.point(case, {"omega": 0.8}), gl.point(family, {"omega": 0.8})),
        (gl.zones(case, axis), gl.zones(family, axis)),
    ):
        assert repr(one) == repr(other)


def test_public_functions_use_the_words_that_hold_now():
    for name in gl.__all__:
        function = getattr(gl, name)
        if inspect.isfunction(function):
            assert set(inspect.signature(function).parameters).isdisjoint(NAMES), name
