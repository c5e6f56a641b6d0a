"""From a file, a bundled name or a text to raw TOML; every way this can fail is a `CaseError`."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from importlib import resources
from itertools import islice
from os import PathLike
from pathlib import Path

from gearlash.system import GearlashError, given, shown

from .errors import CaseError, Problem
from .files import UnreadableError, read_file
from .words import nearest_name

LARGEST_FILE = 500_000  # bytes; the largest bundled case has 6,000
MOST_PARTS = 30
"""Of a name with dots. (Python's reader of TOML keeps every beginning of it: 100,000 parts take 40 GB.)"""
MOST_NAMES, MOST_ITEMS, DEEPEST = 5_000, 50_000, 12
"""Names in all tables of a file, items in all its arrays, tables and arrays inside each other."""
MOST_FILES = 200
"""Of a folder, that a name is held against."""
_LONG_KEY = re.compile(
    r"""(?<![\w-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){""" + f"{MOST_PARTS}}}", re.ASCII
)
_AT_LINE = re.compile(r"\s*\(at (line \d+, column \d+|end of document)\)")


def bundled() -> list[str]:
    """Names of the cases that come with the package, for `load_case`.

    Returns
    -------
    list of str
        In alphabetical order.

    Examples
    --------
    >>> import gearlash as gl
    >>> gl.bundled()[-1]
    'wind-turbine'
    """
    names = (entry.name for entry in resources.files("gearlash.case").joinpath("data").iterdir())
    return sorted(name.removesuffix(".toml") for name in names if name.endswith(".toml"))


def source_text(path_or_name: str | Path) -> tuple[str, str, Path | None]:
    """Label, text and folder of a file; a bundled case, which wins over a file of that name, has no
    folder."""
    label = str(path_or_name) if isinstance(path_or_name, (str, PathLike)) else shown(path_or_name)
    if isinstance(path_or_name, str) and path_or_name in bundled():
        data = resources.files("gearlash.case").joinpath("data", f"{path_or_name}.toml").read_bytes()
        return label, _decoded(label, data), None
    path = _path(label, path_or_name)
    return label, _decoded(label, _file(label, path)), path.parent


def parse(label: str, text: str) -> dict[str, object]:
    """The tables of a TOML text."""
    if len(text) > LARGEST_FILE:
        raise CaseError(label, [Problem("file", None, f"at most {LARGEST_FILE:,} characters")])
    if _LONG_KEY.search(text):
        raise CaseError(label, [Problem("file", None, f"names of at most {MOST_PARTS} parts")])
    try:
        tables = tomllib.loads(text)
    except ValueError as error:
        place = _AT_LINE.search(str(error))
        what = _AT_LINE.sub("", str(error))
        where = place[1] if place else "file"
        raise CaseError(label, [Problem(where, None, f"valid TOML ({what[:1].lower()}{what[1:]})")]) from None
    except RecursionError:
        raise CaseError(label, [Problem("file", None, "tables nested less deeply")]) from None
    check_size(label, tables)
    return tables


def check_size(label: str, tables: Mapping[str, object]) -> None:
    """Raises `CaseError` for tables that no case can have. (Each of fifty thousand wrong names would be held
    against the valid ones.)"""
    names = items = 0
    layer: list[object] = [tables]
    for _ in range(DEEPEST):
        inside: list[object] = []
        for part in layer:
            if isinstance(part, Mapping):
                names += len(part)
                inside += part.values()
            elif isinstance(part, list):
                items += len(part)
                inside += part
        if names > MOST_NAMES:
            raise CaseError(label, [Problem("file", None, f"at most {MOST_NAMES:,} names")])
        if items > MOST_ITEMS:
            raise CaseError(label, [Problem("file", None, f"at most {MOST_ITEMS:,} items in arrays")])
        layer = [part for part in inside if isinstance(part, (Mapping, list))]
    if layer:
        raise CaseError(label, [Problem("file", None, "tables and arrays nested less deeply")])


def _path(label: str, path_or_name: object) -> Path:
    try:
        return given.path("case", path_or_name)
    except GearlashError:
        expected = (
            f"a case file that can be read (no such path) or one of the bundled: {', '.join(bundled())}"
        )
        raise CaseError(label, [Problem("file", shown(path_or_name), expected)]) from None


def _file(label: str, path: Path) -> bytes:
    try:
        return read_file(path, LARGEST_FILE)
    except UnreadableError as error:
        names = ", ".join(bundled())
        expected = f"a case file that can be read ({error}) or one of the bundled cases: {names}"
        near = _beside(path) or nearest_name(label, bundled())
        raise CaseError(label, [Problem("file", None, expected, near)]) from None


def _beside(path: Path) -> str | None:
    """Name of the file in that folder that was probably meant: the same with its ending, else the nearest."""
    try:
        files = sorted(each.name for each in islice(path.parent.glob("*.toml"), MOST_FILES))
    except OSError:  # no folder, or one that cannot be read
        return None
    whole = f"{path.name}.toml"
    return whole if whole in files else nearest_name(path.name, files)


def _decoded(label: str, data: bytes) -> str:
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data[: error.start].count(b"\n") + 1
        raise CaseError(label, [Problem(f"line {line}", None, "text in UTF-8")]) from None
