"""Contact force over time: real teeth beside the lumped model."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from . import style

Reals = NDArray[np.float64]
CYCLES = 2.0
ROW, ENDS = 34.0, 22.0  # mm: height of a row of panels, and of what stands above and below them


@dataclass(frozen=True, eq=False)
class ForcePanel:
    """One operating point, forces over the mean one.

    Parameters
    ----------
    title : str
    phase, force : ndarray, shape (n,)
        Of the multibody model; mesh cycles.
    lumped_phase, lumped_force : ndarray, shape (m,)
        Of the lumped model at the same inputs.

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash import plots
    >>> time = np.linspace(0.0, 2.0, 5)
    >>> plots.ForcePanel("3600 rpm", time, np.ones(5), time, np.ones(5)).title
    '3600 rpm'
    """

    title: str
    phase: Reals
    force: Reals
    lumped_phase: Reals
    lumped_force: Reals


@style.styled
def force_beside(rows: Sequence[Sequence[ForcePanel]]) -> Figure:
    """Contact forces over two mesh cycles, a row of panels for every way to hold the inputs.

    Parameters
    ----------
    rows : sequence of sequence of ForcePanel
        Each row of the same length.

    Returns
    -------
    matplotlib.figure.Figure
        As wide as a page. Both curves begin at phase zero of their own motion, and where neither model fixes
        the other's phase only their shapes compare.

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash import plots
    >>> t = np.linspace(0.0, 2.0, 81)
    >>> force = 1.0 + 0.5 * np.cos(2.0 * np.pi * t)
    >>> panel = plots.ForcePanel("3600 rpm", t, force, t, force)
    >>> len(plots.force_beside([[panel, panel]]).axes)
    2
    """
    columns = len(rows[0])
    figure = style.figure(style.PAGE, ROW * len(rows) + ENDS)
    grid = figure.subplots(len(rows), columns, squeeze=False, sharex=True)
    for axes_row, panels in zip(grid, rows, strict=True):
        for axes, panel in zip(axes_row, panels, strict=True):
            axes.axhline(0.0, color=style.PALE, linewidth=0.6)
            axes.plot(panel.phase, panel.force, color=style.INK, label="real teeth")
            phase, force = _repeated(panel.lumped_phase, panel.lumped_force)
            axes.plot(phase, force, color=style.VERMILION, linestyle="--", label="lumped model, same inputs")
            axes.set_title(panel.title)
            axes.set_xlim(0.0, CYCLES)
        axes_row[0].set_ylabel("force over its mean")
    for axes in grid[-1]:
        axes.set_xlabel("time, mesh cycles")
    handles, labels = grid[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=2)
    return figure


def _repeated(phase: Reals, force: Reals) -> tuple[Reals, Reals]:
    """A period put after itself until it fills the panel; a longer stretch as it is."""
    if not len(phase):
        return phase, force
    period = max(round(float(phase[-1] - phase[0])), 1)
    times = max(round(CYCLES / period), 1)
    return np.concatenate([phase + k * period for k in range(times)]), np.tile(force, times)
