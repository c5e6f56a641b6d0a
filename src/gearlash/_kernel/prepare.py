"""Every kernel ready: from the cache, else compiled.

Where the cache can be written, kernels are compiled in processes of their own, beside each other
(`workshop`), and then read from it; where not, here and in memory."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable
from typing import Any

from . import cache
from .announce import Say, announced
from .declare import KERNELS, Kernel

_ONE_AT_A_TIME = threading.RLock()
_READY: set[str] = set()


def load_all() -> list[Kernel]:
    """Loads every kernel declared so far that is in the cache; returns those that must be compiled."""
    with _ONE_AT_A_TIME:
        return [kernel for kernel in KERNELS.values() if not _loaded(kernel)]


def compile_all(missing: Iterable[Kernel], say: Say | None = None) -> None:
    """Compiles these and makes them ready; ``say`` is told so, else standard error."""
    with _ONE_AT_A_TIME:
        missing = list(missing)
        if not missing:
            return
        with announced(say):
            if not cache.trouble(cache.cache_folder()):
                from .workshop import compile_beside

                compile_beside(missing)
            for kernel in missing:
                if not _loaded(kernel):
                    _compile_here(kernel)


def make_ready(kernel: Kernel) -> None:
    """One kernel, when it is first called. If it is not in the cache, others are likely to be missing too:
    they are compiled with it where they can be kept."""
    with _ONE_AT_A_TIME:
        if _loaded(kernel):
            return
        compile_all([kernel] if cache.trouble(cache.cache_folder()) else load_all())


def _loaded(kernel: Kernel) -> bool:
    if kernel.name not in _READY:
        from .machine import can_load, load

        code = cache.read(kernel.name)
        if code is None or not can_load(code):
            return False
        cache.mark_used(cache.version_folder())
        _be_called(kernel, load(code, kernel.signature))
    return True


def _compile_here(kernel: Kernel) -> None:
    from .compiling import compile_kernel
    from .machine import callable_at

    code, address = compile_kernel(kernel)
    cache.write(kernel.name, code)
    _be_called(kernel, callable_at(address, kernel.function.__name__, kernel.signature))


def _be_called(kernel: Kernel, entry: Callable[..., Any]) -> None:
    kernel.entry = entry
    _READY.add(kernel.name)
