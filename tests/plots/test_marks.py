"""Texts of special points: kept apart, in order, moved as little as possible."""

from __future__ import annotations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from gearlash.plots.marks import spread

PLACES = st.lists(st.floats(0.0, 10.0), min_size=1, max_size=30)


@given(PLACES)
def test_texts_stand_apart_inside_the_band_in_order(places: list[float]) -> None:
    gap = 0.3
    placed = spread(places, gap, 0.0, 10.0)
    assert placed.min() >= -1e-9
    assert placed.max() <= 10.0 + 1e-9
    ordered = placed[np.argsort(places, kind="stable")]
    assert (np.diff(ordered) >= gap - 1e-9).all()


@given(PLACES)
def test_no_placement_is_nearer_for_texts_that_collide_pairwise(places: list[float]) -> None:
    placed = spread(places[:2], 1.0, -100.0, 100.0)
    if len(places) > 1:
        first, second = sorted(places[:2])
        moved = max(0.0, 1.0 - (second - first)) / 2.0
        assert np.allclose(sorted(placed), [first - moved, second + moved])


def test_texts_far_apart_stay_where_they_are() -> None:
    assert np.allclose(spread([5.0, 1.0, 9.0], 1.0, 0.0, 10.0), [5.0, 1.0, 9.0])


def test_more_texts_than_room_lie_evenly() -> None:
    placed = spread([5.0] * 11, 3.0, 0.0, 10.0)
    assert np.allclose(np.diff(placed), 1.0)
    assert placed[0] == 0.0
