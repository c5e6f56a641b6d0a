"""Zones as `gearlash zones` finds them: bands with their ends, over what the sweeps show."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle
from numpy.typing import NDArray

from gearlash.studies.zone import Zone, Zones
from gearlash.studies.zone_end import Quiet, ZoneEnd

from . import style
from .bifurcation import along, directions, dot_size, new_points, scatter
from .legends import legend_below
from .marks import OTHER_TICK, TICKS
from .regimes import DRIVE, FREE
from .strip import key, strip
from .swept import axis_name, swept
from .units import ASSUMED, Twin, Units, literal, rests, second
from .words import words

WIDTH = 140.0  # mm of the panels: what is left beside the labels
LEGEND = 15.0  # mm: height of it that the figure is made for
ROW = 6.0  # mm of a band
THICK = 0.62  # of a band, of its row
SOME = "/////"  # hatch, on white, of where only some attractors are quiet: a colour alone says every
BEHIND = 0.55  # of its colour is left of a zone behind points
PRESENT = (0, (5, 2))
QUIET_WORDS = {Quiet.IMPACT_FREE: "no impacts", Quiet.DRIVE_SIDE_ONLY: "back side not hit"}
FILLS = {Quiet.IMPACT_FREE: FREE.colour, Quiet.DRIVE_SIDE_ONLY: DRIVE.colour}
HALVED = "end found by halving"


@dataclass(frozen=True)
class _Band:
    """A row of bands: what holds in them, and for whom."""

    quiet: Quiet
    every: bool
    zones: tuple[Zone, ...]

    @property
    def title(self) -> str:
        return f"{QUIET_WORDS[self.quiet]}, {'every' if self.every else 'some'}"


@style.styled
def zone_bands(
    dataset: xr.Dataset,
    found: Sequence[Zones],
    title: str = "",
    present: float | None = None,
    units: Units | None = None,
    asked: Twin | None = None,
    apart: Sequence[NDArray[np.bool_]] = (),
) -> Figure:
    """Zones of one or several kinds, over the sweeps that they were found from.

    Parameters
    ----------
    dataset : xarray.Dataset
        Of `gearlash.sweep_dataset`, with complete sweeps.
    found : sequence of Zones
    title : str
        What the zones are of.
    present : float, optional
        The value of the case itself, for a line there.
    units : Units, optional
        Second axes in physical units: `Units.of` a case.
    asked : Twin, optional
        The scale that the parameter was asked for in: it takes the place of the dimensionless one.
    apart : sequence of ndarray of bool, shape (m-1,), optional
        Steps over which no line is drawn, as for `diagram`.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash import plots
    >>> case = gl.load_case("kahraman-singh")
    >>> found = gl.zones(case, gl.Axis.even("omega", 0.5, 0.55, 3), "impact-free")
    >>> len(plots.zone_bands(gl.sweep_dataset(case, found.sweeps), [found]).axes)
    3
    """
    axis = axis_name(dataset)
    asked = asked or (units or Units()).alone(axis)
    factor = 1.0 if asked is None else asked.factor
    rows = [replace(row, values=factor * row.values) for row in swept(dataset, apart)]
    bands = list(_bands(found, factor))
    heights = [ROW * len(bands), 4.6 * len(rows), 52.0]
    figure = style.figure(style.PAGE, sum(heights) + 46.0)
    panels: list[Axes] = list(figure.subplots(3, 1, sharex=True, height_ratios=heights))
    upper, bars, lower = panels
    upper.set_xlim(*sorted((float(rows[0].values[0]), float(rows[0].values[-1]))))
    marks = _draw(upper, bands)
    seen = strip(bars, rows, WIDTH)
    _shade(lower, bands)
    shown = new_points(rows)
    for way, keep in zip(rows, shown, strict=True):
        scatter(lower, way.direction, *way.points("strobes", keep), larger=dot_size(rows[0]))
        along(lower, way, "strobes", keep)
    lower.margins(y=0.08)
    lower.set_ylabel(r"$X_n$  on  $\sigma_t$")
    usual = (units or Units()).of_parameter(axis)
    twin = usual if asked is None else asked
    lower.set_xlabel(words(dataset, units).name(axis) if asked is None else asked.label)
    second(lower, twin if asked is None else None, below=9.5)
    second(lower, (units or Units()).length, "y")
    bars.tick_params(which="both", bottom=False, top=False)
    if title:
        upper.set_title(literal(f"{title} (every, some: of the attractors found)"), pad=6.0)
    here = list(_present(panels, None if present is None else factor * present))
    told = ASSUMED if rests(twin, (units or Units()).length) else None
    handles = [*directions(rows, shown), *key(seen), *_key(bands), *marks, *here]
    legend_below(figure, handles, told, columns=3, room=LEGEND)
    return figure


def _bands(found: Sequence[Zones], factor: float) -> Iterator[_Band]:
    """With values times ``factor``."""
    for zones in found:
        yield _Band(zones.quiet, True, tuple(_scaled(zone, factor) for zone in zones.zones))
        if zones.wider:
            yield _Band(zones.quiet, False, tuple(_scaled(zone, factor) for zone in zones.wider))


def _scaled(zone: Zone, factor: float) -> Zone:
    ends = (replace(end, value=factor * end.value) for end in (zone.lower, zone.upper))
    lower, upper = ends
    return replace(zone, lower=lower, upper=upper)


def _draw(axes: Axes, bands: Sequence[_Band]) -> list[Line2D]:
    """The bands, first on top, and their ends; returns the legend entries of the ends."""
    seen: dict[str, Line2D] = {}
    for row, band in enumerate(bands):
        bottom = len(bands) - 1 - row + (1.0 - THICK) / 2.0
        for zone in band.zones:
            low, high = zone.lower.value, zone.upper.value
            axes.add_patch(
                Rectangle(
                    (low, bottom),
                    high - low,
                    THICK,
                    edgecolor=style.INK,
                    linewidth=0.5,
                    **_look(band),
                )
            )
            for end in (zone.lower, zone.upper):
                if end.bounded:
                    _tick(axes, end, bottom + THICK / 2.0, seen)
        if not band.zones:
            axes.text(
                0.5, bottom + THICK / 2.0, "none found", transform=axes.get_yaxis_transform(), ha="center",
                va="center_baseline", color=style.GREY,
            )  # fmt: skip
    axes.set_ylim(0.0, len(bands))
    axes.set_yticks([len(bands) - 0.5 - i for i in range(len(bands))], [band.title for band in bands])
    axes.tick_params(which="both", length=0, labelbottom=False)
    return [seen[kind] for kind in sorted(seen, key=lambda kind: kind == HALVED)]


def _tick(axes: Axes, end: ZoneEnd, height: float, seen: dict[str, Line2D]) -> None:
    """The end of a band: solved for (filled), or found by halving (hollow)."""
    kind = end.kind if end.point is not None else HALVED
    marker = TICKS.get(kind, OTHER_TICK) if end.point is not None else "s"
    fill = style.INK if end.point is not None else "white"
    look = {"marker": marker, "ms": 4.0, "mew": 0.7, "color": style.INK, "mfc": fill}
    axes.plot([end.value], [height], ls="none", clip_on=False, zorder=5, **look)
    label = kind if kind == HALVED else f"{kind}, solved for"
    seen.setdefault(kind, Line2D([], [], ls="none", label=label, **look))


def _shade(axes: Axes, bands: Sequence[_Band]) -> None:
    """Behind the points: the zones of the first kind that has any, in two looks, and lines where zones
    end. Where every attractor is quiet some is, too: there the look of every one covers the other."""
    for band in _shaded(bands):
        look = {
            **_look(band),
            "edgecolor": style.GREY,
            "linewidth": 0.0,
            "zorder": 0.1 if band.every else 0.05,
        }
        look["facecolor"] = 1.0 - BEHIND * (1.0 - np.array(to_rgb(look["facecolor"])))
        for zone in band.zones:
            axes.axvspan(zone.lower.value, zone.upper.value, **look)
    for end in (e for band in bands for zone in band.zones for e in (zone.lower, zone.upper)):
        if end.bounded:
            axes.axvline(end.value, color=style.GREY, lw=0.5, zorder=0.5)


def _look(band: _Band) -> dict[str, Any]:
    """Filled where every attractor found is quiet; hatched on white where at least one is."""
    return {"facecolor": FILLS[band.quiet]} if band.every else {"facecolor": "white", "hatch": SOME}


def _shaded(bands: Sequence[_Band]) -> list[_Band]:
    """Those of the first kind that has any zone."""
    found = [band for band in bands if band.zones]
    return [band for band in found if band.quiet is found[0].quiet]


def _key(bands: Sequence[_Band]) -> Iterator[Patch]:
    for band in _shaded(bands):
        words = QUIET_WORDS[band.quiet]
        label = f"{words} in {'every' if band.every else 'at least one'} attractor found"
        yield Patch(**_look(band), edgecolor=style.INK, linewidth=0.4, label=label)


def _present(panels: Sequence[Axes], value: float | None) -> Iterator[Line2D]:
    """A line where the case itself is, if that is in the range."""
    if value is None:
        return
    low, high = panels[0].get_xlim()
    if not low <= value <= high:
        return
    look = {"color": style.VERMILION, "lw": 1.0, "ls": PRESENT}
    for panel in panels:
        panel.axvline(value, zorder=4, **look)
    yield Line2D([], [], label="present value", **look)
