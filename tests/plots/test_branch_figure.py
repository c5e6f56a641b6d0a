"""The figure of branches: numbers as in the table, boundaries of the gap, units and words."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import combinations

import numpy as np
import pytest
import xarray as xr
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.text import Annotation, Text

import gearlash as gl
from gearlash import plots
from gearlash.plots import style
from gearlash.plots.branch_diagram import CLOUD, FREE_COLOUR
from gearlash.plots.branch_lines import ORDINARY, OTHER_COLOUR
from gearlash.plots.room import Room
from gearlash.plots.style import figure as empty
from plots.made import branch


@cache
def stop() -> xr.Dataset:
    """A mass that hits one stop: no gears, and one side that does not act."""
    case = gl.load_case("shaw-holmes")
    return gl.branch_dataset(case, gl.continue_branch(case, "omega", lower=0.75, upper=0.9))


def inner_texts(figure: Figure) -> list[Text]:
    """Numbers of special points, labels of motions and names of boundaries."""
    return [text for text in figure.axes[0].texts if text.get_text()]


def said(figure: Figure) -> str:
    return "; ".join(text.get_text() for text in figure.findobj(Text) if isinstance(text, Text))


@pytest.mark.parametrize("measure", ["extremes", "strobes"])
def test_special_points_have_the_numbers_of_the_table_where_they_are(measure: str) -> None:
    made = branch()
    figure = plots.branch_diagram([made], measure)
    numbers = {text.get_text(): text.xy for text in inner_texts(figure) if isinstance(text, Annotation)}
    assert set(numbers) == {str(i) for i in range(1, made.sizes["special"] + 1)}
    for number, (x, _) in numbers.items():
        assert x == pytest.approx(float(made["special_value"].values[int(number) - 1]), abs=1e-12)


@pytest.mark.parametrize("made", [branch, stop])
def test_no_text_in_the_panel_overlaps_another(made: Callable[[], xr.Dataset]) -> None:
    figure = plots.branch_diagram([made(), made()], "strobes")
    figure.draw_without_rendering()
    renderer = figure.canvas.get_renderer()  # pyright: ignore[reportAttributeAccessIssue]
    texts = inner_texts(figure)
    boxes = [Text.get_window_extent(text, renderer) for text in texts]
    for (one, a), (other, b) in combinations(zip(texts, boxes, strict=True), 2):
        assert not a.overlaps(b), (one.get_text(), other.get_text())


def test_what_has_no_room_is_counted() -> None:
    """The same branch fifty times: fifty points at every place."""
    figure = plots.branch_diagram([branch()] * 50)
    count = 50 * branch().sizes["special"]
    numbers = sum(isinstance(text, Annotation) for text in inner_texts(figure))
    markers = {
        (float(x), float(y))
        for line in figure.axes[0].lines
        if line.get_marker() != "None"
        for x, y in np.column_stack([np.asarray(part, dtype=float) for part in line.get_data()])
    }
    assert f"{numbers} of {count} special points shown have one; " in said(figure)
    assert "markers are left out where they would hide the lines" in said(figure)
    assert len(markers) == 2 * branch().sizes["special"]


def test_boundaries_of_the_gap_are_drawn_where_a_side_acts() -> None:
    made = stop()
    assert np.isnan(made["boundary_minus"]).all()
    assert set(made["boundary_plus"].values) == {gl.load_case("shaw-holmes").family()[0].defaults["gap"]}
    texts = [text.get_text() for text in inner_texts(plots.branch_diagram([made]))]
    assert "$+D$" in texts
    assert not any("-D" in text for text in texts)


def test_labels_are_those_of_the_table() -> None:
    figure = plots.branch_diagram([branch()])
    labels = {str(label) for label in branch()["label"].values}
    texts = {text.get_text() for text in inner_texts(figure)}
    assert labels <= texts


def test_the_unit_that_was_typed_stands_first() -> None:
    case = gl.load_case("article")
    rpm = plots.Units.of(case).speed
    figure = plots.branch_diagram([branch()], along=rpm)
    scales = [child.get_xlabel() for child in figure.axes[0].child_axes]
    places = [child.spines["bottom"].get_position() for child in figure.axes[0].child_axes]
    assert scales == ["pinion speed  [rpm]", r"mesh frequency  $\omega$"]
    assert places[0] == ("outward", 0.0)
    assert float(places[1][1]) > 0.0
    assert not figure.axes[0].get_xlabel()


def test_a_system_without_gears_is_told_without_words_of_gears() -> None:
    case = gl.load_case("shaw-holmes")
    sweep = gl.sweep_dataset(case, [gl.sweep(case, gl.Axis.even("omega", 0.79, 0.81, 3))])
    plane = gl.map_plane(case, gl.Axis.even("omega", 0.8, 0.81, 2), gl.Axis.even("force", 0.9, 1.0, 2))
    figures = [
        plots.branch_diagram([stop()], cloud=sweep, multipliers=True, units=plots.Units.of(case)),
        plots.diagram(sweep, units=plots.Units.of(case)),
        plots.plane(gl.plane_dataset(case, plane), plots.Units.of(case)),
    ]
    for figure in figures:
        words = said(figure).lower()
        assert "frequency" in words
        for word in ("mesh", "gear", "pinion", "teeth", "tooth", "backlash", "transmission error"):
            assert word not in words


def test_words_of_gears_stay_where_there_are_gears() -> None:
    assert "mesh frequency" in said(plots.branch_diagram([branch()]))


def test_ordinary_ends_have_no_marker() -> None:
    assert {str(kind) for kind in (gl.EndKind.LOWER, gl.EndKind.UPPER)} <= set(ORDINARY)


def test_room_takes_the_emptiest_place_and_never_one_twice() -> None:
    figure = empty(100.0, 60.0)
    panel = figure.subplots()
    panel.set_xlim(0.0, 100.0)
    panel.set_ylim(0.0, 50.0)
    room = Room(panel, 100.0, 50.0)
    room.fill(np.array([0.0, 100.0]), np.array([20.0, 20.0]))
    assert room.place("12", 7.0, [(50.0, 20.0), (50.0, 30.0)]) == (50.0, 30.0)
    assert room.place("13", 7.0, [(50.5, 30.5)]) is None
    assert room.place("14", 7.0, [(50.0, 20.0)], most=0) is None
    assert room.place("15", 7.0, [(99.9, 10.0)]) is None, "outside"
    assert room.back(*room.at(30.0, 40.0)) == pytest.approx((30.0, 40.0))


def test_branches_that_leave_the_picture_are_told() -> None:
    case = gl.load_case("article")
    made = gl.continue_branch(case, "omega", lower=0.9, upper=1.3, values={"omega": 1.0})
    figure = plots.branch_diagram([gl.branch_dataset(case, made)])
    low, high = figure.axes[0].get_ylim()
    assert "unstable branches go on above and below what is shown" in said(figure)
    drawn = [np.asarray(line.get_ydata(), dtype=float) for line in figure.axes[0].lines]
    assert max(float(np.nanmax(y)) for y in drawn) > high
    assert min(float(np.nanmin(y)) for y in drawn) < low
    assert "go on" not in said(plots.branch_diagram([branch()]))


def test_words_of_a_colour_can_be_read_on_white() -> None:
    for colour in ("#56b4e9", "#e69f00", "#f0e442", "#cc79a7", "#0072b2", "#1a1a1a"):
        parts = np.array(to_rgb(style.words_in(colour)))
        assert 1.05 / (style.luminance(parts) + 0.05) >= 4.5
    assert style.words_in("#1a1a1a") == "#1a1a1a"


def test_branches_are_told_from_what_was_swept() -> None:
    cloud = style.luminance(np.array(to_rgb(CLOUD))) + 0.05
    for colour in (OTHER_COLOUR, FREE_COLOUR, style.BLUE):
        assert cloud / (style.luminance(np.array(to_rgb(colour))) + 0.05) > 2.4
