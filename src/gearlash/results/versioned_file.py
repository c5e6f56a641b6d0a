"""Files of one record each: JSON with every number to its last digit, a version, and where it comes from."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from gearlash.case import Case
from gearlash.case.files import UnreadableError, read_file
from gearlash.system import Family, GearlashError, given
from gearlash.system.short_text import cut

from .provenance import provenance

Read = TypeVar("Read")
LARGEST_FILE = 1_000_000_000
"""Bytes of a file that is read."""
WRONG = (KeyError, TypeError, ValueError, AttributeError, IndexError, GearlashError, RecursionError)


@dataclass(frozen=True)
class VersionedFile:
    """A kind of file: ``record`` is what it holds and the name of its table, ``version`` that of its form."""

    record: str
    version: int

    @property
    def format(self) -> str:
        return f"gearlash-{self.record}"

    def text(self, stored: dict[str, Any], model: Case | Family) -> bytes:
        """The content of a file."""
        content = {
            "format": self.format,
            "version": self.version,
            "provenance": provenance(model),
            self.record: stored,
        }
        return json.dumps(content, allow_nan=False, ensure_ascii=False).encode()

    def read(self, path: object, made: Callable[[dict[str, Any]], Read]) -> Read:
        """What a file holds, ``made`` from its table. Raises `GearlashError` for another file."""
        path = given.path("path", path)
        name = cut(str(path), 200)
        content = self._content(path, name)
        try:
            return made(content[self.record])
        except WRONG as error:
            reason = cut(f"{type(error).__name__}: {error}", 200)
            raise GearlashError(f"{name}: not a whole {self.record} ({reason})") from None

    def _content(self, path: Path, name: str) -> dict[str, Any]:
        try:
            content = json.loads(read_file(path, LARGEST_FILE))
        except UnreadableError as error:
            raise GearlashError(f"{name}: {error}") from None
        except (ValueError, RecursionError) as error:
            raise GearlashError(f"{name}: not a file of a {self.record} ({cut(str(error), 200)})") from None
        if not isinstance(content, dict) or content.get("format") != self.format:
            raise GearlashError(f"{name}: not a file of a {self.record}")
        found = content.get("version")
        if found != self.version:
            raise GearlashError(
                f"{name}: version {found} of its format, this gearlash reads version {self.version}"
            )
        return content
