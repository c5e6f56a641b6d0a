"""Phase portraits (X, X') with the boundaries of the gap, contacts, and the touch of a grazing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from gearlash.results.contact_words import sided
from gearlash.studies.motion import Motion

from . import style
from .framing import Box, frame, zoom_frame
from .regimes import short
from .units import ASSUMED, VELOCITY, Units, X, literal, rests, second
from .words import ANY

# Colour, line style and width of a stretch: drive side, free, back side.
STRETCHES = {
    0: (style.BLUE, "-", 1.0, "contact, drive side"),
    1: (style.INK, (0, (3.5, 1.2)), 0.8, "no contact"),
    2: (style.GREEN, (0, (5, 1, 1, 1)), 1.0, "contact, back side"),
}
# A ring, so that the tangency inside it stays visible.
TOUCH: dict[str, Any] = {
    "ls": "none",
    "marker": "o",
    "ms": 8.0,
    "mfc": "none",
    "mec": style.PURPLE,
    "mew": 1.6,
}


@style.styled
def portrait(motion: Motion, units: Units | None = None, parameter: str = "omega", title: str = "") -> Figure:
    """The phase portrait of one motion, as wide as a column.

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
    >>> plots.portrait(gl.motion(found)).axes[0].get_title(loc="left")
    '1-0'
    """
    figure = style.figure(style.COLUMN, 84.0)
    axes = figure.subplots()
    draw(axes, motion)
    _limits(axes, frame([motion]))
    axes.set_title(literal(title) if title else heading(motion, parameter))
    axes.set(xlabel=X, ylabel=VELOCITY)
    length = (units or Units()).length
    second(axes, length)
    told = ASSUMED if rests(length) else None
    figure.legend(
        handles=key([motion], units), loc="outside lower center", ncols=2, title=told, title_fontsize=6.5
    )
    return figure


@style.styled
def triple(motions: Sequence[Motion], units: Units | None = None, parameter: str = "omega") -> Figure:
    """Phase portraits before, at and after an event, with the touched place enlarged below.

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
    >>> len(plots.portrait_triple([motion, motion, motion]).axes)
    6
    """
    figure = style.figure(style.PAGE, 132.0)
    whole, close = figure.subplots(2, len(motions), height_ratios=[1.15, 1.0], squeeze=False)
    full, zoom = frame(motions), zoom_frame(motions)
    for i, (above, below, motion) in enumerate(zip(whole, close, motions, strict=True)):
        draw(above, motion)
        draw(below, motion, names=False)
        _limits(above, full)
        _limits(below, zoom)
        above.set_title(f"({'abc'[i % 3]})  {heading(motion, parameter)}")
        _window(above, zoom)
        below.set_xlabel(X)
        second(above, (units or Units()).length)
        above.xaxis.set_major_locator(MaxNLocator(4))
        below.xaxis.set_major_locator(MaxNLocator(3))
        for panel in (above, below):
            if i == 0:
                panel.set_ylabel(VELOCITY)
            else:
                panel.tick_params(labelleft=False)
    figure.legend(handles=key(motions, units), loc="outside lower center", ncols=4, columnspacing=1.4)
    return figure


@style.styled
def gallery(
    motions: Sequence[Motion],
    units: Units | None = None,
    parameter: str = "omega",
    titles: Sequence[str] = (),
    physical: bool = False,
) -> Figure:
    """Phase portraits of coexisting motions under the same scales, three in a row.

    Parameters
    ----------
    motions : sequence of Motion
    units : Units, optional
        Second axes in physical units: `Units.of` a case.
    parameter : str
        Short name of the parameter whose value stands in the heading.
    titles : sequence of str
        In place of these headings.
    physical : bool
        Whether the axes are in the units of the case alone, where it has any; no † then says on what these
        rest.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash import plots
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> found = gl.attractor(family.system(), family.start())
    >>> len(plots.gallery([gl.motion(found), gl.motion(found)]).axes)
    2
    """
    units = units or Units()
    labels: tuple[str, ...] = (X, VELOCITY)
    length = units.length
    if physical and units.length is not None and units.velocity is not None:
        motions = [in_units(motion, units.length.factor, units.velocity.factor) for motion in motions]
        own = (replace(each, assumed=False) for each in (units.length, units.velocity))
        labels, length = tuple(each.label for each in own), None
    columns = min(3, len(motions))
    rows = -(-len(motions) // columns)
    figure = style.figure(style.PAGE if columns > 1 else style.COLUMN, 72.0 * rows + 12.0)
    panels = figure.subplots(rows, columns, squeeze=False).ravel()
    full = frame(motions)
    for i, panel in enumerate(panels):
        if i >= len(motions):
            panel.remove()
            continue
        draw(panel, motions[i])
        _limits(panel, full)
        own = literal(titles[i]) if titles else heading(motions[i], parameter)
        panel.set_title(f"({chr(97 + i)})  {own}")
        panel.set(xlabel=labels[0], ylabel=labels[1] if i % columns == 0 else "")
        second(panel, length)
    handles = key(motions, units, plain=physical)
    figure.legend(handles=handles, loc="outside lower center", ncols=4 if columns > 1 else 2)
    return figure


def in_units(motion: Motion, length: float, velocity: float) -> Motion:
    """The motion with what a portrait draws of it in the units of a case, which are these factors."""
    touch = motion.touch
    if touch is not None:
        touch = replace(
            touch, displacement=length * touch.displacement, velocity=velocity * touch.velocity
        )  # fmt: skip
    return replace(
        motion,
        displacement=length * motion.displacement,
        velocity=velocity * motion.velocity,
        hit_displacement=length * motion.hit_displacement,
        hit_velocity=velocity * motion.hit_velocity,
        strobe_displacement=length * motion.strobe_displacement,
        strobe_velocity=velocity * motion.strobe_velocity,
        gap_plus=length * motion.gap_plus,
        gap_minus=length * motion.gap_minus,
        touch=touch,
    )


def heading(motion: Motion, parameter: str) -> str:
    """Value and label: what a reader looks for first."""
    symbol = ANY.symbol(parameter)
    text = short(motion.label)
    return text if not np.isfinite(motion.value) else f"{symbol} = {motion.value:.6g}:  {text}"


def draw(axes: Axes, motion: Motion, names: bool = True, strobes: bool = True) -> None:
    """The motion into existing axes."""
    boundaries(axes, motion, names)
    thin = 1.0 if 0 < motion.period <= 4 else 0.7 if motion.periodic else 0.45
    for first, last, region in stretches(motion):
        colour, ls, width, _ = STRETCHES[region]
        part = slice(first, last)
        axes.plot(
            motion.displacement[part],
            motion.velocity[part],
            color=colour,
            ls=ls,
            lw=thin * width,
            rasterized=not motion.periodic,
        )
    small = thin * 3.2
    for side in (1, -1):
        for engaging in (True, False):
            chosen = (motion.hit_boundary == side) & (motion.hit_engaging == engaging)
            axes.plot(
                motion.hit_displacement[chosen],
                motion.hit_velocity[chosen],
                ls="none",
                marker="o",
                ms=small,
                zorder=4,
                mfc=style.BOUNDARY if engaging else "white",
                mec=style.BOUNDARY,
                mew=0.7 * min(1.0, 1.4 * thin),
            )
    if strobes:
        axes.plot(
            motion.strobe_displacement,
            motion.strobe_velocity,
            ls="none",
            marker="D",
            ms=thin * 2.9,
            zorder=5,
            mfc=style.YELLOW,
            mec=style.INK,
            mew=0.5 * thin,
        )
    if motion.touch:
        axes.plot(
            [motion.touch.displacement],
            [motion.touch.velocity],
            zorder=6,
            **TOUCH,
        )
    axes.xaxis.set_major_locator(MaxNLocator(5))
    axes.tick_params(which="both", right=True)


def boundaries(axes: Axes, motion: Motion, names: bool = True) -> None:
    """Σ1 and Σ2 as lines, the gap between them shaded; names at the top, inside."""
    axes.axvspan(-motion.gap_minus, motion.gap_plus, facecolor=style.FREE_SHADE, edgecolor="none", zorder=0.1)
    axes.axhline(0.0, color=style.PALE, lw=0.5, zorder=0.2)
    for place, text in ((motion.gap_plus, r"$\Sigma_1$"), (-motion.gap_minus, r"$\Sigma_2$")):
        axes.axvline(place, color=style.BOUNDARY, lw=0.8, zorder=0.3)
        if names:
            axes.annotate(
                text,
                (place, 1.0),
                (2.0, -3.0),
                xycoords=("data", "axes fraction"),
                textcoords="offset points",
                va="top",
                ha="left",
                color=style.BOUNDARY,
                fontsize=8,
                annotation_clip=True,
                clip_on=True,
            )


def stretches(motion: Motion) -> list[tuple[int, int, int]]:
    """Maximal stretches of one region: first index, index after the last (sharing its end with the next),
    region.
    """
    change = np.flatnonzero(np.diff(motion.region)) + 1
    starts = [0, *change.tolist()]
    stops = [*change.tolist(), len(motion.region) - 1]
    return [(a, b + 1, int(motion.region[a])) for a, b in zip(starts, stops, strict=True) if b + 1 > a]


def _limits(axes: Axes, box: Box) -> None:
    axes.set(xlim=box[:2], ylim=box[2:])


def _window(axes: Axes, box: Box) -> None:
    """The outline of the zoom in the whole portrait."""
    left, right, bottom, top = box
    axes.plot(
        [left, right, right, left, left],
        [bottom, bottom, top, top, bottom],
        color=style.GREY,
        lw=0.5,
        zorder=3.5,
    )


def key(motions: Sequence[Motion], units: Units | None = None, plain: bool = False) -> list[Line2D | Patch]:
    """Legend entries of what occurs in these motions; ``plain``: in words, without symbols."""
    teeth = units is None or units.teeth
    present = {int(r) for m in motions for r in np.unique(m.region)}
    handles: list[Line2D | Patch] = [
        Line2D([], [], color=c, ls=ls, lw=1.1, label=sided(words, teeth))
        for r, (c, ls, _, words) in STRETCHES.items()
        if r in present
    ]
    if any(len(m.hit_phase) for m in motions):
        marker: dict[str, Any] = {"ls": "none", "marker": "o", "ms": 3.6, "mec": style.BOUNDARY, "mew": 0.7}
        handles.append(Line2D([], [], mfc=style.BOUNDARY, label="impact (into contact)", **marker))
        handles.append(Line2D([], [], mfc="white", label="release (out of contact)", **marker))
    handles.append(
        Line2D(
            [],
            [],
            ls="none",
            marker="D",
            ms=3.2,
            mfc=style.YELLOW,
            mec=style.INK,
            mew=0.5,
            label="once per mesh cycle" if plain else r"on $\sigma_t$",
        )
    )
    if any(m.touch for m in motions):
        handles.append(Line2D([], [], label="touch: $X_n'=0$", **TOUCH))
    left, right, _, _ = frame(motions)
    if any(left < m.gap_plus and -m.gap_minus < right for m in motions):
        gap = "backlash" if plain else r"gap,  $-D \leq X_n \leq D$"
        handles.append(Patch(facecolor=style.FREE_SHADE, label=gap))
    return handles
