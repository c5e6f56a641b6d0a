"""Columns of numbers from a text file, as instruments and spreadsheets write them.

Columns are parted by semicolons, tabs, commas or blanks; numbers have a decimal point or, where commas do not
part columns, a decimal comma. Lines that begin with # are remarks. Above the numbers may stand names, units
in brackets behind them or in a line of their own, and lines of other words. Cells may be empty.
"""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import isfinite, nan
from pathlib import Path

from .column_text import as_number, separator_of
from .column_units import head_of
from .files import UnreadableError, read_file

LARGEST = 20_000_000  # bytes
_WORDS = re.compile(r'"[^"]*"|\S+(?:\s*[\[(][^\])]*[\])])?')  # what blanks part, a unit with its name
MARKS = (b"\xff\xfe", b"\xfe\xff")  # at the beginning of UTF-16, in which spreadsheets write "Unicode text"


@dataclass(frozen=True)
class Columns:
    """Columns of a file.

    Parameters
    ----------
    names : tuple of str
        As the file has them, without units; ``column 1`` … where it has none.
    units : tuple of str
        What stands in brackets behind a name or below it; empty where nothing does.
    cells : tuple of tuple of str
        A row a line of numbers.
    lines : tuple of int
        The line of the file that each row is.
    decimal : str
        The sign of decimals.
    """

    names: tuple[str, ...]
    units: tuple[str, ...]
    cells: tuple[tuple[str, ...], ...]
    lines: tuple[int, ...]
    decimal: str = "."

    def column(self, at: int) -> list[float]:
        """Numbers of a column, NaN where its cell is empty. Raises `UnreadableError` naming the line of what
        is no number."""
        found = []
        for row, line in zip(self.cells, self.lines, strict=True):
            number = as_number(row[at], self.decimal)
            if number is None:
                raise UnreadableError(
                    f"its line {line} has no number in column {self.names[at]!r}: {row[at]!r}"
                )
            found.append(number)
        return found

    def without_footer(self, *places: int) -> Columns:
        """Without last rows that have words in one of these columns: means and maxima below a table."""
        count = len(self.cells)
        while count and any(as_number(self.cells[count - 1][at], self.decimal) is None for at in places):
            count -= 1
        return replace(self, cells=self.cells[:count], lines=self.lines[:count])

    @cached_property
    def rows(self) -> tuple[tuple[float, ...], ...]:
        """All numbers, where none is missing. Raises `UnreadableError` for the first line with another
        cell."""
        found = []
        for row, line in zip(self.cells, self.lines, strict=True):
            numbers = tuple(as_number(cell, self.decimal) for cell in row)
            if any(each is None for each in numbers):
                text = ";".join(row)[:60]
                raise UnreadableError(f"its line {line} is no row of {len(row)} numbers: {text!r}")
            values = tuple(nan if each is None else each for each in numbers)
            if not all(map(isfinite, values)):
                raise UnreadableError(f"a number is missing or not finite in its line {line}")
            found.append(values)
        return tuple(found)


def read_columns(path: Path) -> Columns:
    """The columns of a file. Raises `UnreadableError` in words."""
    data = read_file(path, LARGEST)
    for encoding in ("utf-16",) if data.startswith(MARKS) else ("utf-8-sig", "cp1252", "latin-1"):
        try:
            return parse_columns(data.decode(encoding))
        except UnicodeDecodeError:  # the degree and micro signs of older spreadsheets
            continue
    raise UnreadableError("it is no text")


def parse_columns(text: str) -> Columns:
    """The columns of a text. Raises `UnreadableError` in words."""
    text = text.removeprefix("\ufeff")
    numbered = [(at, line) for at, line in enumerate(text.splitlines(), 1) if _counts(line)]
    told = numbered[0][1].strip() if numbered else ""
    if told.lower().startswith("sep=") and len(told) == 5:  # how a spreadsheet is told what parts columns
        numbered = numbered[1:]
    if not numbered:
        raise UnreadableError("it has no line of numbers")
    separator, decimal = separator_of([line for _, line in numbered])
    table = _closed([(at, _parts(line, separator)) for at, line in numbered])
    count = Counter(len(parts) for _, parts in table[len(table) // 3 :]).most_common(1)[0][0]
    begin = _first_row(table, count, decimal)
    if begin == len(table):
        raise UnreadableError("it has names of columns and no line of numbers")
    names, units = head_of([parts for _, parts in table[:begin] if len(parts) == count], count)
    for at, parts in table[begin:]:
        if len(parts) != count:
            line = text.splitlines()[at - 1]
            raise UnreadableError(f"its line {at} is no row of {count} numbers: {line[:60]!r}")
    rows = tuple(tuple(parts) for _, parts in table[begin:])
    return Columns(names, units, rows, tuple(at for at, _ in table[begin:]), decimal)


def _counts(line: str) -> bool:
    return bool(line.strip(" \t;,")) and not line.lstrip().startswith("#")


def _parts(line: str, separator: str) -> list[str]:
    """The cells of a line."""
    if separator == " ":
        return [part.strip('"') for part in _WORDS.findall(line)]
    found = next(csv.reader([line.strip(" ")], delimiter=separator, skipinitialspace=True))
    return [part.strip().strip('"') for part in found]


def _closed(table: list[tuple[int, list[str]]]) -> list[tuple[int, list[str]]]:
    """Without the empty last cell, where a separator ends every line."""
    ends = all(len(parts) > 1 and not parts[-1] for _, parts in table)
    return [(at, parts[:-1]) for at, parts in table] if ends else table


def _first_row(table: Sequence[tuple[int, list[str]]], count: int, decimal: str) -> int:
    """Where numbers begin: below the lines that have none in a column that is mostly numbers, and the first
    whole line, which may have numbers among its names."""
    whole = [parts for _, parts in table if len(parts) == count]
    below = whole[len(whole) // 2 :]
    numeric = [
        i for i in range(count)
        if 2 * sum(as_number(parts[i], decimal) is not None for parts in below) >= len(below)
    ]  # fmt: skip

    def kinds(parts: list[str]) -> list[bool]:
        return [as_number(parts[i], decimal) is not None for i in numeric if parts[i]]

    for at, (_, parts) in enumerate(table):
        if len(parts) != count or not any(kinds(parts)):
            continue
        mixed = not all(kinds(parts)) and not any(len(p) == count for _, p in table[:at])
        return at + mixed
    return len(table)
