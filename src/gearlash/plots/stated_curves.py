"""Stiffness and error as a case states them: points over their period, and the series that stands there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from gearlash.case import Case
from gearlash.case.kinds.gears.curves import LOADED
from gearlash.case.kinds.gears.kind import GearContent
from gearlash.system import Fourier, evaluate

from .style import BLUE, GREY, INK, PAGE, figure, styled
from .units import literal

TALL = 46.0  # mm of a panel
FINE = 16  # samples of the shortest wave
FEW = 80  # points that are dots
LEFT = "left of stated points"
TAKEN_OFF = (
    "The error was stated under load: what stiffness and flanks make of it there, and the mean, are "
    "taken off."
)


@dataclass(frozen=True, eq=False)
class StatedCurve:
    """One curve over its period.

    Parameters
    ----------
    label : str
        Of its axis.
    over : str
        The period in words, such as ``mesh cycle``.
    phases, values : ndarray, shape (n,)
        Stated points, from 0 to 1 of the period; empty where harmonics are stated.
    series : ndarray
        ``[mean, c1, s1, …]`` over the period.
    error : str
        How far the series is from the points, in words.
    points : str
        What the points are.

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash import plots
    >>> none = np.empty(0)
    >>> plots.StatedCurve("stiffness", "mesh cycle", none, none, np.array([1.0, 0.1, 0.0])).over
    'mesh cycle'
    """

    label: str
    over: str
    phases: NDArray[np.float64]
    values: NDArray[np.float64]
    series: Fourier
    error: str = ""
    points: str = "stated points"


def curves_of(case: Case) -> list[StatedCurve]:
    """Of ``[curves.stiffness]`` and ``[curves.error]`` of a case, as its model takes them, in N/µm and µm
    where the case has units."""
    content = case.content
    if not isinstance(content, GearContent):
        return []
    mean = case.entries.get("mesh.mean_stiffness")
    made = []
    for name, curve in content.pair.reconstructed.items():
        if name == "stiffness":
            factor, unit = (mean.number / 1e6, "N/µm") if mean is not None else (1.0, "over its mean")
        else:
            length = case.scales.length
            factor, unit = (1e6 * length, "µm") if length else (1.0, "over D_c")
        part = 100.0 * curve.rms_error / curve.peak_to_peak if curve.peak_to_peak else 0.0
        told = f"{part:.2g} % of peak to peak (rms) from the points" if len(curve.phases) else ""
        words = {"stiffness": "mesh stiffness", "error": "unloaded error"}[name]
        drawn = StatedCurve(
            f"{words}  [{unit}]", f"part of a {curve.over}", curve.phases, factor * curve.values,
            factor * curve.series, told,
        )  # fmt: skip
        loaded = name == "error" and content.pair.curves[name].get("state") == LOADED
        made.append(_left(drawn) if loaded else drawn)
    return made


def _left(curve: StatedCurve) -> StatedCurve:
    """What is left of a loaded error, about its mean: that is the deflection under the mean load, which the
    model has of the load itself."""
    series = curve.series.copy()
    mean, series[0] = float(series[0]), 0.0
    return replace(curve, values=curve.values - mean, series=series, points=LEFT)


def notice(curves: Sequence[StatedCurve]) -> str:
    """What a reader must know of the curves beside what they are; empty where that is all."""
    return TAKEN_OFF if any(curve.points == LEFT for curve in curves) else ""


@styled
def stated_curves(curves: Sequence[StatedCurve], title: str = "") -> Figure:
    """Every curve in a panel of its own.

    Parameters
    ----------
    curves : sequence of StatedCurve
        At least one.
    title : str

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> import numpy as np
    >>> from gearlash import plots
    >>> points = np.array([0.0, 0.5]), np.array([1.1, 0.9])
    >>> curve = plots.StatedCurve("stiffness", "mesh cycle", *points, np.array([1.0, 0.08, 0.0]))
    >>> len(plots.stated_curves([curve]).axes)
    1
    """
    made = figure(PAGE, TALL * len(curves) + 8.0)
    for panel, curve in zip(made.subplots(len(curves), 1, squeeze=False)[:, 0], curves, strict=True):
        count = (len(curve.series) - 1) // 2
        at = np.linspace(0.0, 1.0, max(400, FINE * count) + 1)
        if len(curve.phases):
            dots = "o" if len(curve.phases) <= FEW else "."
            look = {"ls": "none", "marker": dots, "ms": 3.4 if dots == "o" else 2.0, "mew": 0.7}
            ends = np.append(curve.phases, 1.0), np.append(curve.values, curve.values[0])
            panel.plot(*ends, color=GREY, lw=0.7, ls=(0, (1, 1.2)), label="joined by straight lines")
            panel.plot(curve.phases, curve.values, color=INK, mfc="white", label=curve.points, **look)
        words = f"{count} harmonics" + (f": {curve.error}" if curve.error else "")
        panel.plot(at, evaluate(curve.series, 2.0 * np.pi * at), color=BLUE, lw=1.1, label=words)
        panel.set(xlim=(0.0, 1.0), xlabel=literal(curve.over), ylabel=literal(curve.label))
        panel.margins(y=0.12)
        panel.legend(loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=3, frameon=False, borderaxespad=0.1)
    told = "\n".join(filter(None, [title, notice(curves)]))
    if told:
        made.suptitle(literal(told), x=0.01, ha="left", fontsize=8.0)
    return made
