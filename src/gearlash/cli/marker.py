"""What is noted in a folder of --out: names that are this program's, what was asked, what was left there.

An answer is known as one to its question only while all that the command left is there as it was: a call of
the library, an editor or another folder may have put something else in its place.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Container, Iterable, Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass, field, replace
from enum import IntEnum
from pathlib import Path

MARKER = ".gearlash.json"
LARGEST_MARKER = 10_000_000  # bytes


class Worth(IntEnum):
    """What an answer is worth, beside others to the same question."""

    PART = 0
    """It ended early."""
    BARE = 1
    """The answer is there, without some of what is computed or drawn beside it."""
    WHOLE = 2


@dataclass(frozen=True)
class Marker:
    """The note itself.

    Parameters
    ----------
    files : frozenset of str
        Names (files or folders) that are this program's.
    asked : mapping of str to str
        The question that each of them is an answer to.
    worth : mapping of str to Worth
        Of every file of an answer: what the answer is worth.
    content : mapping of str to str
        Digest of every file that was left, by its path in the folder.
    process : int or None
        Of the last command.
    """

    files: frozenset[str] = frozenset()
    asked: Mapping[str, str] = field(default_factory=dict)
    worth: Mapping[str, Worth] = field(default_factory=dict)
    content: Mapping[str, str] = field(default_factory=dict)
    process: int | None = None

    @staticmethod
    def read(folder: Path) -> Marker:
        """What an earlier command noted. Raises `GearlashError` for a file that is no note of this program. A
        folder from elsewhere may name any place, and what gearlash did not write: those are no names."""
        from gearlash.case.files import UnreadableError, read_file
        from gearlash.system import GearlashError

        if not os.path.lexists(folder / MARKER):
            return Marker()
        try:
            found = json.loads(read_file(folder / MARKER, LARGEST_MARKER, follow=False))
            if isinstance(found["files"], list):
                return _marker(found)
        except (ValueError, KeyError, TypeError, RecursionError, UnreadableError):
            pass
        raise GearlashError(f"--out {folder}: {MARKER} there is not one of gearlash; choose another folder")

    def write(self, folder: Path) -> None:
        """Puts it into the folder, as of this process."""
        from .jsonio import write_text

        noted = asdict(self) | {"files": sorted(self.files), "process": os.getpid()}
        write_text(json.dumps({"written by": "gearlash", **noted}, indent=2) + "\n", folder / MARKER)

    def of(self, question: str) -> list[str]:
        """The names of its answer."""
        return [name for name, asked in self.asked.items() if asked == question]

    def without(self, names: Container[str]) -> Marker:
        """Of all other names; these stay this program's."""
        return replace(
            self,
            asked={name: one for name, one in self.asked.items() if name not in names},
            worth={name: one for name, one in self.worth.items() if name not in names},
            content={path: one for path, one in self.content.items() if _name(path) not in names},
        )

    def as_left(self, folder: Path, names: Iterable[str]) -> bool:
        """Whether all of these is there as a command left it, and nothing else has one of the names."""
        names = list(names)
        there = contents(folder, names)
        noted = {path: digest for path, digest in self.content.items() if _name(path) in names}
        left = {_name(path) for path in noted}
        unchanged = all(there.get(path) == digest for path, digest in noted.items())
        return unchanged and all(_name(path) in left for path in there)


def _marker(found: Mapping[str, object]) -> Marker:
    files = frozenset(str(name) for name in _rows(found["files"]))
    process = found.get("process")
    asked, worth, content = (_mapping(found.get(name)) for name in ("asked", "worth", "content"))
    return Marker(
        files,
        {name: str(one) for name, one in asked.items() if name in files and _is_name(name)},
        {name: Worth(one) for name, one in worth.items() if one in list(Worth)},
        {path: str(digest) for path, digest in content.items()},
        process if isinstance(process, int) else None,
    )


def _rows(value: object) -> list[object]:
    return value if isinstance(value, list) else []


def _mapping(value: object) -> dict[str, object]:
    return value if isinstance(value, dict) else {}


def _name(path: str) -> str:
    """What a path in the folder begins with."""
    return path.partition("/")[0]


def _is_name(name: str) -> bool:
    """Whether this names something in a folder; the marker itself is no answer."""
    return name == Path(name).name and name not in ("", ".", "..", MARKER)


def contents(folder: Path, names: Iterable[str]) -> dict[str, str]:
    """Digests of what has these names in a folder, files in folders of it too, by their path there. What
    cannot be read has none."""
    found = {}
    for name in names:
        place = folder / name
        for file in sorted(place.rglob("*")) if place.is_dir() else [place]:
            with suppress(OSError):
                if file.is_file() and not file.is_symlink():
                    found[file.relative_to(folder).as_posix()] = _digest(file)
    return found


def _digest(file: Path) -> str:
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, lambda: hashlib.blake2b(digest_size=16)).hexdigest()
