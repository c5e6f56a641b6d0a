"""Lines of contact on a tooth of the pinion, and the load along them."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from gearlash.multibody.contact import MeshContact
from gearlash.multibody.flanks import Flanks
from gearlash.multibody.quasi_static import QuasiStatic

from . import style

Reals = NDArray[np.float64]

ROWS = 160  # of the map, from root to tip
HAIRS = 7.0  # mm of the picture for the greatest load along a line
HIGH = 66.0  # mm
UNIT = "N/mm"


@dataclass(frozen=True, eq=False)
class ToothLoads:
    """Loads on the teeth over a mesh cycle.

    Parameters
    ----------
    flanks : Flanks
    slices : ndarray, shape (slices,)
        z of their middles, m.
    phase : ndarray, shape (n,)
        Of the mesh, from 0 to below 1.
    rolls, loads : ndarray, shape (n, pairs, slices)
        Roll lengths of the pinion at the places, m, and forces on them, N.
    """

    flanks: Flanks
    slices: Reals
    phase: Reals
    rolls: Reals
    loads: Reals

    @classmethod
    def of(cls, contact: MeshContact, found: QuasiStatic) -> ToothLoads:
        """Of a contact and what `gearlash.multibody.quasi_static` found of it."""
        return cls(contact.flanks, contact.tables.slices, found.phase, found.rolls, found.loads)


@style.styled
def tooth_contact(found: ToothLoads) -> Figure:
    """Load on a tooth of the pinion: the greatest one in a mesh cycle, and the lines of contact at one time.

    Parameters
    ----------
    found : ToothLoads

    Returns
    -------
    matplotlib.figure.Figure
        As wide as a page: a map of the flank, face width across and diameter upwards; beside it the lines of
        all pairs at the phase of the greatest load, put on one tooth, with the load as hairs.
    """
    figure = style.figure(style.PAGE, HIGH)
    left, right = figure.subplots(1, 2, sharex=True, sharey=True)
    right.tick_params(labelleft=True)
    line_loads = found.loads / _length(found) * 1e-3
    image = _greatest(found, line_loads)
    heights, z = _diameters(found, image[0]) * 1e3, found.slices * 1e3
    shown = left.pcolormesh(z, heights, image[1], cmap="Greys", vmin=0.0, shading="nearest", rasterized=True)
    bar = figure.colorbar(shown, ax=left, location="bottom", aspect=40, pad=0.03)
    bar.set_label(f"greatest load, {UNIT}")
    bar.outline.set_linewidth(0.6)  # pyright: ignore[reportCallIssue, reportAttributeAccessIssue]
    left.set_title("(a)  greatest load along the line in a cycle")
    at, most = int(line_loads.max(axis=(1, 2)).argmax()), float(line_loads.max())
    _lines(right, found, line_loads, at)
    right.set_title(f"(b)  lines at phase {found.phase[at]:.2f}; longest hair {most:.3g} {UNIT}")
    half = 0.5e3 * found.flanks.pair.face_width
    for axes in (left, right):
        axes.set_xlim(-half, half)
        axes.set_ylim(heights[0], heights[-1])
        axes.set_xlabel("across the face, mm")
        axes.set_facecolor("white")
    left.set_ylabel("diameter of the pinion, mm")
    return figure


def _length(found: ToothLoads) -> float:
    """Of the line of contact in a slice, m."""
    pair = found.flanks.pair
    return pair.face_width / len(found.slices) / cos(found.flanks.base_helix)


def _lowest(found: ToothLoads) -> float:
    """Roll length where contact starts, m: on the path, or before it under a tip corner of the gear."""
    pressed = found.rolls[found.loads > 0.0]
    return float(min(pressed.min(), found.flanks.pair.path_of_contact[0]))


def _diameters(found: ToothLoads, rolls: Reals) -> Reals:
    return 2.0 * np.hypot(rolls, found.flanks.base_radii[0])


def _greatest(found: ToothLoads, line_loads: Reals) -> tuple[Reals, Reals]:
    """Roll lengths from where contact may start to the tip, and the load there of every slice: each place of
    the flank is passed once in the time that a pair is in contact."""
    rolls = np.linspace(_lowest(found), found.flanks.tip_rolls[0], ROWS)
    image = np.empty((ROWS, line_loads.shape[2]))
    for k in range(line_loads.shape[2]):
        at = found.rolls[:, :, k].ravel()
        order = np.argsort(at)
        image[:, k] = np.interp(rolls, at[order], line_loads[:, :, k].ravel()[order])
    return rolls, image


def _lines(axes: Axes, found: ToothLoads, line_loads: Reals, at: int) -> None:
    """Every line of contact on the flank, with the load upwards from it."""
    z, most = found.slices * 1e3, line_loads.max()
    low = _lowest(found)
    span = np.ptp(_diameters(found, np.array([low, found.flanks.tip_rolls[0]]))) * 1e3
    unit = span * HAIRS / HIGH / most
    for rolls, loads in zip(found.rolls[at], line_loads[at], strict=True):
        on = (rolls >= low) & (rolls <= found.flanks.tip_rolls[0])
        if not on.any():
            continue
        places = _diameters(found, rolls[on]) * 1e3
        tops = places + unit * loads[on]
        axes.fill_between(z[on], places, tops, color=style.SKY, alpha=0.5, lw=0.0)
        axes.vlines(z[on], places, tops, color=style.BLUE, lw=0.5)
        axes.plot(z[on], places, color=style.INK, lw=1.0)
