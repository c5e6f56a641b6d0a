"""Time histories over one period: X with the boundaries of the gap, the mesh force, shading where contact
is lost.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from gearlash.studies.motion import Motion

from . import style
from .portraits import TOUCH, heading, stretches
from .units import ASSUMED, FORCE, PHASE, Units, X, literal, rests, second

LONG = 4  # mesh cycles above which a motion needs the width of the page
MOST_DRAWN_CYCLES = 12  # mesh cycles of a motion that does not repeat


@style.styled
def history(motion: Motion, units: Units | None = None, parameter: str = "omega", title: str = "") -> Figure:
    """Displacement and mesh force of one motion over time, as wide as a column.

    Parameters
    ----------
    motion : Motion
        As from `gearlash.motion`.
    units : Units, optional
        Second axes in physical units: `Units.of` a case.
    parameter : str
        Short name of the parameter whose value stands in the heading.
    title : str
        In place of that heading.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash import plots
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> found = gl.attractor(family.system(), family.start())
    >>> len(plots.history(gl.motion(found)).axes)
    2
    """
    figure = style.figure(style.COLUMN, 84.0)
    upper, lower = figure.subplots(2, 1, sharex=True)
    scales = units or Units()
    _columns(figure, [(upper, lower)], [motion], scales, parameter)
    if title:
        upper.set_title(literal(title))
    if figure.legends and rests(scales.length, scales.force):
        figure.legends[0].set_title(ASSUMED, prop=FontProperties(size=6.5))
    return figure


@style.styled
def triple(motions: Sequence[Motion], units: Units | None = None, parameter: str = "omega") -> Figure:
    """Histories before, at and after an event: side by side, or below each other where a period is long.

    Parameters
    ----------
    motions : sequence of Motion
        Before, at and after, in this order.
    units : Units, optional
        Second axes in physical units: `Units.of` a case.
    parameter : str
        Short name of the parameter whose value stands in the heading.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash import plots
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> found = gl.attractor(family.system(), family.start())
    >>> motion = gl.motion(found)
    >>> len(plots.history_triple([motion, motion, motion]).axes)
    6
    """
    count, units = len(motions), units or Units()
    if max(_shown(m) for m in motions) <= LONG:
        figure = style.figure(style.PAGE, 92.0)
        panels = figure.subplots(2, count, sharex="col", sharey="row", squeeze=False)
        _columns(figure, list(zip(panels[0], panels[1], strict=True)), motions, units, parameter)
        return figure
    figure = style.figure(style.PAGE, 56.0 * count + 14.0)
    panels = figure.subplots(2 * count, 1, squeeze=False, height_ratios=[1.2, 1.0] * count)[:, 0]
    for i, motion in enumerate(motions):
        pair = panels[2 * i], panels[2 * i + 1]
        _pair(*pair, motion)
        pair[0].tick_params(labelbottom=False)
        pair[0].set_title(f"({'abc'[i % 3]})  {heading(motion, parameter)}")
        _labels(*pair, units, first=True, last=True)
    panels[-1].set_xlabel(PHASE)
    style.align_labels(list(panels))
    figure.legend(handles=_key(motions), loc="outside lower center", ncols=5)
    return figure


def _shown(motion: Motion) -> float:
    """Mesh cycles in the picture: a whole period if there is one."""
    return motion.cycles if motion.periodic else min(motion.cycles, float(MOST_DRAWN_CYCLES))


def _columns(
    figure: Figure, pairs: list[tuple[Axes, Axes]], motions: Sequence[Motion], units: Units, parameter: str
) -> None:
    for i, (pair, motion) in enumerate(zip(pairs, motions, strict=True)):
        _pair(*pair, motion)
        letter = f"({'abc'[i % 3]})  " if len(motions) > 1 else ""
        pair[0].set_title(letter + heading(motion, parameter))
        pair[1].set_xlabel(PHASE)
        _labels(*pair, units, first=i == 0, last=i == len(motions) - 1)
    handles = _key(motions)
    if handles or rests(units.length, units.force):
        figure.legend(handles=handles, loc="outside lower center", ncols=5 if len(motions) > 1 else 3)


def _labels(upper: Axes, lower: Axes, units: Units, first: bool, last: bool) -> None:
    if first:
        upper.set_ylabel(X)
        lower.set_ylabel(FORCE)
    if last:
        second(upper, units.length, "y")
        second(lower, units.force, "y")


def _pair(upper: Axes, lower: Axes, motion: Motion) -> None:
    for axes in (upper, lower):
        lost(axes, motion)
        axes.set_xlim(0.0, _shown(motion))
        axes.xaxis.set_major_locator(MaxNLocator(6, integer=_shown(motion) > 2))
        axes.tick_params(which="both", top=True)
    _displacement(upper, motion)
    lower.axhline(0.0, color=style.INK, lw=0.5, zorder=1.0)
    lower.plot(motion.phase, motion.force, color=style.BLUE, lw=0.9)
    lower.margins(y=0.08)


def _displacement(axes: Axes, motion: Motion) -> None:
    axes.plot(motion.phase, motion.displacement, color=style.INK, lw=0.9)
    x = motion.displacement
    low, high = float(x.min()), float(x.max())
    wide = high - low
    for edge, text in _edges(motion):
        low, high = min(low, edge), max(high, edge)
        axes.axhline(edge, color=style.BOUNDARY, lw=0.7, zorder=1.0)
        axes.annotate(
            text,
            (_clearest(motion, edge, wide), edge),
            (0.0, 1.5),
            textcoords="offset points",
            fontsize=7,
            color=style.BOUNDARY,
            va="bottom",
            ha="center",
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.3, "alpha": 0.8},
        )
    wide = high - low
    axes.set_ylim(low - 0.08 * wide, high + 0.12 * wide)
    if motion.touch:
        axes.plot(
            [motion.touch.phase],
            [motion.touch.displacement],
            zorder=5,
            clip_on=False,
            **TOUCH,
        )
    hits = motion.hit_engaging
    axes.plot(
        motion.hit_phase[hits],
        motion.hit_displacement[hits],
        ls="none",
        marker="o",
        ms=2.8,
        mfc=style.BOUNDARY,
        mec=style.BOUNDARY,
        mew=0.6,
        zorder=4,
    )


def _edges(motion: Motion) -> list[tuple[float, str]]:
    """The boundaries near the motion, which are drawn, with their names."""
    low, high = float(motion.displacement.min()), float(motion.displacement.max())
    reach = 0.3 * (high - low)
    both = (motion.gap_plus, "$+D$"), (-motion.gap_minus, "$-D$")
    return [(edge, text) for edge, text in both if low - reach <= edge <= high + reach]


def _clearest(motion: Motion, edge: float, wide: float) -> float:
    """The phase at which a text just above a boundary lies farthest from the curve."""
    places = _shown(motion) * np.linspace(0.04, 0.96, 24)
    reach = 0.04 * _shown(motion)
    away = np.abs(motion.displacement - edge - 0.08 * wide)
    room = [float(away[np.abs(motion.phase - place) <= reach].min(initial=np.inf)) for place in places]
    return float(places[int(np.argmax(room))])


def lost(axes: Axes, motion: Motion) -> None:
    """Shades the phases without contact, and hatches contact on the back side."""
    for first, last, region in stretches(motion):
        left, right = float(motion.phase[first]), float(motion.phase[min(last, len(motion.phase)) - 1])
        if region == 1:
            axes.axvspan(left, right, facecolor=style.FREE_SHADE, edgecolor="none", zorder=0.1)
        elif region == 2:
            axes.axvspan(
                left, right, facecolor="#d5efe6", edgecolor=style.GREEN, hatch="////", lw=0.0, zorder=0.1
            )


def _key(motions: Sequence[Motion]) -> list[Line2D | Patch]:
    regions = {int(r) for m in motions for r in np.unique(m.region)}
    handles: list[Line2D | Patch] = []
    if 1 in regions:
        handles.append(Patch(facecolor=style.FREE_SHADE, label="no contact"))
    if 2 in regions:
        handles.append(
            Patch(
                facecolor="#d5efe6", edgecolor=style.GREEN, hatch="////", lw=0.0, label="contact, back side"
            )
        )
    if any(m.hit_engaging.any() for m in motions):
        handles.append(Line2D([], [], ls="none", marker="o", ms=3.0, color=style.BOUNDARY, label="impact"))
    if any(m.touch for m in motions):
        handles.append(Line2D([], [], label="touch", **TOUCH))
    if any(map(_edges, motions)):
        handles.append(Line2D([], [], color=style.BOUNDARY, lw=0.9, label=r"boundaries $\pm D$"))
    return handles
