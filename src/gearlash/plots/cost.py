"""Cost of a period against the size of the problem, one panel a size."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullFormatter

from gearlash.bench import Curve

from . import style

LOGARITHMIC = ("states", "speed ω")
PANEL = 46.0  # mm, height


@style.styled
def cost(curves: Sequence[Curve]) -> Figure:
    """Microseconds per period (filled) and, to build the propagators, milliseconds (open). Curves without
    points are left out."""
    drawn = [curve for curve in curves if curve.sizes]
    rows = len(drawn) // 2 + 1  # one place more than curves at the least, for the key
    made = style.figure(style.PAGE, PANEL * rows)
    panels = made.subplots(rows, 2, squeeze=False).ravel()
    for axes, curve in zip(panels, drawn, strict=False):
        _panel(axes, curve)
    for axes in panels[len(drawn) :]:
        axes.set_axis_off()
    panels[-1].legend(*panels[0].get_legend_handles_labels(), loc="center")
    return made


def _panel(axes: Axes, curve: Curve) -> None:
    sizes = np.array(curve.sizes)
    axes.plot(sizes, 1e6 * np.array(curve.seconds), "o-", color=style.BLUE, ms=3.5, label="a period, µs")
    axes.plot(
        sizes, 1e3 * np.array(curve.building), "s--", color=style.GREY, mfc="white", ms=3.5,
        label="building the propagators, ms",
    )  # fmt: skip
    axes.set_xlabel(curve.axis)
    axes.set_ylabel("µs, ms")
    if curve.axis in LOGARITHMIC:
        axes.set_xscale("log")
        axes.set_yscale("log")
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
            axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            axis.set_minor_formatter(NullFormatter())
    else:
        axes.set_ylim(bottom=0.0)
    if curve.axis == "clearances":
        axes.xaxis.set_major_locator(FixedLocator(list(sizes)))
