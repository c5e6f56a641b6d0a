"""The names of the room of gears, which are imported when they are first used."""

from __future__ import annotations

import ast
import inspect

import pytest

from gearlash import gears


@pytest.mark.parametrize("name", gears.__all__)
def test_every_public_name_is_there(name: str):
    value = getattr(gears, name)
    assert inspect.ismodule(value) == (name not in gears._WHERE)


def test_the_lists_agree():
    tree = ast.parse(inspect.getsource(gears))
    checked = next(node for node in tree.body if isinstance(node, ast.If))
    typed = {
        alias.asname for node in checked.body if isinstance(node, ast.ImportFrom) for alias in node.names
    }
    assert typed == set(gears.__all__)
    assert set(gears._WHERE) <= set(gears.__all__)


def test_an_unknown_name_is_named():
    with pytest.raises(AttributeError, match="nothing_of_it"):
        _ = gears.nothing_of_it
