"""What `gearlash compare` keeps in the folder of --out."""

from __future__ import annotations

from typing import TYPE_CHECKING

from gearlash.case import Case
from gearlash.case.units import pretty
from gearlash.results.store import write_together

from .files import at_what, draw_if
from .folder import OutFolder
from .jsonio import text

if TYPE_CHECKING:
    from gearlash.studies.comparison import Comparison

    from .answers.compare import CompareAnswer


def write_compare(
    folder: OutFolder, case: Case, found: Comparison, answer: CompareAnswer, table: bytes
) -> None:
    """The answer (JSON), a row for each speed (CSV) and, where all was computed, the overlay."""
    unit = f" [{pretty(answer.unit)}]" if answer.unit else ""
    speed = f"speed [{pretty(answer.speed_unit)}]" if answer.speed_unit else "ω"
    contents = {
        folder.file("compare.json"): text(answer).encode("utf-8"),
        folder.file("compare.csv"): table,
    }
    write_together(contents, folder.outdated("compare.json", ("compare.svg", "compare.pdf")))
    words = answer.quantity.replace("_", " ")
    order = f" {answer.order:g}" if answer.order is not None else ""
    draw_if(
        folder, "compare", found.complete,
        lambda plots: plots.overlay(
            [p.speed for p in answer.points], [p.measured for p in answer.points],
            [p.up for p in answer.points], [p.down for p in answer.points],
            speed, f"{words}, {answer.figure}{order}{unit}",
            f"{case.name}: measured and computed{at_what(case, 'omega')}",
            [(jump.lower, jump.upper) for jump in answer.jumps],
            [p.direction for p in answer.points],
            found.apart,
        ),
    )  # fmt: skip
