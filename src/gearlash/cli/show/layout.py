"""Blocks of aligned lines, the same in every command, as wide as the terminal and without blanks at line
ends.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator, Sequence
from itertools import zip_longest

from rich.text import Text

Column = tuple[str, str]  # name, "left" or "right"
INDENT = "  "
GAP = 2  # columns between two columns
BESIDE = 40  # room that a remark needs beside its value
NARROWEST = 24  # of a column that wraps; below it lines may run over the terminal's edge


def headline(text: str, width: int) -> Iterator[Text]:
    """The sentence that comes first."""
    yield from (Text(line, style="bold") for line in wrapped(text, width))


def note(text: str, width: int, style: str = "dim") -> Iterator[Text]:
    """A remark in a paragraph of its own."""
    yield Text()
    yield from (Text(line, style=style) for line in wrapped(text, width))


def assumed(held: Iterable[str], width: int) -> Iterator[Text]:
    """What is taken to be the same along a parameter that varies, although it may not be; each told once."""
    for text in dict.fromkeys(filter(None, held)):
        yield from note(f"Assumed: {text}.", width)


def facts(title: str, rows: Sequence[tuple[str, str]], width: int) -> Iterator[Text]:
    """Names and values in two columns under a title; values wrap."""
    yield Text()
    if title:
        yield Text(title, style="bold")
    first = max(len(name) for name, _ in rows)
    room = width - len(INDENT) - first - GAP
    for name, value in rows:
        for i, line in enumerate(wrapped(value, room)):
            yield Text.assemble(INDENT, (f"{'' if i else name:{first}}", "dim"), " " * GAP, line)


def table(title: str, columns: Sequence[Column], rows: Sequence[Sequence[str]], width: int) -> Iterator[Text]:
    """A titled table without frames; its last column wraps, and where that leaves it no room the widest one
    of words before it, too."""
    yield Text()
    yield Text(title, style="bold")
    names = [name for name, _ in columns]
    widths = [max(map(len, cells)) for cells in zip(names, *rows, strict=True)]
    room = width - len(INDENT) - sum(widths[:-1]) - GAP * (len(widths) - 1)
    words = [i for i, (_, side) in enumerate(columns[:-1]) if side == "left"]
    widest = max(words, key=lambda i: widths[i], default=None)
    needed = min(NARROWEST, widths[-1])
    if widest is not None and room < needed and widths[widest] > NARROWEST:
        kept = max(NARROWEST, len(names[widest]), widths[widest] - (needed - room))
        room, widths[widest] = room + widths[widest] - kept, kept
    if any(names):
        yield Text(_line(names, columns, widths), style="dim")
    for row in rows:
        sized = zip(row, widths, strict=True)
        cells = [[cell] if len(cell) <= size else wrapped(cell, size) for cell, size in sized]
        cells[-1] = wrapped(row[-1], room)
        yield from (Text(_line(line, columns, widths)) for line in zip_longest(*cells, fillvalue=""))


def remarks(title: str, rows: Sequence[tuple[str, str, str, str]], width: int) -> Iterator[Text]:
    """Paths, short names, values and a remark: beside the value where there is room, else below it."""
    if not rows:
        return
    yield Text()
    yield Text(title, style="bold")
    widths = [max(len(row[i]) for row in rows) for i in range(3)]
    room = width - len(INDENT) - sum(widths) - 3 * GAP
    for path, short, value, remark in rows:
        head = f"{INDENT}{path:{widths[0]}}  {short:{widths[1]}}  {value:{widths[2]}}"
        if room < BESIDE:
            yield Text(head.rstrip())
            yield from (Text(3 * INDENT + line, style="dim") for line in wrapped(remark, width - 6) if line)
            continue
        for i, line in enumerate(wrapped(remark, room)):
            start = head if i == 0 else " " * len(head)
            yield Text.assemble(start, " " * GAP, (line, "dim")) if line else Text(start.rstrip())


def wrapped(text: str, width: int) -> list[str]:
    """Lines of at most this width, broken at blanks; at least one."""
    return textwrap.wrap(text, max(width, NARROWEST), break_long_words=False, break_on_hyphens=False) or [""]


def _line(cells: Sequence[str], columns: Sequence[Column], widths: Sequence[int]) -> str:
    aligned = (
        f"{cell:>{size}}" if justify == "right" else f"{cell:{size}}"
        for cell, (_, justify), size in zip(cells, columns, widths, strict=True)
    )
    return (INDENT + (" " * GAP).join(aligned)).rstrip()
