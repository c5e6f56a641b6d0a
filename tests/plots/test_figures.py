"""Every figure: labelled with symbols and units, nothing outside, self-contained, the same bytes always."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle
from matplotlib.text import Text

import gearlash as gl
from gearlash import plots
from gearlash.gears import CylindricalGear, CylindricalPair
from gearlash.plots import style
from gearlash.plots.branch_lines import MARKERS, OTHER_MARKER
from gearlash.plots.legends import legend_below
from gearlash.plots.measured import Column, Strip, measured_histories
from gearlash.plots.over_speed import Curve, SpeedAxis, Stack, over_speed
from gearlash.plots.spectra import Levels, order_spectra
from gearlash.plots.units import ASSUMED_MARK
from gearlash.system import Signature
from plots.made import (
    aperiodic,
    around_grazing,
    article,
    begun,
    branch,
    curves,
    dataset,
    moving,
    planar,
    plane,
    tolerated,
    zoned,
)

BARS = (
    plots.Bar("article", 0.973, 1.112, "reported", "", "0.973", "1.112"),
    plots.Bar(
        "computed: every motion",
        0.9725,
        1.0922,
        "computed",
        Signature(1, 0),
        "0.9725  grazing",
        "1.0922  fold",
    ),
    plots.Bar("coexists: 2-1", 1.0922, 1.112, "coexisting", Signature(2, 1), "1.0922", "1.112"),
)
MARKS = (
    plots.Mark(1.112, "grazing", "1.1120  1-0 → 1-1", True),
    plots.Mark(1.1125, "doubling", "1.1125  1-1 → 2-2"),
    plots.Mark(1.09, "fold", ""),
)


def units() -> plots.Units:
    return plots.Units.of(article())


def measured() -> tuple[SpeedAxis, list[Stack]]:
    """Curves over speed with a band, a jump, and a resonance."""
    speed = np.linspace(2000.0, 6000.0, 41)
    up = np.where(speed < 4000.0, 1e3, 5e3) + speed
    down = np.where(speed < 3500.0, 1e3, 5e3) + speed
    breaks = np.isclose(speed, 4000.0), np.isclose(speed, 3500.0)
    marks = plots.Mark(2730.0, "resonance", "f3", True), plots.Mark(2550.0, "resonance", "f5/2")
    axis = SpeedAxis(
        speed, "pinion speed  [rpm]", breaks, ((3500.0, 6000.0),), ((4500.0, 5000.0),), 4200.0, marks
    )
    curves = Curve("peak", up, down), Curve("mean", 0.5 * up, 0.5 * up)
    return axis, [Stack("mesh force  [N]", curves, (1e3, "$K_v$")), Stack("DTE  [µm]", curves[1:])] * 2


def columns() -> list[Column]:
    time = np.linspace(0.0, 1.0, 101)
    lines = ("pinion, lateral", np.sin(6.0 * time)), ("gear, lateral", np.cos(6.0 * time))
    strips = Strip("bearing force  [N]", lines), Strip("DTE  [µm]", lines[:1], 0.5)
    return [Column(title, time, time > 0.7, strips) for title in ("4000 rpm:  1-0", "4480 rpm:  aperiodic")]


def levels() -> list[Levels]:
    few, many = np.arange(12.0), np.arange(0.0, 12.0, 1 / 64)
    return [Levels("mesh force", "dB re 1 µN", order, 180.0 - 8.0 * order) for order in (few, many)]


def force_panels() -> list[list[plots.ForcePanel]]:
    time = np.linspace(0.0, 2.0, 129)
    force = 1.0 + 1.2 * np.cos(2.0 * np.pi * time)
    one = [
        plots.ForcePanel(f"{speed} rpm", time, np.maximum(force, 0.0), time[:65], force[:65])
        for speed in (3600, 4000)
    ]
    return [one, one]


def order_panels() -> list[list[plots.OrderPanel]]:
    halves, whole = np.arange(1.0, 17.0) / 2.0, np.arange(1.0, 9.0)
    lumped = [(whole, 0.3**whole), (np.zeros(0), np.zeros(0))]
    return [[plots.OrderPanel("3600 rpm", halves, 0.2**halves, *each) for each in lumped]]


FIGURES: dict[str, Callable[[], Figure]] = {
    "stated-curves": lambda: plots.stated_curves(
        [
            plots.StatedCurve(
                "stiffness",
                "mesh cycle",
                np.array([0.0, 0.5]),
                np.array([1.1, 0.9]),
                np.array([1.0, 0.08, 0.0]),
            )
        ],
        "as it is",
    ),
    "around-point": lambda: plots.around_point(
        [
            plots.PlaneLine([(0.01 * (5 - y) ** n + 0.3, 0.01 * y) for y in (5, 4, 3, 2, 1)], kind, text)
            for n, kind, text in ((1, "doubling", "doubling of 1-1"), (2, "grazing", "1-1 | 1-1-1"))
        ],
        (0.3, 0.05),
        0.02,
        [(0.33, "0.33")],
        ("D", "bearing_damping"),
        "as it is",
        units(),
    ),
    "force-beside": lambda: plots.force_beside(force_panels()),
    "orders-beside": lambda: plots.orders_beside(order_panels()),
    "zone-in-plane": lambda: plots.zone_in_plane(planar(), title="a spur pair"),
    "branches": lambda: plots.branch_diagram(
        [branch()], cloud=dataset(), multipliers=True, title="The window of article", units=units()
    ),
    "branch-force": lambda: plots.branch_diagram([branch()], "force_max", units=units()),
    "curves": lambda: plots.curve_diagram(
        curves(), article(), title="Around the window", along=(units().speed, units().of_parameter("load"))
    ),
    "diagram": lambda: plots.diagram(dataset(), MARKS, units()),
    "diagram-back": lambda: plots.diagram(dataset("D"), (), units()),
    "diagram-asked": lambda: plots.diagram(
        dataset(), MARKS, units(), title="article", present=1.047, asked=plots.Twin(3820.0, "speed", "rpm")
    ),
    "over-speed": lambda: over_speed(*measured(), "article, 96.95 N·m"),
    "over-speed-alone": lambda: over_speed(replace(measured()[0], resonances=()), measured()[1], ""),
    "measured-histories": lambda: measured_histories(columns(), "time  [ms]"),
    "order-spectra": lambda: order_spectra([levels(), levels()], ("4000 rpm: 1-0", "4480 rpm: aperiodic")),
    "plane-present": lambda: plots.plane(plane(), units(), present=(1.0, 1.0), title="article", height=66.0),
    "portrait": lambda: plots.portrait(moving(1.1, 1.0, 1.1), units()),
    "portraits": lambda: plots.portrait_triple(around_grazing(), units()),
    "gallery": lambda: plots.gallery((moving(1.05, 1.0, 1.05), aperiodic()), units()),
    "history": lambda: plots.history(moving(1.1, 1.0, 1.1), units()),
    "histories": lambda: plots.history_triple(around_grazing(), units()),
    "overlay": lambda: plots.overlay(
        [1.0, 2.0, 3.0],
        [3.0, 4.0, 9.0],
        [3.1, 4.1, 8.7],
        [3.1, None, 8.7],
        "speed [rpm]",
        "transmission error, peak-to-peak [um]",
        "drive: measured and computed",
        [(2.0, 3.0)],
    ),
    "tolerances": lambda: plots.tolerance_bands(tolerated(), "Tolerances of drive"),
    "tolerances-begun": lambda: plots.tolerance_bands(begun(4), "Tolerances of drive"),
    "tolerances-stopped": lambda: plots.tolerance_bands(begun(16), "Tolerances of drive"),
    "histories-stacked": lambda: plots.history_triple((moving(0.78, 0.386), aperiodic()), units(), "D"),
    "plane": lambda: plots.plane(plane(), units()),
    "sections": lambda: plots.sections((moving(1.1, 1.0, 1.1), moving(0.78, 0.386, 0.386))),
    "zone-bands": lambda: plots.zone_bands(*zoned(), "Zones of article", 1.047, units()),
    "mesh-drawing": lambda: plots.mesh_drawing(
        CylindricalPair(
            CylindricalGear(25, 3e-3, 0.26, 0.2), CylindricalGear(57, 3e-3, 0.26), face_width=0.04
        ),
        "drive: 25/57 teeth",
        80e-6,
        (0.044, 0.04),
    ),
    "zones": lambda: plots.zones((plots.Panel("omega", "impact-free at D = 1", BARS),), units()),
}


@pytest.fixture(params=sorted(FIGURES))
def figure(request: pytest.FixtureRequest) -> Figure:
    return FIGURES[request.param]()


def panels(figure: Figure) -> list[Axes]:
    """Axes with a frame and numbers on them."""
    return [a for a in figure.axes if a.spines["left"].get_visible() and a.xaxis.get_visible()]


def words(figure: Figure) -> set[str]:
    shown = [t for t in figure.findobj(Text) if isinstance(t, Text) and t.get_visible()]
    return {t.get_text() for t in shown if t.get_text()}


def test_nothing_written_lies_outside(figure: Figure) -> None:
    figure.draw_without_rendering()
    renderer = figure.canvas.get_renderer()  # pyright: ignore[reportAttributeAccessIssue]
    box = figure.bbox
    pixel = figure.dpi / 100.0
    for axes in (*figure.axes, *(child for a in figure.axes for child in a.child_axes)):
        for axis in (axes.xaxis, axes.yaxis):
            if not axis.get_visible():
                continue
            low, high = sorted(axis.get_view_interval())
            ticks = zip(axis.get_majorticklocs(), axis.get_majorticklabels(), strict=False)
            shown = [label for place, label in ticks if low <= place <= high]
            for text in (axis.label, axes.title, *shown):
                if text.get_visible() and text.get_text():
                    extent = text.get_window_extent(renderer)
                    assert extent.x0 >= box.x0 - pixel, text.get_text()
                    assert extent.x1 <= box.x1 + 6 * pixel, text.get_text()
                    assert extent.y0 >= box.y0 - pixel, text.get_text()
                    assert extent.y1 <= box.y1 + pixel, text.get_text()
    for legend in figure.legends:
        extent = legend.get_window_extent(renderer)
        assert box.x0 - pixel <= extent.x0
        assert extent.x1 <= box.x1 + pixel
        assert extent.y0 >= box.y0 - pixel


def test_an_svg_asks_no_host_and_carries_no_date(figure: Figure) -> None:
    text = plots.to_bytes(figure, "svg").decode()
    without_names = re.sub(r'xmlns(:\w+)?="[^"]*"', "", re.sub(r"<!DOCTYPE[^>]*>", "", text))
    assert "http" not in without_names
    assert "<script" not in text
    assert "<metadata" not in text
    assert re.findall(r'href="(?!#|data:image/png;base64,)', text) == []
    assert "<text" not in text, "text as outlines needs no font of the reader"


@pytest.mark.parametrize("form", ["svg", "pdf", "png"])
def test_the_same_figure_gives_the_same_bytes_under_any_settings(form: str) -> None:
    first = plots.to_bytes(FIGURES["portraits"](), form, dpi=60)
    with mpl.rc_context(
        {"font.size": 30, "lines.linewidth": 9, "svg.hashsalt": None, "font.family": "serif"}
    ):
        assert plots.to_bytes(FIGURES["portraits"](), form, dpi=60) == first
        assert mpl.rcParams["font.size"] == 30, "the caller's settings are left alone"


def test_a_bifurcation_diagram_says_what_and_in_which_units() -> None:
    figure = FIGURES["diagram"]()
    said = words(figure)
    for label in (
        r"mesh frequency  $\omega$",
        r"$X_n$  on  $\sigma_t$",
        r"$\Phi$  on  $\sigma_d$",
        r"$\lambda_1$  [per $\tau$]",
    ):
        assert label in said
    assert "pinion speed  [rpm]" in said
    assert {"cold", "up", "down", "1-0"} <= said
    assert "1.1120  1-0 → 1-1" in said
    assert any("no impact was found in these sweeps" in text for text in said), "Σ2 is not met at D = 1"


def test_the_back_side_is_shown_with_impacts_and_releases() -> None:
    said = words(FIGURES["diagram-back"]())
    assert r"$\Phi$  on  $\sigma_b$" in said
    assert any(text.startswith("impacts, S2") for text in said)
    assert any(text.startswith("releases, S3") for text in said)
    assert f"backlash  $b$  [µm] {ASSUMED_MARK}" in said


def test_forces_are_drawn_in_the_sign_asked_for() -> None:
    """Φ is positive where the drive side is hit; a sweep's file holds -Φ."""

    def drawn(figure: Figure, label: str) -> np.ndarray:
        (panel,) = [a for a in figure.axes if a.get_ylabel() == label]
        offsets = [np.asarray(c.get_offsets())[:, 1] for c in panel.collections if hasattr(c, "get_offsets")]
        return np.concatenate(offsets)

    stored = dataset("D")["drive_force"].values
    own = drawn(FIGURES["diagram-back"](), r"$\Phi$  on  $\sigma_d$")
    turned = plots.diagram(dataset("D"), (), units(), plots.ForceAxis(r"$F$", -1.0))
    assert (own > 0.0).all()
    assert set(own) <= set(-stored[np.isfinite(stored)])
    np.testing.assert_array_equal(drawn(turned, r"$F$  on  $\sigma_d$"), -own)


def test_second_scales_agree_with_the_case_and_mark_what_is_assumed() -> None:
    own, scales = units(), article().scales
    assert own.speed is not None
    assert own.length is not None
    assert own.force is not None
    assert own.speed(1.047) == pytest.approx(float(scales.pinion_rpm(1.047)), rel=1e-14)
    assert own.speed.back(own.speed(0.7)) == pytest.approx(0.7, rel=1e-14)
    assert not own.speed.label.endswith(ASSUMED_MARK), "the speed rests on inferred values only"
    assert own.length.label.endswith(ASSUMED_MARK), "the length rests on the assumed backlash"
    assert own.force.label.endswith(ASSUMED_MARK)
    assert plots.Units().of_parameter("omega") is None
    torque, error = own.of_parameter("load"), own.of_parameter("error")
    assert torque is not None
    assert error is not None
    assert torque(0.1) == pytest.approx(float(scales.torque(0.1)), rel=1e-14)
    assert torque.label == f"torque  [N·m] {ASSUMED_MARK}"
    assert error(0.1) == pytest.approx(float(scales.length_um(0.1)), rel=1e-14)
    assert own.of_parameter("ripple") is None


@pytest.mark.parametrize(
    "name", ["portrait", "portraits", "gallery", "history", "histories", "histories-stacked", "sections"]
)
def test_axes_of_motions_carry_symbols_and_units(name: str) -> None:
    figure = FIGURES[name]()
    said = words(figure)
    expected = {
        "port": ("displacement  $X_n$", "velocity  $X_n'$", f"$x_n$  [µm] {ASSUMED_MARK}"),
        "gall": ("displacement  $X_n$", "velocity  $X_n'$", f"$x_n$  [µm] {ASSUMED_MARK}"),
        "hist": (r"time  $\theta/2\pi$  [cycles]", r"contact force  $\Phi$", f"$F_n$  [N] {ASSUMED_MARK}"),
        "sect": (
            r"phase in the cycle  $\theta/2\pi$",
            r"$\Phi$  on  $\sigma_d$",
            r"$\Phi$  on  $\sigma_b$",
        ),
    }[name[:4]]
    for label in expected:
        assert label in said


def test_boundaries_of_the_gap_are_drawn_where_they_are() -> None:
    motions = around_grazing()
    figure = FIGURES["portraits"]()
    for axes, motion in zip(panels(figure)[:3], motions, strict=True):
        places = {float(line.get_xdata()[0]) for line in axes.lines if len(set(line.get_xdata())) == 1}  # pyright: ignore
        assert motion.gap_plus in places
        assert -motion.gap_minus in places


def test_a_zoom_holds_the_touch_in_its_middle_and_what_is_missed_beside_it() -> None:
    before, at, after = around_grazing()
    zoom = panels(FIGURES["portraits"]())[3:]
    assert at.touch is not None
    for axes in zoom:
        low, high = axes.get_xlim()
        assert (low + high) / 2 == pytest.approx(at.touch.displacement, abs=1e-9)
        assert low < before.displacement.min() < after.displacement.min() < high


def test_zones_are_drawn_as_bands_with_their_ends() -> None:
    _, found = zoned()
    figure = FIGURES["zone-bands"]()
    upper, lower = figure.axes[0], panels(figure)[-1]
    bands = [(r.get_x(), r.get_x() + r.get_width()) for r in upper.patches if isinstance(r, Rectangle)]
    expected = [(z.lower.value, z.upper.value) for kind in found for z in (*kind.zones, *kind.wider)]
    assert np.allclose(sorted(bands), sorted(expected), rtol=1e-14)
    ends = {float(x) for line in upper.lines for x in np.atleast_1d(line.get_xdata())}
    solved = {e.value for kind in found for z in kind.zones for e in (z.lower, z.upper) if e.bounded}
    assert solved
    assert solved <= ends
    assert any(np.all(np.asarray(line.get_xdata()) == 1.047) for line in lower.lines), "the present value"
    assert "no impacts, every" in words(figure)
    assert "grazing, solved for" in words(figure)
    assert "pinion speed  [rpm]" in words(figure)


def points_of(line: Line2D) -> np.ndarray:
    """(m, 2): what a line goes through."""
    return np.column_stack([np.asarray(part, dtype=float) for part in line.get_data()])


def test_a_branch_is_solid_where_stable_with_markers_at_its_special_points() -> None:
    made, figure = branch(), FIGURES["branches"]()
    upper = panels(figure)[0]
    lines = [line for line in upper.lines if len(np.asarray(line.get_xdata())) > 2]
    for name in ("minimum", "maximum"):
        for value, height, stable in zip(
            *(made[key].values for key in ("omega", name, "stable")), strict=True
        ):
            on = [
                line for line in lines if np.abs(points_of(line) - (value, height)).max(axis=1).min() < 1e-12
            ]
            assert {line.get_linestyle() == "-" for line in on} == {stable}
    assert {line.get_linestyle() for line in lines} == {"-", "--"}
    marked = {
        float(np.asarray(m.get_xdata())[0]): m.get_marker() for m in upper.lines if m.get_marker() != "None"
    }
    kinds = dict(zip(made["special_value"].values, made["special_kind"].values, strict=True))
    names = {"grazing": "v", "doubling": "o", "fold": "D"}
    assert {value: names[str(kind)] for value, kind in kinds.items()} == marked
    assert {"stable", "unstable", "grazing", "doubling", "1-0-0", "1-1-0", "swept: cold, up, down"} <= words(
        figure
    )
    assert "The window of article" in words(figure)
    assert "pinion speed  [rpm]" in words(figure)


def test_a_branch_is_drawn_through_every_orbit_that_was_computed() -> None:
    made = branch()
    upper = panels(FIGURES["branch-force"]())[0]
    drawn = np.concatenate([points_of(line) for line in upper.lines])
    for value, force in zip(made["omega"].values, made["force_max"].values, strict=True):
        assert np.abs(drawn - (value, force)).max(axis=1).min() < 1e-12


def test_a_part_of_a_branch_is_drawn_as_high_as_what_attracts_there() -> None:
    figure = plots.branch_diagram([branch()], "minimum", span=(1.0, 1.1), cloud=dataset())
    (upper,) = panels(figure)
    low, high = upper.get_ylim()
    inside = (branch()["omega"].values > 1.0) & (branch()["omega"].values < 1.1)
    least = branch()["minimum"].values[inside]
    assert upper.get_xlim() == (1.0, 1.1)
    assert low < least.min() < least.max() < high < 1.5 * least.max()
    with pytest.raises(gl.GearlashError, match="span"):
        plots.branch_diagram([branch()], span=(1.1, 1.0))


def test_every_kind_of_special_point_has_a_marker_of_its_own() -> None:
    markers = [MARKERS[str(kind)] for kind in gl.SpecialKind]
    assert len(set(markers)) == len(markers)
    assert OTHER_MARKER not in markers


def test_branches_over_different_parameters_are_refused() -> None:
    with pytest.raises(gl.GearlashError, match="over different parameters: omega, D"):
        plots.branch_diagram([branch()], cloud=dataset("D"))
    with pytest.raises(gl.GearlashError, match="not a dataset of a branch"):
        plots.branch_diagram([dataset()])
    with pytest.raises(gl.GearlashError, match="measure"):
        plots.branch_diagram([branch()], "forces")


def test_the_legend_of_zones_lies_inside_the_page() -> None:
    figure = FIGURES["zone-bands"]()
    figure.draw_without_rendering()
    (legend,) = figure.legends
    box, page = legend.get_window_extent(), figure.bbox
    assert page.x0 <= box.x0
    assert box.x1 <= page.x1
    assert box.y0 >= page.y0 - 1.0
    assert all(box.y1 <= a.get_window_extent().y0 for a in figure.axes)


def test_a_study_without_motion_is_refused_and_one_with_some_is_drawn() -> None:
    case = gl.load_case("kahraman-singh")
    none = gl.sweeps(case, gl.Axis("D", np.array([-2.0, -1.0])), ("cold", "up"))
    with pytest.raises(gl.GearlashError, match="nothing to draw"):
        plots.diagram(gl.sweep_dataset(case, none))
    some = gl.sweeps(case, gl.Axis("D", np.array([-1.0, 0.5, 1.0])), ("cold",))
    low, high = plots.diagram(gl.sweep_dataset(case, some)).axes[0].get_xlim()
    assert (low, high) == (0.5, 1.0)


def _legend(figure: Figure) -> set[str]:
    return {
        text.get_text() for legend in figure.legends for text in (*legend.get_texts(), legend.get_title())
    }


def test_a_legend_names_what_is_in_the_figure_and_no_more() -> None:
    """Of a motion that stays far from the gap neither that nor its boundaries."""
    case = gl.load_case("kahraman-singh", {"omega": 0.5})
    family, _ = case.family()
    far, near = (
        gl.motion(gl.attractor(family.system({"load": load}), family.start({"load": load})))
        for load in (0.8, 0.1)
    )
    assert far.displacement.min() > 1.5 * far.gap_plus
    gap, boundaries = r"gap,  $-D \leq X_n \leq D$", r"boundaries $\pm D$"
    assert gap not in _legend(plots.portrait(far))
    assert boundaries not in _legend(plots.history(far))
    hitting = gl.motion(gl.attractor(family.system({"omega": 0.8}), [3.0, 0.0]))
    assert hitting.displacement.min() < hitting.gap_plus
    assert gap in _legend(plots.portrait(hitting))
    assert boundaries in _legend(plots.history(hitting))
    assert near.displacement.min() > near.gap_plus
    assert gap in _legend(plots.gallery([far, hitting]))


def test_a_title_stands_in_place_of_value_and_label_and_an_assumed_scale_is_explained() -> None:
    case = gl.load_case("article")
    found = gl.motion(gl.attractor(case.family()[0].system(), case.family()[0].start()))
    for draw in (plots.portrait, plots.history):
        figure = draw(found, units(), title="drive:  1-0\n4000 rpm, 5 % more")
        assert figure.axes[0].get_title(loc="left") == r"drive:  1-0" + "\n" + r"4000 rpm, 5 % more"
        assert any("assumed value" in text for text in _legend(figure))
        assert not any("assumed value" in text for text in _legend(draw(found)))


def test_residuals_have_the_markers_of_what_was_measured() -> None:
    values = [3.0, 4.0, 3.2, 4.1]
    figure = plots.overlay(
        [1, 2, 1, 2], values, values, values, "speed", "force", directions=["up"] * 2 + ["down"] * 2
    )
    upper, lower = ({str(line.get_marker()) for line in axes.lines} - {"None", ""} for axes in figure.axes)
    assert upper == lower == {"^", "v"}


def test_a_long_note_breaks_into_lines_and_leaves_the_legend_its_columns() -> None:
    handles = [Line2D([], [], label=f"curve {i}") for i in range(8)]
    made = []
    for note in ("short", "words that say much " * 20):
        figure = style.figure(style.PAGE, 60.0)
        figure.subplots()
        legend_below(figure, handles, note, columns=4, room=15.0)
        made.append(figure)
    short, long = (each.legends[0] for each in made)
    assert long._ncols == short._ncols == 4
    box = long.get_window_extent(FigureCanvasAgg(made[1]).get_renderer())
    assert 0.0 < box.width <= made[1].bbox.width
    assert "\n" in long.get_title().get_text()


def test_small_exponents_fill_their_panel() -> None:
    """Those of a pair with little damping are a few thousandths, of either sign."""
    data = dataset().copy(deep=True)
    values = np.linspace(-2e-3, 2e-4, data["largest_exponent"].size)
    data["largest_exponent"].values[:] = values.reshape(data["largest_exponent"].shape)
    data["exponent_error"].values[:] = 1e-5
    low, high = plots.diagram(data).axes[5].get_ylim()
    assert -2.8e-3 < low < -1.9e-3
    assert 2.1e-4 < high < 1e-3
