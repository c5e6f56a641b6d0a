"""The commands, put together."""

from __future__ import annotations

from typing import Annotated

import typer

from .commands.bench import bench
from .commands.check import check
from .commands.graze import graze
from .commands.map import map as map_
from .commands.reproduce import reproduce
from .commands.run import run
from .commands.schema import schema
from .commands.sweep import sweep
from .commands.zones import zones

app = typer.Typer(
    name="gearlash",
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


for command in (run, check, sweep, map_, graze, zones, reproduce, bench, schema):
    app.command()(command)
