"""An atlas: its curves over its map, and the points where they meet."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.figure import Figure

from gearlash.case import Case
from gearlash.results.atlas import Atlas
from gearlash.results.plane_dataset import plane_dataset
from gearlash.system import Family, given

from .curve_diagram import curve_diagram
from .units import Twin


def atlas_diagram(
    atlas: Atlas,
    model: Case | Family,
    *,
    title: str = "",
    span: Sequence[Sequence[float]] = (),
    along: Sequence[Twin | None] = (None, None),
) -> Figure:
    """The curves of an atlas over its map in pale colours, with the points where two things happen at once.

    Parameters
    ----------
    atlas : Atlas
        With at least one curve.
    model : Case or Family
        That of the atlas; of a case the axes have units.
    title : str
        What the atlas is of.
    span : sequence of two pairs of float
        First and last value of either parameter that are shown; the rectangle where nothing is given.
    along : sequence of Twin or None
        For either parameter the unit in which it was asked for.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    GearlashError
        For an atlas without curves.

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash import plots
    >>> case = gl.load_case("kahraman-singh")
    >>> x, y = gl.Axis.even("omega", 0.81, 0.83, 2), gl.Axis.even("D", 0.9, 1.1, 2)
    >>> figure = plots.atlas_diagram(gl.atlas(case, x, y, lines=1), case)
    >>> [round(float(end), 6) for end in figure.axes[0].get_xlim()]
    [0.81, 0.83]
    """
    given.instance("atlas", atlas, Atlas, "an atlas, as from gearlash.atlas")
    ends = [(float(axis.values[0]), float(axis.values[-1])) for axis in (atlas.plane.x, atlas.plane.y)]
    return curve_diagram(
        [each.curve for each in atlas.curves],
        model,
        title=title,
        behind=plane_dataset(model, atlas.plane),
        span=span or ends,
        along=along,
    )
