"""The three Poincaré sections of several motions, side by side."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from gearlash.studies.motion import Motion

from . import style
from .portraits import heading
from .units import VELOCITY, ForceAxis

# One look a motion: colour and marker, so that two are told apart in grey too.
POINT_STYLES = (
    (style.BLUE, "o"),
    (style.VERMILION, "^"),
    (style.GREEN, "s"),
    (style.PURPLE, "D"),
    (style.INK, "v"),
)
IN_CYCLE = r"phase in the cycle  $\theta/2\pi$"


@style.styled
def sections(motions: Sequence[Motion], parameter: str = "omega", force: ForceAxis | None = None) -> Figure:
    """The three Poincaré sections of one or several motions, side by side.

    σ_t in (X, X′); the contact force at every crossing of Σ1 (σ_d) and of Σ2 (σ_b) over its phase in the mesh
    cycle, filled where contact begins, hollow where it ends.

    Parameters
    ----------
    motions : sequence of Motion
    parameter : str
        Short name of the parameter whose value stands in the heading.
    force : ForceAxis, optional
        Symbol and sign of the contact force; Φ where nothing is given.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> import gearlash as gl
    >>> from gearlash import plots
    >>> family, _ = gl.load_case("kahraman-singh").family()
    >>> found = gl.attractor(family.system(), family.start())
    >>> len(plots.sections([gl.motion(found)]).axes)
    2
    """
    force = force or ForceAxis()
    back = any((m.hit_boundary < 0).any() for m in motions)
    figure = style.figure(style.PAGE if back else 132.0, 70.0)
    panels: list[Axes] = list(figure.subplots(1, 3 if back else 2, squeeze=False)[0])
    titles = (
        "(a)  $\\sigma_t$: once a cycle",
        "(b)  $\\sigma_d$: crossings of $\\Sigma_1$",
        "(c)  $\\sigma_b$: crossings of $\\Sigma_2$",
    )
    for panel, title in zip(panels, titles, strict=False):
        panel.set_title(title)
        panel.tick_params(which="both", top=True, right=True)
    for i, motion in enumerate(motions):
        look = POINT_STYLES[i % len(POINT_STYLES)]
        _points(panels[0], motion.strobe_displacement, motion.strobe_velocity, look, True, motion.periodic)
        for panel, side in zip(panels[1:], (1, -1), strict=False):
            for engaging in (True, False):
                chosen = (motion.hit_boundary == side) & (motion.hit_engaging == engaging)
                at_hits = force.sign * np.interp(motion.hit_phase[chosen], motion.phase, motion.force)
                _points(panel, motion.hit_phase[chosen] % 1.0, at_hits, look, engaging, motion.periodic)
    panels[0].set(xlabel=r"$X_n$  on  $\sigma_t$", ylabel=VELOCITY)
    panels[0].xaxis.set_major_locator(MaxNLocator(5))
    for panel, symbol in zip(panels[1:], ("d", "b"), strict=False):
        panel.xaxis.set_major_locator(MaxNLocator(6))
        panel.axhline(0.0, color=style.GREY, lw=0.5, zorder=0.5)
        panel.set(xlabel=IN_CYCLE, xlim=(-0.02, 1.02), ylabel=f"{force.symbol}  on  $\\sigma_{symbol}$")
    figure.legend(handles=_key(motions, parameter), loc="outside lower center", ncols=3)
    return figure


def _points(
    axes: Axes,
    x: NDArray[np.float64],
    y: NDArray[np.float64],
    look: tuple[str, str],
    filled: bool,
    periodic: bool,
) -> None:
    colour, marker = look
    axes.plot(
        x,
        y,
        ls="none",
        marker=marker,
        ms=4.2 if periodic else 2.4,
        mec=colour,
        mew=0.8,
        mfc=colour if filled else "none",
        rasterized=not periodic,
        zorder=3,
    )


def _key(motions: Sequence[Motion], parameter: str) -> list[Line2D]:
    handles = [
        Line2D([], [], ls="none", marker=m, color=c, ms=4.2, label=heading(motion, parameter))
        for (c, m), motion in zip(POINT_STYLES, motions, strict=False)
    ]
    if any(len(m.hit_phase) for m in motions):
        for filled, words in ((True, "impact (into contact)"), (False, "release (out of contact)")):
            face = style.GREY if filled else "none"
            handles.append(
                Line2D([], [], ls="none", marker="o", ms=4.2, mec=style.GREY, mfc=face, label=words)
            )
    return handles
