"""A legend below a figure, in as many columns as its width holds; the figure grows with its rows."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.artist import Artist
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

MARGIN = 2.0  # mm, on either side
MM = 25.4  # of an inch


def legend_below(
    figure: Figure, handles: Sequence[Artist], title: str | None, *, columns: int, room: float
) -> None:
    """At most so many ``columns``; ``room`` (mm): the height of legend that the figure is made for."""
    renderer = FigureCanvasAgg(figure).get_renderer()
    for count in range(columns, 0, -1):
        legend = figure.legend(
            handles=list(handles), loc="outside lower center", ncols=count, columnspacing=1.4,
            title_fontsize=6.5, title=title,
        )  # fmt: skip
        size = legend.get_window_extent(renderer)
        width, height = (side / figure.dpi * MM for side in (size.width, size.height))
        if count == 1 or width <= figure.get_figwidth() * MM - 2.0 * MARGIN:
            figure.set_figheight(figure.get_figheight() + max(0.0, height - room) / MM)
            return
        legend.remove()
