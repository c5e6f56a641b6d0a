"""The folder of --out: gearlash writes over its own answer to the same question, moves what it answered to
others out of the way, touches nothing else, and lets one command write at a time."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path

from gearlash.system import GearlashError, given

from .hold import HeldError, Hold, hold
from .marker import Marker, Worth, contents
from .question import fingerprint
from .set_aside import set_aside

MOTION_FILES = ("portrait.svg", "portrait.pdf", "history.svg", "history.pdf", "history.nc", "spectrum.nc")


@dataclass(frozen=True, eq=False)
class OutFolder:
    """A folder with the names in it that are this program's: they are listed in its marker file. It belongs
    to this process as long as this object is there. ``worth`` is that of the answers to this question in it,
    by the name of their files."""

    path: Path
    held: Hold
    names: frozenset[str] = frozenset()
    worth: dict[str, Worth] = field(default_factory=dict)

    def owns(self, name: str) -> bool:
        """Whether this program wrote a file of this name, now or before."""
        return name in self.names

    def file(self, name: str) -> Path:
        """Path of a file that was claimed."""
        return self.path / name

    def outdated(self, answer: str, names: Iterable[str]) -> list[Path]:
        """Files of before that go as an ``answer`` is written, by the name of its file: those are made again
        later, unless a signal comes. None where they belong to the whole answer to the same question."""
        return [] if self.worth.get(answer) == Worth.WHOLE else [self.file(name) for name in names]

    def note(self) -> None:
        """Notes what lies there of this question, so that the next command knows it again."""
        marker = Marker.read(self.path)
        mine = marker.of(fingerprint())
        content = {**marker.without(mine).content, **contents(self.path, mine)}
        replace(marker, worth={**marker.worth, **self.worth}, content=content).write(self.path)


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
        marker = Marker.read(path)
        foreign = [name for name in wanted if _is_foreign(path / name, name in marker.files)]
        if foreign:
            raise GearlashError(
                f"--out {path}: {', '.join(foreign)} is there and was not written by gearlash; "
                "choose another folder, or move it away"
            )
        for name in wanted:
            for part in path.glob(unfinished(name)):  # of a command that was killed
                part.unlink(missing_ok=True)
        marker = set_aside(path, wanted, marker, held)
        asked = {**marker.asked, **dict.fromkeys(wanted, fingerprint())}
        marker = replace(marker, files=marker.files.union(wanted), asked=asked)
        marker.write(path)
    except HeldError:
        raise GearlashError(
            f"--out {path}: another command{_whose(path)} is writing there; "
            "wait for its end, or choose another folder"
        ) from None
    except OSError as error:
        raise GearlashError(f"--out {path}: cannot be written ({error.strerror or error})") from None
    answered = {name: marker.worth[name] for name in wanted if name in marker.worth}
    return OutFolder(path, held, marker.files, answered)


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


def _whose(path: Path) -> str:
    """The process that has the folder, as far as it has said so."""
    try:
        process = Marker.read(path).process
    except GearlashError:
        return ""
    return "" if process is None else f" (process {process})"
