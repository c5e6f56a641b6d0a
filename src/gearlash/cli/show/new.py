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
    what = "with the values of an example" if answer.example else f"{len(answer.stated)} values stated"
    count = len(answer.estimated)
    yield from headline(
        f"{answer.file}: written, {answer.kind}, {what}, {count} estimated; nothing to correct", width
    )
    yield from remarks("Estimated, with ranges", open_rows(answer.estimated, Marks({})), width)
    file = shlex.quote(answer.file)
    low, high = (f"{factor * answer.speed_rpm:.4g}" for factor in (0.5, 1.5))
    rows = [
        ("edit", "take the # from what the drawing says, put your own values in place of others"),
        ("all of it", f"gearlash check {file}"),
        ("here", f"gearlash run {file}"),
        ("where is it quiet", f"gearlash zones {file} --over pinion_speed={low}:{high}rpm:41"),
        ("all on one page", f"gearlash report {file}"),
    ]
    yield from facts("Next", rows, width)
    yield from note("An estimate is no measurement; state what is known better.", width)
