"""From a kernel to a function of machine code, by numba and its cache.

numba's cache is a folder of pickles: whoever writes to it runs what he likes. So it is given one that is made
for this call, for this user alone, and removed again; what lies in it comes from, and goes to, the one sealed
file of the kernel (`cache`). Nothing of numba's settings is changed but for the moment in which a kernel is
told where that folder is. While it compiles, the folder lies beside the kernels: what is left of a process
that was killed is removed by the next one that compiles."""

from __future__ import annotations

import contextlib
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numba

from .cache import UNFINISHED, Files, cache_folder, make_version, trouble, version_folder
from .declare import Kernel
from .jit import NUMBA_SETTINGS


def loaded(kernel: Kernel, kept: Files) -> tuple[Callable[..., Any], Files]:
    """The kernel as a function, from what was kept of it; where numba does not take that, compiled, and the
    files to keep instead. Raises `OSError` where there is no room for a temporary folder."""
    with tempfile.TemporaryDirectory(prefix="gearlash-") as base:
        return _made(kernel, Path(base), kept)


def compiled(kernel: Kernel) -> tuple[Callable[..., Any], Files]:
    """The kernel as a function, and the files to keep; none where no folder can be written."""
    if not trouble(cache_folder()):
        with contextlib.suppress(OSError):
            make_version(version_folder())
            with tempfile.TemporaryDirectory(prefix=UNFINISHED, dir=version_folder()) as base:
                return _made(kernel, Path(base), {})
    return _ready(numba.njit(**kernel.options)(kernel.function), kernel), {}


def _made(kernel: Kernel, base: Path, kept: Files) -> tuple[Callable[..., Any], Files]:
    with _cache_in(base):
        dispatcher: Any = numba.njit(cache=True, **kernel.options)(kernel.function)
    folder = Path(dispatcher.stats.cache_path)
    if base not in folder.parents:
        raise OSError(f"numba keeps kernels in {folder}")
    for name, content in kept.items():
        (folder / name).write_bytes(content)
    ready = _ready(dispatcher, kernel)
    if dispatcher.stats.cache_hits:
        return ready, {}
    return ready, {file.name: file.read_bytes() for file in folder.iterdir()}


def _ready(dispatcher: Any, kernel: Kernel) -> Callable[..., Any]:
    dispatcher.compile(kernel.signature)
    dispatcher.disable_compile()
    return dispatcher


@contextlib.contextmanager
def _cache_in(folder: Path) -> Iterator[None]:
    """For kernels declared in this block numba's cache is this folder, whatever is set for others."""
    wanted = {"CACHE_DIR": str(folder), "CACHE_LOCATOR_CLASSES": ""}
    before = {name: getattr(NUMBA_SETTINGS, name) for name in wanted if hasattr(NUMBA_SETTINGS, name)}
    try:
        for name in before:
            setattr(NUMBA_SETTINGS, name, wanted[name])
        yield
    finally:
        for name, value in before.items():
            setattr(NUMBA_SETTINGS, name, value)
