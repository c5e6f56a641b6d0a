"""What numba makes of the keywords that its pages do not list, seen in the code that it generates: a version
that no longer knows one of them does not slow everything down in silence."""

from __future__ import annotations

import ast
import re
import tomllib
from collections.abc import Callable
from pathlib import Path
from types import FunctionType
from typing import Any

import numba
import numpy as np
import pytest

import gearlash
from gearlash._kernel.declare import KERNELS
from gearlash._kernel.jit import array_of, float64, int64
from gearlash._kernel.options import COUNTED, ENTRY, HELPER, INLINED, NOT_COUNTED

pytestmark = pytest.mark.skipif(bool(numba.config.DISABLE_JIT), reason="nothing is compiled")  # pyright: ignore
FLOATS = array_of(float64, 1)


def two_rows(values: np.ndarray, n: int) -> float:
    """Takes arrays apart, which is where references are counted."""
    low, high = values[:n], values[n:]
    total = 0.0
    for i in range(n):
        total += last(low, i) * last(high, i)
    return total * last(values, 0) - last(values, n)


def last(values: np.ndarray, i: int) -> float:
    """Too long to be inlined by itself."""
    part = values[i:]
    end, found = part[len(part) - 1], part[0]
    for k in range(len(part)):
        found = found * np.sin(end) + np.cos(found) * np.exp(-found * found) + np.log(1.0 + part[k] * part[k])
        found += np.arctan(found) * np.tanh(end) - np.sqrt(abs(found)) + np.floor(found)
        found -= np.sin(found + 1.0) * np.cos(found - 1.0) * np.exp(-abs(found)) / (1.0 + found * found)
        found += np.sinh(np.sin(found)) * np.cosh(np.cos(found)) + np.arctan2(found, end)
    return found


def code(helper: dict[str, Any], counts: dict[str, Any]) -> str:
    """What becomes of `two_rows` with a helper of these options."""
    compiled = numba.njit(**helper, **counts)(last)
    names = {**two_rows.__globals__, "last": compiled}
    caller = FunctionType(two_rows.__code__, names, "two_rows")
    entry: Any = numba.njit(**ENTRY, **counts)(caller)
    entry.compile(float64(FLOATS, int64))
    values = np.arange(6.0)
    assert entry(values, 3) == pytest.approx(two_rows(values, 3))
    return next(iter(entry.inspect_llvm().values()))


def calls(text: str, name: str) -> int:
    return len(re.findall(rf"call [^\n@]*@[^\s(]*{name}", text))


def counted(text: str) -> int:
    """Places where a reference is counted, by a call or in place."""
    return calls(text, "NRT_incref") + calls(text, "NRT_decref") + len(re.findall(r"atomicrmw", text))


def test_without_counts_no_reference_is_counted():
    assert counted(code(HELPER, NOT_COUNTED)) == 0
    assert counted(code(HELPER, COUNTED)) > 0  # so the other can fail


def test_inlined_helpers_leave_no_call():
    assert calls(code(INLINED, NOT_COUNTED), "last") == 0
    assert calls(code(HELPER, NOT_COUNTED), "last") > 1  # so the other can fail


@pytest.mark.parametrize("options", [HELPER, INLINED])
def test_nothing_is_compiled_for_calls_of_helpers_from_python(options: dict[str, Any]):
    helper: Any = numba.njit(**options, **NOT_COUNTED)(last)
    helper.compile(float64(FLOATS, int64))
    text = next(iter(helper.inspect_llvm().values()))
    assert "cpython" not in text
    assert "PyObject" not in text
    assert "cfunc" not in text


def test_the_newest_numba_that_is_allowed_is_the_one_that_was_tried():
    project = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text(encoding="utf-8"))
    (bound,) = (text for text in project["project"]["dependencies"] if text.startswith("numba"))
    major, minor = map(int, numba.__version__.split(".")[:2])
    assert bound.endswith(f",<{major}.{minor + 1}")


def test_kernels_of_the_flow_count_no_references():
    """Of the smallest one that is written so: what its helpers are compiled with is what they all are."""
    from gearlash.flow._cells import stiffness_series

    kernel: Any = stiffness_series
    made: Callable[..., Any] = numba.njit(**kernel.options)(kernel.function)
    made.compile(kernel.signature)  # pyright: ignore[reportFunctionMemberAccess]
    text = next(iter(made.inspect_llvm().values()))  # pyright: ignore[reportFunctionMemberAccess]
    assert counted(text) == 0


PUBLIC = {"numba": "", "numba.extending": "intrinsic", "llvmlite": "", "llvmlite.binding": ""}
"""Modules that numba's and llvmlite's pages describe, and what alone is taken of one."""


def test_nothing_private_of_numba_is_used():
    """Only described modules are imported, nothing of them by a name with an underscore."""
    for path in Path(gearlash.__file__).parent.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            imported: list[tuple[str, str]] = []
            if isinstance(node, ast.Import):
                imported = [(alias.name, "") for alias in node.names]
            elif isinstance(node, ast.ImportFrom) and not node.level:
                imported = [(node.module or "", alias.name) for alias in node.names]
            for module, name in imported:
                if module.partition(".")[0] in ("numba", "llvmlite"):
                    assert module in PUBLIC, f"{path}: {module}"
                    assert not name.startswith("_"), f"{path}: {name}"
                    assert not PUBLIC[module] or name == PUBLIC[module], f"{path}: {name}"


def test_entry_points_take_at_most_twenty_arguments():
    """Each costs every call its time."""
    from gearlash.flow import _ensemble  # noqa: F401  (declares its kernel)

    counts = {name: len(kernel.signature.args) for name, kernel in KERNELS.items()}
    assert max(counts.values()) <= 20, counts
