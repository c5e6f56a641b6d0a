"""From a file, a bundled name or a text to raw TOML; every way this can fail is a `CaseError`."""

from __future__ import annotations

import re
import tomllib
from importlib import resources
from os import PathLike
from pathlib import Path

from gearlash.system import GearlashError, given, shown

from .errors import CaseError, Problem, nearest_name

_LARGEST_FILE = 10_000_000
_AT_LINE = re.compile(r"\s*\(at (line \d+, column \d+|end of document)\)")


def bundled() -> list[str]:
    """Names of the cases that come with the package."""
    names = (entry.name for entry in resources.files("gearlash.case").joinpath("data").iterdir())
    return sorted(name.removesuffix(".toml") for name in names if name.endswith(".toml"))


def source_text(path_or_name: str | Path) -> tuple[str, str]:
    """(label, text) of a bundled case or of a file. A bare bundled name wins over a file of that name."""
    label = str(path_or_name) if isinstance(path_or_name, (str, PathLike)) else shown(path_or_name)
    if isinstance(path_or_name, str) and path_or_name in bundled():
        data = resources.files("gearlash.case").joinpath("data", f"{path_or_name}.toml").read_bytes()
        return label, _decoded(label, data)
    return label, _decoded(label, _file(label, _path(label, path_or_name)))


def parse(label: str, text: str) -> dict[str, object]:
    """The tables of a TOML text."""
    try:
        return tomllib.loads(text)
    except ValueError as error:
        place = _AT_LINE.search(str(error))
        what = _AT_LINE.sub("", str(error))
        where = place[1] if place else "file"
        raise CaseError(label, [Problem(where, None, f"valid TOML ({what[:1].lower()}{what[1:]})")]) from None
    except RecursionError:
        raise CaseError(label, [Problem("file", None, "tables nested less deeply")]) from None


def _path(label: str, path_or_name: object) -> Path:
    try:
        return given.path("case", path_or_name)
    except GearlashError:
        expected = "the path of a file, or the name of a bundled case"
        raise CaseError(label, [Problem("file", shown(path_or_name), expected)]) from None


def _file(label: str, path: Path) -> bytes:
    try:
        with path.open("rb") as stream:
            data = stream.read(_LARGEST_FILE + 1)
    except (OSError, ValueError) as error:  # ValueError: a null character in the name
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        expected = (
            f"a case file that can be read ({reason}) or one of the bundled cases: {', '.join(bundled())}"
        )
        raise CaseError(label, [Problem("file", None, expected, nearest_name(label, bundled()))]) from None
    if len(data) > _LARGEST_FILE:
        raise CaseError(label, [Problem("file", None, "less than 10 MB")])
    return data


def _decoded(label: str, data: bytes) -> str:
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data[: error.start].count(b"\n") + 1
        raise CaseError(label, [Problem(f"line {line}", None, "text in UTF-8")]) from None
