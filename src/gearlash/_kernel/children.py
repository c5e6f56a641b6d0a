"""Python processes that this one starts: they do not import from the current folder either."""

from __future__ import annotations

import os

from gearlash.current_folder import is_here

SAFE = "-P"
"""Option of Python: nothing is put before the standard library."""


def environment() -> dict[str, str]:
    """The variables of this process, so that a Python that gets them does not import from the current
    folder."""
    found = {**os.environ, "PYTHONSAFEPATH": "1"}
    kept = [part for part in found.pop("PYTHONPATH", "").split(os.pathsep) if not is_here(part)]
    return {**found, "PYTHONPATH": os.pathsep.join(kept)} if kept else found
