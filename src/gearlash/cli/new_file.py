"""A new case file: where it may be written, and that it can be used, before it is there."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path

from gearlash.case import Case, CaseError, Problem, bundled, loads
from gearlash.system import GearlashError, given

from .jsonio import write_text
from .words_of_drawing import EITHER, lacking


def checked_place(file: Path, overwrite: bool) -> None:
    """Raises `GearlashError` where nothing may be written."""
    given.path("FILE", file)
    if str(file) in bundled():
        raise GearlashError(f"{file}: a case that comes with the package has this name; choose {file}.toml")
    if file.is_dir() or file.is_symlink():
        raise GearlashError(f"{file}: is a {'folder' if file.is_dir() else 'link'}; choose another name")
    if file.exists() and not overwrite:
        raise GearlashError(f"{file}: is there already; choose another name, or --overwrite replaces it")
    if not file.parent.is_dir():
        raise GearlashError(f"{file}: there is no folder {file.parent}")


def loaded(file: Path, text: str, words: Collection[str]) -> Case:
    """The case that the text is. Raises `CaseError` with every problem, and nothing is written."""
    missing = [
        Problem(word.option, None, _expected(word.name, word.example), missing=True)
        for word in (lacking(words) if words else ())
    ]
    try:
        case = loads(text, label=file.name)
    except CaseError as error:
        told = [p for p in error.problems if not (p.missing and missing)]
        raise CaseError(file.name, [*missing, *told]) from None
    if missing:
        raise CaseError(file.name, missing)
    return case


def _expected(name: str, example: str) -> str:
    others = " or ".join(f"--{other.replace('_', '-')}" for other in EITHER.get(name, ()))
    return f"a value, such as {example}" + (f" (or {others})" if others else "")


def write(file: Path, text: str, overwrite: bool) -> None:
    """The file, whole or not at all; never over one that came there in between."""
    if overwrite:
        write_text(text, file)
        return
    try:
        with file.open("x", encoding="utf-8") as new:
            new.write(text)
    except FileExistsError:
        raise GearlashError(f"{file}: is there already; choose another name") from None
