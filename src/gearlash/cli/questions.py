"""Questions at a terminal: the words of a drawing, one after the other."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from dataclasses import replace

from gearlash.case.kinds import kind_named
from gearlash.case.stated import ValueRefusedError, read_stated
from gearlash.system import GearlashError

from .words_of_drawing import EITHER, ONLY_BESIDE, WORDS, Word, placed

HEAD = (
    "A pair of external spur or helical gears from its drawing. Type values with their units as they stand "
    "there; pinion and gear apart by a stroke, 25/57. Enter alone: not known, to be estimated; of module, "
    "speed and torque: said otherwise, and asked for next.\n"
)


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
) -> dict[str, str]:
    """Texts by name of the word. Raises `GearlashError` where the questions end before the needed answers."""
    say(HEAD)
    found: dict[str, str] = {}
    for word in words:
        beside = ONLY_BESIDE.get(word.name)
        if word.question and (beside is None or beside in found):
            name, text = _either(word, ask, say)
            found |= {name: text} if text else {}
    return found


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
        say(f"  expected one of them: {', '.join(each.what.rstrip('.') for each in words)}")


def _meant(word: Word, words: Iterable[Word], text: str) -> Word:
    """The word whose answer this is: of those that stand in for each other, the only one that can read it."""
    able = [each for each in words if _wrong(each, text) is None]
    return word if word in able or len(able) != 1 else able[0]


def _answer(
    word: Word, ask: Callable[[str], str], say: Callable[[str], object], instead: Iterable[Word] = ()
) -> str:
    """One answer that can be read, as this word or as one ``instead`` of it; asked again until then."""
    while True:
        try:
            text = ask(f"{word.what.rstrip('.')}, such as {word.example}: ").strip()
        except EOFError:
            raise GearlashError("the answers ended; nothing was written") from None
        except KeyboardInterrupt:
            say("\nnothing was written")
            raise
        if not text and not word.needed:
            return ""
        wrong = _wrong(_meant(word, instead, text), text)
        if wrong is None:
            return text
        say(f"  {wrong}")


def _wrong(word: Word, text: str) -> str | None:
    """What is expected instead of this answer; None where it can be read."""
    places = kind_named("helical-pair").places
    try:
        parts = placed({word.name: text}) if text else {}
    except GearlashError as error:
        return str(error).removeprefix(f"{word.option} {text}: ")
    if not parts or (word.needed and len(parts) < len(word.paths)):
        return f"expected a value, such as {word.example}"
    for path, part in parts.items():
        try:
            read_stated(part, places[path])
        except ValueRefusedError as error:
            return f"expected {error.expected}" + (
                f"; did you mean {error.nearest!r}?" if error.nearest else ""
            )
    return None
