"""Axes of what is measured over speed: what does not happen is not magnified, none begins below zero."""

from __future__ import annotations

import numpy as np

from gearlash.plots.marks import Mark
from gearlash.plots.over_speed import Curve, SpeedAxis, Stack, over_speed

SPEEDS = np.linspace(1000.0, 2000.0, 50)


def limits(values: np.ndarray, second: tuple[float, str] | None = None) -> tuple[float, float, int]:
    """Of the panel, and how many numbers stand on its second axis."""
    none = np.zeros(len(SPEEDS), dtype=np.bool_)
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
