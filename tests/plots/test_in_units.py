"""Figures in the units of a case: the one asked for along the axis, µm and N on the right."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.axes._secondary_axes import SecondaryAxis

import gearlash as gl
from gearlash import plots
from gearlash.plots.measured import Column, Strip, measured_histories
from gearlash.plots.units import X

RPM = plots.Twin(4000.0, "pinion speed", "rpm")


def test_zones_along_the_unit_that_was_asked_for():
    case = gl.load_case("kahraman-singh")
    found = gl.zones(case, gl.Axis.even("omega", 0.5, 0.55, 3), "impact-free")
    figure = plots.zone_bands(gl.sweep_dataset(case, found.sweeps), [found], present=0.525, asked=RPM)
    panel = figure.axes[2]
    assert panel.get_xlabel() == "pinion speed  [rpm]"
    assert panel.get_xlim() == (2000.0, 2200.0)
    assert any(np.asarray(line.get_xdata()).tolist() == [2100.0, 2100.0] for line in panel.lines)


def test_a_sweep_has_second_axes_and_no_axis_of_zeros():
    case = gl.load_case("article")
    done = gl.sweep(case, gl.Axis.even("omega", 0.9, 0.95, 3))
    figure = plots.diagram(gl.sweep_dataset(case, [done]), units=plots.Units.of(case))
    scales = [
        child for panel in figure.axes for child in panel.child_axes if isinstance(child, SecondaryAxis)
    ]
    labels = {scale.get_ylabel() for scale in scales}
    assert {"$x_n$  [µm] †", "$F_n$  [N] †"} & labels
    stop = gl.load_case("shaw-holmes")
    done = gl.sweep(stop, gl.Axis.even("omega", 0.7, 0.8, 3))
    assert any(isinstance(point.label, gl.Signature) and point.label.impacts for point in done.points)
    figure = plots.diagram(gl.sweep_dataset(stop, [done]))
    said = [text.get_text() for panel in figure.axes for text in panel.texts]
    assert any("zero at every impact" in text for text in said)


def test_no_history_leaves_its_panel():
    time = np.linspace(0.0, 1.0, 5)
    lines = tuple((name, time) for name in "abc")
    small = Column("", time, time < 0.0, (Strip("force", lines),))
    deep = Column("", time, time < 0.0, (Strip("force", (("a", -10.0 * time), *lines[1:])),))
    for panel in measured_histories([small, deep], "time").axes[:2]:
        low, high = panel.get_ylim()
        assert low < -10.0
        assert high > 1.0


def test_portraits_in_the_units_of_a_case_alone():
    case = gl.load_case("article")
    family, scales = case.family()
    found = gl.motion(gl.attractor(family.system(), family.start()))
    plain, own = (
        plots.gallery([found], plots.Units.of(case), physical=physical).axes[0] for physical in (False, True)
    )
    assert own.get_xlabel() == "$x_n$  [µm]"
    assert own.get_ylabel() == r"$\dot x_n$  [mm/s]"
    assert not own.child_axes
    limits = np.array([*plain.get_xlim(), *plain.get_ylim()])
    length, velocity = float(scales.length_um(1.0)), 1e3 * float(scales.velocity(1.0))
    shown = np.array([*own.get_xlim(), *own.get_ylim()])
    assert shown == pytest.approx(limits * [length, length, velocity, velocity])
    bare = gl.load_case("kahraman-singh")
    assert plots.gallery([found], plots.Units.of(bare), physical=True).axes[0].get_xlabel() == X


def test_every_and_some_have_two_looks():
    case = gl.load_case("kahraman-singh")
    found = gl.zones(case, gl.Axis.even("omega", 0.5, 0.9, 9), "impact-free")
    assert found.zones
    assert found.wider
    figure = plots.zone_bands(gl.sweep_dataset(case, found.sweeps), [found])
    looks = {bool(patch.get_hatch()): patch.get_facecolor() for patch in figure.axes[0].patches}
    assert set(looks) == {False, True}
    assert looks[True] == (1.0, 1.0, 1.0, 1.0) != looks[False]
    said = [text.get_text() for text in figure.legends[0].get_texts()]
    assert "no impacts in every attractor found" in said
    assert "no impacts in at least one attractor found" in said


def test_a_map_has_bands_narrower_than_its_pixels_over_them():
    case = gl.load_case("kahraman-singh")
    done = gl.map_plane(case, gl.Axis.even("omega", 0.5, 0.9, 3), gl.Axis.even("load", 0.1, 0.2, 2))
    dataset, present, narrow = gl.plane_dataset(case, done), (0.6, 0.15), (0.651, 0.652)
    figure = plots.plane(dataset, present=present, bands=[narrow])
    bars = [line for line in figure.axes[0].lines if np.asarray(line.get_xdata()).tolist() == [*narrow]]
    assert [np.asarray(line.get_ydata()).tolist() for line in bars] == [[0.15, 0.15]]
    assert bars[0].get_marker() == "|"
    said = [text.get_text() for text in figure.legends[0].get_texts()]
    assert "teeth separate, at the present point's height" in said
    bare = plots.plane(dataset, present=present).legends[0]
    assert not any("separate" in text.get_text() for text in bare.get_texts())


def test_a_map_shows_what_is_not_told_with_a_look_of_its_own():
    case = gl.load_case("kahraman-singh")
    done = gl.map_plane(case, gl.Axis.even("omega", 0.5, 0.9, 3), gl.Axis.even("load", 0.1, 0.2, 2))
    look = {"present": (0.6, 0.15), "bands": [(0.651, 0.652)], "not_told": [(0.7, 0.72)]}
    figure = plots.plane(gl.plane_dataset(case, done), **look)
    bars = {
        tuple(np.asarray(line.get_xdata()).tolist()): line
        for line in figure.axes[0].lines
        if line.get_marker() == "|"
    }
    assert set(bars) == {(0.651, 0.652), (0.7, 0.72)}
    one, other = bars.values()
    assert one.get_color() != other.get_color()
    assert one.get_linestyle() != other.get_linestyle()
    assert "not told whether teeth separate" in [t.get_text() for t in figure.legends[0].get_texts()]
