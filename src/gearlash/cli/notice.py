"""Says that kernels are being compiled, when they are.

Kernels are compiled once a machine and version and then read from a cache.
"""

from __future__ import annotations

import time

from .terminal import tell

EXPECTED = 15  # seconds, all kernels on two slow cores


def load_engine() -> None:
    """Imports the engine and loads its kernels; one line on standard error if they must be compiled, and one
    when that is done."""
    from gearlash import flow  # noqa: F401  (declares the kernels)
    from gearlash._kernel import compile_all, load_all

    missing = load_all()
    if missing:
        began = time.monotonic()
        tell(first_words())
        compile_all(missing)
        tell(f"compiled in {time.monotonic() - began:.0f} s")


def first_words() -> str:
    """What is said before compiling."""
    from gearlash._kernel.cache import cache_folder, writable

    folder = cache_folder()
    if writable(folder):
        return f"compiling kernels, about {EXPECTED} s, once (kept in {folder})"
    return (
        f"compiling kernels, about {EXPECTED} s; {folder} cannot be written, so every run will: "
        "name another folder in GEARLASH_CACHE_DIR"
    )
