"""The figure of curves: kinds by their looks, special points with numbers, units, and a map behind."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.text import Annotation, Text

import gearlash as gl
from gearlash import plots
from gearlash.plots.curve_diagram import MARKERS
from plots.made import article, curves


@cache
def folds() -> gl.Curve:
    """Of the impacting branch of the 1-DOF family with a cusp."""
    case = gl.load_case("kahraman-singh")
    branch = gl.continue_branch(case, "omega", lower=0.7, upper=1.6, values={"omega": 1.5})
    fold, low, high = branch.of_kind("fold")[0], (0.6, 0.05), (1.2, 0.5)
    return gl.continue_curve(case, ("omega", "load"), fold, branch=branch, lower=low, upper=high)


def said(figure: Figure) -> set[str]:
    return {text.get_text() for text in figure.findobj(Text) if isinstance(text, Text)}


def lines_of(figure: Figure) -> list[np.ndarray]:
    lines = [line for line in figure.axes[0].lines if line.get_marker() == "None"]
    return [places(line) for line in lines]


def places(line: Line2D) -> np.ndarray:
    """(m, 2): what a line goes through."""
    return np.column_stack([np.asarray(part, dtype=float) for part in line.get_data()])


def test_every_kind_has_a_marker_of_its_own() -> None:
    assert set(MARKERS) == set(gl.CodimTwoKind)
    assert len(set(MARKERS.values())) == len(MARKERS)


def test_a_curve_goes_through_every_computed_point_and_its_special_ones_are_marked() -> None:
    curve = folds()
    (cusp,) = curve.special
    figure = plots.curve_diagram([curve])
    drawn = np.concatenate(lines_of(figure))
    for point in (*curve.points, cusp.point):
        assert np.abs(drawn - point.values).max(axis=1).min() < 1e-12
    marks = {line.get_marker(): line for line in figure.axes[0].lines if line.get_marker() != "None"}
    assert set(marks) == {MARKERS[gl.CodimTwoKind.CUSP]}
    assert places(marks["<"])[0].tolist() == list(cusp.values)
    numbers = [text.get_text() for text in figure.axes[0].texts if isinstance(text, Annotation)]
    assert numbers == ["1"]
    assert {"fold", "cusp", "1-1-0", "Numbers: rows of the table."} <= said(figure)


def test_one_curve_found_twice_is_drawn_once() -> None:
    once, twice = plots.curve_diagram([folds()]), plots.curve_diagram([folds(), folds()])
    assert len(lines_of(once)) == len(lines_of(twice))
    assert {text.get_text() for text in twice.axes[0].texts} >= {"1.1", "2.1"}


def test_orbits_that_are_none_of_the_real_system_are_pale() -> None:
    curve = folds()
    points = [replace(point, admissible=i < 20) for i, point in enumerate(curve.points)]
    figure = plots.curve_diagram([replace(curve, points=tuple(points), special=())])
    faint = [line.get_alpha() for line in figure.axes[0].lines]
    assert set(faint) == {1.0, 0.35}
    assert "pale: no orbit of the real system" in said(figure)
    assert "pale: no orbit of the real system" not in said(plots.curve_diagram([curve]))


def test_axes_have_words_and_units_of_the_case() -> None:
    units = plots.Units.of(article())
    own = plots.curve_diagram(curves(), article())
    assert own.axes[0].get_xlabel() == r"mesh frequency  $\omega$"
    assert "pinion speed  [rpm]" in said(own)
    asked = plots.curve_diagram(curves(), article(), along=(units.speed, None))
    assert asked.axes[0].get_xlabel() == ""
    plain = plots.curve_diagram([folds()])
    assert plain.axes[0].get_xlabel() == r"frequency  $\omega$"


def test_a_map_lies_behind_them_paler_and_must_be_over_the_same() -> None:
    case = article()
    axes = gl.Axis.even("omega", 0.98, 1.0, 2), gl.Axis.even("load", 0.1, 0.12, 2)
    plane = gl.plane_dataset(case, gl.map_plane(case, *axes))
    figure = plots.curve_diagram(curves(), case, behind=plane)
    assert "no impacts" in said(figure)
    with pytest.raises(gl.GearlashError, match="expected a map over omega and load"):
        plots.curve_diagram(curves(), case, behind=gl.plane_dataset(case, gl.map_plane(case, *axes[::-1])))


def test_what_cannot_be_drawn_together_is_refused() -> None:
    other = replace(folds(), names=("load", "omega"))
    with pytest.raises(gl.GearlashError, match="load and omega; omega and load"):
        plots.curve_diagram([folds(), other])
    with pytest.raises(gl.GearlashError, match="at least one"):
        plots.curve_diagram([])
    with pytest.raises(gl.GearlashError, match="span"):
        plots.curve_diagram([folds()], span=((1.0, 0.5), (0.0, 1.0)))


def test_curves_are_drawn_as_any_result_is() -> None:
    case = gl.load_case("kahraman-singh")
    assert len(plots.draw(folds(), case).axes) == len(plots.draw([folds()], case).axes) == 1


@pytest.mark.parametrize("long", [(0, 1, 2), (0, 3, 6), (0, 5, 10)])
def test_the_legend_lies_on_the_page_however_long_its_words_are(long: tuple[int, ...]) -> None:
    curve = folds()
    (cusp,) = curve.special
    kinds = sorted(gl.CodimTwoKind, key=lambda kind: len(str(kind)))
    for place in long:
        kinds.insert(place, kinds.pop())
    special = tuple(replace(cusp, kind=kind) for kind in kinds)
    figure = plots.curve_diagram([replace(curve, special=special)])
    figure.draw_without_rendering()
    (legend,) = figure.legends
    extent = legend.get_window_extent()
    assert extent.x0 >= 0.0
    assert extent.x1 <= figure.bbox.x1
    assert figure.axes[0].get_window_extent().height / figure.dpi * 25.4 > 85.0
