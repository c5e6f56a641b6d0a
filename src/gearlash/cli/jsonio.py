"""Answers as JSON: plain, strict (no NaN), readable in any terminal."""

from __future__ import annotations

import math
import re
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields, is_dataclass
from functools import cache
from json.encoder import encode_basestring, encode_basestring_ascii
from pathlib import Path
from typing import Any

import numpy as np

from gearlash.system import Signature

PART = 65_536  # characters that are written at once
_UNPRINTABLE = re.compile("[\x7f-\x9f\u2028-\u202e\u2066-\u2069\ud800-\udfff]")


def text(answer: Any, ascii_only: bool = False) -> str:
    """The JSON text of an answer, two spaces a level, with a line end: dataclasses as objects, tuples and
    arrays as lists, NaN and infinity as null; what could steer a terminal or has no UTF-8 is escaped.

    As `json.dumps` writes it, which does the same in several times the time: answers have a million numbers,
    and who has stopped a study waits for them.
    """
    spell = encode_basestring_ascii if ascii_only else encode_basestring
    written = _written(answer, "\n", spell) + "\n"
    return _UNPRINTABLE.sub(lambda found: f"\\u{ord(found[0]):04x}", written)


def _written(value: Any, line: str, spell: Callable[[str], str]) -> str:
    """The text of a value; ``line`` is a line end with the blanks that the value stands behind."""
    if isinstance(value, float):
        return float.__repr__(value) if math.isfinite(value) else "null"
    if isinstance(value, str | Signature):
        return spell(str(value))  # a StrEnum too
    if value is None or value is True or value is False:
        return {None: "null", True: "true", False: "false"}[value]
    if isinstance(value, int):
        return int.__repr__(value)
    if isinstance(value, np.ndarray | np.generic):
        return _written(value.tolist(), line, spell)
    inner = line + "  "
    if isinstance(value, Mapping):
        rows = [f"{spell(str(key))}: {_written(item, inner, spell)}" for key, item in value.items()]
    elif isinstance(value, Sequence):
        items = [_written(item, inner, spell) for item in value]
        return f"[{inner}{f',{inner}'.join(items)}{line}]" if items else "[]"
    else:
        rows = [f'"{name}": {_written(getattr(value, name), inner, spell)}' for name in _fields(type(value))]
    return f"{{{inner}{f',{inner}'.join(rows)}{line}}}" if rows else "{}"


@cache
def _fields(kind: type) -> tuple[str, ...]:
    if not is_dataclass(kind):
        raise TypeError(f"{kind.__name__} has no place in an answer")
    return tuple(field.name for field in fields(kind))


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
