"""The decorators of kernels, and the words of their signatures: a thin layer over numba.

Helpers are functions of `numba.njit`; entry points become so when they are first called (`prepare`), with
their signature and from the cache. With NUMBA_DISABLE_JIT=1 every kernel is the plain function that it is
written as. Importing this imports numba: only modules with kernels do."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any, TypeVar

from gearlash.current_folder import elsewhere

from .collecting import not_collecting
from .declare import KERNELS, Kernel
from .options import COUNTED, ENTRY, HELPER, INLINED, NOT_COUNTED

with elsewhere(), not_collecting():
    import numba
    from numba import boolean, float64, int64, njit, types, void
    from numba.extending import intrinsic

__all__ = [
    "allocating",
    "array_of",
    "boolean",
    "float64",
    "fma",
    "inlined",
    "inner",
    "int64",
    "kernel",
    "record_of",
    "tuple_of",
    "void",
    "written_out",
]

F = TypeVar("F", bound=Callable[..., Any])

NUMBA_SETTINGS: Any = numba.config  # pyright: ignore[reportPrivateImportUsage]  (documented as numba.config)
"""Of numba: the user's, and left as they are."""

PLAIN = bool(NUMBA_SETTINGS.DISABLE_JIT)
"""Whether kernels run as plain Python."""


def array_of(kind: Any, dimensions: int, writable: bool = True) -> Any:
    """A C-contiguous array; one that is only read need not be ``writable``."""
    return types.Array(kind, dimensions, "C", readonly=not writable)


def tuple_of(kind: Any, count: int) -> Any:
    """So many numbers, as a result."""
    return types.UniTuple(kind, count)


def record_of(named: type, *kinds: Any) -> Any:
    """A NamedTuple of arrays. It is taken apart in every call, which costs more than to give them one by
    one: for calls that take long."""
    return types.NamedTuple(kinds, named)


if TYPE_CHECKING:

    def kernel(signature: Any, allocates: bool = False, alone: bool = False) -> Callable[[F], F]: ...
    def inner(function: F) -> F: ...
    def inlined(function: F) -> F: ...
    def allocating(function: F) -> F: ...
    def written_out(home: str) -> Callable[[F], F]: ...

else:

    def kernel(signature, allocates=False, alone=False):
        """An entry point for one explicit signature. Unless it ``allocates`` arrays it is compiled without
        reference counts. ``alone``: it takes as long to compile as all others together, and gets a process
        of its own for that."""

        def wrap(function):
            if PLAIN:
                return function
            options = {**ENTRY, **(COUNTED if allocates else NOT_COUNTED)}
            made = Kernel(function, signature, options, alone)
            KERNELS[made.name] = made
            return made

        return wrap

    def inner(function):
        """A helper that only kernels call: compiled into its callers and kept with them. It allocates
        nothing."""
        return njit(**HELPER, **NOT_COUNTED)(function)

    def inlined(function):
        """A helper on the hot path: no call is left of it. (A call passes every array as seven numbers, which
        can cost more than its work.)"""
        return njit(**INLINED, **NOT_COUNTED)(function)

    def allocating(function):
        """A helper that makes arrays."""
        return njit(**HELPER, **COUNTED)(function)

    def written_out(home):
        """A function in place of which kernels get the intrinsic of the same name in module ``home``: there
        its machine code is written by hand. What it says in Python is what it means."""

        def wrap(function):
            return function if PLAIN else getattr(import_module(home), function.__name__)

        return wrap


def _fma(a: float, b: float, c: float) -> float:
    return a * b + c


@intrinsic
def _fused(typing, a, b, c):
    def generate(context, builder, signature, arguments):
        return builder.fma(*arguments)

    return float64(float64, float64, float64), generate


fma = _fma if PLAIN or TYPE_CHECKING else _fused
"""a·b + c: in compiled kernels rounded once, wherever it is written and nowhere else."""
