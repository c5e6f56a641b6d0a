"""Answers as JSON: plain, strict (no NaN), readable in any terminal."""

from __future__ import annotations

import json
import math
import re
import sys
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

import numpy as np

PART = 65_536  # characters that are written at once
_UNPRINTABLE = re.compile("[\x7f-\x9f\u2028-\u202e\u2066-\u2069\ud800-\udfff]")


def plain(value: Any) -> Any:
    """What JSON can hold: dataclasses as objects, tuples and arrays as lists, NaN and infinity as null."""
    if is_dataclass(value) and not isinstance(value, type):
        return {field.name: plain(getattr(value, field.name)) for field in fields(value)}
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, str):
        return str(value)  # a StrEnum too
    if value is None or isinstance(value, bool | int):
        return value
    if isinstance(value, float):
        return float(value) if math.isfinite(value) else None
    if isinstance(value, np.ndarray | np.generic):
        return plain(value.tolist())
    if isinstance(value, Sequence):
        return [plain(item) for item in value]
    raise TypeError(f"{type(value).__name__} has no place in an answer")


def text(answer: Any, ascii_only: bool = False) -> str:
    """The JSON text of an answer, two spaces a level, with a line end; what could steer a terminal or has no
    UTF-8 is escaped.
    """
    written = json.dumps(plain(answer), indent=2, ensure_ascii=ascii_only, allow_nan=False) + "\n"
    return _UNPRINTABLE.sub(lambda found: f"\\u{ord(found[0]):04x}", written)


def write_stdout(answer: Any) -> None:
    """Standard output holds this and nothing else."""
    from .interrupt import showing

    encoding = (sys.stdout.encoding or "ascii").lower().replace("-", "")
    written = text(answer, ascii_only=encoding != "utf8")
    with showing() as taken:
        for i in range(0, len(written), PART):
            sys.stdout.write(written[i : i + PART])
            sys.stdout.flush()
            taken()


def write_file(answer: Any, path: Path) -> None:
    """The whole file or none: written beside its place, then moved."""
    write_text(text(answer), path)


def write_text(content: str, path: Path) -> None:
    """As `write_file`, for text."""
    from gearlash.results.store import write_whole  # late: checking a case writes nothing

    write_whole(path, content.encode("utf-8"))
