"""Order spectra of the contact force: real teeth beside the lumped model."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from . import style

Reals = NDArray[np.float64]
HIGHEST = 8.0
"""Order that is drawn."""
TOP, FLOOR = 10.0, -80.0  # dB
ROW, ENDS = 34.0, 22.0  # mm: height of a row of panels, and of what stands above and below them
ASIDE = 0.06  # orders between the lines of both models


@dataclass(frozen=True, eq=False)
class OrderPanel:
    """One operating point.

    Parameters
    ----------
    title : str
    order, amplitude : ndarray, shape (n,)
        Orders of the mesh frequency, and amplitudes of the force over its mean, of the multibody model.
    lumped_order, lumped_amplitude : ndarray, shape (m,)
        Of the lumped model at the same inputs; empty for a motion without a period.

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash import plots
    >>> orders = np.arange(1.0, 4.0)
    >>> plots.OrderPanel("3600 rpm", orders, 0.1**orders, orders, 0.2**orders).title
    '3600 rpm'
    """

    title: str
    order: Reals
    amplitude: Reals
    lumped_order: Reals
    lumped_amplitude: Reals


@style.styled
def orders_beside(rows: Sequence[Sequence[OrderPanel]]) -> Figure:
    """Levels of the contact force over orders of the mesh frequency; 0 dB is the mean force.

    Parameters
    ----------
    rows : sequence of sequence of OrderPanel
        Each row of the same length.

    Returns
    -------
    matplotlib.figure.Figure
        As wide as a page. Lines of the multibody model stand left of their order, those of the lumped model
        right of it; none is drawn below -80 dB.

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash import plots
    >>> orders = np.arange(1.0, 4.0)
    >>> panel = plots.OrderPanel("3600 rpm", orders, 0.1**orders, orders, 0.2**orders)
    >>> len(plots.orders_beside([[panel, panel]]).axes)
    2
    """
    columns = len(rows[0])
    figure = style.figure(style.PAGE, ROW * len(rows) + ENDS)
    grid = figure.subplots(len(rows), columns, squeeze=False, sharex=True, sharey=True)
    for axes_row, panels in zip(grid, rows, strict=True):
        for axes, panel in zip(axes_row, panels, strict=True):
            _lines(axes, panel.order - ASIDE, panel.amplitude, style.INK, "o", "real teeth")
            words = "lumped model, same inputs"
            _lines(
                axes, panel.lumped_order + ASIDE, panel.lumped_amplitude, style.VERMILION, "s", words, ls="--"
            )
            axes.grid(axis="y", color=style.PALE, lw=0.4)
            axes.set_title(panel.title)
        axes_row[0].set_ylabel("force, dB re its mean")
    grid[0][0].set_xlim(0.0, HIGHEST + 0.5)
    grid[0][0].set_ylim(FLOOR, TOP)
    for axes in grid[-1]:
        axes.set_xlabel("order of the mesh frequency")
    handles, labels = grid[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=2)
    return figure


def _lines(
    axes: Axes, order: Reals, amplitude: Reals, colour: str, marker: str, words: str, ls: str = "-"
) -> None:
    """A stem for every line above the floor."""
    shown = (amplitude > 10.0 ** (FLOOR / 20.0)) & (order < HIGHEST + 0.4)
    level = 20.0 * np.log10(amplitude[shown])
    axes.vlines(order[shown], FLOOR, level, color=colour, lw=0.8, ls=ls)
    axes.plot(order[shown], level, ls="none", marker=marker, ms=2.4, color=colour, label=words)
