"""The folder of --out: gearlash writes over its own answer to the same question, moves what it answered to
others out of the way, touches nothing else, and lets one command write at a time."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from gearlash.system import GearlashError, given

from .hold import HeldError, Hold, hold
from .marker import Marker, Worth, contents
from .question import fingerprint
from .set_aside import set_aside

MOTION_FILES = ("portrait.svg", "portrait.pdf", "history.svg", "history.pdf", "history.nc", "spectrum.nc")


@dataclass(eq=False)
class OutFolder:
    """A folder with the names in it that are this program's, listed in its marker file; those of them are
    ``wanted`` now. It belongs to this process as long as this object is there. ``worth`` is that of the
    answers to this question in it, by the name of their files, once there is room for a new one."""

    path: Path
    held: Hold
    names: frozenset[str]
    wanted: Sequence[str]
    worth: dict[str, Worth] | None = None

    def owns(self, name: str) -> bool:
        """Whether this program wrote a file of this name, now or before."""
        return name in self.names

    def file(self, name: str) -> Path:
        """Path of a file that was claimed."""
        return self.path / name

    def outdated(self, answer: str, names: Iterable[str]) -> list[Path]:
        """Files of before that go as an ``answer`` is written, by the name of its file: those are made again
        later, unless a signal comes. None where they belong to the whole answer to the same question."""
        return [] if self.make_room().get(answer) == Worth.WHOLE else [self.file(name) for name in names]

    def make_room(self) -> dict[str, Worth]:
        """Moves answers to other questions away, before anything is written. Returns what those to this one
        are worth."""
        if self.worth is None:
            marker = set_aside(self.path, self.wanted, Marker.read(self.path))
            asked = {**marker.asked, **dict.fromkeys(self.wanted, fingerprint())}
            there = [name for name in marker.of(fingerprint()) if (self.path / name).exists()]
            self.worth = {name: marker.worth[name] for name in there if name in marker.worth}
            replace(marker, asked=asked).write(self.path)
        return self.worth

    def note(self) -> None:
        """Notes what lies there of this question, so that the next command knows it again."""
        marker = Marker.read(self.path)
        mine = marker.of(fingerprint())
        content = {**marker.without(mine).content, **contents(self.path, mine)}
        replace(marker, worth={**marker.worth, **self.make_room()}, content=content).write(self.path)


def claim_if(path: Path | None, names: Iterable[str]) -> OutFolder | None:
    """`claim`, where a folder was asked for."""
    return None if path is None else claim(path, names)


def claim(path: Path, names: Iterable[str]) -> OutFolder:
    """The folder, made if it is missing, with these names (files or folders) listed as this program's own
    *before* anything is computed. Raises `GearlashError` if one of them is there and is not, or is a link, if
    another command writes there, or nothing can be written.
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
        files = marker.files.union(wanted)
        replace(marker, files=files).write(path)
    except HeldError:
        raise GearlashError(
            f"--out {path}: another command{_whose(path)} is writing there; "
            "wait for its end, or choose another folder"
        ) from None
    except OSError as error:
        raise GearlashError(f"--out {path}: cannot be written ({error.strerror or error})") from None
    return OutFolder(path, held, files, wanted)


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
