"""Examples in docstrings are run: of the public names of the package and of its rooms."""

from __future__ import annotations

import doctest
import inspect
from importlib import import_module

import pytest

FINDER = doctest.DocTestFinder(recurse=False)
MODULES = (
    "gearlash",
    "gearlash.article",
    "gearlash.case",
    "gearlash.case.kinds",
    "gearlash.gears",
    "gearlash.gears.backlash",
    "gearlash.gears.basic_rack",
    "gearlash.gears.cylindrical_pair",
    "gearlash.gears.dynamic_factor",
    "gearlash.gears.estimates",
    "gearlash.gears.flank_tolerances",
    "gearlash.gears.gear_body",
    "gearlash.gears.gear_fits",
    "gearlash.gears.helical",
    "gearlash.gears.inspection",
    "gearlash.gears.involute",
    "gearlash.gears.materials",
    "gearlash.gears.mesh_cycle",
    "gearlash.gears.mesh_stiffness",
    "gearlash.gears.pair_shape",
    "gearlash.gears.root_fillet",
    "gearlash.gears.spur",
    "gearlash.gears.tooth_form",
    "gearlash.gears.tooth_pair",
    "gearlash.gears.unloaded_error",
    "gearlash.gears.waveform",
    "gearlash.plots",
    "gearlash.report",
)


def _examples() -> dict[str, doctest.DocTest]:
    """By name, of what has any; what two modules have once."""
    found: dict[str, doctest.DocTest] = {}
    seen: set[int] = set()
    for place in MODULES:
        module = import_module(place)
        for name in getattr(module, "__all__", None) or _own(module):
            thing = getattr(module, name)
            if not str(getattr(thing, "__module__", "")).startswith("gearlash"):
                continue  # a name for a type of another package
            members = [(f"{place}.{name}", thing)]
            if inspect.isclass(thing):
                own = vars(thing).items()
                members += [(f"{place}.{name}.{m}", value) for m, value in own if not m.startswith("_")]
            for label, member in members:
                member = getattr(member, "__func__", member)
                if id(member) in seen or not getattr(member, "__doc__", None):
                    continue
                seen.add(id(member))
                for test in FINDER.find(member, label, globs={}):
                    if test.examples:
                        found[label] = test
    return found


def _own(module) -> list[str]:
    """Functions and classes that a module without a list of names defines."""
    return [
        name
        for name, thing in vars(module).items()
        if not name.startswith("_") and getattr(thing, "__module__", None) == module.__name__
    ]


EXAMPLES = _examples()


def test_there_are_some():
    assert {"gearlash.first_grazing", "gearlash.gears.spur.family"} <= set(EXAMPLES)


@pytest.mark.parametrize("name", sorted(EXAMPLES))
def test_example(name: str, capsys: pytest.CaptureFixture[str]):
    failed = doctest.DocTestRunner().run(EXAMPLES[name]).failed
    assert failed == 0, capsys.readouterr().out
