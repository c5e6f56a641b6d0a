"""Says that kernels are being compiled, when they are.

Kernels are compiled once a machine and version and then read from a cache. Whether this run compiles is asked
of the compiler itself: it announces every compilation that the cache did not spare.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager

from .terminal import tell

EXPECTED = 30  # seconds, all kernels on a slow core


def load_engine() -> None:
    """Imports the engine; one line on standard error if that compiles kernels, and one when it is done."""
    with compilation_told():
        from gearlash import flow  # noqa: F401  (importing compiles)


@contextmanager
def compilation_told() -> Iterator[None]:
    """Says once that something is being compiled in this block, and how long it took."""
    from numba.core import event

    began: list[float] = []

    class Listener(event.Listener):
        def on_start(self, event: object) -> None:
            if not began:
                began.append(time.monotonic())
                tell(first_words())

        def on_end(self, event: object) -> None:
            pass

    listener = Listener()
    event.register("numba:compile", listener)
    try:
        yield
    finally:
        event.unregister("numba:compile", listener)
    if began:
        tell(f"compiled in {time.monotonic() - began[0]:.0f} s")


def first_words() -> str:
    """What is said at the first compilation."""
    from gearlash._kernel import _writable, cache_folder

    folder = cache_folder()
    if _writable(folder):
        return f"compiling kernels, about {EXPECTED} s, once (kept in {folder})"
    return (
        f"compiling kernels, about {EXPECTED} s; {folder} cannot be written, so every run will: "
        "name another folder in GEARLASH_CACHE_DIR"
    )
