"""Examples in docstrings of public names are run."""

from __future__ import annotations

import doctest
import inspect

import pytest

import gearlash

FINDER = doctest.DocTestFinder(recurse=False)


def _examples() -> dict[str, doctest.DocTest]:
    """By name, of what has any."""
    found: dict[str, doctest.DocTest] = {}
    for name in gearlash.__all__:
        thing = getattr(gearlash, name)
        members = [(name, thing)]
        if inspect.isclass(thing):
            members += [(f"{name}.{m}", value) for m, value in vars(thing).items() if not m.startswith("_")]
        for label, member in members:
            member = getattr(member, "__func__", member)
            for test in FINDER.find(member, label, globs={}) if getattr(member, "__doc__", None) else ():
                if test.examples:
                    found[label] = test
    return found


EXAMPLES = _examples()


def test_there_are_some():
    assert {"first_grazing", "impact_free_speeds"} <= set(EXAMPLES)


@pytest.mark.parametrize("name", sorted(EXAMPLES))
def test_example(name: str, capsys: pytest.CaptureFixture[str]):
    failed = doctest.DocTestRunner().run(EXAMPLES[name]).failed
    assert failed == 0, capsys.readouterr().out
