"""What a command was asked, as a fingerprint: only the same question takes the place of its own answer."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

HOW = frozenset({"out", "workers", "as_json", "as_csv", "decimal_comma"})
"""Options that change nothing in what is computed."""
IN_ANY_ORDER = frozenset({"settings", "initial"})
"""Options that may be given several times, each for a name of its own."""
LARGEST = 1_000_000_000  # bytes; no command reads a larger file
LONGEST = 2_000  # bits of a whole number that is no nonsense
_asked = ""


def ask(command: str, options: Mapping[str, Any]) -> None:
    """Notes what this process was asked."""
    global _asked
    from gearlash import __version__

    what = {name: _content(value) for name, value in options.items() if name not in HOW}
    what |= {name: sorted(what[name], key=str) for name in IN_ANY_ORDER if what.get(name)}
    text = json.dumps([command, __version__, what], sort_keys=True, default=str)
    _asked = hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()[:16]


def fingerprint() -> str:
    """Of command, version, options, and what files say that options name; empty outside of a command."""
    return _asked


def _content(value: Any) -> Any:
    """Of a file that can be read, what it says in place of its name."""
    if isinstance(value, list | tuple):
        return [_content(each) for each in value]
    if not isinstance(value, str | Path):
        return value
    from gearlash.case.files import UnreadableError, read_file
    from gearlash.system import GearlashError, given

    try:
        path = given.path("file", value)
        data = read_file(path, LARGEST)
    except (GearlashError, UnreadableError):  # no name of a file that any command reads: the text itself
        return value
    said = _said(data, path.parent)
    return said or hashlib.sha256(data).hexdigest()


def _said(data: bytes, folder: Path) -> str:
    """What a case file says, in whatever order and with whatever comments, with the points in files that it
    names; empty where this is the content of another file."""
    from gearlash.case.curve_files import with_files
    from gearlash.case.errors import CaseError
    from gearlash.case.read import parse

    try:
        tables = with_files("case", parse("case", data.decode("utf-8-sig")), folder)
    except (CaseError, UnicodeDecodeError):
        return ""
    return json.dumps(_plain(tables), sort_keys=True, default=str)


def _plain(value: Any) -> Any:
    """The same with one way to write a number: 1 for 1.0."""
    if isinstance(value, Mapping):
        return {name: _plain(each) for name, each in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(each) for each in value]
    if isinstance(value, int) and value.bit_length() > LONGEST:
        return hex(value)  # Python writes no decimal number of thousands of digits
    return int(value) if isinstance(value, float) and value.is_integer() else value
