"""Every kernel ready: from the cache, else compiled.

Where the cache can be written, kernels are compiled in processes of their own, beside each other
(`workshop`), and then read from it; where not, here and in memory. Of several processes that need them at
once one compiles, and the others wait (`waiting`)."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterable
from typing import Any

from gearlash.current_folder import elsewhere

from . import cache
from .announce import Say, announced, tell_waiting
from .collecting import not_collecting
from .declare import KERNELS, Kernel
from .waiting import one_at_a_time

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
        if cache.trouble(cache.cache_folder()):
            with announced(say):
                _compile_here(missing)
            return
        with one_at_a_time(lambda: tell_waiting(say)):
            missing = [
                kernel for kernel in missing if not _loaded(kernel)
            ]  # another process may have made them
            if missing:
                with announced(say):
                    from .workshop import compile_beside

                    compile_beside(missing)
                    _compile_here(missing)


def _compile_here(kernels: list[Kernel]) -> None:
    """What is not ready yet: where nothing can be kept, and what another process failed at, which here meets
    the reason."""
    for kernel in kernels:
        if not _loaded(kernel):
            from .compiling import compiled

            with elsewhere():
                _keep(kernel, *compiled(kernel))


def make_ready(kernel: Kernel) -> None:
    """One kernel, when it is first called. If it is not in the cache, others are likely to be missing too:
    they are compiled with it where they can be kept."""
    with _ONE_AT_A_TIME:
        if _loaded(kernel):
            return
        compile_all([kernel] if cache.trouble(cache.cache_folder()) else load_all())


def _loaded(kernel: Kernel) -> bool:
    """Whether it is ready, if need be from the cache."""
    if kernel.name not in _READY:
        kept = cache.read(kernel.name)
        if kept is None:
            return False
        from .compiling import loaded

        try:
            with elsewhere(), not_collecting():
                ready = loaded(kernel, kept)
        except OSError as error:
            cache.give_up(f"is not used, as there is no room for temporary files ({error.strerror or error})")
            return False
        cache.mark_used(cache.version_folder())
        _keep(kernel, *ready)
    return True


Kernel.make_ready = make_ready


def _keep(kernel: Kernel, entry: Callable[..., Any], files: cache.Files) -> None:
    kernel.entry = entry
    cache.write(kernel.name, files)
    _READY.add(kernel.name)
