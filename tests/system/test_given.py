"""What callers hand over is made plain, or refused in words: never taken for something else."""

from __future__ import annotations

import copy
import datetime
import importlib
import pickle
import pkgutil
from decimal import Decimal
from fractions import Fraction
from typing import Any

import numpy as np
import pandas as pd
import pytest

import gearlash as gl
from gearlash import flow
from gearlash.system import BuildError, GearlashError, UnknownNameError
from gearlash.system.status import Named


def stop(**changes: Any) -> gl.Clearance:
    fields: dict[str, Any] = {
        "h": [1.0, 0.0], "g": [0.0, -1.0], "gap_plus": 1.0, "gap_minus": 5.0,
        "stiffness_plus": [29.0], "stiffness_minus": [0.0],
    }  # fmt: skip
    return gl.Clearance(**(fields | changes))


def system(clearance: gl.Clearance | None = None, **changes: Any) -> gl.System:
    fields: dict[str, Any] = {
        "omega": 0.8, "matrix": [[0.0, 1.0], [-1.0, -0.02]], "forcing": [[0.0, 0.0, 0.0], [0.0, 0.7, 0.0]],
        "clearances": (clearance or stop(),),
    }  # fmt: skip
    return gl.System(**(fields | changes))


@pytest.mark.parametrize("rule", ["always", "in-contact", "no-tension"])
def test_a_contact_rule_as_text_is_the_rule(rule: str):
    """As text it once was none of the three, and the motion certified was that of another system."""
    named, member = (
        flow.march(flow.propagators(system(stop(damping=0.3, contact=contact))), [2.0, 0.5], 40).states
        for contact in (rule, gl.ContactRule(rule))
    )
    assert np.array_equal(named, member)
    assert stop(contact=rule).contact is gl.ContactRule(rule)


@pytest.mark.parametrize("wrong", ["allways", "ALWAYS", "", 1, None, True, ["always"], b"always"])
def test_another_contact_rule_is_refused_with_the_valid_ones(wrong: Any):
    with pytest.raises(UnknownNameError, match=r"contact rule of clearance 'mesh'.*always, in-contact"):
        stop(contact=wrong)


def test_a_choice_by_its_class_is_refused_in_words():
    with pytest.raises(GearlashError, match="did you mean 'in-contact'"):
        gl.ContactRule("in contact")
    with pytest.raises(GearlashError, match="unknown Status"):
        gl.Status(7)
    assert issubclass(gl.ContactRule, Named)


ARRAYS = {
    "list": [1.0, 0.0],
    "tuple": (1, 0),
    "whole numbers": np.array([1, 0]),
    "single precision": np.array([1.0, 0.0], dtype=np.float32),
    "read-only": np.broadcast_to(np.array([1.0, 0.0]), (2, 2))[1],
    "every other": np.array([1.0, 7.0, 0.0, 7.0])[::2],
    "series": pd.Series([1.0, 0.0]),
    "exact": [Fraction(1), Decimal(0)],
    "no place masked": np.ma.masked_array([1.0, 0.0], [False, False]),
    "range": range(1, -1, -1),
}


@pytest.mark.parametrize("name", ARRAYS)
def test_arrays_of_all_kinds_are_plain_ones(name: str):
    found = stop(h=ARRAYS[name]).h
    assert type(found) is np.ndarray
    assert (found.dtype, found.tolist()) == (np.float64, [1.0, 0.0])
    assert found.flags.c_contiguous
    assert not found.flags.writeable


REFUSED_ARRAYS = {
    "text": (["1", "0"], "text"),
    "one text": ("10", "not '10'"),
    "complex": ([1j, 0.0], "complex"),
    "truth values": ([True, False], "truth values"),
    "NaN": ([np.nan, 0.0], "NaN"),
    "infinite": ([np.inf, 0.0], "infinity"),
    "nothing in it": ([1.0, None], "None"),
    "nothing": (None, "None"),
    "object": (object(), "object"),
    "ragged": ([[1.0], [0.0, 1.0]], "expected numbers of shape"),
    "dates": (np.array(["2020-01-01", "2020-01-02"], dtype="M8[D]"), "dates"),
    "masked": (np.ma.masked_array([1.0, 0.0], [False, True]), "masked"),
    "too large": ([10**400, 0], "beyond double precision"),
    "table": ({"x": 1.0, "v": 0.0}, "dict"),
    "two rows": ([[1.0, 0.0]], "shape"),
    "no dimension": (np.array(1.0), "shape"),
}


@pytest.mark.parametrize("name", REFUSED_ARRAYS)
def test_what_is_no_array_of_numbers_is_refused_with_its_field(name: str):
    value, told = REFUSED_ARRAYS[name]
    with pytest.raises(GearlashError, match=f"clearance 'mesh': h.*{told}"):
        stop(h=value)


NUMBERS = [
    1,
    1.0,
    np.float32(1.0),
    np.int8(1),
    np.array(1.0),
    Decimal(1),
    Fraction(1),
    True is not None and 1,
]
REFUSED = ["1", "1 mm", b"1", 1j, np.complex128(1.0), None, True, np.True_, [1.0], np.array([1.0]), object(),
           float("nan"), float("inf"), -float("inf"), 10**400, Decimal("NaN"), pd.Series([1.0]),
           datetime.datetime(2020, 1, 1), np.timedelta64(1, "s"), {}, pd.NA]  # fmt: skip


@pytest.mark.parametrize("value", NUMBERS, ids=repr)
def test_numbers_of_all_kinds_are_floats(value: Any):
    found = stop(gap_plus=value).gap_plus
    assert type(found) is float
    assert found == 1.0


@pytest.mark.parametrize("value", REFUSED, ids=lambda value: type(value).__name__)
def test_what_is_no_number_is_refused_with_its_field(value: Any):
    with pytest.raises(GearlashError, match=r"clearance 'mesh': gap_plus = .*: expected a finite number"):
        stop(gap_plus=value)
    with pytest.raises(GearlashError, match=r"omega = .*: expected a positive number"):
        system(omega=value)
    with pytest.raises(GearlashError, match=r"budget is .*: expected a whole number"):
        gl.Settings(budget=value)
    with pytest.raises(GearlashError, match="parameter zeta"):
        gl.Parameter("zeta", value)


def test_a_number_is_a_fourier_series_without_harmonics():
    assert stop(stiffness_plus=3).stiffness_plus.tolist() == [3.0]
    with pytest.raises(GearlashError, match="stiffness_plus: a Fourier series has even length"):
        stop(stiffness_plus=[1.0, 2.0])


def test_what_was_handed_over_may_change_afterwards():
    h, matrix, stiffness = np.array([1.0, 0.0]), np.array([[0.0, 1.0], [-1.0, 0.0]]), np.array([29.0])
    made = system(stop(h=h, stiffness_plus=stiffness), matrix=matrix)
    h[:], matrix[:], stiffness[:] = 7.0, 7.0, 7.0
    assert made.matrix.tolist() == [[0.0, 1.0], [-1.0, 0.0]]
    assert made.clearances[0].h.tolist() == [1.0, 0.0]
    assert made.clearances[0].stiffness_plus.tolist() == [29.0]
    with pytest.raises(ValueError, match="read-only"):
        made.matrix[0, 0] = 1.0


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"matrix": np.zeros((2, 3))}, r"matrix has shape \(2, 3\)"),
        ({"matrix": 1.0}, "matrix has shape"),
        ({"forcing": [[0.0, 0.0], [0.0, 0.0]]}, "forcing has shape"),
        ({"forcing": np.zeros((3, 1))}, "forcing has shape"),
        ({"omega": 0}, "omega = 0"),
        ({"omega": -1.0}, "omega = -1.0"),
        ({"cycles": 0}, "cycles is 0"),
        ({"cycles": 1.0}, "cycles is 1.0"),
        ({"cycles": True}, "cycles is True"),
        ({"clearances": "mesh"}, "clearances = 'mesh'"),
        ({"clearances": [1]}, "expected a tuple of Clearance, not an int"),
        ({"clearances": [stop(), stop()]}, "the same name"),
        ({"clearances": stop(h=[1.0, 0.0, 0.0], g=[0.0, 0.0, 1.0])}, "expected \\(2,\\)"),
        ({"clearances": stop(g=[1.0, 0.0])}, "is not zero"),
        ({"clearances": stop(gap_plus=-6.0)}, "width"),
    ],
)
def test_systems_that_are_none(changes: dict[str, Any], told: str):
    with pytest.raises(GearlashError, match=told):
        system(**changes)


def test_one_clearance_alone_and_a_list_are_tuples():
    assert isinstance(system(clearances=stop()).clearances, tuple)
    assert isinstance(system(clearances=[stop()]).clearances, tuple)


def family(**changes: Any) -> gl.Family:
    fields: dict[str, Any] = {
        "parameters": (gl.Parameter("omega", 0.8, lower=0.1),), "states": ("x", "v"),
        "build": lambda p: system(omega=p["omega"]), "cold_start": lambda p: [0.0, 0.0],
    }  # fmt: skip
    return gl.Family(**(fields | changes))


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"states": "xv"}, "states of a family = 'xv'"),
        ({"states": ("x", "x")}, "'x' stands there twice"),
        ({"states": ("x", 1)}, "expected a name"),
        ({"states": {"x", "v"}}, "in order: a set has none"),
        ({"parameters": frozenset({gl.Parameter("omega", 0.8)})}, "in order: a set has none"),
        ({"parameters": {"omega": 0.8}}, "expected parameters, such as"),
        ({"parameters": [gl.Parameter("omega", 1.0)] * 2}, "'omega' stands there twice"),
        ({"build": system()}, "build of a family"),
        ({"cold_start": [0.0, 0.0]}, "cold_start of a family"),
    ],
)
def test_families_that_are_none(changes: dict[str, Any], told: str):
    with pytest.raises(GearlashError, match=told):
        family(**changes)


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"states": ("x", "v", "w")}, "a system of 2 states, but the family names 3: x, v, w"),
        ({"build": lambda p: None}, "build returned None instead of a System, at omega = 0.8"),
        ({"build": lambda p: p["omga"]}, "build failed at omega = 0.8: KeyError: 'omga'"),
        ({"build": lambda p: system(omega="1")}, "omega = '1'"),
    ],
)
def test_what_a_build_does_wrong_is_told(changes: dict[str, Any], told: str):
    with pytest.raises(GearlashError, match=told):
        family(**changes).system()
    point = gl.point(family(**changes))
    assert point.status == "failed"
    assert told[:30] in point.message


@pytest.mark.parametrize("start", [[0.0], [0.0, np.nan], None, "rest", lambda: 0])
def test_what_an_initial_does_wrong_is_told(start: Any):
    with pytest.raises(GearlashError, match="the start"):
        family(cold_start=lambda p: start).start()
    with pytest.raises(BuildError, match=r"cold_start failed at omega = 0\.8: ValueError: no"):
        family(cold_start=_refusing).start()


def _refusing(values: Any) -> Any:
    raise ValueError("no")


@pytest.mark.parametrize(
    "values", [{"omega": "0.9"}, {"omega": 0.01}, {"omga": 1.0}, [("omega", 1.0)], 7, {1: 2}]
)
def test_parameter_values_that_are_none(values: Any):
    with pytest.raises(GearlashError, match=r"omega|omga|parameter values"):
        family().system(values)


def test_a_build_that_fails_for_one_value_fails_that_point():
    def build(p):
        return system(stop(gap_plus=1.0 / (p["omega"] - 1.0)), omega=p["omega"])

    found = gl.sweep(family(build=build), gl.Axis("omega", np.array([0.5, 1.0, 1.5])))
    assert [point.status == "failed" for point in found.points] == [False, True, False]
    assert "ZeroDivisionError" in found.points[1].message
    assert "omega = 1" in found.points[1].message


class WordlessError(Exception):
    """An error whose text fails."""

    def __str__(self) -> str:
        raise ValueError("no text")


@pytest.mark.parametrize(
    ("error", "told"),
    [
        (MemoryError("too much"), "MemoryError: too much"),
        (SystemExit(3), "SystemExit: 3"),
        (ValueError("two\nlines"), "ValueError: two lines"),
        (WordlessError(), "WordlessError: its text cannot be had"),
    ],
)
def test_whatever_a_build_raises_fails_its_point(error: BaseException, told: str):
    def build(p):
        if p["omega"] == 1.0:
            raise error
        return system(omega=p["omega"])

    own = family(build=build, parameters=(gl.Parameter("omega", 0.8), gl.Parameter("f", 0.1)))
    plane = gl.map_plane(own, gl.Axis("omega", np.array([0.5, 1.0])), gl.Axis("f", np.array([0.1])))
    found = gl.sweep(own, gl.Axis("omega", np.array([0.5, 1.0, 1.5])))
    assert [point.status == "failed" for point in found.points] == [False, True, False]
    assert found.points[1].message.endswith(told)
    assert plane.statuses == {"ok": 1, "failed": 1}


def test_cosines_refuse_in_words():
    with pytest.raises(GearlashError, match="2 amplitudes but 1 phases"):
        gl.cosines(1.0, [0.1, 0.2], [0.0])
    for wrong in (("1", [0.1]), (1.0, "a"), (1.0, [None]), (np.nan, [])):
        with pytest.raises(GearlashError):
            gl.cosines(*wrong)  # pyright: ignore[reportArgumentType]
    assert gl.cosines(1.0, 0.5).tolist() == [1.0, 0.5, -0.0]


def _every_error() -> list[GearlashError]:
    from gearlash.case import CaseError, Problem
    from gearlash.case.kinds.gears.meshing import ValueProblemError
    from gearlash.case.kinds.piecewise.arrays import NoValueError
    from gearlash.jobs import NoWorkersError, UnfinishedError
    from gearlash.multibody.extra import MissingExtraError
    from gearlash.multibody.solvers import SimulationError
    from gearlash.studies.verification import NotVerifiableError

    return [
        GearlashError("text"),
        UnknownNameError("parameter", "omga", ["omega"]),
        BuildError("build failed"),
        CaseError("case", [Problem("mesh.backlash", "'1'", "a length")]),
        NoValueError("matrix", "1/0", "a number"),
        NoWorkersError("no worker started"),
        UnfinishedError("a worker died"),
        ValueProblemError(Problem("mesh.backlash", "'0 um'", "more")),
        MissingExtraError("not installed"),
        NotVerifiableError("case", [Problem("kind", "piecewise-linear", "a pair of gears")]),
        SimulationError("it stopped"),
    ]


def test_every_error_travels_between_processes():
    for error in _every_error():
        same = pickle.loads(pickle.dumps(error))
        assert type(same) is type(error)
        assert str(same) == str(error)
        assert same.__dict__ == error.__dict__
    for module in pkgutil.walk_packages(gl.__path__, "gearlash."):  # whatever other tests have imported
        if ".peers." not in module.name and not module.name.startswith("gearlash._kernel"):
            importlib.import_module(module.name)
    assert {type(e) for e in _every_error()} >= {GearlashError, *_subclasses(GearlashError)}


def _subclasses(kind: type) -> set[type]:
    found = {each for each in kind.__subclasses__() if each.__module__.startswith("gearlash")}
    return found.union(*map(_subclasses, found)) if found else found


def test_systems_and_families_travel_and_copy():
    made = system(stop(contact="no-tension", damping=0.2, damping_minus=0.1))
    for same in (pickle.loads(pickle.dumps(made)), copy.copy(made), copy.deepcopy(made)):
        assert np.array_equal(same.matrix, made.matrix)
        assert same.clearances[0].contact is gl.ContactRule.NO_TENSION
        assert same.clearances[0].dampings == made.clearances[0].dampings
        assert not same.matrix.flags.writeable
