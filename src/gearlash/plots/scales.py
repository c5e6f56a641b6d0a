"""Two scales of one parameter: that in which it was asked for stands first."""

from __future__ import annotations

from dataclasses import replace

from matplotlib.axes import Axes

from .units import Twin, second

OUT = 9.5  # mm: how far below the first scale of x the second one lies


def scales(panel: Axes, which: str, text: str, twin: Twin | None, *, first: bool, only: bool = False) -> None:
    """The axis x (below) or y (left): ``text`` is its name without a unit, ``twin`` the physical scale, which
    stands in its place where it is to be the ``first`` (``only``: alone), and else beside it. A quantity in
    SI has its physical scale alone."""
    label = panel.set_xlabel if which == "x" else panel.set_ylabel
    below = OUT if which == "x" else 0.0
    if twin is not None and twin.own:
        first = only = True
    if twin is None or not first:
        label(text)
        second(panel, twin, which, below)
        return
    plain = Twin(1.0, text, "", twin.assumed)  # what was asked in is as given: the other one rests on more
    twin = replace(twin, assumed=False)
    if which == "x":
        panel.tick_params(axis="x", which="both", bottom=False, labelbottom=False)
        second(panel, twin, "below")
    else:
        panel.tick_params(axis="y", which="both", left=False, labelleft=False)
        second(panel, twin, "left")
    if not only:
        second(panel, plain, which, below)
