"""Calls of compiled kernels: numbers in and out, and what is refused before machine code sees it."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator
from importlib import import_module, invalidate_caches
from typing import Any

import numpy as np
import pytest

from gearlash._kernel import machine
from gearlash._kernel.cache import Code
from kernel.tiny import write

KERNELS = """
from typing import NamedTuple
import numpy as np
from tiny._kernel import (
    ArrayOf, Record, Several, allocating, boolean, float64, fma, int64, kernel, void
)

FLOATS = ArrayOf(float64, 1, writable=False)

class Sizes(NamedTuple):
    first: int
    second: int

@kernel(int64(Record(Sizes), ArrayOf(float64, 2), ArrayOf(int64, 1), FLOATS, float64, int64, boolean))
def every(sizes, table, counts, read, x, k, negative):
    table[sizes.first, sizes.second] = -x if negative else x
    counts[k] += len(read) * table.shape[0]
    return counts[k]

@kernel(void(ArrayOf(float64, 1)))
def cleared(values):
    for i in range(len(values)):
        values[i] = 0.0

@allocating
def squares(n):
    made = np.zeros(n)
    for i in range(n):
        made[i] = i * i
    return made

@kernel(Several(float64, 2)(int64), allocates=True)
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
        "sizes": tiny.Sizes(1, 2),
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
    values = np.ones(4)
    assert tiny.cleared(values) is None
    assert not values.any()
    assert tiny.extremes(5) == (0.0, 16.0)


def test_minus_one_is_a_number_and_no_error(tiny: Any, given: dict[str, Any]):
    given["counts"][:] = -11
    assert tiny.every(*given.values()) == -1
    tiny.every(*{**given, "x": -1.0, "negative": False}.values())
    assert given["table"][1, 2] == -1.0


def test_a_fused_multiply_add_is_rounded_once(tiny: Any):
    a = 1.0 + 2.0**-30
    assert tiny.fused(a, a, -(1.0 + 2.0**-29)) == 2.0**-60
    assert a * a - (1.0 + 2.0**-29) == 0.0


def read_only(array: np.ndarray) -> np.ndarray:
    array.setflags(write=False)
    return array


def unaligned() -> np.ndarray:
    return np.frombuffer(bytearray(41), dtype=np.uint8)[1:].view(np.float64)


WRONG: list[tuple[str, Callable[[], Any], str]] = [
    ("sizes", lambda: (1, 2), "sizes is not a Sizes"),
    (
        "table",
        lambda: np.zeros((2, 3), dtype=np.float32),
        "table is not a writable C-contiguous 2-dimensional",
    ),
    ("table", lambda: np.zeros((2, 3), dtype=np.int64), "array of float64"),
    ("table", lambda: np.zeros((2, 3), dtype=">f8"), "array of float64"),
    ("table", lambda: np.zeros((2, 3), dtype=np.complex128), "array of float64"),
    ("table", lambda: np.zeros(6), "table is not"),
    ("table", lambda: np.zeros((3, 2)).T, "table is not"),
    ("table", lambda: np.zeros((2, 6))[:, ::2], "table is not"),
    ("table", lambda: read_only(np.zeros((2, 3))), "table is not a writable"),
    ("table", lambda: [[0.0] * 3] * 2, "table is not"),
    ("table", lambda: None, "table is not"),
    ("counts", lambda: np.zeros(2), "array of int64"),
    ("counts", lambda: np.zeros(2, dtype=np.int32), "array of int64"),
    ("counts", lambda: np.zeros(2, dtype=np.uint64), "array of int64"),
    ("read", lambda: np.zeros(10)[::2], "read is not a C-contiguous 1-dimensional array of float64"),
    ("read", unaligned, "read is not"),
    ("x", lambda: "2.5", "x is not a number"),
    ("x", lambda: np.zeros(2), "x is not a number"),
    ("k", lambda: 1.0, "k is not a number"),
    ("k", lambda: 2**70, "k is not a number"),
    ("negative", lambda: np.zeros(2), "negative is not a number"),
]


@pytest.mark.parametrize(("name", "wrong", "said"), WRONG)
def test_what_does_not_fit_is_refused_by_name(
    name: str, wrong: Callable[[], Any], said: str, tiny: Any, given: dict[str, Any]
):
    with pytest.raises(TypeError, match=f"every: .*{said}"):
        tiny.every(*{**given, name: wrong()}.values())
    assert not given["counts"].any()


def test_a_record_of_something_else_than_whole_numbers_is_refused(tiny: Any, given: dict[str, Any]):
    with pytest.raises(TypeError, match=r"every: sizes\.second is not a number"):
        tiny.every(*{**given, "sizes": tiny.Sizes(1, "two")}.values())
    with pytest.raises(TypeError, match=r"every: sizes\.second is not a number"):
        tiny.every(*{**given, "sizes": tuple.__new__(tiny.Sizes, (1,))}.values())


@pytest.mark.parametrize("count", [0, 6, 8])
def test_too_few_and_too_many_arguments_are_refused(count: int, tiny: Any, given: dict[str, Any]):
    with pytest.raises(TypeError, match="every takes 7 positional arguments"):
        tiny.every(*[*given.values(), 0][:count])


def test_an_array_that_was_pickled_has_a_type_object_of_its_own_and_fits(tiny: Any):
    import pickle

    values = pickle.loads(pickle.dumps(np.ones(3)))
    assert values.dtype is not np.ones(3).dtype
    tiny.cleared(values)
    assert not values.any()


def test_memory_that_cannot_be_had_is_said(tiny: Any):
    with pytest.raises(MemoryError, match="extremes: its work space cannot be had"):
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


def test_code_that_needs_what_is_nowhere_is_not_loaded():
    assert machine.can_load(Code(b"", "some.kernel", ("malloc", "PyErr_SetString")))
    assert not machine.can_load(Code(b"", "some.kernel", ("malloc", "no_such_function_anywhere")))


def test_arrays_laid_out_in_another_way_are_not_read(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setitem(machine.ARRAY_PLACES, "ndim", machine.ARRAY_PLACES["flags"])
    with pytest.raises(ImportError, match="does not know: ndim"):
        machine._check_layout.__wrapped__()
