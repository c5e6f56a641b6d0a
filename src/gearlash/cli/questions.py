"""Questions at a terminal: the words of a drawing, one after the other."""

from __future__ import annotations

import sys
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from shlex import quote

from gearlash.case import CaseError
from gearlash.case.kinds import Quantity, kind_named
from gearlash.case.stated import ValueRefusedError, read_stated
from gearlash.case.unit_hints import usual_units
from gearlash.system import GearlashError

from .words_of_drawing import EITHER, ONLY_BESIDE, WORDS, Word, placed

HEAD = (
    "A pair of external spur or helical gears from its drawing. Type values with their units as they stand "
    "there, or limits, 0.06-0.14 mm; pinion and gear apart by a stroke, 25/57. Enter alone: not known, to be "
    "estimated; of module, speed and torque: said otherwise, and asked for next. ? tells more of a question, "
    "< goes back to the one before, Ctrl-C stops.\n"
)
UNKNOWN = frozenset(
    {
        "-", "--", "–", "—", "none", "no", "n/a", "na", "n.a.", "unknown", "not known", "keine", "kein",
        "keiner", "nein", "unbekannt", "k.a.", "aucun", "aucune", "non", "ninguno", "无", "なし",
    }
)  # fmt: skip
"""What people type where a sheet says nothing: as good as Enter alone."""
BACK = frozenset(("<", "back", "zurück", "retour"))
MORE = frozenset(("?", "??", "help", "hilfe", "h", "/?", "-h", "--help"))
TAKEN = frozenset(("y", "yes", "j", "ja", "ok", "o", "oui", "si", "sí", "はい", "是"))
"""Of a value that was offered."""
MOST_NAMED = 20
"""Names that are told one by one."""


class _BackError(Exception):
    """To the question before."""


def at_a_terminal() -> bool:
    """Can somebody answer?"""
    return sys.stdin is not None and sys.stdin.isatty()


def words_of(teeth: str) -> tuple[Word, ...]:
    """Words that are asked for: the helix angle not of spur teeth, and in any case of helical ones."""
    if teeth == "spur":
        return tuple(word for word in WORDS if word.name != "helix_angle")
    if teeth == "helical":
        return tuple(replace(word, needed=True) if word.name == "helix_angle" else word for word in WORDS)
    return WORDS


def asked(
    ask: Callable[[str], str] = input,
    say: Callable[[str], object] = print,
    words: Iterable[Word] = WORDS,
    file: str = "FILE",
) -> dict[str, str]:
    """Texts by name of the word. Raises `GearlashError` where the questions end before the needed answers;
    what was answered by then is told as a command with ``file``."""
    say(HEAD)
    found: dict[str, str] = {}
    questions = [word for word in words if word.question]
    before: list[tuple[int, str]] = []
    at = 0
    with _told_at_end(file, found, say):
        while at < len(questions):
            beside = ONLY_BESIDE.get(questions[at].name)
            if beside is not None and beside not in found:
                at += 1
                continue
            try:
                name, text = _either(questions[at], ask, say)
            except _BackError:
                at, name = before.pop() if before else (0, "")
                say(f"  was {found.pop(name)}, and is dropped" if name in found else "  was not known")
                continue
            before.append((at, name))
            found |= {name: text} if text else {}
            at += 1
    return found


def asked_again(
    found: Mapping[str, str],
    error: CaseError,
    ask: Callable[[str], str] = input,
    say: Callable[[str], object] = print,
    file: str = "FILE",
) -> dict[str, str] | None:
    """The answers with new ones in place of those that a pair was refused for; None where it was none of them
    alone."""
    paths = {problem.path for problem in error.problems}
    refused = [word for word in WORDS if word.name in found and not paths.isdisjoint(word.paths)]
    if not refused:
        return None
    kept = dict(found)
    with _told_at_end(file, kept, say):
        say(f"\n{error}\n")
        for word in refused:
            try:
                name, text = _either(word, ask, say)
            except _BackError:
                continue  # as it was
            del kept[word.name]
            kept |= {name: text} if text else {}
    return kept


@contextmanager
def _told_at_end(file: str, found: Mapping[str, str], say: Callable[[str], object]) -> Iterator[None]:
    """Says what was answered where questions are interrupted, or nobody answers any more."""
    try:
        yield
    except EOFError:
        raise GearlashError(f"the answers ended; nothing was written{as_command(file, found)}") from None
    except KeyboardInterrupt:
        say(f"\nnothing was written{as_command(file, found)}")
        raise


def as_command(file: str, found: Mapping[str, str]) -> str:
    """What was answered, as options that can be gone on with; empty where nothing was."""
    options = {word.name: word.option for word in WORDS}
    told = " ".join(f"{options[name]} {quote(text)}" for name, text in found.items())
    return f"; what was answered: gearlash new {quote(file)} {told}" if told else ""


def _either(word: Word, ask: Callable[[str], str], say: Callable[[str], object]) -> tuple[str, str]:
    """Name and text of the word, or of one that stands in for it: those are asked for, one after the other,
    where the answer is empty; and all again until there is one."""
    others = [each for each in WORDS if each.name in EITHER.get(word.name, ())]
    if not others:
        return word.name, _answer(word, ask, say)
    words = word, *others
    while True:
        for each in words:
            text = _answer(replace(each, needed=False), ask, say, words)
            if text:
                taken = _meant(each, words, text)
                if taken is not each:
                    say(f"  taken as: {taken.what}")
                return taken.name, text
        say(f"  one of them is needed: {', '.join(each.what.rstrip('.') for each in words)}")


def _meant(word: Word, words: Iterable[Word], text: str) -> Word:
    """The word whose answer this is: of those that stand in for each other, the only one that can read it."""
    able = [each for each in words if _wrong(each, text) is None]
    return word if word in able or len(able) != 1 else able[0]


def _answer(
    word: Word, ask: Callable[[str], str], say: Callable[[str], object], instead: Collection[Word] = ()
) -> str:
    """One answer that can be read, as this word or as one ``instead`` of it; asked again until then."""
    offered: str | None = None
    while True:
        text = ask(f"{word.what.rstrip('.')}, such as {word.example}: ").strip()
        small = text.casefold()
        if small in BACK:
            raise _BackError
        if small in MORE:
            say(f"  {_more(word, instead)}")
            continue
        if offered is not None and small in TAKEN:
            text = offered
        elif small in UNKNOWN:
            say("  taken as not known")
            text = ""
        if not text and not word.needed:
            return ""
        wrong = _wrong(_meant(word, instead, text), text)
        if wrong is None:
            return text
        told, offered = wrong
        several = [each for each in instead if each is not word and text and _wrong(each, text) is None]
        if several and offered is None:
            names = " or ".join(each.what.partition(",")[0].rstrip(".") for each in several)
            told = f"that may be {names}: Enter here, and each is asked for"
        say(f"  {told}" if offered is None else f"  {told} (y takes that)")


def _more(word: Word, instead: Iterable[Word]) -> str:
    """What is asked for, in which units, and what may be typed."""
    place = kind_named("helical-pair").places[word.paths[0]]
    text = place.description[:1].upper() + place.description[1:]
    if isinstance(place, Quantity):
        units = usual_units(place)
        text += f"; in {units}" if units else ""
    elif len(place.choices) < MOST_NAMED:
        text += f": {', '.join(place.choices)}"
    if len(word.paths) > 1:
        text += "; pinion and gear apart by a stroke, one value stands for both, /b is that of the gear alone"
    others = [each for each in instead if each is not word]
    skip = "said otherwise, and asked for next" if others else "not known"
    return f"{text}. " + ("It is needed." if word.needed else f"Enter alone: {skip}.")


def _wrong(word: Word, text: str) -> tuple[str, str | None] | None:
    """What is expected instead of this answer, and the answer that was probably meant; None where it can be
    read."""
    places = kind_named("helical-pair").places
    try:
        parts = placed({word.name: text}) if text else {}
    except GearlashError as error:
        return str(error).removeprefix(f"{word.option} {text}: "), None
    if not parts or (word.needed and len(parts) < len(word.paths)):
        return f"expected a value, such as {word.example}", None
    near, told = dict(parts), ""
    for path, part in parts.items():
        try:
            read_stated(part, places[path])
        except ValueRefusedError as error:
            near[path] = error.nearest or ""
            told = told or f"expected {error.expected}"
    if not told:
        return None
    if not all(near.values()):
        return told, None
    whole = [near.get(path, "") for path in word.paths]
    nearest = whole[0] if len(set(whole)) == 1 else "/".join(whole)
    return f"{told}; did you mean {nearest!r}?", nearest
