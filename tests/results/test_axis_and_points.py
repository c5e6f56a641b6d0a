"""Axes, and whether two points show the same attractor."""

from __future__ import annotations

import numpy as np
import pytest

from gearlash.results import Axis, Direction, Point, Sweep, blank, coexisting, same_motion
from gearlash.system import GearlashError, MotionKind, Signature, Status


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ([], "at least one value"),
        ([[1.0]], "shape"),
        ([1.0, np.nan], "NaN"),
        ([1.0, 1.0], "ascend"),
        ([2.0, 1.0], "ascend"),
    ],
)
def test_an_axis_must_ascend(values, text):
    with pytest.raises(GearlashError, match=text):
        Axis("D", np.array(values))


def test_an_axis_is_a_copy_that_cannot_be_changed():
    values = np.array([1.0, 2.0, 4.0])
    axis = Axis("D", values)
    values[0] = 9.0
    assert axis.values.tolist() == [1.0, 2.0, 4.0]
    assert axis.step == 2.0
    with pytest.raises(ValueError, match="read-only"):
        axis.values[0] = 0.0


def test_even_values_hold_both_ends_in_either_order():
    np.testing.assert_array_equal(Axis.even("D", 2.0, 1.0, 5).values, [1.0, 1.25, 1.5, 1.75, 2.0])
    for ends, count in (((1.0, 1.0), 2), ((1.0, 2.0), 1)):
        with pytest.raises(GearlashError, match="two different ends"):
            Axis.even("D", *ends, count)
    for count in (0, -3, 2.0, "5", True, None):
        with pytest.raises(GearlashError, match="whole number"):
            Axis.even("D", 1.0, 2.0, count)  # pyright: ignore[reportArgumentType]


def orbit(label: str, strobes, size: float = 1.0) -> Point:
    signature = Signature.parse(label)
    return Point(
        1.0, Status.OK, "", signature, signature.period, strobes=np.array(strobes), minimum=0.0, maximum=size
    )


def test_the_same_orbit_begun_elsewhere_is_the_same_motion():
    assert same_motion(orbit("2-1-0", [0.1, 0.5]), orbit("2-1-0", [0.5, 0.1 + 1e-9]))
    assert not same_motion(orbit("2-1-0", [0.1, 0.5]), orbit("2-1-0", [0.1, 0.501]))
    assert not same_motion(orbit("2-1-0", [0.1, 0.5]), orbit("2-2-0", [0.1, 0.5]))


def test_closeness_is_measured_by_the_size_of_the_motion():
    a, b = 1e-9, 2e-9
    assert same_motion(orbit("1-1-0", [a], 1.0), orbit("1-1-0", [b], 1.0))
    assert not same_motion(orbit("1-1-0", [0.0], 0.01), orbit("1-1-0", [1e-7], 0.01))


def test_what_was_not_computed_differs_from_nothing():
    assert same_motion(blank(1.0, Status.FAILED, "no"), orbit("1-1-0", [0.1]))
    axis = Axis("D", np.array([1.0]))
    rows = [
        Sweep(axis, Direction.COLD, (blank(1.0, Status.FAILED, "no"),)),
        Sweep(axis, Direction.UP, (orbit("1-1-0", [0.1]),)),
        Sweep(axis, Direction.DOWN, (orbit("1-0-0", [0.1]),)),
    ]
    assert coexisting(rows).tolist() == [True]
    assert coexisting(rows[:2]).tolist() == [False]


@pytest.mark.parametrize("label", ["unresolved", "neutral"])
def test_what_is_no_attractor_coexists_with_none(label: str):
    axis, other = Axis("D", np.array([1.0])), Point(1.0, Status(label), "", MotionKind(label), 0)
    rows = [Sweep(axis, Direction.COLD, (other,)), Sweep(axis, Direction.UP, (orbit("1-1-0", [0.1]),))]
    assert coexisting(rows).tolist() == [False]


def test_runs_of_one_label():
    axis = Axis("D", np.arange(5.0))
    points = (
        *(orbit(label, [0.0]) for label in ("1-0-0", "1-0-0", "1-1-0")),
        blank(3.0, Status.FAILED, ""),
        orbit("1-1-0", [0.0]),
    )
    sweep = Sweep(axis, Direction.COLD, points)
    assert sweep.runs() == [(0, 1, "1-0-0"), (2, 2, "1-1-0"), (3, 3, "failed"), (4, 4, "1-1-0")]
    assert sweep.statuses == {"ok": 4, "failed": 1}


@pytest.mark.parametrize(
    ("low", "high", "count"), [(-40.0, 180.0, 23), (-0.7, 0.3, 11), (-1e-6, 9e-6, 101), (-3.3, 6.6, 10)]
)
def test_an_even_axis_through_zero_has_zero(low: float, high: float, count: int):
    """And no other value moves: the distance from 0 to its neighbours is that of all."""
    values = Axis.even("load", low, high, count).values
    assert (values == 0.0).sum() == 1
    np.testing.assert_allclose(np.diff(values), (high - low) / (count - 1), rtol=1e-12)
    plain = np.linspace(low, high, count)
    np.testing.assert_array_equal(values[values != 0.0], plain[values != 0.0])
