"""Words that are left over on a command line, and the option whose value they were probably meant for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from shlex import quote
from typing import TYPE_CHECKING, Any

from typer.core import TyperArgument, TyperCommand, TyperOption

from .terminal import harmless

if TYPE_CHECKING:
    from gearlash.case.units import Dimension

BEHIND = "--"
"""No word behind it is an option."""
NUMBERS_ALONE = "N", "P", "S", "NUMBER", "ORDER", "SHARE"
"""What help texts have in the place of numbers without unit."""


class Command(TyperCommand):
    """Says of words left over how the option before them takes them: ``--set pinion_speed 9000rpm``,
    ``--torque 150 Nm``."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Fails as a wrong use of the command where words are left, and where a unit stands for the case."""
        typed, taken, ctx.allow_extra_args = list(args), self._taken(), True
        options = typed[: typed.index(BEHIND)] if BEHIND in typed else typed
        loose = sorted(_loose(options, taken.valued))
        negative = [options[at] for at in loose if options[at][:1] == "-"]
        if negative and not ctx.resilient_parsing:  # would be read as options
            _fail(ctx, negative, meant(typed, negative, taken))
        left = super().parse_args(ctx, args)
        if ctx.resilient_parsing:
            return left
        if left:
            _fail(ctx, left, meant(typed, left, taken))
        alone = meant(typed, (), replace(taken, needed=0))
        if alone and len(_loose(typed, taken.valued)) <= taken.needed:
            ctx.fail(harmless(f"Missing argument, as the words are those of an option{alone}"))
        return left

    def _taken(self) -> Taken:
        """What the words of a command line may be."""
        options = [each for each in self.params if isinstance(each, TyperOption)]
        values = [each for each in options if not each.is_flag]
        return Taken(
            {name: each.metavar or "" for each in values if _is_text(each) for name in each.opts},
            frozenset(name for each in values for name in each.opts),
            sum(each.required for each in self.params if isinstance(each, TyperArgument)),
        )


@dataclass(frozen=True)
class Taken:
    """Options that take a text, and what help has in its place (NAME=VALUE, 25/57 …); all that take a value;
    and how many words a command needs that are no options."""

    texts: Mapping[str, str]
    valued: frozenset[str]
    needed: int


def _fail(ctx: Any, words: Sequence[str], told: str) -> None:
    ctx.fail(harmless(f"Got unexpected extra argument(s) ({' '.join(words)}){told}"))


def _is_text(parameter: Any) -> bool:
    """Whether its value may have blanks: a number without unit has none."""
    return parameter.metavar not in NUMBERS_ALONE


def meant(typed: Sequence[str], left: Sequence[str], taken: Taken) -> str:
    """What to type instead, where an option that takes a text stands just before words that go on with its
    value: words that are left, or that were taken for the case.

    Parameters
    ----------
    typed, left : sequence of str
        All words, and those that are left over.
    taken : Taken
    """
    loose = _loose(typed, taken.valued)
    for at, option in enumerate(typed):
        if option not in taken.texts or at + 1 == len(typed):
            continue
        end = at + 2
        while end in loose and not _is_case(typed[end]):
            end += 1
        most = min(end - at - 1, len(loose) - taken.needed + 1)  # the words that the command needs stay
        parts = [typed[at + 1 : at + 1 + count] for count in range(most, 1, -1)]
        parts.sort(key=lambda part: not _are_values(" ".join(part)))  # before other texts
        for part in parts:
            joined = _joined(part, taken.texts[option])
            if joined and (set(part[1:]) <= set(left) or _are_values(joined.rpartition("=")[2])):
                between = "=" in joined and not any("=" in word for word in part)
                how = "takes a name, a = and a value in one word" if between else "takes one word"
                return f"; {option} {how}: {option} {quote(joined)}"
    return ""


def _loose(typed: Sequence[str], valued: frozenset[str]) -> set[int]:
    """Places of words that are neither options nor the one word that is the value of one."""
    before = ["", *typed]
    return {at for at, word in enumerate(typed) if not _is_option(word) and before[at] not in valued}


def _is_option(word: str) -> bool:
    return word[:1] == "-" and word != "-" and not word[1:2].isdigit()


def _is_case(word: str) -> bool:
    """Another case, which is no part of a value."""
    from gearlash.case import bundled  # late: help needs none of it

    return word.casefold().endswith(".toml") or word in bundled()


def _joined(words: Sequence[str], form: str) -> str:
    """The words as one value of this form; empty where they are none."""
    text = " ".join(words)
    if "=" in form:
        return _named(words, ":" if ":" in form else " ")
    if _reads(text):
        return text
    if all(_reads(word) for word in words):  # several values
        return "/".join(words) if "/" in form and len(words) == 2 else ""
    return "" if _begins_number(text) and _is_whole(words[0]) else text


def _named(words: Sequence[str], between: str) -> str:
    """``a b c`` and ``a = b c`` as ``a=b c``, several values with what is ``between`` them; empty where that
    would be no name with its value."""
    name, equals, value = (part.strip() for part in " ".join(words).partition("="))
    if not equals:
        name, value = words[0], " ".join(words[1:])
        if not name[:1].isalpha() or not (_begins_number(value) or "." in name):
            return ""
    values = value.split()
    if between == ":" and len(values) > 1 and ":" not in value and all(map(_reads, values)):
        value = between.join(values)
    return f"{name}={value}" if not _begins_number(value) or _reads(value) else ""


def _is_whole(word: str) -> bool:
    """Whether it is a value with its unit, and no angle, behind which its hand may stand."""
    from gearlash.case.units import ANGLE, NUMBER

    return _dimension(word) not in (None, NUMBER, ANGLE)


def _begins_number(text: str) -> bool:
    return text[:1] in tuple("0123456789+-.−")


def _are_values(text: str) -> bool:
    """Whether it is a value, or those of pinion and gear."""
    return _reads(text) or all(_reads(part) for part in text.split("/"))


def _reads(text: str) -> bool:
    """Whether it is a number with its unit, several with colons between, or two limits."""
    return all(_dimension(part) is not None for part in text.split(":")) or _are_limits(text)


def _are_limits(text: str) -> bool:
    from gearlash.case.limits import ends_of  # late: help needs none of it
    from gearlash.case.units import UnitError

    try:
        ends = ends_of(text)
    except UnitError:
        return False
    return ends is not None and _dimension(ends.lower) is not None and _dimension(ends.upper) is not None


def _dimension(text: str) -> Dimension | None:
    from gearlash.case.kinds.gears.written import handed_angle  # late: help needs none of it
    from gearlash.case.quantity import ValueRefusedError
    from gearlash.case.units import UnitError, read

    try:
        return read(handed_angle(text))[1].dimension
    except (UnitError, ValueRefusedError):
        return None
