"""Arguments and options that commands share, each described once."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer


def folder(text: str | Path) -> Path:
    """The path of ``--out``. No name at all is mostly a variable of the shell that was not set: the current
    folder is written `.`."""
    if not str(text).strip():
        raise typer.BadParameter("no folder is named; the current one is written '.'")
    return Path(text)


CaseArgument = Annotated[
    str,
    typer.Argument(
        metavar="CASE",
        help="A case file, or a bundled case: article, article-first-harmonic, "
        "blankenship-kahraman, geared-rotor, kahraman-singh, shaw-holmes, two-stage, wind-turbine.",
    ),
]
Settings = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="NAME=VALUE",
        help="Replaces a value of the case, by short name or path (omega=0.942, "
        "pinion_speed=3600rpm, mesh.backlash=80um). May be given several times.",
    ),
]
Initial = Annotated[
    list[str] | None,
    typer.Option(
        metavar="STATE=VALUE",
        help="Starts from other states than the cold start (X=1.2, X'=0; dimensionless), or from the "
        "state in the JSON file of an earlier run. May be given several times.",
    ),
]
Periods = Annotated[
    int | None,
    typer.Option(
        min=1,
        max=1_000_000_000,
        metavar="N",
        help="Mesh cycles that the motion is followed at most, transient and averages together, before the "
        "search ends.",
    ),
]
MaxPeriod = Annotated[
    int | None,
    typer.Option(min=1, max=4096, metavar="P", help="Longest period looked for, in mesh cycles."),
]
AsJson = Annotated[
    bool,
    typer.Option(
        "--json",
        help="Prints one JSON object and nothing else on standard output "
        "(gearlash schema --result describes it).",
    ),
]
AsCsv = Annotated[
    bool,
    typer.Option(
        "--csv",
        help="Tables as CSV: into the folder of --out, or, without one, the main table on standard output "
        "and nothing else.",
    ),
]
DecimalComma = Annotated[
    bool,
    typer.Option("--decimal-comma", help="The same with decimal commas and semicolons between columns."),
]
Out = Annotated[
    Path | None,
    typer.Option(
        "--out",
        parser=folder,
        metavar="DIR",
        help="Also writes the results into this folder, made if missing. Files there that gearlash did not "
        "write are never overwritten; results of another question are moved into earlier-1 there, and what "
        "ends early takes the place of no complete answer to the same question.",
    ),
]
ReportOut = Annotated[
    Path,
    typer.Option(
        "--out",
        parser=folder,
        metavar="DIR",
        help="Folder of the report, made if missing. Files there that gearlash did not write are never "
        "overwritten; a report of another case, or with other values or options, is moved into earlier-1 "
        "there, and one that ends early takes the place of no complete one of the same question.",
    ),
]
Workers = Annotated[
    int | None,
    typer.Option(
        min=0,
        max=512,
        metavar="N",
        help="Processes; 1 computes in this one. The results do not depend on it. "
        "[default: one a core where it pays]",
    ),
]
Over = Annotated[
    str,
    typer.Option(
        metavar="NAME=FROM:TO:COUNT",
        help="Parameter to vary, by short name or path: omega=0.5:1.4:900, "
        "pinion_speed=1000:6000rpm:500, backlash=20:200um:100.",
    ),
]
