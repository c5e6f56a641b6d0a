"""Lines of an order spectrum are the signal that they are of, its mean with its sign."""

from __future__ import annotations

import numpy as np
import pytest

import gearlash as gl
from gearlash.studies.history import history, spectrum
from gearlash.studies.order_lines import order_lines
from gearlash.studies.series import series_of, spectrum_of


def signal(order: np.ndarray, rms: np.ndarray, phase: np.ndarray, at: np.ndarray) -> np.ndarray:
    """What a reader of the files sums up: √2 rms of every line, of order 0 the value itself."""
    size = np.where(order > 0.0, np.sqrt(2.0), 1.0) * rms
    return size @ np.cos(2.0 * np.pi * order[:, None] * at + phase[:, None])


@pytest.mark.parametrize("mean", [-3.0, 2.0])
@pytest.mark.parametrize("periodic", [True, False])
def test_a_mean_and_two_tones(mean: float, periodic: bool):
    at = np.arange(512) / 64  # eight cycles
    values = mean + 0.5 * np.cos(2 * np.pi * at + 0.3) + 0.25 * np.sin(6 * np.pi * at)
    rms, phase = order_lines(values, periodic)
    assert rms[[0, 8, 24]] * [1.0, np.sqrt(2.0), np.sqrt(2.0)] == pytest.approx(
        [abs(mean), 0.5, 0.25], abs=1e-12
    )
    assert phase[[0, 8, 24]] == pytest.approx([np.pi if mean < 0.0 else 0.0, 0.3, -np.pi / 2])


def test_files_of_a_motion_sum_up_to_it():
    case = gl.load_case("kahraman-singh", {"omega": 0.9})
    point = gl.point(case, {"omega": 0.9}, name="omega")
    found = history(case, {}, point)
    lines = spectrum(found)
    for row, rms, phase in zip(found.values, lines.rms, lines.phase, strict=True):
        assert signal(lines.order, rms, phase, found.phase) == pytest.approx(row, abs=1e-4 * np.ptp(row))
    table = series_of(
        case, case.family()[0].defaults, gl.attractor(case.family()[0].system(), case.family()[0].start())
    )
    columns = {one.name: np.asarray(one.values) for one in spectrum_of(table, periodic=True)}
    for one in table:
        if f"{one.name}_rms" in columns:
            rms, phase = columns[f"{one.name}_rms"], columns[f"{one.name}_phase"]
            summed = signal(columns["order"], rms, phase, _cycles(table))
            values = np.asarray(one.values)
            assert summed == pytest.approx(values, abs=1e-3 * np.ptp(values))


def _cycles(table: list) -> np.ndarray:
    return np.asarray(next(one.values for one in table if one.name == "mesh_cycle"))
