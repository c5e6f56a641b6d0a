"""What `gearlash check` keeps in the folder of --out."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from gearlash.case import Case

from .answers.check import CheckAnswer
from .folder import claim
from .jsonio import write_file

if TYPE_CHECKING:
    from .tables import CsvAsked, Tables

FILES = ("check.json", "teeth.svg", "teeth.pdf", "curves.svg", "curves.pdf")
TABLES = ("check", "notes")


def write_check(
    out: Path, case: Case, answer: CheckAnswer, csv: CsvAsked, tables: Callable[[], Tables]
) -> None:
    """The answer, the teeth in mesh of a pair that has known ones, and curves that the case states."""
    folder = claim(out, [*FILES, *csv.files(*TABLES)])
    folder.make_room()
    write_file(answer, folder.file("check.json"))
    csv.keep(folder, TABLES, tables)
    _write_curves(case, folder.file("curves"))
    from gearlash.plots import mesh_drawing, save
    from gearlash.plots.teeth_of_case import teeth_of_case

    teeth = teeth_of_case(case)
    if teeth is not None:
        save(mesh_drawing(*teeth), folder.file("teeth"))
    folder.note()


def _write_curves(case: Case, stem: Path) -> None:
    """Stiffness and error over their points, of a case with such curves."""
    if not any(value.path.startswith("curves.") for value in case.values()):
        return
    from gearlash.plots import save, stated_curves
    from gearlash.plots.stated_curves import curves_of

    save(stated_curves(curves_of(case), f"{case.name}: stated curves, and what the model takes"), stem)
