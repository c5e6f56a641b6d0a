"""The memory that kernels read, as it grows region by region."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

from ._tables import Array, Shape, aligned

NUMBERS_PER_CALL = 4_000_000  # numbers of tables that one call writes: a tenth of a second


@dataclass
class Tables:
    """What kernels read: replaced as a whole when a region is added. What was there is never changed; a new
    region is written behind it. There is room for as many as the budget allows (pages of it that nobody has
    written to take no memory); where more was allowed later, everything is copied."""

    room: Array
    used: int
    slot_of: Array  # (3^clearances) int: slot of each region, or -1

    @cached_property
    def memory(self) -> Array:
        """The room, to be read."""
        memory = self.room.view()
        memory.setflags(write=False)
        return memory

    def with_space(self, more: int) -> Array:
        """The room, or a larger one with the same content, with space for so many numbers behind it."""
        if self.used + more <= len(self.room):
            return self.room
        (room,) = aligned(self.used + 2 * more)
        copy_in_pieces(self.room[: self.used], room[: self.used])
        return room


def calls(shape: Shape) -> Iterator[tuple[int, int]]:
    """The cells in pieces for one call of a kernel each: first, and first of the next."""
    piece = max(1, NUMBERS_PER_CALL * shape.cells // shape.slot)
    return ((i, min(i + piece, shape.cells)) for i in range(0, shape.cells, piece))


def copy_in_pieces(old: Array, new: Array) -> None:
    """In pieces: gigabytes in new memory take seconds, in which Ctrl-C would not be answered."""
    for i in range(0, len(old), NUMBERS_PER_CALL):
        new[i : i + NUMBERS_PER_CALL] = old[i : i + NUMBERS_PER_CALL]
