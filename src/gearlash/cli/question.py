"""What a command was asked, as a fingerprint: only the same question takes the place of its own answer."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

HOW = frozenset({"out", "workers", "as_json", "as_csv", "decimal_comma"})
"""Options that change nothing in what is computed."""
LARGEST = 1_000_000_000  # bytes; no command reads a larger file
_asked = ""


def ask(command: str, options: Mapping[str, Any]) -> None:
    """Notes what this process was asked."""
    global _asked
    from gearlash import __version__

    what = {name: _content(value) for name, value in sorted(options.items()) if name not in HOW}
    text = json.dumps([command, __version__, what], sort_keys=True, default=str)
    _asked = hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()[:16]


def fingerprint() -> str:
    """Of command, version, options, and what is in files that options name and in those that a case file
    names; empty outside of a command."""
    return _asked


def _content(value: Any) -> Any:
    """Of a file that can be read, its content in place of its name, and that of the files it names."""
    if isinstance(value, list | tuple):
        return [_content(each) for each in value]
    if not isinstance(value, str | Path):
        return value
    from gearlash.system import GearlashError, given

    try:
        path = given.path("file", value)
    except GearlashError:  # no name of a file: the text itself
        return value
    data = _read(path)
    if data is None:
        return value
    return [_digest(each) for each in (data, *map(_read, _named(data, path.parent)))]


def _read(path: Path) -> bytes | None:
    """None of what no command reads."""
    from gearlash.case.files import UnreadableError, read_file

    try:
        return read_file(path, LARGEST)
    except UnreadableError:
        return None


def _named(data: bytes, folder: Path) -> list[Path]:
    """Files that a case file names; none where this is the content of another file."""
    from gearlash.case.curve_files import files_named
    from gearlash.case.errors import CaseError
    from gearlash.case.read import parse

    try:
        return files_named(parse("case", data.decode("utf-8-sig")), folder)
    except (CaseError, UnicodeDecodeError):
        return []


def _digest(data: bytes | None) -> str:
    return "" if data is None else hashlib.sha256(data).hexdigest()
