"""The folder of --out: gearlash writes over what it wrote itself, never over anything else."""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from gearlash.system import GearlashError, given

from .jsonio import write_text

MOTION_FILES = ("portrait.svg", "portrait.pdf", "history.svg", "history.pdf")
MARKER = ".gearlash.json"


@dataclass(frozen=True)
class OutFolder:
    """A folder with the names in it that are this program's: they are listed in its marker file."""

    path: Path

    def file(self, name: str) -> Path:
        """Path of a file that was claimed."""
        return self.path / name


def claim_if(path: Path | None, names: Iterable[str]) -> OutFolder | None:
    """`claim`, where a folder was asked for."""
    return None if path is None else claim(path, names)


def claim(path: Path, names: Iterable[str]) -> OutFolder:
    """The folder, made if it is missing, with these names (files or folders) listed as this program's own
    *before* anything is computed. Raises `GearlashError` if one of them is there and is not, or nothing
    can be written.
    """
    wanted, path = list(names), given.path("--out", path)
    try:
        path.mkdir(parents=True, exist_ok=True)
        own = _listed(path)
        foreign = [name for name in wanted if name not in own and (path / name).exists()]
        if foreign:
            raise GearlashError(
                f"--out {path}: {', '.join(foreign)} is there and was not written by gearlash; "
                "choose another folder, or move it away"
            )
        listed = sorted({*own, *wanted})
        write_text(json.dumps({"written by": "gearlash", "files": listed}, indent=2) + "\n", path / MARKER)
    except OSError as error:
        raise GearlashError(f"--out {path}: cannot be written ({error.strerror or error})") from None
    return OutFolder(path)


def _listed(path: Path) -> set[str]:
    marker = path / MARKER
    if not marker.exists():
        return set()
    try:
        return {str(name) for name in json.loads(marker.read_text(encoding="utf-8"))["files"]}
    except (ValueError, KeyError, TypeError):
        raise GearlashError(
            f"--out {path}: {MARKER} there is not one of gearlash; choose another folder"
        ) from None
