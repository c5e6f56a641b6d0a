"""A gear pair as a drawing: both gears in mesh, teeth at the pitch point with true involutes, dimensions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import cos, degrees, pi, sin
from typing import TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from gearlash.gears import CylindricalGear, CylindricalPair, backlash, inspection
from gearlash.gears.outline import Reals, outline

from .style import BLUE, GREY, INK, PAGE, PALE, VERMILION, figure, styled
from .units import ASSUMED

TALL = 84.0  # mm
PITCHES = 2.1  # shown to either side of the pitch point
MM = 1e3
MARK = " †"
A_W = r"$a_{\mathrm{w}}$"


@styled
def mesh_drawing(
    pair: CylindricalPair,
    title: str = "",
    play: float | None = None,
    widths: tuple[float, float] | None = None,
    assumed: Sequence[str] = (),
) -> Figure:
    """The pair in its transverse section.

    Parameters
    ----------
    pair : CylindricalPair
        The pinion below.
    title : str
        What the figure is headed with.
    play : float, optional
        Whole normal backlash, m; that of the teeth where nothing is given. Teeth are drawn thinner by it,
        both gears alike.
    widths : (float, float), optional
        Face widths of pinion and gear, m; that of the pair for both where nothing is given.
    assumed : sequence of str
        Paths of values of a case that are assumed or rest on such, which are marked.

    Returns
    -------
    matplotlib.figure.Figure

    Examples
    --------
    >>> from gearlash import plots
    >>> from gearlash.gears import CylindricalGear, CylindricalPair
    >>> pair = CylindricalPair(CylindricalGear(25, 3e-3), CylindricalGear(57, 3e-3), face_width=0.04)
    >>> len(plots.mesh_drawing(pair, "drive").axes)
    3
    """
    made = figure(PAGE, TALL)
    whole, teeth, words = made.subplots(1, 3, width_ratios=[0.9, 1.75, 1.05])
    outlines = _in_mesh(pair, play)
    _whole(whole, pair, outlines)
    _teeth(teeth, pair, outlines)
    _words(words, pair, play, widths, assumed)
    if title:
        made.suptitle(title, x=0.01, ha="left", fontsize=8.0)
    return made


def _in_mesh(pair: CylindricalPair, play: float | None) -> list[tuple[Reals, Reals]]:
    """Both outlines, mm, the pinion's axis at the origin and the gear's above it, touching at the pitch
    point."""
    own = backlash.of_pair(pair)
    wanted = (
        own.circumferential
        if play is None
        else play * own.circumferential / own.normal
        if own.normal
        else 0.0
    )
    found = []
    for sign, gear, working in zip((1, -1), pair.gears, pair.working_diameters, strict=True):
        thinner = 0.5 * (wanted - own.circumferential) / working
        half = gear.transverse_thickness(working) / working - thinner
        x, y = outline(gear, sign * pi / 2 + half, thinner)
        found.append((x * MM, (y + (0.0 if sign > 0 else pair.centre_distance)) * MM))
    return found


def _whole(axes: Axes, pair: CylindricalPair, outlines: list[tuple[Reals, Reals]]) -> None:
    """Both gears and their centre distance."""
    centre = pair.centre_distance * MM
    for (x, y), colour in zip(outlines, (BLUE, INK), strict=True):
        axes.fill(x, y, facecolor=colour, alpha=0.12, edgecolor="none")
        axes.plot(x, y, color=colour, linewidth=0.4)
    for middle, working in zip((0.0, centre), pair.working_diameters, strict=True):
        axes.add_patch(_circle(middle, working * MM, GREY, (0, (6, 2, 1, 2))))
        axes.plot([0.0], [middle], marker="+", color=INK, markersize=5, markeredgewidth=0.6)
    axes.annotate(
        "", (0.0, centre), (0.0, 0.0), arrowprops={"arrowstyle": "<->", "linewidth": 0.6, "color": INK}
    )
    axes.text(0.0, 0.78 * centre, f"{A_W} {centre:.5g} ", fontsize=7.0, va="center", rotation=90, ha="right")
    _plain(axes)
    axes.set_title("in mesh, mm")


def _circle(middle: float, diameter: float, colour: str, style: object = "-", width: float = 0.5):
    from matplotlib.patches import Circle

    return Circle(
        (0.0, middle), 0.5 * diameter, fill=False, edgecolor=colour, linestyle=style, linewidth=width
    )


def _teeth(axes: Axes, pair: CylindricalPair, outlines: list[tuple[Reals, Reals]]) -> None:
    """The teeth around the pitch point, line of action and path of contact."""
    pitch = 0.5 * pair.working_diameters[0] * MM
    half = PITCHES * pi * pair.pinion.transverse_module * MM
    for (x, y), colour in zip(outlines, (BLUE, INK), strict=True):
        axes.fill(x, y, facecolor=colour, alpha=0.12, edgecolor="none")
        axes.plot(x, y, color=colour, linewidth=0.8)
    _circles(axes, pair, half)
    angle = pair.working_pressure_angle
    along = np.array([cos(angle), sin(angle)])  # the pinion turns clockwise and drives
    foot = -0.5 * pair.working_diameters[0] * sin(angle) * MM
    tangents = foot, pair.tangent_length * MM + foot
    axes.plot(*_line(tangents, along, pitch), color=VERMILION, linewidth=0.6, linestyle=(0, (4, 2)))
    ends = [place * MM + foot for place in pair.path_of_contact]
    axes.plot(*_line(ends, along, pitch), color=VERMILION, linewidth=1.6)
    for name, at in zip("AE", ends, strict=True):
        x, y = at * along
        axes.plot([x], [pitch + y], marker="o", color=VERMILION, markersize=3)
        axes.annotate(
            name, (x, pitch + y), (2, -8), textcoords="offset points", fontsize=7.5, color=VERMILION
        )
    axes.plot([0.0], [pitch], marker="o", markersize=3.5, markerfacecolor="white", color=INK)
    axes.annotate("C", (0.0, pitch), (4, 3), textcoords="offset points", fontsize=7.5)
    axes.set_xlim(-half, half)
    axes.set_ylim(pitch - 0.62 * half, pitch + 0.62 * half)
    _plain(axes)
    axes.set_title("teeth at the pitch point C, path of contact A to E")


def _line(places: object, along: Reals, pitch: float) -> tuple[Reals, Reals]:
    points = np.outer(np.asarray(places, dtype=float), along)
    return points[:, 0], points[:, 1] + pitch


def _circles(axes: Axes, pair: CylindricalPair, half: float) -> None:
    """Tip, working, base and root circles with their names at both ends of the panel."""
    for sign, gear, working in zip((1, -1), pair.gears, pair.working_diameters, strict=True):
        index = 1 if sign > 0 else 2
        circles = (
            (rf"$d_{{\mathrm{{a}}{index}}}$", gear.tip_diameter, PALE, "-"),
            (rf"$d_{{\mathrm{{w}}{index}}}$", working, GREY, (0, (6, 2, 1, 2))),
            (rf"$d_{{\mathrm{{b}}{index}}}$", gear.base_diameter, GREY, (0, (2, 2))),
            (rf"$d_{{\mathrm{{f}}{index}}}$", gear.root_diameter, PALE, "-"),
        )
        middle = 0.0 if sign > 0 else pair.centre_distance * MM
        for i, (name, diameter, colour, style) in enumerate(circles):
            axes.add_patch(_circle(middle, diameter * MM, colour, style))
            x = -sign * (0.93 - 0.11 * (i % 2)) * half  # base and root circles may nearly be one
            if abs(x) < 0.5 * diameter * MM:
                y = middle + sign * np.sqrt((0.5 * diameter * MM) ** 2 - x**2)
                if abs(y - 0.5 * pair.working_diameters[0] * MM) > 0.57 * half:
                    continue  # outside the panel
                axes.text(x, y, name, fontsize=6.0, color=GREY, ha="center", va="center", clip_on=True,
                          bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.4})  # fmt: skip


def _plain(axes: Axes) -> None:
    axes.set_aspect("equal")
    axes.set_xticks([])
    axes.set_yticks([])
    for spine in axes.spines.values():
        spine.set_visible(False)


def _words(
    axes: Axes,
    pair: CylindricalPair,
    play: float | None,
    widths: tuple[float, float] | None,
    assumed: Sequence[str],
) -> None:
    """The dimensions, of pinion and gear."""
    rows = [*_of_gears(pair, widths), ("", "", ""), *_of_pair(pair, play, widths)]
    marked = [_marked(row, assumed) for row in rows]
    if any(MARK in "".join(row) for row in marked):
        marked += [(ASSUMED, "", "")]
    step = 1.0 / len(marked)
    for i, row in enumerate(marked):
        y = 1.0 - (i + 0.5) * step
        for x, words, colour in zip((0.0, 0.31, 0.70), row, (GREY, INK, INK), strict=True):
            axes.text(x, y, words, fontsize=7.0, color=colour, va="center", transform=axes.transAxes)
    _plain(axes)
    axes.set_aspect("auto")


Row: TypeAlias = tuple[str, ...]
"""Name, value of the pinion and of the gear; then the paths of values that these are, with ``{}`` for either
gear."""


def _marked(row: Row, assumed: Sequence[str]) -> tuple[str, str, str]:
    """With a mark behind what rests on an assumed value."""
    name, *values = row[:3]
    found = [
        value + MARK * (value != "" and any(path.format(gear) in assumed for path in row[3:]))
        for value, gear in zip(values, ("pinion", "gear"), strict=True)
    ]
    return name, found[0], found[1]


def _of_gears(pair: CylindricalPair, widths: tuple[float, float] | None) -> list[Row]:
    first, second = pair.gears
    rows: list[Row] = [("", "pinion", "gear"), ("$z$", f"{first.teeth}", f"{second.teeth}")]

    def both(name: str, of: Callable[[CylindricalGear], float], path: str) -> None:
        rows.append((name, f"{of(first):.5g}", f"{of(second):.5g}", path))

    both("$x$", lambda g: round(g.profile_shift, 4), "{}.profile_shift")
    both("$d$, mm", lambda g: g.reference_diameter * MM, "derived.reference_diameter_{}")
    both(r"$d_{\mathrm{a}}$, mm", lambda g: g.tip_diameter * MM, "derived.tip_diameter_{}")
    both(r"$d_{\mathrm{f}}$, mm", lambda g: g.root_diameter * MM, "derived.root_diameter_{}")
    both(r"$d_{\mathrm{b}}$, mm", lambda g: g.base_diameter * MM, "derived.base_diameter_{}")
    working = [f"{d * MM:.5g}" for d in pair.working_diameters]
    rows.append((r"$d_{\mathrm{w}}$, mm", working[0], working[1], "derived.working_diameter_{}"))
    rows.append((r"$W_k$, mm", _span(first), _span(second), "derived.span_{}"))
    if all(gear.thickness_allowance == 0.0 for gear in (first, second)):
        rows.append(("", "nominal", "nominal"))
    if widths is not None and widths[0] != widths[1]:
        rows.append(("$b$, mm", f"{widths[0] * MM:.5g}", f"{widths[1] * MM:.5g}", "{}.face_width"))
    return rows


def _of_pair(pair: CylindricalPair, play: float | None, widths: tuple[float, float] | None) -> list[Row]:
    rack, helix = pair.pinion.rack, pair.pinion.helix_angle
    normal = backlash.of_pair(pair).normal if play is None else play
    differ = widths is not None and widths[0] != widths[1]
    ratios = "derived.transverse_contact_ratio", "derived.overlap_ratio"
    return [
        (r"$m_{\mathrm{n}}$, mm", f"{pair.pinion.normal_module * MM:.5g}", "", "mesh.normal_module"),
        (
            r"$\alpha_{\mathrm{n}}$, $\beta$",
            f"{degrees(rack.pressure_angle):.4g}°, {degrees(abs(helix)):.4g}°", "",
            "mesh.pressure_angle", "mesh.helix_angle",
        ),
        (r"$\alpha_{\mathrm{wt}}$", f"{degrees(pair.working_pressure_angle):.5g}°", "",
         "derived.working_pressure_angle"),
        (f"{A_W}, mm", f"{pair.centre_distance * MM:.6g}", "", "derived.centre_distance"),
        (r"$b_{\mathrm{w}}$, mm" if differ else "$b$, mm", f"{pair.face_width * MM:.5g}", "",
         "pinion.face_width", "gear.face_width"),
        (
            r"$\varepsilon_\alpha$, $\varepsilon_\beta$",
            f"{pair.transverse_contact_ratio:.3f}, {pair.overlap_ratio:.3f}", "", *ratios,
        ),
        (r"$j_{\mathrm{n}}$, µm", f"{round(normal * 1e6, 3):.4g}", "", "mesh.backlash"),
    ]  # fmt: skip


def _span(gear: CylindricalGear) -> str:
    k = inspection.span_teeth(gear)
    return f"{inspection.span_measurement(gear, k) * MM:.5g} (k {k})"
