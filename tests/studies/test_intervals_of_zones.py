"""Intervals of zones: their algebra, margins, and which motions coexist."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gearlash.studies import Interval, Quiet, ZoneEnd
from gearlash.studies.intervals import intersection, union
from gearlash.studies.zone import Zone, ZoneMotion
from gearlash.studies.zone_end import RANGE
from gearlash.studies.zone_end import Interval as Plain
from gearlash.system import Signature


def ends(pair: tuple[int, int]) -> Interval:
    low, high = sorted(pair)
    return Interval(ZoneEnd(float(low), "x"), ZoneEnd(float(high + 1), "x"))


ROWS = st.lists(
    st.lists(st.tuples(st.integers(0, 20), st.integers(0, 20)).map(ends), max_size=4), min_size=1, max_size=3
)


@given(ROWS)
def test_interval_algebra_is_that_of_sets(rows):
    rows = [union([row]) for row in rows]  # intervals of one row do not overlap
    every, some = intersection(rows), union(rows)
    for value in np.arange(0.5, 21.0):
        inside = [any(i.contains(value) for i in row) for row in rows]
        assert any(i.contains(value) for i in every) == all(inside)
        assert any(i.contains(value) for i in some) == any(inside)
    assert all(a.upper.value < b.lower.value for a, b in pairwise(some))


def test_margins():
    zone = Zone(ZoneEnd(1.0, "fold", 0.1), ZoneEnd(2.0, RANGE), "D", Quiet.IMPACT_FREE, True)
    assert zone.margin(1.5) == pytest.approx(0.4)
    assert zone.margin(0.7) == pytest.approx(-0.3)
    assert zone.margin(2.5) == pytest.approx(-0.5)
    assert (
        Zone(ZoneEnd(1.0, RANGE), ZoneEnd(2.0, RANGE), "D", Quiet.IMPACT_FREE, True).margin(1.2) == math.inf
    )


def test_motions_coexist_only_where_they_overlap():
    motions = (
        ZoneMotion(Signature(1, 0), ("up",), 1.0, 1.4, True),
        ZoneMotion(Signature(2, 1), ("down",), 1.3, 1.6, False),
    )
    apart = (motions[0], ZoneMotion(Signature(2, 1), ("up",), 1.5, 1.6, False))
    span = Plain(ZoneEnd(1.0, RANGE), ZoneEnd(2.0, RANGE))
    meeting = tuple(
        ZoneMotion(Signature(period, 0), ("up",), low, high, True, span, span, 0)
        for period, low, high in ((1, 1.0, 1.4), (2, 1.4, 1.6))
    )

    def make(motions):
        return Zone(ZoneEnd(1.0, RANGE), ZoneEnd(2.0, RANGE), "D", Quiet.IMPACT_FREE, False, motions)

    assert make(motions).coexisting == motions
    assert make(apart).coexisting == ()
    assert make(meeting).coexisting == ()
