"""Bad piecewise-linear cases, one kind a row: each is named with path, expectation and nearest name."""

from __future__ import annotations

import datetime

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from case.piecewise_texts import TEXT
from case.test_bad_files import problems_of
from gearlash.case import Case, CaseError, loads
from gearlash.case.kinds.piecewise.file import CLEARANCE_KEYS, PARAMETER_KEYS, TOP
from gearlash.case.loading import from_tables
from gearlash.case.read import parse

STOP, WALL = (f"clearance.{name}.stiffness_plus" for name in ("stop", "wall"))
STOP_G = 'g = [0, -1, 0, "1"]'

# (what is replaced, by what, path of the problem, words in what is expected, nearest name)
REPLACED = [
    ('"piecewise-linear"', '"piecewise-liner"', "kind", "one of helical-pair", "piecewise-linear"),
    ('name = "two masses"', "name = 3", "name", "a text", None),
    ("[parameters]", "[source]\nauthor = 1\n[parameters]", "source.author", "exists here", "source.authors"),
    ("[parameters]", "[source]\ndoi = 3\n[parameters]", "source.doi", "a text", None),
    # states and cycles
    ("states = [", "sates = [", "sates", "exists here", "states"),
    ("states = [", "sates = [", "states", "1 to 40 names", None),
    ('["x", "x\'", "y", "y\'"]', "[]", "states", "1 to 40 names", None),
    ('["x", "x\'", "y", "y\'"]', "3", "states", "1 to 40 names", None),
    ('["x", "x\'", "y", "y\'"]', str([f"s{i}" for i in range(41)]), "states", "1 to 40 names", None),
    ('"y", "y\'"]', '"y", "x"]', "states[3]", "each state once", None),
    ('"y", "y\'"]', '"y", "v = 1"]', "states[3]", "a name of 1 to 40", None),
    ('"y", "y\'"]', '"y", 4]', "states[3]", "a name of 1 to 40", None),
    ("cycles = 2", "cycles = 0", "cycles", "from 1 to 1000", None),
    ("cycles = 2", "cycles = 2.0", "cycles", "a whole number", None),
    ("cycles = 2", "cycles = true", "cycles", "a whole number", None),
    # parameters and definitions
    ("omega = 0.9\n", "", "parameters.omega", "above 0", None),
    ("omega = 0.9\n", "omega = 0\n", "parameters.omega", "above 0", None),
    ("omega = 0.9\n", "omega = -0.9\n", "parameters.omega", "above 0", None),
    ("omega = 0.9\n", "omega = inf\n", "parameters.omega", "not finite", None),
    ("omega = 0.9\n", 'omega = "0.9 Hz"\n', "parameters.omega", "a number without unit", None),
    ("omega = 0.9\n", 'omega = "2*F"\n', "parameters.omega", "a number without unit", None),
    ("value = 0.05, lower", "value = 1.05, lower", "parameters.zeta", "from 0", None),
    ("value = 0.05, lower", "lower", "parameters.zeta", "a table with a value", None),
    ("value = 0.05, lower", "value = 0.05, lover", "parameters.zeta.lover", "one of value", "lower"),
    ("lower = 0.0", 'lower = "0"', "parameters.zeta.lower", "a finite number", None),
    ("lower = 0.0", "lower = 2.0", "parameters.zeta.lower", "at most upper = 1", None),
    ('"damping ratio"', "4", "parameters.zeta.description", "a text", None),
    ('"assumed"', '"asumed"', "parameters.gap", "a provenance out of", "assumed"),
    ("F = 1.5", "pi = 3\nF = 1.5", "parameters.pi", "no word of the expressions", None),
    ("F = 1.5", "lambda = 3\nF = 1.5", "parameters.lambda", "a name of letters", None),
    ("F = 1.5", '"a b" = 3\nF = 1.5', "parameters.a b", "a name of letters", None),
    ('c = "2*zeta"', 'gap = "2*zeta"', "definitions.gap", "no parameter has", None),
    ('c = "2*zeta"', 'c = "2*half"', "definitions.c", "names of parameters", None),
    ('c = "2*zeta"', 'c = "1/(zeta - zeta)"', "definitions.c", "finite real value", None),
    # matrix, forcing, initial
    ("[matrix]", "[matrx]", "matrix", "the rows of M", None),
    ("[matrix]", "[matrx]", "matrx", "exists here", "matrix"),
    ('y = { "y\'" = 1.0 }', 'z = { "y\'" = 1.0 }', "matrix.z", "the name of a state", None),
    ('y = { "y\'" = 1.0 }', "y = { \"y''\" = 1.0 }", "matrix.y.y''", "the name of a state", "y'"),
    ('y = { "y\'" = 1.0 }', "y = [0, 0, 1]", "matrix.y", "4 entries, one a state", None),
    ('y = { "y\'" = 1.0 }', "y = 1", "matrix.y", "an array with one entry a state", None),
    ('y = { "y\'" = 1.0 }', 'y = { "y\'" = true }', "matrix.y.y'", "a finite number", None),
    ('y = { "y\'" = 1.0 }', 'y = { "y\'" = nan }', "matrix.y.y'", "a finite number", None),
    ('y = { "y\'" = 1.0 }', 'y = { "y\'" = 1e60 }', "matrix.y.y'", "a finite number", None),
    ('y = { "y\'" = 1.0 }', 'y = { "y\'" = "1 +" }', "matrix.y.y'", "an expression", None),
    ('"half/zeta"', '"half/zeat"', "matrix.y'.x", "names of parameters", "zeta"),
    ('"half/zeta"', '"sqr(zeta)"', "matrix.y'.x", "one of sqrt", "sqrt"),
    ('"half/zeta"', '"sqrt(-zeta)"', "matrix.y'.x", "finite real value", None),
    ('"half/zeta"', '"__import__(1)"', "matrix.y'.x", "one of sqrt", None),
    ("sin = [0.5]", "sin = 0.5", "forcing.x'.sin", "an array of at most", None),
    ("sin = [0.5]", "sine = [0.5]", "forcing.x'.sine", "one of mean, cos", "sin"),
    ("sin = [0.5]", "phases = [0.5]", "forcing.x'.cos", "either cos and sin or", None),
    ("sin = [0.5]", 'sin = ["f"]', "forcing.x'.sin[0]", "names of parameters", "F"),
    ('phases = ["phase"]', "phases = [0, 1]", "forcing.y'.phases", "as many phases as amplitudes (1)", None),
    ("orders = [4]", "orders = [4, 5]", "forcing.y'.orders", "1 different whole numbers", None),
    ("orders = [4]", "orders = [0]", "forcing.y'.orders", "1 different whole numbers", None),
    ("orders = [4]", "orders = [1.0]", "forcing.y'.orders", "1 different whole numbers", None),
    ('0.25] }\nstiff', '0.25], orders = [2, 2] }\nstiff', f"{STOP}.orders", "2 different", None),
    ('[initial]\nx = "gap + F"', '[initial]\nx = [1]', "initial.x", "a finite number", None),
    ('[initial]\nx = "gap + F"', '[initial]\nz = 1', "initial.z", "the name of a state", None),
    # clearances
    ('name = "wall"', 'name = "stop"', "clearance[1].name", "no other clearance has", None),
    ('name = "wall"\n', "", "clearance[1].name", "the name of this clearance", None),
    ('name = "wall"', 'name = "a/b"', "clearance[1].name", "a name of 1 to 40", None),
    ('name = "wall"', 'name = "<b>"', "clearance[1].name", "a name of 1 to 40", None),
    ("gap_minus = 2", "gap_mius = 2", "clearance.stop.gap_mius", "one of name", "gap_minus"),
    ("gap_minus = 2", "gap_mius = 2", "clearance.stop.gap_minus", "where side - begins", None),
    ("gap_minus = 2\n", "gap_minus = -0.4\n", "clearance.stop.gap_minus", "0 or more (it is -0.1)", None),
    ("gap_plus = 5\n", "", "clearance.wall.gap_plus", "where side + begins", None),
    ("gap_plus = 5\n", "gap_plus = [5]\n", "clearance.wall.gap_plus", "a finite number", None),
    ("h = [1, 0, 0, 0]\n", "", "clearance.wall.h", "gap coordinate", None),
    ("h = [1, 0, 0, 0]", "h = [1, 0, 0]", "clearance.wall.h", "4 entries, one a state", None),
    ("h = [1, 0, 0, 0]", "h = [0, 0, 0, 0]", "clearance.wall.h", "reads no state", None),
    ("h = [1, 0, 0, 0]", "h = { z = 1 }", "clearance.wall.h.z", "the name of a state", None),
    ("h = [1, 0, 0, 0]", "h = [0, 1, 0, 0]", "clearance.wall.h", "h·g = 0 with g of wall (it is -1)", None),
    (STOP_G, "g = [-1, -1, 0, 1]", "clearance.stop.h", "h·g = 0 with g of stop", None),
    (STOP_G, "g = [-1, -1, -1, 1]", "clearance.wall.h", "h·g = 0 with g of stop (it is -1)", None),
    (STOP_G, "g = [0, 0, 0, 0]", "clearance.stop.g", "acts on no state", None),
    ("stiffness_plus = 1\n", "", "clearance.wall.stiffness_plus", "the stiffness of side +", None),
    ("stiffness_plus = 1\n", "stiffness_plus = [1]\n", WALL, "a number, an expr", None),
    ("stiffness_plus = 1\n", "stiffness_plus = true\n", WALL, "a number, an expr", None),
    ('damping = "zeta"', 'damping = "zeta kappa"', "clearance.stop.damping", "an expression", None),
    ('"in-contact"', '"in contact"', "clearance.stop.contact", "one of always", "in-contact"),
    ('"in-contact"', '"always"', "clearance.stop.damping_minus", "lets it act in the gap", None),
    ('"in-contact"', "1", "clearance.stop.contact", "one of always", None),
]  # fmt: skip


@pytest.mark.parametrize(("old", "new", "path", "expected", "nearest"), REPLACED)
def test_every_kind_of_bad_value_is_named(old, new, path, expected, nearest):
    assert old in TEXT
    problems = problems_of(TEXT.replace(old, new, 1))
    found = [p for p in problems if p.path == path and expected in p.expected]
    assert found, [str(p) for p in problems]
    assert nearest in [p.nearest for p in found]


def test_without_clearance_or_with_something_else_in_its_place():
    text = TEXT.partition("[[clearance]]")[0]
    assert [p.path for p in problems_of(text)] == ["clearance"]
    assert problems_of("clearance = 3\n" + text)[0].expected == "1 to 8 tables [[clearance]]"
    assert problems_of("clearance = [3]\n" + text)[0].path == "clearance[0]"


def test_all_problems_of_a_file_come_at_once():
    text = (
        TEXT.replace("omega = 0.9", "omega = -1")
        .replace('"2*zeta"', '"2*zeat"')
        .replace('y = { "y\'" = 1.0 }', 'y = { "q" = 1.0 }')
        .replace("gap_minus = 2", "gap_mins = 2")
        .replace('"no-tension"', '"no tension"')
        .replace('[initial]\nx = "gap + F"', "[initial]\nx = nan")
    )
    paths = [p.path for p in problems_of(text, {"zeta": "x", "nothing": 1})]
    assert sorted(paths) == sorted(
        [
            "parameters.omega",
            "definitions.c",
            "matrix.y.q",
            "clearance.stop.gap_mins",
            "clearance.stop.gap_minus",
            "clearance.wall.contact",
            "initial.x",
            "zeta",
            "nothing",
        ]
    )


def test_one_wrong_definition_is_one_problem():
    problems = problems_of(TEXT.replace('"2*zeta"', '"2*sqrt(-zeta)"'))
    assert [p.path for p in problems] == ["definitions.c"]
    assert problems[0].value == "'2*sqrt(-zeta)'"


def test_a_file_without_anything_is_asked_for_its_parts():
    found = {p.path: p for p in problems_of('kind = "piecewise-linear"')}
    assert set(found) == {"states", "parameters.omega", "matrix", "clearance"}
    assert all(p.missing for p in found.values())


junk = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=12)
    | st.dates()
    | st.just(datetime.time(1, 2))
    | st.sampled_from(["x", "x'", "omega", "2*zeta", "zeta^0.5", "1/0", "always", 1, 0, -1.0, 1e300]),
    lambda inner: (
        st.lists(inner, max_size=5)
        | st.dictionaries(
            st.sampled_from(
                ["x", "x'", "v", "mean", "cos", "sin", "amplitudes", "phases", "orders", *PARAMETER_KEYS]
            ),
            inner,
            max_size=4,
        )
        | st.dictionaries(st.sampled_from(CLEARANCE_KEYS), inner, max_size=11)
    ),
    max_leaves=12,
)
WHOLE = parse("case", TEXT)


def accepted_or_refused(raw, overrides=None) -> None:
    """Either outcome is right; a refusal must say why, and an accepted case must make a system."""
    try:
        case = from_tables(raw, overrides)
    except CaseError as error:
        assert error.problems  # noqa: PT017
        return
    family, _ = Case.from_json(case.to_json()).family()
    assert family.system().size == len(family.states) == len(family.start())
    assert case.values()


@settings(max_examples=200)
@given(
    st.dictionaries(st.sampled_from(TOP), junk, max_size=10),
    st.dictionaries(st.text(max_size=6), junk, max_size=2),
)
def test_garbage_never_crashes_the_loader(tables, overrides):
    accepted_or_refused({**tables, "kind": "piecewise-linear"}, overrides)


@settings(max_examples=300)
@given(st.data())
def test_garbage_in_one_place_of_a_good_case_never_crashes_the_loader(data):
    def damaged(part, depth=0):
        if depth and (not isinstance(part, dict | list) or not part or data.draw(st.integers(0, 3)) == 0):
            return data.draw(junk)
        if isinstance(part, list):
            i = data.draw(st.integers(0, len(part) - 1))
            return [*part[:i], damaged(part[i], depth + 1), *part[i + 1 :]]
        key = data.draw(st.sampled_from(sorted(set(part) - {"kind"})))
        return {**part, key: damaged(part[key], depth + 1)}

    accepted_or_refused(damaged(WHOLE))


@settings(max_examples=100)
@given(st.data())
def test_a_damaged_file_never_crashes_the_loader(data):
    start = data.draw(st.integers(0, len(TEXT) - 1))
    length = data.draw(st.integers(0, 12))
    text = TEXT[:start] + data.draw(st.text(max_size=6)) + TEXT[start + length :]
    try:
        loads(text)
    except CaseError as error:
        assert error.problems  # noqa: PT017 - either outcome is right; a refusal must say why
