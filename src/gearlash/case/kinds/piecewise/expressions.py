"""Arithmetic in case files: ``"2*zeta*kappa"``, ``"F*omega^2"``, ``"cos(phase)"``.

Numbers, names, ``+ - * / ^`` (``**`` too), parentheses, ``sqrt cos sin exp``, ``pi``: nothing else. The text
is read by Python's own parser and every node that is not one of these is refused; nothing is ever executed.
All numbers are floats, so that no power grows beyond bounds.
"""

from __future__ import annotations

import ast
import keyword
import math
import operator
import re
import warnings
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from functools import cached_property
from math import isfinite, pi
from typing import TypeAlias

from gearlash.case.words import nearest_name

FUNCTIONS: dict[str, Callable[[float], float]] = {
    "sqrt": math.sqrt,
    "cos": math.cos,
    "sin": math.sin,
    "exp": math.exp,
}
CONSTANTS = {"pi": pi}
RESERVED = (*FUNCTIONS, *CONSTANTS)
GRAMMAR = "numbers, parameter names, + - * / ^, parentheses, sqrt cos sin exp, pi"
LONGEST = 400  # characters
DEEPEST = 100  # levels of nesting
LARGEST_NUMBER = 1e50
"""Bound of every number in a structure, so that no product of a few of them overflows."""

_OPERATORS: dict[type[ast.operator], Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: math.pow,
}
_ALLOWED = re.compile(r"[A-Za-z0-9_.+\-*/^() \t]*", re.ASCII)
_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,39}", re.ASCII)

Values: TypeAlias = Mapping[str, float]
Code: TypeAlias = Callable[[Values], float]


class ExpressionError(ValueError):
    """A text that is no expression, or one without a value; says what is expected and the nearest name."""

    def __init__(self, expected: str, nearest: str | None = None):
        self.expected, self.nearest = expected, nearest
        super().__init__(expected)


def is_name(text: str) -> bool:
    """May a parameter be called this?"""
    return bool(_NAME.fullmatch(text)) and not keyword.iskeyword(text) and text not in RESERVED


@dataclass(frozen=True)
class Expression:
    """A checked text. ``names`` are the parameters in it; calling it with their values gives a finite number
    or raises `ExpressionError`."""

    text: str
    names: frozenset[str]

    @staticmethod
    def read(text: str, known: Collection[str]) -> Expression:
        """The expression of a text in which these names may stand. Raises `ExpressionError`."""
        tree = _tree(text)
        _refuse(tree, known, 0)
        names = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
        return Expression(text, frozenset(names - set(RESERVED)))

    def __call__(self, values: Values) -> float:
        try:
            value = self._code(values)
        except (ValueError, OverflowError, ZeroDivisionError) as error:
            raise ExpressionError(f"an expression with a finite real value ({error})") from None
        if not abs(value) <= LARGEST_NUMBER:
            raise ExpressionError(
                f"an expression with a finite real value up to {LARGEST_NUMBER:g} (it is {value:g})"
            )
        return value

    @cached_property
    def _code(self) -> Code:
        return _compiled(_tree(self.text))

    def __getstate__(self) -> dict[str, object]:
        return {"text": self.text, "names": self.names}  # closures do not travel to other processes


def _tree(text: str) -> ast.expr:
    if not text.strip():
        raise ExpressionError(f"an expression ({GRAMMAR}); nothing stands there")
    if len(text) > LONGEST:
        raise ExpressionError(f"an expression of at most {LONGEST} characters")
    if not _ALLOWED.fullmatch(text):
        wrong = next(c for c in text if not _ALLOWED.fullmatch(c))
        raise ExpressionError(f"an expression ({GRAMMAR}), without {wrong!r}")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # Python's advice about its own syntax ("2if") helps nobody here
            return ast.parse(text.strip().replace("^", "**"), mode="eval").body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        raise ExpressionError(f"an expression ({GRAMMAR})") from None


def _refuse(node: ast.expr, known: Collection[str], depth: int) -> None:
    """Raises `ExpressionError` for whatever is not in the grammar."""
    if depth > DEEPEST:
        raise ExpressionError(f"an expression nested at most {DEEPEST} levels deep")
    match node:
        case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
            _finite(value)
        case ast.Name(id=name):
            _check_name(name, known)
        case ast.UnaryOp(op=ast.USub() | ast.UAdd(), operand=inner):
            _refuse(inner, known, depth + 1)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
            _refuse(left, known, depth + 1)
            _refuse(right, known, depth + 1)
        case ast.Call(func=ast.Name(id=name), args=[inner], keywords=[]) if name in FUNCTIONS:
            _refuse(inner, known, depth + 1)
        case ast.Call(func=ast.Name(id=name)):
            one = f"one of {', '.join(FUNCTIONS)} of one number"
            raise ExpressionError(one, None if name in FUNCTIONS else nearest_name(name, FUNCTIONS))
        case _:
            raise ExpressionError(f"an expression ({GRAMMAR})")


def _finite(value: float) -> float:
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not isfinite(number):
        raise ExpressionError("numbers that fit double precision")
    return number


def _check_name(name: str, known: Collection[str]) -> None:
    if name in FUNCTIONS:
        raise ExpressionError(f"parentheses after {name}, such as {name}(phase)")
    if name not in known and name not in CONSTANTS:
        raise ExpressionError(
            f"names of parameters or definitions only, not {name!r}", nearest_name(name, [*known, *RESERVED])
        )


def _compiled(node: ast.expr) -> Code:
    """The value of a checked tree as a function of the values of its names."""
    match node:
        case ast.Constant(value=int() | float() as value):
            number = _finite(value)
            return lambda _: number
        case ast.Name(id=name) if name in CONSTANTS:
            constant = CONSTANTS[name]
            return lambda _: constant
        case ast.Name(id=name):
            return operator.itemgetter(name)
        case ast.UnaryOp(op=op, operand=operand):
            inner = _compiled(operand)
            return (lambda v: -inner(v)) if isinstance(op, ast.USub) else inner
        case ast.BinOp(left=left, op=op, right=right):
            first, act, second = _compiled(left), _OPERATORS[type(op)], _compiled(right)
            return lambda v: act(first(v), second(v))
        case ast.Call(func=ast.Name(id=name), args=[argument]):
            function, inner = FUNCTIONS[name], _compiled(argument)
            return lambda v: function(inner(v))
    raise AssertionError(f"{ast.dump(node)} was not refused")
