"""What kernels are, before numba is imported: a function and a signature, ready when first called."""

from __future__ import annotations

from collections.abc import Callable
from types import FunctionType
from typing import Any


class Kernel:
    """An entry point: called like the function that it was made of, positional arguments only. It is loaded,
    or compiled, when it is first called or when all are asked for (`prepare`)."""

    make_ready: Callable[[Kernel], None]
    """What loads or compiles one, given by `prepare`, which knows how: here it is only known that it is done
    at the first call."""

    def __init__(self, function: FunctionType, signature: Any, options: dict[str, Any], alone: bool):
        self.function, self.signature, self.options, self.alone = function, signature, options, alone
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
        Kernel.make_ready(self)
        return self.entry(*arguments)


KERNELS: dict[str, Kernel] = {}
"""All that the modules imported so far declare, by name."""
