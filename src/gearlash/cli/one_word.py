"""Words that are left over on a command line, and the option whose value they were probably meant for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from shlex import quote
from typing import TYPE_CHECKING, Any

from typer.core import TyperCommand

from .terminal import harmless

if TYPE_CHECKING:
    from gearlash.case.units import Dimension

NUMBERS_ALONE = "N", "P", "S", "NUMBER", "ORDER", "SHARE"
"""What help texts have in the place of numbers without unit."""


class Command(TyperCommand):
    """Says of words left over how the option before them takes them: ``--set pinion_speed 9000rpm``,
    ``--torque 150 Nm``."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Fails as a wrong use of the command where words are left."""
        typed, ctx.allow_extra_args = list(args), True
        left = super().parse_args(ctx, args)
        if left and not ctx.resilient_parsing:
            texts = [each for each in self.params if not getattr(each, "is_flag", False) and _is_text(each)]
            valued = {name: each.metavar or "" for each in texts for name in each.opts}
            ctx.fail(
                harmless(f"Got unexpected extra argument(s) ({' '.join(left)}){meant(typed, left, valued)}")
            )
        return left


def _is_text(parameter: Any) -> bool:
    """Whether its value may have blanks: a number without unit has none."""
    return parameter.metavar not in NUMBERS_ALONE


def meant(typed: Sequence[str], left: Sequence[str], valued: Mapping[str, str]) -> str:
    """What to type instead, where an option that takes a text stands just before words that are left, and
    they go on with its value.

    Parameters
    ----------
    typed, left : sequence of str
        All words, and those that are left over.
    valued : mapping
        Options that take a text, and what help has in its place: NAME=VALUE, 25/57 …
    """
    for at, option in enumerate(typed):
        if option not in valued:
            continue
        words: list[str] = []
        for word in typed[at + 1 :]:
            if words and (word not in left or _is_case(word)):
                break
            words.append(word)
        parts = [words[:end] for end in range(len(words), 1, -1)]  # the last ones may be too much
        parts.sort(key=lambda part: not _reads(" ".join(part)))  # values with their unit before other texts
        joined = next(filter(None, (_joined(part, valued[option]) for part in parts)), "")
        if joined:
            return f"; {option} takes one word: {option} {quote(joined)}"
    return ""


def _is_case(word: str) -> bool:
    """Another case, which is no part of a value."""
    from gearlash.case import bundled  # late: help needs none of it

    return word.casefold().endswith(".toml") or word in bundled()


def _joined(words: Sequence[str], form: str) -> str:
    """The words as one value of this form; empty where they are none."""
    text = " ".join(words)
    if "=" in form:
        return _named(words)
    if _reads(text):
        return text
    if all(_reads(word) for word in words):  # several values
        return "/".join(words) if "/" in form and len(words) == 2 else ""
    return "" if _begins_number(text) and _is_whole(words[0]) else text


def _named(words: Sequence[str]) -> str:
    """``a b c`` and ``a = b c`` as ``a=b c``; empty where that would be no name with its value."""
    name, equals, value = (part.strip() for part in " ".join(words).partition("="))
    if not equals:
        name, value = words[0], " ".join(words[1:])
        if not name[:1].isalpha() or not (_begins_number(value) or "." in name):
            return ""
    return f"{name}={value}" if not _begins_number(value) or _reads(value) else ""


def _is_whole(word: str) -> bool:
    """Whether it is a value with its unit, and no angle, behind which its hand may stand."""
    from gearlash.case.units import ANGLE, NUMBER

    return _dimension(word) not in (None, NUMBER, ANGLE)


def _begins_number(text: str) -> bool:
    return text[:1] in tuple("0123456789+-.−")


def _reads(text: str) -> bool:
    """Whether it is a number with its unit, or several with colons between."""
    return all(_dimension(part) is not None for part in text.split(":"))


def _dimension(text: str) -> Dimension | None:
    from gearlash.case.units import UnitError, read  # late: help needs none of it

    try:
        return read(text)[1].dimension
    except UnitError:
        return None
