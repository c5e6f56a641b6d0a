"""Says that kernels are being compiled, when they are.

Kernels are compiled once a machine and version and then read from a cache. Whether this run compiles is asked
of the compiler itself: it announces every compilation that the cache did not spare.
"""

from __future__ import annotations

import time

from .terminal import tell

EXPECTED = 30  # seconds, all kernels on a slow core


def load_engine() -> None:
    """Imports the engine; one line on standard error if that compiles kernels, and one when it is done."""
    from numba.core import event

    listener = _listener(event)
    event.register("numba:compile", listener)
    try:
        from gearlash import flow  # noqa: F401  (importing compiles)
    finally:
        event.unregister("numba:compile", listener)
    if listener.began is not None:
        tell(f"compiled in {time.monotonic() - listener.began:.0f} s")


def _listener(event):
    class FirstCompilation(event.Listener):
        began: float | None = None

        def on_start(self, event):
            if self.began is None:
                self.began = time.monotonic()
                tell(first_words())

        def on_end(self, event):
            pass

    return FirstCompilation()


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
