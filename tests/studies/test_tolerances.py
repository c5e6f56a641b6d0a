"""Impact-free bands in spite of tolerances: closed forms, brute force, the same bytes from any workers."""

import threading
from itertools import product
from math import log, nan, pi, prod
from pathlib import Path

import numpy as np
import pytest

import gearlash as gl
from gearlash.case import loads
from gearlash.cli.answers.tolerance import chance_text, tolerance_answer
from gearlash.results.tolerance import ToleranceInput
from gearlash.studies.impact_free import closed_margin
from gearlash.studies.tolerances.bands import outside, positive_bands, shared
from gearlash.studies.tolerances.influence import (
    combinations,
    groups,
    influences,
    share_and_error,
    why_none,
)
from gearlash.studies.tolerances.inputs import check_possible, ranged_inputs, read_inputs
from gearlash.studies.tolerances.worst import LAST_STEP, MOST, worst_from
from gearlash.studies.worst_of_ranges import margin_of

DRIVE = Path(__file__).parents[1] / "cases" / "drive.toml"
LINEAR = """
kind = "spur-1dof"
[dimensionless]
omega = 0.6
D = 1
load = 0.2
error = 0.1
mesh_damping = 0.05
"""


def opens(load: float, error: float) -> tuple[float, float]:
    """Where ω² E / |1 - ω² + 2iξω| = f_m: both ends of the band around ω = 1 in which teeth part."""
    # ω⁴ E² = f² ((1 - ω²)² + 4ξ²ω²), a quadratic in ω²
    a = error**2 - load**2
    b = load**2 * (2.0 - 4.0 * 0.05**2)
    roots = np.sort(np.roots([a, b, -(load**2)]).real)
    return tuple(float(x) for x in np.sqrt(roots[roots > 0.0]))  # type: ignore[return-value]


def test_limits_of_a_case_file_are_those_that_are_taken_where_none_are_given():
    """Both ends of the band in which teeth part, at the worst of all limits, by the closed form."""
    case = loads(
        LINEAR.replace("load = 0.2", 'load = "0.15:0.3"').replace("error = 0.1", "error = [0.08, 0.12]")
    )
    axis = gl.Axis.even("omega", 0.5, 3.2, 3)
    found = gl.tolerance(case, axis, samples=2, replicates=2)
    low, high = opens(0.15, 0.12)
    assert found.always == (pytest.approx((0.5, low), abs=1e-9), pytest.approx((high, 3.2), abs=1e-9))
    assert [one.reason for one in found.inputs] == ["limits of the case file"] * 2
    assert [(one.path, one.nominal) for one in found.inputs] == [
        ("dimensionless.load", 0.225),
        ("dimensionless.error", 0.1),
    ]
    given = gl.tolerance(case, axis, {"load": "0.15 to 0.3", "error": "0.1 ± 20 %"}, samples=2, replicates=2)
    assert given.always == found.always
    assert [one.reason for one in given.inputs] == ["stated"] * 2


def test_the_quantity_of_the_axis_is_left_out_of_the_limits_of_the_case():
    case = loads(
        LINEAR.replace("load = 0.2", 'load = "0.15:0.3"').replace("error = 0.1", "error = [0.08, 0.12]")
    )
    found = gl.tolerance(case, gl.Axis.even("load", 0.02, 0.3, 3), samples=2, replicates=2)
    assert [one.path for one in found.inputs] == ["dimensionless.error"]
    amplitude = 0.6**2 / abs(1.0 - 0.6**2 + 2j * 0.05 * 0.6)
    assert found.always == (pytest.approx((0.12 * amplitude, 0.3), rel=1e-9),)
    with pytest.raises(gl.GearlashError, match="cannot have limits as well"):
        gl.tolerance(case, gl.Axis.even("load", 0.1, 0.3, 3), {"load": (0.1, 0.2)})
    alone = case.with_overrides({"error": 0.1})
    with pytest.raises(gl.GearlashError, match="nothing but load, the axis of the study, has limits"):
        gl.tolerance(alone, gl.Axis.even("load", 0.1, 0.3, 3))


def test_what_is_no_parameter_of_the_model_is_an_axis_too():
    """The end of a band over mean stiffness is where teeth of a case with it are pressed together no more."""
    case = gl.load_case(DRIVE, {"torque": "85 N m"}).varying("mean_stiffness")
    axis = gl.Axis.even("mean_stiffness", "3e8 N/m", "6e8 N/m", 4)
    found = gl.tolerance(case, axis, {"mesh.damping_ratio": "0.05 ± 1 %"}, samples=2, replicates=2)
    ((low, end),) = found.nominal.bands
    assert low == 3e8
    assert 3e8 < end < 6e8
    assert abs(margin_of(case, {"mesh.mean_stiffness": f"{end!r} N/m"})) < 1e-9
    teeth = gl.Axis("pinion.teeth", np.array([25.0, 27.0]))
    with pytest.raises(gl.GearlashError, match="is of whole numbers"):
        gl.tolerance(case.varying("pinion.teeth"), teeth, {"mesh.damping_ratio": (0.04, 0.05)})


@pytest.mark.slow
def test_bands_of_a_linear_mesh_are_those_of_the_closed_form():
    case = loads(LINEAR)
    axis = gl.Axis.even("omega", 0.5, 3.2, 3)
    limits = {"load": (0.15, 0.3), "error": (0.08, 0.12)}
    found = gl.tolerance(case, axis, limits, samples=2, replicates=2)
    low, high = opens(0.15, 0.12)
    assert found.always == (
        pytest.approx((0.5, low), abs=1e-9),
        pytest.approx((high, 3.2), abs=1e-9),
    )
    inside, beyond = opens(0.3, 0.08)
    assert found.never == (pytest.approx((inside, beyond), abs=1e-9),)
    assert found.worst.inputs == pytest.approx((0.15, 0.12))
    assert found.settings_of_worst == {"dimensionless.load": "0.15", "dimensionless.error": "0.12"}
    assert (found.corners, found.unsolved, found.complete) == (4, 0, True)
    assert (found.tried, found.here) == (1 + 4 + 4, 1.0)


@pytest.mark.slow
def test_a_study_that_was_stopped_counts_what_was_tried():
    cancel = threading.Event()
    execution = gl.Execution(progress=lambda progress: cancel.set(), cancel=cancel)
    axis, limits = gl.Axis.even("omega", 0.5, 3.2, 3), {"load": (0.15, 0.3), "error": (0.08, 0.12)}
    found = gl.tolerance(loads(LINEAR), axis, limits, samples=8, replicates=2, execution=execution)
    assert (found.complete, found.message) == (False, "cancelled")
    assert 0 < found.tried < 16


@pytest.mark.slow
def test_the_probability_is_that_of_brute_force():
    case = loads(LINEAR)
    axis = gl.Axis.even("omega", 0.8, 0.95, 4)
    limits = {"load": (0.1, 0.3), "error": (0.05, 0.15)}
    found = gl.tolerance(case, axis, limits, samples=16, replicates=4)
    assert found.profile is not None  # in pieces between solved ends: at the axis it is what is told there
    edges, pieces = np.array(found.profile.edges), np.array(found.profile.probability)
    at = np.clip(np.searchsorted(edges, axis.values) - 1, 0, None)
    assert pieces[at] == pytest.approx(np.array(found.probability), abs=1e-12)
    middle = (np.arange(400) + 0.5) / 400
    load, error = (np.ravel(x) for x in np.meshgrid(0.1 + 0.2 * middle, 0.05 + 0.1 * middle))
    for omega, share, spread in zip(axis.values, found.probability, found.probability_error, strict=True):
        response = omega**2 * error / abs(1.0 - omega**2 + 0.1j * omega)
        assert share == pytest.approx(np.mean(response < load), abs=4.0 * spread + 0.03)


@pytest.mark.slow
def test_the_probability_between_values_of_the_axis_is_that_of_the_ends():
    """An axis of two values only: around the resonance between them teeth part with either load."""
    case, axis = loads(LINEAR), gl.Axis.even("omega", 0.5, 3.2, 2)
    found = gl.tolerance(case, axis, {"load": (0.15, 0.3)}, samples=4, replicates=2)
    assert found.profile is not None
    edges, share = np.array(found.profile.edges), np.array(found.profile.probability)
    first, last = opens(0.15, 0.1)[0], opens(0.3, 0.1)[0]
    none = edges[np.flatnonzero(share == 0.0)[0]]
    assert share[0] == share[-1] == 1.0
    assert share[np.searchsorted(edges, 1.0) - 1] == 0.0
    assert first <= edges[1] <= none <= last
    assert np.diff(share)[edges[1:-1] <= none].tolist() == [-0.125] * 8


def test_indices_of_a_known_function():
    """x1 + 2 x2: first and total are 1/5 and 4/5."""
    inputs = ("one", "two", "none")
    columns = [(0,), (1,), (2,)]
    sampled = [combinations(np.random.default_rng(seed).random((2, 512, 3)), columns) for seed in range(8)]
    sets = [points[..., 0] + 2.0 * points[..., 1] for points in sampled]
    first, second, third = influences(inputs, sets)
    assert [first.path, second.path] == ["two", "one"]
    assert first.total == pytest.approx(0.8, abs=0.1)
    only = [np.array(each) for each in (points[..., 1] for points in sampled)]
    alone, *others = influences(inputs, only)
    assert (alone.path, alone.first, alone.total) == ("two", 1.0, 1.0)  # with any samples
    assert [(one.first, one.total) for one in others] == [(0.0, 0.0)] * 2
    assert first.total == pytest.approx(0.8, abs=4.0 * first.total_error)
    assert second.first == pytest.approx(0.2, abs=4.0 * second.first_error)
    assert third.total == pytest.approx(0.0, abs=1e-12)


def test_harmonics_of_one_curve_share_an_influence():
    """x1 + 2 x2 + x3 x4, the last two together: their share is that of their product, 1/9 by the variances
    1/12, 4/12 and 1/9 - 1/16."""
    inputs = [gl.ToleranceInput(name, "", 0.0, 1.0, 0.5) for name in ("one", "two")]
    inputs += [gl.ToleranceInput(name, "", 0.0, 1.0, 0.5, curve="c") for name in ("c", "c_2")]
    together = groups(inputs)
    assert together == {"one": (0,), "two": (1,), "c": (2, 3)}
    sampled = [
        combinations(np.random.default_rng(seed).random((2, 512, 4)), together.values()) for seed in range(8)
    ]
    assert sampled[0].shape == (5, 512, 4)
    sets = [x[..., 0] + 2.0 * x[..., 1] + x[..., 2] * x[..., 3] for x in sampled]
    variances = {"one": 1.0 / 12.0, "two": 4.0 / 12.0, "c": 1.0 / 9.0 - 1.0 / 16.0}
    for row in influences(together, sets):
        share = variances[row.path] / sum(variances.values())
        assert row.first == pytest.approx(share, abs=4.0 * row.first_error)
        assert row.total == pytest.approx(share, abs=4.0 * row.total_error)
        assert row.total_error < 0.05


def test_all_that_a_drawing_leaves_open_is_varied():
    """Of a helical pair on bearings more than twenty values; harmonics of the stiffness are one curve."""
    case = gl.load_case(Path(__file__).parents[1] / "cases" / "drawing.toml")
    inputs = read_inputs(case, None)
    assert inputs == ranged_inputs(case)
    ranged = [value.path for value in case.values() if value.least is not None]
    assert [one.path for one in inputs] == ranged
    assert len(inputs) > 20
    ripple = [one for one in inputs if one.path.startswith("mesh.ripple")]
    assert len(ripple) > 4
    assert {one.curve for one in ripple} == {"mesh.ripple"}
    assert {one.curve for one in inputs if one not in ripple} == {""}


def test_where_no_share_can_be_told_it_is_told_why():
    values = np.zeros((2, 4, 8))
    values[0, 1, 2] = -np.inf
    assert why_none(list(values)) == "in 1 of 64 samples that motion is unstable, and has no margin"
    assert why_none(list(np.where(values < 0.0, np.nan, values))).endswith("was not solved for")
    assert why_none(list(np.zeros((2, 4, 8)))) == "the margin is the same in all samples"
    one = gl.tolerance(
        loads(LINEAR), gl.Axis.even("omega", 0.55, 0.65, 2), {"load": (0.15, 0.3)}, samples=2, replicates=2
    )
    assert (one.influences, one.no_influences) == ((), "all of it is of one input")


def test_indices_and_the_worst_corner_of_a_linear_mesh_are_those_of_the_closed_form():
    """Its least compression is load - c error, with c = ω² / |1 - ω² + 2iξω|: over the static one, which is
    the load, 1 - c error / load, a product."""
    case, axis = loads(LINEAR), gl.Axis.even("omega", 0.55, 0.65, 2)
    limits = {"load": (0.15, 0.3), "error": (0.05, 0.3)}
    found = gl.tolerance(case, axis, limits, samples=32, replicates=4)
    c = 0.6**2 / abs(1.0 - 0.6**2 + 2j * 0.05 * 0.6)
    means = {"dimensionless.load": log(0.3 / 0.15) / 0.15, "dimensionless.error": 0.175}
    squares = {"dimensionless.load": 1.0 / (0.15 * 0.3), "dimensionless.error": 0.175**2 + 0.25**2 / 12.0}
    whole = prod(squares.values()) - prod(means.values()) ** 2
    for one, other in zip(found.influences, reversed(found.influences), strict=True):
        part = means[other.path] ** 2 * (squares[one.path] - means[one.path] ** 2)
        rest = means[one.path] ** 2 * (squares[other.path] - means[other.path] ** 2)
        assert one.first == pytest.approx(part / whole, abs=4.0 * one.first_error)
        assert one.total == pytest.approx(1.0 - rest / whole, abs=4.0 * one.total_error)
        assert one.total_error < 0.2
    worst = case.with_overrides(dict(found.settings_of_worst)).family()[0].system()
    assert closed_margin(worst, 1) == pytest.approx(0.15 - 0.3 * c, abs=1e-9)
    assert found.worst.margin == pytest.approx(0.15 - 0.3 * c, abs=1e-9)


def test_a_case_outside_its_limits_is_told_beside_them():
    case, axis = loads(LINEAR), gl.Axis.even("omega", 0.55, 0.65, 2)
    found = gl.tolerance(case, axis, {"load": (0.25, 0.3)}, samples=2, replicates=2)
    assert found.worst.inputs == (0.25,)  # and not the 0.2 of the case
    assert found.nominal.margin < found.worst.margin
    assert found.tried == 2 + 4


def test_what_is_estimated_and_not_varied_stays_as_it_is():
    case = gl.load_case(Path(__file__).parents[1] / "cases" / "drawing.toml")
    axis = gl.Axis.even("pinion_speed", "1000 rpm", "1030 rpm", 2)
    value = next(float(v.value) for v in case.values() if v.path == "mesh.ripple_2")
    around = sorted((0.999 * value, 1.001 * value))
    found = gl.tolerance(case, axis, {"mesh.ripple_2": around}, samples=2, replicates=2)
    assert found.worst.margin == pytest.approx(found.nominal.margin, rel=2e-3)


def test_a_drive_in_its_units_and_the_margin_at_the_corners():
    case = gl.load_case(DRIVE)
    axis = gl.Axis.even("pinion_speed", "4100 rpm", "4300 rpm", 3)
    limits = {"backlash": ("60 um", "120 um"), "torque": "100:250Nm"}
    found = gl.tolerance(case, axis, limits, samples=8, replicates=2)
    assert found.present == pytest.approx(4200.0)
    margins = []
    for backlash, torque in product((60, 120), (100, 250)):
        settings = {"backlash": f"{backlash} um", "torque": f"{torque} N m"}
        member = case.with_overrides(settings)
        margin = closed_margin(member.family()[0].system(), 1)
        margins.append(float(member.scales.length_m(margin)))
    assert found.worst.compression == pytest.approx(min(margins), rel=1e-6)
    indices = {one.path: one for one in found.influences}
    assert indices["mesh.backlash"].total < 1e-12  # it does not matter while the back side is never met
    assert indices["operation.torque"].total == pytest.approx(1.0, abs=0.4)
    with gl.open_workers(case, 2) as workers:
        again = gl.tolerance(
            case, axis, limits, samples=8, replicates=2, execution=gl.Execution(executor=workers)
        )
    assert repr(again) == repr(found)


@pytest.mark.slow
def test_ranges_of_what_a_drawing_leaves_open_are_taken_by_themselves():
    case = gl.load_case(Path(__file__).parents[1] / "cases" / "drawing.toml")
    axis = gl.Axis.even("pinion_speed", "1000 rpm", "1030 rpm", 2)
    found = gl.tolerance(case, axis, samples=2, replicates=2)
    assert "mesh.mean_stiffness" in {one.path for one in found.inputs}
    assert all(one.reason for one in found.inputs)


def test_what_does_not_depend_on_a_value_is_looked_at_once_each():
    looked: list[float] = []

    def flat(at: float) -> float:
        looked.append(at)
        return 0.9 + 1e-15 * (len(looked) % 3)  # and its rounding

    assert positive_bands(flat, [0.0, 1.0, 2.0, 3.0, 4.0]) == ((0.0, 4.0),)
    assert looked == [0.0, 1.0, 2.0, 3.0, 4.0]


def test_bands_of_a_function_with_a_dip_between_two_values():
    def height(x: float) -> float:
        return (x - 0.5031) ** 2 - 1e-6

    values = np.linspace(0.0, 1.0, 11).tolist()
    assert positive_bands(height, values) == (
        pytest.approx((0.0, 0.5021)),
        pytest.approx((0.5041, 1.0)),
    )
    (peak,) = positive_bands(lambda x: -height(x), values)
    assert peak == pytest.approx((0.5021, 0.5041))
    assert positive_bands(lambda x: -1.0, values) == ()
    (half,) = positive_bands(lambda x: 1.0 if x > 0.3 else -np.inf, values)
    assert half == pytest.approx((0.3, 1.0))


def test_what_rows_share_and_what_none_has():
    rows = [[(0.0, 2.0), (3.0, 5.0)], [(1.0, 4.0)]]
    assert shared(rows) == ((1.0, 2.0), (3.0, 4.0))
    assert outside(rows, -1.0, 6.0) == ((-1.0, 0.0), (5.0, 6.0))


@pytest.mark.parametrize(
    ("limits", "message"),
    [
        ({}, "expected at least one"),
        ({"lod": (1, 2)}, "did you mean 'load'"),
        ({"load": (1,)}, "two limits"),
        ({"load": "0.1"}, "two limits"),
        ({"load": "0.1:"}, "two limits"),
        ({"load": ("1 N", 2)}, "load"),
        ({"load": (0.2, 0.2)}, "two different limits"),
        ({"omega": (0.5, 0.6)}, "is the axis of the study"),
        ({"load": (0.1, 0.2), "dimensionless.load": (0.1, 0.3)}, "one of two that name the same quantity"),
        ({"model.contact": ("always", "in-contact")}, "not of an option"),
    ],
)
def test_limits_that_do_not_fit_are_refused(limits: dict[str, tuple[float, float]], message: str):
    with pytest.raises(gl.GearlashError, match=message):
        gl.tolerance(loads(LINEAR), gl.Axis.even("omega", 0.5, 0.9, 3), limits, samples=2, replicates=2)


@pytest.mark.parametrize(
    ("axis", "limits", "message"),
    [
        ("pinion_speed=3400:4400rpm", {"omega": (0.5, 0.6)}, "pinion_speed is the axis of the study"),
        (
            "pinion_speed=3400:4400rpm",
            {"gear_speed": "1400:1500rpm"},
            "pinion_speed is the axis of the study",
        ),
        ("omega=0.9:1.1", {"pinion_speed": "3400:4400rpm"}, "omega is the axis of the study"),
        ("torque=90:110N*m", {"load": (0.08, 0.1)}, "torque is the axis of the study"),
        ("load=0.08:0.1", {"power": "30:40kW"}, "load is the axis of the study"),
        ("omega=0.9:1.1", {"D": (0.8, 1.0), "backlash": "60:80um"}, "two that name the same quantity"),
        ("omega=0.9:1.1", {"torque": "90:110N*m", "load": (0.08, 0.1)}, "two that name the same quantity"),
        ("omega=0.9:1.1", {"torque": "90:110N*m", "power": "30:40kW"}, "two that name the same quantity"),
        ("omega=0.9:1.1", {"loaded_error": "1:2um", "error_phase": (0.1, 0.2)}, "loaded_error"),
    ],
)
def test_a_quantity_has_limits_once_under_whatever_name(axis: str, limits: dict[str, str], message: str):
    name, _, ends = axis.partition("=")
    low, high = ends.split(":")
    unit = high.lstrip("0123456789.")
    values = (
        gl.Axis.even(name, f"{low} {unit}", high, 3)
        if unit
        else gl.Axis.even(name, float(low), float(high), 3)
    )
    with pytest.raises(gl.GearlashError, match=message):
        gl.tolerance(gl.load_case("article"), values, limits, samples=2, replicates=2)


@pytest.mark.parametrize(
    ("case", "message"),
    [
        ("shaw-holmes", "is no gear pair"),
        ("article", "expected a power of 2"),
    ],
)
def test_cases_and_counts_that_do_not_fit_are_refused(case: str, message: str):
    axis = gl.Axis.even("omega", 0.5, 0.9, 3)
    with pytest.raises(gl.GearlashError, match=message):
        gl.tolerance(gl.load_case(case), axis, {"omega": (0.1, 0.2)}, samples=3)


def test_limits_of_which_one_corner_exists_are_not_refused():
    """A bore and a rim between the same limits: least, middle and greatest values together leave no rim, the
    least bore with the greatest rim does. With every bore above every rim nothing exists."""
    case = gl.load_case(
        DRIVE.parent / "drawing.toml", {"gear.rim_diameter": "150 mm", "gear.web_width": "12 mm"}
    )
    rim = ToleranceInput("gear.rim_diameter", "mm", 40.0, 60.0, 50.0)
    check_possible(case, (ToleranceInput("gear.bore", "mm", 40.0, 60.0, 50.0), rim))
    with pytest.raises(gl.GearlashError, match="a diameter below that of its rim"):
        check_possible(case, (ToleranceInput("gear.bore", "mm", 61.0, 70.0, 65.0), rim))


def test_a_resonance_between_two_values_of_the_axis_is_seen():
    """The axis has its two ends only; teeth part around omega = 1 between them."""
    found = gl.tolerance(
        loads(LINEAR), gl.Axis.even("omega", 0.6, 1.6, 2), {"D": (0.5, 1.0)}, samples=2, replicates=2
    )
    low, high = opens(0.2, 0.1)
    assert found.nominal.bands == (pytest.approx((0.6, low)), pytest.approx((high, 1.6)))


def test_what_few_samples_that_agree_bound():
    assert chance_text(1.0, 0.0, 256) == "of at least 98.8 %"
    assert chance_text(0.0, 0.0, 8) == "of at most 31.3 %"
    assert chance_text(0.75, 0.02, 64) == "75 ± 2 %"


def test_the_worst_combination_is_at_a_limit_and_inside_and_no_single_value_is_worse():
    """Least where x = 0.37 inside, y at its lower and z at its upper limit, which matter only together."""
    inputs = [gl.ToleranceInput(name, "", 0.0, 1.0, 0.5) for name in "xyz"]
    looked = []

    def heights(rows):
        looked.extend(rows)
        return [(x - 0.37) ** 2 + y - 0.4 * z * (1.5 - y) + 0.1 * z for x, y, z in rows]

    begin = (0.9, 0.6, 0.1)
    x, y, z = worst_from(begin, heights([begin])[0], inputs, heights)
    assert (y, z) == (0.0, 1.0)
    assert x == pytest.approx(0.37, abs=2.0 * LAST_STEP)
    assert len(looked) < MOST


def test_what_cannot_be_solved_for_is_no_worst_combination():
    """Beyond 0.9 of x there is no height; z does not matter and ends at its upper limit."""
    inputs = [gl.ToleranceInput(name, "", 0.0, 1.0, 0.5) for name in "xyz"]

    def heights(rows):
        return [np.inf if x > 0.9 else x + y for x, y, _ in rows]

    assert worst_from((0.5, 0.5, 0.3), 1.0, inputs, heights) == (0.0, 0.0, 1.0)


def test_a_search_that_is_stopped_keeps_what_it_has():
    inputs = [gl.ToleranceInput("x", "", 0.0, 1.0, 0.5)]
    assert worst_from((0.5,), 1.0, inputs, lambda _rows: []) == (0.5,)


def test_the_worst_of_a_mesh_lies_at_no_better_place_than_any_of_its_limits():
    case, axis = loads(LINEAR), gl.Axis.even("omega", 0.55, 0.65, 3)
    limits = {"load": (0.1, 0.3), "error": (0.05, 0.15), "mesh_damping": (0.03, 0.1)}
    found = gl.tolerance(case, axis, limits, samples=2, replicates=2)
    assert found.worst.inputs == pytest.approx((0.1, 0.15, 0.03))


def test_shares_are_possible_ones():
    """Indices of few samples lie between none and all, alone no more than in all; and sets that agree by
    chance do not make a share exact."""
    rng = np.random.default_rng(3)
    points = [combinations(rng.uniform(size=(2, 4, 2)), [(0,), (1,)]) for _ in range(3)]
    for row in influences("ab", [x[..., 0] + 1e-3 * x[..., 1] for x in points]):
        assert 0.0 <= row.first <= row.total <= 1.0
    held = np.repeat([[1.0, 1.0, 1.0, 0.0]], 4, axis=0)
    share, error = share_and_error(held)
    assert (float(share), 0.02 < float(error) < 0.1) == (0.75, True)


def test_it_prints_in_a_few_lines():
    case = gl.load_case("kahraman-singh")
    limits = {"load": (0.1, 0.3)}
    found = gl.tolerance(case, gl.Axis.even("omega", 0.5, 0.9, 5), limits, samples=2, replicates=2)
    assert len(repr(found)) < 500
    assert "<table>" in found._repr_html_()


@pytest.mark.parametrize(
    ("limits", "path", "nominal"),
    [
        ({"error_phase": "-180:180deg"}, "mesh.error_phase", 90.0),
        ({"error_phase": (0.0, 1.0)}, "dimensionless.error_phase", pi / 2.0),
        ({"ripple": "-0.3:-0.1"}, "mesh.ripple", 0.12),
        ({"D": (0.2, 0.4)}, "dimensionless.D", 1.0),
        ({"gear_torque": "100:300Nm"}, "operation.gear_torque", 150.0 * 57.0 / 25.0),
        ({"power": "10:60kW"}, "operation.power", 150.0 * 4200.0 * pi / 30.0 / 1e3),
        ({"backlash_circumferential": "50:200um"}, "mesh.backlash_circumferential", nan),
    ],
)
def test_the_value_of_the_case_in_the_form_of_the_limits(limits: dict[str, str], path: str, nominal: float):
    (one,) = read_inputs(gl.load_case(DRIVE), limits)
    assert (one.path, one.nominal) == (path, pytest.approx(nominal, rel=1e-12, nan_ok=True))


def test_what_the_case_has_in_no_form_is_no_start_of_the_search():
    speeds = gl.Axis.even("pinion_speed", "4000 rpm", "4200 rpm", 2)
    limits = {"backlash_circumferential": "50:200um", "error": "5:20um"}
    found = gl.tolerance(gl.load_case(DRIVE), speeds, limits, samples=2, replicates=2)
    assert set(found.settings_of_worst) == {"mesh.backlash_circumferential", "mesh.error"}
    inputs = {one.path: one for one in tolerance_answer(gl.load_case(DRIVE), found).inputs}
    assert inputs["mesh.backlash_circumferential"].nominal is None
    assert inputs["mesh.error"].nominal == 8.0
