"""Columns of numbers from a text file, as instruments and spreadsheets write them.

Columns are parted by semicolons, tabs, commas or blanks; numbers have a decimal point or, where commas do not
part columns, a decimal comma. Lines that begin with # are remarks; a first line that is no numbers has names.
"""

from __future__ import annotations

import io
import re
from dataclasses import dataclass
from math import isfinite
from pathlib import Path

from .files import UnreadableError, read_file

LARGEST = 20_000_000  # bytes
_UNIT = re.compile(r"^(?P<name>.*?)\s*[\[(](?P<unit>[^\])]*)[\])]\s*$")


@dataclass(frozen=True)
class Columns:
    """Columns of a file.

    Parameters
    ----------
    names : tuple of str
        As the first line has them, without units; ``column 1`` … where it has none.
    units : tuple of str
        What stands in brackets behind a name; empty where nothing does.
    rows : tuple of tuple of float
        One a line.
    """

    names: tuple[str, ...]
    units: tuple[str, ...]
    rows: tuple[tuple[float, ...], ...]


def read_columns(path: Path) -> Columns:
    """The columns of a file. Raises `UnreadableError` in words."""
    data = read_file(path, LARGEST)
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("latin-1")  # the degree and micro signs of older spreadsheets
    return parse_columns(text)


def parse_columns(text: str) -> Columns:
    """The columns of a text. Raises `UnreadableError` in words."""
    import pandas as pd  # late: only files of points need it

    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    if not lines:
        raise UnreadableError("it has no line of numbers")
    separator, decimal = _separator(lines)
    head = _parts(lines[0], separator)
    named = not all(_is_number(part, decimal) for part in head if part)
    body = lines[1:] if named else lines
    if not body:
        raise UnreadableError("it has names of columns and no line of numbers")
    try:
        frame = pd.read_csv(
            io.StringIO("\n".join(body)),
            sep=r"\s+" if separator == " " else separator,
            decimal=decimal,
            header=None,
            dtype=float,
            skipinitialspace=True,
        )
    except (ValueError, pd.errors.ParserError):
        raise UnreadableError(_wrong_line(text, lines, named, separator, decimal)) from None
    rows = tuple(tuple(float(value) for value in row) for row in frame.to_numpy())
    for at, row in enumerate(rows, start=1 + named):
        if not all(isfinite(value) for value in row):
            raise UnreadableError(f"a number is missing or not finite in line {at} of its numbers")
    count = len(rows[0])
    names = [_UNIT.match(part) for part in head] if named else []
    plain = tuple(found["name"] if found else part for found, part in zip(names, head, strict=False))
    units = tuple(found["unit"].strip() if found else "" for found in names)
    if len(plain) != count:
        plain, units = tuple(f"column {i}" for i in range(1, count + 1)), ("",) * count
    return Columns(plain, units, rows)


def _wrong_line(text: str, lines: list[str], named: bool, separator: str, decimal: str) -> str:
    """The first line that is no row of numbers, as it stands in the file."""
    count = len(_parts(lines[named], separator))
    for line in lines[named:]:
        parts = _parts(line, separator)
        if len(parts) != count or not all(_is_number(part, decimal) for part in parts):
            at = text.splitlines().index(line) + 1
            return f"its line {at} is no row of {count} numbers: {line[:60]!r}"
    return "its lines are no columns of numbers"


def _separator(lines: list[str]) -> tuple[str, str]:
    """What parts the columns, by the last line (the first may be names), and the sign of decimals."""
    line = lines[-1]
    for separator in (";", "\t"):
        if separator in line:
            return separator, "," if any("," in each for each in lines[1:] or lines) else "."
    if re.search(r"\d,\d+\s+[-+]?\d+,\d", line):
        return " ", ","
    return (",", ".") if "," in line else (" ", ".")


def _parts(line: str, separator: str) -> list[str]:
    parts = line.split() if separator == " " else line.split(separator)
    return [part.strip().strip('"') for part in parts]


def _is_number(text: str, decimal: str) -> bool:
    try:
        float(text.replace(decimal, "."))
    except ValueError:
        return False
    return True
