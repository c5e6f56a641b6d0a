"""gearlash schema"""

from __future__ import annotations

from typing import Annotated

import typer

from gearlash.cli.exits import ExitCode, command, delivery


@command
def schema(
    result: Annotated[
        str | None,
        typer.Option(
            metavar="KIND",
            help="Schema of what --json prints instead: new, run, check, sweep, map, branch, graze, zones, "
            "reproduce, or problem (input that cannot be used).",
        ),
    ] = None,
) -> ExitCode:
    """What may a case file contain? Prints its JSON Schema (2020-12), or that of a result of --json."""
    from gearlash.cli.jsonio import write_stdout

    if result is None:
        from gearlash.case import schema as case_schema

        found = case_schema()
    else:
        from gearlash.cli.kinds import answer_kind
        from gearlash.cli.schemas import answer_schema

        found = answer_schema(answer_kind(result))
    with delivery():
        write_stdout(found)
    return ExitCode.OK
