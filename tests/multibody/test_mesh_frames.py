"""Frames of a motion: the teeth touch where they touch, with the play drawn larger."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.text import Annotation

from gearlash.plots.mesh_frames import drawn_turns, magnified, mesh_frames
from multibody.meshes import plain, pose


def test_gears_are_drawn_where_the_larger_play_has_them():
    mesh = plain("helical")
    flanks, times = mesh.flanks, magnified(mesh.flanks)
    oblique = np.cos(flanks.base_helix)
    assert 0.1 * flanks.pitch < times * flanks.play / oblique < 0.14 * flanks.pitch
    first, second = flanks.base_radii
    for part in (-1.0, -0.3, 0.0, 0.5, 1.0):
        one, two = drawn_turns(flanks, pose(mesh, 0.2, 0.5 * part * flanks.play), times)
        assert one == 0.2
        assert (first * one + second * two) * oblique == pytest.approx(0.5 * times * part * flanks.play)
    pressed = drawn_turns(flanks, pose(mesh, 0.2, 0.5 * flanks.play + 20e-6), times)
    assert pressed == pytest.approx(drawn_turns(flanks, pose(mesh, 0.2, 0.5 * flanks.play), times))


def test_a_push_of_next_to_nothing_has_no_arrow():
    """And a small one has a small head, so that it does not look like a large one."""
    mesh = plain("helical")
    poses = np.array([pose(mesh, 0.05 * k, 0.5 * mesh.flanks.play) for k in range(3)])
    figure = mesh_frames(
        mesh.flanks, poses, np.array([[4000.0, 0.0], [39.0, 0.0], [200.0, 0.0]]), [0.0, 0.3, 0.6]
    )
    large, none, small = figure.axes
    assert not none.texts
    heads = []
    for axes in (large, small):
        (arrow,) = (one for one in axes.texts if isinstance(one, Annotation))
        assert arrow.arrow_patch is not None
        heads.append(arrow.arrow_patch.get_mutation_scale())
    assert heads[1] == pytest.approx(0.2 * heads[0])


def test_every_frame_shows_its_forces():
    mesh = plain("helical")
    poses = np.array([pose(mesh, 0.05 * k, (1 - k) * 0.5 * mesh.flanks.play) for k in range(3)])
    forces = np.array([[2000.0, 0.0], [0.0, 0.0], [0.0, 1000.0]])
    figure = mesh_frames(mesh.flanks, poses, forces, [-0.001, 1.0 / 3.0, 2.0 / 3.0])
    assert [axes.get_title("left") for axes in figure.axes] == ["phase 0.00", "phase 0.33", "phase 0.67"]
    drive, free, back = figure.axes
    assert not free.texts
    arrows = [one for axes in (drive, back) for one in axes.texts if isinstance(one, Annotation)]
    tips = [np.subtract(arrow.xy, arrow.xyann) for arrow in arrows]
    assert tips[0][1] > 0.0 > tips[1][1]
    assert np.linalg.norm(tips[0]) == pytest.approx(2.0 * np.linalg.norm(tips[1]))
    for axes in figure.axes:  # no tooth is drawn into another one
        pinion, gear = (np.array(line.get_xydata()) for line in axes.lines)
        solid = next(patch for patch in axes.patches).get_path()
        assert not solid.contains_points(gear, radius=-0.05).any()
        assert np.abs(pinion[:, None, :] - gear[None, :, :]).sum(axis=2).min() < 1.5
