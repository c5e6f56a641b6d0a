"""The picture of the README: the impact-free window of the article's pair, and a motion before, at and
after grazing.

`python -m gearlash.article.overview docs/images/overview.png` computes and writes it.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from gearlash.branches.continuation import SpecialPoint
from gearlash.case import Case, load
from gearlash.case.edges import shown_edge
from gearlash.orbits import Orbit, Settings, attractor
from gearlash.plots import portraits, style
from gearlash.plots.bifurcation import directions, scatter
from gearlash.plots.framing import frame
from gearlash.plots.regimes import FREE, short
from gearlash.plots.swept import Swept, differs, swept
from gearlash.plots.units import VELOCITY, Units, X, second
from gearlash.plots.words import GEARS
from gearlash.results import Axis, sweep_dataset
from gearlash.studies.first_grazing import first_grazing
from gearlash.studies.motion import Motion, motion, touching
from gearlash.studies.point import point
from gearlash.studies.sweep import sweeps
from gearlash.system import Family, GearlashError, Signature

SPAN = (0.90, 1.20)  # of ω around the window
POINTS = 451
INSIDE = 1.05  # ω in the middle of the window
PICTURED = 0.006  # relative distance of the portraits from the grazing
PANEL_WORDS = ("before: teeth stay in contact", "at: the motion touches Σ₁", "after: teeth part and hit")


@dataclass(frozen=True, eq=False)
class OverviewData:
    """What the picture shows: sweeps, both ends of the window, motions around the upper one."""

    dataset: xr.Dataset
    ends: tuple[float, float]
    motions: tuple[Motion, ...]


def compute(case: Case, points: int = POINTS) -> OverviewData:
    """Everything in the picture, computed."""
    family, _ = case.family()
    axis = Axis("omega", np.linspace(*SPAN, points))
    dataset = sweep_dataset(case, sweeps(case, axis, ("cold", "up", "down"), settings=Settings(budget=4_000)))
    lower, upper = ends(family)
    motions = (
        motion(_orbit(family, upper, 1.0 - PICTURED), value=upper.value * (1.0 - PICTURED)),
        touching(family, upper),
        motion(_orbit(family, upper, 1.0 + PICTURED), value=upper.value * (1.0 + PICTURED)),
    )
    return OverviewData(dataset, (lower.value, upper.value), motions)


def ends(family: Family) -> tuple[SpecialPoint, SpecialPoint]:
    """The grazings in which the window without impacts ends."""
    inside = point(family, {"omega": INSIDE}, name="omega")
    if not inside.impact_free:
        raise GearlashError(f"no motion without impacts at omega = {INSIDE}: there is no window to draw")
    _, lower = first_grazing(family, "omega", inside, "down")
    _, upper = first_grazing(family, "omega", inside, "up")
    if lower is None or upper is None:
        raise GearlashError(
            "the window without impacts has no grazing at both ends: there is nothing to draw"
        )
    return lower, upper


def _orbit(family: Family, point: SpecialPoint, factor: float) -> Orbit:
    system = family.system({**point.values, "omega": point.value * factor})
    found = attractor(system, point.point.state, trial=(point.point.state, point.period))
    if not isinstance(found, Orbit):
        raise GearlashError(f"no periodic motion beside the grazing: {found.message}")
    return found


@style.styled
def overview(data: OverviewData, units: Units) -> Figure:
    """The picture: the diagram above, three portraits below."""
    figure = style.figure(style.PAGE, 118.0)
    grid = figure.add_gridspec(2, 3, height_ratios=[1.0, 0.92])
    _diagram(figure.add_subplot(grid[0, :]), data, units)
    _portraits([figure.add_subplot(grid[1, i]) for i in range(3)], data.motions)
    return figure


def _diagram(axes: Axes, data: OverviewData, units: Units) -> None:
    rows = swept(data.dataset)
    low, high = data.ends
    axes.axvspan(low, high, facecolor=FREE.colour, alpha=0.55, edgecolor="none", zorder=0.1)
    for way in rows:
        keep = differs(way, rows[0]) if way is not rows[0] else np.ones(len(way.values), dtype=bool)
        scatter(axes, way.direction, *way.points("strobes", keep))
    axes.set_xlim(*SPAN)
    axes.margins(y=0.1)
    axes.set(xlabel=GEARS.name("omega"), ylabel=r"$X_n$  on  $\sigma_t$")
    second(axes, units.speed)
    for edge in data.ends:
        axes.axvline(edge, color=style.BOUNDARY, lw=0.9, zorder=0.5)
    _names(axes, rows, data.ends)
    axes.legend(handles=directions(rows), loc="upper left")
    speeds = ""
    if units.speed is not None:
        ends = zip(map(float, units.speed(data.ends)), (1, -1), strict=True)
        speeds = f"\n{' to '.join(shown_edge(end, inwards) for end, inwards in ends)} rpm"
    axes.text(
        (low + high) / 2,
        0.06,
        f"1-0: no impacts{speeds}",
        transform=axes.get_xaxis_transform(),
        ha="center",
        va="bottom",
    )
    for edge, side in ((low, "left"), (high, "right")):
        axes.annotate(
            f"grazing\nω = {edge:.4f}",
            (edge, 0.06),
            (-4 if side == "left" else 4, 0),
            ha="right" if side == "left" else "left",
            va="bottom",
            xycoords=axes.get_xaxis_transform(),
            textcoords="offset points",
            color=style.BOUNDARY,
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0, "alpha": 0.85},
        )


def _names(axes: Axes, rows: list[Swept], ends: tuple[float, float]) -> None:
    """Labels on the directions where they are long enough, and on what coexists with the motion without
    impacts.
    """
    low, high = ends
    for first, last, label in rows[0].runs():
        left, right = rows[0].values[first], rows[0].values[last - 1]
        middle = (max(left, high) + right) / 2 if right > high and left < high else (left + right) / 2
        if isinstance(label, Signature) and right - left > 0.03:
            top = float(np.nanmax(rows[0].strobes[int(np.argmin(np.abs(rows[0].values - middle)))]))
            axes.annotate(
                short(label), (middle, top), (0, 5), textcoords="offset points", ha="center", va="bottom"
            )
    inside = [
        (b.values[i], float(np.nanmin(b.strobes[i])), label)
        for b in rows
        for i, label in enumerate(b.labels)
        if low < b.values[i] < high and label != "1-0-0"
    ]
    if inside:
        value, bottom, label = min(inside, key=lambda one: one[:2])
        axes.annotate(
            f"{short(label)} coexists",
            (value, bottom),
            (-14, -6),
            textcoords="offset points",
            ha="right",
            va="center",
            arrowprops={"arrowstyle": "-", "lw": 0.5, "color": style.GREY},
        )


def _portraits(panels: list[Axes], motions: Sequence[Motion]) -> None:
    box = frame(motions)
    for panel, item, words in zip(panels, motions, PANEL_WORDS, strict=True):
        portraits.draw(panel, item)
        panel.set(xlim=box[:2], ylim=box[2:], xlabel=X)
        panel.set_title(f"{words}\nω = {item.value:.4f}   {short(item.label)}")
        panel.xaxis.set_major_locator(MaxNLocator(4))
    for panel in panels[1:]:
        panel.tick_params(labelleft=False)
    panels[0].set_ylabel(VELOCITY)


def main(arguments: Sequence[str]) -> int:
    """Writes the picture to the path given."""
    if len(arguments) != 1:
        print("usage: python -m gearlash.article.overview FILE.png", file=sys.stderr)
        return 2
    target = Path(arguments[0])
    target.parent.mkdir(parents=True, exist_ok=True)
    case = load("article")
    made = overview(compute(case), Units.of(case))
    width = 1600  # pixels
    target.write_bytes(style.to_bytes(made, "png", dpi=width / (style.PAGE * style.MM)))
    print(target)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
