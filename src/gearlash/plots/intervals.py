"""Where a motion stays: intervals of a parameter, computed beside reported, with what coexists inside
them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from gearlash.system import Label, MotionKind, Signature, label_text

from . import style
from .regimes import regime, short
from .units import Units, second
from .words import Words, drawn, words

REPORTED = "reported"
HEIGHT = 0.56  # of a bar, of the distance between two
ROW, NARROW_ROW, MANY = 8.5, 6.5, 12  # mm; where all panels together have more bars than this


@dataclass(frozen=True)
class Bar:
    """One interval of a parameter.

    Parameters
    ----------
    title : str
        At the left.
    lower, upper : float
    kind : {"reported", "computed", "coexisting"}
        Reported ones are hatched, the others have the colour of their motion.
    label : str
        P-Q-R or words, on the bar.
    lower_text, upper_text : str
        At its two ends.

    Examples
    --------
    >>> from gearlash.plots import Bar
    >>> Bar("window", 0.97, 1.11, "computed", "1-0-0").upper
    1.11
    """

    title: str
    lower: float
    upper: float
    kind: str
    label: Label | str | None = None
    lower_text: str = ""
    upper_text: str = ""


@dataclass(frozen=True)
class Panel:
    """The intervals of one parameter under one heading.

    Parameters
    ----------
    parameter : str
        Short name.
    title : str
    bars : tuple of Bar

    Examples
    --------
    >>> from gearlash.plots import Bar, Panel
    >>> len(Panel("omega", "At D = 1", (Bar("window", 0.97, 1.11, "computed"),)).bars)
    1
    """

    parameter: str
    title: str
    bars: tuple[Bar, ...]


@style.styled
def zones(panels: Sequence[Panel], units: Units | None = None) -> Figure:
    """Intervals of parameters as bars, one panel for each parameter.

    Parameters
    ----------
    panels : sequence of Panel
    units : Units, optional
        Second axes in physical units: `Units.of` a case.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> from gearlash import plots
    >>> panel = plots.Panel("omega", "At D = 1", (plots.Bar("window", 0.97, 1.11, "computed"),))
    >>> plots.zones([panel]).axes[0].get_title(loc="left")
    'At D = 1'
    """
    rows = [len(p.bars) for p in panels]
    row = NARROW_ROW if sum(rows) > MANY else ROW
    figure = style.figure(style.PAGE, sum(row * n + 27.0 for n in rows))
    axes = figure.subplots(len(panels), 1, squeeze=False, height_ratios=[n + 0.4 for n in rows])[:, 0]
    for panel, place in zip(panels, axes, strict=True):
        _panel(place, panel, words(None, units))
        second(place, (units or Units()).of_parameter(panel.parameter))
    return figure


def _panel(axes: Axes, panel: Panel, said: Words) -> None:
    low, high = min(b.lower for b in panel.bars), max(b.upper for b in panel.bars)
    wide = high - low
    axes.set_xlim(low - 0.42 * wide, high + 0.42 * wide)
    axes.set_ylim(len(panel.bars) - 0.3, -0.7)
    axes.set_yticks(range(len(panel.bars)), [drawn(b.title) for b in panel.bars])
    axes.tick_params(axis="y", length=0)
    axes.set_title(drawn(panel.title), pad=6.0)
    axes.set_xlabel(said.name(panel.parameter))
    for row, bar in enumerate(panel.bars):
        _bar(axes, row, bar, wide)
    computed = [b for b in panel.bars if b.kind != "coexisting"]
    for edge in sorted({e for b in computed for e in (b.lower, b.upper)}):
        axes.axvline(edge, color=style.PALE, lw=0.5, zorder=0.2)


def _bar(axes: Axes, row: int, bar: Bar, wide: float) -> None:
    plain = bar.kind == REPORTED
    kind = regime(bar.label if isinstance(bar.label, Signature | MotionKind) else None)
    fill = "white" if plain else kind.colour
    axes.add_patch(
        Rectangle(
            (bar.lower, row - HEIGHT / 2),
            bar.upper - bar.lower,
            HEIGHT,
            facecolor=fill,
            edgecolor=style.INK,
            linewidth=0.6,
            hatch="" if not plain else "///",
        )
    )
    middle = (bar.lower + bar.upper) / 2.0
    box = {"facecolor": "white", "edgecolor": "none", "pad": 1.2} if plain else None
    if bar.upper - bar.lower > (0.02 * len(short(bar.label)) + 0.012) * wide:
        axes.text(
            middle,
            row,
            label_text(bar.label) if plain else short(bar.label),
            ha="center",
            va="center",
            fontsize=7.5,
            bbox=box,
            color=style.INK if plain else kind.ink,
        )
    gap = 0.012 * wide
    over = {"va": "center", "fontsize": 7, "bbox": {"facecolor": "white", "edgecolor": "none", "pad": 0.6}}
    for at, text, side in (
        (bar.lower - gap, bar.lower_text, "right"),
        (bar.upper + gap, bar.upper_text, "left"),
    ):
        if text:
            axes.text(at, row, text, ha=side, **over)
