"""Says that kernels are being compiled, when they are: the first call on a machine would otherwise take more
than half a minute without a word.

On standard error, unless `GEARLASH_QUIET` is set to anything but 0."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

from . import cache

EXPECTED = "30 s on two free cores"  # 55 s of their time
Say = Callable[[str], object]
_said: list[str] = []


def keep_silent() -> None:
    """For a process that works for another one, which has said it."""
    _said.append("")


def said() -> bool:
    """Whether this process has said it already."""
    return bool(_said)


@contextmanager
def announced(say: Say | None = None) -> Iterator[None]:
    """Around compiling: what is going on and how long it takes, then how long it took. A process whose
    kernels cannot be kept compiles one after the other and says it once."""
    if said() or _quiet(say):
        yield
        return
    say = say or _on_standard_error
    words, began = first_words(), time.monotonic()
    say(words)
    yield
    if cache.trouble(cache.cache_folder()):
        _said.append(words)
    say(f"compiled in {time.monotonic() - began:.0f} s")


def tell_waiting(say: Say | None = None) -> None:
    """Another process compiles what this one needs."""
    if not (said() or _quiet(say)):
        (say or _on_standard_error)("another run is compiling the kernels; waiting for it")


def _quiet(say: Say | None) -> bool:
    return say is None and os.environ.get("GEARLASH_QUIET", "0") not in ("", "0")


def first_words() -> str:
    """What is said before compiling."""
    folder = cache.cache_folder()
    trouble = cache.trouble(folder)
    if not trouble:
        return f"compiling kernels, about {EXPECTED}, once (kept in {folder})"
    return (
        f"compiling kernels, about {EXPECTED}; {folder} {trouble}, so every run will: "
        "name another folder in GEARLASH_CACHE_DIR"
    )


def _on_standard_error(message: str) -> None:
    if sys.stderr is not None:
        with suppress(OSError, ValueError):  # closed; compiling goes on
            print(f"gearlash: {message}", file=sys.stderr, flush=True)
