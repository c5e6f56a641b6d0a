"""The pages of docs that are made from the program: `python -m tools.reference docs`."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import typer.main

from gearlash.cli.app import app
from tools.reference_results import exit_codes, results_page

HEAD = """\
# Command line

Made from the program by `python -m tools.reference docs`; do not edit.

`CASE` is a case file or the name of a bundled case. A value of `--set`, `--near` and `--over` is written as
it would stand in the case file: `omega=0.942`, `pinion_speed=3600rpm`, `mesh.backlash=80um`. Results go to
standard output, notices, progress and problems to standard error. [results.md](results.md) describes what
`--json` prints and what `--out` writes.
"""


ENVIRONMENT = """\
## Environment

| | |
|---|---|
| `GEARLASH_CACHE_DIR` | Folder of compiled kernels, absolute. [default: `gearlash` in \
`XDG_CACHE_HOME`, else in `LOCALAPPDATA`, else in `~/.cache`] |
| `GEARLASH_QUIET=1` | From Python: no word while kernels are being compiled. |
| `GEARLASH_MEMORY=4GB` | Most memory for the tables of one system (KB to TB, or KiB to TiB). [default: 1GB] |
| `COLUMNS` | Width of what is printed. [default: that of the terminal; 120 for a file or a pipe] |
| `NO_COLOR`, `TERM=dumb` | Print without colours. |

- No folder for compiled kernels, or one that cannot be written (read-only home, full disk): every run
  compiles, about 30 s on two free cores, and says so. So it does where that folder, or the one of a version
  in it, belongs to another user or may be written by others: what lies there is not loaded. A cached kernel
  that is missing or damaged is compiled again. Of several first runs at once one compiles; the others say
  that they wait for it. Kernels of other versions go when those of a new one are stored and nothing has
  used them for 30 days.
- A motion is computed from tables of its system, whose size is known before they are built. What would take
  more than `GEARLASH_MEMORY` is refused, and the refusal names what makes it so; a point of a sweep or pixel
  of a map that is refused fails alone. It is a bound for the tables of one system: `run`, `sweep`, `map` and
  `zones` hold those of two at a time, `graze` up to five, and each worker has its own. From 100 MB on a
  line says before the computation that it will be slow, and why.
- Nothing is imported from the folder in which a command is called, neither by it nor by processes that it
  starts. (What `PYTHONPATH` names is there before this program has a say; an empty part of it means the
  current folder.)
- `--out` names a file, or a place that cannot be written: exit code 2, before anything is computed.
- The disk is full when results are written: they are still printed, each file is there whole or not at
  all, and the exit code is 4. The same for standard output that cannot be written.
- The reader of a pipe has seen enough (`gearlash check CASE | head -1`): the command ends quietly with
  exit code 0; files of `--out` are written before anything is printed. Standard output or error that is
  closed from the start loses what is printed and changes nothing else.
- A terminal that is not UTF-8: letters that its encoding lacks are spelled (ξ as xi, µm as um).
- Names of files may hold anything: where they are printed, signs stand for control characters, so that no
  name steers a terminal.
"""


def reference() -> str:
    """The whole page, Markdown."""
    group: Any = typer.main.get_command(app)
    parts = [HEAD, "\n".join(_contents(group.commands))]
    parts += ["\n".join(_command(name, command)) for name, command in group.commands.items()]
    parts += [ENVIRONMENT, "\n".join(exit_codes())]
    return "\n\n".join(part.strip() for part in parts) + "\n"


def _contents(commands: dict[str, Any]) -> Iterator[str]:
    yield "| command | answers |"
    yield "|---|---|"
    for name, command in commands.items():
        yield f"| [`gearlash {name}`](#gearlash-{name}) | {_question(command)} |"
    yield "| `gearlash --version` | Which version is this? |"


def _question(command: Any) -> str:
    """The first sentence of a command's help."""
    first = _help(command)[0]
    return first.partition("?")[0] + "?"


def _help(command: Any) -> list[str]:
    paragraphs = inspect.cleandoc(command.callback.__doc__ or "").split("\n\n")
    return [" ".join(paragraph.split()) for paragraph in paragraphs]


def _command(name: str, command: Any) -> Iterator[str]:
    arguments = [p for p in command.params if p.param_type_name == "argument"]
    options = [p for p in command.params if p.param_type_name == "option" and p.name != "help"]
    usage = "".join(f" {a.metavar}" if a.required else f" [{a.metavar}]" for a in arguments)
    required = "".join(f" {o.opts[0]} {o.metavar}" for o in options if o.required)
    yield f"## `gearlash {name}`"
    yield ""
    yield "```console"
    yield f"gearlash {name}{usage}{required}{' [OPTIONS]' if options else ''}"
    yield "```"
    for paragraph in _help(command):
        yield ""
        yield paragraph
    yield ""
    yield "| | |"
    yield "|---|---|"
    for parameter in (*arguments, *options):
        yield f"| {_name(parameter)} | {_text(parameter)} |"


def _name(parameter: Any) -> str:
    if parameter.param_type_name == "argument":
        return f"`{parameter.metavar}`"
    value = "" if parameter.is_flag else f" {parameter.metavar}"
    return f"`{parameter.opts[0]}{value}`"


def _text(parameter: Any) -> str:
    text = " ".join((parameter.help or "").split())
    plain = isinstance(parameter.default, str) and parameter.param_type_name == "option"
    return f"{text} [default: {parameter.default}]" if plain and parameter.default else text


def write(folder: Path) -> None:
    """Writes cli.md and results.md there."""
    (folder / "cli.md").write_text(reference(), encoding="utf-8")
    (folder / "results.md").write_text(results_page(), encoding="utf-8")


if __name__ == "__main__":
    write(Path(sys.argv[1]))
