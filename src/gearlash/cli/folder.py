"""The folder of --out: gearlash writes over its own answer to the same question, moves what it answered to
others out of the way, touches nothing else, and lets one command write at a time."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from gearlash.case.files import UnreadableError, read_file
from gearlash.system import GearlashError, given

from .hold import HeldError, Hold, hold
from .jsonio import write_text
from .question import fingerprint
from .set_aside import MARKER, noted, set_aside

MOTION_FILES = ("portrait.svg", "portrait.pdf", "history.svg", "history.pdf", "history.nc", "spectrum.nc")
LARGEST_MARKER = 100_000  # bytes


@dataclass(frozen=True)
class OutFolder:
    """A folder with the names in it that are this program's: they are listed in its marker file. It belongs
    to this process as long as this object is there."""

    path: Path
    held: Hold
    names: frozenset[str] = frozenset()

    def owns(self, name: str) -> bool:
        """Whether this program wrote a file of this name, now or before."""
        return name in self.names

    def file(self, name: str) -> Path:
        """Path of a file that was claimed."""
        return self.path / name


def claim_if(path: Path | None, names: Iterable[str]) -> OutFolder | None:
    """`claim`, where a folder was asked for."""
    return None if path is None else claim(path, names)


def claim(path: Path, names: Iterable[str]) -> OutFolder:
    """The folder, made if it is missing, with these names (files or folders) listed as this program's own
    *before* anything is computed. Raises `GearlashError` if one of them is there and is not, or is a link, if
    another command writes there, or nothing can be written. Answers to other questions that have these names
    are moved into a folder of their own.
    """
    from gearlash.results.store import unfinished  # late: checking a case writes nothing

    wanted, path = list(names), given.path("--out", path)
    try:
        _make(path)
        held = hold(path)
        marker = _marker(path)
        own = {str(name) for name in marker.get("files", ())}
        foreign = [name for name in wanted if _is_foreign(path / name, name in own)]
        if foreign:
            raise GearlashError(
                f"--out {path}: {', '.join(foreign)} is there and was not written by gearlash; "
                "choose another folder, or move it away"
            )
        for name in wanted:
            for part in path.glob(unfinished(name)):  # of a command that was killed
                part.unlink(missing_ok=True)
        asked = noted(marker, own)
        moved = set_aside(path, [name for name in wanted if name in own], asked, held)
        asked = {name: one for name, one in asked.items() if name not in moved}
        asked |= dict.fromkeys(wanted, fingerprint())
        content = {
            "written by": "gearlash",
            "process": os.getpid(),
            "files": sorted({*own, *wanted}),
            "asked": asked,
        }
        write_text(json.dumps(content, indent=2) + "\n", path / MARKER)
    except HeldError:
        raise GearlashError(
            f"--out {path}: another command{_whose(path)} is writing there; "
            "wait for its end, or choose another folder"
        ) from None
    except OSError as error:
        raise GearlashError(f"--out {path}: cannot be written ({error.strerror or error})") from None
    return OutFolder(path, held, frozenset({*own, *wanted}))


def _make(path: Path) -> None:
    """The folder. A link to one will do."""
    if path.is_dir():
        return
    if path.is_symlink():
        raise GearlashError(f"--out {path}: is a link to what is no folder; choose another folder")
    path.mkdir(parents=True, exist_ok=True)


def _is_foreign(path: Path, own: bool) -> bool:
    """Whether something is there that this program did not write. It writes no links, so a link is foreign,
    whatever it leads to."""
    return path.is_symlink() or (not own and path.exists())


def _marker(path: Path) -> dict[str, Any]:
    """What an earlier command noted in the folder."""
    if not os.path.lexists(path / MARKER):
        return {}
    try:
        found = json.loads(read_file(path / MARKER, LARGEST_MARKER, follow=False))
        if isinstance(found["files"], list):
            return found
    except (ValueError, KeyError, TypeError, RecursionError, UnreadableError):
        pass
    raise GearlashError(f"--out {path}: {MARKER} there is not one of gearlash; choose another folder")


def _whose(path: Path) -> str:
    """The process that has the folder, as far as it has said so."""
    try:
        return f" (process {int(_marker(path)['process'])})"
    except (GearlashError, KeyError, TypeError, ValueError):
        return ""
