"""Cost of a period against the size of the problem, one panel a size."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullFormatter

from gearlash.plots import style

from .results import Curve

LOGARITHMIC = ("states", "speed ω")
PANEL = 46.0  # mm, height


@style.styled
def cost(curves: Sequence[Curve]) -> Figure:
    """Microseconds per period (left; filled where there are impacts) and milliseconds to build the
    propagators (right). Curves without points are left out."""
    drawn = [curve for curve in curves if curve.sizes]
    rows = len(drawn) // 2 + 1  # one place more than curves at the least, for the key
    made = style.figure(style.PAGE, PANEL * rows)
    panels = made.subplots(rows, 2, squeeze=False).ravel()
    for axes, curve in zip(panels, drawn, strict=False):
        _panel(axes, curve)
    for axes in panels[len(drawn) :]:
        axes.set_axis_off()
    panels[-1].legend(handles=_key(), loc="center")
    return made


def _panel(axes: Axes, curve: Curve) -> None:
    sizes, crossed = np.array(curve.sizes), np.array(curve.crossings) > 0.0
    period, building = 1e6 * np.array(curve.seconds), 1e3 * np.array(curve.building)
    right = axes.twinx()
    axes.plot(sizes, period, "-", color=style.BLUE)
    axes.plot(sizes[crossed], period[crossed], "o", color=style.BLUE, ms=4)
    axes.plot(sizes[~crossed], period[~crossed], "o", color=style.BLUE, mfc="white", ms=4)
    right.plot(sizes, building, "s--", color=style.GREY, mfc="white", ms=3.5)
    axes.set_xlabel(curve.axis)
    axes.set_ylabel("a period, µs", color=style.BLUE)
    right.set_ylabel("building, ms", color=style.GREY)
    for each, values in ((axes, period), (right, building)):
        if curve.axis in LOGARITHMIC:
            each.set_xscale("log")
            each.set_yscale("log")
            for axis in (each.xaxis, each.yaxis):
                axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
                axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
                axis.set_minor_formatter(NullFormatter())
        else:
            each.set_ylim(0.0, 1.1 * values.max())
    if curve.axis == "clearances":
        axes.xaxis.set_major_locator(FixedLocator(list(sizes)))


def _key() -> list[Line2D]:
    blue, grey = (
        {"color": style.BLUE, "marker": "o", "ms": 4},
        {"color": style.GREY, "marker": "s", "ms": 3.5},
    )
    return [
        Line2D([], [], label="a period with impacts (left)", **blue),
        Line2D([], [], label="a period without (left)", mfc="white", **blue),
        Line2D([], [], label="building the propagators (right)", ls="--", mfc="white", **grey),
        Line2D([], [], label="states, speed: logarithmic", ls=""),
    ]
