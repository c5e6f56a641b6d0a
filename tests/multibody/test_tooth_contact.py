"""The picture of the lines of contact shows the loads that were found."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.collections import LineCollection, QuadMesh

from gearlash.multibody.quasi_static import quasi_static
from gearlash.plots.tooth_contact import ToothLoads, tooth_contact
from multibody.meshes import plain


def test_the_map_and_the_lines_show_the_loads():
    mesh = plain("helical")
    found = quasi_static(mesh, 77.0, 16)
    line_loads = found.loads / mesh.tables.scalars[20] * 1e-3  # N/mm; the length of line in a slice
    figure = tooth_contact(ToothLoads.of(mesh, found))
    left, right = figure.axes[:2]
    image = next(one for one in left.collections if isinstance(one, QuadMesh)).get_array()
    assert image is not None
    assert image.shape == (160, len(mesh.tables.slices))
    assert image.max() == pytest.approx(line_loads.max(), rel=0.02)
    figure.canvas.draw()
    for axes in (left, right):  # both axes have numbers, and the scale of the map stands below it
        assert any(one.get_visible() and one.get_text() for one in axes.get_yticklabels())
    assert figure.axes[2].get_position().y1 < left.get_position().y0
    hairs = [one for one in right.collections if isinstance(one, LineCollection)]
    lengths = np.concatenate([np.ptp(np.array(one.get_segments())[:, :, 1], axis=1) for one in hairs])
    shown = line_loads[int(line_loads.max(axis=(1, 2)).argmax())]
    assert lengths.max() / lengths.sum() == pytest.approx(shown.max() / shown.sum(), rel=1e-6)
    low, high = left.get_ylim()
    pinion = mesh.flanks.pair.pinion
    assert high == pytest.approx(1e3 * pinion.tip_diameter)
    assert 1e3 * pinion.root_form_diameter < low < 1e3 * pinion.reference_diameter
