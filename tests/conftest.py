"""What every test process starts with."""

from __future__ import annotations

import os

import pytest
from hypothesis import settings

os.environ.setdefault("MPLBACKEND", "Agg")

# Examples are drawn the same way in every run; none fails for being slow, as the first one compiles kernels.
settings.register_profile("gearlash", deadline=None, derandomize=True)
settings.load_profile("gearlash")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Coverage counts the first case of every test, and no slow one: counting makes Python take twice as
    long, and other cases of a test go nearly the same ways. Without compiled kernels all counts, as only
    there kernels do."""
    if os.environ.get("NUMBA_DISABLE_JIT", "0") not in ("", "0"):
        return
    seen = set()
    for item in items:
        test = item.nodeid.partition("[")[0]
        if test in seen or item.get_closest_marker("slow"):
            item.add_marker("no_cover")
        seen.add(test)
