"""A case file that was written, in the terminal."""

from __future__ import annotations

import shlex
from collections.abc import Iterator

from rich.text import Text

from gearlash.cli.answers.new import NewAnswer

from .check import open_rows
from .layout import facts, headline, note, remarks
from .numbers import Marks


def new_view(answer: NewAnswer, width: int) -> Iterator[Text]:
    """What was written, what is estimated, what to do next."""
    count = len(answer.estimated)
    if answer.example:
        what = "a template with the values of an example as comments; nothing is stated yet"
    else:
        unusual = f"{len(answer.notes)} to look at" if answer.notes else "nothing to correct"
        limits = sum(value.least is not None for value in answer.stated)
        of_them = f", {limits} of them with limits" if limits else ""
        what = f"{len(answer.stated)} values stated{of_them}, {count} estimated; {unusual}"
    yield from headline(f"{answer.file}: written, {answer.kind}, {what}", width)
    for remark in answer.notes:
        yield from note(f"{remark.path}: {remark.text}", width, style="yellow")
    title = "Estimated from the example, with ranges" if answer.example else "Estimated, with ranges"
    yield from remarks(title, open_rows(answer.estimated, Marks({})), width)
    file = shlex.quote(answer.file)
    low, high = (f"{float(f'{factor * answer.speed_rpm:.4g}'):.9g}" for factor in (0.5, 1.5))
    rows = [
        ("edit", "take the # from what the drawing says, put your own values in place of others"),
        ("all of it", f"gearlash check {file}"),
        ("here", f"gearlash run {file}"),
        ("where is it quiet", f"gearlash zones {file} --over pinion_speed={low}:{high}rpm:41"),
        ("all on one page", f"gearlash report {file}"),
    ]
    yield from facts("Next", rows, width)
    yield from note("An estimate is no measurement; state what is known better.", width)
