"""What goes into a kernel and comes out: numba's words for it, without numba."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Signature:
    """The kinds of the arguments, in order, and of the result."""

    result: Scalar | Several
    arguments: tuple[Scalar | ArrayOf | Record, ...]


@dataclass(frozen=True)
class Scalar:
    """A number; called with the kinds of arguments, a signature that returns it."""

    name: str

    def __call__(self, *arguments: Scalar | ArrayOf | Record) -> Signature:
        return Signature(self, arguments)


float64, int64, boolean, void = (Scalar(name) for name in ("float64", "int64", "boolean", "void"))


@dataclass(frozen=True)
class Several:
    """``count`` numbers, as a result."""

    kind: Scalar
    count: int

    def __call__(self, *arguments: Scalar | ArrayOf | Record) -> Signature:
        return Signature(self, arguments)


@dataclass(frozen=True)
class ArrayOf:
    """A C-contiguous array of float64 or int64; one that is only read need not be ``writable``."""

    kind: Scalar
    dimensions: int
    writable: bool = True

    def __str__(self) -> str:
        access = "writable " if self.writable else ""
        return f"{access}C-contiguous {self.dimensions}-dimensional array of {self.kind.name}"


@dataclass(frozen=True)
class Record:
    """A NamedTuple of whole numbers."""

    of: type

    @property
    def size(self) -> int:
        """How many they are."""
        return len(self.of._fields)  # pyright: ignore[reportAttributeAccessIssue]
