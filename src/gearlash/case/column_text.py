"""Signs in files of columns: what parts columns, and how numbers are written."""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import nan

DECIMAL_COMMA = re.compile(r"[-+−]?\d*,\d+(?:[eE][-+]?\d+)?")
GROUPED = {
    ",": re.compile(r"[-+]?\d{1,3}(?:\.\d{3})+,\d+"),
    ".": re.compile(r"[-+]?\d{1,3}(?:,\d{3})+\.\d+"),
}
"""Numbers whose thousands are set apart, beyond doubt as the other sign is there as well."""
EMPTY = ("", "-", "--", "nan", "n/a", "na", "#n/a", "#nv", "null", "none")


def as_number(cell: str, decimal: str) -> float | None:
    """The number of a cell, NaN of an empty one; None of other text."""
    text = cell.strip().replace("−", "-")
    if text.lower() in EMPTY:
        return nan
    if GROUPED[decimal].fullmatch(text):
        text = text.replace("." if decimal == "," else ",", "")
    if "_" in text:
        return None
    try:
        return float(text.replace(decimal, "."))
    except ValueError:
        return None


def separator_of(lines: Sequence[str]) -> tuple[str, str]:
    """What parts the columns, by what most lines have, and the sign of decimals."""
    for separator in (";", "\t"):
        if 2 * sum(separator in line for line in lines) > len(lines):
            return separator, _decimal(lines, separator)
    below = lines[len(lines) // 2 :]
    blanks = sum(bool(re.search(r"\d,\d+\s+[-+−]?\d+(?:,\d|\s|$)", line)) for line in below)
    if 2 * blanks > len(below):
        return " ", ","
    commas = sum("," in line for line in below)
    return (",", ".") if 2 * commas > len(below) else (" ", ".")


def _decimal(lines: Sequence[str], separator: str) -> str:
    cells = [cell.strip().strip('"') for line in lines for cell in line.split(separator)]
    commas = sum(bool(DECIMAL_COMMA.fullmatch(cell) or GROUPED[","].fullmatch(cell)) for cell in cells)
    return "," if commas else "."
