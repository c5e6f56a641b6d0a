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
    write_file(answer, folder.file("check.json"))
    csv.keep(folder, TABLES, tables)
    _write_curves(case, folder.file("curves"))
    numbers = case.numbers
    pair = None if numbers is None else numbers.body.drawn
    if pair is None:
        return
    from gearlash.plots import mesh_drawing, save

    play = float(case.scales.backlash_m(case.family()[0].defaults["D"]))
    title = f"{case.name}: {pair.pinion.teeth}/{pair.gear.teeth} teeth in the transverse section"
    save(mesh_drawing(pair, title, play, _widths(case)), folder.file("teeth"))


def _widths(case: Case) -> tuple[float, float] | None:
    """Face widths of both gears, m."""
    found = {value.path: value.value for value in case.values()}
    first, second = (found.get(f"{gear}.face_width") for gear in ("pinion", "gear"))
    return None if first is None or second is None else (1e-3 * float(first), 1e-3 * float(second))


def _write_curves(case: Case, stem: Path) -> None:
    """Stiffness and error over their points, of a case with such curves."""
    if not any(value.path.startswith("curves.") for value in case.values()):
        return
    from gearlash.plots import save, stated_curves
    from gearlash.plots.stated_curves import curves_of

    save(stated_curves(curves_of(case), f"{case.name}: stated curves, and what the model takes"), stem)
