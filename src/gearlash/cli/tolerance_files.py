"""What `gearlash tolerance` keeps in the folder of --out."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from gearlash.case import Case
from gearlash.results.store import write_together

from .files import MAIN_VALUES, at_what, draw_if, draw_stopped
from .folder import OutFolder
from .jsonio import text

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from gearlash.results.tolerance import Tolerance

    from .answers.tolerance import ToleranceAnswer


def write_tolerance(
    folder: OutFolder, case: Case, found: Tolerance, answer: ToleranceAnswer, table: bytes
) -> None:
    """The answer (JSON), the probability as a table (CSV), and the figure, which says what it lacks where the
    work was stopped."""
    contents = {
        folder.file("tolerance.json"): text(answer).encode("utf-8"),
        folder.file("tolerance.csv"): table,
    }
    write_together(contents, folder.outdated("tolerance.json", ("tolerance.svg", "tolerance.pdf")))

    def figure(plots: Any) -> Figure:
        varied = {path.rpartition(".")[2] for path in (found.axis.name, *(one.path for one in found.inputs))}
        given = at_what(case, *varied, *(short for short, leaf in MAIN_VALUES if leaf in varied))
        return plots.tolerance_bands(found, f"Tolerances of {case.name}{given} (dashed: its own value)")

    if found.complete:
        draw_if(folder, "tolerance", True, figure)
    else:
        draw_stopped(folder, "tolerance", figure)
