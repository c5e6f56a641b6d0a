"""Compiles kernels beside each other, in processes of their own: one for each that takes long, one for the
rest. They hand them over through the cache."""

from __future__ import annotations

import contextlib
import gc
import json
import os
import subprocess
import sys
import threading
from collections.abc import Iterable, Iterator
from importlib import import_module

from gearlash.current_folder import path_without_it

from . import cache, children
from .declare import KERNELS, Kernel

PROGRAM = """
import json, sys
order = json.loads(sys.stdin.readline())
sys.path[:] = order["path"]
from importlib import import_module
import_module(order["workshop"]).work(order["kernels"])
"""


def compile_beside(kernels: Iterable[Kernel]) -> None:
    """Compiles these into the cache. What a process fails at is missing there afterwards; the caller compiles
    it itself and meets the reason."""
    if getattr(sys, "frozen", False) or not sys.executable:
        return  # no Python to start
    with contextlib.ExitStack() as running:
        processes = [running.enter_context(_started(share)) for share in _shares(kernels)]
        for process in processes:
            process.wait()


def _shares(kernels: Iterable[Kernel]) -> list[list[Kernel]]:
    kernels = list(kernels)
    shares = [[kernel] for kernel in kernels if kernel.alone]
    return [share for share in (*shares, [kernel for kernel in kernels if not kernel.alone]) if share]


@contextlib.contextmanager
def _started(kernels: list[Kernel]) -> Iterator[subprocess.Popen[str]]:
    """A process that compiles these; ended with the block."""
    order = {
        "path": path_without_it(),
        "workshop": __name__,
        "kernels": [(kernel.function.__module__, kernel.name) for kernel in kernels],
    }
    process = subprocess.Popen(
        [sys.executable, children.SAFE, "-c", PROGRAM],
        env=children.environment(),
        cwd=os.sep,  # numba reads a file of settings in the current folder
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    try:
        assert process.stdin is not None
        with contextlib.suppress(BrokenPipeError):
            process.stdin.write(json.dumps(order) + "\n")
            process.stdin.flush()
        yield process  # its input stays open: it ends with that, however this process ends
    finally:
        process.kill()
        process.wait()
        if process.stdin is not None:
            with contextlib.suppress(BrokenPipeError):
                process.stdin.close()


def work(order: list[tuple[str, str]]) -> None:
    """What such a process does."""
    gc.disable()  # it ends soon
    threading.Thread(target=_end_with_input, daemon=True).start()
    from .compiling import compiled

    for module, name in order:
        import_module(module)
        _, files = compiled(KERNELS[name])
        cache.write(name, files)


def _end_with_input() -> None:
    while os.read(0, 65536):  # not through sys.stdin, whose lock would still be held when the process ends
        pass
    os._exit(1)
