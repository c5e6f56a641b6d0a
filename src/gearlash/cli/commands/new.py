"""gearlash new"""

from __future__ import annotations

import inspect
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from gearlash.cli.exits import ExitCode, command, delivery
from gearlash.cli.options import AsJson
from gearlash.cli.words_of_drawing import WORDS, Word

if TYPE_CHECKING:
    from gearlash.system import GearlashError


def _option(word: Word) -> inspect.Parameter:
    kind = Annotated[str | None, typer.Option(word.option, metavar=word.example, help=word.what)]
    return inspect.Parameter(word.name, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=kind)


def _new(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="The case file to write, such as pair.toml.")],
    *,
    description: Annotated[
        str | None, typer.Option(metavar="TEXT", help="A line about the pair, kept in the file.")
    ] = None,
    gears: Annotated[
        str | None,
        typer.Option(
            "--type",
            metavar="TYPE",
            help="Spur or helical, as the helix angle must say too; other gears are refused in words.",
        ),
    ] = None,
    shaft_angle: Annotated[
        str | None, typer.Option(metavar="0deg", help="Angle between the shafts; only 0 is taken.")
    ] = None,
    overwrite: Annotated[
        bool, typer.Option("--overwrite", help="Replaces a file that is there already.")
    ] = False,
    as_json: AsJson = False,
    **words: str | None,
) -> ExitCode:
    """What does the drawing say? Writes a case file from it, which all other commands take.

    For external spur and helical gears. From options, or from answers to questions where none is given and
    somebody is at the terminal, else a template: its values are those of an example, and comments, so that
    nothing is computed before they are put right and their # is taken away. Values of pinion and gear stand
    apart by a stroke (25/57), one stands for both, and /50mm is that of the gear alone. What a drawing leaves
    open (stiffness and how it varies, error, masses, bearings, damping, backlash) is estimated whenever the
    file is read, with range and source.
    """
    from gearlash.cli.answers.new import new_answer
    from gearlash.cli.comments_of_drawing import comments_of
    from gearlash.cli.drawing_file import file_text, template
    from gearlash.cli.frame import show_answer
    from gearlash.cli.interrupt import asking
    from gearlash.cli.new_file import checked_place, loaded, write
    from gearlash.cli.other_gears import check_shafts, check_teeth, check_type
    from gearlash.cli.questions import asked, at_a_terminal, words_of
    from gearlash.cli.words_of_drawing import placed
    from gearlash.system import GearlashError

    teeth = "" if gears is None else check_type(gears)
    if shaft_angle is not None:
        check_shafts(shaft_angle)
    checked_place(file, overwrite)
    stated = {name: text for name, text in words.items() if text is not None}
    questioned = not stated and at_a_terminal() and not as_json
    if questioned:
        with asking():
            stated = asked(words=words_of(teeth), file=str(file))
    example = not stated
    head = file.name, description or ""
    while True:
        texts = placed(stated or template(teeth))
        try:
            case = loaded(file, file_text(texts, *head), stated)
            check_teeth(teeth, case)
            break
        except GearlashError as error:
            if not questioned:
                raise
            stated = _asked_again(file, stated, error)
    text = file_text(texts, *head, example, comments_of(case))
    answer = new_answer(str(file), case, example)
    with delivery():
        write(file, text, overwrite)
        show_answer(answer, as_json)
    return ExitCode.OK


def _asked_again(file: Path, stated: dict[str, str], error: GearlashError) -> dict[str, str]:
    """What was typed, where what the pair is refused for is asked for again. Raises the ``error`` where no
    word is to blame, or nobody answers; what was typed is not lost."""
    from gearlash.case import CaseError
    from gearlash.cli.interrupt import asking
    from gearlash.cli.questions import as_command, asked_again

    again = None
    if isinstance(error, CaseError):
        with asking():
            again = asked_again(stated, error, file=str(file))
    if again is None:
        print(f"\nnothing was written{as_command(str(file), stated)}\n")
        raise error
    return again


# One option for each word of a drawing: written out they would be forty times the same five lines.
_own = inspect.signature(_new, eval_str=True)
_kept = [p for p in _own.parameters.values() if p.kind is not inspect.Parameter.VAR_KEYWORD]
_words = [_option(word) for word in WORDS]
_signed: Any = _new
_signed.__signature__ = _own.replace(parameters=[_kept[0], *_words, *_kept[1:]])
_signed.__annotations__ = {p.name: p.annotation for p in _signed.__signature__.parameters.values()}
_signed.__name__ = "new"
new = command(_new)
