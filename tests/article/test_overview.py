"""The picture of the README: the window that it shows."""

from __future__ import annotations

import pytest

from gearlash.article.overview import ends
from gearlash.case import load
from gearlash.system import GearlashError


def test_the_window_ends_where_the_article_says():
    lower, upper = ends(load("article").family()[0])
    assert (lower.value, upper.value) == pytest.approx((0.9725, 1.112), abs=2e-6)
    assert (lower.label_above, upper.label_below) == ("1-0-0", "1-0-0")


def test_a_case_without_the_window_is_refused():
    narrow = load("article", {"load": 0.001}).family()[0]
    with pytest.raises(GearlashError, match="no window to draw"):
        ends(narrow)
