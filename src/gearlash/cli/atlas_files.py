"""What `gearlash atlas` keeps in the folder of --out."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from gearlash.case import Case
from gearlash.results.atlas_dataset import atlas_dataset
from gearlash.results.curve_file import curve_text
from gearlash.results.plane_dataset import plane_dataset
from gearlash.results.store import netcdf, write_together

from .files import at_what, draw_if
from .folder import OutFolder
from .jsonio import text
from .second_scale import scale_of

if TYPE_CHECKING:
    from gearlash.results.atlas import Atlas

    from .answers.atlas import AtlasAnswer


def write_atlas(folder: OutFolder, case: Case, found: Atlas, answer: AtlasAnswer) -> None:
    """Map and curves (NetCDF), the answer (JSON), every curve as a file to go on from (JSON), and the figure
    as SVG and PDF: of the curves over the map, or of the whole map where there is no curve."""
    contents: dict[Any, bytes | memoryview] = {
        folder.file("atlas.nc"): netcdf(atlas_dataset(case, found)),
        folder.file("atlas.json"): text(answer).encode("utf-8"),
    }
    for i, each in enumerate(found.curves, 1):
        contents[folder.file(f"curve-{i}.json")] = curve_text(each.curve, case)
    older = [path for path in folder.path.glob("curve-*.json") if folder.owns(path.name)]
    gone = [path for path in older if path not in contents]
    write_together(contents, [*gone, *folder.outdated("atlas.json", ("atlas.svg", "atlas.pdf"))])
    drawn = bool(found.curves) or found.plane.complete
    draw_if(folder, "atlas", drawn, lambda plots: _figure(plots, case, found, answer))


def _figure(plots: Any, case: Case, found: Atlas, answer: AtlasAnswer) -> Any:
    title = f"Atlas of {case.name} over {answer.x.asked.title} and {answer.y.asked.title}"
    title += at_what(case, answer.x.name, answer.y.name)
    if not found.curves:
        return plots.plane(plane_dataset(case, found.plane), units=plots.Units.of(case), title=title)
    if not found.complete:
        title += " (incomplete)"
    along = [scale_of(answer.x), scale_of(answer.y)]
    return plots.atlas_diagram(found, case, title=title, along=along)
