"""Whatever a public function takes or returns, and whatever a public result holds, is public itself."""

from __future__ import annotations

import ast
import importlib
import inspect
import sys
from collections.abc import Iterator
from functools import cache
from typing import Any, get_args, get_type_hints

import pytest

from api.public import GUESTS, NAMESPACES, function_of, members, names

PUBLIC = names(NAMESPACES | GUESTS)
KERNELS = {"Responses", "Shape", "Tables"}
"""Arrays for the kernels, which `Propagators` carries; their content is no part of the interface."""


@cache
def only_for_types(module: str) -> dict[str, Any]:
    """What a module imports for type checkers only."""
    tree = ast.parse(inspect.getsource(sys.modules[module]))
    blocks = [n for n in tree.body if isinstance(n, ast.If) and ast.unparse(n.test) == "TYPE_CHECKING"]
    found: dict[str, Any] = {}
    for node in [node for block in blocks for node in block.body]:
        if isinstance(node, ast.Import):
            for alias in node.names:
                found[alias.asname or alias.name] = importlib.import_module(alias.name)
        elif isinstance(node, ast.ImportFrom):
            package = module if hasattr(sys.modules[module], "__path__") else module.rpartition(".")[0]
            home = importlib.import_module("." * node.level + (node.module or ""), package)
            for alias in node.names:
                found[alias.asname or alias.name] = getattr(home, alias.name)
    return found


def types_of(thing: Any) -> Iterator[type]:
    """The classes of gearlash that stand in the annotations of a function or of the fields of a class."""
    known = only_for_types(thing.__module__) if thing.__module__.startswith("gearlash") else {}
    hints = get_type_hints(thing, localns=known)
    waiting = list(hints.values())
    while waiting:
        hint = waiting.pop()
        if isinstance(hint, list | tuple):
            waiting.extend(hint)
        elif inspect.isclass(hint) and hint.__module__.startswith("gearlash"):
            yield hint
        else:
            waiting.extend(get_args(hint))


def met(value: Any) -> Iterator[type]:
    """The same of a class with its methods and properties."""
    yield from types_of(value)
    if inspect.isclass(value):
        for member in members(value).values():
            yield from types_of(function_of(member))


@pytest.mark.parametrize("name", sorted(PUBLIC))
def test_types_of_a_public_name_are_public(name: str):
    public = set(PUBLIC.values())
    hidden = {kind.__qualname__ for kind in met(PUBLIC[name]) if kind not in public}
    assert hidden - KERNELS == set()
