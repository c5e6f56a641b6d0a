"""What is measured over speed: panels one below the other, with bands, the present speed and resonances."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from . import style
from .legends import legend_below
from .marks import Mark, height, texts
from .units import Twin, literal

Array = NDArray[np.float64]

PANEL = 33.0  # mm of a panel
LOW_PANEL = 27.0  # of three or more
WIDTH = 150.0  # mm of the panels, beside the labels
LEAST_ABOVE = 6.0  # mm above the panels, where there is no resonance
SEPARATING = {"facecolor": "#f6c9ae", "edgecolor": "#f6c9ae", "lw": 0.6}
BESIDE = {"facecolor": "white", "edgecolor": "#d98a5b", "hatch": "....", "lw": 0.5}
NOT_TOLD = {"facecolor": "#ededeb", "edgecolor": "#8f8f8f", "hatch": "\\\\\\", "lw": 0.5}
"""Three looks, told apart without colour: plain, dotted on white, hatched on grey. Edges are lines, so that
the narrowest is seen."""
LOOKS = (
    (style.BLUE, "o"),
    (style.VERMILION, "s"),
    (style.GREEN, "^"),
    (style.PURPLE, "D"),
)
NOMINAL = {"color": style.INK, "lw": 1.1, "ls": (0, (5, 2))}
RESONANCE = {"color": style.GREY, "lw": 0.6, "ls": (0, (1, 1.5))}
LEGEND_BELOW = 10.0  # mm: what the figure is made for
LEGEND = 0.24  # of the height of a panel: room above the curves
FEW = 90  # values up to which each is a dot


@dataclass(frozen=True, eq=False)
class Curve:
    """One quantity over speed, from sweeps upwards and downwards.

    Parameters
    ----------
    words : str
        In the legend.
    up, down : ndarray of shape (m,)
        NaN where there is no motion; of ``down`` only what differs from ``up`` is drawn.
    """

    words: str
    up: Array
    down: Array


@dataclass(frozen=True, eq=False)
class Stack:
    """One panel: curves of one unit.

    Parameters
    ----------
    label : str
        Of its axis.
    curves : tuple of Curve
    second : (float, str), optional
        A second axis on the right: what values are divided by, and its label.
    """

    label: str
    curves: tuple[Curve, ...]
    second: tuple[float, str] | None = None


@dataclass(frozen=True, eq=False)
class SpeedAxis:
    """What all panels share.

    Parameters
    ----------
    values : ndarray of shape (m,)
    label : str
    apart : sequence of ndarray of bool, shape (m-1,)
        For up and down, the steps over which the motion changes to another one: no line goes over them.
    separating, back : tuple of (float, float)
        Bands in which teeth separate in every motion found, and in which the back side is met.
    present : float
    resonances : tuple of Mark
    beside : tuple of (float, float)
        Bands in which teeth separate in one motion and stay in contact in another.
    not_told : tuple of (float, float)
        Parts of which no motion tells whether teeth separate.
    """

    values: Array
    label: str
    apart: Sequence[NDArray[np.bool_]]
    separating: tuple[tuple[float, float], ...]
    back: tuple[tuple[float, float], ...]
    present: float
    resonances: tuple[Mark, ...] = ()
    beside: tuple[tuple[float, float], ...] = ()
    not_told: tuple[tuple[float, float], ...] = ()


@style.styled
def over_speed(axis: SpeedAxis, stacks: Sequence[Stack], title: str = "") -> Figure:
    """Panels of curves over speed.

    Parameters
    ----------
    axis : SpeedAxis
    stacks : sequence of Stack
    title : str

    Returns
    -------
    matplotlib.figure.Figure
    """
    above, each = max(height(axis.resonances), LEAST_ABOVE), PANEL if len(stacks) < 3 else LOW_PANEL
    figure = style.figure(style.PAGE, above + each * len(stacks) + 26.0)
    panels = list(
        figure.subplots(len(stacks) + 1, 1, sharex=True, height_ratios=[above, *[each] * len(stacks)])
    )
    band, *rest = panels
    band.set_xlim(float(axis.values[0]), float(axis.values[-1]))
    texts(band, axis.resonances, WIDTH)
    band.set_title(literal(title), pad=6.0)
    for panel, stack in zip(rest, stacks, strict=True):
        _shade(panel, axis)
        _curves(panel, axis, stack)
    rest[-1].set_xlabel(axis.label)
    style.align_labels(rest, 13.0)
    both = any(_differs(curve).any() for stack in stacks for curve in stack.curves)
    legend_below(figure, list(_key(axis, both)), None, columns=4, room=LEGEND_BELOW)
    return figure


def _shade(panel: Axes, axis: SpeedAxis) -> None:
    looks = (axis.separating, SEPARATING), (axis.beside, BESIDE), (axis.not_told, NOT_TOLD)
    for spans, look in looks:
        for low, high in spans:
            panel.axvspan(low, high, zorder=0.1, **look)
    for low, high in axis.back:
        panel.axvspan(low, high, facecolor="none", edgecolor=style.PURPLE, hatch="////", lw=0.0, zorder=0.2)
    for mark in axis.resonances:
        panel.axvline(mark.value, zorder=0.4, **RESONANCE)
    panel.axvline(axis.present, zorder=0.5, **NOMINAL)


def _curves(panel: Axes, axis: SpeedAxis, stack: Stack) -> None:
    handles = []
    for curve, (colour, marker) in zip(stack.curves, LOOKS, strict=False):
        down = np.where(_differs(curve), curve.down, np.nan)
        dots = {"ms": 2.6, "mew": 0.6} if len(axis.values) <= FEW else {"ms": 1.5, "mew": 0.4}
        for values, apart, look in (
            (curve.up, axis.apart[0], {"lw": 1.0, "mfc": colour}),
            (down, axis.apart[1], {"lw": 0.8, "ls": (0, (4, 1.5)), "mfc": "white"}),
        ):
            x, y = broken(axis.values, values, apart)
            panel.plot(x, y, color=colour, marker=marker, mec=colour, **dots, **look)
        handles.append(Line2D([], [], color=colour, marker=marker, ms=3.0, label=curve.words))
    panel.set_ylabel(stack.label)
    _limits(panel, np.concatenate([each for curve in stack.curves for each in (curve.up, curve.down)]))
    if stack.second is not None:
        unit, label = stack.second
        twin = Twin(unit, "", "")
        panel.tick_params(which="both", right=False)
        right = panel.secondary_yaxis("right", functions=(twin.back, twin))
        right.set_ylabel(label)
        right.yaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 2.5, 5, 10], min_n_ticks=4))
    panel.legend(handles=handles, loc="upper left", ncols=len(handles), fontsize=7.0, columnspacing=1.2,
                 facecolor="white", framealpha=0.8, frameon=True, edgecolor="none")  # fmt: skip


def _differs(curve: Curve) -> NDArray[np.bool_]:
    """Where the motion with speed going down is another one."""
    return ~np.isclose(curve.up, curve.down, rtol=1e-6, atol=0.0, equal_nan=True)


def _limits(panel: Axes, drawn: Array) -> None:
    """From zero where values lie near to it, with room for the legend above them."""
    panel.margins(y=0.04)
    low, high = panel.get_ylim()
    if 0.0 < low < 0.6 * high or (low < 0.0 and not np.nanmin(drawn, initial=np.inf) < 0.0):
        low = 0.0
    if not np.nanmax(np.abs(drawn), initial=0.0) > 0.0:  # nothing happens: no axis that magnifies that
        low, high = 0.0, 1.0
    wide = high - low or 1.0
    panel.set_ylim(low, low + (1.0 + LEGEND) * wide)
    panel.yaxis.set_major_locator(MaxNLocator(4, steps=[1, 2, 2.5, 5, 10]))


def broken(x: Array, y: Array, apart: NDArray[np.bool_]) -> tuple[Array, Array]:
    """Both with a gap in every step over which the motion changes to another one."""
    at = np.flatnonzero(apart) + 1
    return np.insert(x, at, np.nan), np.insert(y, at, np.nan)


def _key(axis: SpeedAxis, both: bool) -> Iterator[Line2D | Patch]:
    """What is there; ``both``: whether anywhere the motion depends on the way of speed."""
    up = "speed going up" if both else "speed going up, and down"
    yield Line2D([], [], color=style.INK, lw=1.0, marker="o", ms=2.6, label=up)
    if both:
        yield Line2D(
            [], [], color=style.INK, lw=0.8, ls=(0, (4, 1.5)), marker="o", ms=2.6, mfc="white",
            label="going down, where another motion",
        )  # fmt: skip
    yield Line2D([], [], label="present speed", **NOMINAL)
    if axis.separating:
        yield Patch(label="teeth separate in every motion found", **SEPARATING)
    if axis.beside:
        subject = "" if axis.separating else "teeth separate "
        yield Patch(label=f"{subject}in one motion, in another not", **BESIDE)
    if axis.not_told:
        yield Patch(label="not told whether teeth separate", **NOT_TOLD)
    if axis.back:
        yield Patch(facecolor="white", edgecolor=style.PURPLE, hatch="////", lw=0.0, label="back side met")
    if axis.resonances:
        yield Line2D([], [], label="mesh order meets a natural frequency", **RESONANCE)
