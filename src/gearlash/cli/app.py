"""The commands, put together."""

from __future__ import annotations

from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from .commands.atlas import atlas
from .commands.branch import branch
from .commands.check import check
from .commands.compare import compare
from .commands.curve import curve
from .commands.graze import graze
from .commands.map import map as map_
from .commands.new import new
from .commands.report import report
from .commands.reproduce import reproduce
from .commands.run import run
from .commands.schema import schema
from .commands.sweep import sweep
from .commands.tolerance import tolerance
from .commands.verify import verify
from .commands.zones import zones
from .one_word import Command

LONGEST_ARGUMENT, MOST_ARGUMENTS = 4096, 1000  # characters: as much as a path may have


class Bounded(TyperGroup):
    """Takes no argument that could only be repeated in an error, and fill the screen."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Raises `typer.BadParameter` before anything is looked at."""
        longest = max(map(len, args), default=0)
        if longest > LONGEST_ARGUMENT:
            raise typer.BadParameter(
                f"an argument of {longest:,} characters; expected at most {LONGEST_ARGUMENT:,}"
            )
        if len(args) > MOST_ARGUMENTS:
            raise typer.BadParameter(f"{len(args):,} arguments; expected at most {MOST_ARGUMENTS:,}")
        return super().parse_args(ctx, args)


app = typer.Typer(
    name="gearlash",
    cls=Bounded,
    help="How a gear pair with backlash really moves: where it runs quietly, where teeth hit, and where one "
    "regime turns into the other.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _version(wanted: bool) -> None:
    if wanted:
        from gearlash import __version__

        print(f"gearlash {__version__}")
        raise typer.Exit


@app.callback()
def gearlash(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Prints the version and ends.")
    ] = False,
) -> None:
    pass


for command in (
    new,
    report,
    run,
    check,
    sweep,
    map_,
    branch,
    curve,
    atlas,
    graze,
    zones,
    tolerance,
    compare,
    verify,
    reproduce,
    schema,
):
    app.command(cls=Command)(command)
