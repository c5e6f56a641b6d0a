"""Axes of what is measured over speed: what does not happen is not magnified, none begins below zero."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.patches import Rectangle

from gearlash.plots.marks import Mark
from gearlash.plots.over_speed import NOT_TOLD, Curve, SpeedAxis, Stack, over_speed

SPEEDS = np.linspace(1000.0, 2000.0, 50)


def limits(values: np.ndarray, second: tuple[float, str] | None = None) -> tuple[float, float, int]:
    """Of the panel, and how many numbers stand on its second axis."""
    none = np.zeros(len(SPEEDS) - 1, dtype=np.bool_)
    marks = (Mark(1300.0, "resonance", "f1", True),)
    axis = SpeedAxis(SPEEDS, "pinion speed  [rpm]", (none, none), (), (), 1500.0, marks)
    made = over_speed(axis, [Stack("force  [N]", (Curve("peak", values, values),), second)])
    panel = made.axes[1]
    made.canvas.draw()
    right = [len(axes.get_yticks()) for axes in panel.child_axes]
    return *panel.get_ylim(), right[0] if right else 0


def test_what_is_zero_everywhere_has_an_axis_of_one():
    low, high, _ = limits(np.zeros(50))
    assert low == 0.0
    assert 1.0 <= high <= 1.5


def test_values_from_zero_on_have_an_axis_from_zero_on():
    assert limits(np.linspace(0.0, 3.0, 50))[0] == 0.0
    assert limits(np.linspace(-1.0, 3.0, 50))[0] < -1.0


def test_the_dynamic_factor_has_several_numbers_on_its_axis():
    assert limits(np.linspace(4000.0, 13000.0, 50), (4250.0, "$K_v$ of the peak"))[2] >= 4


def test_what_is_not_told_has_a_look_of_its_own_in_every_panel():
    none, values = np.zeros(len(SPEEDS), dtype=np.bool_), np.linspace(1.0, 2.0, 50)
    open_ = ((1100.0, 1200.0), (1700.0, 1710.0))
    stack = Stack("force  [N]", (Curve("peak", values, values),))
    separating, beside = ((1300.0, 1400.0),), ((1500.0, 1600.0),)
    shown = {}
    for not_told in (open_, ()):
        axis = SpeedAxis(
            SPEEDS, "speed", (none, none), separating, (), 1500.0, beside=beside, not_told=not_told
        )
        figure = over_speed(axis, [stack, stack])
        shown[not_told] = {text.get_text() for text in figure.legends[0].get_texts()}
        for panel in figure.axes[1:3]:
            hatched = [one for one in panel.patches if one.get_hatch() == NOT_TOLD["hatch"]]
            assert all(isinstance(one, Rectangle) for one in hatched)
            at = [
                (one.get_x(), one.get_x() + one.get_width()) for one in hatched if isinstance(one, Rectangle)
            ]
            assert at == [pytest.approx(each) for each in not_told]
    assert shown[open_] - shown[()] == {"not told whether teeth separate"}


def test_a_legend_without_the_first_band_still_says_what_happens_in_the_second():
    none, values = np.zeros(len(SPEEDS), dtype=np.bool_), np.linspace(1.0, 2.0, 50)
    axis = SpeedAxis(SPEEDS, "speed", (none, none), (), (), 1500.0, beside=((1500.0, 1600.0),))
    figure = over_speed(axis, [Stack("force  [N]", (Curve("peak", values, values),))])
    said = [text.get_text() for text in figure.legends[0].get_texts()]
    assert "teeth separate in one motion, in another not" in said
