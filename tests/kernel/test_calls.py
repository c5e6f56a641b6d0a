"""Calls of compiled kernels: numbers in and out, and what does not fit is refused."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator
from importlib import import_module, invalidate_caches
from typing import Any

import numpy as np
import pytest

from kernel.tiny import write

KERNELS = """
from typing import NamedTuple
import numpy as np
from tiny._kernel.jit import (
    allocating, array_of, boolean, float64, fma, inlined, inner, int64, kernel, record_of, tuple_of, void
)

FLOATS = array_of(float64, 1, writable=False)

class Place(NamedTuple):
    table: np.ndarray
    counts: np.ndarray

PLACE = record_of(Place, array_of(float64, 2), array_of(int64, 1))

@kernel(int64(PLACE, array_of(float64, 2), array_of(int64, 1), FLOATS, float64, int64, boolean))
def every(place, table, counts, read, x, k, negative):
    place.table[0, 0] = x
    table[1, 2] = -x if negative else x
    counts[k] += len(read) * table.shape[0]
    return counts[k]

@kernel(void(array_of(float64, 1)))
def cleared(values):
    for i in range(len(values)):
        values[i] = 0.0

@allocating
def squares(n):
    made = np.zeros(n)
    for i in range(n):
        made[i] = i * i
    return made

@kernel(tuple_of(float64, 2)(int64), allocates=True)
def extremes(n):
    made = squares(n)
    return made[0], made[n - 1]

@kernel(float64(float64, float64, float64))
def fused(a, b, c):
    return fma(a, b, c)
"""


@pytest.fixture(scope="module")
def tiny(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    """The module with those kernels, in this process."""
    folder = write(tmp_path_factory.mktemp("package"), KERNELS)
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(folder)
        patch.setenv("GEARLASH_CACHE_DIR", str(folder / "cache"))
        invalidate_caches()
        yield import_module("tiny._caller")


@pytest.fixture
def given(tiny: Any) -> dict[str, Any]:
    """Arguments of `every`, by name."""
    return {
        "place": tiny.Place(np.zeros((1, 1)), np.zeros(1, dtype=np.int64)),
        "table": np.zeros((2, 3)),
        "counts": np.zeros(2, dtype=np.int64),
        "read": np.zeros(5),
        "x": 2.5,
        "k": 1,
        "negative": True,
    }


def test_numbers_go_in_and_come_out(tiny: Any, given: dict[str, Any]):
    given["read"].setflags(write=False)
    assert tiny.every(*given.values()) == 10
    assert tiny.every(*{**given, "negative": False, "k": np.int32(1), "x": 3}.values()) == 20
    assert given["table"].tolist() == [[0.0, 0.0, 0.0], [0.0, 0.0, 3.0]]
    assert given["counts"].tolist() == [0, 20]
    assert given["place"].table[0, 0] == 3.0
    values = np.ones(4)
    assert tiny.cleared(values) is None
    assert not values.any()
    assert tiny.extremes(5) == (0.0, 16.0)


def test_a_fused_multiply_add_is_rounded_once(tiny: Any):
    a = 1.0 + 2.0**-30
    assert tiny.fused(a, a, -(1.0 + 2.0**-29)) == 2.0**-60
    assert a * a - (1.0 + 2.0**-29) == 0.0


def read_only(array: np.ndarray) -> np.ndarray:
    array.setflags(write=False)
    return array


WRONG: list[tuple[str, Callable[[], Any]]] = [
    ("place", lambda: (np.zeros((1, 1)), np.zeros(1, dtype=np.int64))),
    ("table", lambda: np.zeros((2, 3), dtype=np.float32)),
    ("table", lambda: np.zeros((2, 3), dtype=np.int64)),
    ("table", lambda: np.zeros(6)),
    ("table", lambda: np.zeros((3, 2)).T),
    ("table", lambda: np.zeros((2, 6))[:, ::2]),
    ("table", lambda: read_only(np.zeros((2, 3)))),
    ("table", lambda: None),
    ("counts", lambda: np.zeros(2, dtype=np.int32)),
    ("read", lambda: np.zeros(10)[::2]),
    ("x", lambda: "2.5"),
]


@pytest.mark.parametrize(("name", "wrong"), WRONG)
def test_what_does_not_fit_is_refused(name: str, wrong: Callable[[], Any], tiny: Any, given: dict[str, Any]):
    with pytest.raises(TypeError):
        tiny.every(*{**given, name: wrong()}.values())
    assert not given["counts"].any()


@pytest.mark.parametrize("count", [0, 6, 8])
def test_too_few_and_too_many_arguments_are_refused(count: int, tiny: Any, given: dict[str, Any]):
    with pytest.raises(TypeError):
        tiny.every(*[*given.values(), 0][:count])


def test_memory_that_cannot_be_had_is_said(tiny: Any):
    with pytest.raises(MemoryError):
        tiny.extremes(2**55)


@pytest.mark.skipif(sys.platform != "linux", reason="ru_maxrss in kilobytes")
def test_memory_that_was_had_is_given_back(tiny: Any):
    resource = pytest.importorskip("resource")
    tiny.extremes(10**6)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for _ in range(200):
        tiny.extremes(10**6)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss < before + 200_000


def test_first_calls_from_many_threads(tiny: Any):
    from tiny._kernel import prepare  # pyright: ignore[reportMissingImports]

    prepare._READY.discard(tiny.fused.name)
    tiny.fused.entry = tiny.fused._first
    found: list[float] = []
    threads = [threading.Thread(target=lambda: found.append(tiny.fused(2.0, 3.0, 1.0))) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [7.0] * 8
