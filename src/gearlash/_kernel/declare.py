"""The decorators. They import nothing: a kernel is loaded, or compiled, when it is first called or when all
are asked for (`prepare`). With NUMBA_DISABLE_JIT=1 every kernel is the plain function that it is written
as."""

from __future__ import annotations

import os
from collections.abc import Callable
from types import FunctionType
from typing import TYPE_CHECKING, Any, TypeVar

from .signature import Signature

F = TypeVar("F", bound=Callable[..., Any])

PLAIN = os.environ.get("NUMBA_DISABLE_JIT", "0") not in ("", "0")
"""Whether kernels run as plain Python."""


class Kernel:
    """An entry point: called like the function that it was made of, positional arguments only."""

    def __init__(self, function: FunctionType, signature: Signature, allocates: bool, alone: bool):
        self.function, self.signature, self.allocates, self.alone = function, signature, allocates, alone
        self.name = f"{function.__module__}.{function.__qualname__}"
        self.__doc__, self.__name__, self.__module__ = (
            function.__doc__,
            function.__name__,
            function.__module__,
        )
        self.entry: Callable[..., Any] = self._first

    def __call__(self, *arguments: Any) -> Any:
        return self.entry(*arguments)

    def __repr__(self) -> str:
        return f"<kernel {self.name}>"

    def _first(self, *arguments: Any) -> Any:
        from .prepare import make_ready

        make_ready(self)
        return self.entry(*arguments)


KERNELS: dict[str, Kernel] = {}
"""All that the modules imported so far declare, by name."""

HELPERS: dict[FunctionType, dict[str, Any]] = {}
"""What only kernels call, with the options that each is compiled with."""

PRIMITIVES: dict[FunctionType, str] = {}
"""Functions with machine code written by hand, and the modules where that is, under the same name."""


if TYPE_CHECKING:

    def kernel(signature: Any, allocates: bool = False, alone: bool = False) -> Callable[[F], F]: ...
    def inner(function: F) -> F: ...
    def inlined(function: F) -> F: ...
    def allocating(function: F) -> F: ...
    def primitive(home: str) -> Callable[[F], F]: ...

else:

    def kernel(signature, allocates=False, alone=False):
        """An entry point for one explicit signature. Unless it ``allocates`` arrays it is compiled without
        reference counts, which cost more than the arithmetic of a small product. ``alone``: it takes as long
        to compile as all others together, and gets a process of its own for that."""

        def wrap(function):
            if PLAIN:
                return function
            made = Kernel(function, signature, allocates, alone)
            KERNELS[made.name] = made
            return made

        return wrap

    def inner(function):
        """A helper that only kernels call: compiled into its callers and kept with them. It allocates
        nothing."""
        HELPERS[function] = {"_nrt": False}
        return function

    def inlined(function):
        """A helper on the hot path, with one place that calls it: no call is left of it. (A call passes every
        array as seven numbers, which can cost more than its work.)"""
        HELPERS[function] = {"_nrt": False, "forceinline": True}
        return function

    def allocating(function):
        """A helper that makes arrays."""
        HELPERS[function] = {}
        return function

    def primitive(home):
        """A function in place of which kernels get the intrinsic of the same name in module ``home``, which
        is imported for compiling only."""

        def wrap(function):
            PRIMITIVES[function] = home
            return function

        return wrap


@primitive(f"{__package__}.primitives")
def fma(a: float, b: float, c: float) -> float:
    """a·b + c: in compiled kernels rounded once, wherever it is written and nowhere else."""
    return a * b + c
