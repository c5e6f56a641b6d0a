"""Python processes that this one starts: they do not import from the current folder either."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager

from gearlash.current_folder import is_here

SAFE = "-P"
"""Option of Python: nothing is put before the standard library."""


def environment() -> dict[str, str]:
    """The variables of this process, so that a Python that gets them does not import from the current
    folder."""
    found = {**os.environ, "PYTHONSAFEPATH": "1"}
    kept = [part for part in found.pop("PYTHONPATH", "").split(os.pathsep) if not is_here(part)]
    return {**found, "PYTHONPATH": os.pathsep.join(kept)} if kept else found


@contextmanager
def started_safely() -> Iterator[None]:
    """Within it, processes that `multiprocessing` starts have the variables of `environment`. (It takes none;
    they inherit those of this process.)"""
    names = ("PYTHONSAFEPATH", "PYTHONPATH")
    before, safe = {name: os.environ.get(name) for name in names}, environment()
    _set({name: safe.get(name) for name in names})
    try:
        yield
    finally:
        _set(before)


def _set(values: dict[str, str | None]) -> None:
    for name, value in values.items():
        if value is None:
            os.environ.pop(name, None)
        else:
            os.environ[name] = value
