"""The one look of all figures: sizes of a journal page, a palette for colour-blind readers, files without
dates.

Palette: M. Okabe and K. Ito, Color Universal Design, 2008. Nothing is shown by colour alone: markers, line
styles, hatches or words say the same, so that a grey print can be read.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import wraps
from io import BytesIO
from pathlib import Path
from typing import Any, ParamSpec

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_hex, to_rgb
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke
from matplotlib.ticker import AutoLocator, AutoMinorLocator, FixedLocator, MaxNLocator, NullLocator
from matplotlib.transforms import ScaledTranslation
from numpy.typing import NDArray

from gearlash.results.store import write_together
from gearlash.system import arguments

P = ParamSpec("P")

COLUMN, PAGE = 88.0, 180.0  # mm: one column and the whole width of a journal page
MM = 1.0 / 25.4
RASTER_DPI = 400  # of the dense point layers inside vector files

INK, GREY, PALE = "#1a1a1a", "#6e6e6e", "#c9c9c9"
BLUE, SKY, GREEN = "#0072b2", "#56b4e9", "#009e73"
VERMILION, ORANGE, YELLOW, PURPLE = "#d55e00", "#e69f00", "#f0e442", "#cc79a7"

READABLE = 4.5  # to 1: contrast of words with a white ground

FREE_SHADE = "#e9e9e9"  # contact is lost
BOUNDARY = VERMILION

RC: Any = {  # matplotlib types these names as literals only in newer versions
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],  # comes with matplotlib, so every machine draws the same
    "mathtext.fontset": "dejavusans",
    "font.size": 8.0,
    "axes.titlesize": 8.0,
    "axes.labelsize": 8.0,
    "xtick.labelsize": 7.5,
    "ytick.labelsize": 7.5,
    "legend.fontsize": 7.5,
    "axes.linewidth": 0.6,
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "axes.titlelocation": "left",
    "axes.titlepad": 4.0,
    "axes.labelpad": 2.5,
    "axes.formatter.useoffset": False,
    "axes.formatter.limits": (-4, 5),
    "axes.axisbelow": True,
    "xtick.direction": "in",
    "ytick.direction": "in",
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.minor.width": 0.4,
    "ytick.minor.width": 0.4,
    "xtick.major.size": 3.0,
    "ytick.major.size": 3.0,
    "xtick.minor.size": 1.8,
    "ytick.minor.size": 1.8,
    "lines.linewidth": 0.9,
    "lines.solid_capstyle": "round",
    "hatch.linewidth": 0.6,
    "legend.frameon": False,
    "legend.handlelength": 1.6,
    "legend.borderaxespad": 0.3,
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
    "text.hinting": "none",  # hinted letters are narrower at a coarse resolution: labels would not fit
    "svg.fonttype": "path",  # text as outlines: the file needs no font of the reader's machine
    "svg.hashsalt": "gearlash",
    "pdf.fonttype": 42,
    "path.simplify": True,
    "path.simplify_threshold": 0.05,
}


def styled(draw: Callable[P, Figure]) -> Callable[P, Figure]:
    """Draws under this style whatever the caller's settings are, and leaves those alone.

    The layout is settled once, here: it costs as much as drawing, and every format is to have the same.
    """

    draw = arguments(draw)

    @wraps(draw)
    def under_style(*args: P.args, **kwargs: P.kwargs) -> Figure:
        with mpl.rc_context():
            mpl.rcdefaults()
            mpl.rcParams.update(RC)
            made = draw(*args, **kwargs)
            engine = made.get_layout_engine()
            if engine is not None:
                _major_ticks(made)
                engine.execute(made)
                made.set_layout_engine("none")
            _minor_ticks(made)
            return made

    return under_style


def _major_ticks(made: Figure) -> None:
    """As many ticks as fit the panel before the layout: if they changed with it, labels could grow again."""
    for axes in made.axes:
        box = axes.get_position()
        width, height = box.width * made.get_figwidth() / MM, box.height * made.get_figheight() / MM
        for panel in (axes, *axes.child_axes):
            for axis, length, apart in ((panel.xaxis, width, 12.0), (panel.yaxis, height, 8.0)):
                if isinstance(axis.get_major_locator(), AutoLocator):
                    bins = int(min(9, max(2, length // apart)))
                    axis.set_major_locator(MaxNLocator(bins, steps=[1, 2, 2.5, 5, 10]))


def _minor_ticks(made: Figure) -> None:
    """Minor ticks on every axis of numbers; after the layout, which they only slow down."""
    panels = [each for axes in made.axes for each in (axes, *axes.child_axes)]
    for axis in (axis for panel in panels for axis in (panel.xaxis, panel.yaxis)):
        even = axis.get_scale() == "linear" and not isinstance(
            axis.get_major_locator(), FixedLocator | NullLocator
        )
        if axis.get_visible() and even:
            axis.set_minor_locator(AutoMinorLocator())


class Shown(Figure):
    """A figure that a notebook shows as it is, whatever its settings of matplotlib are."""

    def _repr_svg_(self) -> str:
        return to_bytes(self, "svg").decode()


def figure(width: float, height: float) -> Figure:
    """An empty figure of a size in mm, with a layout that leaves no label outside."""
    made = Shown(figsize=(width * MM, height * MM), dpi=RASTER_DPI, layout="constrained")
    FigureCanvasAgg(made)
    pads = {"w_pad": 1.0 * MM, "h_pad": 0.8 * MM, "wspace": 0.02, "hspace": 0.02}
    engine = made.get_layout_engine()
    assert engine is not None
    engine.set(**pads)
    return made


def align_labels(panels: Sequence[Axes], left: float = 11.0) -> None:
    """Puts the y labels of panels one below the other at one distance (mm), known to the layout."""
    for panel in panels:
        shift = ScaledTranslation(-left * MM, 0.0, panel.figure.dpi_scale_trans)
        panel.yaxis.set_label_coords(0.0, 0.5, transform=panel.transAxes + shift)


def to_bytes(made: Figure, form: str, dpi: float = RASTER_DPI) -> bytes:
    """The content of a file with this figure; the same figure gives the same bytes.

    Parameters
    ----------
    made : matplotlib.figure.Figure
    form : {"svg", "pdf", "png"}
    dpi : float
        Dots an inch of a PNG, and of the dense layers of points in the others.

    Returns
    -------
    bytes

    Examples
    --------
    >>> from gearlash import plots
    >>> figure = plots.zones([plots.Panel("omega", "", (plots.Bar("window", 0.9, 1.1, "computed"),))])
    >>> plots.to_bytes(figure, "svg")[:5]
    b'<?xml'
    """
    empty: dict[str, dict[str, None]] = {
        "svg": dict.fromkeys(("Date", "Creator", "Format", "Type")),
        "pdf": dict.fromkeys(("CreationDate", "Creator", "Producer")),
        "png": {"Software": None},
    }
    out = BytesIO()
    with mpl.rc_context(), _quiet("fontTools"):
        mpl.rcdefaults()
        mpl.rcParams.update(RC)
        made.savefig(out, format=form, dpi=dpi, metadata=empty[form])
    return out.getvalue()


@contextmanager
def _quiet(name: str) -> Iterator[None]:
    """Without the remarks of a library on the dates inside the fonts it puts into a PDF."""
    logger = logging.getLogger(name)
    level = logger.level
    logger.setLevel(logging.ERROR)
    try:
        yield
    finally:
        logger.setLevel(level)


def save(
    made: Figure, stem: str | Path, forms: tuple[str, ...] = ("svg", "pdf"), dpi: float = RASTER_DPI
) -> list[Path]:
    """Writes a figure in several formats: all of them, or none where one cannot be written.

    Parameters
    ----------
    made : matplotlib.figure.Figure
    stem : str or Path
        Path of the files without the ending.
    forms : tuple of str
        Of ``svg``, ``pdf`` and ``png``.
    dpi : float
        Dots an inch of a PNG, and of the dense layers of points in the others.

    Returns
    -------
    list of Path

    Examples
    --------
    >>> import tempfile
    >>> from gearlash import plots
    >>> figure = plots.zones([plots.Panel("omega", "", (plots.Bar("window", 0.9, 1.1, "computed"),))])
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     [path.name for path in plots.save(figure, folder + "/zone", forms=("svg",))]
    ['zone.svg']
    """
    stem = Path(stem)
    paths = [stem.with_name(f"{stem.name}.{form}") for form in forms]
    write_together({path: to_bytes(made, form, dpi) for path, form in zip(paths, forms, strict=True)})
    return paths


def words_in(colour: str) -> str:
    """The colour of words that belong to a line of this colour: the same, as dark as reading asks for."""
    parts = np.array(to_rgb(colour))
    while 1.05 / (luminance(parts) + 0.05) < READABLE:
        parts *= 0.97
    return to_hex((float(parts[0]), float(parts[1]), float(parts[2])))


def luminance(parts: NDArray[np.float64]) -> float:
    """Relative luminance of a colour, red, green and blue from 0 to 1 (sRGB)."""
    linear = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
    return float(np.array([0.2126, 0.7152, 0.0722]) @ linear)


def cased(width: float) -> list[withStroke]:
    """A white edge around what lies over other things, so that it is told from them: ``width`` in points."""
    return [withStroke(linewidth=width, foreground="white")]
