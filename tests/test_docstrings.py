"""Docstrings of public names have the form of numpydoc: arguments and their types, results, an example.

The examples are run by `tests/test_examples.py`. Fields of a result may stand as its attributes.
"""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any

import pytest
from numpydoc.docscrape import get_doc_object
from numpydoc.validate import validate

from api.public import NAMESPACES, function_of, is_a_property, is_made_by_its_arguments, members, names

PUBLIC = names(NAMESPACES)
FORM = {"GL06", "GL07", "GL08", "SS01", "SS03", "SS06", "PR10"}
"""Unknown sections or sections in another order, no docstring, no summary of one sentence in one line."""
ARGUMENTS = {"PR01", "PR02", "PR03", "PR04", "RT01"}
"""Arguments not described, not there, in another order or without a type; results not described."""
EXAMPLE = {"EX01"}


def faults(name: str, value: Any) -> Iterator[str]:
    """What is missing in the docstring of a public name, and in those of its methods and properties."""
    made = is_made_by_its_arguments(value)  # choices, errors and protocols need no example
    if not inspect.isclass(value):
        yield from told(name, value, FORM | ARGUMENTS | EXAMPLE)
        return
    yield from told(name, value, FORM | (EXAMPLE if made else set()))
    if made:
        yield from fields_told(name, value)
    for each, member in members(value).items():
        function = function_of(member)
        if is_a_property(member):
            if not function.__doc__:
                yield f"{name}.{each}: no docstring"
        else:
            yield from told(f"{name}.{each}", function, FORM | ARGUMENTS)


def told(name: str, value: Any, wanted: set[str]) -> Iterator[str]:
    """Of the faults that numpydoc finds those that are wanted."""
    for code, text in validate(get_doc_object(value))["errors"]:
        if code in wanted:
            yield f"{name}: {code} {text}"


def fields_told(name: str, value: type) -> Iterator[str]:
    """Arguments of a class that are not among its parameters or attributes, or have no type. Fields of what a
    command answers are described where they are declared: ``Annotated[float, "what it is"]``."""
    document = get_doc_object(value, config={"show_class_members": False})
    entries = [*document["Parameters"], *document["Attributes"]]
    described = {part.strip(): entry.type for entry in entries for part in entry.name.split(",")}
    declared = {field.name: str(field.type) for field in fields(value)} if is_dataclass(value) else {}
    for argument in inspect.signature(value).parameters:
        if declared.get(argument, "").startswith("Annotated["):
            continue
        if argument not in described:
            yield f"{name}: {argument} is not described"
        elif not described[argument]:
            yield f"{name}: {argument} has no type"


@pytest.mark.parametrize("name", sorted(PUBLIC))
def test_docstring_has_the_form(name: str):
    found = list(faults(name, PUBLIC[name]))
    assert not found, "\n".join(found)


def test_faults_are_found():
    """A docstring that lacks something is told apart from one that is whole."""

    def short(value: int) -> int:
        """No more than a sentence."""
        return value

    said = " ".join(faults("short", short))
    assert all(part in said for part in ("PR01", "RT01", "EX01"))
