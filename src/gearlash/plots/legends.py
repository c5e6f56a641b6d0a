"""A legend below a figure, in as many columns as its width holds; the figure grows with its rows."""

from __future__ import annotations

from collections.abc import Sequence
from textwrap import fill

from matplotlib.artist import Artist
from matplotlib.backends.backend_agg import FigureCanvasAgg, RendererAgg
from matplotlib.figure import Figure
from matplotlib.text import Text

MARGIN = 2.0  # mm, on either side
TITLE = 6.5  # points
SLACK = 6  # characters: lines of words are not equally long
MM = 25.4  # of an inch


def legend_below(
    figure: Figure, handles: Sequence[Artist], title: str | None, *, columns: int, room: float
) -> None:
    """At most so many ``columns``, below a ``title`` in as many lines as it takes; ``room`` (mm): the height
    of legend that the figure is made for."""
    renderer = FigureCanvasAgg(figure).get_renderer()
    widest = figure.get_figwidth() * MM - 2.0 * MARGIN
    title = title and _in_lines(figure, renderer, title, widest - 2.0 * MARGIN)
    for count in range(columns, 0, -1):
        legend = figure.legend(
            handles=list(handles), loc="outside lower center", ncols=count, columnspacing=1.4,
            title_fontsize=TITLE, title=title, alignment="center",
        )  # fmt: skip
        size = legend.get_window_extent(renderer)
        width, height = (side / figure.dpi * MM for side in (size.width, size.height))
        if count == 1 or width <= widest:
            figure.set_figheight(figure.get_figheight() + max(0.0, height - room) / MM)
            return
        legend.remove()


def _in_lines(figure: Figure, renderer: RendererAgg, text: str, widest: float) -> str:
    """A text in lines that are at most so wide (mm)."""
    for count in range(1, len(text) + 1):
        lines = fill(text, -(-len(text) // count) + (count > 1) * SLACK, break_long_words=False)
        width = Text(0.0, 0.0, lines, fontsize=TITLE, figure=figure).get_window_extent(renderer).width
        if width / figure.dpi * MM <= widest:
            return lines
    return text
