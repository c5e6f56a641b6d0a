"""What a command was asked, as a fingerprint: only the same question takes the place of its own answer."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

HOW = frozenset({"out", "workers", "as_json", "as_csv", "decimal_comma"})
"""Options that change nothing in what is computed."""
_asked = ""


def ask(command: str, options: Mapping[str, Any]) -> None:
    """Notes what this process was asked."""
    global _asked
    from gearlash import __version__

    what = {name: _content(value) for name, value in sorted(options.items()) if name not in HOW}
    text = json.dumps([command, __version__, what], sort_keys=True, default=str)
    _asked = hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()[:16]


def fingerprint() -> str:
    """Of command, version, options, and what is in files that options name; empty outside of a command."""
    return _asked


def _content(value: Any) -> Any:
    """Of a file that can be read, its text in place of its name."""
    if isinstance(value, list | tuple):
        return [_content(each) for each in value]
    if isinstance(value, str | Path):
        try:
            path = Path(value)
            if path.is_file():
                return hashlib.sha256(path.read_bytes()).hexdigest()
        except (OSError, ValueError):  # no name of a file: the text itself
            pass
    return value
