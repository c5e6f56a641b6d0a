"""What `gearlash curve` keeps in the folder of --out."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from gearlash.case import Case
from gearlash.results.branch_file import branch_text
from gearlash.results.curve_dataset import curve_dataset
from gearlash.results.curve_file import curve_text
from gearlash.results.store import netcdf, write_together

from .command_tables import curve_tables
from .files import at_what, draw_if
from .folder import OutFolder
from .jsonio import text
from .second_scale import scale_of

if TYPE_CHECKING:
    from gearlash.branches.curves import Curve

    from .answers.curve import CurveAnswer
    from .answers.curve_parts import Begun
    from .curve_inputs import CurveInputs
    from .tables import CsvAsked

FIGURES = ("curve.svg", "curve.pdf")


def file_names(count: int) -> list[str]:
    """Of so many curves."""
    kept = [f"curve-{i}.{form}" for i in range(1, count + 1) for form in ("json", "nc", "csv")]
    return ["curve.json", "special.csv", "branch-1.json", *FIGURES, *kept]


def write_curves(
    folder: OutFolder, asked: CurveInputs, found: Sequence[Begun], answer: CurveAnswer, csv: CsvAsked
) -> None:
    """The answer (JSON), every curve as a file to resume from (JSON), as data (NetCDF) and as a table (CSV),
    all points of the tables as one (CSV), the branch they begin at (JSON), and the figure as SVG and PDF."""
    case = asked.case
    curves = [each.curve for each in found if each.curve is not None]
    contents: dict[Any, bytes | memoryview] = {folder.file("curve.json"): text(answer).encode("utf-8")}
    for name, content in csv.bytes_of(curve_tables(case, curves, answer)).items():
        contents[folder.file(name)] = content
    if asked.branch is not None:
        contents[folder.file("branch-1.json")] = branch_text(asked.branch, case)
    for i, curve in enumerate(curves, 1):
        dataset = curve_dataset(case, curve)
        contents[folder.file(f"curve-{i}.json")] = curve_text(curve, case)
        contents[folder.file(f"curve-{i}.nc")] = netcdf(dataset)
    older = [path for path in folder.path.glob("curve-*.*") if folder.owns(path.name)]
    gone = [path for path in older if path not in contents]
    write_together(contents, instead_of=[*gone, *folder.outdated("curve.json", FIGURES)])
    if curves and answer.status != "incomplete":
        draw_if(folder, "curve", True, lambda plots: _figure(plots, case, curves, answer))


def _figure(plots: Any, case: Case, curves: Sequence[Curve], answer: CurveAnswer) -> Any:
    """With the parameters in the units that were asked for."""
    one, two = answer.axes
    what = "Curves" if len(curves) > 1 else "Curve"
    title = f"{what} of {case.name} over {one.asked.title} and {two.asked.title}"
    title += at_what(case, one.name, two.name)
    return plots.curve_diagram(curves, case, title=title, along=(scale_of(one), scale_of(two)))
