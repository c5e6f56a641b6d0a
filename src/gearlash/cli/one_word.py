"""Words that are left over on a command line, and the option whose value they were probably meant for."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from shlex import quote
from typing import Any

from typer.core import TyperCommand

from .terminal import harmless


class Command(TyperCommand):
    """Says of words left over how the option before them takes them: ``--set pinion_speed 9000rpm``,
    ``--torque 150 Nm``."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Fails as a wrong use of the command where words are left."""
        typed, ctx.allow_extra_args = list(args), True
        left = super().parse_args(ctx, args)
        if left and not ctx.resilient_parsing:
            valued = {
                name for each in self.params if not getattr(each, "is_flag", False) for name in each.opts
            }
            ctx.fail(
                harmless(f"Got unexpected extra argument(s) ({' '.join(left)}){meant(typed, left, valued)}")
            )
        return left


def meant(typed: Sequence[str], left: Sequence[str], valued: Collection[str]) -> str:
    """What to type instead, where an option that takes a value stands just before the words that are left."""
    for at, option in enumerate(typed):
        if not (option.startswith("-") and option in valued):
            continue
        words: list[str] = []
        for word in typed[at + 1 :]:
            if words and word not in left:
                break
            words.append(word)
        if len(words) > 1:
            return f"; {option} takes one word: {option} {quote(_joined(words))}"
    return ""


def _joined(words: list[str]) -> str:
    """``a b`` and ``a = b`` as ``a=b``; what has its sign, or begins with a number, with blanks."""
    text = " ".join(words)
    name, equals, value = (part.strip() for part in text.partition("="))
    if equals:
        return f"{name}={value}"
    named = words[0][:1].isalpha() and len(words) == 2 and words[1][:1] in "0123456789+-."
    return "=".join(words) if named else text
