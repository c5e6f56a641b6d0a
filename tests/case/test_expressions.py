"""Expressions in case files: their values, and that of any text comes a value or a named problem."""

from __future__ import annotations

import math
import pickle

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gearlash.case.kinds.piecewise.expressions import (
    DEEPEST,
    FUNCTIONS,
    LARGEST_NUMBER,
    LONGEST,
    Expression,
    ExpressionError,
    is_name,
)

VALUES = {"zeta": 0.05, "kappa": 1.5, "F": -2.0, "omega": 0.9, "phase": 1.25, "zero": 0.0}


def value(text: str) -> float:
    return Expression.read(text, VALUES)(VALUES)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("2*zeta*kappa", 0.15),
        ("F*omega^2", -1.62),
        ("F*omega**2", -1.62),
        ("cos(phase)", math.cos(1.25)),
        ("-F", 2.0),
        ("+F", -2.0),
        ("--F", -2.0),
        ("-2^2", -4.0),
        ("2^-1", 0.5),
        ("2^3^2", 512.0),
        ("1 + 2*3^2", 19.0),
        ("6/3/2", 1.0),
        ("1 - 2 - 3", -4.0),
        ("(1 + 2)*3", 9.0),
        ("2*pi", 2.0 * math.pi),
        ("sqrt(kappa^2 + 4)", 2.5),
        ("exp(0) + sin(pi/2)", 2.0),
        ("1.5e-3", 0.0015),
        (".5 + 5.", 5.5),
        (" 1 ", 1.0),
        ("7/2", 3.5),
    ],
)
def test_values_are_those_of_arithmetic(text: str, expected: float):
    assert value(text) == pytest.approx(expected, rel=1e-15)


# (text, words in what is expected, nearest name)
REFUSED = [
    ("", "nothing stands there", None),
    ("   ", "nothing stands there", None),
    ("2*", "an expression", None),
    ("(1", "an expression", None),
    ("1)", "an expression", None),
    ("2 zeta", "an expression", None),
    ("4 mm", "an expression", None),
    ("zeat", "names of parameters", "zeta"),
    ("Kappa", "names of parameters", "kappa"),
    ("__import__", "names of parameters", None),
    ("__import__(0)", "one of sqrt, cos", None),
    ("eval(1)", "one of sqrt, cos", None),
    ("sqr(2)", "one of sqrt, cos", "sqrt"),
    ("tan(1)", "one of sqrt, cos", None),
    ("cos", "parentheses after cos", None),
    ("cos()", "one of sqrt, cos", None),
    ("zeta(2)", "one of sqrt, cos", None),
    ("(cos)(1)(2)", "an expression", None),
    ("zeta.real", "an expression", None),
    ("zeta.__class__", "an expression", None),
    ("1 if zeta else 2", "an expression", None),
    ("zeta and 1", "an expression", None),
    ("not zeta", "an expression", None),
    ("1//2", "an expression", None),
    ("1j", "an expression", None),
    ("True", "an expression", None),
    ("None", "an expression", None),
    ("lambda", "an expression", None),
    ("cos(*zeta)", "an expression", None),
    ("cos(1, 2)", "without ','", None),
    ("1 < 2", "without '<'", None),
    ("1 % 2", "without '%'", None),
    ("zeta[0]", "without '['", None),
    ("'a'", 'without "\'"', None),
    ("a := 1", "without ':'", None),
    ("1 # x", "without '#'", None),
    ("1\n+2", "without '\\n'", None),
    ("1\x00", "without '\\x00'", None),
    ("ζ", "without 'ζ'", None),
    ("²", "without '²'", None),
    ("1e999", "double precision", None),
    ("9" * 399, "double precision", None),
    ("1+" * 250 + "1", f"at most {LONGEST} characters", None),
    ("-" * (LONGEST - 1) + "1", f"at most {DEEPEST} levels", None),
    ("cos(" * 90 + "1" + ")" * 40, "an expression", None),
]


@pytest.mark.parametrize(("text", "expected", "nearest"), REFUSED)
def test_everything_else_is_refused_when_it_is_read(text: str, expected: str, nearest: str | None):
    with pytest.raises(ExpressionError) as caught:
        value(text)
    assert expected in caught.value.expected
    assert caught.value.nearest == nearest


@pytest.mark.parametrize(
    "text",
    [
        "1/zero",
        "sqrt(F)",
        "F^0.5",
        "zero^-1",
        "exp(1000)",
        "9^9^9^9",
        "1e50*kappa",
        "1e300*1e300",
        "exp(999)*zero",
    ],
)
def test_an_expression_without_a_usable_value_says_so(text: str):
    expression = Expression.read(text, VALUES)
    with pytest.raises(ExpressionError, match="finite real value"):
        expression(VALUES)


def test_names_of_an_expression_are_its_parameters():
    assert Expression.read("sqrt(zeta)*pi + F*zeta", VALUES).names == {"zeta", "F"}


def test_an_expression_travels_to_other_processes():
    expression = Expression.read("2*zeta + cos(phase)", VALUES)
    first = expression(VALUES)
    again = pickle.loads(pickle.dumps(expression))
    assert again == expression
    assert again(VALUES) == first


@pytest.mark.parametrize(
    ("name", "valid"),
    [("omega", True), ("mu_1", True), ("D", True), ("pi", False), ("cos", False), ("lambda", False)]
    + [(name, False) for name in ("", "1a", "a b", "a-b", "ζ", "_a", "a" * 41, "a.b", "None")],
)
def test_what_a_parameter_may_be_called(name: str, valid: bool):
    assert is_name(name) is valid


WORDS = (
    "pi",
    "1",
    "2.5",
    "1e9",
    "1e",
    "9" * 30,
    "__class__",
    "lambda",
    "if",
    "else",
    "0x1f",
    "1_0",
    "**",
    "//",
)
SIGNS = "+-*/^().,[]{}:;=<>&|~%@!#'\"\\ \t\n\x00ζ\u202e"
FRAGMENTS = st.sampled_from([*VALUES, *FUNCTIONS, *WORDS, *SIGNS])


@settings(max_examples=500)
@given(st.lists(FRAGMENTS, max_size=30).map("".join) | st.text(max_size=60))
def test_of_any_text_comes_a_finite_float_or_a_named_problem(text: str):
    try:
        found = value(text)
    except ExpressionError as error:
        assert error.expected  # noqa: PT017 - either outcome is right; a refusal must say why
    else:
        assert type(found) is float
        assert abs(found) <= LARGEST_NUMBER


LEAVES = st.one_of(
    st.sampled_from(list(VALUES.items())),
    st.floats(0.0, 100.0).map(lambda x: (repr(x), x)),
)


def grown(inner: st.SearchStrategy[tuple[str, float]]) -> st.SearchStrategy[tuple[str, float]]:
    sums = st.tuples(inner, st.sampled_from("+-*"), inner)
    return st.one_of(
        sums.map(lambda x: (f"({x[0][0]} {x[1]} {x[2][0]})", calculated(x[0][1], x[1], x[2][1]))),
        inner.map(lambda x: (f"(-{x[0]})", -x[1])),
        inner.map(lambda x: (f"cos({x[0]})", math.cos(x[1]))),
        inner.map(lambda x: (f"sqrt(({x[0]})^2)", math.sqrt(math.pow(x[1], 2.0)))),
    )


def calculated(a: float, sign: str, b: float) -> float:
    return a + b if sign == "+" else a - b if sign == "-" else a * b


@settings(max_examples=300)
@given(st.recursive(LEAVES, grown, max_leaves=8))
def test_a_tree_written_as_text_has_its_value(tree: tuple[str, float]):
    text, expected = tree
    if len(text) <= LONGEST:
        assert value(text) == expected
