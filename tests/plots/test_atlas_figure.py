"""The figure of an atlas: one panel, or closer looks at what is crowded."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from matplotlib.text import Annotation, Text

import gearlash as gl
from gearlash import plots
from gearlash.results.atlas import AtlasCurve
from plots.made import article, curves


@cache
def drawn(crowded: int = 0) -> gl.Atlas:
    """Two curves over a map, one with so many points close together."""
    case = article()
    x, y = gl.Axis.even("omega", 0.9, 1.2, 3), gl.Axis.even("load", 0.05, 0.2, 3)
    plane = gl.map_plane(case, x, y)
    one, other = curves()[:2]
    special = next(each for curve in curves() for each in curve.special)
    places = [(1.0 + 0.004 * k, 0.1 + 0.003 * (k % 3)) for k in range(crowded)]
    points = tuple(
        replace(
            special, values=place,
            point=replace(special.point, values=place, multipliers=np.zeros(10, complex), arclength=1e3 + k),
        )
        for k, place in enumerate(places)
    )  # fmt: skip
    one = replace(one, special=points)
    both = tuple(AtlasCurve(curve, "of a branch") for curve in (one, other))
    return gl.Atlas(
        plane=plane, curves=both, points=(), changes=(), undone=(), tried=2, complete=True, message="",
        values=case.family()[0].complete({}),
    )  # fmt: skip


def said(figure: Figure) -> set[str]:
    return {text.get_text() for text in figure.findobj(Text) if isinstance(text, Text)}


def test_an_atlas_without_a_crowd_is_one_panel_in_both_units() -> None:
    figure = plots.atlas_diagram(drawn(), article(), title="of article")
    (panel,) = figure.axes
    assert (panel.get_xlim(), panel.get_ylim()) == ((0.9, 1.2), (0.05, 0.2))
    assert {"of article", r"mesh frequency  $\omega$", "pinion speed  [rpm]", "grazing"} <= said(figure)


def test_a_crowd_is_framed_and_shown_closer_with_the_numbers_of_the_table() -> None:
    figure = plots.atlas_diagram(drawn(9), article(), title="of article")
    whole, closer = figure.axes
    (left, right), (low, high) = closer.get_xlim(), closer.get_ylim()
    frames = [each for each in whole.patches if isinstance(each, Rectangle)]
    assert [(f.get_x(), f.get_y(), f.get_width(), f.get_height()) for f in frames] == [
        pytest.approx((left, low, right - left, high - low))
    ]
    numbers = [text.get_text() for text in closer.texts if isinstance(text, Annotation)]
    assert {text.split()[0] for text in numbers} <= {f"1.{k}" for k in range(1, 10)}
    assert len(numbers) >= 3
    counted = sum(1 + int(text.split("+")[1]) if "+" in text else 1 for text in numbers)
    assert counted <= 9
    assert not any(isinstance(text, Annotation) and text.get_text() in numbers for text in whole.texts)
    assert {"Numbers: curve.number in the table. †: rests on an assumed value."} & said(figure)


def test_the_regimes_of_the_map_are_told_in_the_legend_and_not_every_motion() -> None:
    figure = plots.atlas_diagram(drawn(), article())
    (legend,) = figure.legends
    words = {text.get_text() for text in legend.get_texts()}
    assert words & {"no impacts", "drive-side impacts", "aperiodic", "drive- and back-side impacts"}
    assert not any(text[:1].isdigit() for text in words)


def test_what_was_asked_in_another_unit_stands_first_in_every_panel() -> None:
    units = plots.Units.of(article())
    figure = plots.atlas_diagram(drawn(9), article(), along=(units.speed, None))
    assert [panel.get_xlabel() for panel in figure.axes] == ["", ""]
    texts = [text.get_text() for text in figure.findobj(Text) if isinstance(text, Text)]
    assert texts.count("pinion speed  [rpm]") == 2


def test_spans_that_do_not_fit_are_refused() -> None:
    with pytest.raises(gl.GearlashError, match="span"):
        plots.atlas_diagram(drawn(), article(), span=((1.0, 0.9), (0.1, 0.2)))


def test_curves_that_lie_together_are_shown_closer_where_no_points_are() -> None:
    case = gl.load_case("kahraman-singh")
    found = gl.atlas(case, gl.Axis.even("omega", 0.65, 0.9, 2), gl.Axis.even("D", 0.12, 1.1, 2), lines=1)
    whole, closer = plots.atlas_diagram(found, case).axes
    (special,) = (each for each in found.points if each.kind is gl.CodimTwoKind.GRAZING_FOLD)
    (left, right), (low, high) = closer.get_xlim(), closer.get_ylim()
    assert left < special.values[0] < right
    assert low <= special.values[1] < high < 0.5 * whole.get_ylim()[1]
