"""What `gearlash branch` keeps in the folder of --out."""

from __future__ import annotations

import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from gearlash.case import Case, CaseError, Problem
from gearlash.results.branch_dataset import branch_dataset
from gearlash.results.branch_file import branch_text
from gearlash.results.store import netcdf, write_together

from .command_tables import branch_tables
from .files import at_what, draw_if
from .folder import OutFolder
from .jsonio import text
from .second_scale import scale_of

if TYPE_CHECKING:
    import xarray as xr

    from gearlash.studies.switches import SwitchedBranch

    from .answers.branch import BranchAnswer
    from .tables import CsvAsked

NUMBERED = re.compile(r"branch-\d+\.(json|nc|csv)")
FIRST = ("branch-1.json", "branch-1.nc", "branch-1.csv")


def check_nothing_is_lost(out: Path | None, resume: Path | None, whole: bool) -> None:
    """Raises `CaseError` where branches in the folder of --resume would be replaced by others.

    A resumed branch is number 1 of its own answer. So its folder may take that answer only where it has no
    other branch, and the resumed one is taken as a ``whole``."""
    if out is None or resume is None or not out.is_dir() or not resume.exists():
        return
    source = resume.resolve()
    if not source.parent.samefile(out):
        return
    kept = FIRST if whole and source.name == FIRST[0] else ()
    lost = sorted(
        {path.stem for path in out.iterdir() if NUMBERED.fullmatch(path.name) and path.name not in kept}
    )
    if lost:
        expected = (
            f"another folder: in this one {', '.join(lost)} (.json, .nc, .csv) would be replaced or removed, "
            "as a resumed branch is number 1 of its own answer"
        )
        raise CaseError("--out", [Problem("--out", repr(str(out)), expected)])


def write_branches(
    folder: OutFolder,
    case: Case,
    found: Sequence[SwitchedBranch],
    datasets: Sequence[xr.Dataset] | None,
    answer: BranchAnswer,
    csv: CsvAsked,
    measure: str,
    span: Sequence[float] = (),
) -> None:
    """The answer (JSON), every branch as a file to resume from (JSON), as data (NetCDF) and as a table (CSV),
    all special points as a table, and the figure, of the part ``span``, as SVG and PDF, unless a signal
    came (``datasets`` None)."""
    made = datasets
    if made is None:
        made = [branch_dataset(case, each.branch, extremes=False) for each in found]
    contents: dict[Any, bytes | memoryview] = {folder.file("branch.json"): text(answer).encode("utf-8")}
    for name, content in csv.bytes_of(branch_tables(case, made, answer.axis)).items():
        contents[folder.file(name)] = content
    for i, (each, dataset) in enumerate(zip(found, made, strict=True), 1):
        contents[folder.file(f"branch-{i}.json")] = branch_text(each.branch, case)
        contents[folder.file(f"branch-{i}.nc")] = netcdf(dataset)
    older = [path for path in folder.path.glob("branch-*.*") if folder.owns(path.name)]
    gone = [path for path in older if path not in contents]
    write_together(contents, [*gone, *folder.outdated("branch.json", ("branch.svg", "branch.pdf"))])
    if datasets:
        draw_if(folder, "branch", True, lambda plots: _figure(plots, case, datasets, answer, measure, span))


def _figure(
    plots: Any,
    case: Case,
    datasets: Sequence[xr.Dataset],
    answer: BranchAnswer,
    measure: str,
    span: Sequence[float],
) -> Any:
    """With the parameter in the unit that was asked for."""
    title = f"{'Branches' if len(datasets) > 1 else 'Branch'} of {case.name} over {answer.axis.asked.title}"
    title += at_what(case, answer.axis.name)
    units, along = plots.Units.of(case), scale_of(answer.axis)
    return plots.branch_diagram(datasets, measure, title=title, span=span, units=units, along=along)
