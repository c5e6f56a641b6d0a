"""Rounding of the ends of intervals."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearlash.case.edges import rounded_edge, shown_distance, shown_edge, shown_interval

VALUES = st.floats(min_value=1e-6, max_value=1e6)


@pytest.mark.parametrize(
    ("value", "inwards", "text"),
    [
        (3714.859, 1, "3715"),
        (4247.6, -1, "4247"),
        (4247.6, 0, "4248"),
        (0.97248, 1, "0.9725"),
        (1.11204, -1, "1.112"),
        (80.0, 1, "80"),
        (80.0 * (1.0 + 1e-14), 1, "80"),
        (12129.3, 1, "12130"),
        (-0.12345, -1, "-0.1235"),
        (0.0, 1, "0"),
    ],
)
def test_ends_are_rounded_into_the_interval(value: float, inwards: int, text: str):
    assert shown_edge(value, inwards) == text


def test_the_present_value_stays_on_its_side():
    assert shown_edge(4114.082, 1, beside=4114.1) == "4114.082"
    assert shown_edge(4114.082, 1, beside=4200.0) == "4114.1"
    assert shown_edge(4114.082, 1, beside=6000.0) == "4115"
    assert shown_distance(4200.0, 4114.082, 1) == "85.9"


@given(VALUES, VALUES, st.sampled_from((-1, 1)))
def test_rounding_never_claims_more(value: float, beside: float, inwards: int):
    shown = rounded_edge(value, inwards, beside)
    assert (shown - value) * inwards >= -2e-9 * value
    assert float(shown_edge(value, inwards, beside)) == pytest.approx(shown, rel=1e-12)
    if abs(value - beside) > 1e-6 * value:
        assert (beside > value) == (beside > shown) or beside == shown


@given(VALUES, st.floats(min_value=1e-9, max_value=1.0), st.sampled_from((-1.0, 1.0)))
def test_an_interval_is_shown_within_itself_and_stays_one(value: float, width: float, sign: float):
    low, high = sorted((sign * value, sign * value * (1.0 + width)))
    shown = [float(text) for text in shown_interval(low, high, 6)]
    slack = 2e-9 * abs(value) + 1e-15
    assert low - slack <= shown[0] <= shown[1] + slack <= high + 2.0 * slack
    assert shown[0] - low <= max(1e-5 * abs(high), 1e-5 * abs(low), 1e-15)
    assert shown_interval(0.6, 0.681311956, 6) == ("0.6", "0.681311")
    assert shown_interval(0.6813531204, 0.6813679304, 6) == ("0.6813532", "0.6813679")
