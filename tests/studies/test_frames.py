"""Frames of a motion show the teeth apart where they part."""

from __future__ import annotations

import numpy as np
import pytest

from gearlash.multibody import Trajectory
from gearlash.studies.verification import Frames, frames_of


def frames(begins: float, ends: float) -> Frames:
    """Of a motion over two mesh cycles and a half in which no tooth carries between two phases."""
    teeth = 28, 70
    t = np.linspace(0.0, 2.5, 2501)
    q = np.zeros((len(t), 12))
    q[:, 5] = 2.0 * np.pi * t / teeth[0]
    q[:, 11] = -2.0 * np.pi * t / teeth[1]
    drive = np.where((t - begins) % 1.0 <= ends - begins, 0.0, 1000.0)
    return frames_of(Trajectory(t, q, np.zeros_like(q), np.outer(drive, [1.0, 0, 0, 0, 0])), teeth)


@pytest.mark.parametrize(
    ("begins", "ends"), [(0.0, 0.12), (0.4, 0.45), (0.9, 0.99), (0.9, 1.1), (0.95, 1.25), (0.6, 1.05)]
)
def test_one_frame_is_in_the_middle_of_the_time_apart(begins: float, ends: float):
    found = frames(begins, ends)
    off = np.abs((found.phase - 0.5 * (begins + ends) + 0.5) % 1.0 - 0.5)
    at = int(off.argmin())
    assert off[at] < 2e-3
    assert found.forces[at, 0] == 0.0
    assert np.diff(found.phase) == pytest.approx(1.0 / 6.0, abs=2e-3)
    assert 0.0 <= found.phase[0] < 1.0 / 6.0 + 1e-3
    assert found.turns[:, 0] == pytest.approx(2.0 * np.pi * found.phase / 28)


def test_frames_of_teeth_that_stay_begin_with_the_cycle():
    found = frames(0.0, -1.0)
    assert found.phase == pytest.approx(np.arange(6) / 6, abs=1e-3)
    assert np.all(found.forces[:, 0] > 0.0)
