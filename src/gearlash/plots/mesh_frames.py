"""Teeth in mesh at times of a motion, side by side like the frames of a film, with the play drawn larger."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, floor, pi

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from gearlash.gears import CylindricalGear
from gearlash.gears.outline import half_tooth
from gearlash.multibody.flanks import Flanks

from . import style

Reals = NDArray[np.float64]

TALL = 50.0  # mm
PITCHES = 1.15  # shown above and below the pitch point
SHOWN_PLAY = 0.12  # of the pitch, about: how wide the play is drawn
LEAST_ARROW = 0.01  # of the longest: shorter ones are not drawn
HEAD = 0.25  # of the longest arrow: shorter arrows have a smaller head
HEAD_SIZE = 10.0  # points
MM = 1e3


@style.styled
def mesh_frames(
    flanks: Flanks,
    poses: NDArray[np.float64],
    forces: NDArray[np.float64],
    phases: Sequence[float],
    motion: str = "",
) -> Figure:
    """Frames of a motion in the section at mid face.

    Parameters
    ----------
    flanks : Flanks
    poses : ndarray, shape (n, 12 or more)
        As of `MeshContact.forces`; from 2 to 8 of them.
    forces : ndarray, shape (n, 2)
        Sum of the normal forces on both sides of the teeth, N.
    phases : sequence of float
        Mesh cycles, which stand above each frame.
    motion : str
        Which motion this is, said below the frames.

    Returns
    -------
    matplotlib.figure.Figure
        The pinion left, the gear right; play and approach are drawn so many times larger as it says, and
        arrows, long as the forces, show the push on the gear; none where it is below 1 % of the longest.
    """
    figure = style.figure(style.PAGE, TALL)
    panels = figure.subplots(1, len(poses), squeeze=False)[0]
    times, most = magnified(flanks), float(np.max(forces, initial=0.0))
    for axes, pose, force, phase in zip(panels, poses, forces, phases, strict=True):
        _teeth(axes, flanks, pose, times)
        for side in range(2):
            if force[side] > LEAST_ARROW * most:
                _push(axes, flanks, side, float(force[side]) / most)
        _window(axes, flanks)
        axes.set_title(f"phase {round(phase, 2) + 0.0:.2f}", fontsize=7.0)  # no −0.00
    words = f"{motion}: " if motion else ""
    words += f"play drawn {times} times as wide"
    if most > 0.0:
        words += f"; longest arrow {most * 1e-3:.3g} kN"
    figure.supxlabel(words, fontsize=7.5)
    return figure


def magnified(flanks: Flanks) -> int:
    """How many times wider the play is drawn."""
    return max(1, round(SHOWN_PLAY * flanks.pitch / max(flanks.play, 1e-9)))


def drawn_turns(flanks: Flanks, pose: Reals, times: int) -> tuple[float, float]:
    """Turns of both gears as they are drawn, rad: the pinion as it is, the gear where the larger play has it.

    Flanks that are pressed into each other are drawn touching.
    """
    first, second = flanks.base_radii
    half = 0.5 * flanks.play / np.cos(flanks.base_helix)
    ahead = float(np.clip(first * pose[5] + second * pose[11], -half, half))
    return float(pose[5]), (times * ahead - first * float(pose[5])) / second


def _teeth(axes: Axes, flanks: Flanks, pose: Reals, times: int) -> None:
    pair = flanks.pair
    thinner = (times - 1) * flanks.play / np.cos(flanks.base_helix) / 4.0
    turns = drawn_turns(flanks, pose, times)
    beginnings = 0.0, pi + pi / pair.gear.teeth
    for which, (gear, begins, turn) in enumerate(zip(pair.gears, beginnings, turns, strict=True)):
        towards = which * pi
        x, y = _some_teeth(gear, begins + turn, towards, thinner / flanks.base_radii[which])
        x = x + which * pair.centre_distance
        colour = (style.BLUE, style.INK)[which]
        axes.fill(x * MM, y * MM, facecolor=colour, alpha=0.12, edgecolor="none")
        axes.plot(x[1:-1] * MM, y[1:-1] * MM, color=colour, lw=0.7)


def _some_teeth(gear: CylindricalGear, begins: float, towards: float, thinner: float) -> tuple[Reals, Reals]:
    """Outline of the teeth around a direction, closed behind them."""
    radius, angle = half_tooth(gear, thinner)
    step = 2.0 * pi / gear.teeth
    middle = (towards - begins) / step
    count = PITCHES + 1.5
    around, radii = [], []
    for tooth in range(floor(middle - count), ceil(middle + count) + 1):
        around.append(begins + step * tooth + np.append(-angle, angle[::-1]))
        radii.append(np.append(radius, radius[::-1]))
    inner = gear.root_diameter * 0.5 - 3.0 * gear.transverse_module
    turn = np.concatenate([[around[0][0]], *around, [around[-1][-1]]])
    reach = np.concatenate([[inner], *radii, [inner]])
    return reach * np.cos(turn), reach * np.sin(turn)


def _push(axes: Axes, flanks: Flanks, side: int, part: float) -> None:
    """The force on the gear, from the pitch point along the line of action of a side."""
    angle, sign = flanks.pair.working_pressure_angle, 1.0 - 2.0 * side
    pitch = 0.5 * flanks.pair.working_diameters[0] * MM
    along = part * 0.8 * flanks.pitch * MM * np.array([np.sin(angle), sign * np.cos(angle)])
    axes.annotate(
        "",
        (pitch + along[0], along[1]),
        (pitch, 0.0),
        arrowprops={
            "arrowstyle": "-|>",
            "mutation_scale": HEAD_SIZE * min(1.0, part / HEAD),
            "color": style.VERMILION,
            "lw": 1.2,
            "shrinkA": 0,
            "shrinkB": 0,
        },
        zorder=5,
    )


def _window(axes: Axes, flanks: Flanks) -> None:
    pitch = 0.5 * flanks.pair.working_diameters[0] * MM
    half = PITCHES * flanks.pitch * MM
    axes.set_xlim(pitch - 0.75 * half, pitch + 0.75 * half)
    axes.set_ylim(-half, half)
    axes.set_aspect("equal")
    axes.set_xticks([])
    axes.set_yticks([])
