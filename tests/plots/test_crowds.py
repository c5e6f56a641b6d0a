"""Which parts of a panel are worth a closer look."""

from __future__ import annotations

import numpy as np

from gearlash.plots.crowds import Box, crowds

PANEL, CLOSER = (148.0, 66.0), (66.0, 76.0)


def around(x: float, y: float, count: int = 6, width: float = 0.02) -> np.ndarray:
    turns = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    return np.array([x, y]) + width * np.column_stack([np.cos(turns), np.sin(turns)])


def test_things_far_from_each_other_are_no_crowd():
    places = np.array([[x, y] for x in (0.1, 0.5, 0.9) for y in (0.1, 0.5, 0.9)])
    assert crowds(places, PANEL, CLOSER, 2) == []
    assert crowds(places[:0], PANEL, CLOSER, 2) == []


def test_a_crowd_is_framed_with_room_around_it():
    places = around(0.3, 0.5)
    (box,) = crowds(places, PANEL, CLOSER, 2)
    low, high = places.min(axis=0), places.max(axis=0)
    assert (box.left, box.low) < tuple(low)
    assert (box.right, box.high) > tuple(high)
    assert box.right - box.left >= 0.08


def test_the_larger_crowds_are_chosen_and_stand_from_left_to_right():
    places = np.concatenate([around(0.8, 0.3, 9), around(0.2, 0.7, 5), around(0.5, 0.5, 7)])
    boxes = crowds(places, PANEL, CLOSER, 2)
    assert [round((box.left + box.right) / 2.0, 2) for box in boxes] == [0.5, 0.8]


def test_boxes_stay_in_the_panel_and_overlap_nowhere():
    rng = np.random.default_rng(3)
    for _ in range(20):
        spread = rng.uniform(0.01, 0.2)
        places = np.clip(rng.normal(rng.uniform(0.0, 1.0, (1, 2)), spread, (30, 2)), 0.0, 1.0)
        boxes = crowds(places, PANEL, CLOSER, 2)
        for box in boxes:
            assert 0.0 <= box.left < box.right <= 1.0
            assert 0.0 <= box.low < box.high <= 1.0
        assert not any(one.meets(other) for one in boxes for other in boxes if one is not other)


def test_a_crowd_that_fills_the_panel_is_not_shown_again():
    x, y = np.meshgrid(np.linspace(0.0, 1.0, 40), np.linspace(0.0, 1.0, 20))
    assert crowds(np.column_stack([x.ravel(), y.ravel()]), PANEL, (66.0, 66.0), 2) == []


def test_what_holds_two_boxes():
    both = Box(0.1, 0.3, 0.2, 0.4).with_(Box(0.2, 0.6, 0.1, 0.3))
    assert both == Box(0.1, 0.6, 0.1, 0.4)
